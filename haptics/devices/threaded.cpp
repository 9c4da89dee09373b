// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/devices/threaded.h"

#include <pthread.h>
#include <sched.h>

#include <atomic>
#include <condition_variable>
#include <ctime>
#include <mutex>
#include <thread>

#include "haptics/core/latest_value.h"

namespace haptics {
namespace {

constexpr int kPriority = 79;                     // below the servo thread's
constexpr std::int64_t kConfirmedNs = 5'000'000;  // what no write has confirmed for so long is zero
constexpr std::chrono::microseconds kShortestRound{250};  // a transport that never waits
constexpr std::chrono::seconds kHung{2};  // not even a machine that is very busy takes so long

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

/// What the device and the transport's thread share, and who ends last destroys.
class Exchanges {
 public:
  explicit Exchanges(std::unique_ptr<Transport> transport) : transport_{std::move(transport)} {}

  /// The transport's thread, from its begin to its end.
  void run() {
    const sched_param parameters{.sched_priority = kPriority};
    pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameters);
    exchangeUntilTheEnd();
    // zero is the last word, and a thread that has nothing to ask for waits for its end
    DeviceReading ignored;
    transport_->exchange(Wrench{}, ignored);
    transport_.reset();
    const std::lock_guard lock{mutex_};
    ended_ = true;
    ends_.notify_one();
  }

  /// Asks it to end, and waits for that. False: an exchange hangs.
  bool end() {
    stopped.store(true, std::memory_order_release);
    ending_.store(true, std::memory_order_relaxed);
    std::unique_lock lock{mutex_};
    return ends_.wait_for(lock, kHung, [this] { return ended_; });
  }

  LatestValue<Seen> seen;
  LatestValue<Wanted> wanted;
  std::atomic<bool> stopped{false};
  std::atomic<std::int64_t> begun_ns{monotonic()};  ///< when the exchange began that is under way

 private:
  void exchangeUntilTheEnd() {
    Wanted newest;
    Seen last;
    FailedPolls polls;
    while (!ending_.load(std::memory_order_relaxed) && last.status != DeviceStatus::Lost) {
      const auto begun = std::chrono::steady_clock::now();
      begun_ns.store(monotonic(), std::memory_order_relaxed);
      // in this order: whoever sees the resume() sees that it took back what was written before
      const bool stop_said = stopped.load(std::memory_order_acquire);
      wanted.take(newest);
      const bool zero = stop_said || last.status != DeviceStatus::Ok ||
                        monotonic() - newest.at_ns > kConfirmedNs ||
                        !newest.wrench_B.force.allFinite() || !newest.wrench_B.torque.allFinite();
      const DeviceStatus status =
          transport_->exchange(zero ? Wrench{} : newest.wrench_B, last.reading);
      if (status == DeviceStatus::Stale) {
        if (polls.failed() == DeviceStatus::Lost) {
          last.status = DeviceStatus::Lost;
          last.reading.trouble = Trouble::Lost;
        }
      } else {
        polls.succeeded();
        last.status = status;
        last.at_ns = monotonic();
      }
      if (last.status == DeviceStatus::Lost && last.reading.trouble == Trouble::None)
        last.reading.trouble = Trouble::Lost;
      seen.publish(last);
      std::this_thread::sleep_until(begun + kShortestRound);
    }
  }

  std::unique_ptr<Transport> transport_;
  std::atomic<bool> ending_{false};
  std::mutex mutex_;  ///< of ended_
  std::condition_variable ends_;
  bool ended_ = false;
};

class Threaded final : public Device {
 public:
  Threaded(std::unique_ptr<Transport> transport, const DeviceRating& rating,
           std::chrono::milliseconds fresh)
      : rating_{rating},
        fresh_ns_{fresh.count() * 1'000'000},
        shared_{std::make_shared<Exchanges>(std::move(transport))},
        thread_{[shared = shared_] { shared->run(); }} {}
  ~Threaded() override {
    if (shared_->end())
      thread_.join();
    else
      thread_.detach();
  }
  Threaded(const Threaded&) = delete;
  Threaded& operator=(const Threaded&) = delete;

  const DeviceRating& rating() const noexcept override { return rating_; }

  DeviceStatus read(DeviceReading& reading) noexcept override {
    shared_->seen.take(last_);
    if (last_.status != DeviceStatus::Lost && hangs()) {
      hung_ = true;
      last_.reading.trouble = Trouble::Lost;
    }
    if (lost()) {
      reading.trouble = last_.reading.trouble;
      return DeviceStatus::Lost;
    }
    reading = last_.reading;
    if (last_.status == DeviceStatus::NotReady) return DeviceStatus::NotReady;
    const bool old = fresh_ns_ > 0 && monotonic() - last_.at_ns > fresh_ns_;
    return old ? DeviceStatus::Stale : DeviceStatus::Ok;
  }

  DeviceStatus write(const Wrench& wrench_B) noexcept override {
    shared_->wanted.publish(lost() ? Wanted{} : Wanted{wrench_B, monotonic()});
    return lost() ? DeviceStatus::Lost : DeviceStatus::Ok;
  }

  void stop() noexcept override { shared_->stopped.store(true, std::memory_order_release); }
  void resume() noexcept override {
    if (!shared_->stopped.load(std::memory_order_relaxed)) return;
    shared_->wanted.publish({});
    shared_->stopped.store(false, std::memory_order_release);
  }

 private:
  bool hangs() const noexcept {
    return monotonic() - shared_->begun_ns.load(std::memory_order_relaxed) >
           std::chrono::nanoseconds{kHung}.count();
  }
  bool lost() const noexcept { return hung_ || last_.status == DeviceStatus::Lost; }

  const DeviceRating rating_;
  const std::int64_t fresh_ns_;
  Seen last_;  ///< the servo thread's copy
  bool hung_ = false;
  std::shared_ptr<Exchanges> shared_;
  std::thread thread_;
};

}  // namespace

std::unique_ptr<Device> threaded(std::unique_ptr<Transport> transport, const DeviceRating& rating,
                                 std::chrono::milliseconds fresh) {
  return std::make_unique<Threaded>(std::move(transport), rating, fresh);
}

}  // namespace haptics
