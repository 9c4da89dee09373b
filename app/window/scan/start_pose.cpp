// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/scan/start_pose.h"

#include <array>
#include <cmath>

#include "app/window/scan/tool_place.h"
#include "haptics/scene/legal_pose.h"
#include "ui/views/space_camera.h"

namespace app {
namespace {

constexpr double kStandOff = 0.008;  // m between tool and surface at the start
constexpr double kApproach = 0.001;  // m, the step towards it
constexpr std::array kAbout{-0.02, -0.01, 0.0, 0.01, 0.02};  // m, beside the line
// of the handle from the tip: out of the patient and up, towards where the first picture is seen
// from, but enough beside it that the tool is seen whole
const haptics::Vec3 kHandle{0.0, -0.85, 0.6};

double nearestVoxel(const haptics::Volume& volume, const haptics::Vec3& p_W) {
  const haptics::Grid& grid = volume.grid;
  const haptics::VoxelBox box = volume.bounds();
  const haptics::Vec3 index = grid.indexOf(p_W);
  std::int64_t at[3];
  for (int a = 0; a < 3; ++a) {
    at[a] = std::llround(index[a]);
    const auto axis = static_cast<std::size_t>(a);
    if (at[a] < box.first[axis] || at[a] >= box.end[axis]) return volume.least;
  }
  const std::int64_t voxel = (at[2] * grid.dims[1] + at[1]) * grid.dims[0] + at[0];
  return haptics::visitVoxels(volume.type, volume.voxels.get(),
                              [&](const auto* v) { return static_cast<double>(v[voxel]); });
}

}  // namespace

std::optional<haptics::Pose> startPose(const haptics::Scene& scene, double isovalue) {
  const haptics::Volume& volume = *scene.volume;
  const haptics::Grid& grid = volume.grid;
  const haptics::VoxelBox box = volume.bounds();
  haptics::Vec3 first, last;  // voxels
  for (int a = 0; a < 3; ++a) {
    first[a] = static_cast<double>(box.first[static_cast<std::size_t>(a)]);
    last[a] = static_cast<double>(box.end[static_cast<std::size_t>(a)] - 1);
  }
  const haptics::Vec3 middle = grid.worldOf(0.5 * (first + last));
  const haptics::Vec3 sizes = (last - first).cwiseProduct(grid.spacing);
  const double reach = 0.5 * sizes.norm();
  const double step = 0.5 * grid.spacing.minCoeff();
  // along the sight of the first picture, in which the wheel pushes the tool
  const haptics::Vec3 inwards = -ui::firstDirection(grid.direction.cwiseAbs() * sizes);
  const haptics::Vec3 right = inwards.unitOrthogonal(), up = inwards.cross(right);
  // what is nearest to the eye about the line, so that the tip waits in no hollow
  double depth = reach;
  for (const double x : kAbout)
    for (const double y : kAbout)
      for (double at = -reach; at < depth; at += step)
        if (nearestVoxel(volume, middle + inwards * at + right * x + up * y) >= isovalue)
          depth = at;
  if (depth >= reach) depth = 0.0;  // nothing there
  haptics::Pose X_WT = haptics::Pose::Identity();
  X_WT.linear() = haptics::Quat::FromTwoVectors(haptics::Vec3::UnitZ(), kHandle).toRotationMatrix();
  const haptics::Vec3 tip = X_WT.linear() * scene.tool.shell.tip;
  // from where the whole tool is in front of the surface, nearer until something would touch
  double offset = depth - 2.0 * scene.tool.shell.radius - kStandOff;
  const auto touches = [&](double at) {
    for (const haptics::Vec3& p : scene.tool.shell.points)
      if (nearestVoxel(volume, middle + inwards * at + X_WT.linear() * p - tip) >= isovalue)
        return true;
    return false;
  };
  for (; offset < depth && !touches(offset + kStandOff + kApproach); offset += kApproach) {
  }
  X_WT.translation() = middle + inwards * offset - tip;
  return haptics::legalPoseNear(scene, isovalue, X_WT);
}

}  // namespace app
