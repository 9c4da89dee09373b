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
  /// The scene from before a cutting was taken: no servo thread destroys one.
  std::shared_ptr<const Scene> uncut = {};
  /// The mouse's grip comes along to the proxy's pose, and the mouse pulls to this one; none: it
  /// stays. A real device always stays: its mapping moves.
  std::optional<Pose> X_WH = {};
};

/// Hands engagements to the servo thread, and back after use, and what cuts in them. There is one
/// setting thread and one servo thread; neither waits. The servo thread adopts no new engagement
/// until the setting thread has collected the one that the servo thread left last.
class SceneHandOver {
 public:
  ~SceneHandOver() {
    delete next_.load();
    delete left_.load();
    delete cutting_.load();
    delete cutting_left_.load();
    delete waiting_;
    delete current_;
  }
  /// Setting thread: offers the next engagement. An earlier offer that was not adopted is
  /// destroyed.
  void offer(std::unique_ptr<Engagement> engagement) {
    collect();
    std::unique_ptr<Engagement> never_adopted{
        next_.exchange(engagement.release(), std::memory_order_acq_rel)};
  }
  /// Setting thread: offers what cuts in the engagement of the same scene, from then on. An earlier
  /// offer that was not taken is destroyed.
  void offer(std::unique_ptr<Cutting> cutting) {
    std::unique_ptr<Cutting> never_taken{
        cutting_.exchange(cutting.release(), std::memory_order_acq_rel)};
  }
  /// Setting thread: destroys what the servo thread has left.
  void collect() {
    std::unique_ptr<Engagement> left{left_.exchange(nullptr, std::memory_order_acq_rel)};
    std::unique_ptr<Cutting> cutting{cutting_left_.exchange(nullptr, std::memory_order_acq_rel)};
  }
  /// Servo thread, at a tick boundary: adopts a new engagement if there is one. Returns whether it
  /// did.
  bool adopt() HAPTICS_RT {
    if (next_.load(std::memory_order_relaxed) == nullptr) return false;
    if (current_ != nullptr && left_.load(std::memory_order_acquire) != nullptr) return false;
    Engagement* next = next_.exchange(nullptr, std::memory_order_acq_rel);
    if (next == nullptr) return false;
    if (current_ != nullptr) {
      // the tool is brought elsewhere in the scene that it has cut
      const bool same = current_->scene->id == next->scene->id;
      if (same && current_->cutting && !next->cutting) {
        current_->cutting->forget();
        std::swap(current_->cutting, next->cutting);
        std::swap(current_->scene, next->scene);
      }
      left_.store(current_, std::memory_order_release);
    }
    current_ = next;
    return true;
  }
  /// Servo thread, at a tick boundary: takes what cuts in the present scene if it was offered, in
  /// place of what did, which must not have cut. Its voxels and bounds are those of the scene, so
  /// the proxy knows nothing wrong.
  void takeCutting() HAPTICS_RT {
    if (cutting_.load(std::memory_order_relaxed) != nullptr &&
        (waiting_ == nullptr || cutting_left_.load(std::memory_order_acquire) == nullptr)) {
      // what did not fit is destroyed by collect()
      Cutting* const misfit =
          std::exchange(waiting_, cutting_.exchange(nullptr, std::memory_order_acq_rel));
      if (misfit != nullptr) cutting_left_.store(misfit, std::memory_order_release);
    }
    if (waiting_ == nullptr || current_ == nullptr || waiting_->scene()->id != current_->scene->id)
      return;
    if (current_->cutting && cutting_left_.load(std::memory_order_acquire) != nullptr) return;
    if (!current_->cutting) current_->uncut = current_->scene;
    Cutting* const left = current_->cutting.release();
    current_->cutting.reset(std::exchange(waiting_, nullptr));
    // while the one that is left has its scene yet: no scene is destroyed here
    current_->scene = current_->cutting->scene();
    if (left != nullptr) cutting_left_.store(left, std::memory_order_release);
  }
  /// When the servo thread has ended: what cuts in a scene, or was offered for it last; null:
  /// nothing does.
  std::unique_ptr<Cutting> release(std::uint64_t scene) {
    std::unique_ptr<Cutting> offered{cutting_.exchange(nullptr)};
    std::unique_ptr<Cutting> waiting{std::exchange(waiting_, nullptr)};
    Engagement* const next = next_.load();
    for (std::unique_ptr<Cutting>* one :
         {&offered, &waiting, current_ == nullptr ? nullptr : &current_->cutting,
          next == nullptr ? nullptr : &next->cutting})
      if (one != nullptr && *one && (*one)->scene()->id == scene) return std::move(*one);
    return nullptr;
  }
  /// Servo thread: the present engagement, or null.
  Engagement* current() HAPTICS_RT { return current_; }

 private:
  std::atomic<Engagement*> next_{nullptr};
  std::atomic<Engagement*> left_{nullptr};
  std::atomic<Cutting*> cutting_{nullptr};  ///< offered
  std::atomic<Cutting*> cutting_left_{nullptr};
  Cutting* waiting_ = nullptr;  ///< the servo thread's: of a scene that it has not adopted
  Engagement* current_ = nullptr;
};

}  // namespace haptics
