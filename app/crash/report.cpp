// SPDX-License-Identifier: BSD-3-Clause
#include "app/crash/report.h"

#include <cxxabi.h>
#include <dwarf.h>
#include <elfutils/libdwfl.h>
#include <fcntl.h>
#include <link.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/utsname.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <map>
#include <memory>
#include <system_error>
#include <utility>
#include <vector>

#include "app/build_info/build_identity.h"
#include "app/crash/raw_file.h"
#include "app/log/log.h"
#include "haptics/process/output_file.h"

namespace app::crash {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLogLines = 50;
constexpr const char* kSymbols = "/usr/lib/debug/.build-id/";  // where -dbgsym packages have them

bool isWord(std::string_view text, std::string_view allowed, std::size_t longest) {
  return !text.empty() && text.size() <= longest &&
         text.find_first_not_of(allowed) == std::string_view::npos;
}

constexpr std::string_view kHexDigits = "0123456789abcdef";
constexpr std::string_view kVersionLetters =
    "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789.+~-";

template <class Number>
std::optional<Number> hexIn(std::string_view text) {
  Number number{};
  const auto end = text.data() + text.size();
  const auto [behind, failed] = std::from_chars(text.data(), end, number, 16);
  if (failed != std::errc{} || behind != end) return {};
  return number;
}

struct Frame {
  std::string identity;  ///< of the module; empty: none is known
  std::uint64_t address = 0;
  bool is_instruction = false;
};

struct Raw {
  std::string version = "?", build = "?", session;
  int signal = 0;  ///< 0: none
  std::vector<Frame> frames;
};

std::optional<Frame> frameOf(std::string_view line) {
  Frame frame;
  const std::size_t first = line.find(' '), second = line.find(' ', first + 1);
  if (first == std::string_view::npos || second == std::string_view::npos) return {};
  const std::string_view identity = line.substr(0, first), last = line.substr(second + 1);
  if (identity != "-") {
    if (!isWord(identity, kHexDigits, 2 * raw::kLongestIdentity)) return {};
    frame.identity = identity;
  }
  const auto address = hexIn<std::uint64_t>(line.substr(first + 1, second - first - 1));
  if (!address || (last != "0" && last != "1")) return {};
  frame.address = *address;
  frame.is_instruction = last == "1";
  return frame;
}

Raw rawOf(std::string_view text) {
  Raw raw;
  text = text.substr(0, raw::kMostBytes);
  if (!text.starts_with(std::string{raw::kHead} + '\n')) return raw;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    if (end == std::string_view::npos) break;  // cut off
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(end + 1);
    const auto after = [line](const char* name) -> std::optional<std::string_view> {
      if (!line.starts_with(name)) return {};
      return line.substr(std::strlen(name));
    };
    if (const auto version = after(raw::kVersion)) {
      if (isWord(*version, kVersionLetters, 32)) raw.version = *version;
    } else if (const auto build = after(raw::kBuild)) {
      if (isWord(*build, kHexDigits, 64)) raw.build = *build;
    } else if (const auto session = after(raw::kSession)) {
      if (isWord(*session, "0123456789abcdef-", 40)) raw.session = *session;
    } else if (const auto signal = after(raw::kSignal)) {
      if (const auto number = hexIn<int>(*signal)) raw.signal = *number;
    } else if (const auto at = after(raw::kAt)) {
      const auto frame = frameOf(*at);
      if (frame && raw.frames.size() < raw::kMostFrames) raw.frames.push_back(*frame);
    }
  }
  return raw;
}

// --- symbols -----------------------------------------------------------------------------------

/// The modules of this process: build identity and file. A program that crashed a start ago has the
/// same.
std::map<std::string, std::string> modulesHere() {
  std::map<std::string, std::string> modules;
  dl_iterate_phdr(
      [](dl_phdr_info* module, std::size_t, void* out) {
        const bool is_program = module->dlpi_name == nullptr || *module->dlpi_name == '\0';
        const std::string identity = buildIdentityOf(*module);
        std::error_code failed;
        if (!identity.empty())
          static_cast<std::map<std::string, std::string>*>(out)->emplace(
              identity,
              is_program ? fs::read_symlink("/proc/self/exe", failed).string() : module->dlpi_name);
        return 0;
      },
      &modules);
  return modules;
}

