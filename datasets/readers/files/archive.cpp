// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/readers/files/archive.h"

#include <archive.h>
#include <archive_entry.h>
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <system_error>

#include "datasets/readers/files/beginning.h"
#include "datasets/readers/files/header_words.h"
#include "datasets/readers/files/refusal.h"

namespace datasets {

namespace fs = std::filesystem;
using haptics::Expected;

namespace {

constexpr std::string_view kFolderName = "palpate-archive-";
constexpr std::string_view kLockName = "in-use";
constexpr std::int64_t kGiB = std::int64_t{1} << 30;
constexpr std::int64_t kMostBytes = 32 * kGiB;
constexpr std::int64_t kAnyway = kGiB;  // whatever the archive's size
constexpr std::int64_t kExpansion = 100;
constexpr std::int64_t kMostFiles = 200'000;
constexpr std::int64_t kMostEntries = 2 * kMostFiles;
constexpr int kDeepestPath = 32;

/// The lock of a folder, if it can be had; the caller closes it.
int lockOf(const fs::path& folder) {
  const int lock =
      open((folder / kLockName).c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0600);
  if (lock >= 0 && flock(lock, LOCK_EX | LOCK_NB) == 0) return lock;
  if (lock >= 0) close(lock);
  return -1;
}

/// A new folder, and its lock: another process's sweep may have it for a moment, and takes the
/// folder with it.
int makeFolder(const fs::path& place, fs::path& folder) {
  for (int n = 0; n < 3; ++n) {
    std::string name = (place / (std::string(kFolderName) + std::string(6, 'X'))).string();
    if (mkdtemp(name.data()) == nullptr) break;
    folder = name;
    if (const int lock = lockOf(folder); lock >= 0) return lock;
    std::error_code ignored;
    fs::remove_all(folder, ignored);
  }
  throw fs::filesystem_error("no temporary folder", place,
                             std::error_code(errno, std::generic_category()));
}

}  // namespace

void sweepTemporaryFolders() {
  std::error_code error;
  const fs::path place = fs::temp_directory_path(error);
  for (fs::directory_iterator it(place, error), end; !error && it != end; it.increment(error)) {
    std::error_code ignored;
    if (!it->path().filename().string().starts_with(kFolderName)) continue;
    if (!fs::is_directory(it->symlink_status(ignored))) continue;
    const int lock = lockOf(it->path());
    if (lock < 0) continue;
    fs::remove_all(it->path(), ignored);
    close(lock);
  }
}

namespace {

tl::unexpected<haptics::Error> tooLarge(const fs::path& path) {
  return unsupported("too-large", {"archive-too-large", {quoted(path)}});
}

tl::unexpected<haptics::Error> damaged(const fs::path& path) {
  return malformed("truncated", {"file-damaged", {quoted(path)}});
}

struct CloseArchive {
  void operator()(archive* a) const { archive_read_free(a); }
};
using ArchivePtr = std::unique_ptr<archive, CloseArchive>;

/// An archive open for reading; formats and filters by name, since some of the rest start programs.
ArchivePtr opened(const fs::path& path) {
  ArchivePtr a(archive_read_new());
  for (const auto support : {archive_read_support_format_zip, archive_read_support_format_7zip,
                             archive_read_support_format_tar, archive_read_support_format_iso9660,
                             archive_read_support_filter_gzip, archive_read_support_filter_bzip2,
                             archive_read_support_filter_xz, archive_read_support_filter_zstd})
    support(a.get());
  if (archive_read_open_filename(a.get(), path.c_str(), std::size_t{1} << 18) != ARCHIVE_OK)
    a.reset();
  return a;
}

/// Where an entry belongs below the folder; nothing for a name that leads out of it.
std::optional<fs::path> placeOf(std::string_view name) {
  fs::path place;
  int depth = 0;
  while (!name.empty()) {
    const auto end = std::min(name.find_first_of("/\\"), name.size());
    const std::string_view part = name.substr(0, end);
    name.remove_prefix(std::min(end + 1, name.size()));
    if (part.empty() || part == ".") continue;
    if (part == ".." || part.find('\0') != part.npos || ++depth > kDeepestPath) return {};
    place /= part;
  }
  if (place.empty()) return {};
  return place;
}

/// What has been taken out so far, and may be at most.
struct Tally {
  std::int64_t files = 0, bytes = 0, most_bytes = 0;
  std::int64_t entries = 0;  ///< folders and links too
};

/// Takes out what the entry holds at which the archive stands, to a file or to nowhere.
Expected<void> take(archive* a, std::ofstream* out, const fs::path& path, Tally& tally,
                    const ReadProgress& progress) {
  const void* block = nullptr;
  std::size_t size = 0;
  la_int64_t offset = 0;
  int result = ARCHIVE_OK;
  while ((result = archive_read_data_block(a, &block, &size, &offset)) == ARCHIVE_OK) {
    if (progress.isCancelled()) return cancelled();
    tally.bytes += static_cast<std::int64_t>(size);
    // and a hole counts as long as it claims to be
    if (std::max<std::int64_t>(tally.bytes, offset) > tally.most_bytes) return tooLarge(path);
    if (out == nullptr) continue;
    out->seekp(offset);
    out->write(static_cast<const char*>(block), static_cast<std::streamsize>(size));
    if (!*out) return tooLarge(path);
  }
  return result == ARCHIVE_EOF ? Expected<void>{} : damaged(path);
}

/// Writes the entry at which the archive stands.
Expected<void> extract(archive* a, const fs::path& to, const fs::path& path, Tally& tally,
                       const ReadProgress& progress) {
  std::error_code error;
  fs::create_directories(to.parent_path(), error);
  std::ofstream out(to, std::ios::binary | std::ios::trunc);
  if (error || !out) return damaged(path);
  return take(a, &out, path, tally, progress);
}

Expected<void> extractAll(archive* a, const fs::path& folder, const fs::path& path, Tally& tally,
                          const ReadProgress& progress) {
  std::error_code error;
  const double size = static_cast<double>(std::max<std::uintmax_t>(fs::file_size(path, error), 1));
  archive_entry* entry = nullptr;
  int result = ARCHIVE_OK;
  while ((result = archive_read_next_header(a, &entry)) == ARCHIVE_OK || result == ARCHIVE_WARN) {
    if (progress.isCancelled()) return cancelled();
    progress.advanced(std::min(1.0, static_cast<double>(archive_filter_bytes(a, -1)) / size));
    if (archive_entry_is_encrypted(entry) == 1)
      return unsupported("unreadable", {"archive-locked", {quoted(path)}});
    if (++tally.entries > kMostEntries) return tooLarge(path);
    if (archive_entry_filetype(entry) != AE_IFREG || archive_entry_hardlink(entry) != nullptr) {
      // libarchive would pass over it in one step, however long it is, and ask nobody
      if (auto done = take(a, nullptr, path, tally, progress); !done) return done;
      continue;
    }
    ++tally.files;
    const char* name = archive_entry_pathname_utf8(entry);
    if (name == nullptr) name = archive_entry_pathname(entry);
    // a name that cannot be told says nothing of a slice either
    const auto place = placeOf(name != nullptr ? name : std::to_string(tally.files));
    if (!place) return unsupported("outside-folder", {"archive-name-outside", {quoted(path)}});
    if (tally.files > kMostFiles) return tooLarge(path);
    if (auto done = extract(a, folder / *place, path, tally, progress); !done) return done;
  }
  return result == ARCHIVE_EOF ? Expected<void>{} : damaged(path);
}

/// A kind of archive, or of compression, by how a file of it begins.
struct Kind {
  const char* name;
  std::string_view begins;
  std::size_t at = 0;  ///< bytes before that
};

constexpr Kind kNotUnpacked[] = {{"RAR", "Rar!\x1a\x07"},    {"CAB", {"MSCF\0\0\0\0", 8}},
                                 {"ACE", "**ACE**", 7},      {"LHA", "-lh5-", 2},
                                 {"StuffIt", "StuffIt (c)"}, {"compress (.Z)", "\x1f\x9d\x90"},
                                 {"lzip", "LZIP\x01"},       {"LZ4", "\x04\x22\x4d\x18"}};

/// What may hold an archive or a single file.
constexpr Kind kPacked[] = {{"gzip", "\x1f\x8b"},
                            {"bzip2", "BZh"},
                            {"xz", {"\xfd\x37zXZ\0", 6}},
                            {"Zstandard", "\x28\xb5\x2f\xfd"}};

/// The kind of this list that a file is of; null if it is of none.
const Kind* kindIn(std::span<const Kind> kinds, std::string_view file) {
  const auto found = std::ranges::find_if(kinds, [&](const Kind& kind) {
    return file.size() > kind.at && file.substr(kind.at).starts_with(kind.begins);
  });
  return found != kinds.end() ? &*found : nullptr;
}

/// Whether an entry is found in the file as an archive, whatever its name.
bool hasEntry(const fs::path& path) {
  const ArchivePtr a = opened(path);
  archive_entry* entry = nullptr;
  if (!a) return false;
  const int result = archive_read_next_header(a.get(), &entry);
  return result == ARCHIVE_OK || result == ARCHIVE_WARN;
}

}  // namespace

TemporaryFolder::TemporaryFolder() {
  lock_ = makeFolder(fs::temp_directory_path(), path_);
  content_ = path_ / "files";
  fs::create_directory(content_);
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
  if (lock_ >= 0) close(lock_);
}

bool looksLikeArchive(const fs::path& path) {
  const std::string begin = Beginning(path).bytes;
  if (begin.starts_with("PK\x03\x04") || begin.starts_with("7z\xbc\xaf\x27\x1c")) return true;
  if (begin.size() >= 262 && begin.substr(257, 5) == "ustar") return true;
  if (kindIn(kNotUnpacked, begin) != nullptr) return false;
  // one that is cut off early says nothing else
  const std::string name = lowered(path.filename().string());
  for (const std::string_view ending :
       {".tar.gz", ".tgz", ".tar.bz2", ".tbz2", ".tar.xz", ".txz", ".tar.zst", ".tar", ".iso"})
    if (name.size() > ending.size() && name.ends_with(ending)) return true;
  return hasEntry(path);
}

std::optional<haptics::Message> whyNoArchive(const fs::path& path) {
  const std::string begin = Beginning(path).bytes;
  if (const Kind* kind = kindIn(kNotUnpacked, begin))
    return haptics::Message{"archive-kind-unread", {quoted(path), kind->name}};
  if (const Kind* kind = kindIn(kPacked, begin))
    return haptics::Message{"file-packed", {quoted(path), kind->name}};
  return {};
}

Expected<std::shared_ptr<const TemporaryFolder>> unpacked(const fs::path& path,
                                                          const ReadProgress& progress) {
  const ArchivePtr a = opened(path);
  if (!a) return damaged(path);
  std::shared_ptr<TemporaryFolder> folder;
  try {
    folder = std::make_shared<TemporaryFolder>();
  } catch (const fs::filesystem_error& failed) {
    return unsupported("no-temporary-folder",
                       {"temporary-folder-unwritable", {failed.path1().string()}});
  }
  std::error_code error;
  const fs::space_info space = fs::space(folder->path(), error);
  const auto size = static_cast<std::int64_t>(fs::file_size(path, error));
  Tally tally;
  tally.most_bytes =
      std::min(kMostBytes, std::max(kAnyway, kExpansion * std::min(size, kMostBytes)));
  if (!error)
    tally.most_bytes =
        std::min(tally.most_bytes, static_cast<std::int64_t>(space.available / 10 * 9));
  if (auto done = extractAll(a.get(), folder->path(), path, tally, progress); !done)
    return tl::unexpected(std::move(done.error()));
  return folder;
}

}  // namespace datasets
