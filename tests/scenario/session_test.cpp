// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/session.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstring>
#include <functional>
#include <memory>
#include <optional>
#include <string_view>
#include <thread>
#include <vector>

#include "datasets/edits/edit_history.h"
#include "haptics/core/clock.h"
#include "haptics/coupling/safety.h"
#include "haptics/proxy/cutting.h"
#include "haptics/simulation/allowed_stiffness.h"
#include "tests/scenario/fake_device.h"
#include "tests/scenario/trial.h"
#include "tests/support/made.h"

// What a session lets a user set for a device, and what it keeps of one.

namespace {

using haptics::DeviceStatus;
using haptics::Settings;
using haptics::Snapshot;
using haptics::Wrench;
using made::at;

TEST(Session, TakesNoSettingBeyondItsRangeAndNoStiffnessBeyondTheRating) {
  const Stage stage = stageOf("sphere", ballTool(50, 3e-3));
  haptics::Session session;
  session.set({.isovalue = stage.isovalue});
  session.adopt(stage.scene, at(0, 0, 0.03));
  auto device = std::make_unique<FakeDevice>(at(0, 0, 0));
  device->rated = {.sensed = 6,
                   .actuated = 6,
                   .force = 8.0,
                   .torque = 0.2,
                   .stiffness = 1000.0,
                   .angular_stiffness = 0.001};
  ASSERT_TRUE(session.open(std::move(device)));
  const auto inForce = [&](double stiffness, double force_scale, double position_scale) {
    session.set({.isovalue = stage.isovalue,
                 .stiffness = stiffness,
                 .force_scale = force_scale,
                 .position_scale = position_scale});
    return session.inForce();
  };
  EXPECT_EQ(inForce(400.0, 1.0, 2.0).stiffness, 400.0);
  EXPECT_EQ(inForce(800.0, 1.0, 2.0).stiffness, 500.0);  // 1000 N/m at the hand
  EXPECT_EQ(inForce(400.0, 2.0, 1.0).stiffness, 800.0);
  EXPECT_EQ(inForce(400.0, 5.0, 0.5).stiffness, 2000.0);
  EXPECT_EQ(inForce(400.0, 1.0, 1.0).angular_stiffness, 0.001);
  const double nan = std::nan("");
  for (const double odd : {nan, 0.0, -1.0, 1e300, -1e300}) {
    const Settings settings = inForce(odd, odd, odd);
    EXPECT_GE(settings.stiffness, 0.0);
    EXPECT_LE(settings.stiffness * settings.position_scale, 1000.0 + 1e-9) << odd;
    EXPECT_GE(settings.position_scale, 0.1);
    EXPECT_LE(settings.position_scale, 10.0);
  }
  // where no motor turns the hand, an angular stiffness would only change where the proxy goes
  device = std::make_unique<FakeDevice>(at(0, 0, 0));
  device->rated = *haptics::findRating("omega.6");
  ASSERT_TRUE(session.open(std::move(device)));
  session.set({.isovalue = stage.isovalue, .angular_stiffness = 5.0});
  EXPECT_EQ(session.inForce().angular_stiffness, 0.0);
  // of what nobody has rated no limit is known
  ASSERT_TRUE(session.open(std::make_unique<FakeDevice>(at(0, 0, 0))));
  EXPECT_EQ(inForce(5000.0, 1.0, 1.0).stiffness, 5000.0);
}

TEST(Session, RunsAtTheRateOfTheLinkAndNeverAtMore) {
  using haptics::ServoRate;
  const Stage stage = stageOf("sphere", ballTool(50, 3e-3));
  haptics::Session session;
  session.set({.isovalue = stage.isovalue, .stiffness = 20'000.0});
  session.adopt(stage.scene, at(0, 0, 0.03));
  const auto rateWith = [&](const char* model, std::optional<ServoRate> wish) {
    session.chooseRate(wish);
    auto device = std::make_unique<FakeDevice>(at(0, 0, 0));
    device->rated = *haptics::findRating(model);
    EXPECT_TRUE(session.open(std::move(device)));
    // what is allowed is by the period and by what the link costs
    const haptics::DeviceRating& rating = *haptics::findRating(model);
    const ServoRate rate = session.rate();
    EXPECT_EQ(
        session.inForce().stiffness,
        haptics::allowedStiffness(rating, stage.scene->tool.shell, {rate.period(), rating.delay}));
    return rate.hz;
  };
  EXPECT_EQ(rateWith("omega.6", {}), 4000);
  EXPECT_EQ(rateWith("omega.6", ServoRate{2000}), 2000);
  EXPECT_EQ(rateWith("omega.6", ServoRate{1000}), 1000);
  EXPECT_EQ(rateWith("falcon", {}), 1000);
  EXPECT_EQ(rateWith("falcon", ServoRate{4000}), 1000);
  session.chooseRate({});
  ASSERT_TRUE(session.open(haptics::HandKind::Mouse));
  EXPECT_EQ(session.rate().hz, 1000);
  const double stiffest = session.inForce().stiffness;
  session.chooseRate(ServoRate{4000});
  EXPECT_EQ(session.rate().hz, 1000);  // until it is opened anew
  ASSERT_TRUE(session.open(haptics::HandKind::Mouse));
  EXPECT_EQ(session.rate().hz, 4000);
  EXPECT_GT(session.inForce().stiffness, 2.0 * stiffest);
  // it keeps the pace, with what is late made up for by what is missed
  Snapshot first, last;
  const auto waited = [&](Snapshot& snapshot) {
    std::this_thread::sleep_for(std::chrono::milliseconds{300});
    ASSERT_TRUE(session.latest(snapshot));
  };
  waited(first);
  waited(last);
  const auto ticks = double(last.tick - first.tick + last.missed_ticks - first.missed_ticks);
  EXPECT_NEAR(ticks, 4000.0 * (last.time - first.time), 2.0);
}

TEST(Session, LetsNobodySetWhatShakesUnlessItIsLiftedAndForOneConnection) {
  const Stage stage = stageOf("sphere", ballTool(50, 3e-3));
  haptics::Session session;
  const Settings stiff{.isovalue = stage.isovalue, .stiffness = 20'000.0};
  session.set(stiff);
  session.adopt(stage.scene, at(0, 0, 0.03));
  const haptics::DeviceRating falcon = *haptics::findRating("falcon");
  const double allowed =
      haptics::allowedStiffness(falcon, stage.scene->tool.shell, {1e-3, falcon.delay});
  ASSERT_LT(allowed, 0.9 * falcon.stiffness);
  for (int connection = 0; connection < 2; ++connection) {
    auto device = std::make_unique<FakeDevice>(at(0, 0, 0));
    device->rated = falcon;
    ASSERT_TRUE(session.open(std::move(device)));
    EXPECT_EQ(session.inForce().stiffness, allowed);
    session.liftStiffness(true);
    EXPECT_EQ(session.inForce().stiffness, falcon.stiffness);
  }
  session.liftStiffness(false);
  EXPECT_EQ(session.inForce().stiffness, allowed);
  // nor what the grip of the mouse does not carry, which nothing lifts
  ASSERT_TRUE(session.open(haptics::HandKind::Mouse));
  session.liftStiffness(true);
  EXPECT_LE(session.inForce().stiffness, 8000.0);
  EXPECT_GT(session.inForce().stiffness, 7000.0);
}

/// A real device whose hand goes down into the ball and stays there.
class Diver final : public haptics::Device {
 public:
  explicit Diver(std::string_view id) {
    rated_ = {.id = id, .force = 8.0, .continuous_force = 0.5, .torque = 0.2};
  }
  const haptics::DeviceRating& rating() const noexcept override { return rated_; }
  DeviceStatus read(haptics::DeviceReading& reading) noexcept override {
    reading.X_BD.translation().z() = -std::min(5e-5 * ++reads_, 0.012);
    return DeviceStatus::Ok;
  }
  DeviceStatus write(const Wrench&) noexcept override { return DeviceStatus::Ok; }
  void stop() noexcept override {}
  void resume() noexcept override {}

 private:
  haptics::DeviceRating rated_;
  int reads_ = 0;
};

TEST(Session, MotorsThatWereHotAreSoWhenTheirDeviceIsOpenedAnew) {
  const Stage stage = stageOf("sphere", ballTool(50, 3e-3));
  haptics::Session session;
  session.set({.isovalue = stage.isovalue, .stiffness = 1000.0});
  session.adopt(stage.scene, at(0, 0, 0.03));
  // N, the most that is felt until `done`, or for a minute, and s, when: a busy machine's loop is
  // at fault, and armed again
  struct Strongest {
    double force = 0.0;
    double time = haptics::monotonicNs() * 1e-9;
  };
  const auto strongest = [&](std::string_view id, auto&& done) {
    EXPECT_TRUE(session.open(std::make_unique<Diver>(id)));
    Snapshot snapshot;
    Strongest most;
    std::uint64_t calm_since = 0;  // ticks: since then the force is what motors stand for ever
    for (int n = 0; n < 60'000 && !done(most.force, snapshot.tick - calm_since); ++n) {
      session.arm();
      std::this_thread::sleep_for(std::chrono::milliseconds{1});
      session.latest(snapshot);
      const double force = snapshot.felt_W.force.norm();
      if (force > most.force) most = {force, haptics::monotonicNs() * 1e-9};
      if (!(force > 0.4 && force < 0.6)) calm_since = snapshot.tick;
    }
    return most;
  };
  constexpr std::uint64_t kLong = 100;
  const auto calm = [](double, std::uint64_t ticks) { return ticks > kLong; };
  const auto spared = [](double most, std::uint64_t ticks) { return most > 1.5 && ticks > kLong; };
  EXPECT_GT(strongest("one", spared).force, 1.5);
  // no more than motors bear that cool since then, without a force at worst: a fifth cooler than at
  // their continuous force they bear all of the 8 N
  const double left = haptics::monotonicNs() * 1e-9;
  const Strongest again = strongest("one", calm);
  const double heat = 0.98 * std::exp(-(again.time - left) / haptics::ForceLimits::kWarmUp);
  EXPECT_LT(again.force, 8.0 - 7.5 * std::clamp((heat - 0.8) / 0.2, 0.0, 1.0));
  EXPECT_GT(strongest("another", [](double most, std::uint64_t) { return most > 1.5; }).force, 1.5);
}

/// A burr of 3 mm in the sphere, in the mouse's hand, which presses from above.
struct MillingMouse {
  MillingMouse() {
    session.set({.isovalue = stage.isovalue, .stiffness = 1000.0});
    session.adopt(stage.scene, kAbove);
    EXPECT_TRUE(session.open(haptics::HandKind::Mouse, kAbove));
    haptics::CutLaw law;
    law.burr.radius = 3e-3;
    auto cutting =
        std::make_unique<haptics::Cutting>(haptics::CarvedScene::of(*stage.scene).value(), law);
    touched = cutting->scene();
    session.cut(std::move(cutting));
  }
  /// Goes on until it is so, at display rate, and takes the cuts. A busy machine's loop is at
  /// fault: it is armed again, and cuts once the key was let go.
  bool until(const std::function<bool()>& holds, bool key) {
    for (int n = 0; n < 12'000; ++n) {
      session.collectGarbage();
      session.arm();
      session.holdCut(key && (snapshot.cuts || n % 10 != 9));
      session.latest(snapshot);
      std::array<haptics::BurrCut, 64> some;
      while (const std::size_t count = session.cuts(some))
        made.insert(made.end(), some.begin(), some.begin() + static_cast<std::ptrdiff_t>(count));
      if (holds()) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds{10});
    }
    return false;
  }
  /// Holds the key until there are so many cuts more.
  bool cutsMore(std::size_t count) {
    const std::size_t before = made.size();
    return until([&] { return snapshot.can_cut && !snapshot.cuts; }, false) &&
           until([&] { return snapshot.scene == stage.scene->id && snapshot.can_cut; }, false) &&
           until([&] { return made.size() >= before + count; }, true);
  }

  static inline const haptics::Pose kAbove = at(0, 0, 0.03), kPressed = at(0, 0, 0.02);
  Stage stage = stageOf("sphere", ballTool(400, 3e-3));
  haptics::Session session;
  std::shared_ptr<const haptics::Scene> touched;
  Snapshot snapshot;
  std::vector<haptics::BurrCut> made;
};

TEST(Session, CutsWithWhatItWasGivenWhateverHandHasTheToolAndTellsEachCut) {
  MillingMouse milling;
  haptics::Session& session = milling.session;
  session.pull(MillingMouse::kPressed);
  ASSERT_TRUE(milling.cutsMore(50));
  EXPECT_GT(milling.snapshot.burr_force, 0.0);
  // brought elsewhere in what is cut already
  session.bring(at(0, 0.006, 0.03), at(0, 0.006, 0.02));
  ASSERT_TRUE(milling.cutsMore(50));
  // and in another hand
  ASSERT_TRUE(session.open(haptics::HandKind::Mouse, at(0.006, 0, 0.03)));
  milling.snapshot = {};
  session.pull(at(0.006, 0, 0.02));
  ASSERT_TRUE(milling.cutsMore(50));
  ASSERT_TRUE(milling.until([&] { return !milling.snapshot.cuts; }, false));
  // a cut that is under way goes on in the ticks that follow
  const std::uint64_t tick = milling.snapshot.tick;
  ASSERT_TRUE(milling.until([&] { return milling.snapshot.tick > tick + 50; }, false));
  session.close();
  milling.until([] { return true; }, false);
  const auto made = datasets::edited(milling.stage.scene->volume,
                                     std::vector<datasets::Edit>{datasets::Stroke{milling.made}});
  ASSERT_TRUE(made);
  const haptics::Volume& left = *milling.touched->volume;
  const std::size_t bytes = std::size_t(left.grid.voxelCount()) * haptics::sizeOf(left.type);
  EXPECT_EQ(std::memcmp((*made)->voxels.get(), left.voxels.get(), bytes), 0);
  EXPECT_NE(std::memcmp((*made)->voxels.get(), milling.stage.scene->volume->voxels.get(), bytes),
            0);
}

TEST(Session, TurnsNoBurrInAnotherHandBeforeItsKeyWasReleased) {
  MillingMouse milling;
  haptics::Session& session = milling.session;
  session.pull(MillingMouse::kPressed);
  ASSERT_TRUE(milling.cutsMore(10));
  const auto holdOn = [&] {
    session.arm();
    session.holdCut(true);
    session.latest(milling.snapshot);
    std::this_thread::sleep_for(std::chrono::milliseconds{5});
  };
  holdOn();
  ASSERT_TRUE(session.open(haptics::HandKind::Mouse, MillingMouse::kAbove));
  session.pull(MillingMouse::kPressed);
  milling.snapshot = {};
  while (milling.snapshot.tick < 1500) {
    if (milling.snapshot.tick > 20) holdOn();  // a window says it later
    session.latest(milling.snapshot);
    EXPECT_FALSE(milling.snapshot.cuts);
  }
  EXPECT_TRUE(milling.cutsMore(10));
}

TEST(Session, LetsNothingCutInAnotherScene) {
  MillingMouse milling;
  haptics::Session& session = milling.session;
  ASSERT_TRUE(milling.until([&] { return milling.snapshot.can_cut; }, false));
  const Stage other = stageOf("sphere", ballTool(400, 3e-3));
  session.adopt(other.scene, MillingMouse::kAbove);
  ASSERT_TRUE(milling.until([&] { return milling.snapshot.scene == other.scene->id; }, false));
  EXPECT_FALSE(milling.snapshot.can_cut);
  // what was made for the scene before comes too late
  session.cut(std::make_unique<haptics::Cutting>(
      haptics::CarvedScene::of(*milling.stage.scene).value(), haptics::CutLaw{}));
  const std::uint64_t tick = milling.snapshot.tick;
  ASSERT_TRUE(milling.until([&] { return milling.snapshot.tick > tick + 10; }, false));
  EXPECT_FALSE(milling.snapshot.can_cut);
  // and what is given before the scene is adopted waits for it
  session.adopt(milling.stage.scene, MillingMouse::kAbove);
  session.cut(std::make_unique<haptics::Cutting>(
      haptics::CarvedScene::of(*milling.stage.scene).value(), haptics::CutLaw{}));
  ASSERT_TRUE(milling.until([&] { return milling.snapshot.can_cut; }, false));
  EXPECT_EQ(milling.snapshot.scene, milling.stage.scene->id);
  // one that follows another law takes its place, and it is destroyed here
  const auto given = [&] {
    auto cutting = std::make_unique<haptics::Cutting>(
        haptics::CarvedScene::of(*milling.stage.scene).value(), haptics::CutLaw{});
    const std::weak_ptr<const haptics::Scene> scene = cutting->scene();
    session.cut(std::move(cutting));
    return scene;
  };
  const auto before = given();
  const std::uint64_t then = milling.snapshot.tick;
  ASSERT_TRUE(milling.until([&] { return milling.snapshot.tick > then + 10; }, false));
  const auto after = given();
  ASSERT_TRUE(milling.until([&] { return before.expired(); }, false));
  EXPECT_FALSE(after.expired());
  EXPECT_TRUE(milling.snapshot.can_cut);
  // one that no tick has taken yet goes to the next hand, as often as there is one
  const auto last = given();
  for (int n = 0; n < 3; ++n)
    ASSERT_TRUE(session.open(haptics::HandKind::Mouse, MillingMouse::kAbove));
  EXPECT_FALSE(last.expired());
  milling.snapshot = {};
  EXPECT_TRUE(milling.until([&] { return milling.snapshot.can_cut; }, false));
}

}  // namespace
