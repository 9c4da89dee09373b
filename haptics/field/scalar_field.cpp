// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/field/scalar_field.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "haptics/field/spline_cell.h"

namespace haptics {

double Cell::value(const Vec3& u) const HAPTICS_RT {
  const double x = u.x() - double(at[0]), y = u.y() - double(at[1]), z = u.z() - double(at[2]);
  const double c00 = corner[0] + x * (corner[1] - corner[0]);
  const double c10 = corner[2] + x * (corner[3] - corner[2]);
  const double c01 = corner[4] + x * (corner[5] - corner[4]);
  const double c11 = corner[6] + x * (corner[7] - corner[6]);
  const double c0 = c00 + y * (c10 - c00);
  const double c1 = c01 + y * (c11 - c01);
  return c0 + z * (c1 - c0);
}

Vec3 Cell::gradient(const Vec3& u) const HAPTICS_RT {
  const double x = u.x() - double(at[0]), y = u.y() - double(at[1]), z = u.z() - double(at[2]);
  const double dx00 = corner[1] - corner[0], dx10 = corner[3] - corner[2];
  const double dx01 = corner[5] - corner[4], dx11 = corner[7] - corner[6];
  const double c00 = corner[0] + x * dx00, c10 = corner[2] + x * dx10;
  const double c01 = corner[4] + x * dx01, c11 = corner[6] + x * dx11;
  const double dx0 = dx00 + y * (dx10 - dx00), dx1 = dx01 + y * (dx11 - dx01);
  return {dx0 + z * (dx1 - dx0), (c10 - c00) + z * ((c11 - c01) - (c10 - c00)),
          (c01 + y * (c11 - c01)) - (c00 + y * (c10 - c00))};
}

namespace {

/// How far most voxels lie apart: from the first to the last percentile of some 4,096 of them, so
/// that one voxel of 1e30 does not count; the whole range where those are all alike.
double usualRange(const Volume& volume) {
  const std::int64_t count = volume.grid.voxelCount();
  const std::int64_t step = std::max<std::int64_t>(1, count / 4096) | 1;
  std::vector<double> values;
  visitVoxels(volume.type, volume.voxels.get(), [&](const auto* voxels) {
    for (std::int64_t i = 0; i < count; i += step) values.push_back(double(voxels[i]));
  });
  std::sort(values.begin(), values.end());
  const std::size_t percent = values.size() / 100;
  const double range = values[values.size() - 1 - percent] - values[percent];
  return range > 0.0 ? range : std::max(volume.greatest - volume.least, 1e-30);
}

}  // namespace

ScalarField::ScalarField(std::shared_ptr<const Volume> volume, FieldKind kind)
    : ScalarField{volume, kind, MaxPyramid{*volume, kind}} {}

ScalarField::ScalarField(std::shared_ptr<const Volume> volume, FieldKind kind, MaxPyramid pyramid)
    : volume_{std::move(volume)},
      bounds_{volume_->bounds()},
      kind_{kind},
      pyramid_{std::move(pyramid)} {
  const Grid& grid = volume_->grid;
  A_VW_ = grid.spacing.cwiseInverse().asDiagonal() * grid.direction.transpose();
  A_VW_t_ = A_VW_.transpose();
  b_V_ = -(A_VW_ * grid.origin);
  voxel_ = grid.spacing.minCoeff();
  rounding_margin_ = 1e-9 * usualRange(*volume_);
  lattice_.voxels = volume_->voxels.get();
  lattice_.type = volume_->type;
  lattice_.blocks = pyramid_.finest();
  lattice_.finest_radius = pyramid_.finestRadius();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    lattice_.dims[axis] = double(grid.dims[axis]);
    lattice_.first[axis] = double(bounds_.first[axis]);
    lattice_.end[axis] = double(bounds_.end[axis]);
    lattice_.block_counts[axis] = double(pyramid_.finestCounts()[axis]);
  }
}

namespace {

template <class T>
void fetch(const T* voxels, const Grid& grid, const VoxelBox& box, double background,
           Cell& cell) HAPTICS_RT {
  const std::int64_t row = grid.dims[0], slice = grid.dims[0] * grid.dims[1];
  const auto [i, j, k] = cell.at;
  if (i >= box.first[0] && j >= box.first[1] && k >= box.first[2] && i + 1 < box.end[0] &&
      j + 1 < box.end[1] && k + 1 < box.end[2]) {
    const T* v = voxels + k * slice + j * row + i;
    cell.corner = {
        double(v[0]),     double(v[1]),         double(v[row]),         double(v[row + 1]),
        double(v[slice]), double(v[slice + 1]), double(v[slice + row]), double(v[slice + row + 1])};
    return;
  }
  for (int bit = 0; bit < 8; ++bit) {
    const std::int64_t x = i + (bit & 1), y = j + (bit >> 1 & 1), z = k + (bit >> 2 & 1);
    const bool within = x >= box.first[0] && y >= box.first[1] && z >= box.first[2] &&
                        x < box.end[0] && y < box.end[1] && z < box.end[2];
    cell.corner[bit] = within ? double(voxels[z * slice + y * row + x]) : background;
  }
}

/// The cell around u, kept where the conversion is defined; far outside all is background.
std::array<std::int64_t, 3> cellIndex(const Vec3& u, const VoxelBox& box) HAPTICS_RT {
  std::array<std::int64_t, 3> at;
  for (int axis = 0; axis < 3; ++axis)
    at[axis] = static_cast<std::int64_t>(
        std::clamp(std::floor(u[axis]), double(box.first[axis] - 2), double(box.end[axis])));
  return at;
}

}  // namespace

Cell ScalarField::cellAt(const std::array<std::int64_t, 3>& at) const HAPTICS_RT {
  Cell cell;
  cell.at = at;
  const Volume& v = *volume_;
  visitVoxels(v.type, v.voxels.get(),
              [&](const auto* voxels) { fetch(voxels, v.grid, bounds_, v.least, cell); });
  return cell;
}

Cell ScalarField::cellAround(const Vec3& u) const HAPTICS_RT {
  return cellAt(cellIndex(u, bounds_));
}

SplineCell ScalarField::splineCellAround(const Vec3& u) const HAPTICS_RT {
  return splineCellAt(*volume_, bounds_, cellIndex(u, bounds_));
}

double ScalarField::value(const Vec3& u) const HAPTICS_RT {
  if (kind_ == FieldKind::CubicSpline) return splineCellAround(u).value(u);
  return cellAround(u).value(u);
}

FieldSample ScalarField::sample(const Vec3& u) const HAPTICS_RT {
  FieldSample sample;
  if (kind_ == FieldKind::CubicSpline) {
    Vec3 per_index;
    sample.value = splineCellAround(u).sample(u, per_index);
    sample.gradient_W = worldGradient(per_index);
  } else {
    const Cell cell = cellAround(u);
    sample.value = cell.value(u);
    sample.gradient_W = worldGradient(cell.gradient(u));
  }
  return sample;
}

Vec3 ScalarField::splineGradient(const Vec3& u) const HAPTICS_RT {
  if (kind_ == FieldKind::CubicSpline) return sample(u).gradient_W;
  return worldGradient(splineCellAround(u).normalSlope(u));
}

Vec3 ScalarField::centralGradient(const Vec3& u) const HAPTICS_RT {
  Vec3 per_index;
  for (int axis = 0; axis < 3; ++axis) {
    Vec3 a = u, b = u;
    a[axis] -= 1.0;
    b[axis] += 1.0;
    per_index[axis] = 0.5 * (value(b) - value(a));
  }
  return worldGradient(per_index);
}

}  // namespace haptics
