// SPDX-License-Identifier: BSD-3-Clause
#include "app/fetch/folder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include "app/fetch/archive.h"

namespace app::fetch {

namespace fs = std::filesystem;
using haptics::Expected;

namespace {

constexpr std::string_view kName = "palpate-fetch-";
constexpr int kLooks = 3;

/// The locked folder itself: a file for the lock would be among the images. -1 if it is not this
/// user's, or in use.
int lockOf(const fs::path& folder) {
  const int lock = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC | O_NOFOLLOW);
  struct stat status {};
  if (lock >= 0 && fstat(lock, &status) == 0 && status.st_uid == geteuid() &&
      flock(lock, LOCK_EX | LOCK_NB) == 0)
    return lock;
  if (lock >= 0) close(lock);
  return -1;
}

tl::unexpected<haptics::Error> unwritable(const fs::path& path, int why) {
  return failed("unwritable",
                {"output-unwritable", {path.string(), std::generic_category().message(why)}});
}

}  // namespace

Expected<Folder> Folder::temporary() {
  std::error_code error;
  const fs::path place = fs::temp_directory_path(error);
  for (int n = 0; n < kLooks && !error; ++n) {
    std::string name = (place / (std::string(kName) + std::string(6, 'X'))).string();
    if (mkdtemp(name.data()) == nullptr) return unwritable(place, errno);
    // a sweep may have it for a moment, and takes it
    if (const int lock = lockOf(name); lock >= 0) return Folder{name, lock};
  }
  return unwritable(place, error ? error.value() : EBUSY);
}

Expected<Folder> Folder::at(const fs::path& path) {
  if (mkdir(path.c_str(), 0700) == 0) return Folder{fs::absolute(path), -1};
  if (errno != EEXIST) return unwritable(path, errno);
  std::error_code error;
  struct stat status {};
  const bool ours =
      lstat(path.c_str(), &status) == 0 && S_ISDIR(status.st_mode) && status.st_uid == geteuid();
  if (!ours || !fs::is_empty(path, error) || error)
    return refused("usage", {"fetch-folder-not-empty", {path.string()}});
  if (chmod(path.c_str(), 0700) != 0) return unwritable(path, errno);
  return Folder{fs::absolute(path), -1};
}

Folder::Folder(Folder&& other) noexcept
    : path_{std::exchange(other.path_, {})}, lock_{std::exchange(other.lock_, -1)} {}

Folder::~Folder() {
  if (isTemporary()) discard();
}

void Folder::discard() {
  std::error_code ignored;
  if (!path_.empty()) fs::remove_all(path_, ignored);
  if (lock_ >= 0) close(std::exchange(lock_, -1));
  path_.clear();
}

void sweepFolders() {
  std::error_code error;
  const fs::path place = fs::temp_directory_path(error);
  for (fs::directory_iterator it(place, error), end; !error && it != end; it.increment(error)) {
    std::error_code ignored;
    if (!it->path().filename().string().starts_with(kName)) continue;
    const int lock = lockOf(it->path());
    if (lock < 0) continue;
    fs::remove_all(it->path(), ignored);
    close(lock);
  }
}

}  // namespace app::fetch
