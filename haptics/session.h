// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <span>
#include <string>

#include "haptics/core/error.h"
#include "haptics/core/geometry.h"
#include "haptics/scene/scene.h"
#include "haptics/settings.h"
#include "haptics/snapshot.h"

namespace haptics {

class Device;
class StepRing;

/// Which hand holds the device.
enum class HandKind {
  Mouse,  ///< follows Session::pull through a spring of its own
  Tap,    ///< the simulated hand, in one of its motions, over and over
  Slide,
  Wedge,
  Pry,
  Hook,
  Jerk,
  Twist
};

/// A device, a servo thread and what passes between them and the window.
///
/// All calls come from one thread, the GUI's; none of them waits for the servo thread except
/// close() and the destructor. There is a tick only while a hand is open; it touches something
/// only once a scene was adopted.
class Session {
 public:
  Session();
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  /// Opens the device that this hand holds and starts the servo loop in place of an open one. The
  /// simulated hands aim at the current scene. Refused without a scene, where a hand finds no
  /// surface, and where the tool has no room; an open hand then goes on.
  Expected<void> open(HandKind hand);
  /// Opens a real device in place of what is open: no force until arm(); watched by a watchdog, its
  /// motion guarded, and mapped by `handle`. Refused as above; what was open then goes on, and the
  /// device is closed.
  Expected<void> open(std::unique_ptr<Device> device);
  /// Stops the loop with the force at zero.
  void close();
  bool isOpen() const;

  /// Hands over a scene; the servo thread adopts it at a tick boundary, with the force ramping
  /// from zero. The old one is destroyed here, by collectGarbage(), once the servo has left it.
  void adopt(std::shared_ptr<const Scene> scene, const Pose& start_W);
  void collectGarbage();

  void set(const Settings& settings);
  /// What they came to under what is allowed to the real device that is open (allowedStiffness),
  /// and for any other hand to the grip that holds it: stiffness at the hand no more than that,
  /// force_scale taken into it. The servo's and the recording's settings.
  Settings inForce() const;
  /// Lets a real device have all that its maker rates it for, though the loop may shake; until it
  /// is closed, or another is opened.
  void liftStiffness(bool lifted);
  /// How a real device is held from the next tick on.
  void handle(const Handling& handling);
  /// Where the mouse wants the tool to be, W.
  void pull(const Pose& X_WH);

  /// Zero force from the next tick on, through every hand and scene, until arm(). A fault does the
  /// same by itself.
  void forceOff();
  void arm();

  /// Every tick goes into this ring from the next one on, through every hand and scene; null: no
  /// more. Scenes must have been described to the ring's recorder before they are adopted.
  void record(std::shared_ptr<StepRing> ring);
  /// Whether the servo thread has left the ring that was taken away last: two ticks later.
  bool hasLeftRing() const;

  /// Replaces `snapshot` and returns true if there is a newer one.
  bool latest(Snapshot& snapshot);
  /// Moves transitions of the force, each of them once, oldest first, into `transitions`; returns
  /// how many.
  std::size_t transitions(std::span<ForceTransition> transitions);
  /// Moves force samples, one a tick, oldest first, into `samples`; returns how many.
  std::size_t forces(std::span<ForceSample> samples);

 private:
  class Loop;
  std::unique_ptr<Loop> loop_;
};

}  // namespace haptics
