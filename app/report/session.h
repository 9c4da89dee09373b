// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/recording/recording.h"
#include "app/report/figures.h"
#include "haptics/core/error.h"
#include "haptics/core/volume.h"
#include "haptics/scene/watch.h"

namespace app::report {

/// Ticks of the steps of a recording: what each tool had to do with the structures of a watch.
class Ticks {
 public:
  /// Steps over a volume that does not lie like `scan` are not known. The watch must outlive it.
  Ticks(const Recording& recording, const haptics::Watch& watch, const haptics::Volume& scan);
  /// Refuses ("no-structures") structures that were felt and that the watch lacks.
  haptics::Expected<void> readGuards(const Recording& recording);
  /// Of steps in order of time.
  Tick of(const RecordedStep& recorded);
  /// Whether each structure is guarded at some time.
  std::vector<bool> everGuarded() const;

  // Distances that the recording has, against those to the watch.
  std::int64_t compared = 0;
  std::int64_t differing = 0;  ///< by more than any rounding

 private:
  struct Tool {
    haptics::ShellTree tree;
    haptics::Vec3 tip;
  };
  /// From a time on [ns], which structures are guarded.
  struct Guards {
    std::int64_t from_ns = 0;
    std::vector<bool> guarded;
  };
  const haptics::Watch& watch_;
  double half_voxel_;  ///< m
  std::vector<Guards> guards_;
  std::size_t guard_ = 0;                ///< how many of them have begun
  std::map<std::uint32_t, Tool> tools_;  ///< by scene
};

/// The least and the largest of a value in each of equal parts of a time.
class Curve {
 public:
  static constexpr std::size_t kParts = 180;
  struct Part {
    double from = 0.0;  ///< s
    Moment least, most;
  };
  Curve(double begin, double end);
  void add(double time, double value);
  const std::array<Part, kParts>& parts() const { return parts_; }

 private:
  double begin_, length_;
  std::array<Part, kParts> parts_{};
};

/// All that a report says of a session.
struct Session {
  Figures figures = {};
  std::vector<std::string> tools = {};  ///< of its scenes: names, or empty for a tool from a file
  int rate = 0;                         ///< Hz
  std::vector<bool> guarded;            ///< each structure, at some time
  std::int64_t compared = 0, differing = 0;  ///< as of Ticks
  Curve force;
  std::vector<Curve> nearest;  ///< m, to each structure
};

/// Reads a session. `scan`: may have no voxels; then nothing is known of what was cut of
/// structures. `hash`: of the scan, if known. `margins`: of each structure of the watch [m].
/// `goes_on`: gets the fraction that is done; if it returns false, the reason is "cancelled".
/// Refuses what Recording refuses, and
/// ("no-structures") a recording in which structures were felt that the watch lacks.
haptics::Expected<Session> sessionOf(Recording& recording, const haptics::Watch& watch,
                                     const std::shared_ptr<const haptics::Volume>& scan,
                                     const std::optional<VolumeHash>& hash,
                                     const std::vector<std::vector<double>>& margins,
                                     const std::function<bool(double)>& goes_on);

}  // namespace app::report
