// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <string>

namespace datasets::testing {

/// A NIfTI file in one piece, written from the format's definition.
struct Nifti {
  int version = 1;
  bool big = false;  ///< byte order
  std::array<std::int64_t, 8> dim{3, 5, 4, 3, 1, 1, 1, 1};
  std::array<double, 8> pixdim{1, 1, 1, 1, 0, 0, 0, 0};
  int datatype = 4, bits = 16, units = 2;  ///< int16, mm
  double first_voxel = 0.0;                ///< 0: right after the header
  double slope = 0.0, intercept = 0.0;
  int quaternion_code = 0, matrix_code = 0;
  std::array<double, 3> quaternion{}, offset{};
  std::array<double, 12> matrix{};
  std::string voxels;  ///< little endian int16
};

inline std::string bytesOf(const Nifti& n) {
  std::string out(n.version == 1 ? 352 : 544, '\0');
  const auto put = [&](std::size_t at, auto value) {
    char raw[sizeof value];
    std::memcpy(raw, &value, sizeof value);
    if (n.big) std::reverse(raw, raw + sizeof value);
    std::memcpy(out.data() + at, raw, sizeof value);
  };
  const auto putAll = [&](std::size_t at, const auto& values, auto as) {
    for (const auto value : values) {
      put(at, static_cast<decltype(as)>(value));
      at += sizeof as;
    }
  };
  const double first = n.first_voxel == 0.0 ? double(out.size()) : n.first_voxel;
  if (n.version == 1) {
    put(0, std::int32_t{348});
    putAll(40, n.dim, std::int16_t{});
    put(70, std::int16_t(n.datatype));
    put(72, std::int16_t(n.bits));
    putAll(76, n.pixdim, float{});
    put(108, float(first));
    put(112, float(n.slope));
    put(116, float(n.intercept));
    put(123, std::uint8_t(n.units));
    put(252, std::int16_t(n.quaternion_code));
    put(254, std::int16_t(n.matrix_code));
    putAll(256, n.quaternion, float{});
    putAll(268, n.offset, float{});
    putAll(280, n.matrix, float{});
    std::memcpy(out.data() + 344, "n+1", 4);
  } else {
    put(0, std::int32_t{540});
    std::memcpy(out.data() + 4, "n+2\0\r\n\032\n", 8);
    put(12, std::int16_t(n.datatype));
    put(14, std::int16_t(n.bits));
    putAll(16, n.dim, std::int64_t{});
    putAll(104, n.pixdim, double{});
    put(168, std::int64_t(first));
    put(176, n.slope);
    put(184, n.intercept);
    put(344, std::int32_t(n.quaternion_code));
    put(348, std::int32_t(n.matrix_code));
    putAll(352, n.quaternion, double{});
    putAll(376, n.offset, double{});
    putAll(400, n.matrix, double{});
    put(500, std::int32_t(n.units));
  }
  std::string voxels = n.voxels;
  if (n.big)
    for (std::size_t i = 0; i + 1 < voxels.size(); i += 2) std::swap(voxels[i], voxels[i + 1]);
  return out + voxels;
}

}  // namespace datasets::testing
