// SPDX-License-Identifier: BSD-3-Clause

// palpate-link: how late a force is over a link with a thread of its own, in step with the servo
// loop and not.

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <memory>
#include <numeric>
#include <string>
#include <thread>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/build_info/build_info.h"
#include "app/measurement/quantile.h"
#include "app/study/comparison/scenes.h"
#include "haptics/core/clock.h"
#include "haptics/devices/threaded.h"
#include "haptics/servo/servo_loop.h"
#include "haptics/simulation/hand.h"
#include "tests/bench/ticks.h"
#include "tests/support/passing_device.h"

namespace {

using haptics::DeviceReading;
using haptics::DeviceStatus;
using haptics::Wrench;
using Json = nlohmann::ordered_json;

constexpr std::int64_t kRound = 250'000;  // ns: 4 kHz

/// What the link and the servo's side of it tell each other beside what is measured.
struct Seen {
  std::atomic<std::int64_t> answered{0};  ///< when the reading came that the newest wrench answers
  std::vector<double> ages_us;            ///< of a reading when its wrench is sent; link's thread
};

/// A link that takes so long to carry a force and to bring a pose, 4000 times a second: the pose of
/// a hand that is led.
class Led final : public haptics::Transport {
 public:
  Led(haptics::Hand hand, std::int64_t transfer_ns, std::shared_ptr<Seen> seen)
      : hand_{std::move(hand)}, transfer_ns_{transfer_ns}, seen_{std::move(seen)} {}

  DeviceStatus exchange(const Wrench&, DeviceReading& reading) noexcept override {
    const std::int64_t now = haptics::monotonicNs(), answered = seen_->answered.load();
    if (answered != 0 && answered != last_) seen_->ages_us.push_back(1e-3 * double(now - answered));
    last_ = answered;
    transfer();
    due_ = std::max(due_ + kRound, haptics::monotonicNs() - kRound);
    haptics::sleepUntil(due_);
    transfer();
    reading.time_ns = haptics::monotonicNs();
    if (begun_ == 0) begun_ = reading.time_ns;
    reading.X_BD = hand_.at(1e-9 * double(reading.time_ns - begun_));
    return DeviceStatus::Ok;
  }

 private:
  void transfer() const noexcept {
    if (transfer_ns_ > 0) haptics::sleepUntil(haptics::monotonicNs() + transfer_ns_);
  }

  const haptics::Hand hand_;
  const std::int64_t transfer_ns_;
  const std::shared_ptr<Seen> seen_;
  std::int64_t due_ = 0, begun_ = 0, last_ = 0;
};

/// A device that notes which reading a wrench answers.
class Noted final : public support::PassingDevice {
 public:
  Noted(std::unique_ptr<haptics::Device> device, std::shared_ptr<Seen> seen)
      : PassingDevice{std::move(device)}, seen_{std::move(seen)} {}
  DeviceStatus read(DeviceReading& reading) noexcept override {
    const DeviceStatus status = PassingDevice::read(reading);
    read_at_ = reading.time_ns;
    return status;
  }
  DeviceStatus write(const Wrench& wrench_B) noexcept override {
    seen_->answered.store(read_at_);
    return PassingDevice::write(wrench_B);
  }

 private:
  const std::shared_ptr<Seen> seen_;
  std::int64_t read_at_ = 0;
};

Json run(const std::shared_ptr<const haptics::Scene>& scene, double isovalue,
         const haptics::Hand& hand, haptics::ServoRate rate, bool in_step, std::int64_t transfer_ns,
         double seconds) {
  static const haptics::DeviceRating rating = *haptics::findRating("omega.3");
  const auto seen = std::make_shared<Seen>();
  seen->ages_us.reserve(std::size_t(seconds * 1e9 / double(kRound)) + 1000);
  haptics::Settings settings;
  settings.isovalue = isovalue;
  Json json{
      {"rate_hz", rate.hz}, {"in_step", in_step}, {"transfer_us", 1e-3 * double(transfer_ns)}};
  {
    haptics::ServoLoop loop{
        std::make_unique<Noted>(haptics::threaded(std::make_unique<Led>(hand, transfer_ns, seen),
                                                  rating, std::chrono::milliseconds{15}, in_step),
                                seen),
        settings, true, rate};
    loop.scenes.offer(std::make_unique<haptics::Engagement>(scene, hand.at(0.0)));
    loop.start();
    std::this_thread::sleep_for(std::chrono::duration<double>{seconds});
    loop.end();
    haptics::Snapshot last;
    loop.snapshots.take(last);
    json["real_time_policy"] = last.policy == haptics::SchedulingPolicy::RealTime;
    json["contacts_at_the_end"] = last.contacts;
    json.update(bench::jsonOf(bench::ticksOf(last)));
  }
  std::vector<double>& ages = seen->ages_us;
  std::ranges::sort(ages);
  json["answers"] = ages.size();
  json["late_us"] = {{"median", measurement::quantile(ages, 0.5)},
                     {"p90", measurement::quantile(ages, 0.9)},
                     {"p99", measurement::quantile(ages, 0.99)},
                     {"mean", std::reduce(ages.begin(), ages.end()) / double(ages.size())}};
  return json;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App cli{"How late a force is over a link with a thread of its own."};
  double seconds = 10.0;
  int rounds = 3;
  std::string out;
  cli.add_option("--seconds", seconds, "Of touching, each")->check(CLI::Range(1.0, 3600.0));
  cli.add_option("--rounds", rounds, "In turns")->check(CLI::Range(1, 100));
  cli.add_option("--out", out, "JSON, besides what is printed");
  CLI11_PARSE(cli, argc, argv);

  const auto touched = comparison::phantomScene("demo");
  const auto scene = haptics::makeScene(touched.volume, comparison::toolOf(touched)).value();
  const auto hand =
      haptics::Hand::aimed(haptics::HandMotion::Slide, *scene, touched.isovalue, 2e-3, 1).value();
  Json json{{"machine", app::machineHere()}, {"runs", Json::array()}};
  for (int round = 0; round < rounds; ++round)
    for (const std::int64_t transfer_ns : {0, 50'000})
      for (const haptics::ServoRate rate : haptics::kServoRates)
        for (const bool in_step : {false, true})
          json["runs"].push_back(
              run(scene, touched.isovalue, hand, rate, in_step, transfer_ns, seconds));
  std::puts(json.dump(2).c_str());
  if (!out.empty()) std::ofstream(out) << json.dump(2) << '\n';
}
