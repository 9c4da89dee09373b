// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

/// What a crash leaves: first a raw file of addresses, and from the next start on a report that can
/// be read. Neither leaves the machine.
namespace app::crash {

/// The raw file of this process, in the user's folder for logs, readable by the user alone. It says
/// which build this is. After a crash has stopped the motors, it adds the signal and the addresses
/// of the functions that were under way. The destructor removes the file.
///
/// One object, made by the thread that calls main() before another exists. Where the folder cannot
/// be written, a crash leaves nothing.
class RawFile {
 public:
  explicit RawFile(const std::filesystem::path& folder);
  ~RawFile();
  RawFile(const RawFile&) = delete;
  RawFile& operator=(const RawFile&) = delete;

 private:
  std::string path_;
  int file_ = -1;
};

/// The lines of a raw file.
namespace raw {
inline constexpr const char* kEnding = ".raw";
inline constexpr const char* kHead = "palpate-crash 1";
inline constexpr const char* kVersion = "version ";
inline constexpr const char* kBuild = "build ";
inline constexpr const char* kSession = "session ";  ///< as the log has it
inline constexpr const char* kSignal = "signal ";
/// Build identity of the module or "-", the address within it, and whether the address is that of
/// the instruction (1) or of the one after a call (0); hexadecimal.
inline constexpr const char* kAt = "at ";
inline constexpr int kMostFrames = 128;  ///< a window that is being painted has more than 64
inline constexpr std::size_t kLongestIdentity = 32;  ///< bytes
inline constexpr int kMostBytes = 65'536;            ///< of a file
}  // namespace raw

}  // namespace app::crash
