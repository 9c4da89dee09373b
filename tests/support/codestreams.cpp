// SPDX-License-Identifier: BSD-3-Clause
#include "tests/support/codestreams.h"

#include <charls/charls.h>
#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmjpeg/djcparam.h>
#include <dcmtk/dcmjpeg/djeijg16.h>
#include <openjpeg.h>

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <vector>

namespace support {
namespace {

void require(bool done, const char* what) {
  if (!done) throw std::runtime_error(what);
}

/// Values of up to 8 bits take one byte.
std::vector<std::uint8_t> packed(const Raster& raster) {
  std::vector<std::uint8_t> bytes;
  for (const std::uint16_t v : raster.values) {
    bytes.push_back(static_cast<std::uint8_t>(v & 0xff));
    if (raster.bits > 8) bytes.push_back(static_cast<std::uint8_t>(v >> 8));
  }
  return bytes;
}

OPJ_SIZE_T append(void* from, OPJ_SIZE_T size, void* to) {
  static_cast<std::string*>(to)->append(static_cast<const char*>(from), size);
  return size;
}

}  // namespace

std::string asJpegLs(const Raster& raster, int near) {
  const std::vector<std::uint8_t> values = packed(raster);
  charls::jpegls_encoder encoder;
  encoder.frame_info({static_cast<std::uint32_t>(raster.columns),
                      static_cast<std::uint32_t>(raster.rows), raster.bits, raster.components});
  if (raster.components > 1) encoder.interleave_mode(charls::interleave_mode::sample);
  encoder.near_lossless(near);
  std::vector<std::uint8_t> coded(encoder.estimated_destination_size());
  encoder.destination(coded.data(), coded.size());
  const std::size_t size = encoder.encode(values.data(), values.size());
  return {coded.begin(), coded.begin() + static_cast<std::ptrdiff_t>(size)};
}

std::string asJpeg2000(const Raster& raster, const Jpeg2000Ways& ways) {
  std::vector<opj_image_cmptparm_t> components(static_cast<std::size_t>(raster.components));
  for (opj_image_cmptparm_t& c : components) {
    c = {};
    c.dx = c.dy = 1;
    c.w = static_cast<OPJ_UINT32>(raster.columns);
    c.h = static_cast<OPJ_UINT32>(raster.rows);
    c.prec = static_cast<OPJ_UINT32>(raster.bits);
    c.sgnd = ways.is_signed ? 1 : 0;
  }
  opj_image_t* image =
      opj_image_create(static_cast<OPJ_UINT32>(raster.components), components.data(),
                       raster.components == 1 ? OPJ_CLRSPC_GRAY : OPJ_CLRSPC_SRGB);
  require(image != nullptr, "no image");
  image->x1 = static_cast<OPJ_UINT32>(raster.columns);
  image->y1 = static_cast<OPJ_UINT32>(raster.rows);
  const auto step = static_cast<std::size_t>(raster.components);
  for (std::size_t c = 0; c < step; ++c)
    for (std::size_t n = 0; n < raster.values.size() / step; ++n) {
      const std::uint16_t v = raster.values[n * step + c];
      image->comps[c].data[n] = ways.is_signed ? static_cast<std::int16_t>(v) : v;
    }
  opj_cparameters_t parameters;
  opj_set_default_encoder_parameters(&parameters);
  parameters.tcp_numlayers = 1;
  parameters.cp_disto_alloc = 1;
  parameters.numresolution = std::min(raster.columns, raster.rows) < 8 ? 1 : 3;
  parameters.irreversible = ways.with_loss ? 1 : 0;
  parameters.tile_size_on = ways.tile > 0 ? OPJ_TRUE : OPJ_FALSE;
  parameters.cp_tdx = parameters.cp_tdy = ways.tile;
  opj_codec_t* codec = opj_create_compress(OPJ_CODEC_J2K);
  opj_stream_t* stream = opj_stream_create(1 << 20, OPJ_FALSE);
  std::string coded;
  opj_stream_set_user_data(stream, &coded, nullptr);
  opj_stream_set_write_function(stream, append);
  const bool done = opj_setup_encoder(codec, &parameters, image) &&
                    opj_start_compress(codec, image, stream) && opj_encode(codec, stream) &&
                    opj_end_compress(codec, stream);
  opj_stream_destroy(stream);
  opj_destroy_codec(codec);
  opj_image_destroy(image);
  require(done, "not encoded");
  return coded;
}

std::string asLosslessJpeg(const Raster& raster) {
  const DJCodecParameter parameters(ECC_lossyYCbCr, EDC_never, EUC_never, EPC_default);
  DJCompressIJG16Bit encoder(parameters, EJM_lossless, 1, 0);
  std::vector<Uint16> values(raster.values.begin(), raster.values.end());
  Uint8* coded = nullptr;
  Uint32 size = 0;
  const OFCondition done =
      encoder.encode(static_cast<Uint16>(raster.columns), static_cast<Uint16>(raster.rows),
                     EPI_Monochrome2, 1, values.data(), coded, size);
  const std::unique_ptr<Uint8[]> owned{coded};
  require(done.good(), "not encoded");
  return {reinterpret_cast<const char*>(coded), size};
}

std::string asRle(const Raster& raster) {
  const int segments = raster.bits > 8 ? 2 : 1;
  std::string table, coded;
  const auto number = [](std::size_t v) {
    return std::string{char(v), char(v >> 8), char(v >> 16), char(v >> 24)};
  };
  table = number(static_cast<std::size_t>(segments));
  const auto columns = static_cast<std::size_t>(raster.columns);
  for (int s = 0; s < segments; ++s) {
    table += number(64 + coded.size());
    const int shift = 8 * (segments - 1 - s);
    for (std::size_t row = 0; row < raster.values.size(); row += columns)
      for (std::size_t at = 0; at < columns;) {
        const auto byteAt = [&](std::size_t n) {
          return static_cast<char>(raster.values[row + n] >> shift & 0xff);
        };
        std::size_t same = 1;
        while (same < 128 && at + same < columns && byteAt(at + same) == byteAt(at)) ++same;
        coded += static_cast<char>(same > 1 ? 257 - same : 0);
        coded += byteAt(at);
        at += same;
      }
    if (coded.size() % 2 == 1) coded += '\0';
  }
  table.resize(64, '\0');
  return table + coded;
}

}  // namespace support