/// Debug symbols of this identity on this machine; the library's own search may ask a server.
/// `called`: a path where a file that several modules share is sought, which we do without.
int findSymbols(Dwfl_Module* module, void**, const char*, Dwarf_Addr, const char*,
                const char* called, GElf_Word, char**) {
  if (called != nullptr && std::strchr(called, '/') != nullptr) return -1;
  const unsigned char* bytes = nullptr;
  GElf_Addr where = 0;
  const int count = dwfl_module_build_id(module, &bytes, &where);
  if (count < 2) return -1;
  std::string path = kSymbols;
  for (int b = 0; b < count; ++b) {
    path += kHexDigits[bytes[b] / 16];
    path += kHexDigits[bytes[b] % 16];
    if (b == 0) path += '/';
  }
  path += ".debug";
  return open(path.c_str(), O_RDONLY | O_CLOEXEC);
}

std::string readable(const char* symbol) {
  constexpr std::size_t kLongest = 300;
  int status = 0;
  const std::unique_ptr<char, decltype(&std::free)> words{
      abi::__cxa_demangle(symbol, nullptr, nullptr, &status), &std::free};
  return std::string{words ? words.get() : symbol}.substr(0, kLongest);
}

/// One module, and what is known of the places in it.
class Symbols {
 public:
  explicit Symbols(const std::string& file) {
    static const Dwfl_Callbacks callbacks{.find_elf = nullptr,
                                          .find_debuginfo = findSymbols,
                                          .section_address = dwfl_offline_section_address,
                                          .debuginfo_path = nullptr};
    dwfl_.reset(dwfl_begin(&callbacks));
    if (!dwfl_) return;
    dwfl_report_begin(dwfl_.get());
    module_ = dwfl_report_elf(dwfl_.get(), "module", file.c_str(), -1, 0, true);
    dwfl_report_end(dwfl_.get(), nullptr, nullptr);
  }

  /// " function (file:line)", or less of it.
  std::string at(std::uint64_t address) const {
    if (module_ == nullptr) return {};
    std::string words;
    if (const char* symbol = dwfl_module_addrname(module_, address))
      words += ' ' + readable(symbol);
    Dwfl_Line* line = dwfl_module_getsrc(module_, address);
    int number = 0;
    const char* source = line == nullptr
                             ? nullptr
                             : dwfl_lineinfo(line, nullptr, &number, nullptr, nullptr, nullptr);
    if (source != nullptr)
      words += " (" + fs::path{source}.filename().string() + ':' + std::to_string(number) + ')';
    return words;
  }

 private:
  std::unique_ptr<Dwfl, decltype(&dwfl_end)> dwfl_{nullptr, &dwfl_end};
  Dwfl_Module* module_ = nullptr;
};

std::string hexOf(std::uint64_t number) {
  std::string digits(16, '0');
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number, 16).ptr;
  digits.resize(static_cast<std::size_t>(end - digits.data()));
  return digits;
}

std::string framesOf(const std::vector<Frame>& frames, Names names,
                     const std::atomic<bool>& cancel) {
  const std::map<std::string, std::string> modules = modulesHere();
  std::map<std::string, Symbols> symbols;
  std::string words;
  for (std::size_t n = 0; n < frames.size() && !cancel; ++n) {
    const Frame& frame = frames[n];
    words += "  #" + std::to_string(n) + ' ';
    const auto module = modules.find(frame.identity);
    if (module == modules.end()) {
      words += frame.identity.empty() ? "no module" : "module " + frame.identity;
      words += " 0x" + hexOf(frame.address) + '\n';
      continue;
    }
    words += fs::path{module->second}.filename().string() + "+0x" + hexOf(frame.address);
    // behind a call lies the next line, or the next function
    const std::uint64_t place = frame.address - (frame.is_instruction ? 0 : 1);
    if (names == Names::Sought)
      words += symbols.try_emplace(frame.identity, module->second).first->second.at(place);
    words += '\n';
  }
  return words;
}

// ----------------------------------------------------------------------------------------------

/// "Debian GNU/Linux 12 (bookworm), Linux 6.1.0, x86_64"
std::string systemHere() {
  std::string system = "unknown system", line;
  std::ifstream release{"/etc/os-release"};
  while (std::getline(release, line))
    if (line.starts_with("PRETTY_NAME=")) {
      system = line.substr(std::strlen("PRETTY_NAME="));
      std::erase(system, '"');
    }
  utsname kernel{};
  if (uname(&kernel) == 0)
    system += std::string{", Linux "} + kernel.release + ", " + kernel.machine;
  return system;
}

