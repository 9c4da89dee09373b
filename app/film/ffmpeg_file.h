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

/// An MP4 (H.264) that a process of ffmpeg writes. It is given the frames as they are drawn and is
/// never ahead of them by more than a frame. Ends with the object.
class FfmpegFile {
 public:
  /// None where there is no such program, or it cannot be started. A name without a slash is looked
  /// for in PATH.
  static std::optional<FfmpegFile> start(const std::string& program,
                                         const std::filesystem::path& file,
                                         const FilmFormat& format);
  /// Unless finished, the process is killed and waited for; the file stays as it is.
  ~FfmpegFile();
  FfmpegFile(FfmpegFile&& other) noexcept;
  FfmpegFile& operator=(FfmpegFile&&) = delete;

  /// Refusals: "encoder" (the process ended; the sentence has its first words), "cancelled".
  haptics::Expected<void> write(const FilmFrame& frame, const StillWanted& wanted);
  /// After the last frame: waits until the file is whole.
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
  std::string said_ = {};  ///< the beginning of that
};

}  // namespace app
