// SPDX-License-Identifier: BSD-3-Clause
#include "app/film/theora_file.h"

#include <vtkImageData.h>
#include <vtkOggTheoraWriter.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <fstream>

namespace app {
namespace {

using haptics::Error;
using haptics::Expected;

tl::unexpected<Error> failure() {
  return tl::unexpected(Error{Error::Kind::Unsupported,
                              "The film could not be written; check the room on the disk.",
                              "encoder"});
}

/// Whether a file is Ogg pages without a gap up to the one that ends the stream. The writer looks
/// at no write that failed.
bool isWholeTheora(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::array<unsigned char, 27> header{};
  for (std::uint32_t expected = 0;; ++expected) {
    if (!in.read(reinterpret_cast<char*>(header.data()), header.size())) return false;
    std::uint32_t page = 0;
    std::memcpy(&page, header.data() + 18, sizeof page);
    if (std::memcmp(header.data(), "OggS", 4) != 0 || page != expected) return false;
    std::array<unsigned char, 255> segments{};
    if (!in.read(reinterpret_cast<char*>(segments.data()), header[26])) return false;
    std::streamoff size = 0;
    for (int s = 0; s < header[26]; ++s) size += segments[std::size_t(s)];
    // the last byte of the page, so that one cut off is seen
    if (size > 0 && !in.seekg(size - 1, std::ios::cur)) return false;
    if (size > 0 && in.get() == std::ifstream::traits_type::eof()) return false;
    constexpr int kLastPage = 4;
    if (header[5] & kLastPage) return in.peek() == std::ifstream::traits_type::eof();
  }
}

}  // namespace

TheoraFile::TheoraFile(const std::filesystem::path& file, const FilmFormat& format)
    : file_{file},
      picture_{vtkSmartPointer<vtkImageData>::New()},
      writer_{vtkSmartPointer<vtkOggTheoraWriter>::New()} {
  picture_->SetDimensions(format.width, format.height, 1);
  picture_->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  writer_->SetInputData(picture_);
  writer_->SetFileName(file.c_str());
  writer_->SetRate(format.frames_per_second);
  writer_->SetQuality(2);
  writer_->SubsamplingOn();  // as every player wants it
  writer_->Start();
}

TheoraFile::~TheoraFile() = default;
TheoraFile::TheoraFile(TheoraFile&& other) noexcept = default;

Expected<void> TheoraFile::write(const FilmFrame& frame) {
  std::ranges::copy(frame.rgb, static_cast<std::uint8_t*>(picture_->GetScalarPointer()));
  picture_->Modified();
  writer_->Write();
  if (writer_->GetError()) return failure();
  return {};
}

Expected<void> TheoraFile::finish() {
  writer_->End();
  if (writer_->GetError() || !isWholeTheora(file_)) return failure();
  return {};
}

}  // namespace app
