// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "haptics/core/error.h"
#include "haptics/scene/scene.h"
#include "haptics/servo/rate.h"

namespace cohort {

/// How a scan is touched, where the manifest does not say so.
struct Touching {
  std::string isovalue = "bone";               ///< a number, or the name of a rule: bone, skin
  std::vector<std::string> tools = {"drill"};  ///< named tools
  std::vector<std::string> hands = {"tap", "slide"};
  int repetitions = 1;             ///< each with another aim
  double seconds = 4.0;            ///< s of each touch
  double stiffness = 1000.0;       ///< N/m
  double angular_stiffness = 0.0;  ///< N·m/rad; 0: stiffness times the tool's inertia
  double friction = 0.0;
  std::string field = "trilinear", normals = "central";  ///< as app::nameOf() names them
  haptics::Fineness fineness = {};
  haptics::ServoRate rate = {};
  std::int64_t budget_us = 0;  ///< counted, 100 units of work for each; 0: what the rate gives
  std::int64_t budget_work() const { return budget_us > 0 ? budget_us * 100 : rate.budget_work(); }
  std::uint64_t seed = 0;  ///< of the hands' aims: added to the number of the repetition
  /// The mesh of the tool called "mesh": its file, its unit, and a hash of its bytes, by which
  /// shards know it.
  std::filesystem::path mesh = {};
  std::string mesh_unit = "mm";
  std::uint64_t mesh_hash = 0;
};
/// The tool whose mesh is Touching::mesh.
inline constexpr const char* kOwnMesh = "mesh";

/// One line of a manifest: a scan, and what is done with it.
struct Line {
  std::string label;  ///< what the scan is called in all that is written: letters, digits, - and _
  std::filesystem::path path;
  std::optional<int> series = {};
  Touching touching = {};
  std::filesystem::path recording = {};  ///< to be replayed in the scan; empty: the hands touch it

  /// Touches of this line: each tool with each hand, repeated; a replay counts as one.
  std::size_t rows() const;
};

struct Manifest {
  std::vector<Line> lines;
  /// Names what is asked for, without any path: the same on every machine, another for another
  /// manifest.
  std::string identity;
};

/// Reads a manifest: a text of columns parted by tabs, with a line of heads. `path` is relative to
/// the manifest's folder. The other columns may be missing or empty: label, series, isovalue, tool
/// and hand (several parted by commas), repetitions, seconds, stiffness, recording. A folder is
/// taken as a BIDS dataset: each volume below sub-*/ is a line, its label the subject, session and
/// run of its name. Refuses with a sentence that names line and column.
haptics::Expected<Manifest> readManifest(const std::filesystem::path& path,
                                         const Touching& otherwise);

/// The isovalue for a volume of this unit; none where a rule needs Hounsfield units and there are
/// none.
std::optional<double> isovalueOf(const Touching& touching, const std::string& unit);

/// tap, slide, wedge, pry, hook, jerk, twist.
const std::vector<std::string>& handNames();

}  // namespace cohort
