// SPDX-License-Identifier: BSD-3-Clause
#include "tests/support/failing_disk.h"

#include <sqlite3.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <map>
#include <memory>
#include <mutex>
#include <random>
#include <vector>

namespace support {
namespace {

constexpr std::size_t kSector = 512;

struct Write {
  std::size_t at = 0;
  std::vector<std::uint8_t> bytes;
};

struct Content {
  std::vector<std::uint8_t> now;     ///< what the process sees
  std::vector<std::uint8_t> synced;  ///< what is sure to be there
  std::vector<Write> since;          ///< what was written after that
};

struct Disk {
  std::mutex mutex;
  std::map<std::string, std::shared_ptr<Content>> files;
  std::int64_t left = std::numeric_limits<std::int64_t>::max();
  std::int64_t room = std::numeric_limits<std::int64_t>::max();
  bool cut = false;

  /// Counts an operation; false once the power is gone.
  bool goesOn() {
    if (left-- <= 0) cut = true;
    return !cut;
  }
  std::int64_t used() const {
    std::int64_t bytes = 0;
    for (const auto& [name, content] : files)
      bytes += static_cast<std::int64_t>(content->now.size());
    return bytes;
  }
};

Disk* disk = nullptr;

struct File {
  sqlite3_file base;
  std::shared_ptr<Content>* content;
};
Content& of(sqlite3_file* file) { return **reinterpret_cast<File*>(file)->content; }

int close(sqlite3_file* file) {
  delete reinterpret_cast<File*>(file)->content;
  return SQLITE_OK;
}
int read(sqlite3_file* file, void* out, int count, sqlite3_int64 at) {
  const std::scoped_lock lock(disk->mutex);
  const auto& bytes = of(file).now;
  const auto begin = std::min(bytes.size(), static_cast<std::size_t>(at));
  const std::size_t some = std::min(bytes.size() - begin, static_cast<std::size_t>(count));
  auto* to = static_cast<std::uint8_t*>(out);
  std::fill_n(to, count, std::uint8_t{0});
  std::copy_n(bytes.begin() + static_cast<std::ptrdiff_t>(begin), some, to);
  return some == static_cast<std::size_t>(count) ? SQLITE_OK : SQLITE_IOERR_SHORT_READ;
}
void put(std::vector<std::uint8_t>& bytes, std::size_t at, const std::uint8_t* from,
         std::size_t count) {
  if (bytes.size() < at + count) bytes.resize(at + count);
  std::copy(from, from + count, bytes.begin() + static_cast<std::ptrdiff_t>(at));
}
int write(sqlite3_file* file, const void* from, int count, sqlite3_int64 at) {
  const std::scoped_lock lock(disk->mutex);
  if (!disk->goesOn()) return SQLITE_IOERR_WRITE;
  Content& content = of(file);
  const auto end = static_cast<std::int64_t>(at) + count;
  const std::int64_t more = end - static_cast<std::int64_t>(content.now.size());
  if (more > 0 && disk->used() + more > disk->room) return SQLITE_FULL;
  const auto* bytes = static_cast<const std::uint8_t*>(from);
  put(content.now, static_cast<std::size_t>(at), bytes, static_cast<std::size_t>(count));
  content.since.push_back({static_cast<std::size_t>(at), {bytes, bytes + count}});
  return SQLITE_OK;
}
int truncate(sqlite3_file* file, sqlite3_int64 size) {
  const std::scoped_lock lock(disk->mutex);
  if (!disk->goesOn()) return SQLITE_IOERR_TRUNCATE;
  of(file).now.resize(static_cast<std::size_t>(size));
  return SQLITE_OK;
}
int sync(sqlite3_file* file, int) {
  const std::scoped_lock lock(disk->mutex);
  if (!disk->goesOn()) return SQLITE_IOERR_FSYNC;
  of(file).synced = of(file).now;
  of(file).since.clear();
  return SQLITE_OK;
}
int fileSize(sqlite3_file* file, sqlite3_int64* size) {
  const std::scoped_lock lock(disk->mutex);
  *size = static_cast<sqlite3_int64>(of(file).now.size());
  return SQLITE_OK;
}
int lockNothing(sqlite3_file*, int) { return SQLITE_OK; }
int nobodyHasReserved(sqlite3_file*, int* reserved) {
  *reserved = 0;
  return SQLITE_OK;
}
int noControl(sqlite3_file*, int, void*) { return SQLITE_NOTFOUND; }
int sectorSize(sqlite3_file*) { return kSector; }
int characteristics(sqlite3_file*) { return 0; }

constexpr sqlite3_io_methods kMethods{1,
                                      close,
                                      read,
                                      write,
                                      truncate,
                                      sync,
                                      fileSize,
                                      lockNothing,
                                      lockNothing,
                                      nobodyHasReserved,
                                      noControl,
                                      sectorSize,
                                      characteristics,
                                      nullptr,
                                      nullptr,
                                      nullptr,
                                      nullptr,
                                      nullptr,
                                      nullptr};

int open(sqlite3_vfs*, const char* name, sqlite3_file* file, int flags, int* out_flags) {
  const std::scoped_lock lock(disk->mutex);
  auto& content = disk->files[name == nullptr ? "" : name];
  if (!content) content = std::make_shared<Content>();
  auto* opened = reinterpret_cast<File*>(file);
  opened->base.pMethods = &kMethods;
  opened->content = new std::shared_ptr<Content>(content);
  if (out_flags != nullptr) *out_flags = flags;
  return SQLITE_OK;
}
int remove(sqlite3_vfs*, const char* name, int) {
  const std::scoped_lock lock(disk->mutex);
  if (!disk->goesOn()) return SQLITE_IOERR_DELETE;
  disk->files.erase(name);
  return SQLITE_OK;
}
int access(sqlite3_vfs*, const char* name, int, int* there) {
  const std::scoped_lock lock(disk->mutex);
  *there = disk->files.contains(name) ? 1 : 0;
  return SQLITE_OK;
}
int fullPath(sqlite3_vfs*, const char* name, int size, char* out) {
  sqlite3_snprintf(size, out, "%s", name);
  return SQLITE_OK;
}

sqlite3_vfs& fileSystem() {
  static sqlite3_vfs vfs = [] {
    sqlite3_vfs made = *sqlite3_vfs_find(nullptr);  // its clock, sleep and chance
    made.iVersion = 1;
    made.szOsFile = sizeof(File);
    made.zName = "failing-disk";
    made.pNext = nullptr;
    made.xOpen = open;
    made.xDelete = remove;
    made.xAccess = access;
    made.xFullPathname = fullPath;
    return made;
  }();
  return vfs;
}

void saveOne(const std::filesystem::path& folder, const std::string& name,
             const std::vector<std::uint8_t>& bytes) {
  std::ofstream(folder / std::filesystem::path(name).filename(), std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()),
             static_cast<std::streamsize>(bytes.size()));
}

}  // namespace

