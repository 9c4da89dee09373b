// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <memory>

#include "app/film/frame.h"
#include "haptics/core/error.h"

namespace app {

/// An Ogg file (Theora), for films without ffmpeg. The same frames give the same bytes.
class TheoraFile {
 public:
  TheoraFile(const std::filesystem::path& file, const FilmFormat& format);
  ~TheoraFile();
  TheoraFile(TheoraFile&& other) noexcept;
  TheoraFile& operator=(TheoraFile&&) = delete;

  /// Refusal: "encoder".
  haptics::Expected<void> write(const FilmFrame& frame);
  /// Call after the last frame: writes the rest, and checks that all was written.
  haptics::Expected<void> finish();

 private:
  struct Writer;
  std::unique_ptr<Writer> writer_;
};

}  // namespace app
