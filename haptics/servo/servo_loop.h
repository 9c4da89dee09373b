// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <readerwriterqueue/readerwriterqueue.h>

#include <atomic>
#include <memory>
#include <thread>

#include "haptics/core/latest_value.h"
#include "haptics/coupling/safety.h"
#include "haptics/devices/device.h"
#include "haptics/servo/engagement.h"
#include "haptics/servo/mapping.h"
#include "haptics/servo/motion_guard.h"
#include "haptics/servo/servo_tick.h"
#include "haptics/servo/step_ring.h"
#include "haptics/servo/tick_stats.h"
#include "haptics/servo/watchdog.h"
#include "haptics/settings.h"
#include "haptics/snapshot.h"

namespace haptics {

/// The servo thread: read the device, tick, write the device, a thousand times a second at
/// absolute times. Takes real-time priority where it is granted and says which it got. A period
/// that was missed is counted and not made up for.
class ServoLoop {
 public:
  static constexpr double kPeriod = 1e-3;               ///< s
  static constexpr std::int64_t kTickBudget = 200'000;  ///< ns of CPU for the proxy

  /// A device without motors that can hurt: its base is the world, and nothing watches it.
  ServoLoop(std::unique_ptr<Device> device, const Settings& initial, bool arm = true);
  /// A real one, not armed: watched, guarded, and mapped so that its first pose is X_WD. `heat`:
  /// its motors', as an earlier loop left them.
  ServoLoop(std::unique_ptr<Device> device, const Settings& initial, const Pose& X_WD,
            double heat = 0.0);
  ~ServoLoop();  ///< as end()
  /// Ends the thread, with the force at zero.
  void end();
  /// Of the motors: 1 is what they stand for ever. Once it has ended.
  double heat() const { return safety_.memory().heat; }

  // The other thread's side; none of these waits.
  LatestValue<Settings> settings;
  LatestValue<Handling> handling;
  LatestValue<Snapshot> snapshots;
  moodycamel::ReaderWriterQueue<ForceSample> forces{8192};
  moodycamel::ReaderWriterQueue<ForceTransition> transitions{1024};
  SceneHandOver scenes;
  std::atomic<bool> armed;  ///< false: zero force from the next tick on
  /// Where steps go from the next tick on; null: nowhere. The ring outlives its use: it is left
  /// once `boundary` has grown by two since another was set, or the loop has ended.
  std::atomic<StepRing*> recording{nullptr};
  std::atomic<std::uint64_t> boundary{0};  ///< ticks that are over

  /// Starts the thread.
  void start();

  /// One period's work, of the tick that was due at `time` [s] since the start, at `now` of the
  /// watchdog's clock [ns]. Public for tests.
  void step(double time, std::int64_t now) HAPTICS_RT;
  /// The same, with a clock that keeps time with the ticks.
  void step(double time) HAPTICS_RT { step(time, 1 + std::int64_t(time * 1e9)); }

 private:
  /// What guards a real device's hand.
  struct Guard {
    Guard(Device& device, const Pose& X_WD) : watchdog{device}, mapping{X_WD} {}
    Watchdog watchdog;
    MotionGuard motion;
    Mapping mapping;
    Handling handling;
    int silent = 0;               ///< readings in a row that told nothing new
    std::int64_t handled_ns = 0;  ///< when `handling` came
  };

  /// One period, from the wishes it began with to what it came to.
  struct Period {
    std::uint16_t flags = 0;        ///< StepFlags
    Engagement* engaged = nullptr;  ///< what is touched; null: nothing, or the device is lost
    StepRing* ring = nullptr;       ///< null: not recorded
    std::int64_t read_at = 0;       ///< ns, monotonic; only where recorded
    std::int64_t cpu_ns = 0;

    bool has(std::uint16_t flag) const HAPTICS_RT { return (flags & flag) != 0; }
    void raise(std::uint16_t flag, bool is) HAPTICS_RT {
      if (is) flags = static_cast<std::uint16_t>(flags | flag);
    }
  };

  void run();
  /// What others want of the servo thread since the last period, and what the watchdog saw.
  Period takeWishes(std::int64_t now) HAPTICS_RT;
  void readDevice(Period& period, std::int64_t now) HAPTICS_RT;
  ServoResult feel(Period& period, Budget& budget) HAPTICS_RT;
  void push(const Wrench& sent_W, const Period& period) HAPTICS_RT;
  void noteTransitions(double time) HAPTICS_RT;
  void publish(const Period& period, const ServoResult& result, double time) HAPTICS_RT;
  void startRecording(StepRing& ring, Engagement* touched) HAPTICS_RT;
  void record(const Period& period, const Budget& budget) HAPTICS_RT;

  std::unique_ptr<Device> device_;
  Settings in_force_;
  Safety safety_;
  TickStats stats_;
  Snapshot snapshot_;
  DeviceReading reading_;
  bool lost_ = false;  ///< the device is gone for good
  Pose X_WD_ = Pose::Identity();
  std::unique_ptr<Guard> guard_;  ///< null: not a real device
  Step step_;
  std::atomic<bool> ending_{false};
  std::thread thread_;
};

}  // namespace haptics
