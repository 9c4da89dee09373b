// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QList>
#include <QStringList>

namespace app {

/// Of these programs, each with its first words, the first that the system has; null: none.
const QStringList* firstThere(const QList<QStringList>& programs);

}  // namespace app
