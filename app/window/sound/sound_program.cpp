// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/sound/sound_program.h"

#include <QStandardPaths>

namespace app {

const QStringList* firstThere(const QList<QStringList>& programs) {
  for (const QStringList& one : programs)
    if (!QStandardPaths::findExecutable(one.front()).isEmpty()) return &one;
  return nullptr;
}

}  // namespace app
