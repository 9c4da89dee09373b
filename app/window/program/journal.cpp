// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/program/journal.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <QStandardPaths>
#include <algorithm>
#include <cerrno>
#include <fstream>
#include <system_error>
#include <utility>

#include "haptics/process/output_file.h"

namespace app {
namespace {

namespace fs = std::filesystem;
using haptics::Error;

constexpr const char* kLock = "lock";

tl::unexpected<Error> cannotKeep(const fs::path& path, int why) {
  return tl::unexpected(
      Error{Error::Kind::Unsupported,
            {"output-unwritable", {path.string(), std::generic_category().message(why)}},
            "unwritable"});
}

/// The lock in a folder, where no process holds it; -1: one does, or there is none.
int takeLock(const fs::path& folder, int flags) {
  const int file = ::open((folder / kLock).c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW | flags, 0600);
  if (file < 0) return -1;
  struct stat what {};
  // who swept the folder meanwhile has unlinked it
  if (::flock(file, LOCK_EX | LOCK_NB) == 0 && ::fstat(file, &what) == 0 && what.st_nlink > 0)
    return file;
  ::close(file);
  return -1;
}

struct Found {
  Journal::Left left;
  fs::file_time_type time;
};

/// What a folder has, as far as it can be read.
std::vector<fs::directory_entry> entriesOf(const fs::path& folder) {
  std::vector<fs::directory_entry> entries;
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error))
    entries.push_back(*at);
  return entries;
}

/// The work in a folder.
std::vector<Found> workIn(const fs::path& folder) {
  std::vector<Found> found;
  std::error_code error;
  for (const auto& file : entriesOf(folder)) {
    const auto hash = hashFromHex(file.path().stem().string());
    if (!hash || file.path().extension() != kViewEnding) continue;
    const auto time = file.last_write_time(error);
    if (!error) found.push_back({{*hash, file.path()}, time});
  }
  return found;
}

/// Calls `use` with each folder whose process has ended, while its lock is held.
template <class Use>
void visitEnded(const fs::path& folder, const fs::path& own, const Use& use) {
  std::error_code error;
  for (const auto& entry : entriesOf(folder)) {
    if (entry.path() == own || !entry.is_directory(error) || entry.is_symlink(error)) continue;
    const int lock = takeLock(entry.path(), 0);
    if (lock < 0) continue;
    use(entry.path());
    ::close(lock);
  }
}

/// Of all ended processes, newest first.
std::vector<Found> allLeft(const fs::path& folder, const fs::path& own) {
  std::vector<Found> all;
  visitEnded(folder, own, [&](const fs::path& ended) {
    const std::vector<Found> found = workIn(ended);
    all.insert(all.end(), found.begin(), found.end());
  });
  std::ranges::sort(all, std::ranges::greater{}, &Found::time);
  return all;
}

}  // namespace

Journal::Journal(fs::path folder) : folder_(std::move(folder)) {}

Journal::~Journal() {
  if (lock_ < 0) return;
  std::error_code error;
  if (workIn(own_).empty()) fs::remove_all(own_, error);
  ::close(lock_);
}

haptics::Expected<void> Journal::hold() {
  std::error_code error;
  if (lock_ >= 0 && fs::exists(own_ / kLock, error)) return {};
  if (lock_ >= 0) ::close(std::exchange(lock_, -1));
  fs::create_directories(folder_.parent_path(), error);
  if (::mkdir(folder_.c_str(), 0700) != 0 && errno != EEXIST) return cannotKeep(folder_, errno);
  // another process may take one that has no lock yet for one that is over
  constexpr int kTries = 5;
  for (int n = 0; n < kTries && lock_ < 0; ++n) {
    std::string made = (folder_ / std::string(6, 'X')).string();  // mkdtemp's own letters
    if (::mkdtemp(made.data()) == nullptr) return cannotKeep(folder_, errno);
    own_ = made;
    lock_ = takeLock(own_, O_CREAT | O_EXCL);
  }
  if (lock_ < 0) return cannotKeep(folder_, EAGAIN);
  return {};
}

haptics::Expected<void> Journal::write(const ViewFile& view) {
  const std::string text = textOf(view);
  if (text.size() > kMostViewBytes)
    return tl::unexpected(Error{
        Error::Kind::Unsupported, {"view-not-saved-too-large", {folder_.string()}}, "too-large"});
  const std::scoped_lock guard(mutex_);
  if (const auto held = hold(); !held) return held;
  auto output = haptics::Output::at(own_ / (hexOf(*view.hash) + kViewEnding));
  if (!output) return tl::unexpected(output.error());
  std::error_code error;
  fs::permissions(output->part(), fs::perms::owner_read | fs::perms::owner_write, error);
  std::ofstream file(output->part(), std::ios::binary);
  file << text << std::flush;
  if (error || !file) return tl::unexpected(output->unwritable(error ? error.value() : ENOSPC));
  file.close();
  if (const auto done = output->finish(); !done) return tl::unexpected(done.error());
  return {};
}

void Journal::remove(const VolumeHash& hash) {
  const std::scoped_lock guard(mutex_);
  std::error_code error;
  if (lock_ >= 0) fs::remove(own_ / (hexOf(hash) + kViewEnding), error);
}

void Journal::clear() {
  const std::scoped_lock guard(mutex_);
  if (lock_ < 0) return;
  std::error_code error;
  for (const Found& found : workIn(own_)) fs::remove(found.left.path, error);
}

void Journal::forget() {
  if (!isOn()) return;
  clear();
  std::error_code error;
  // those of others that run: what they keep, not what they hold
  for (const auto& folder : entriesOf(folder_))
    for (const Found& found : workIn(folder.path())) fs::remove(found.left.path, error);
  sweep();
}

std::vector<Journal::Left> Journal::left() const {
  if (!isOn()) return {};
  const std::scoped_lock guard(mutex_);
  std::vector<Left> newest;
  for (const Found& found : allLeft(folder_, own_))
    if (std::ranges::find(newest, found.left.hash, &Left::hash) == newest.end())
      newest.push_back(found.left);
  return newest;
}

void Journal::sweep() {
  if (!isOn()) return;
  const std::scoped_lock guard(mutex_);
  std::error_code error;
  const std::vector<Found> all = allLeft(folder_, own_);
  for (std::size_t n = kMostScans; n < all.size(); ++n) fs::remove(all[n].left.path, error);
  visitEnded(folder_, own_, [&](const fs::path& ended) {
    if (workIn(ended).empty()) fs::remove_all(ended, error);
  });
}

fs::path ownJournal() {
  const QString folder = QStandardPaths::writableLocation(QStandardPaths::AppDataLocation);
  return folder.isEmpty() ? fs::path{} : fs::path(folder.toStdString()) / "journal";
}

}  // namespace app
