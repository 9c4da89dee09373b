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
#include <cstdint>
#include <cstring>
#include <memory>
#include <vector>

namespace datasets::decode {
namespace {

std::size_t pixelCount(const Request& request) {
  return std::size_t{request.columns} * request.rows;
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

bool decodeJpeg(const Request& request, std::span<const std::byte> codestream,
                std::span<std::byte> pixels) {
  constexpr std::size_t kMost = 0xffffffffU;  // its sizes have 32 bits
  if (codestream.size() > kMost || pixels.size() > kMost) return false;
  if (request.precision <= 8) return decodeJpegBy<DJDecompressIJG8Bit>(request, codestream, pixels);
  if (request.precision <= 12)
    return decodeJpegBy<DJDecompressIJG12Bit>(request, codestream, pixels);
  return decodeJpegBy<DJDecompressIJG16Bit>(request, codestream, pixels);
}

bool decodeJpegLs(const Request& request, std::span<const std::byte> codestream,
                  std::span<std::byte> pixels) {
  charls::jpegls_decoder decoder;
  decoder.source(codestream.data(), codestream.size());
  decoder.read_header();
  const charls::frame_info& frame = decoder.frame_info();
  if (frame.width != request.columns || frame.height != request.rows ||
      frame.component_count != 1 ||
      frame.bits_per_sample != static_cast<std::int32_t>(request.precision))
    return false;
  return throughSamples(request, request.precision <= 8 ? 1 : 2, pixels,
                        [&](std::span<std::byte> samples) {
                          if (decoder.destination_size() != samples.size()) return false;
                          decoder.decode(samples.data(), samples.size());  // throws on any fault
                          return true;
                        });
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

bool decodeJpeg2000(const Request& request, std::span<const std::byte> codestream,
                    std::span<std::byte> pixels) {
  bool told = false;
  const std::unique_ptr<opj_codec_t, Ends<opj_destroy_codec>> codec{
      opj_create_decompress(OPJ_CODEC_J2K)};
  const std::unique_ptr<opj_stream_t, Ends<opj_stream_destroy>> stream{
      opj_stream_create(std::max<std::size_t>(codestream.size(), 1), OPJ_TRUE)};
  if (!codec || !stream) return false;
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
  bool sound = opj_setup_decoder(codec.get(), &parameters) == OPJ_TRUE &&
               opj_decoder_set_strict_mode(codec.get(), OPJ_TRUE) == OPJ_TRUE &&
               opj_read_header(stream.get(), codec.get(), &read) == OPJ_TRUE;
  const std::unique_ptr<opj_image_t, Ends<opj_image_destroy>> image{read};
  sound = sound && opj_decode(codec.get(), stream.get(), image.get()) == OPJ_TRUE &&
          opj_end_decompress(codec.get(), stream.get()) == OPJ_TRUE;
  if (!sound || told || image->numcomps != 1) return false;
  const opj_image_comp_t& component = image->comps[0];
  if (component.data == nullptr || component.w != request.columns || component.h != request.rows ||
      component.prec != request.precision || component.sgnd != request.is_signed)
    return false;
  switch (request.bytes_per_pixel) {
    case 1:
      copyValues<std::uint8_t>(component, pixels);
      return true;
    case 2:
      copyValues<std::uint16_t>(component, pixels);
      return true;
    default:
      copyValues<std::uint32_t>(component, pixels);
      return true;
  }
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

bool decodeRle(const Request& request, std::span<const std::byte> codestream,
               std::span<std::byte> pixels) {
  const std::size_t width = request.bytes_per_pixel;
  std::vector<std::uint32_t> offsets(width + 1);
  if (codestream.size() < 64) return false;
  std::memcpy(offsets.data(), codestream.data(), 4 * (width + 1));  // little endian, as x86-64 is
  if (offsets[0] != width) return false;
  for (std::size_t n = 0; n < width; ++n) {
    const std::size_t begin = offsets[n + 1];
    const std::size_t end = n + 1 < width ? offsets[n + 2] : codestream.size();
    if (begin > end || end > codestream.size()) return false;
    // the most significant byte comes first
    if (!unpack(codestream.subspan(begin, end - begin), pixelCount(request), width,
                pixels.data() + (width - 1 - n)))
      return false;
  }
  return true;
}

}  // namespace

bool decodeFrame(const Request& request, std::span<const std::byte> codestream,
                 std::span<std::byte> pixels) {
  if (pixels.size() != pixelCount(request) * request.bytes_per_pixel || pixels.empty())
    return false;
  switch (request.coding) {
    case Coding::Jpeg:
      return decodeJpeg(request, codestream, pixels);
    case Coding::JpegLs:
      return decodeJpegLs(request, codestream, pixels);
    case Coding::Jpeg2000:
      return decodeJpeg2000(request, codestream, pixels);
    case Coding::Rle:
      return decodeRle(request, codestream, pixels);
  }
  return false;
}

}  // namespace datasets::decode
