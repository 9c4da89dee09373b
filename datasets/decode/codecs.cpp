// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/decode/codecs.h"

#include <charls/charls.h>
#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmjpeg/djcparam.h>
#include <dcmtk/dcmjpeg/djdijg12.h>
#include <dcmtk/dcmjpeg/djdijg16.h>
#include <dcmtk/dcmjpeg/djdijg8.h>
#include <openjpeg.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <memory>
#include <optional>
#include <set>
#include <vector>

namespace datasets::decode {
namespace {

std::size_t pixelCount(const Request& request) {
  return std::size_t{request.columns} * request.rows;
}

/// What differs first between the frame's own header and the request.
std::optional<Verdict> difference(const Request& request, const FrameHeader& frame) {
  if (frame.components != 1) return Verdict::Components;
  if (frame.columns != request.columns || frame.rows != request.rows) return Verdict::Size;
  // the extended process knows depths of 8 and 12 bits alone
  const bool is_rounded_up = request.coding == Coding::JpegExtended && frame.precision == 12 &&
                             request.bits_stored > 8 && request.bits_stored < 12;
  if (frame.precision != request.bits_stored && frame.precision != 8 * request.bytes_per_pixel &&
      !is_rounded_up)
    return Verdict::Depth;
  return {};
}

Answer answerOf(bool is_decoded, const FrameHeader& frame) {
  return {is_decoded ? Verdict::Decoded : Verdict::Damaged, frame};
}

/// A big-endian number; what is missing of it counts as 0.
std::uint32_t numberAt(std::span<const std::byte> bytes, std::size_t at, std::size_t count) {
  std::uint32_t value = 0;
  for (; count > 0; --count, ++at)
    value = value << 8 | (at < bytes.size() ? std::to_integer<std::uint32_t>(bytes[at]) : 0U);
  return value;
}

/// Whether only what fills up a fragment stands from `at` on.
bool isFillingFrom(std::span<const std::byte> bytes, std::size_t at) {
  return std::ranges::all_of(bytes.subspan(at),
                             [](std::byte b) { return b == std::byte{0} || b == std::byte{0xff}; });
}

/// The segments before the coded data of JPEG and JPEG-LS.
struct Segments {
  FrameHeader frame = {};
  std::uint32_t process = 0;  ///< the marker of the frame header
  std::size_t scan = 0;       ///< where the coded data begin
};

/// dcmtk's decoder shows no header, and neither it nor CharLS tells where it ended.
std::optional<Segments> segmentsOf(std::span<const std::byte> bytes) {
  constexpr std::uint32_t kStart = 0xffd8, kScan = 0xffda, kLsFrame = 0xfff7;
  if (numberAt(bytes, 0, 2) != kStart) return {};
  Segments segments;
  for (std::size_t at = 2; segments.scan == 0;) {
    while (numberAt(bytes, at, 2) == 0xffff) ++at;  // fill bytes may stand before a marker
    const std::uint32_t marker = numberAt(bytes, at, 2), length = numberAt(bytes, at + 2, 2);
    if (marker < 0xff00 || length < 2) return {};
    const bool is_table = marker == 0xffc4 || marker == 0xffc8 || marker == 0xffcc;
    if (marker == kLsFrame || (marker >= 0xffc0 && marker <= 0xffcf && !is_table)) {
      segments.process = marker;
      segments.frame = {.columns = numberAt(bytes, at + 7, 2),
                        .rows = numberAt(bytes, at + 5, 2),
                        .components = numberAt(bytes, at + 9, 1),
                        .precision = numberAt(bytes, at + 4, 1)};
    }
    at += 2 + length;
    if (marker == kScan) segments.scan = at;
  }
  if (segments.process == 0 || segments.scan > bytes.size()) return {};
  return segments;
}

/// Whether the one scan, in which no end marker can occur, has one with nothing behind it.
bool endsAfterScan(std::span<const std::byte> bytes, const Segments& segments) {
  constexpr std::array kEnd{std::byte{0xff}, std::byte{0xd9}};
  const auto rest = bytes.subspan(segments.scan);
  const auto end = std::search(rest.begin(), rest.end(), kEnd.begin(), kEnd.end());
  return end != rest.end() &&
         isFillingFrom(rest, static_cast<std::size_t>(end - rest.begin()) + kEnd.size());
}

/// Samples of the codec's own width as pixels of theirs.
template <class From, class To>
void widen(const void* from, void* to, std::size_t count) {
  std::copy_n(static_cast<const From*>(from), count, static_cast<To*>(to));
}

/// Decodes by `decode(samples)`, where the codec's samples take so many bytes.
template <class Decode>
bool throughSamples(const Request& request, std::size_t bytes_per_sample,
                    std::span<std::byte> pixels, Decode&& decode) {
  if (bytes_per_sample == request.bytes_per_pixel) return decode(pixels);
  if (bytes_per_sample > request.bytes_per_pixel) return false;
  std::vector<std::byte> samples(pixelCount(request) * bytes_per_sample);
  if (!decode(std::span{samples})) return false;
  if (bytes_per_sample == 2)
    widen<std::uint16_t, std::uint32_t>(samples.data(), pixels.data(), pixelCount(request));
  else if (request.bytes_per_pixel == 2)
    widen<std::uint8_t, std::uint16_t>(samples.data(), pixels.data(), pixelCount(request));
  else
    widen<std::uint8_t, std::uint32_t>(samples.data(), pixels.data(), pixelCount(request));
  return true;
}

/// dcmtk's JPEG decoder, which goes on after what it only warns of: damaged entropy-coded data.
template <class Decompressor>
class Strict : public Decompressor {
 public:
  using Decompressor::Decompressor;
  void emitMessage(int level) const override { warned_ = warned_ || level < 0; }
  bool warned() const { return warned_; }

