// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>

#include "haptics/core/error.h"
#include "haptics/core/geometry.h"
#include "haptics/scene/scene.h"
#include "haptics/servo/rate.h"
#include "haptics/settings.h"
#include "haptics/snapshot.h"

namespace haptics {

class Cutting;
class Device;
class StepRing;
struct BurrCut;
struct Watch;

/// The hand that holds the device.
enum class HandKind {
  Mouse,  ///< follows Session::pull through a spring of its own
  Tap,    ///< the simulated hand, which repeats one of its motions
  Slide,
  Wedge,
  Pry,
  Hook,
  Jerk,
  Twist
};

/// A device, its servo thread, and the exchange with the window.
///
/// All calls come from the GUI thread. Only close() and the destructor wait for the servo thread.
/// There are ticks only while a hand is open, and contacts only after a scene was adopted.
class Session {
 public:
  Session();
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  /// Opens the device of this hand and starts the servo loop, instead of an open one. The simulated
  /// hands aim at the current scene. Refused without a scene, if the hand finds no surface, and if
  /// there is no legal pose; an open hand then goes on.
  /// `from`: the simulated hand aims from this pose along the tool's tip instead of choosing a
  /// place itself; the mouse starts there.
  Expected<void> open(HandKind hand, const std::optional<Pose>& from = {});
  /// Opens a real device instead of an open one. There is no force until arm(). A watchdog and a
  /// motion guard watch the device, and `handle` maps its motion. Refused as above; an open hand
  /// then goes on, and the device is closed.
  Expected<void> open(std::unique_ptr<Device> device);
  /// Stops the loop with the force at zero.
  void close();
  bool isOpen() const;

  /// Hands over a scene; the servo thread adopts it at a tick boundary, with the force ramping
  /// from zero. The old one is destroyed here, by collectGarbage(), once the servo has left it.
  /// `with_hand`: in that tick the mouse comes along, as it does in bring().
  void adopt(std::shared_ptr<const Scene> scene, const Pose& start_W, bool with_hand = false);
  void collectGarbage();
  /// Brings the tool to a pose in the present scene, with the force ramping from zero. The mouse
  /// comes along and pulls to X_WH from there; a real device stays where it is, and its mapping
  /// moves. The tool must be legal at X_WT. Without an open hand, the next one starts there.
  void bring(const Pose& X_WT, const Pose& X_WH);

  /// Lets the tool cut in the present scene from now on, for every hand: what was made of that
  /// scene, in place of what cut there before and must not have cut yet. Of another scene it is
  /// destroyed. It ends with the scene.
  void cut(std::unique_ptr<Cutting> cutting);
  /// The burr's key is down, or up. Down, it counts for a quarter of a second: say it at display
  /// rate.
  void holdCut(bool down);
  /// The burr rests, in every hand, whatever key or button is held. Afterwards that must be
  /// released before it turns again.
  void restCut(bool rests);
  /// Whether it has taken effect: no cut is begun any more that cuts() did not tell.
  bool cutRests() const;
  /// Moves cuts that were begun, oldest first, into `cuts`; returns how many.
  std::size_t cuts(std::span<BurrCut> cuts);
  /// The present scene with the cuts that were made in it, and so with its id: what is opened or
  /// brought from now on is placed by it.
  void renew(std::shared_ptr<const Scene> scene);

  void set(const Settings& settings);
  /// The settings that the servo thread uses and a recording stores: those of set(), with the
  /// stiffness at the hand, force_scale included, lowered to allowedStiffness of the open device
  /// or, for other hands, of their grip.
  Settings inForce() const;
  /// Allows a real device the whole stiffness of its rating, although the loop may shake, until the
  /// device is closed or another is opened.
  void liftStiffness(bool lifted);
  /// The servo loop's rate of hands that are opened from now on: this one, but for a real device no
  /// more than its link carries. None: 1 kHz, and for a real device the most that its link carries.
  /// A rate needs the processor as often as it has ticks.
  void chooseRate(std::optional<ServoRate> rate);
  /// The rate of the open hand; without one, of the mouse.
  ServoRate rate() const;
  /// Sets how a real device is held, from the next tick on.
  void handle(const Handling& handling);
  /// Sets the pose to which the mouse pulls the tool, W.
  void pull(const Pose& X_WH);

  /// Measures the tool's distance to these structures in every tick, from the next one on and for
  /// every hand and scene; null ends that.
  void watch(std::shared_ptr<const Watch> watch);

  /// Zero force from the next tick on, for every hand and scene, until arm(). A fault has the same
  /// effect.
  void forceOff();
  void arm();

  /// Puts every tick into this ring, from the next one on and for every hand and scene; null ends
  /// that. Every scene must be described to the ring's recorder before it is adopted.
  void record(std::shared_ptr<StepRing> ring);
  /// Whether the servo thread no longer uses the previous ring: true two ticks after record().
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
