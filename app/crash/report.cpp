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

#include "app/crash/raw_file.h"
#include "app/log/log.h"

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
bool readNumber(std::string_view text, Number& number, int base) {
  const auto end = text.data() + text.size();
  const auto [behind, failed] = std::from_chars(text.data(), end, number, base);
  return failed == std::errc{} && behind == end;
}

struct Frame {
  std::string identity;  ///< of the module; empty: none is known
  std::uint64_t address = 0;
  bool is_instruction = false;
};

struct Raw {
  std::string version = "?", build = "?";
  int process = 0, signal = 0;
  std::vector<Frame> frames;
};

std::optional<Frame> frameOf(std::string_view line) {
  Frame frame;
  const std::size_t first = line.find(' '), second = line.find(' ', first + 1);
  if (first == std::string_view::npos || second == std::string_view::npos) return {};
  const std::string_view identity = line.substr(0, first), last = line.substr(second + 1);
  if (identity != "-") {
    if (!isWord(identity, kHexDigits, 64) || identity.size() < 4) return {};
    frame.identity = identity;
  }
  if (!readNumber(line.substr(first + 1, second - first - 1), frame.address, 16)) return {};
  if (last != "0" && last != "1") return {};
  frame.is_instruction = last == "1";
  return frame;
}

Raw rawOf(std::string_view text) {
  Raw raw;
  text = text.substr(0, raw::kMostBytes);
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
    } else if (const auto process = after(raw::kProcess)) {
      readNumber(*process, raw.process, 10);
    } else if (const auto signal = after(raw::kSignal)) {
      readNumber(*signal, raw.signal, 16);
    } else if (const auto at = after(raw::kAt)) {
      const auto frame = frameOf(*at);
      if (frame && raw.frames.size() < raw::kMostFrames) raw.frames.push_back(*frame);
    }
  }
  return raw;
}

// --- symbols -----------------------------------------------------------------------------------

std::string identityIn(const char* at, const char* end) {
  std::string identity;
  const auto padded = [](std::size_t size) { return (size + 3) / 4 * 4; };
  while (at + sizeof(ElfW(Nhdr)) < end) {
    ElfW(Nhdr) note;
    std::memcpy(&note, at, sizeof note);
    const char* name = at + sizeof note;
    const char* content = name + padded(note.n_namesz);
    if (note.n_type == NT_GNU_BUILD_ID && note.n_namesz == 4 && std::memcmp(name, "GNU", 4) == 0) {
      for (std::size_t b = 0; b < note.n_descsz; ++b) {
        const auto byte = static_cast<unsigned char>(content[b]);
        identity += kHexDigits[byte / 16];
        identity += kHexDigits[byte % 16];
      }
      return identity;
    }
    at = content + padded(note.n_descsz);
  }
  return identity;
}

/// The modules of this process: build identity and file. A program that crashed a start ago has the
/// same.
std::map<std::string, std::string> modulesHere() {
  std::map<std::string, std::string> modules;
  dl_iterate_phdr(
      [](dl_phdr_info* module, std::size_t, void* out) {
        for (int n = 0; n < module->dlpi_phnum; ++n) {
          const ElfW(Phdr)& segment = module->dlpi_phdr[n];
          if (segment.p_type != PT_NOTE) continue;
          const auto* at = reinterpret_cast<const char*>(module->dlpi_addr + segment.p_vaddr);
          const std::string identity = identityIn(at, at + segment.p_memsz);
          if (identity.empty()) continue;
          const bool is_program = module->dlpi_name == nullptr || *module->dlpi_name == '\0';
          std::string file = module->dlpi_name == nullptr ? "" : module->dlpi_name;
          if (is_program) {
            std::error_code failed;
            file = fs::read_symlink("/proc/self/exe", failed).string();
          }
          static_cast<std::map<std::string, std::string>*>(out)->emplace(identity, file);
          break;
        }
        return 0;
      },
      &modules);
  return modules;
}

/// Debug symbols of this identity on this machine; the library's own search may ask a server.
int findSymbols(Dwfl_Module* module, void**, const char*, Dwarf_Addr, const char*, const char*,
                GElf_Word, char**) {
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

std::string framesOf(const std::vector<Frame>& frames) {
  const std::map<std::string, std::string> modules = modulesHere();
  std::map<std::string, Symbols> symbols;
  std::string words;
  for (std::size_t n = 0; n < frames.size(); ++n) {
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
    words += symbols.try_emplace(frame.identity, module->second).first->second.at(place) + '\n';
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

class OpenFile {
 public:
  OpenFile(const fs::path& path, int flags)
      : file_{open(path.c_str(), flags | O_CLOEXEC | O_NOFOLLOW, S_IRUSR | S_IWUSR)} {}
  ~OpenFile() {
    if (file_ >= 0) close(file_);
  }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  int get() const { return file_; }

 private:
  int file_;
};

/// The text of a raw file that no process holds.
std::optional<std::string> textOf(const fs::path& path) {
  const OpenFile file{path, O_RDWR | O_NONBLOCK};
  struct stat facts {};
  if (file.get() < 0 || fstat(file.get(), &facts) != 0 || !S_ISREG(facts.st_mode)) return {};
  if (flock(file.get(), LOCK_EX | LOCK_NB) != 0) return {};
  std::string text(raw::kMostBytes, '\0');
  const ssize_t count = read(file.get(), text.data(), text.size());
  text.resize(count < 0 ? 0 : static_cast<std::size_t>(count));
  return text;
}

}  // namespace

std::optional<std::string> reportOf(std::string_view raw_text, const fs::path& folder) {
  const Raw raw = rawOf(raw_text);
  if (raw.signal <= 0) return {};
  const char* name = sigabbrev_np(raw.signal);
  std::string words = "Palpate " + raw.version + ", build " + raw.build + '\n' + systemHere() +
                      "\nEnded by signal " + std::to_string(raw.signal) +
                      (name == nullptr ? "" : std::string{", SIG"} + name) + "\n\nFunctions:\n";
  words += framesOf(raw.frames);
  words += "\nThe log before:\n";
  if (raw.process > 0)
    for (const std::string& line : log::lines(folder, kLogLines, raw.process))
      words += "  " + line + '\n';
  return words;
}

fs::path reportFile(const fs::path& folder) { return folder / "crash-report.txt"; }

std::optional<std::string> takeReport(const fs::path& folder) {
  std::string all;
  std::error_code failed;
  std::vector<fs::path> left;
  if (!folder.empty())
    for (fs::directory_iterator entry{folder, failed}, end; !failed && entry != end;
         entry.increment(failed))
      if (entry->path().extension() == raw::kEnding) left.push_back(entry->path());
  std::ranges::sort(left);
  for (const fs::path& path : left) {
    const auto text = textOf(path);
    if (!text) continue;
    if (const auto report = reportOf(*text, folder)) all += (all.empty() ? "" : "\n") + *report;
    fs::remove(path, failed);
  }
  if (all.empty()) return {};
  fs::remove(reportFile(folder), failed);
  const OpenFile file{reportFile(folder), O_WRONLY | O_CREAT | O_EXCL};
  // where it cannot be kept it is shown all the same
  for (std::string_view rest = all; !rest.empty();) {
    const ssize_t count = write(file.get(), rest.data(), rest.size());
    if (count <= 0) break;
    rest.remove_prefix(static_cast<std::size_t>(count));
  }
  return all;
}

}  // namespace app::crash
