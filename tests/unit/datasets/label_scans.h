// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdint>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "datasets/labels/label_file.h"
#include "datasets/labels/label_map.h"
#include "haptics/core/volume.h"
#include "tests/support/sentence.h"
#include "tests/support/turned_scan.h"
#include "tests/unit/datasets/scans.h"

/// Scans that structures are put onto, and where the octants of turned_scan.h's box lie in them.
namespace datasets::testing {

/// Which of the eight octants about a place of the patient, 1 to 8; 0 outside a ball.
inline std::int16_t octantAt(const haptics::Vec3& p_mm) {
  const haptics::Vec3 by = p_mm - turned::placeOf_mm({4.3, 6.4, 8.7});
  if (by.norm() > 16.0) return 0;
  return std::int16_t(1 + (by.x() > 0.0) + 2 * (by.y() > 0.0) + 4 * (by.z() > 0.0));
}

inline haptics::Volume scanOn(const haptics::Grid& grid, bool orientation_known = true) {
  auto voxels = haptics::allocateVoxels(grid.voxelCount(), haptics::ScalarType::Int16).value();
  static_cast<std::int16_t*>(voxels.get())[0] = 1;
  return haptics::makeVolume(grid, haptics::ScalarType::Int16, std::move(voxels),
                             {.orientation_known = orientation_known})
      .value();
}

/// Oblique, uneven, and larger than the box of turned_scan.h on some sides only.
inline haptics::Grid obliqueGrid() {
  haptics::Grid grid;
  grid.dims = {31, 29, 27};
  grid.spacing = 1e-3 * haptics::Vec3(0.83, 1.21, 1.37);
  grid.direction =
      Eigen::AngleAxisd{0.6, haptics::Vec3{0.3, -0.8, 0.5}.normalized()}.toRotationMatrix();
  grid.origin = 1e-3 * turned::placeOf_mm({-0.7, 1.2, 2.3});
  return grid;
}

/// The number of each voxel's structure counted from 1, of a map without overlaps; 0: none.
inline std::vector<int> numbersIn(const LabelMap& map) {
  std::vector<int> numbers;
  for (std::int64_t n = 0; n < map.grid().voxelCount(); ++n) {
    const auto& set = map.structuresOf(map.codes()[n]);
    EXPECT_LE(set.size(), 1U);
    numbers.push_back(set.empty() ? 0 : set.front() + 1);
  }
  return numbers;
}

/// The octant of each voxel of a scan, by the nearest place of the box; how many each has.
inline std::vector<int> octantsOn(const haptics::Grid& grid, std::map<int, std::int64_t>& counted) {
  using haptics::Vec3;
  std::vector<int> octants;
  for (std::int64_t k = 0; k < grid.dims[2]; ++k)
    for (std::int64_t j = 0; j < grid.dims[1]; ++j)
      for (std::int64_t i = 0; i < grid.dims[0]; ++i) {
        const Vec3 p_mm = 1e3 * grid.worldOf({double(i), double(j), double(k)});
        const Vec3 nearest = ((p_mm - turned::kFirst_mm) / turned::kStep_mm).array().round();
        const bool within =
            (nearest.array() >= 0.0).all() &&
            (nearest.array() < Vec3(turned::kSize[0], turned::kSize[1], turned::kSize[2]).array())
                .all();
        octants.push_back(within ? octantAt(turned::placeOf_mm(nearest)) : 0);
        ++counted[octants.back()];
      }
  return octants;
}

/// Of 4 x 3 x 2 voxels of 1 mm at the origin.
inline haptics::Grid smallGrid() {
  haptics::Grid grid;
  grid.dims = {4, 3, 2};
  grid.spacing = haptics::Vec3::Constant(1e-3);
  return grid;
}

inline std::vector<std::uint8_t> setAt(const LabelMap& map, int n) {
  return map.structuresOf(map.codes()[n]);
}

inline std::string reasonOf(const haptics::Expected<LabelMap>& map) {
  return map ? "" : map.error().reason;
}

/// Changes bytes behind the first ones, cuts, repeats and removes pieces.
inline std::string damaged(std::string bytes, std::size_t behind, std::mt19937& random) {
  const auto below = [&](std::size_t end) {
    return std::uniform_int_distribution<std::size_t>{0, end - 1}(random);
  };
  const std::size_t changes = 1 + below(4);
  for (std::size_t n = 0; n < changes && bytes.size() > behind + 60; ++n) {
    const auto place = [&] { return behind + below(bytes.size() - behind); };
    const std::size_t at = place();
    switch (below(5)) {
      case 0:
        bytes[at] = char(below(256));
        break;
      case 1:
        bytes.resize(at);
        break;
      case 2:
        bytes.erase(at, 1 + below(8));
        break;
      case 3:
        bytes.insert(at, bytes.substr(place(), 1 + below(40)));
        break;
      default:
        for (std::size_t m = at; m < std::min(at + 4, bytes.size()); ++m) bytes[m] = '\xff';
    }
  }
  return bytes;
}

/// Damages files (name, bytes) behind their first bytes until 200 are refused, each with a sentence
/// and a reason.
inline void expectDamagedRefused(const std::vector<std::pair<std::string, std::string>>& files,
                                 std::size_t behind) {
  Workshop workshop;
  const haptics::Volume scan = scanOn(smallGrid());
  std::mt19937 random{46};
  int refused = 0;
  std::size_t all = 0;
  for (; refused < 200 && all < 2000; ++all) {
    const auto& [name, bytes] = files[all % files.size()];
    const auto map = readLabels(workshop.write(name, damaged(bytes, behind, random)), scan);
    if (map) continue;
    ++refused;
    EXPECT_FALSE(sentence(map.error()).empty());
    EXPECT_FALSE(map.error().reason.empty());
  }
  EXPECT_EQ(refused, 200) << "of " << all;
}

}  // namespace datasets::testing
