// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "app/recording/recorded_cuts.h"
#include "haptics/core/error.h"
#include "haptics/core/volume.h"
#include "ui/window/views.h"

namespace app {

/// The cuts of a recording until a step, in the voxels that the views show. GUI thread.
class ReplayedCuts {
 public:
  /// All of a recording, in order. Any thread; `goes_on` as of replay().
  static haptics::Expected<std::vector<RecordedCut>> read(const std::filesystem::path& path,
                                                          const std::function<bool()>& goes_on);

  explicit ReplayedCuts(ui::Views& views) : views_{views} {}

  void set(std::vector<RecordedCut> cuts) { cuts_.set(std::move(cuts)); }
  /// Another picture is on view, or none: what was cut is seen no more.
  void forget() { cuts_.forget(); }
  bool isShown() const { return cuts_.isCarved(); }
  /// Shows what was cut of a scene until a step, over this picture, which is on view. Back in time
  /// everything is cut anew. Returns whether it shows all of it: if not, the same call again goes
  /// on, so that no call takes long.
  bool show(const ui::Picture& on_view, std::uint32_t scene, std::uint64_t sequence);

 private:
  ui::Views& views_;
  CutsUntil cuts_;
};

}  // namespace app
