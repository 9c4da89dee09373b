// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QHash>
#include <QString>
#include <QStringList>

namespace app {

inline constexpr qsizetype kMostPlaces = 8;

/// Puts `place` at the front of the places (newest first). A temporary place is not added.
QStringList withPlace(QStringList places, const QString& place);

/// Keyed hashes of scans, as entries "hash path", newest first: with one more, and of these places
/// alone.
QStringList withHash(QStringList hashes, const QString& hash, const QString& place);
QStringList hashesOf(const QStringList& hashes, const QStringList& places);
/// The names of the places, without their folders, by hash.
QHash<QString, QString> namesOf(const QStringList& hashes);
/// The place with a hash; empty: there is none.
QString placeWith(const QStringList& hashes, const QString& hash);

/// Whether a path is below a folder for temporary files, caches or session files, where other
/// programs unpack files.
bool isTemporary(const QString& path);

}  // namespace app
