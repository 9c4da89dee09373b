// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "haptics/carving/burr.h"
#include "haptics/carving/tissues.h"
#include "haptics/core/error.h"
#include "haptics/core/geometry.h"
#include "haptics/core/volume.h"

namespace datasets {

/// Keeps the voxels of a box and writes none. It takes the place of the crop before it, so a box
/// can be made larger again.
struct Crop {
  haptics::VoxelBox kept;  ///< indices of the scan, within its grid; at least one voxel
};

/// Cuts away the half-space to which the normal points.
struct PlaneCut {
  haptics::Vec3 point_W = haptics::Vec3::Zero();    ///< m
  haptics::Vec3 normal_W = haptics::Vec3::UnitZ();  ///< unit
  double isovalue = 0.0;  ///< the present one: at it the wall lies in the plane
};

/// Cuts along a closed outline drawn on a picture, through everything behind it (a scalpel).
struct LassoCut {
  /// Corners of the outline in the camera's axes, at least three: for a parallel camera x, y in m,
  /// else x, y over the distance along the view (tangents). The last corner joins the first.
  std::vector<std::array<double, 2>> outline;
  haptics::Pose X_WC =
      haptics::Pose::Identity();  ///< camera: its eye, x right, y up, z towards the viewer
  bool parallel = false;
  double from = 0.0;      ///< m along the view from the eye: where the cut begins
  double until = 1e3;     ///< m, where it ends: the depth limit
  bool inside = true;     ///< what is inside the outline goes; false: what is outside
  double isovalue = 0.0;  ///< the present one: at it the wall lies on the outline
};

inline constexpr std::size_t kMostCorners = 4096;  ///< of a lasso's outline

/// Takes away the connected part of the solid at a place.
struct RemovePiece {
  haptics::Vec3 seed_W = haptics::Vec3::Zero();  ///< m, in the solid or within two voxels of it
  double isovalue = 0.0;
};

/// Takes away all parts of the solid but the one at a place.
struct KeepPiece {
  haptics::Vec3 seed_W = haptics::Vec3::Zero();
  double isovalue = 0.0;
};

/// Takes away all connected parts that are smaller than this.
struct RemoveSmallPieces {
  double isovalue = 0.0;
  double least_volume = 0.0;  ///< m^3
};

/// Takes away table and head holder: what is no part of the patient, by the rule in README.md.
struct RemoveHolder {
  double isovalue = 0.0;
};

/// What a burr took away while its key was held. Copies share the cuts, of which there may be very
/// many, and their text.
class Stroke {
 public:
  /// In the order in which they were made. Each begins less than its radius from where it ends.
  /// `removed`: what they removed [m3], for who shows it.
  explicit Stroke(std::vector<haptics::BurrCut> cuts = {}, double removed = 0.0);
  const std::vector<haptics::BurrCut>& cuts() const { return made_->cuts; }
  double removed() const { return made_->removed; }
  /// textOf(); made once. Any thread.
  const std::string& text() const;

 private:
  struct Made {
    Made(std::vector<haptics::BurrCut> all, double volume)
        : cuts{std::move(all)}, removed{volume} {}
    const std::vector<haptics::BurrCut> cuts;
    const double removed;
    std::once_flag once;
    std::string text;
  };
  std::shared_ptr<Made> made_;
};

/// What it takes to cut structures, whatever the scan's values say, or that they may not be cut.
/// It writes no voxel, and takes the place of the one before it. Copies share the runs.
class TissueTable {
 public:
  struct Part {
    int structure = 0;                         ///< its number in the label map
    double energy = haptics::Tissues::kNever;  ///< J/m3, above 0; kNever: it may not be cut
    std::vector<haptics::VoxelRun> runs = {};  ///< its voxels, by k, j, i, apart
    bool operator==(const Part&) const = default;
  };
  /// `dims`: of the scan. Runs lie in it.
  explicit TissueTable(std::array<std::int64_t, 3> dims = {1, 1, 1}, std::vector<Part> parts = {})
      : made_{std::make_shared<const Made>(Made{dims, std::move(parts)})} {}
  const std::array<std::int64_t, 3>& dims() const { return made_->dims; }
  const std::vector<Part>& parts() const { return made_->parts; }
  bool operator==(const TissueTable& other) const {
    return made_ == other.made_ || *made_ == *other.made_;
  }

 private:
  struct Made {
    std::array<std::int64_t, 3> dims;
    std::vector<Part> parts;
    bool operator==(const Made&) const = default;
  };
  std::shared_ptr<const Made> made_;
};

inline std::int64_t voxelsOf(const TissueTable::Part& part) {
  std::int64_t sum = 0;
  for (const haptics::VoxelRun& run : part.runs) sum += run.count;
  return sum;
}

inline constexpr std::size_t kMostCuts = 200'000;  ///< of a stroke: minutes of it

/// One thing that the user took away, or may not be cut, as a command: applied to the same volume
/// it gives the same voxels, to the bit. A session file and a recording store it as text.
using Edit = std::variant<Crop, PlaneCut, LassoCut, RemovePiece, KeepPiece, RemoveSmallPieces,
                          RemoveHolder, Stroke, TissueTable>;

/// Bytes of the longest text that is read: kMostCuts cuts have less, each on a way of its own.
inline constexpr std::size_t kLongestText = 1 << 26;
/// Of a table. Its text is shorter then.
inline constexpr std::size_t kMostParts = 256, kMostRuns = 1 << 22;
/// One line of JSON; numbers so that reading gives the same double.
std::string textOf(const Edit& edit);
/// Refuses text that textOf() did not write, longer text, and numbers out of range; reason
/// "damaged".
haptics::Expected<Edit> editFrom(std::string_view text);

}  // namespace datasets
