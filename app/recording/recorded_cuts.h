// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "app/recording/carved_copy.h"
#include "haptics/carving/burr.h"
#include "haptics/core/error.h"
#include "haptics/core/volume.h"
#include "haptics/proxy/cutting.h"

namespace app {

class Recording;

/// A cut of a recording.
struct RecordedCut {
  std::uint64_t sequence = 0;  ///< of its step
  std::uint32_t scene = 0;
  haptics::BurrCut cut;
};

/// How a burr cuts in the scenes of a recording, by scene.
haptics::Expected<std::map<std::uint32_t, haptics::CutLaw>> lawsOf(const Recording& recording);
/// All cuts of a recording, in order, or those before `goes_on` returned false.
haptics::Expected<std::vector<RecordedCut>> cutsOf(Recording& recording,
                                                   const std::function<bool()>& goes_on);

/// The cuts of a recording until a step, carried out in voxels of their own.
class CutsUntil {
 public:
  void set(std::vector<RecordedCut> cuts);
  /// Drops the voxels: the next moveTo() begins anew.
  void forget() { live_.reset(); }
  bool isCarved() const { return live_.has_value(); }

  struct Moved {
    bool anew = false;  ///< volume() has other voxels than before, or is no more
    std::vector<haptics::VoxelBox> changed;  ///< hold all voxels that were lowered
    bool whole = true;                       ///< nothing is left to cut until the step
  };
  static constexpr std::int64_t kAll = INT64_MAX;
  /// Carries out what was cut of a scene until a step, over the scene's volume, until cuts have
  /// looked at `most` voxels: the same call again goes on. Back in time, in another scene and over
  /// another volume everything is cut anew. In a scene without cuts nothing isCarved().
  haptics::Expected<Moved> moveTo(const std::shared_ptr<const haptics::Volume>& uncut,
                                  std::uint32_t scene, std::uint64_t sequence,
                                  std::int64_t most = kAll);
  /// With what was cut until then; only while isCarved().
  const haptics::Volume& volume() const { return live_->copy.volume(); }

 private:
  struct Live {
    CarvedCopy copy;
    std::uint32_t scene = 0;
    std::size_t next = 0;  ///< cut
  };
  haptics::Expected<void> begin(const std::shared_ptr<const haptics::Volume>& uncut,
                                std::uint32_t scene);

  std::vector<RecordedCut> cuts_;
  std::optional<Live> live_;  ///< none: there are no voxels yet
};

}  // namespace app