 private:
  mutable bool warned_ = false;
};

template <class Decompressor>
bool decodeJpegBy(const Request& request, std::span<const std::byte> codestream,
                  std::span<std::byte> pixels) {
  const DJCodecParameter parameters(ECC_lossyYCbCr, EDC_never, EUC_never, EPC_default);
  Strict<Decompressor> decompressor(parameters, OFFalse);
  return throughSamples(
      request, decompressor.bytesPerSample(), pixels, [&](std::span<std::byte> samples) {
        if (decompressor.init().bad()) return false;
        // it takes what it reads as not const, and does not write there
        auto* coded = reinterpret_cast<Uint8*>(const_cast<std::byte*>(codestream.data()));
        const OFCondition done = decompressor.decode(
            coded, static_cast<Uint32>(codestream.size()), reinterpret_cast<Uint8*>(samples.data()),
            static_cast<Uint32>(samples.size()), request.is_signed != 0);
        return done == EC_Normal && !decompressor.warned();
      });
}

bool allowsProcess(Coding coding, std::uint32_t process) {
  constexpr std::uint32_t kBaseline = 0xffc0, kExtended = 0xffc1, kLossless = 0xffc3;
  if (coding == Coding::JpegLossless) return process == kLossless;
  return process == kBaseline || (process == kExtended && coding == Coding::JpegExtended);
}

Answer decodeJpeg(const Request& request, std::span<const std::byte> codestream,
                  std::span<std::byte> pixels) {
  constexpr std::size_t kMost = 0xffffffffU;  // its sizes have 32 bits
  const auto segments = segmentsOf(codestream);
  if (!segments || codestream.size() > kMost || pixels.size() > kMost) return {Verdict::Damaged};
  const FrameHeader& frame = segments->frame;
  if (!allowsProcess(request.coding, segments->process)) return {Verdict::Process, frame};
  if (const auto differs = difference(request, frame)) return {*differs, frame};
  if (!endsAfterScan(codestream, *segments)) return {Verdict::Damaged, frame};
  if (frame.precision <= 8)
    return answerOf(decodeJpegBy<DJDecompressIJG8Bit>(request, codestream, pixels), frame);
  if (frame.precision <= 12)
    return answerOf(decodeJpegBy<DJDecompressIJG12Bit>(request, codestream, pixels), frame);
  return answerOf(decodeJpegBy<DJDecompressIJG16Bit>(request, codestream, pixels), frame);
}

Answer decodeJpegLs(const Request& request, std::span<const std::byte> codestream,
                    std::span<std::byte> pixels) {
  const auto segments = segmentsOf(codestream);
  if (!segments) return {Verdict::Damaged};
  if (segments->process != 0xfff7) return {Verdict::Process, segments->frame};
  charls::jpegls_decoder decoder;
  decoder.source(codestream.data(), codestream.size());
  decoder.read_header();
  const charls::frame_info& read = decoder.frame_info();
  const FrameHeader frame{read.width, read.height, static_cast<std::uint32_t>(read.component_count),
                          static_cast<std::uint32_t>(read.bits_per_sample)};
  if (const auto differs = difference(request, frame)) return {*differs, frame};
  if (request.coding == Coding::JpegLsLossless && decoder.near_lossless() != 0)
    return {Verdict::Loss, frame};
  const bool is_decoded =
      endsAfterScan(codestream, *segments) &&
      throughSamples(request, frame.precision <= 8 ? 1 : 2, pixels,
                     [&](std::span<std::byte> samples) {
                       if (decoder.destination_size() != samples.size()) return false;
                       decoder.decode(samples.data(), samples.size());  // throws on any fault
                       return true;
                     });
  return answerOf(is_decoded, frame);
}

/// The codestream as OpenJPEG reads it.
struct CodedBytes {
  std::span<const std::byte> bytes;
  std::size_t at = 0;

