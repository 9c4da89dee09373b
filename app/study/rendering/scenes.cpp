// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include "app/display.h"
#include "app/study/rendering/drawing.h"
#include "app/study/rendering/rendering.h"
#include "datasets/phantoms/making.h"
#include "datasets/phantoms/sampling.h"

namespace study {
namespace {

using haptics::Vec3;

// All but parallel rays. The ray caster's light comes along each ray, that of meshes and of the
// CPU's ray caster along the camera's axis: at 30 degrees that would outweigh all else.
constexpr double kAngle_deg = 1.0;

const Sphere kSphere{{4.0, -3.0, 5.0}, 18.0};

datasets::Phantom spherePhantom() {
  const datasets::Ramp ramp;
  auto volume = datasets::sampled<std::int16_t>(
      datasets::centredGrid(64, 64, 64, 0.001), ramp, [](const Vec3& p) {
        return ((p * 1e3 - kSphere.centre_mm).norm() - kSphere.radius_mm) * 1e-3;
      });
  return {.volume = std::move(volume.value()), .isovalue = ramp.isovalue, .tool = {}};
}

/// The mean of `factor` voxels each way, whole blocks only.
haptics::Volume averaged(const haptics::Volume& fine, std::int64_t factor) {
  haptics::Grid grid = fine.grid;
  grid.origin = fine.grid.worldOf(Vec3::Constant(0.5 * (static_cast<double>(factor) - 1.0)));
  grid.spacing *= static_cast<double>(factor);
  for (auto& dim : grid.dims) dim /= factor;
  const auto& dims = fine.grid.dims;
  return haptics::visitVoxels(fine.type, fine.voxels.get(), [&](const auto* voxels) {
    return datasets::filled(grid, haptics::ScalarType::Int16,
                            [&](std::int64_t I, std::int64_t J, std::int64_t K) {
                              double sum = 0.0;
                              for (std::int64_t k = K * factor; k < (K + 1) * factor; ++k)
                                for (std::int64_t j = J * factor; j < (J + 1) * factor; ++j)
                                  for (std::int64_t i = I * factor; i < (I + 1) * factor; ++i)
                                    sum += voxels[(k * dims[1] + j) * dims[0] + i];
                              return sum / static_cast<double>(factor * factor * factor);
                            });
  });
}

/// Looks at the middle of the volume from three sides, so that a median is one; all of it is in the
/// picture.
std::vector<Camera> camerasAround(const haptics::Grid& grid) {
  const Vec3 sides[] = {{0, -1, 0}, {1, -1, 0.6}, {-1, -0.2, -0.7}};
  const Vec3 last{static_cast<double>(grid.dims[0] - 1), static_cast<double>(grid.dims[1] - 1),
                  static_cast<double>(grid.dims[2] - 1)};
  const Vec3 middle_mm = 1e3 * grid.worldOf(0.5 * last);
  const double half_mm = 0.5 * 1e3 * (grid.worldOf(last) - grid.worldOf(Vec3::Zero())).norm();
  const double away_mm = half_mm / std::tan(0.5 * kAngle_deg * std::numbers::pi / 180.0);
  std::vector<Camera> cameras;
  for (const Vec3& side : sides)
    cameras.push_back(
        {middle_mm + away_mm * side.normalized(), middle_mm, Vec3::UnitZ(), kAngle_deg});
  return cameras;
}

struct Effort {
  int side;                              ///< pixels
  std::vector<double> sample_distances;  ///< voxels
  double reference;                      ///< the same
  Frames frames;
};

Effort effortOf(const std::string& scene, Depth depth) {
  if (depth == Depth::Quick) return {160, {2.0, 1.0, 0.5}, 0.125, {2, 2, 0.0}};
  // about a minute a job where the processor draws; the head's rays are three times as long
  return {
      scene == "sphere" ? 192 : 160, {2.0, 1.0, 0.5, 0.25, 0.125, 0.0625}, 0.03125, {2, 7, 0.4}};
}

Outcome& operator+=(Outcome& outcome, const Outcome& more) {
  const auto append = [](auto& to, const auto& from) {
    to.insert(to.end(), from.begin(), from.end());
  };
  append(outcome.cases, more.cases);
  append(outcome.plots, more.plots);
  append(outcome.tables, more.tables);
  append(outcome.remarks, more.remarks);
  return outcome;
}

}  // namespace

Outcome drawScene(const std::string& scene, Depth depth) {
  const app::HeldDisplay display;  // outlives the windows
  if (!display.draws())
    return notDrawn(scene, "Not measured: there was no X display with GLX to draw on (DISPLAY).");
  const Effort effort = effortOf(scene, depth);
  const bool sphere = scene == "sphere";
  datasets::Phantom phantom = sphere ? spherePhantom() : datasets::makePhantom("demo").value();
  if (!sphere && depth == Depth::Quick) phantom.volume = averaged(phantom.volume, 3);
  const std::vector<Camera> cameras = camerasAround(phantom.volume.grid);
  Drawing drawing{phantom, effort.side};

  std::vector<Drawn> drawn;
  const auto draw = [&](BackEnd back_end, double distance) {
    drawn.push_back({nameOf(back_end), distance});
    for (const Camera& camera : cameras)
      drawn.back().views.push_back(
          drawing.shoot(back_end, distance > 0.0 ? distance : 1.0, camera, effort.frames));
  };
  for (const BackEnd back_end : {BackEnd::RayCast, BackEnd::RayCastCoarse, BackEnd::ProcessorCast})
    for (const double distance : effort.sample_distances) draw(back_end, distance);
  for (const BackEnd back_end : {BackEnd::Mesh, BackEnd::ReducedMesh}) draw(back_end, 0.0);

  Reference finest{"the ray caster at 1/" + shortly(1.0 / effort.reference) + " voxel"};
  for (const Camera& camera : cameras)
    finest.views.push_back(
        drawing.shoot(BackEnd::RayCast, effort.reference, camera, {0, 0, 0.0}).image);

  Outcome outcome = judged(sphere ? "Sphere" : "Head", finest, drawn);
  outcome += convergence(sphere ? "Sphere" : "Head", nameOf(BackEnd::RayCast),
                         nameOf(BackEnd::RayCastCoarse), drawn);
  if (sphere) {
    Reference formula{"its formula"};
    for (const Camera& camera : cameras)
      formula.views.push_back(imageOf(kSphere, drawing.look(), camera, effort.side));
    outcome += judged("Sphere", formula, drawn);
    outcome += agreement(formula, finest);
    std::vector<Drawn> own;
    for (const Drawn& d : drawn)
      if (d.back_end != nameOf(BackEnd::ProcessorCast) &&
          (d.sample_distance == 0.0 || d.sample_distance == drawing.ownSampleDistance()))
        own.push_back(d);
    outcome += silhouettes({kSphere, cameras, 1e3 * phantom.volume.grid.spacing.x()}, own);
  }
  outcome.remarks.push_back(
      "Drawn by " + drawing.renderer() + ", " + std::to_string(effort.side) + " x " +
      std::to_string(effort.side) + " pixels. Palpate samples every " +
      shortly(drawing.ownSampleDistance()) +
      " voxels. A mesh is made once for each isovalue, which its frame time leaves out: of the " +
      scene + " " + shortly(drawing.triangles()) + " triangles in " +
      shortly(drawing.meshing_ms()) + " ms.");
  return outcome;
}

}  // namespace study
