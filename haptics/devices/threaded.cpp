// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/devices/threaded.h"

#include <pthread.h>
#include <sched.h>

#include <atomic>
#include <ctime>
#include <thread>

#include "haptics/core/latest_value.h"

namespace haptics {
namespace {

constexpr int kPriority = 79;                     // below the servo thread's
constexpr std::int64_t kConfirmedNs = 5'000'000;  // what no write has confirmed for so long is zero

std::int64_t monotonic() noexcept {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return std::int64_t{now.tv_sec} * 1'000'000'000 + now.tv_nsec;
}

/// What the transport's thread last saw.
struct Seen {
  DeviceReading reading;
  DeviceStatus status = DeviceStatus::NotReady;
  std::int64_t at_ns = 0;  ///< when the reading came
};

/// What the servo thread last wrote.
struct Wanted {
  Wrench wrench_B;
  std::int64_t at_ns = 0;
};

class Threaded final : public Device {
 public:
  Threaded(std::unique_ptr<Transport> transport, const DeviceRating& rating,
           std::chrono::milliseconds fresh)
      : transport_{std::move(transport)}, rating_{rating}, fresh_ns_{fresh.count() * 1'000'000} {
    thread_ = std::thread{[this] { run(); }};
  }
  ~Threaded() override {
    stop();
    ending_.store(true, std::memory_order_relaxed);
    thread_.join();
  }

  const DeviceRating& rating() const noexcept override { return rating_; }

  DeviceStatus read(DeviceReading& reading) noexcept override {
    seen_.take(last_);
    if (last_.status == DeviceStatus::Lost) {
      reading.trouble = last_.reading.trouble;
      return DeviceStatus::Lost;
    }
    reading = last_.reading;
    if (last_.status == DeviceStatus::NotReady) return DeviceStatus::NotReady;
    const bool old = fresh_ns_ > 0 && monotonic() - last_.at_ns > fresh_ns_;
    return old ? DeviceStatus::Stale : DeviceStatus::Ok;
  }

  DeviceStatus write(const Wrench& wrench_B) noexcept override {
    wanted_.publish({wrench_B, monotonic()});
    return last_.status == DeviceStatus::Lost ? DeviceStatus::Lost : DeviceStatus::Ok;
  }

  void stop() noexcept override { stopped_.store(true, std::memory_order_release); }
  void resume() noexcept override { stopped_.store(false, std::memory_order_release); }

 private:
  void run() {
    const sched_param parameters{.sched_priority = kPriority};
    pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameters);
    Wanted wanted;
    Seen seen;
    FailedPolls polls;
    while (!ending_.load(std::memory_order_relaxed)) {
      wanted_.take(wanted);
      const bool zero = stopped_.load(std::memory_order_acquire) ||
                        monotonic() - wanted.at_ns > kConfirmedNs ||
                        !wanted.wrench_B.force.allFinite() || !wanted.wrench_B.torque.allFinite();
      const DeviceStatus status =
          transport_->exchange(zero ? Wrench{} : wanted.wrench_B, seen.reading);
      if (status == DeviceStatus::Stale) {
        if (polls.failed() == DeviceStatus::Lost) {
          seen.status = DeviceStatus::Lost;
          seen.reading.trouble = Trouble::Lost;
        }
      } else {
        polls.succeeded();
        seen.status = status;
        seen.at_ns = monotonic();
        if (status == DeviceStatus::Lost && seen.reading.trouble == Trouble::None)
          seen.reading.trouble = Trouble::Lost;
      }
      seen_.publish(seen);
      if (seen.status == DeviceStatus::Lost) break;
    }
    // zero is the last word, and a thread that has nothing to ask for waits for its end
    DeviceReading ignored;
    transport_->exchange(Wrench{}, ignored);
  }

  std::unique_ptr<Transport> transport_;
  const DeviceRating rating_;
  const std::int64_t fresh_ns_;
  LatestValue<Seen> seen_;
  LatestValue<Wanted> wanted_;
  Seen last_;  ///< the servo thread's copy
  std::atomic<bool> stopped_{false};
  std::atomic<bool> ending_{false};
  std::thread thread_;
};

}  // namespace

std::unique_ptr<Device> threaded(std::unique_ptr<Transport> transport, const DeviceRating& rating,
                                 std::chrono::milliseconds fresh) {
  return std::make_unique<Threaded>(std::move(transport), rating, fresh);
}

}  // namespace haptics
