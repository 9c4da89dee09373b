// SPDX-License-Identifier: BSD-3-Clause
#include "app/recording/unfinished.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include "app/recording/schema.h"
#include "haptics/process/input_file.h"

namespace app {

namespace fs = std::filesystem;

namespace {

/// The identity that the file itself states, without what a log beside it says; 0 if it is no file
/// of SQLite.
std::int64_t applicationOf(const fs::path& part) {
  constexpr std::size_t kHead = 100, kAt = 68;
  std::array<char, kHead> head{};
  auto in = haptics::openInput(part, std::uintmax_t{1} << 62);
  if (!in || !in->read(head.data(), kHead) ||
      std::string_view(head.data(), 16) != std::string_view("SQLite format 3\0", 16))
    return 0;
  std::int64_t application = 0;
  for (std::size_t i = kAt; i < kAt + 4; ++i)
    application = application << 8 | static_cast<unsigned char>(head[i]);
  return application;
}

}  // namespace

void syncFolderOf(const fs::path& path) {
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  const int file = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (file < 0) return;
  ::fsync(file);
  ::close(file);
}

haptics::Expected<fs::path> completed(std::optional<Database>& database, const fs::path& part,
                                      const fs::path& target) {
  const auto failed = [&](haptics::Message why) {
    if (database) database->keepLog();
    database.reset();
    return tl::unexpected(
        haptics::Error{haptics::Error::Kind::Unsupported, std::move(why), "unfinished"});
  };
  const std::string name = part.filename().string();
  if (!database->run("PRAGMA wal_checkpoint(TRUNCATE); PRAGMA journal_mode = DELETE;"))
    return failed({"recording-unfinished-disk", {database->complaint(), name}});
  if (!database->isSound()) return failed({"recording-unfinished-damaged", {name}});
  database.reset();
  std::error_code error;
  fs::rename(part, target, error);
  if (error) return failed({"recording-unfinished-disk", {error.message(), name}});
  syncFolderOf(target);
  return target;
}

fs::path partOf(const fs::path& target) {
  // names have 255 bytes, and SQLite adds "-journal"
  constexpr std::size_t kLongest = 255 - 8;
  const std::string ending = target.extension().string() + ".part";
  const std::string stem = target.stem().string();
  if (stem.size() + ending.size() <= kLongest) return fs::path(target.string() + ".part");
  return target.parent_path() /
         (stem.substr(0, kLongest - std::min(kLongest, ending.size())) + ending);
}

std::optional<haptics::Error> foreignBeside(const fs::path& recording) {
  for (const char* log : {"-journal", "-wal", "-shm"}) {
    const fs::path beside = recording.string() + log;
    struct stat what {};
    if (::lstat(beside.c_str(), &what) != 0) continue;
    // Palpate leaves a log, and SQLite empties or deletes what has the name of one
    if (log != std::string_view{"-journal"} && S_ISREG(what.st_mode) && what.st_nlink == 1)
      continue;
    return haptics::Error{haptics::Error::Kind::Unsupported,
                          {"recording-beside", {recording.string(), beside.filename().string()}},
                          "beside"};
  }
  return {};
}

bool isInUse(const fs::path& part) { return Database::isLocked(part); }

haptics::Expected<fs::path> recover(const fs::path& part) {
  const auto refused = [](haptics::Message why, const char* reason) {
    return tl::unexpected(haptics::Error{haptics::Error::Kind::Malformed, std::move(why), reason});
  };
  if (part.extension() != ".part")
    return refused({"recovery-no-recording", {part.string()}}, "no-part");
  std::error_code error;
  if (!fs::is_regular_file(part, error))
    return refused({"recovery-no-file", {part.string()}}, "not-found");
  // as it lies, before SQLite opens it to write: what is not ours is not touched
  if (struct stat what{}; ::lstat(part.c_str(), &what) != 0 || what.st_nlink != 1)
    return refused({"recovery-other-names", {part.string()}}, "beside");
  if (auto beside = foreignBeside(part)) return tl::unexpected(std::move(*beside));
  if (isInUse(part)) return refused({"recovery-in-use", {part.string()}}, "in-use");
  const fs::path log = part.string() + "-wal";
  fs::file_time_type written = fs::last_write_time(part, error);
  const bool has_log = fs::exists(log, error);
  if (has_log) written = std::max(written, fs::last_write_time(log, error));
  const auto noRecording = [&] {
    return has_log || part.stem().extension() != ".palpate"
               ? refused({"recovery-no-recording", {part.string()}}, "no-recording")
               : refused({"recovery-no-log", {part.string(), log.filename().string()}},
                         "no-recording");
  };
  if (applicationOf(part) != kApplicationId) return noRecording();
  auto opened = Database::open(part, Database::Mode::Recover);
  if (!opened)
    return refused({"recovery-failed", {part.string(), opened.error().message}}, "unreadable");
  std::optional<Database> database{std::move(*opened)};
  if (!database->run("BEGIN IMMEDIATE; COMMIT;"))
    return database->isBusy()
               ? refused({"recovery-in-use", {part.string()}}, "in-use")
               : refused({"recovery-failed", {part.string(), database->complaint()}}, "damaged");
  if (database->integer("PRAGMA application_id") != kApplicationId ||
      !database->hasSchema(tablesOf(database->integer("PRAGMA user_version")).c_str()))
    return noRecording();
  if (database->integer("SELECT count(*) FROM step") == 0)
    return refused({"recovery-empty", {part.string()}}, "empty");
  const fs::path stem = fs::path(part).replace_extension();
  fs::path target = stem;
  for (int n = 2; fs::exists(target, error); ++n)
    target = stem.parent_path() /
             (stem.stem().string() + "-" + std::to_string(n) + stem.extension().string());
  auto recovered = completed(database, part, target);
  // of when it was recorded
  if (recovered) fs::last_write_time(*recovered, written, error);
  return recovered;
}

}  // namespace app
