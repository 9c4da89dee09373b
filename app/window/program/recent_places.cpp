// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/program/recent_places.h"

#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>
#include <algorithm>

namespace app {

QStringList withPlace(QStringList places, const QString& place) {
  if (place.isEmpty() || isTemporary(place)) return places;
  places.removeAll(place);
  places.prepend(place);
  return places.mid(0, kMostPlaces);
}

bool isTemporary(const QString& path) {
  const QString real = QFileInfo(path).canonicalFilePath();
  QStringList folders = QStandardPaths::standardLocations(QStandardPaths::GenericCacheLocation);
  folders << QDir::tempPath() << qEnvironmentVariable("XDG_RUNTIME_DIR");
  return std::ranges::any_of(folders, [&](const QString& folder) {
    const QString base = QFileInfo(folder).canonicalFilePath();
    return !base.isEmpty() && (real == base || real.startsWith(base + QLatin1Char('/')));
  });
}

}  // namespace app
