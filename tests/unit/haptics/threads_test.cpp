// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <chrono>
#include <iostream>
#include <thread>

#include "datasets/phantoms/making.h"
#include "datasets/phantoms/sampling.h"
#include "haptics/core/latest_value.h"
#include "haptics/proxy/tick.h"
#include "haptics/scene/watch.h"
#include "haptics/servo/engagement.h"
#include "haptics/servo/step_ring.h"
#include "haptics/session.h"
#include "tests/support/made.h"
#include "tests/support/made_distances.h"

// To be run under the thread sanitizer too: what it says counts as a failure.

// The force queue (readerwriterqueue) orders its slots by fences, which the sanitizer does not
// model: it takes each sample for a race, here or in the sample's copy. Nothing of ours is passed
// over.
extern "C" const char* __tsan_default_suppressions() {
  return "race:moodycamel::ReaderWriterQueue\n";
}

namespace {

using haptics::HandKind;
using haptics::LatestValue;
using haptics::Pose;
using haptics::Scene;
using haptics::Session;
using haptics::Snapshot;
using made::at;

struct Wide {
  std::array<std::uint64_t, 40> words{};
};

TEST(LatestValue, IsWholeAndNeverOlderThanTheLastOneTaken) {
  LatestValue<Wide> box;
  constexpr std::uint64_t kLast = made::trials(400'000);
  // until the reader has seen enough, however late it began
  std::atomic<std::uint64_t> taken{0}, end{0};
  std::thread writer{[&] {
    std::uint64_t n = 0;
    while (n < kLast || taken <= 100) {
      ++n;
      Wide value;
      value.words.fill(n);
      box.publish(value);
      if (n % 64 == 0) std::this_thread::yield();
    }
    end = n;
  }};
  Wide value;
  std::uint64_t last = 0, torn = 0, older = 0;
  while (end == 0 || last < end) {
    if (!box.take(value)) {
      std::this_thread::yield();
      continue;
    }
    ++taken;
    for (const std::uint64_t word : value.words) torn += word != value.words[0];
    older += value.words[0] <= last;
    last = value.words[0];
  }
  writer.join();
  EXPECT_EQ(torn, 0u);
  EXPECT_EQ(older, 0u);
  EXPECT_GT(taken, 100u);
  EXPECT_FALSE(box.take(value));
}

TEST(LatestValue, GivesTheNewestAndEachOnlyOnce) {
  LatestValue<int> box;
  int value = -1;
  EXPECT_FALSE(box.take(value));
  EXPECT_EQ(value, -1);
  for (int n = 0; n < 10; ++n) box.publish(n);
  EXPECT_TRUE(box.take(value));
  EXPECT_EQ(value, 9);
  EXPECT_FALSE(box.take(value));
  box.publish(10);
  EXPECT_TRUE(box.take(value));
  EXPECT_EQ(value, 10);
}

std::shared_ptr<const Scene> smallScene() {
  return made::scene(datasets::solid(datasets::centredGrid(16, 1e-3),
                                     [](const auto& p) { return p.norm() - 5e-3; }),
                     made::tool(datasets::ballPoints(20, 1e-3)));
}

TEST(SceneHandOver, UnderAHammerEverySceneIsWholeAndNoneIsLeftBehind) {
  constexpr int kOffers = made::trials(3000);
  std::vector<std::weak_ptr<const Scene>> scenes;
  std::atomic<std::uint64_t> adopted{0}, ticks{0};
  {
    haptics::SceneHandOver over;
    std::atomic<bool> done{false};
    std::thread servo{[&] {
      std::uint64_t last = 0;
      while (!done.load(std::memory_order_relaxed)) {
        adopted += over.adopt();
        haptics::Engagement* touched = over.current();
        if (touched == nullptr) continue;
        EXPECT_GE(touched->scene->id, last);  // never an older one
        last = touched->scene->id;
        haptics::Budget budget = haptics::Budget::counted(haptics::kTickWork);
        haptics::tick(*touched->scene, datasets::kSolidIso, {}, at(0, 0, 5e-3), touched->proxy,
                      budget, 1e-3);
        ++ticks;
      }
    }};
    const auto same = smallScene();
    for (int n = 0; n < kOffers; ++n) {
      const auto scene =
          n % 50 == 0
              ? smallScene()
              : std::make_shared<const Scene>(
                    Scene{same->id + 1000 + std::uint64_t(n), same->volume, same->tool, same->tree,
                          same->shared_field, same->field, same->metric, same->lengths});
      const auto numbered = std::make_shared<const Scene>(
          Scene{std::uint64_t(n) + 1, scene->volume, scene->tool, scene->tree, scene->shared_field,
                scene->field, scene->metric, scene->lengths});
      scenes.push_back(numbered);
      over.offer(std::make_unique<haptics::Engagement>(numbered, at(0, 0, 0.012)));
      if (n % 3 == 0) over.collect();
      if (n % 4 == 0) std::this_thread::yield();
    }
    while (adopted == 0) std::this_thread::yield();
    done = true;
    servo.join();
  }
  int alive = 0;
  for (const auto& scene : scenes) alive += !scene.expired();
  EXPECT_EQ(alive, 0);
  std::cout << adopted << " of " << kOffers << " scenes adopted over " << ticks << " ticks\n";
  EXPECT_GT(ticks, 0u);
}

TEST(SceneHandOver, KeepsTheSceneInForceWhileTheLastOneIsNotCollected) {
  const auto a = smallScene(), b = smallScene(), c = smallScene();
  const auto engaged = [](const auto& scene) {
    return std::make_unique<haptics::Engagement>(scene, at(0, 0, 0.012));
  };
  haptics::SceneHandOver over;
  EXPECT_FALSE(over.adopt());
  over.offer(engaged(a));
  EXPECT_TRUE(over.adopt());
  over.offer(engaged(b));
  EXPECT_TRUE(over.adopt());
  EXPECT_EQ(over.current()->scene, b);
  over.offer(engaged(c));  // collects a
  EXPECT_TRUE(over.adopt());
  EXPECT_EQ(over.current()->scene, c);
  EXPECT_FALSE(over.adopt());
}

// the window's calls against a servo thread that runs
TEST(Session, OpensAdoptsSetsDropsTheForceAndClosesWhileTheLoopRuns) {
  const auto sphere = made::scene(datasets::solid(datasets::centredGrid(48, 1e-3),
                                                  [](const auto& p) { return p.norm() - 0.015; }),
                                  made::tool(datasets::ballPoints(60, 3e-3)));
  const auto other = made::scene(datasets::solid(datasets::centredGrid(48, 1e-3),
                                                 [](const auto& p) { return p.norm() - 0.010; }),
                                 made::tool(datasets::ballPoints(30, 2e-3)));
  haptics::Watch around;
  around.structures.push_back(
      {3, made::distanceMap(datasets::centredGrid(24, 2e-3),
                            [](const auto& p) { return p.norm() - 0.015; })});
  Session session;
  haptics::Settings settings{.isovalue = datasets::kSolidIso};
  session.set(settings);
  EXPECT_FALSE(session.open(HandKind::Mouse));  // nothing to touch yet
  session.adopt(sphere, at(0, 0, 0.03));
  Snapshot snapshot;
  std::uint64_t ticks = 0, snapshots = 0;
  std::size_t samples = 0;
  for (const HandKind hand : {HandKind::Mouse, HandKind::Tap, HandKind::Slide}) {
    ASSERT_TRUE(session.open(hand));
    EXPECT_TRUE(session.isOpen());
    const std::uint64_t snapshots_before = snapshots;
    std::uint64_t last = 0;
    int frame = 0;
    bool off_seen = false, watched_seen = false, unwatched_seen = false;
    // on a machine that is busy the loop has fewer ticks, and misses moments in which the force is
    // off
    const auto goesOn = [&] {
      return frame < 140 || !off_seen || !watched_seen || !unwatched_seen || last < 100 ||
             snapshots < snapshots_before + 20;
    };
    while (goesOn() && frame < 20'000) {
      if (session.latest(snapshot)) {
        EXPECT_GT(snapshot.tick, last);
        EXPECT_TRUE(snapshot.X_WP.matrix().allFinite());
        EXPECT_NE(snapshot.policy, haptics::SchedulingPolicy::NotStarted);
        if (snapshot.force_state == haptics::ForceState::Ready) {
          EXPECT_TRUE(snapshot.felt_W.force.isZero(0.0));
          off_seen = true;
        }
        watched_seen = watched_seen || snapshot.near.size() == 1;
        unwatched_seen = unwatched_seen || snapshot.near.empty();
        last = snapshot.tick;
        ++snapshots;
      }
      std::array<haptics::ForceSample, 64> forces;
      samples += session.forces(forces);
      session.pull(at(0.01 * std::sin(frame * 0.1), 0, 0.016));
      settings.isovalue = datasets::kSolidIso + 200.0 * std::sin(frame * 0.3);
      session.set(settings);
      if (frame % 20 == 10) session.adopt(frame % 40 == 10 ? other : sphere, snapshot.X_WD);
      if (frame % 16 == 8) session.forceOff();
      if (frame % 16 == 14) session.arm();
      // each watch of its own, so that one that went too early would be missed
      if (frame % 14 == 5) session.watch(std::make_shared<const haptics::Watch>(around));
      if (frame % 14 == 12) session.watch(nullptr);
      session.collectGarbage();
      ++frame;
      std::this_thread::sleep_for(std::chrono::milliseconds{5});
    }
    EXPECT_TRUE(off_seen);
    ticks += last;
    session.close();
    EXPECT_FALSE(session.isOpen());
    EXPECT_FALSE(session.latest(snapshot));
    EXPECT_EQ(session.forces({}), 0u);
  }
  std::cout << ticks << " ticks, " << snapshots << " snapshots, " << samples << " force samples\n";
  EXPECT_GT(ticks, 100u);
  EXPECT_GT(snapshots, 20u);
  EXPECT_GT(samples, 50u);
}

TEST(Session, ForceOffHoldsThroughEveryHandAndSceneUntilArmed) {
  const auto scene = smallScene();
  Session session;
  session.set({.isovalue = datasets::kSolidIso});
  session.adopt(scene, at(0, 0, 0.012));
  const auto ticks = [&](std::uint64_t count, haptics::ForceState wanted) {
    Snapshot snapshot;
    std::uint64_t wrong = 0, from = 0;
    while (snapshot.tick < from + count) {
      if (!session.latest(snapshot)) {
        std::this_thread::sleep_for(std::chrono::milliseconds{1});
        continue;
      }
      if (from == 0) from = snapshot.tick + 2;  // the word may come in the middle of a tick
      if (snapshot.tick > from)
        wrong += (snapshot.force_state == haptics::ForceState::Ready) !=
                 (wanted == haptics::ForceState::Ready);
    }
    return wrong;
  };
  ASSERT_TRUE(session.open(HandKind::Tap));
  EXPECT_EQ(ticks(20, haptics::ForceState::Ramping), 0u);
  session.forceOff();
  EXPECT_EQ(ticks(20, haptics::ForceState::Ready), 0u);
  session.adopt(smallScene(), at(0, 0, 0.012));
  EXPECT_EQ(ticks(20, haptics::ForceState::Ready), 0u);
  ASSERT_TRUE(session.open(HandKind::Slide));
  EXPECT_EQ(ticks(20, haptics::ForceState::Ready), 0u);
  session.arm();
  EXPECT_EQ(ticks(20, haptics::ForceState::Ramping), 0u);
}

TEST(Session, AHandThatCannotBeOpenedLeavesTheOldOne) {
  Session session;
  session.set({.isovalue = datasets::kSolidIso});
  session.adopt(smallScene(), at(0, 0, 0.012));
  ASSERT_TRUE(session.open(HandKind::Tap));
  session.set({.isovalue = 1e9});  // nothing reaches it: nothing to aim at
  EXPECT_FALSE(session.open(HandKind::Slide));
  EXPECT_TRUE(session.isOpen());
}

TEST(Session, MayBeDestroyedWhileItRuns) {
  const auto scene = smallScene();
  for (int n = 0; n < 20; ++n) {
    Session session;
    session.set({.isovalue = datasets::kSolidIso});
    session.adopt(scene, at(0, 0, 0.012));
    ASSERT_TRUE(session.open(HandKind::Tap));
    if (n % 2 == 0) std::this_thread::sleep_for(std::chrono::milliseconds{3});
  }
}

// steps go from a servo thread that runs to one that takes them, through hands that come and go
TEST(Session, RecordsUntilItHasLeftTheRing) {
  const auto sphere = made::scene(datasets::solid(datasets::centredGrid(48, 1e-3),
                                                  [](const auto& p) { return p.norm() - 0.015; }),
                                  made::tool(datasets::ballPoints(60, 3e-3)));
  Session session;
  session.set({.isovalue = datasets::kSolidIso});
  session.adopt(sphere, at(0, 0, 0.03));
  for (int round = 0; round < 4; ++round) {
    auto ring = std::make_shared<haptics::StepRing>(0);
    std::atomic<bool> ended{false};
    std::atomic<std::uint64_t> steps{0};
    std::uint64_t starts = 0, disorder = 0;
    std::thread taker{[&] {
      std::uint64_t next = 0;
      haptics::Step step;
      haptics::ProxyStart start;
      for (bool last = false; !last;) {
        last = ended;
        while (ring->take(start)) ++starts;
        while (ring->take(step)) {
          disorder += step.sequence != next++;
          ++steps;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds{1});
      }
    }};
    if (round % 2 == 0) {
      ASSERT_TRUE(session.open(HandKind::Slide));
    }
    session.record(ring);
    // the ring goes along to another hand
    while (steps < 100) std::this_thread::yield();
    ASSERT_TRUE(session.open(round % 2 == 0 ? HandKind::Tap : HandKind::Slide));
    const std::uint64_t before = steps;
    while (steps < before + 100) std::this_thread::yield();
    session.record(nullptr);
    if (round == 3) session.close();
    while (!session.hasLeftRing()) std::this_thread::yield();
    const std::uint64_t numbered = ring->numbered();
    ended = true;
    taker.join();
    EXPECT_EQ(ring.use_count(), 1);
    EXPECT_EQ(disorder, 0u);
    EXPECT_EQ(steps, numbered);  // nothing came after it was left
    EXPECT_GE(starts, 2u);
  }
}

}  // namespace
