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

QStringList withHash(QStringList hashes, const QString& hash, const QString& place) {
  constexpr qsizetype kMostHashes = 4 * kMostPlaces;  // a folder may have several series
  const QString entry = hash + ' ' + place;
  hashes.removeAll(entry);
  hashes.prepend(entry);
  return hashes.mid(0, kMostHashes);
}

QStringList hashesOf(const QStringList& hashes, const QStringList& places) {
  QStringList kept;
  for (const QString& entry : hashes)
    if (places.contains(entry.section(' ', 1))) kept << entry;
  return kept;
}

QHash<QString, QString> namesOf(const QStringList& hashes) {
  QHash<QString, QString> names;
  for (const QString& entry : hashes)  // of two places the newer
    if (const QString hash = entry.section(' ', 0, 0); !names.contains(hash))
      names[hash] = QFileInfo(entry.section(' ', 1)).fileName();
  return names;
}

QString placeWith(const QStringList& hashes, const QString& hash) {
  for (const QString& entry : hashes)
    if (entry.section(' ', 0, 0) == hash) return entry.section(' ', 1);
  return {};
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
