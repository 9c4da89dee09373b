// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/comparison/scenes.h"

#include <algorithm>
#include <cmath>

#include "datasets/phantoms/making.h"
#include "datasets/phantoms/phantoms.h"
#include "resources/named_tools.h"

namespace comparison {
namespace {

using haptics::Vec3;

/// A scene of the paper, with so many points of its tool.
Touched paperScene(const std::string& name, int points) {
  Touched scene = phantomScene(name);
  scene.points = points;
  return scene;
}

Touched hole() {
  Touched scene = phantomScene("hole");
  scene.tool = "peg";
  scene.points = 1307;
  // the peg's end 8 mm down in the hole; off the middle, and not quite upright, so that it catches,
  // each seed in another direction
  scene.place = [](std::uint64_t seed) {
    constexpr double kGolden = 2.399963;  // rad
    const double angle = kGolden * double((seed - 1) % 1000);
    const Eigen::AngleAxisd turn{angle, Vec3::UnitZ()};
    const haptics::Quat tilt{Eigen::AngleAxisd{0.005, turn.inverse() * Vec3{1, 2, 0}.normalized()}};
    const Vec3 p_WE = turn * Vec3{0.00008, 0.00004, 0.012}, p_EP_P{0.0, 0.0, 0.025};
    return haptics::poseOf(p_WE + tilt * p_EP_P, tilt);
  };
  return scene;
}

}  // namespace

const std::vector<std::string>& sceneNames() {
  static const std::vector<std::string> kNames{"bunny", "engine", "hole", "bone"};
  return kNames;
}

Touched makeScene(const std::string& name) {
  if (name == "bunny") return paperScene(name, 403);
  if (name == "engine") return paperScene(name, 2126);
  if (name == "hole") return hole();
  return paperScene(name, 518);
}

Touched phantomScene(const std::string& name) {
  datasets::Phantom phantom = datasets::makePhantom(name).value();
  return {name, std::make_shared<const haptics::Volume>(std::move(phantom.volume)),
          phantom.isovalue, phantom.tool};
}

haptics::Tool toolOf(const Touched& scene, int points) {
  return haptics::makeTool(scene.tool, resources::namedToolMesh(scene.tool).value(),
                           points > 0 ? points : scene.points)
      .value();
}

haptics::Tool toolOf(std::vector<Vec3> points) {
  return {"", {}, haptics::makeShell(std::move(points)).value()};
}

haptics::Tool ballTool(int points, double radius) {
  return toolOf(datasets::ballPoints(points, radius));
}

haptics::Tool plateTool(int points, double side) {
  const int across = std::max(2, static_cast<int>(std::lround(std::sqrt(double(points)))));
  return toolOf(datasets::platePoints(across, side));
}

}  // namespace comparison
