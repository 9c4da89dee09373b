// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <condition_variable>
#include <iostream>
#include <limits>
#include <mutex>
#include <thread>

#include "datasets/phantoms/making.h"
#include "haptics/proxy/cutting.h"
#include "haptics/scene/legal_pose.h"
#include "haptics/scene/pages_ahead.h"
#include "haptics/simulation/simulated.h"
#include "tests/scenario/fake_device.h"
#include "tests/scenario/trial.h"
#include "tests/support/made_distances.h"
#include "tests/support/no_allocation.h"

namespace {

using haptics::Hand;
using haptics::HandMotion;
using haptics::Pose;
using haptics::ServoLoop;
using haptics::Vec3;
using made::at;
using support::Calls;
using support::NoAllocation;

constexpr HandMotion kHands[] = {HandMotion::Tap,  HandMotion::Slide, HandMotion::Wedge,
                                 HandMotion::Pry,  HandMotion::Hook,  HandMotion::Jerk,
                                 HandMotion::Twist};

void* volatile planted_here = nullptr;

TEST(NoAllocation, CountsWhatIsPlanted) {
  const auto of = [](auto&& plant) {
    const NoAllocation guard;
    plant();
    return guard.calls();
  };
  EXPECT_EQ(of([] {}).all(), 0);
  EXPECT_GE(of([] {
              planted_here = ::operator new(24);
              ::operator delete(planted_here);
            }).allocations,
            2);
  EXPECT_GE(of([] {
              planted_here = std::calloc(3, 8);
              planted_here = std::realloc(planted_here, 100);
              std::free(planted_here);
            }).allocations,
            3);
  EXPECT_GE(of([] {
              planted_here = std::aligned_alloc(64, 128);
              std::free(planted_here);
            }).allocations,
            2);
  EXPECT_GE(of([] {
              planted_here = new (std::align_val_t{64}) char[128];
              ::operator delete[](planted_here, std::align_val_t{64});
            }).allocations,
            2);
  std::mutex mutex;
  EXPECT_EQ(of([&] { const std::lock_guard lock{mutex}; }).waits, 1);
  EXPECT_STREQ(of([&] { const std::lock_guard lock{mutex}; }).first, "pthread_mutex_lock");
  EXPECT_GE(of([&] {
              std::condition_variable condition;
              std::unique_lock lock{mutex};
              condition.wait_for(lock, std::chrono::microseconds{1}, [] { return true; });
              condition.notify_one();
            }).waits,
            1);
  EXPECT_GE(of([] { std::this_thread::sleep_for(std::chrono::microseconds{1}); }).waits, 1);
  EXPECT_GE(of([] { std::this_thread::yield(); }).waits, 1);
  // another thread's are not this one's
  std::atomic<bool> go{false}, done{false};
  std::thread other{[&] {
    while (!go) {
    }
    planted_here = std::malloc(10);
    std::free(planted_here);
    done = true;
  }};
  const Calls calls = of([&] {
    go = true;
    while (!done) {
    }
  });
  other.join();
  EXPECT_EQ(calls.all(), 0);
}

/// One step under the guard; says what it called.
Calls guarded(ServoLoop& loop, double time) {
  const NoAllocation guard;
  loop.step(time);
  return guard.calls();
}

long checked = 0;

void run(ServoLoop& loop, haptics::ServoRate rate, std::int64_t& tick, int ticks) {
  for (int n = 0; n < ticks; ++n) {
    const Calls calls = guarded(loop, rate.period() * double(tick++));
    ASSERT_EQ(calls.all(), 0) << calls.first << " in tick " << tick;
    ++checked;
    haptics::ForceSample sample;
    while (loop.forces.try_dequeue(sample)) {
    }
  }
}

/// A phantom and what is done in it; `points` spreads that many over the tool.
struct Case {
  const char* phantom;
  const char* tool;
  int points = 0;
  haptics::SceneOptions options = {};
  double friction = 0.0;

