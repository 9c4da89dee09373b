// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <atomic>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <thread>

#include "haptics/core/geometry.h"
#include "haptics/core/realtime.h"
#include "haptics/core/volume.h"

namespace haptics {

/// Copies the pages of a private view around a place before they are written, on a thread of its
/// own, so that whoever writes there meets no page fault. The voxels keep their values.
class PagesAhead {
 public:
  /// `volume`: its voxels are the view, which must be writable. `reach` [m] around the place is
  /// written next; pages are copied a little farther.
  PagesAhead(std::shared_ptr<const Volume> volume, double reach);
  ~PagesAhead();
  PagesAhead(const PagesAhead&) = delete;
  PagesAhead& operator=(const PagesAhead&) = delete;

  /// Where it will be written [m, W]. Of one thread.
  void at(const Vec3& p_W) HAPTICS_RT;

  /// Copies the pages around a place now, on the calling thread. Returns false where the system
  /// does not do that: then each is copied when it is first written.
  bool copyAround(const Vec3& p_W) const;

 private:
  void run();

  std::shared_ptr<const Volume> volume_;
  double reach_;
  // the newest place, by axis; a mixture of two is between them
  std::array<std::atomic<float>, 3> place_;
  std::mutex mutex_;
  std::condition_variable ended_;
  bool ending_ = false;
  std::thread thread_;
};

}  // namespace haptics
