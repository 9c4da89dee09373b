// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "tests/scenario/fake_device.h"
#include "tests/scenario/trial.h"

namespace {

using haptics::DeviceStatus;
using haptics::ForceState;
using haptics::Pose;
using haptics::Snapshot;
using haptics::Vec3;
using haptics::Wrench;
using made::at;

bool isNoForce(const Wrench& wrench) {
  return (wrench.force.array() == 0.0).all() && (wrench.torque.array() == 0.0).all();
}

const Pose kAbove = at(0, 0, 0.030), kPressed = at(0, 0, 0.020);

/// A ball on the sphere phantom, pressed 3 mm in and felt in full.
struct Pressed : Stepped {
  Pressed() : Pressed{stageOf("sphere", ballTool(200, 3e-3))} {}
  explicit Pressed(const Stage& stage)
      : Stepped{stage.scene, stage.isovalue, kAbove}, scene{stage.scene} {
    device->X_BD = kPressed;
    steps(1200);
    EXPECT_EQ(snapshot().force_state, ForceState::On);
    EXPECT_GT(device->writes.back().force.z(), 2.0);  // N: 1000 N/m · 3 mm, and outwards
  }
  std::shared_ptr<const haptics::Scene> scene;
};

TEST(ServoLoop, ForceRampsInOverASecondAndStaysWithinTheRating) {
  const Stage stage = stageOf("sphere", ballTool(200, 3e-3));
  Stepped loop{stage.scene, stage.isovalue, kAbove};
  loop.settings.stiffness = 20'000.0;
  loop.set(stage.isovalue);
  loop.device->X_BD = kPressed;
  for (int n = 1; n <= 2000; ++n) {
    const Wrench sent = loop.step();
    ASSERT_LE(sent.force.norm(), 8.0 * std::min(1.0, n * 1e-3) + 1e-9) << "tick " << n;
    ASSERT_LE(sent.torque.norm(), 0.2 * std::min(1.0, n * 1e-3) + 1e-9);
  }
  EXPECT_NEAR(loop.device->writes.back().force.norm(), 8.0, 1e-9);
}

TEST(ServoLoop, EscapeMakesTheVeryNextWriteZeroUntilArmedAgain) {
  Pressed loop;
  loop.loop->armed = false;
  for (int n = 0; n < 50; ++n) ASSERT_TRUE(isNoForce(loop.step())) << n;
  EXPECT_EQ(loop.snapshot().force_state, ForceState::Ready);
  loop.loop->armed = true;
  EXPECT_LE(loop.step().force.norm(), 8.0 * 1e-3 + 1e-9);  // and from zero again
  loop.steps(1200);
  EXPECT_GT(loop.device->writes.back().force.z(), 2.0);
}

TEST(ServoLoop, AReadingThatIsNotANumberIsZeroForceAndThenForgotten) {
  Pressed loop;
  const Wrench before = loop.device->writes.back();
  for (const int place : {0, 5, 12, 15}) {
    loop.device->X_BD.matrix().data()[place] = NAN;
    for (int n = 0; n < 20; ++n) ASSERT_TRUE(isNoForce(loop.step()));
    loop.device->X_BD = kPressed;
    EXPECT_LE(loop.step().force.norm(), 8.0 * 1e-3 + 1e-9);  // in again over a second
    loop.steps(1200);
    const Wrench after = loop.device->writes.back();
    EXPECT_LT((after.force - before.force).norm(), 1e-6);  // N
    EXPECT_TRUE(loop.snapshot().X_WP.matrix().allFinite());
  }
}

TEST(ServoLoop, ALostDeviceIsStoppedAtZero) {
  Pressed loop;
  loop.device->status = DeviceStatus::Lost;
  for (int n = 0; n < 10; ++n) ASSERT_TRUE(isNoForce(loop.step()));
  EXPECT_TRUE(loop.device->stopped);
  EXPECT_FALSE(loop.loop->armed);
}

TEST(ServoLoop, AStaleReadingKeepsTheLastOne) {
  Pressed loop;
  const Wrench before = loop.device->writes.back();
  loop.device->status = DeviceStatus::Stale;
  EXPECT_LT((loop.step().force - before.force).norm(), 1e-9);
}

// the surface moves through the tool: under the slew limit, at every tick, whatever the new value
TEST(ServoLoop, AnIsovalueMovedWhileTouchingKeepsTheForceUnderTheSlewLimit) {
  const double slew = 8.0 / 20.0;  // N a tick: the rating in 20 ms
  for (const double isovalue : {-6000.0, -3000.0, 990.0, 1100.0, 6000.0, 12000.0}) {
    SCOPED_TRACE(isovalue);
    Pressed loop;
    Wrench last = loop.device->writes.back();
    loop.set(isovalue);
    for (int n = 0; n < 1500; ++n) {
      const Wrench sent = loop.step();
      ASSERT_LE((sent.force - last.force).norm(), slew + 1e-9) << "tick " << n;
      ASSERT_LE((sent.torque - last.torque).norm(), 0.2 / 20.0 + 1e-9) << "tick " << n;
      last = sent;
    }
    const Snapshot snapshot = loop.snapshot();
    EXPECT_EQ(snapshot.isovalue, isovalue);
    EXPECT_TRUE(evaluator::isLegal(*loop.scene->volume, isovalue, loop.scene->tool.shell.points,
                                   snapshot.X_WP));
  }
}

TEST(ServoLoop, TheIsovalueCountsFromTheNextTick) {
  Pressed loop;
  loop.set(1234.0);
  loop.step();
  EXPECT_EQ(loop.snapshot().isovalue, 1234.0);
}

TEST(ServoLoop, ANewSceneIsAdoptedAtTheNextTickWithTheForceFromZero) {
  Pressed loop;
  const Stage other = stageOf("halfspace", ballTool(100, 2e-3));
  loop.loop->scenes.offer(std::make_unique<haptics::Engagement>(other.scene, kAbove));
  EXPECT_LE(loop.step().force.norm(), 8.0 * 1e-3 + 1e-9);
  EXPECT_EQ(loop.snapshot().scene, other.scene->id);
  const std::weak_ptr<const haptics::Scene> old = loop.scene;
  loop.scene.reset();
  EXPECT_FALSE(old.expired());  // not on the servo's side
  loop.loop->scenes.collect();
  EXPECT_TRUE(old.expired());
}

TEST(ServoLoop, PublishesWhatItReadMovedAndSent) {
  Pressed loop;
  int contacts = 0;  // a tick that the time cut may know of none
  for (int n = 0; n < 20; ++n) {
    loop.step();
    contacts = std::max(contacts, loop.snapshot().contacts);
  }
  if (!haptics::kSanitized) {  // there the time cuts every tick
    EXPECT_GE(contacts, 1);
  }
  loop.step();
  const Snapshot snapshot = loop.snapshot();
  EXPECT_TRUE((snapshot.X_WD.matrix().array() == kPressed.matrix().array()).all());
  EXPECT_EQ(snapshot.felt_W.force, loop.device->writes.back().force);
  EXPECT_EQ(snapshot.tick, 1221u);
  EXPECT_NEAR(snapshot.coupling_W.force.z(), 1000.0 * (snapshot.X_WP.translation().z() - 0.020),
              1e-9);
  haptics::ForceSample sample;
  std::size_t count = 0;
  while (loop.loop->forces.try_dequeue(sample)) ++count;
  EXPECT_EQ(count, 1221u);
  EXPECT_NEAR(sample.force, snapshot.felt_W.force.norm(), 1e-5);
}

}  // namespace
