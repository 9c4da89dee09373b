// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "haptics/core/error.h"
#include "haptics/core/volume.h"
#include "haptics/tool/point_shell.h"

namespace comparison {

/// What is touched and with what: everything a method needs to be built.
struct Touched {
  std::string name;
  std::shared_ptr<const haptics::Volume> volume;
  double isovalue = 0.0;
  std::string tool;  ///< of resources/named_tools
  int points = 0;    ///< of its shell
  /// Where the hand of a seed begins; without it hands aim themselves.
  std::function<haptics::Pose(std::uint64_t seed)> place = {};
};

/// The synthetic rebuilds of the paper's four scenes: bunny, engine, hole, bone. Sizes, types,
/// spacings, noise and numbers of points are those of [Chan 2011], Table 1, or of the README here.
const std::vector<std::string>& sceneNames();
/// Builds one of them, the same voxels on every machine; some seconds at most. The name must be
/// one of sceneNames().
Touched makeScene(const std::string& name);

/// An analytic phantom with the tool that fits it. The name must be one of phantomNames().
Touched phantomScene(const std::string& name);

/// The real scans: scan-bunny, scan-engine, scan-bone, scan-skin, scan-tooth. Empty where the
/// readers are not built.
const std::vector<std::string>& scanNames();
/// Reads one of them from the folder of real scans. Only where the readers are built.
haptics::Expected<Touched> readScan(const std::string& name, const std::string& folder);

/// The tool of `scene` with its number of points, or with `points` of them.
haptics::Tool toolOf(const Touched& scene, int points = 0);
/// A tool of these points and no name.
haptics::Tool toolOf(std::vector<haptics::Vec3> points);
/// A ball with its points spread evenly.
haptics::Tool ballTool(int points, double radius);
/// A square plate of about `points` points on a grid, facing -z: all of them touch a plane at once.
haptics::Tool plateTool(int points, double side);

}  // namespace comparison
