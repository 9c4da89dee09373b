// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <future>
#include <memory>
#include <optional>

#include "app/read_ahead.h"
#include "datasets/readers/scan.h"
#include "haptics/core/volume.h"
#include "haptics/scene/scene.h"
#include "ui/props/picture.h"

namespace app {

/// Makes what takes longest of the scan that ReadAhead reads, while the window begins: its picture,
/// and a scene, whose field another scene takes over (haptics::makeScene()). On threads of its own.
class ScanAhead {
 public:
  explicit ScanAhead(std::shared_ptr<ReadAhead> file);
  /// Cancels and waits.
  ~ScanAhead();

  struct Scan {
    std::shared_ptr<const haptics::Volume> volume;
    ui::Picture picture = {};
    std::shared_ptr<const haptics::Scene> scene = {};  ///< of a probe; null if none could be made
  };
  /// The scan, after waiting for it; only once. None if it was not read, or on Cancel. Any thread.
  std::optional<Scan> take(const datasets::ReadProgress& progress);

 private:
  std::optional<Scan> make();

  std::shared_ptr<ReadAhead> file_;
  std::atomic<bool> cancel_{false};
  std::atomic<double> fraction_{0.0};
  std::future<std::optional<Scan>> scan_;
};

}  // namespace app