/// A raw file that no process holds, held while the object lives.
class LeftFile {
 public:
  explicit LeftFile(fs::path path)
      : path_{std::move(path)},
        file_{open(path_.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC | O_NOFOLLOW)} {
    struct stat facts {};
    // one without a name was another start's until now
    if (file_ < 0 || flock(file_, LOCK_EX | LOCK_NB) != 0 || fstat(file_, &facts) != 0 ||
        !S_ISREG(facts.st_mode) || facts.st_nlink == 0)
      return;
    text_.emplace(raw::kMostBytes, '\0');
    const ssize_t count = read(file_, text_->data(), text_->size());
    text_->resize(count < 0 ? 0 : static_cast<std::size_t>(count));
  }
  ~LeftFile() {
    if (file_ >= 0) close(file_);
  }
  LeftFile(LeftFile&& other) noexcept
      : path_{std::move(other.path_)},
        file_{std::exchange(other.file_, -1)},
        text_{std::move(other.text_)} {}
  LeftFile& operator=(LeftFile&&) = delete;

  const std::optional<std::string>& text() const { return text_; }
  void remove() const {
    std::error_code failed;
    fs::remove(path_, failed);
  }

 private:
  fs::path path_;
  int file_;
  std::optional<std::string> text_;  ///< empty: not ours
};

/// Those that tell of a crash. Those of processes that were killed are removed.
std::vector<LeftFile> crashesIn(const fs::path& folder) {
  std::vector<fs::path> paths;
  std::error_code failed;
  for (fs::directory_iterator entry{folder, failed}, end; !failed && entry != end;
       entry.increment(failed))
    if (entry->path().extension() == raw::kEnding) paths.push_back(entry->path());
  std::ranges::sort(paths);
  std::vector<LeftFile> left;
  for (fs::path& path : paths) {
    LeftFile file{std::move(path)};
    if (!file.text()) continue;
    if (rawOf(*file.text()).signal > 0)
      left.push_back(std::move(file));
    else
      file.remove();
  }
  return left;
}

void keep(const std::string& report, const fs::path& path) {
  // a pipe would be written to, and its reader waited for
  std::error_code failed;
  if (fs::exists(path, failed) && !fs::is_regular_file(path, failed)) return;
  auto file = haptics::OutputFile::open(path);
  if (file && file->write(report) && file->close()) (void)file->finish();
}

}  // namespace

std::optional<std::string> reportOf(std::string_view raw_text, const fs::path& folder, Names names,
                                    const std::atomic<bool>& cancel) {
  const Raw raw = rawOf(raw_text);
  if (raw.signal <= 0) return {};
  const char* name = sigabbrev_np(raw.signal);
  std::string words = "Palpate " + raw.version + ", build " + raw.build + '\n' + systemHere() +
                      "\nEnded by signal " + std::to_string(raw.signal) +
                      (name == nullptr ? "" : std::string{", SIG"} + name) + "\n\nFunctions";
  if (names == Names::LeftOut) words += " (names were not sought: the last time that did not end)";
  words += ":\n" + framesOf(raw.frames, names, cancel) + "\nThe log before:\n";
  if (!raw.session.empty())
    for (const std::string& line : log::lines(folder, kLogLines, raw.session))
      words += "  " + line + '\n';
  return words;
}

fs::path reportFile(const fs::path& folder) { return folder / "crash-report.txt"; }

std::optional<std::string> takeReport(const fs::path& folder, const std::atomic<bool>& cancel) {
  if (folder.empty()) return {};
  const std::vector<LeftFile> left = crashesIn(folder);
  if (left.empty()) return {};
  // libdw may crash on a damaged module; it would do so at every start
  const fs::path attempt = folder / "crash-names";
  const int mark = open(attempt.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, S_IRUSR);
  const Names names = mark < 0 && errno == EEXIST ? Names::LeftOut : Names::Sought;
  if (mark >= 0) close(mark);
  std::string all;
  for (const LeftFile& file : left)
    if (const auto report = reportOf(*file.text(), folder, names, cancel))
      all += (all.empty() ? "" : "\n") + *report;
  std::error_code failed;
  fs::remove(attempt, failed);
  if (cancel) return {};
  keep(all, reportFile(folder));  // where that cannot be, it is shown all the same
  for (const LeftFile& file : left) file.remove();
  return all;
}

}  // namespace app::crash
