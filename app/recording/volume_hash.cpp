// SPDX-License-Identifier: BSD-3-Clause
#include "app/recording/volume_hash.h"

#include <fcntl.h>
#include <unistd.h>

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QMessageAuthenticationCode>
#include <QRandomGenerator>
#include <QStandardPaths>
#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string>
#include <system_error>

#include "datasets/edits/edited.h"
#include "haptics/process/input_file.h"

namespace app {
namespace {

using haptics::Error;
using haptics::Expected;

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

tl::unexpected<Error> unusable(const std::string& path, int why) {
  return tl::unexpected(Error{why == ENOENT ? Error::Kind::NotFound : Error::Kind::Unsupported,
                              {"volume-key-unusable", {path, std::generic_category().message(why)}},
                              "no-key"});
}

/// The key that is kept; NotFound where there is none yet.
Expected<QByteArray> keptKey(const std::string& path) {
  if (::access(path.c_str(), R_OK) != 0) return unusable(path, errno);
  const auto key = haptics::readInput(path, kKeyBytes);
  if (key && key->size() == kKeyBytes) return QByteArray::fromStdString(*key);
  // a new one in its place would know nothing of what was recorded under it
  return tl::unexpected(Error{Error::Kind::Malformed, {"volume-key-damaged", {path}}, "no-key"});
}

/// What tells the key from others, and the hash that was made with it.
VolumeHash withMark(const QByteArray& key, const QByteArray& hash) {
  const QByteArray whole =
      QMessageAuthenticationCode::hash("Palpate's key", key, QCryptographicHash::Sha256)
          .first(kMarkBytes) +
      hash;
  VolumeHash marked{};
  std::memcpy(marked.data(), whole.constData(), marked.size());
  return marked;
}

}  // namespace

void nameApplication() {
  // Qt takes them as they are; to their specification one that is not absolute is not there
  for (const char* folder :
       {"XDG_DATA_HOME", "XDG_CONFIG_HOME", "XDG_CACHE_HOME", "XDG_STATE_HOME", "XDG_RUNTIME_DIR"})
    if (qEnvironmentVariableIsSet(folder) && !qgetenv(folder).startsWith('/')) qunsetenv(folder);
  QCoreApplication::setOrganizationName("Palpate");
  QCoreApplication::setApplicationName("Palpate");
}

haptics::Expected<QByteArray> installationKey() {
  const QDir folder(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation));
  const std::string path = QFile::encodeName(folder.filePath("installation.key")).toStdString();
  if (auto kept = keptKey(path); kept || kept.error().kind != Error::Kind::NotFound) return kept;
  if (!folder.mkpath(".")) return unusable(path, EACCES);
  // others may be making one as well: the first that has the name is everybody's
  std::array<quint32, kKeyBytes / 4> random{};
  QRandomGenerator::system()->fillRange(random.data(), random.size());
  std::string made = path + "." + std::string(6, 'X');  // mkostemp fills it in
  const int file = ::mkostemp(made.data(), O_CLOEXEC);  // for its owner's eyes
  if (file < 0) return unusable(path, errno);
  int why = 0;
  if (::write(file, random.data(), kKeyBytes) != kKeyBytes)
    why = ENOSPC;
  else if (::fsync(file) != 0 || (::link(made.c_str(), path.c_str()) != 0 && errno != EEXIST))
    why = errno;
  ::close(file);
  ::unlink(made.c_str());
  if (why != 0) return unusable(path, why);
  // the name as well is to survive the power
  const int place = ::open(QFile::encodeName(folder.path()).constData(), O_DIRECTORY | O_CLOEXEC);
  ::fsync(place);
  ::close(place);
  return keptKey(path);
}

std::optional<VolumeHash> hashOf(const haptics::Volume& volume, const QByteArray& key,
                                 const std::atomic<bool>& cancel) {
  if (key.isEmpty()) return {};
  const haptics::Volume& scan = volume.derivation ? *volume.derivation->scan : volume;
  QMessageAuthenticationCode code(QCryptographicHash::Sha256, key);
  add(code, scan.grid);
  add(code, static_cast<qint32>(scan.type));
  const auto* voxels = static_cast<const char*>(scan.voxels.get());
  const auto bytes =
      static_cast<qint64>(scan.grid.voxelCount()) * static_cast<qint64>(haptics::sizeOf(scan.type));
  for (qint64 at = 0; at < bytes; at += kChunk) {
    if (cancel) return {};
    code.addData(voxels + at, std::min(kChunk, bytes - at));
  }
  return withMark(key, code.result());
}

std::optional<std::string> openHashOfVoxels(const haptics::Volume& volume,
                                            const std::atomic<bool>& cancel) {
  const haptics::Volume& scan = volume.derivation ? *volume.derivation->scan : volume;
  QCryptographicHash hash(QCryptographicHash::Sha256);
  const auto* voxels = static_cast<const char*>(scan.voxels.get());
  const auto bytes =
      static_cast<qint64>(scan.grid.voxelCount()) * static_cast<qint64>(haptics::sizeOf(scan.type));
  for (qint64 at = 0; at < bytes; at += kChunk) {
    if (cancel) return {};
    hash.addData(QByteArrayView{voxels + at, qsizetype(std::min(kChunk, bytes - at))});
  }
  return hash.result().toHex().toStdString();
}

std::optional<VolumeHash> hashOfFile(const std::filesystem::path& path, const QByteArray& key) {
  constexpr std::uintmax_t kLargest = 1'000'000'000;  // bytes
  const auto bytes = haptics::readInput(path, kLargest);
  if (!bytes || key.isEmpty()) return {};
  return withMark(key, QMessageAuthenticationCode::hash(
                           QByteArray::fromRawData(bytes->data(), qsizetype(bytes->size())), key,
                           QCryptographicHash::Sha256));
}

}  // namespace app
