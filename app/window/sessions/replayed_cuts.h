// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "app/recording/carved_copy.h"
#include "haptics/carving/burr.h"
#include "haptics/core/error.h"
#include "haptics/core/volume.h"
#include "ui/window/views.h"

namespace app {

/// The cuts of a recording until a step, in the voxels that the views show. GUI thread.
class ReplayedCuts {
 public:
  struct Cut {
    std::uint64_t sequence = 0;  ///< of its step
    std::uint32_t scene = 0;
    haptics::BurrCut cut;
  };
  /// All of a recording, in order. Any thread; `goes_on` as of replay().
  static haptics::Expected<std::vector<Cut>> read(const std::filesystem::path& path,
                                                  const std::function<bool()>& goes_on);

  explicit ReplayedCuts(ui::Views& views) : views_{views} {}

  void set(std::vector<Cut> cuts);
  /// Another picture is on view, or none: what was cut is seen no more.
  void forget() { live_.reset(); }
  bool isShown() const { return live_.has_value(); }
  /// Shows what was cut of a scene until a step, over this volume, which is on view. Back in time
  /// everything is cut anew.
  void show(const std::shared_ptr<const haptics::Volume>& on_view, std::uint32_t scene,
            std::uint64_t sequence);

 private:
  struct Live {
    CarvedCopy copy;
    std::uint32_t scene = 0;
    std::size_t next = 0;  ///< cut
  };
  bool begin(const std::shared_ptr<const haptics::Volume>& on_view, std::uint32_t scene);

  ui::Views& views_;
  std::vector<Cut> cuts_;
  std::optional<Live> live_;  ///< none: nothing cut is on view
};

}  // namespace app
