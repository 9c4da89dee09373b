// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <utility>

#include "haptics/core/realtime.h"
#include "haptics/proxy/cutting.h"
#include "haptics/proxy/felt.h"
#include "haptics/proxy/proxy.h"
#include "haptics/scene/scene.h"

namespace haptics {

/// A scene and the proxy that moves in it. The setting thread makes and destroys it; the servo
/// thread uses it.
struct Engagement {
  Engagement(std::shared_ptr<const Scene> adopted, const Pose& X_start)
      : scene{std::move(adopted)}, proxy{*scene, X_start} {}
  /// Of a tool that cuts.
  Engagement(std::unique_ptr<Cutting> cuts, const Pose& X_start)
      : cutting{std::move(cuts)}, scene{cutting->scene()}, proxy{*scene, X_start} {}
  std::unique_ptr<Cutting> cutting = {};  ///< null: it cuts nothing
  std::shared_ptr<const Scene> scene;
  Proxy proxy;
  Felt felt;  ///< what structures make of its wrench
  /// The mouse's grip comes along to the proxy's pose, and the mouse pulls to this one; none: it
  /// stays. A real device always stays: its mapping moves.
  std::optional<Pose> X_WH = {};
};

/// Hands engagements to the servo thread, and back after use. There is one setting thread and one
/// servo thread; neither waits. The servo thread adopts no new engagement until the setting thread
/// has collected the one that the servo thread left last.
class SceneHandOver {
 public:
  ~SceneHandOver() {
    delete next_.load();
    delete left_.load();
    delete current_;
  }
  /// Setting thread: offers the next engagement. An earlier offer that was not adopted is
  /// destroyed.
  void offer(std::unique_ptr<Engagement> engagement) {
    collect();
    std::unique_ptr<Engagement> never_adopted{
        next_.exchange(engagement.release(), std::memory_order_acq_rel)};
  }
  /// Setting thread: destroys the engagement that the servo thread has left.
  void collect() {
    std::unique_ptr<Engagement> left{left_.exchange(nullptr, std::memory_order_acq_rel)};
  }
  /// Servo thread, at a tick boundary: adopts a new engagement if there is one. Returns whether it
  /// did.
  bool adopt() HAPTICS_RT {
    if (next_.load(std::memory_order_relaxed) == nullptr) return false;
    if (current_ != nullptr && left_.load(std::memory_order_acquire) != nullptr) return false;
    Engagement* next = next_.exchange(nullptr, std::memory_order_acq_rel);
    if (next == nullptr) return false;
    if (current_ != nullptr) left_.store(current_, std::memory_order_release);
    current_ = next;
    return true;
  }
  /// Servo thread: the present engagement, or null.
  Engagement* current() HAPTICS_RT { return current_; }

 private:
  std::atomic<Engagement*> next_{nullptr};
  std::atomic<Engagement*> left_{nullptr};
  Engagement* current_ = nullptr;
};

}  // namespace haptics
