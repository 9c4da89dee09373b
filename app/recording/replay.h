// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>

#include "app/recording/recording.h"
#include "datasets/edits/edit_history.h"
#include "haptics/core/error.h"
#include "haptics/scene/scene.h"
#include "haptics/scene/watch.h"

namespace app {

/// Differences between the recording and the present algorithm on the recorded device path.
struct ReplayDifference {
  std::int64_t steps = 0;  ///< steps compared
  /// Steps without a scene, with a scene that is not available, or without a start.
  std::int64_t skipped = 0;
  std::int64_t differing = 0;          ///< steps in which a bit of any number differs
  std::optional<std::uint64_t> first;  ///< sequence of the first differing step
  // The greatest differences from what was recorded, in the differing steps. A recording that
  // rounds adds its rounding.
  double distance = 0.0;  ///< m, between proxy and recorded proxy
  double angle = 0.0;     ///< rad
  double force = 0.0;     ///< N
  double torque = 0.0;    ///< N·m
  // Of the distances to structures, if there is a watch.
  std::int64_t distances = 0;            ///< compared
  std::int64_t differing_distances = 0;  ///< by more than their rounding
  // Of a recording in which a burr cuts.
  std::int64_t cuts = 0;            ///< that were recorded
  std::int64_t differing_cuts = 0;  ///< that began otherwise, or not
  /// The digest of what the recorded cuts have left of the last scene (cut_words.h), whatever the
  /// replay came to; none if there are none.
  std::optional<std::uint64_t> carved = {};
  std::int64_t carved_said = 0;       ///< digests in the recording: at marks, and at its end
  std::int64_t differing_carved = 0;  ///< of these
};

/// The volume that was on view in a recorded scene: the scan after the scene's edits. Refuses edits
/// that do not fit the scan, and a volume whose digest is not the recorded one, reason
/// "other-edits".
haptics::Expected<std::shared_ptr<const haptics::Volume>> editedAsRecorded(
    std::shared_ptr<const haptics::Volume> scan, const RecordedScene& scene,
    const datasets::EditWatch& watch = {});

/// The same of all scenes of a recording that were of this scan, as far as is known, by number.
haptics::Expected<std::map<std::uint32_t, std::shared_ptr<const haptics::Volume>>> editedAsRecorded(
    const std::shared_ptr<const haptics::Volume>& scan, const std::optional<VolumeHash>& hash,
    const Recording& recording);

/// The volume that a recorded scene touched: the same, with the walls of structures. Refuses
/// ("no-structures") walls of structures that are not in the watch, which may be null, and
/// ("other-structures") walls that come out otherwise.
haptics::Expected<std::shared_ptr<const haptics::Volume>> touchedAsRecorded(
    std::shared_ptr<const haptics::Volume> scan, const RecordedScene& scene,
    const haptics::Watch* watch, const std::shared_ptr<const haptics::Volume>& previous = {});

/// Runs the algorithm with the recorded device path, settings and cuts. `scene` returns the scene
/// with a number, or null if it is not available; it is called once for each scene. `goes_on` is
/// called with the completed fraction. If it returns false, the replay ends with reason
/// "cancelled". `watch`: structures to which distances are measured and compared; may be null.
/// Refuses ("no-structures") a recording in which structures were felt that are not in it.
haptics::Expected<ReplayDifference> replay(
    Recording& recording,
    const std::function<std::shared_ptr<const haptics::Scene>(std::uint32_t)>& scene,
    const std::function<bool(double)>& goes_on, const haptics::Watch* watch = nullptr);

}  // namespace app
