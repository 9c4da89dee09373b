// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkSmartPointer.h>

#include <filesystem>

#include "app/film/frame.h"
#include "haptics/core/error.h"

class vtkImageData;
class vtkOggTheoraWriter;

namespace app {

/// An Ogg file (Theora), written by VTK where there is no ffmpeg.
class TheoraFile {
 public:
  TheoraFile(const std::filesystem::path& file, const FilmFormat& format);
  ~TheoraFile();
  TheoraFile(TheoraFile&& other) noexcept;
  TheoraFile& operator=(TheoraFile&&) = delete;

  /// Refusal: "encoder".
  haptics::Expected<void> write(const FilmFrame& frame);
  /// After the last frame; sees that all of it is on the disk.
  haptics::Expected<void> finish();

 private:
  std::filesystem::path file_;
  vtkSmartPointer<vtkImageData> picture_;
  vtkSmartPointer<vtkOggTheoraWriter> writer_;
};

}  // namespace app
