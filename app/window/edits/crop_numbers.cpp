// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/edits/crop_numbers.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "ui/window/views.h"

namespace app {
namespace {

using ui::kMmPerM;

constexpr double kAligned = 1.0 - 1e-6;  // cosine between an axis of the grid and one of W

/// How the edges of voxels along an axis of the grid are told in mm: in W if the axis is one of
/// W's, else along the grid from its outer face.
struct AxisNumbers {
  int along = -1;  ///< axis of W; below 0: none
  double at_first_mm = 0.0, per_voxel_mm = 1.0;

  double mmOf(std::int64_t edge) const {
    return at_first_mm + per_voxel_mm * static_cast<double>(edge);
  }
  std::int64_t edgeAt(double mm) const { return std::llround((mm - at_first_mm) / per_voxel_mm); }
};

AxisNumbers numbersOf(const haptics::Volume& volume, int axis) {
  const haptics::Grid& grid = volume.grid;
  AxisNumbers numbers{.per_voxel_mm = grid.spacing[axis] * kMmPerM};
  if (!volume.orientation_known) return numbers;
  int along = 0;
  grid.direction.col(axis).cwiseAbs().maxCoeff(&along);
  const double cosine = grid.direction(along, axis);
  if (std::abs(cosine) < kAligned) return numbers;
  numbers.along = along;
  numbers.per_voxel_mm *= cosine > 0.0 ? 1.0 : -1.0;
  haptics::Vec3 edge = haptics::Vec3::Zero();
  edge[axis] = -0.5;
  numbers.at_first_mm = grid.worldOf(edge)[along] * kMmPerM;
  return numbers;
}

}  // namespace

bool cropsAlongPatient(const haptics::Volume& volume) {
  return numbersOf(volume, 0).along >= 0 && numbersOf(volume, 1).along >= 0 &&
         numbersOf(volume, 2).along >= 0;
}

std::array<ui::CropRange, 3> cropRangesOf(const haptics::Volume& volume,
                                          const haptics::VoxelBox& box) {
  const bool in_w = cropsAlongPatient(volume);
  std::array<ui::CropRange, 3> ranges;
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    AxisNumbers numbers = numbersOf(volume, axis);
    if (!in_w) numbers = {.per_voxel_mm = volume.grid.spacing[axis] * kMmPerM};
    const auto [least, most] = std::minmax({numbers.mmOf(0), numbers.mmOf(volume.grid.dims[a])});
    const auto [from, to] = std::minmax({numbers.mmOf(box.first[a]), numbers.mmOf(box.end[a])});
    ranges[a] = {.axis = QChar(in_w ? 'x' + numbers.along : 'i' + axis),
                 .least = least,
                 .most = most,
                 .step = std::abs(numbers.per_voxel_mm),
                 .from = from,
                 .to = to};
  }
  return ranges;
}

haptics::VoxelBox withFace(const haptics::Volume& volume, haptics::VoxelBox box, int axis,
                           bool high, double mm) {
  const auto a = static_cast<std::size_t>(axis);
  AxisNumbers numbers = numbersOf(volume, axis);
  if (!cropsAlongPatient(volume)) numbers = {.per_voxel_mm = volume.grid.spacing[axis] * kMmPerM};
  const bool far_side = high == (numbers.per_voxel_mm > 0.0);
  const std::int64_t edge = numbers.edgeAt(mm);
  if (far_side)
    box.end[a] = std::clamp(edge, box.first[a] + 1, volume.grid.dims[a]);
  else
    box.first[a] = std::clamp<std::int64_t>(edge, 0, box.end[a] - 1);
  return box;
}

std::optional<haptics::VoxelBox> boxInSlices(ui::Views& views, const haptics::Grid& grid) {
  // along each axis of W, what every slice that is in view shows of it
  const double far_mm = 1e5;
  Eigen::Vector3d low = Eigen::Vector3d::Constant(-far_mm), high = -low;
  bool any = false;
  for (const ui::Plane plane : {ui::Plane::Axial, ui::Plane::Coronal, ui::Plane::Sagittal}) {
    const ui::SliceView& slice = views.slice(plane);
    if (!slice.isVisible()) continue;
    any = true;
    const ui::PlaneAxes axes = ui::axesOf(plane);
    const QPointF origin = slice.projected(Eigen::Vector3d::Zero());
    const QRectF seen = slice.pictureRect();
    const auto narrow = [&](const Eigen::Vector3d& along, double at_zero, double per_mm,
                            double begin, double end) {
      int a = 0;
      along.cwiseAbs().maxCoeff(&a);
      const auto [from, to] =
          std::minmax({(begin - at_zero) / per_mm * along[a], (end - at_zero) / per_mm * along[a]});
      low[a] = std::max(low[a], from);
      high[a] = std::min(high[a], to);
    };
    narrow(axes.right, origin.x(), slice.projected(axes.right).x() - origin.x(), seen.left(),
           seen.right());
    narrow(axes.up, origin.y(), slice.projected(axes.up).y() - origin.y(), seen.top(),
           seen.bottom());
  }
  if (!any) return {};
  haptics::Vec3 first = haptics::Vec3::Constant(far_mm), last = -first;
  for (int corner = 0; corner < 8; ++corner) {
    haptics::Vec3 p_mm;
    for (int a = 0; a < 3; ++a) p_mm[a] = (corner >> a) & 1 ? high[a] : low[a];
    const haptics::Vec3 index = grid.indexOf(p_mm / kMmPerM);
    first = first.cwiseMin(index);
    last = last.cwiseMax(index);
  }
  haptics::VoxelBox box;
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    box.first[a] = std::clamp<std::int64_t>(std::llround(first[axis] + 0.5), 0, grid.dims[a] - 1);
    const std::int64_t end = std::llround(last[axis] + 0.5);
    box.end[a] = std::clamp(end, box.first[a] + 1, grid.dims[a]);
  }
  return box;
}

}  // namespace app
