// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <memory>
#include <utility>

#include "haptics/core/realtime.h"
#include "haptics/scene/scene.h"
#include "haptics/servo/proxy.h"

namespace haptics {

/// A scene and the proxy that moves in it. Made and destroyed on the GUI's side, used on the
/// servo's.
struct Engagement {
  Engagement(std::shared_ptr<const Scene> adopted, const Pose& X_start)
      : scene{std::move(adopted)}, proxy{*scene, X_start} {}
  std::shared_ptr<const Scene> scene;
  Proxy proxy;
};

/// Hands engagements over whole, and back when the servo has left them. One setting thread, one
/// servo thread; neither waits. The servo keeps what it has while the last one it left has not
/// been collected.
class SceneHandOver {
 public:
  ~SceneHandOver() {
    delete next_.load();
    delete left_.load();
    delete current_;
  }
  /// Setting thread: the next one to adopt; one that was never adopted is destroyed.
  void offer(std::unique_ptr<Engagement> engagement) {
    collect();
    std::unique_ptr<Engagement> never_adopted{
        next_.exchange(engagement.release(), std::memory_order_acq_rel)};
  }
  /// Setting thread: destroys what the servo has left.
  void collect() {
    std::unique_ptr<Engagement> left{left_.exchange(nullptr, std::memory_order_acq_rel)};
  }
  /// Servo thread, at a tick boundary: true if there is a new one.
  bool adopt() HAPTICS_RT {
    if (next_.load(std::memory_order_relaxed) == nullptr) return false;
    if (current_ != nullptr && left_.load(std::memory_order_acquire) != nullptr) return false;
    Engagement* next = next_.exchange(nullptr, std::memory_order_acq_rel);
    if (next == nullptr) return false;
    if (current_ != nullptr) left_.store(current_, std::memory_order_release);
    current_ = next;
    return true;
  }
  /// Servo thread: the one in force, or null.
  Engagement* current() HAPTICS_RT { return current_; }

 private:
  std::atomic<Engagement*> next_{nullptr};
  std::atomic<Engagement*> left_{nullptr};
  Engagement* current_ = nullptr;
};

}  // namespace haptics