  friend void PrintTo(const Case& with, std::ostream* out) {
    *out << with.phantom << " with " << with.tool;
  }
};
constexpr haptics::SceneOptions kSpline{haptics::FieldKind::CubicSpline,
                                        haptics::NormalKind::Spline};

class EveryHand : public testing::TestWithParam<Case> {};

TEST_P(EveryHand, NeitherAllocatesNorLocksInAnyTick) {
  const Case& with = GetParam();
  datasets::Phantom made = datasets::makePhantom(with.phantom).value();
  const auto volume = made::shared(std::move(made.volume));
  const auto mesh = resources::namedToolMesh(with.tool).value();
  // the hand is aimed with few points, and does the same with many
  const auto aimed = haptics::makeScene(volume, haptics::makeTool(with.tool, mesh).value()).value();
  const auto scene =
      haptics::makeScene(volume, haptics::makeTool(with.tool, mesh, with.points).value(),
                         with.options)
          .value();
  const auto other = haptics::makeScene(volume, namedTool("drill"), kSpline).value();
  haptics::Watch watch;
  for (std::uint8_t n = 0; n < haptics::kMostWatched; ++n)
    watch.structures.push_back({n, made::distanceMap(volume->grid, [&](const Vec3& p) {
                                  return (p - 1e-3 * Vec3(double(n), 0.0, 0.0)).norm() - 5e-3;
                                })});
  long watched = 0;
  long touching = 0, recovering = 0, adopted = 0, recorded = 0, starts = 0;
  for (const HandMotion motion : kHands) {
    SCOPED_TRACE(int(motion));
    auto hand = Hand::aimed(motion, *aimed, made.isovalue, Hand::reachFor(4e-3, 1000.0, 500.0), 7);
    ASSERT_TRUE(hand);
    const Pose start = hand->at(0.0);
    haptics::Grip grip;
    haptics::Settings settings{.isovalue = made.isovalue, .friction = with.friction};
    haptics::StepRing ring{0};
    const haptics::ServoRate rate = haptics::kServoRates[std::size_t(motion) % 3];
    ServoLoop loop{haptics::openSimulated(std::move(*hand), grip, rate.period()), settings, true,
                   rate};
    loop.scenes.offer(std::make_unique<haptics::Engagement>(scene, start));
    std::int64_t tick = 0;
    haptics::Snapshot snapshot;
    for (int part = 0; part < 12; ++part) {
      run(loop, rate, tick, 100 * rate.hz / 1000);
      if (HasFatalFailure()) return;
      loop.snapshots.take(snapshot);
      touching += snapshot.contacts > 0;
      recovering += snapshot.reason == haptics::ForceReason::Inside;
      adopted += snapshot.scene == other->id;
      EXPECT_EQ(snapshot.near.size(), loop.watch.load() == nullptr ? 0U : haptics::kMostWatched);
      watched += !snapshot.near.empty();
      loop.watch = part % 2 == 0 ? &watch : nullptr;
      // the isovalue down so that the tool is buried, and back; then another tool, and back
      settings.isovalue =
          part % 3 == 0 ? volume->least + 0.2 * (made.isovalue - volume->least) : made.isovalue;
      settings.friction = part % 2 == 0 ? 0.4 : with.friction;
      loop.settings.publish(settings);
      run(loop, rate, tick, 5 * rate.hz / 1000);
      loop.snapshots.take(snapshot);
      recovering += snapshot.reason == haptics::ForceReason::Inside;
      if (part % 4 == 3)
        loop.scenes.offer(
            std::make_unique<haptics::Engagement>(part % 8 == 3 ? other : scene, snapshot.X_WD));
      loop.armed = part % 5 != 4;
      // recorded, and no more, and again
      loop.recording = part % 3 == 0 ? nullptr : &ring;
      for (haptics::Step step; ring.take(step);) ++recorded;
      for (haptics::ProxyStart begun; ring.take(begun);) ++starts;
    }
  }
  std::cout << with.phantom << ": " << checked << " ticks so far without a call\n";
  EXPECT_GT(touching, 5);
  EXPECT_GT(recovering, 0);
  EXPECT_GT(adopted, 0);
  EXPECT_GT(recorded, 1000);
  EXPECT_GT(starts, 7);
  EXPECT_GT(watched, 20);
}
INSTANTIATE_TEST_SUITE_P(
    On, EveryHand,
    testing::Values(
        Case{"sphere", "probe"}, Case{"gyroid", "probe", 0, {}, 0.4}, Case{"demo", "drill"},
        Case{"halfspace", "drill", 100'000}, Case{"torus", "cane", 0, kSpline},
        Case{"wedge", "sphere", 3, kSpline, 0.3}, Case{"hole", "peg", 0, {}, 0.2},
        Case{"slot", "sphere", 1, {haptics::FieldKind::Trilinear, haptics::NormalKind::Cell}},
        Case{"cylinder", "wrench", 10'000, {}, 0.5}, Case{"marker", "probe", 20'000, kSpline}),
    [](const auto& with) { return std::string{with.param.phantom}; });

long pageFaults() {
  rusage used{};
  getrusage(RUSAGE_THREAD, &used);
  return used.ru_minflt + used.ru_majflt;
}

// recorded, too. The system may take a page away at any time, so the median of five parts counts
TEST(EveryTick, MeetsNoPageFaultAtAnyRate) {
  const Stage stage = stageOf("demo", namedTool("drill"));
  for (const haptics::ServoRate rate : haptics::kServoRates) {
    auto hand = Hand::aimed(HandMotion::Slide, *stage.scene, stage.isovalue, 4e-3, 7);
    ASSERT_TRUE(hand);
    const Pose start = hand->at(0.0);
    haptics::StepRing ring{0};
    ServoLoop loop{haptics::openSimulated(std::move(*hand), {}, rate.period()),
                   {.isovalue = stage.isovalue},
                   true,
                   rate};
    loop.scenes.offer(std::make_unique<haptics::Engagement>(stage.scene, start));
    loop.recording = &ring;
    std::int64_t tick = 0;
    run(loop, rate, tick, rate.hz);
    std::array<long, 5> faults{};
    for (long& part : faults) {
      haptics::Step step;
      while (ring.take(step)) {
      }
      const long before = pageFaults();
      for (int n = 0; n < rate.hz / 5; ++n) loop.step(rate.period() * double(tick++));
      part = pageFaults() - before;
    }
    haptics::Snapshot snapshot;
    loop.snapshots.take(snapshot);
    EXPECT_GT(snapshot.contacts, 0);
    std::ranges::sort(faults);
    EXPECT_EQ(faults[2], 0) << rate.hz << " Hz, at most " << faults[4];
  }
}

/// A hand that mills with a burr, and its key, which is held from the tenth tick on.
struct Milling {
  explicit Milling(const Stage& on, bool ahead) : stage{on} {
    hand = Hand::aimed(HandMotion::Mill, *stage.scene, stage.isovalue, 4e-3, 7).value();
    haptics::CutLaw law;
    const auto& points = stage.scene->tool.shell.points;
    law.burr.radius = 2e-3;
    law.burr.centre_P.z() =
        std::ranges::min(points, {}, [](const Vec3& p) { return p.z(); }).z() + 2e-3;
    auto made =
        std::make_unique<haptics::Cutting>(haptics::CarvedScene::of(*stage.scene).value(), law);
    if (ahead) made->lookAhead();
    cutting = made.get();
    loop = std::make_unique<ServoLoop>(
        haptics::openSimulated(*hand, {}, haptics::ServoRate{}.period()),
        haptics::Settings{.isovalue = stage.isovalue});
    loop->scenes.offer(std::make_unique<haptics::Engagement>(std::move(made), hand->at(0.0)));
    loop->recording = &ring;
    run(*loop, {}, tick, 10);
    loop->cut_until = std::numeric_limits<std::int64_t>::max();
  }
  void empty() {
    for (haptics::Step step; ring.take(step);) cuts += step.cut.has_value();
  }

  const Stage& stage;
  std::optional<Hand> hand;
  haptics::StepRing ring{0};
  haptics::Cutting* cutting = nullptr;
  std::unique_ptr<ServoLoop> loop;
  std::int64_t tick = 0, cuts = 0;
};

TEST(EveryTick, NeitherAllocatesNorLocksWhileItCuts) {
  const Stage stage = stageOf("demo", namedTool("burr-4"));
  Milling milling{stage, true};
  for (int part = 0; part < made::trials(20); ++part) {
    run(*milling.loop, {}, milling.tick, 2'000);
    milling.empty();
  }
  // a tick has a budget of time, so how many there are depends on the machine
  EXPECT_GT(milling.cuts, made::trials(1'000));
  EXPECT_GT(milling.cutting->removed().volume, 1e-9);
}

// where the pages are copied ahead; where they are not, there are faults
TEST(EveryTick, MeetsNoPageFaultWhileItCuts) {
  const Stage stage = stageOf("demo", namedTool("burr-4"));
  for (const bool ahead : {true, false}) {
    Milling milling{stage, false};
    const haptics::PagesAhead pages{milling.cutting->scene()->volume, 8e-3};
    long faults = 0;
    for (int n = 0; n < 3'600; ++n) {
      // as its thread does, but before each tick, however late a thread would be here
      haptics::Snapshot snapshot;
      if (ahead && milling.loop->snapshots.take(snapshot)) {
        ASSERT_TRUE(pages.copyAround(snapshot.X_WP * milling.cutting->law().burr.centre_P));
      }
      const long before = pageFaults();
      milling.loop->step(haptics::ServoRate{}.period() * double(milling.tick++));
      faults += pageFaults() - before;
      milling.empty();
    }
    EXPECT_GT(milling.cuts, 100);
    if (ahead)
      EXPECT_LE(faults, 3);  // the system may take a page away at any time
    else
      EXPECT_GT(faults, 5);
  }
}

TEST(EveryTick, NeitherAllocatesNorLocksWhereNobodyEmptiesTheRing) {
  const Stage stage = stageOf("sphere", namedTool("probe"));
  auto hand = Hand::aimed(HandMotion::Slide, *stage.scene, stage.isovalue, 4e-3, 7);
  ASSERT_TRUE(hand);
  const Pose start = hand->at(0.0);
  haptics::StepRing ring{0};
  ServoLoop loop{haptics::openSimulated(std::move(*hand), {}, haptics::ServoRate{}.period()),
                 {.isovalue = stage.isovalue}};
  loop.scenes.offer(std::make_unique<haptics::Engagement>(stage.scene, start));
  loop.recording = &ring;
  std::int64_t tick = 0;
  run(loop, {}, tick, 12'000);
  EXPECT_TRUE(ring.full());
  haptics::Step step;
  long kept = 0;
  while (ring.take(step)) ++kept;
  EXPECT_LT(kept, 12'000);
  run(loop, {}, tick, 10);
  while (ring.take(step)) ++kept;
  EXPECT_EQ(step.sequence, 12'009U);
}

// watched, guarded and mapped, with everything that may happen to it
TEST(EveryTick, NeitherAllocatesNorLocksForARealDevice) {
  const Stage stage = stageOf("sphere", namedTool("probe"));
  const Stage other = stageOf("torus", namedTool("drill"));
  const Pose start = haptics::legalPoseNear(*stage.scene, stage.isovalue, at(0, 0, 0.03)).value();
  auto made = std::make_unique<FakeDevice>(start);
  FakeDevice* device = made.get();
  haptics::Settings settings{.isovalue = stage.isovalue};
  haptics::Handling handling;
  haptics::StepRing ring{0};
  ServoLoop loop{std::move(made), settings, start};
  loop.recording = &ring;
  datasets::Random random{7};
  std::int64_t now = 1'000'000'000;
  std::array<long, 6> states{};
  for (int n = 0; n < 40'000; ++n) {
    device->X_BD.translation() = start.translation() + Vec3(0, 0, -0.012) + random.box(1e-4);
    if (n % 5003 == 5002) device->X_BD.translation() += random.box(0.05);
    device->buttons = n / 500 % 4 == 3 ? 1U : 0U;
    device->status = n % 6997 == 6996 ? haptics::DeviceStatus::Lost
                     : n % 6007 < 4   ? haptics::DeviceStatus::Stale
                     : n % 2503 < 30  ? haptics::DeviceStatus::NotReady
                                      : haptics::DeviceStatus::Ok;
    if (n % 300 == 0) {
      handling = {.R_WB = random.rotation().toRotationMatrix(),
                  .clutch_button = 0,
                  .hold_to_run = n % 4500 == 0,
                  .held = n % 9000 == 0};
      loop.handling.publish(handling);
      settings.position_scale = 1.0 + 0.1 * (n % 7);
      loop.settings.publish(settings);
      loop.armed = n % 6300 != 0;
    }
    if (n % 4000 == 0)
      loop.scenes.offer(
          std::make_unique<haptics::Engagement>(n % 8000 == 0 ? stage.scene : other.scene, start));
    now += n % 4001 == 4000 ? 6'000'000 : 1'000'000;
    Calls calls;
    {
      const NoAllocation guard;
      loop.step(1e-9 * double(now), now);
      calls = guard.calls();
    }
    ASSERT_EQ(calls.all(), 0) << calls.first << " in tick " << n;
    haptics::Snapshot snapshot;
    loop.snapshots.take(snapshot);
    ++states[static_cast<std::size_t>(snapshot.force_state)];
    haptics::ForceSample sample;
    while (loop.forces.try_dequeue(sample)) {
    }
    haptics::Step step;
    while (ring.take(step)) {
    }
    haptics::ProxyStart begun;
    while (ring.take(begun)) {
    }
  }
  for (std::size_t state = 0; state < states.size(); ++state) EXPECT_GT(states[state], 10) << state;
}

TEST(EveryTick, NeitherAllocatesNorLocksWhateverTheDeviceReads) {
  const Stage stage = stageOf("gyroid", namedTool("probe"));
  datasets::Random random{131};
  const Pose start = haptics::legalPoseNear(*stage.scene, stage.isovalue, at(0, 0, 0.2)).value();
  Trial trial{stage.scene, stage.isovalue, start};
  trial.judged = false;
  trial.behind.reserve(5000);  // what the trial writes down, not the tick
  Pose D = start;
  for (int n = 0; n < 5000; ++n) {
    if (n % 20 == 0) D = at(random.box(0.05), random.rotation());
    D.translation() += random.box(1e-3);
    Pose read = D;
    if (n % 97 == 0) read.matrix()(n % 3, n % 4) = NAN;
    const NoAllocation guard;
    trial.step(read);
    ASSERT_EQ(guard.calls().all(), 0) << guard.calls().first << " in tick " << n;
  }
  EXPECT_GT(trial.contact, 1000);
}

}  // namespace
