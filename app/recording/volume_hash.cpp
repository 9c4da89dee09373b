// SPDX-License-Identifier: BSD-3-Clause
#include "app/recording/volume_hash.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QMessageAuthenticationCode>
#include <QRandomGenerator>
#include <QSaveFile>
#include <QStandardPaths>
#include <algorithm>
#include <array>
#include <cstring>

namespace app {
namespace {

constexpr qsizetype kKeyBytes = 32;
constexpr qsizetype kMarkBytes = 8;  // of what tells the key from others
constexpr qint64 kChunk = 1 << 20;   // bytes between two looks at `cancel`

template <class T>
void add(QMessageAuthenticationCode& code, const T& value) {
  code.addData(reinterpret_cast<const char*>(&value), sizeof value);
}

void add(QMessageAuthenticationCode& code, const haptics::Grid& grid) {
  for (const std::int64_t count : grid.dims) add(code, count);
  for (int a = 0; a < 3; ++a) {
    add(code, grid.spacing[a]);
    add(code, grid.origin[a]);
    for (int b = 0; b < 3; ++b) add(code, grid.direction(a, b));
  }
}

}  // namespace

void nameApplication() {
  QCoreApplication::setOrganizationName("Palpate");
  QCoreApplication::setApplicationName("Palpate");
}

QByteArray installationKey() {
  const QDir folder(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation));
  const QString path = folder.filePath("installation.key");
  const auto read = [&] {
    QFile file(path);
    const QByteArray key = file.open(QIODevice::ReadOnly) ? file.read(kKeyBytes) : QByteArray();
    return key.size() == kKeyBytes ? key : QByteArray();
  };
  if (const QByteArray key = read(); !key.isEmpty()) return key;
  std::array<quint32, kKeyBytes / 4> random{};
  QRandomGenerator::system()->fillRange(random.data(), random.size());
  QSaveFile file(path);
  if (!folder.mkpath(".") || !file.open(QIODevice::WriteOnly)) return {};
  file.setPermissions(QFileDevice::ReadOwner | QFileDevice::WriteOwner);
  file.write(reinterpret_cast<const char*>(random.data()), kKeyBytes);
  return file.commit() ? read() : QByteArray();
}

std::optional<haptics::VolumeHash> hashOf(const haptics::Volume& volume, const QByteArray& key,
                                          const std::atomic<bool>& cancel) {
  if (key.isEmpty()) return {};
  QMessageAuthenticationCode code(QCryptographicHash::Sha256, key);
  add(code, volume.grid);
  add(code, static_cast<qint32>(volume.type));
  const auto* voxels = static_cast<const char*>(volume.voxels.get());
  const auto bytes = static_cast<qint64>(volume.grid.voxelCount()) *
                     static_cast<qint64>(haptics::sizeOf(volume.type));
  for (qint64 at = 0; at < bytes; at += kChunk) {
    if (cancel) return {};
    code.addData(voxels + at, std::min(kChunk, bytes - at));
  }
  const QByteArray mark =
      QMessageAuthenticationCode::hash("Palpate's key", key, QCryptographicHash::Sha256);
  const QByteArray result = mark.first(kMarkBytes) + code.result();
  haptics::VolumeHash hash{};
  std::memcpy(hash.data(), result.constData(), hash.size());
  return hash;
}

}  // namespace app
