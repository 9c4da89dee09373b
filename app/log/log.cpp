// SPDX-License-Identifier: BSD-3-Clause
#include "app/log/log.h"

#include <spdlog/logger.h>
#include <spdlog/sinks/rotating_file_sink.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <ctime>
#include <deque>
#include <exception>
#include <fstream>
#include <memory>
#include <system_error>

#include "haptics/process/input_file.h"

namespace app::log {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kFileBytes = 1'000'000, kOlderFiles = 2;
constexpr std::uintmax_t kLargestRead = 10 * kFileBytes;
constexpr std::size_t kLongestLine = 64 << 10;
constexpr const char* kFile = "palpate.log";
// in the order of Level
constexpr std::array<std::string_view, 5> kNames{"debug", "info", "warning", "error", "off"};
constexpr std::array kSpdlog{spdlog::level::debug, spdlog::level::info, spdlog::level::warn,
                             spdlog::level::err, spdlog::level::off};

std::shared_ptr<spdlog::logger> logger;

std::string valueOf(const Field& field) {
  struct InText {
    std::string operator()(std::int64_t number) const { return std::to_string(number); }
    std::string operator()(double number) const { return fmt::format("{:.6g}", number); }
    std::string operator()(Word word) const { return std::string{word.text}; }
    std::string operator()(const Name& name) const {
      return name.text().find(' ') == std::string::npos ? name.text() : '"' + name.text() + '"';
    }
  };
  return std::visit(InText{}, field.value);
}

}  // namespace

Level levelOf(std::string_view name) {
  const auto found = std::ranges::find(kNames, name);
  return found == kNames.end() ? Level::Off : static_cast<Level>(found - kNames.begin());
}

Name nameOfProgram(std::string_view name) {
  constexpr std::string_view kAllowed =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_.";
  constexpr std::size_t kLongest = 64;
  const bool is_name = !name.empty() && name.size() <= kLongest &&
                       name.find_first_not_of(kAllowed) == std::string_view::npos;
  return Name{std::string{is_name ? name : "?"}};
}

Name nameOfMachine(std::string_view text) {
  constexpr std::size_t kLongest = 120;
  std::string kept{text.substr(0, kLongest)};
  for (char& c : kept)
    if (c < ' ' || c > '~' || c == '"') c = '?';
  return Name{std::move(kept)};
}

Name nameOf(const haptics::Error& error) {
  return nameOfProgram(error.message.id.empty() ? error.reason : error.message.id);
}

bool open(const fs::path& folder, Level level) {
  close();
  if (folder.empty() || level == Level::Off) return false;
  try {
    fs::create_directories(folder);
    fs::permissions(folder, fs::perms::owner_all);
    // to open a pipe is to wait for its reader
    if (const auto what = fs::status(folder / kFile);
        fs::exists(what) && !fs::is_regular_file(what))
      return false;
    spdlog::file_event_handlers events;
    events.after_open = [](const spdlog::filename_t&, std::FILE* file) {
      fchmod(fileno(file), S_IRUSR | S_IWUSR);
    };
    auto sink = std::make_shared<spdlog::sinks::rotating_file_sink_mt>(
        (folder / kFile).string(), kFileBytes, kOlderFiles, false, events);
    sink->set_pattern("%Y-%m-%d %H:%M:%S.%e [" + session() + "] %l %v");
    auto made = std::make_shared<spdlog::logger>("palpate", std::move(sink));
    made->set_level(kSpdlog.at(static_cast<std::size_t>(level)));
    made->flush_on(spdlog::level::debug);  // a crash leaves what was written
    made->set_error_handler([](const std::string&) {});
    logger = std::move(made);
  } catch (const std::exception&) {  // what is not written is missed by nothing
    return false;
  }
  return true;
}

void close() { logger.reset(); }

void write(Level level, Word event, std::initializer_list<Field> fields) {
  if (!logger) return;
  const auto at = kSpdlog.at(static_cast<std::size_t>(level));
  if (!logger->should_log(at)) return;
  std::string line{event.text};
  for (const Field& field : fields) {
    line += ' ';
    line += field.name.text;
    line += '=';
    line += valueOf(field);
  }
  logger->log(at, spdlog::string_view_t{line});
}

std::string session() {
  static const std::time_t began = std::time(nullptr);
  return fmt::format("{:x}-{:x}", getpid(), began);
}

std::vector<std::string> lines(const fs::path& folder, std::size_t most,
                               const std::string& session) {
  const std::string of = " [" + session + "] ";
  std::deque<std::string> kept;
  for (const char* name : {"palpate.2.log", "palpate.1.log", kFile}) {
    auto file = haptics::openInput(folder / name, kLargestRead);
    if (!file) continue;
    for (std::string line;
         haptics::takeLine(*file, line, kLongestLine) == haptics::LineRead::Whole;) {
      if (!session.empty() && line.find(of) == std::string::npos) continue;
      kept.push_back(std::move(line));
      if (kept.size() > most) kept.pop_front();
    }
  }
  return {kept.begin(), kept.end()};
}

fs::path stateFolder() {
  if (const char* state = std::getenv("XDG_STATE_HOME"); state != nullptr && *state == '/')
    return fs::path{state} / "palpate";
  const char* home = std::getenv("HOME");
  if (home == nullptr || *home != '/') return {};
  return fs::path{home} / ".local" / "state" / "palpate";
}

}  // namespace app::log
