// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QString>
#include <QStringList>

namespace app {

inline constexpr qsizetype kMostPlaces = 8;

/// The places, newest first, once `place` was opened: it comes to the front. A temporary one is
/// not added.
QStringList withPlace(QStringList places, const QString& place);

/// Whether a path is below a folder that is emptied sooner or later: for temporary files, caches
/// and what belongs to a session, where other programs unpack what they hand over.
bool isTemporary(const QString& path);

}  // namespace app
