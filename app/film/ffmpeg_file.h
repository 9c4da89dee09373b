// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>
#include <utility>

#include "app/film/frame.h"
#include "haptics/core/error.h"

namespace app {

/// An MP4 (H.264) written by an ffmpeg process. write() passes each frame when it is drawn. The
/// destructor ends the process.
class FfmpegFile {
 public:
  /// Nullopt if the program does not exist or cannot be started. A name without a slash is searched
  /// in PATH.
  static std::optional<FfmpegFile> start(const std::string& program,
                                         const std::filesystem::path& file,
                                         const FilmFormat& format);
  /// If finish() was not called, kills the process and waits for it; the file stays as it is.
  ~FfmpegFile();
  FfmpegFile(FfmpegFile&& other) noexcept;
  FfmpegFile& operator=(FfmpegFile&&) = delete;

  /// Refusals: "encoder" (the process ended; the message has the first line of its stderr),
  /// "cancelled".
  haptics::Expected<void> write(const FilmFrame& frame, const StillWanted& wanted);
  /// Call after the last frame: waits until the file is complete.
  haptics::Expected<void> finish(const StillWanted& wanted);

 private:
  FfmpegFile(std::filesystem::path file, pid_t process, int frames, int words)
      : file_{std::move(file)}, process_{process}, frames_{frames}, words_{words} {}
  bool listen();
  bool ended(int& status);
  haptics::Error failure();

  std::filesystem::path file_;
  pid_t process_ = -1;
  int frames_ = -1;        ///< a socket to its standard input
  int words_ = -1;         ///< its standard error
  std::string said_ = {};  ///< the beginning of its stderr
};

}  // namespace app