  static OPJ_SIZE_T read(void* to, OPJ_SIZE_T size, void* self) {
    auto* from = static_cast<CodedBytes*>(self);
    const std::size_t count = std::min(size, from->bytes.size() - from->at);
    if (count == 0) return static_cast<OPJ_SIZE_T>(-1);
    std::memcpy(to, from->bytes.data() + from->at, count);
    from->at += count;
    return count;
  }
  static OPJ_OFF_T skip(OPJ_OFF_T count, void* self) {
    auto* from = static_cast<CodedBytes*>(self);
    const auto left = static_cast<OPJ_OFF_T>(from->bytes.size() - from->at);
    if (count < 0 || count > left) return -1;
    from->at += static_cast<std::size_t>(count);
    return count;
  }
  static OPJ_BOOL seek(OPJ_OFF_T at, void* self) {
    auto* from = static_cast<CodedBytes*>(self);
    if (at < 0 || static_cast<std::size_t>(at) > from->bytes.size()) return OPJ_FALSE;
    from->at = static_cast<std::size_t>(at);
    return OPJ_TRUE;
  }
};

/// OpenJPEG goes on after some faults, of which it only tells.
void note(const char*, void* told) { *static_cast<bool*>(told) = true; }

template <auto Destroy>
struct Ends {
  template <class T>
  void operator()(T* what) const {
    Destroy(what);
  }
};

template <class T>
void copyValues(const opj_image_comp_t& component, std::span<std::byte> pixels) {
  auto* to = reinterpret_cast<T*>(pixels.data());
  const std::size_t count = std::size_t{component.w} * component.h;
  for (std::size_t n = 0; n < count; ++n) to[n] = static_cast<T>(component.data[n]);
}

template <auto Destroy>
struct EndsAt {
  template <class T>
  void operator()(T* what) const {
    Destroy(&what);
  }
};

/// OpenJPEG leaves a tile that the codestream lacks as it is, and does not tell. From the first
/// tile-part on.
bool hasTiles(std::span<const std::byte> codestream, std::size_t at, std::size_t count) {
  constexpr std::uint32_t kTilePart = 0xff90;
  std::set<std::uint32_t> tiles;
  while (numberAt(codestream, at, 2) == kTilePart) {
    tiles.insert(numberAt(codestream, at + 4, 2));
    const std::uint32_t length = numberAt(codestream, at + 6, 4);
    if (length == 0) break;  // it reaches to the end
    at += length;
  }
  return tiles.size() == count;
}

Answer decodeJpeg2000(const Request& request, std::span<const std::byte> codestream,
                      std::span<std::byte> pixels) {
  bool told = false;
  const std::unique_ptr<opj_codec_t, Ends<opj_destroy_codec>> codec{
      opj_create_decompress(OPJ_CODEC_J2K)};
  const std::unique_ptr<opj_stream_t, Ends<opj_stream_destroy>> stream{
      opj_stream_create(1, OPJ_TRUE)};  // no buffer: it reads as far as the codestream goes
  if (!codec || !stream) return {Verdict::Damaged};
  opj_set_error_handler(codec.get(), note, &told);
  opj_set_warning_handler(codec.get(), note, &told);
  opj_dparameters_t parameters{};
  opj_set_default_decoder_parameters(&parameters);
  CodedBytes coded{codestream};
  opj_stream_set_user_data(stream.get(), &coded, nullptr);
  opj_stream_set_user_data_length(stream.get(), codestream.size());
  opj_stream_set_read_function(stream.get(), CodedBytes::read);
  opj_stream_set_skip_function(stream.get(), CodedBytes::skip);
  opj_stream_set_seek_function(stream.get(), CodedBytes::seek);
  opj_image_t* read = nullptr;
  const bool is_read = opj_setup_decoder(codec.get(), &parameters) == OPJ_TRUE &&
                       opj_decoder_set_strict_mode(codec.get(), OPJ_TRUE) == OPJ_TRUE &&
                       opj_read_header(stream.get(), codec.get(), &read) == OPJ_TRUE;
  const std::unique_ptr<opj_image_t, Ends<opj_image_destroy>> image{read};
  const std::unique_ptr<opj_codestream_info_v2_t, EndsAt<opj_destroy_cstr_info>> info{
      is_read ? opj_get_cstr_info(codec.get()) : nullptr};
  if (!info || image->numcomps == 0) return {Verdict::Damaged};
  const opj_image_comp_t& component = image->comps[0];
  const FrameHeader frame{component.w, component.h, image->numcomps, component.prec};
  if (const auto differs = difference(request, frame)) return {*differs, frame};
  if (component.sgnd != request.is_signed) return {Verdict::Sign, frame};
  const opj_tccp_info_t& style = info->m_default_tile_info.tccp_info[0];
  constexpr std::uint32_t kHighThroughput = 0x40, kWithLoss = 0;
  if ((style.cblksty & kHighThroughput) != 0) return {Verdict::Process, frame};
  if (request.coding == Coding::Jpeg2000Lossless && style.qmfbid == kWithLoss)
    return {Verdict::Loss, frame};
  const std::size_t tile_part = coded.at - 2;  // its marker ends the header
  const bool sound = opj_decode(codec.get(), stream.get(), image.get()) == OPJ_TRUE &&
                     opj_end_decompress(codec.get(), stream.get()) == OPJ_TRUE && !told &&
                     component.data != nullptr && component.w == frame.columns &&
                     component.h == frame.rows && isFillingFrom(codestream, coded.at) &&
                     hasTiles(codestream, tile_part, std::size_t{info->tw} * info->th);
  if (!sound) return {Verdict::Damaged, frame};
  if (request.bytes_per_pixel == 1)
    copyValues<std::uint8_t>(component, pixels);
  else if (request.bytes_per_pixel == 2)
    copyValues<std::uint16_t>(component, pixels);
  else
    copyValues<std::uint32_t>(component, pixels);
  return {Verdict::Decoded, frame};
}

/// One segment of RLE (PS3.5 G.3), a byte of each pixel, into every `step`th byte from `to` on.
/// False if it has more or fewer than `count`.
bool unpack(std::span<const std::byte> segment, std::size_t count, std::size_t step,
            std::byte* to) {
  std::size_t at = 0, made = 0;
  while (made < count) {
    if (at >= segment.size()) return false;
    const int head = static_cast<std::int8_t>(segment[at++]);
    if (head == -128) continue;
    const auto length = static_cast<std::size_t>(head < 0 ? 1 - head : 1 + head);
    if (length > count - made || (head < 0 ? 1 : length) > segment.size() - at) return false;
    for (std::size_t n = 0; n < length; ++n)
      to[(made + n) * step] = segment[head < 0 ? at : at + n];
    at += head < 0 ? 1 : length;
    made += length;
  }
  // what fills up to an even length
  return std::ranges::all_of(segment.subspan(at), [](std::byte b) {
    return b == std::byte{0} || b == std::byte{0x80} || b == std::byte{0xff};
  });
}

Answer decodeRle(const Request& request, std::span<const std::byte> codestream,
                 std::span<std::byte> pixels) {
  const std::size_t width = request.bytes_per_pixel;
  // the number of segments, and where they begin; little endian, as x86-64 is
  std::array<std::uint32_t, 16> table{};
  if (codestream.size() < sizeof table) return {Verdict::Damaged};
  std::memcpy(table.data(), codestream.data(), sizeof table);
  const FrameHeader frame{.components = table[0]};
  if (table[0] != width) return {Verdict::Segments, frame};
  const auto unused = std::span{table}.subspan(1 + width);
  if (table[1] != sizeof table || std::ranges::any_of(unused, [](auto at) { return at != 0; }))
    return {Verdict::Damaged, frame};
  for (std::size_t n = 0; n < width; ++n) {
    const std::size_t begin = table[n + 1];
    const std::size_t end = n + 1 < width ? table[n + 2] : codestream.size();
    // the most significant byte comes first
    if (begin > end || end > codestream.size() ||
        !unpack(codestream.subspan(begin, end - begin), pixelCount(request), width,
                pixels.data() + (width - 1 - n)))
      return {Verdict::Damaged, frame};
  }
  return {Verdict::Decoded, frame};
}

}  // namespace

Answer decodeFrame(const Request& request, std::span<const std::byte> codestream,
                   std::span<std::byte> pixels) {
  if (pixels.size() != pixelCount(request) * request.bytes_per_pixel || pixels.empty())
    return {Verdict::Damaged};
  switch (request.coding) {
    case Coding::JpegBaseline:
    case Coding::JpegExtended:
    case Coding::JpegLossless:
      return decodeJpeg(request, codestream, pixels);
    case Coding::JpegLsLossless:
    case Coding::JpegLs:
      return decodeJpegLs(request, codestream, pixels);
    case Coding::Jpeg2000Lossless:
    case Coding::Jpeg2000:
      return decodeJpeg2000(request, codestream, pixels);
    case Coding::Rle:
      break;
  }
  return decodeRle(request, codestream, pixels);
}

}  // namespace datasets::decode
