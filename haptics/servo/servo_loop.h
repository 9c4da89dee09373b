// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <readerwriterqueue/readerwriterqueue.h>

#include <atomic>
#include <memory>
#include <thread>

#include "haptics/core/latest_value.h"
#include "haptics/coupling/safety.h"
#include "haptics/devices/device.h"
#include "haptics/scene/watch.h"
#include "haptics/servo/engagement.h"
#include "haptics/servo/mapping.h"
#include "haptics/servo/motion_guard.h"
#include "haptics/servo/pose_predictor.h"
#include "haptics/servo/rate.h"
#include "haptics/servo/servo_tick.h"
#include "haptics/servo/step_ring.h"
#include "haptics/servo/tick_stats.h"
#include "haptics/servo/watchdog.h"
#include "haptics/settings.h"
#include "haptics/snapshot.h"

namespace haptics {

/// The servo thread reads the device, runs a tick and writes the device, once in each period of its
/// rate: at absolute times, or, where the device is in step, when a reading comes. It asks for
/// real-time priority and reports the one it got. Missed periods are counted, not repeated.
class ServoLoop {
 public:
  /// For a device without motors: its base B is W, and it has no watchdog and no guard.
  ServoLoop(std::unique_ptr<Device> device, const Settings& initial, bool arm = true,
            ServoRate rate = {});
  /// For a real device, not armed: with watchdog, guard, and a mapping that takes its first pose to
  /// X_WD. `heat`: heat() of the device's previous loop.
  ServoLoop(std::unique_ptr<Device> device, const Settings& initial, const Pose& X_WD,
            double heat = 0.0, ServoRate rate = {});
  ~ServoLoop();  ///< calls end()
  /// Sets the force to zero and ends the thread.
  void end();
  /// Heat of the motors; 1 is the heat that they stand without a time limit. Call after end().
  double heat() const { return safety_.memory().heat; }

  // For the setting thread; none of these calls waits.
  LatestValue<Settings> settings;
  LatestValue<Handling> handling;
  LatestValue<Snapshot> snapshots;
  moodycamel::ReaderWriterQueue<ForceSample> forces{8192};
  moodycamel::ReaderWriterQueue<ForceTransition> transitions{1024};
  static constexpr std::size_t kMostCuts = 16'384;
  /// Cuts as they began. Who has no room for more lets no burr turn.
  moodycamel::ReaderWriterQueue<BurrCut> cuts{kMostCuts};
  SceneHandOver scenes;
  std::atomic<bool> armed;  ///< false: zero force from the next tick on
  /// Ring that receives the steps from the next tick on; null: no recording. The ring must live
  /// until `boundary` has grown by two after another value was set, or until the loop has ended.
  std::atomic<StepRing*> recording{nullptr};
  /// Structures to which the proxy's distance is measured, from the next tick on; null: none. It
  /// must live as long as a ring.
  std::atomic<const Watch*> watch{nullptr};
  /// Until then the key of the burr counts as down, by the watchdog's clock [ns]: a window that
  /// hangs does not say it again. 0: it was released.
  std::atomic<std::int64_t> cut_until{0};
  /// The burr rests, whatever is held. Afterwards it must be released before it turns.
  std::atomic<bool> cut_rests{false};
  std::atomic<std::uint64_t> boundary{0};  ///< completed ticks

  /// Starts the thread.
  void start();

  /// The work of one period. `time` [s]: when the tick was due, since the start. `now` [ns]: time
  /// of the watchdog's clock. Public for tests.
  void step(double time, std::int64_t now) HAPTICS_RT;
  /// The same, with a watchdog's clock that advances with `time`.
  void step(double time) HAPTICS_RT { step(time, 1 + std::int64_t(time * 1e9)); }

 private:
  /// Protects the hand at a real device.
  struct Guard {
    Guard(Device& device, const Pose& X_WD, ServoRate rate)
        : watchdog{device},
          lead{device.rating().lead, device.rating().resolution},
          mapping{X_WD, rate.period()} {}
    Watchdog watchdog;
    MotionGuard motion;
    PosePredictor lead;
    Mapping mapping;
    Handling handling;
    std::int64_t silent_ns = 0;   ///< when the last reading first came again; 0: it is new
    std::int64_t handled_ns = 0;  ///< when `handling` was received
  };

  /// The data of one period.
  struct Period {
    std::uint16_t flags = 0;        ///< StepFlags
    Engagement* engaged = nullptr;  ///< scene and proxy; null: no scene, or the device is lost
    StepRing* ring = nullptr;       ///< null: not recorded
    const Watch* watch = nullptr;   ///< structures that are watched; null: none
    std::int64_t read_at = 0;       ///< ns, monotonic; set only if recorded
    std::int64_t cpu_ns = 0;

    bool has(std::uint16_t flag) const HAPTICS_RT { return (flags & flag) != 0; }
    void raise(std::uint16_t flag, bool is) HAPTICS_RT {
      if (is) flags = static_cast<std::uint16_t>(flags | flag);
    }
  };

  void run();
  /// Waits for the next tick, due at `due` [ns], and returns when it was due: in step with a
  /// device, when its reading came. One that does not come by a quarter of a period is not waited
  /// for.
  std::int64_t awaitTick(std::int64_t due);
  /// Takes new settings, handling and scene, and the watchdog's beat.
  Period takeWishes(std::int64_t now) HAPTICS_RT;
  void readDevice(Period& period, std::int64_t now) HAPTICS_RT;
  /// Whether the burr turns: its key or button is held, was released since the last start, scene,
  /// rest, gap or fault, the force is on, and somebody takes the cuts and steps.
  void judgeCut(Period& period, std::int64_t now) HAPTICS_RT;
  ServoResult feel(Period& period, Budget& budget) HAPTICS_RT;
  void push(const Wrench& sent_W, const Period& period) HAPTICS_RT;
  void noteTransitions(double time) HAPTICS_RT;
  void publish(const Period& period, const ServoResult& result, double time) HAPTICS_RT;
  /// Puts the distances to the watched structures into the snapshot.
  void measureNearness(const Period& period) HAPTICS_RT;
  /// Puts the places of the contacts into the snapshot.
  void notePlaces(const Proxy& proxy) HAPTICS_RT;
  void startRecording(StepRing& ring, Engagement* touched) HAPTICS_RT;
  void record(const Period& period, const Budget& budget) HAPTICS_RT;

  std::unique_ptr<Device> device_;
  const ServoRate rate_;
  Settings in_force_;
  Safety safety_;
  TickStats stats_;
  Snapshot snapshot_;
  DeviceReading reading_;
  bool lost_ = false;               ///< the device is lost permanently
  const Watch* watched_ = nullptr;  ///< in the last tick
  bool felt_ = false;               ///< some of its structures
  bool may_cut_ = false;            ///< the burr's key was released
  Pose X_WD_ = Pose::Identity();
  std::unique_ptr<Guard> guard_;  ///< null: not a real device
  Step step_;
  std::atomic<bool> ending_{false};
  std::thread thread_;
};

}  // namespace haptics
