// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/simulation/simulated.h"

#include <atomic>
#include <utility>

namespace haptics {
namespace {

/// A grip under a force, pulled along by whoever knows where the hand is.
class Gripped : public Device {
 public:
  Gripped(Grip grip, double period) : grip_{std::move(grip)}, period_{period} {}
  const DeviceRating& rating() const noexcept override { return rating_; }
  DeviceStatus read(DeviceReading& reading) noexcept override {
    grip_.advance(target(), stopped_.load(std::memory_order_relaxed) ? Wrench{} : felt_, period_);
    reading.X_BD = grip_.X_WD;
    return DeviceStatus::Ok;
  }
  DeviceStatus write(const Wrench& wrench_B) noexcept override {
    felt_ = wrench_B;
    return DeviceStatus::Ok;
  }
  void fit(double gyration) noexcept override { grip_.gyration = gyration; }
  void stop() noexcept override { stopped_.store(true, std::memory_order_relaxed); }
  void resume() noexcept override { stopped_.store(false, std::memory_order_relaxed); }

 protected:
  void rest(const Pose& X_BD) noexcept {
    grip_.X_WD = X_BD;
    grip_.velocity = {};
    felt_ = {};
  }

 private:
  virtual Pose target() noexcept = 0;

  const DeviceRating rating_ = *findRating("sigma.7");
  Grip grip_;
  double period_;
  Wrench felt_;
  std::atomic<bool> stopped_{false};
};

class Simulated final : public Gripped {
 public:
  Simulated(Hand hand, Grip grip, double period)
      : Gripped{std::move(grip), period}, hand_{std::move(hand)}, period_{period} {}

 private:
  Pose target() noexcept override { return hand_.at(double(reads_++) * period_); }

  Hand hand_;
  double period_;
  std::uint64_t reads_ = 0;
};

class Mouse final : public Gripped {
 public:
  Mouse(LatestValue<Pose>& target, Grip grip, double period)
      : Gripped{grip, period}, targets_{target}, X_WH_{grip.X_WD} {}
  void place(const Pose& X_BD, const Pose& X_pull) noexcept override {
    targets_.take(X_WH_);  // the hand is not where it pointed before
    X_WH_ = X_pull;
    rest(X_BD);
  }

 private:
  Pose target() noexcept override {
    targets_.take(X_WH_);
    return X_WH_;
  }

  LatestValue<Pose>& targets_;
  Pose X_WH_;
};

}  // namespace

std::unique_ptr<Device> openSimulated(Hand hand, Grip grip, double period) {
  grip.X_WD = hand.at(0.0);
  return std::make_unique<Simulated>(std::move(hand), std::move(grip), period);
}

std::unique_ptr<Device> openMouse(LatestValue<Pose>& target, Grip grip, double period) {
  return std::make_unique<Mouse>(target, std::move(grip), period);
}

}  // namespace haptics
