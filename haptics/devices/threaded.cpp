// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/devices/threaded.h"

#include <pthread.h>
#include <sched.h>

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "haptics/devices/relay.h"
#include "haptics/devices/rendezvous.h"

namespace haptics {
namespace {

constexpr int kPriority = 79;                             // below the servo thread's
constexpr std::chrono::microseconds kShortestRound{250};  // a transport that never waits
constexpr std::chrono::seconds kHung{2};  // not even a machine that is very busy takes so long

/// What the device and the transport's thread share, and who ends last destroys.
class Exchanges {
 public:
  Exchanges(std::unique_ptr<Transport> transport, std::chrono::milliseconds fresh, bool in_step)
      : relay{fresh, kHung}, transport_{std::move(transport)}, in_step_{in_step} {}

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
    relay.stop();
    ending_.store(true, std::memory_order_relaxed);
    std::unique_lock lock{mutex_};
    return ends_.wait_for(lock, kHung, [this] { return ended_; });
  }

  Relay relay;
  Rendezvous rendezvous;

 private:
  void exchangeUntilTheEnd() {
    DeviceReading reading;
    bool goes_on = true;
    while (goes_on && !ending_.load(std::memory_order_relaxed)) {
      const auto begun = std::chrono::steady_clock::now();
      const DeviceStatus status = transport_->exchange(relay.due(), reading);
      goes_on = relay.came(status, reading);
      const bool answered =
          in_step_ && goes_on && status != DeviceStatus::Stale &&
          rendezvous.readingCame(std::chrono::nanoseconds{kShortestRound}.count());
      if (!answered) std::this_thread::sleep_until(begun + kShortestRound);
    }
  }

  std::unique_ptr<Transport> transport_;
  const bool in_step_;
  std::atomic<bool> ending_{false};
  std::mutex mutex_;  ///< of ended_
  std::condition_variable ends_;
  bool ended_ = false;
};

class Threaded final : public Device {
 public:
  Threaded(std::unique_ptr<Transport> transport, const DeviceRating& rating,
           std::chrono::milliseconds fresh, bool in_step)
      : rating_{rating},
        in_step_{in_step},
        shared_{std::make_shared<Exchanges>(std::move(transport), fresh, in_step)},
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
    return shared_->relay.read(reading);
  }
  DeviceStatus write(const Wrench& wrench_B) noexcept override {
    const DeviceStatus status = shared_->relay.write(wrench_B);
    shared_->rendezvous.answer();
    return status;
  }
  bool inStep() const noexcept override { return in_step_; }
  std::int64_t awaitReading(std::int64_t until_ns) noexcept override {
    return shared_->rendezvous.awaitReading(until_ns);
  }
  void stop() noexcept override { shared_->relay.stop(); }
  void resume() noexcept override { shared_->relay.resume(); }

 private:
  const DeviceRating rating_;
  const bool in_step_;
  std::shared_ptr<Exchanges> shared_;
  std::thread thread_;
};

}  // namespace

std::unique_ptr<Device> threaded(std::unique_ptr<Transport> transport, const DeviceRating& rating,
                                 std::chrono::milliseconds fresh, bool in_step) {
  return std::make_unique<Threaded>(std::move(transport), rating, fresh, in_step);
}

}  // namespace haptics
