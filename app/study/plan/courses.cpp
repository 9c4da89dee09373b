// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/plan/courses.h"

#include <utility>

#include "datasets/phantoms/phantoms.h"
#include "datasets/phantoms/sampling.h"
#include "datasets/phantoms/shapes.h"
#include "haptics/simulation/grip.h"
#include "resources/named_tools.h"

namespace study::plan {
namespace {

using haptics::HandMotion;

constexpr double kStiffness = 1000.0;  // N/m
constexpr double kDepth = 0.004;       // m that the hand brings the device beyond the surface
constexpr double kBriefBegin = 0.48;   // s: just before the touch
constexpr int kBriefTicks = 150;

haptics::Expected<haptics::Tool> toolOf(const Planned& planned) {
  if (planned.tool == "point")
    return haptics::makeShell({haptics::Vec3::Zero()}).map([](haptics::PointShell&& shell) {
      return haptics::Tool{"point", {}, std::move(shell)};
    });
  auto mesh = resources::namedToolMesh(planned.tool);
  if (!mesh) return tl::unexpected(mesh.error());
  return haptics::makeTool(planned.tool, std::move(*mesh), planned.points);
}

haptics::Expected<datasets::Phantom> phantomOf(const Planned& planned) {
  if (planned.phantom != "grain") return datasets::makePhantom(planned.phantom);
  const datasets::Ramp ramp;
  return datasets::sampled<std::int16_t>(
             datasets::centredGrid(10, 10, 10, 1e-3), ramp,
             [](const haptics::Vec3& p_W) { return datasets::shapes::HalfSpace{}.distance(p_W); })
      .map([&](haptics::Volume&& volume) {
        return datasets::Phantom{std::move(volume), ramp.isovalue, "point"};
      });
}

/// From one corner of the volume to the other and back, in a second, turning a little.
haptics::Expected<haptics::Hand> through(const haptics::Scene& scene, const haptics::Vec3& aside) {
  const haptics::Grid& grid = scene.volume->grid;
  const haptics::Vec3 last{double(grid.dims[0] - 1), double(grid.dims[1] - 1),
                           double(grid.dims[2] - 1)};
  const haptics::Vec3 a = grid.worldOf(haptics::Vec3::Zero()) + aside,
                      b = grid.worldOf(last) + aside;
  const haptics::Quat turned{Eigen::AngleAxisd{0.5, haptics::Vec3::UnitY()}};
  return haptics::Hand::along(
      {0.0, 0.5, 1.0}, {haptics::poseOf(a, haptics::Quat::Identity()), haptics::poseOf(b, turned),
                        haptics::poseOf(a, haptics::Quat::Identity())});
}

haptics::Expected<haptics::Hand> handOf(const Planned& planned, const haptics::Scene& scene,
                                        double isovalue, std::uint64_t seed) {
  if (planned.way == Way::Within) return through(scene, haptics::Vec3::Zero());
  if (planned.way == Way::Beyond) return through(scene, haptics::Vec3::UnitX());
  const double reach = haptics::Hand::reachFor(kDepth, kStiffness, haptics::Grip{}.stiffness);
  auto aimed = haptics::Hand::aimed(planned.motion, scene, isovalue, reach, seed);
  if (!aimed || planned.way == Way::Aimed) return aimed;
  // pressed for a quarter of a second, then held
  std::vector<double> times;
  std::vector<haptics::Pose> poses;
  for (int n = 0; n <= 75; ++n) {
    times.push_back(0.01 * n);
    poses.push_back(aimed->at(0.01 * n));
  }
  return haptics::Hand::along(std::move(times), std::move(poses));
}

}  // namespace

std::vector<Planned> courses(Depth depth) {
  using haptics::FieldKind, haptics::NormalKind;
  std::vector<Planned> all{
      {"sphere and sphere, slide", "sphere", "sphere"},
      {"sphere and sphere, jerk", "sphere", "sphere", 0, Way::Aimed, HandMotion::Jerk},
      {"demo and probe, slide", "demo", "probe"},
      {"gyroid and drill, wedge", "gyroid", "drill", 0, Way::Aimed, HandMotion::Wedge},
      {"hole and peg, held", "hole", "peg", 0, Way::Held},
      {"sphere and one point, tap", "sphere", "point", 0, Way::Aimed, HandMotion::Tap},
      {"sphere and probe, a metre away", "sphere", "probe", 0, Way::Beyond},
      {"sphere and probe, isovalue above everything",
       "sphere",
       "probe",
       0,
       Way::Within,
       HandMotion::Slide,
       {},
       0.0,
       true},
      {"gyroid and sphere of 10,000 points, hook",
       "gyroid",
       "sphere",
       10'000,
       Way::Aimed,
       HandMotion::Hook,
       {},
       0.0,
       false,
       true},
      {"gyroid and drill, wedge, cell normals",
       "gyroid",
       "drill",
       0,
       Way::Aimed,
       HandMotion::Wedge,
       {FieldKind::Trilinear, NormalKind::Cell, {}}},
      {"a grain of 10^3 voxels and one point, tap", "grain", "point", 0, Way::Aimed,
       HandMotion::Tap},
  };
  if (depth == Depth::Quick) return all;
  const std::vector<Planned> more{
      {"demo and drill, jerk", "demo", "drill", 0, Way::Aimed, HandMotion::Jerk},
      {"torus and cane, hook", "torus", "cane", 0, Way::Aimed, HandMotion::Hook},
      {"halfspace and wrench, pry", "halfspace", "wrench", 0, Way::Aimed, HandMotion::Pry},
      {"hole and peg, wedge", "hole", "peg", 0, Way::Aimed, HandMotion::Wedge},
      {"demo and probe, slide, friction 0.3",
       "demo",
       "probe",
       0,
       Way::Aimed,
       HandMotion::Slide,
       {},
       0.3},
      {"gyroid and drill, wedge, spline normals",
       "gyroid",
       "drill",
       0,
       Way::Aimed,
       HandMotion::Wedge,
       {FieldKind::Trilinear, NormalKind::Spline, {}}},
      {"sphere and sphere, slide, spline field",
       "sphere",
       "sphere",
       0,
       Way::Aimed,
       HandMotion::Slide,
       {FieldKind::CubicSpline, NormalKind::Central, {}}},
      {"gyroid and sphere of 30,000 points, hook",
       "gyroid",
       "sphere",
       30'000,
       Way::Aimed,
       HandMotion::Hook,
       {},
       0.0,
       false,
       true},
  };
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

haptics::Expected<Course> made(const Planned& planned, int ticks, std::uint64_t seed) {
  auto phantom = phantomOf(planned);
  if (!phantom) return tl::unexpected(phantom.error());
  auto tool = toolOf(planned);
  if (!tool) return tl::unexpected(tool.error());
  const double isovalue =
      planned.above_everything ? phantom->volume.greatest + 1.0 : phantom->isovalue;
  auto scene =
      haptics::makeScene(std::make_shared<const haptics::Volume>(std::move(phantom->volume)),
                         std::move(*tool), planned.options);
  if (!scene) return tl::unexpected(scene.error());
  auto hand = handOf(planned, **scene, isovalue, seed);
  if (!hand) return tl::unexpected(hand.error());
  return Course{planned.name,
                std::move(*scene),
                isovalue,
                {kStiffness, 0.0, planned.friction},
                std::move(*hand),
                planned.brief ? kBriefTicks : ticks,
                planned.brief ? kBriefBegin : 0.0,
                planned.way == Way::Aimed || planned.way == Way::Held};
}

}  // namespace study::plan
