// SPDX-License-Identifier: BSD-3-Clause
#include "app/film/theora_file.h"

#include <ogg/ogg.h>
#include <theora/theoraenc.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <utility>
#include <vector>

namespace app {
namespace {

using haptics::Error;
using haptics::Expected;

constexpr int kQuality = 56;  // of 63
constexpr int kStream = 1;    // its number in the file, where it is alone

tl::unexpected<Error> failure() {
  return tl::unexpected(Error{Error::Kind::Unsupported, {"film-not-written", {}}, "encoder"});
}

unsigned wholeBlocks(int pixels) { return (static_cast<unsigned>(pixels) + 15U) & ~15U; }

/// ITU-R BT.601, limited range, of the mean of n pixels.
std::uint8_t weighted(const std::array<int, 3>& sum, int n, double r, double g, double b,
                      double offset) {
  return static_cast<std::uint8_t>(offset + (r * sum[0] + g * sum[1] + b * sum[2]) / (255.0 * n) +
                                   0.5);
}

}  // namespace

struct TheoraFile::Writer {
  /// Y, Cb or Cr; bytes beyond the picture repeat its edge.
  struct Plane {
    int width = 0, height = 0;  ///< with what fills the blocks
    std::vector<std::uint8_t> bytes = {};
  };

  std::FILE* file = nullptr;
  th_enc_ctx* encoder = nullptr;
  ogg_stream_state stream{};
  std::array<Plane, 3> planes;
  bool begun = false;  ///< there is a frame that is not in the file yet
  bool sound = true;

  Writer(const std::filesystem::path& path, const FilmFormat& format) {
    th_info info;
    th_info_init(&info);
    info.frame_width = wholeBlocks(format.width);
    info.frame_height = wholeBlocks(format.height);
    info.pic_width = static_cast<unsigned>(format.width);
    info.pic_height = static_cast<unsigned>(format.height);
    info.fps_numerator = static_cast<unsigned>(format.frames_per_second);
    info.fps_denominator = 1;
    info.aspect_numerator = info.aspect_denominator = 1;
    info.pixel_fmt = TH_PF_420;  // as every player wants it
    info.quality = kQuality;
    encoder = th_encode_alloc(&info);
    for (std::size_t p = 0; p < 3; ++p) {
      const unsigned part = p == 0 ? 1 : 2;
      planes[p].width = static_cast<int>(info.frame_width / part);
      planes[p].height = static_cast<int>(info.frame_height / part);
      planes[p].bytes.resize(std::size_t(planes[p].width) * std::size_t(planes[p].height));
    }
    th_info_clear(&info);
    file = std::fopen(path.c_str(), "wbe");
    ogg_stream_init(&stream, kStream);
    if (file == nullptr || encoder == nullptr) {
      sound = false;
      return;
    }
    th_comment comment;
    th_comment_init(&comment);
    ogg_packet packet{};
    // the first header has a page of its own
    for (bool first = true; th_encode_flushheader(encoder, &comment, &packet) > 0; first = false) {
      ogg_stream_packetin(&stream, &packet);
      if (first) flush();
    }
    th_comment_clear(&comment);
    flush();
  }
  ~Writer() {
    ogg_stream_clear(&stream);
    if (encoder != nullptr) th_encode_free(encoder);
    if (file != nullptr) std::fclose(file);
  }

  void flush() {
    ogg_page page{};
    while (ogg_stream_flush(&stream, &page) != 0)
      for (const auto& [bytes, size] :
           {std::pair{page.header, page.header_len}, std::pair{page.body, page.body_len}})
        sound = std::fwrite(bytes, 1, std::size_t(size), file) == std::size_t(size) && sound;
  }

  /// Brings the frame that was given into the file. A page tells of its last packet alone whether
  /// it is a key frame, so each has a page.
  void put(bool last) {
    ogg_packet packet{};
    while (begun && th_encode_packetout(encoder, last, &packet) > 0) {
      ogg_stream_packetin(&stream, &packet);
      flush();
    }
    begun = false;
  }

  void give(const FilmFrame& frame) {
    const auto sumOf = [&](int x, int y, int side) {
      std::array<int, 3> sum{};
      for (int dy = 0; dy < side; ++dy)
        for (int dx = 0; dx < side; ++dx) {
          const int column = std::min(x + dx, frame.width - 1);
          const int row = frame.height - 1 - std::min(y + dy, frame.height - 1);  // from the lowest
          const std::size_t at =
              3 * (std::size_t(row) * std::size_t(frame.width) + std::size_t(column));
          for (std::size_t c = 0; c < 3; ++c) sum[c] += frame.rgb[at + c];
        }
      return sum;
    };
    th_ycbcr_buffer buffer{};
    for (std::size_t p = 0; p < 3; ++p) {
      Plane& plane = planes[p];
      std::uint8_t* out = plane.bytes.data();
      for (int y = 0; y < plane.height; ++y)
        for (int x = 0; x < plane.width; ++x)
          *out++ = p == 0   ? weighted(sumOf(x, y, 1), 1, 65.481, 128.553, 24.966, 16.0)
                   : p == 1 ? weighted(sumOf(2 * x, 2 * y, 2), 4, -37.797, -74.203, 112.0, 128.0)
                            : weighted(sumOf(2 * x, 2 * y, 2), 4, 112.0, -93.786, -18.214, 128.0);
      buffer[p] = {plane.width, plane.height, plane.width, plane.bytes.data()};
    }
    sound = th_encode_ycbcr_in(encoder, buffer) == 0 && sound;
    begun = sound;
  }
};

TheoraFile::TheoraFile(const std::filesystem::path& file, const FilmFormat& format)
    : writer_{std::make_unique<Writer>(file, format)} {}
TheoraFile::~TheoraFile() = default;
TheoraFile::TheoraFile(TheoraFile&& other) noexcept = default;

Expected<void> TheoraFile::write(const FilmFrame& frame) {
  if (!writer_->sound) return failure();
  writer_->put(false);
  if (writer_->sound) writer_->give(frame);
  if (!writer_->sound) return failure();
  return {};
}

Expected<void> TheoraFile::finish() {
  if (!writer_->sound) return failure();
  writer_->put(true);
  const bool closed = std::fclose(std::exchange(writer_->file, nullptr)) == 0;
  if (!writer_->sound || !closed) return failure();
  return {};
}

}  // namespace app
