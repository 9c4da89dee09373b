// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "haptics/core/volume.h"

/// One box of a patient, stored along any axes: what a picture of it shows follows from the places
/// of the patient alone.
namespace turned {

using haptics::Grid;
using haptics::Mat3;
using haptics::Vec3;

/// Voxels along the patient's L, P and S.
inline constexpr std::array<int, 3> kSize{10, 14, 18};
inline constexpr double kStep_mm = 2.0;
inline const Vec3 kFirst_mm{-31.0, 12.0, 57.0};  ///< the voxel farthest to R, A and I

/// The place of a voxel that is counted along L, P and S [mm, W].
inline Vec3 placeOf_mm(const Vec3& count_LPS) { return kFirst_mm + kStep_mm * count_LPS; }

/// All 48 ways to lay three axes along those of the patient.
inline std::vector<Mat3> orientations() {
  std::vector<Mat3> all;
  std::array<int, 3> order{0, 1, 2};
  do {
    for (int signs = 0; signs < 8; ++signs) {
      Mat3 axes = Mat3::Zero();
      for (int a = 0; a < 3; ++a)
        axes(order[static_cast<std::size_t>(a)], a) = (signs >> a & 1) != 0 ? -1.0 : 1.0;
      all.push_back(axes);
    }
  } while (std::next_permutation(order.begin(), order.end()));
  return all;
}

/// The patient's axis that an axis of a file lies along.
inline int patientAxisOf(const Mat3& axes, int a) {
  int along = 0;
  axes.col(a).cwiseAbs().maxCoeff(&along);
  return along;
}

/// The box as a file with these axes has it.
inline Grid gridAlong(const Mat3& axes) {
  Grid grid;
  Vec3 first = Vec3::Zero();
  for (int a = 0; a < 3; ++a) {
    const int along = patientAxisOf(axes, a);
    const int count = kSize[static_cast<std::size_t>(along)];
    grid.dims[static_cast<std::size_t>(a)] = count;
    if (axes(along, a) < 0.0) first[along] = count - 1;
  }
  grid.spacing = Vec3::Constant(1e-3 * kStep_mm);
  grid.direction = axes;
  grid.origin = 1e-3 * placeOf_mm(first);
  return grid;
}

/// Its voxels in file order, of a formula of the place [mm, W].
inline std::vector<std::int16_t> voxelsOf(
    const Grid& grid, const std::function<std::int16_t(const Vec3& p_mm)>& formula) {
  std::vector<std::int16_t> voxels;
  for (std::int64_t k = 0; k < grid.dims[2]; ++k)
    for (std::int64_t j = 0; j < grid.dims[1]; ++j)
      for (std::int64_t i = 0; i < grid.dims[0]; ++i)
        voxels.push_back(formula(1e3 * grid.worldOf({static_cast<double>(i), static_cast<double>(j),
                                                     static_cast<double>(k)})));
  return voxels;
}

/// A NRRD of it. `signs` turn LPS into the file's space; without a space the file does not say how
/// it lies.
inline std::string nrrdOf(const Grid& grid, const std::vector<std::int16_t>& voxels,
                          const std::string& space = "left-posterior-superior",
                          const Vec3& signs = Vec3::Ones()) {
  const auto vector = [&](const Vec3& v_mm) {
    const Vec3 w = signs.cwiseProduct(v_mm);
    return "(" + std::to_string(w.x()) + "," + std::to_string(w.y()) + "," + std::to_string(w.z()) +
           ")";
  };
  std::string bytes = "NRRD0004\ntype: short\ndimension: 3\n";
  if (!space.empty()) bytes += "space: " + space + "\n";
  bytes += "sizes:";
  for (const std::int64_t n : grid.dims) bytes += " " + std::to_string(n);
  if (space.empty()) {
    bytes += "\nspacings: 2 2 2";
  } else {
    bytes += "\nspace directions:";
    for (int a = 0; a < 3; ++a)
      bytes += " " + vector(1e3 * grid.spacing[a] * grid.direction.col(a));
    bytes += "\nspace origin: " + vector(1e3 * grid.origin);
  }
  bytes += "\nendian: little\nencoding: raw\n\n";
  return bytes.append(reinterpret_cast<const char*>(voxels.data()), 2 * voxels.size());
}

/// Bright in the right front quarter, half as bright in the left front one, else dark.
inline std::int16_t frontAt(const Vec3& p_mm) {
  const Vec3 count = (p_mm - kFirst_mm) / kStep_mm;
  if (count.y() > 0.5 * kSize[1] - 0.6) return 0;
  return count.x() < 0.5 * kSize[0] - 0.6 ? 1000 : 500;
}

/// The same scan of frontAt() in three axial files: as patients lie, stored face down and the other
/// way round, and not saying how it lies.
inline std::vector<std::pair<std::string, std::string>> frontFiles() {
  const Mat3 as_patients_lie = Mat3::Identity();
  const Mat3 face_down = Vec3(-1.0, -1.0, 1.0).asDiagonal();
  const auto bytes = [](const Mat3& axes, const std::string& space) {
    const Grid grid = gridAlong(axes);
    return nrrdOf(grid, voxelsOf(grid, frontAt), space);
  };
  return {{"as_patients_lie.nrrd", bytes(as_patients_lie, "left-posterior-superior")},
          {"face_down.nrrd", bytes(face_down, "left-posterior-superior")},
          {"unknown.nrrd", bytes(as_patients_lie, "")}};
}

}  // namespace turned