FailingDisk::FailingDisk() {
  disk = new Disk;
  sqlite3_vfs_register(&fileSystem(), 0);
}
FailingDisk::~FailingDisk() {
  sqlite3_vfs_unregister(&fileSystem());
  delete disk;
  disk = nullptr;
}

void FailingDisk::cutAfter(std::int64_t operations) {
  const std::scoped_lock lock(disk->mutex);
  disk->left = operations;
}
bool FailingDisk::isCut() const {
  const std::scoped_lock lock(disk->mutex);
  return disk->cut;
}
void FailingDisk::setRoom(std::int64_t bytes) {
  const std::scoped_lock lock(disk->mutex);
  disk->room = bytes;
}

void FailingDisk::saveAfterPowerCut(const std::filesystem::path& folder, std::uint32_t seed) const {
  const std::scoped_lock lock(disk->mutex);
  std::mt19937 chance(seed);
  for (const auto& [name, content] : disk->files) {
    std::vector<std::uint8_t> bytes = content->synced;
    for (const Write& write : content->since) {
      // written in any order, or not at all, a sector at a time
      for (std::size_t at = 0; at < write.bytes.size(); at += kSector)
        if (chance() % 3 == 0)
          put(bytes, write.at + at, write.bytes.data() + at,
              std::min(kSector, write.bytes.size() - at));
    }
    saveOne(folder, name, bytes);
  }
}

void FailingDisk::save(const std::filesystem::path& folder) const {
  const std::scoped_lock lock(disk->mutex);
  for (const auto& [name, content] : disk->files) saveOne(folder, name, content->now);
}

}  // namespace support
