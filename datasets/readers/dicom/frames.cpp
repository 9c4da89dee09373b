// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/readers/dicom/frames.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "datasets/readers/dicom/codestream.h"
#include "datasets/readers/dicom/encapsulated.h"
#include "datasets/readers/dicom/rewritten_file.h"
#include "datasets/readers/files/refusal.h"

namespace datasets {

using haptics::Expected;
using haptics::ScalarType;

namespace {

haptics::Error undecodable(const DicomFile& file) {
  return malformed("truncated", {"dicom-pixels-undecodable", {quoted(file.path)}}).value();
}

/// As they lie in the file: vtk-dicom's own reader masks bits that mean padding, and knows no
/// others than the lowest.
class PlainFrames : public FileFrames {
 public:
  Expected<Pixels> pixelsOf(const DicomFile& frame, const ReadProgress&) override {
    if (!in_.is_open())
      if (const auto done = open(frame); !done) return tl::unexpected(done.error());
    const auto count = static_cast<std::size_t>(frame.plane.columns * frame.plane.rows);
    const ScalarType type = storedTypeOf(frame);
    if (frame.bits_allocated == 1) return bitsOf(frame, count);
    const std::size_t size = haptics::sizeOf(type);
    words_.resize(count * size);
    const auto bytes = static_cast<std::streamoff>(words_.size());
    in_.seekg(frame.pixels_begin + frame.frame * bytes);
    if (!in_.read(reinterpret_cast<char*>(words_.data()), bytes))
      return tl::unexpected(undecodable(frame));
    if (swapped_bytes_ > 1)
      for (auto at = words_.begin(); words_.end() - at >= swapped_bytes_; at += swapped_bytes_)
        std::reverse(at, at + swapped_bytes_);
    return Pixels{type, words_.data()};
  }

 private:
  Expected<void> open(const DicomFile& file) {
    if (file.rewritten) {
      auto copy = RewrittenFile::of(file.path);
      if (!copy) return tl::unexpected(copy.error());
      rewritten_.emplace(std::move(*copy));
    }
    in_.open(rewritten_ ? rewritten_->path() : file.path.string(), std::ios::binary);
    if (file.syntax != kBigEndian) return {};
    // bytes that are stored as words of 16 bits are turned about as such
    std::array<char, 2> representation{};
    in_.seekg(file.pixels_begin - 8);
    in_.read(representation.data(), 2);
    const bool as_words = std::string_view{representation.data(), 2} == "OW";
    swapped_bytes_ = file.bits_allocated == 8 && as_words ? 2 : file.bits_allocated / 8;
    return {};
  }

  /// Of a frame that may begin within a byte, the lowest bit of a byte first.
  Expected<Pixels> bitsOf(const DicomFile& frame, std::size_t count) {
    const std::size_t first = count * std::size_t(frame.frame);
    std::vector<unsigned char> packed((first % 8 + count + 7) / 8);
    in_.seekg(frame.pixels_begin + std::streamoff(first / 8));
    if (!in_.read(reinterpret_cast<char*>(packed.data()), std::streamsize(packed.size())))
      return tl::unexpected(undecodable(frame));
    words_.resize(count);
    for (std::size_t n = 0; n < count; ++n) {
      const std::size_t bit = first % 8 + n;
      words_[n] = std::byte(packed[bit / 8] >> (bit % 8) & 1U);
    }
    return Pixels{ScalarType::UInt8, words_.data()};
  }

  static constexpr std::string_view kBigEndian = "1.2.840.10008.1.2.2";
  std::optional<RewrittenFile> rewritten_;
  std::ifstream in_;
  std::ptrdiff_t swapped_bytes_ = 1;
  std::vector<std::byte> words_;
};

/// Compressed: each frame by a program of its own.
class CompressedFrames : public FileFrames {
 public:
  explicit CompressedFrames(Decoders& decoders) : decoders_{decoders} {}
  ~CompressedFrames() override {
    if (decoder_) decoders_.give(std::move(decoder_));
  }

  Expected<Pixels> pixelsOf(const DicomFile& frame, const ReadProgress& progress) override {
    if (!frames_) {
      auto found = EncapsulatedFrames::of(frame.path, frame.pixels_begin, frame.frame_count,
                                          *codingOf(frame.syntax));
      if (!found) return tl::unexpected(std::move(found.error()));
      frames_ = std::move(*found);
    }
    const auto bytes = frames_->bytesOf(frame.frame);
    if (!bytes) return tl::unexpected(bytes.error());
    // what a decoder takes for a frame must fit any machine; mammograms have a third of it
    constexpr std::int64_t kMostPixels = std::int64_t{1} << 26;
    if (frame.plane.columns * frame.plane.rows > kMostPixels)
      return malformed(
          "truncated",
          {"dicom-frame-refused",
           {quoted(frame.path),
            {"codestream-too-many-pixels",
             {std::to_string(frame.plane.columns) + " x " + std::to_string(frame.plane.rows)}}}});
    if (!decoder_) {
      auto taken = decoders_.take();
      if (!taken) return tl::unexpected(std::move(taken.error()));
      decoder_ = std::move(*taken);
    }
    switch (decoder_->decode(requestFor(frame), *bytes, progress)) {
      case Decoder::Outcome::Decoded:
        return Pixels{storedTypeOf(frame), decoder_->pixels()};
      case Decoder::Outcome::Damaged:
        return tl::unexpected(undecodable(frame));
      case Decoder::Outcome::Differs:
        return malformed("bad-header",
                         {"dicom-frame-refused", {quoted(frame.path), decoder_->difference()}});
      case Decoder::Outcome::Cancelled:
        decoder_.reset();
        return cancelled();
      case Decoder::Outcome::Died:
      case Decoder::Outcome::TooLong:
        break;
    }
    decoder_.reset();
    return malformed("truncated", {"dicom-frame-ends-decoder", {quoted(frame.path)}});
  }

 private:
  static decode::Request requestFor(const DicomFile& file) {
    return {.coding = *codingOf(file.syntax),
            .columns = static_cast<std::uint32_t>(file.plane.columns),
            .rows = static_cast<std::uint32_t>(file.plane.rows),
            .bytes_per_pixel = static_cast<std::uint32_t>(file.bits_allocated / 8),
            .bits_stored = static_cast<std::uint32_t>(file.bits_stored),
            .is_signed = file.is_signed ? 1U : 0U};
  }

  Decoders& decoders_;
  std::unique_ptr<Decoder> decoder_;
  std::optional<EncapsulatedFrames> frames_;
};

}  // namespace

std::unique_ptr<FileFrames> framesOf(const DicomFile& file, Decoders& decoders) {
  if (codingOf(file.syntax)) return std::make_unique<CompressedFrames>(decoders);
  return std::make_unique<PlainFrames>();
}

Decoders decodersFor(std::span<const DicomFile> files) {
  std::size_t coded = 0, decoded = 0;
  for (const DicomFile& file : files) {
    std::error_code error;
    const auto size = std::filesystem::file_size(file.path, error);
    coded = std::max(coded, error ? std::size_t{0} : static_cast<std::size_t>(size));
    decoded = std::max(decoded, static_cast<std::size_t>(file.plane.columns * file.plane.rows *
                                                         (file.bits_allocated / 8)));
  }
  return {coded, decoded};
}

}  // namespace datasets
