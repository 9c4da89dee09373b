// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <iostream>
#include <limits>

#include "datasets/phantoms/making.h"
#include "datasets/phantoms/sampling.h"
#include "tests/scenario/trial.h"
#include "tests/support/millimetre.h"

namespace {

using datasets::Random;
using haptics::Budget;
using haptics::Pose;
using haptics::Quat;
using haptics::Vec3;
using made::at;
using millimetre::h;

// the clock cuts where it will; by the counts at which it did, another proxy goes the same way
TEST(Replay, OfTicksThatTheClockCutIsTheSameToTheBit) {
  Random grain{231};
  const auto scene = made::scene(
      datasets::sampledFloat(datasets::centredGrid(48, h),
                             [&](const Vec3& p) {
                               return std::clamp(1e5 * (0.015 - p.norm()), -300.0, 300.0) +
                                      grain.in(-60.0, 60.0);
                             }),
      ballTool(5000, 4e-3));
  const haptics::VirtualCoupling coupling{1000.0, 0.0};
  for (const double friction : {0.0, 0.4}) {
    haptics::VirtualCoupling felt = coupling;
    felt.friction = friction;
    Random random{232};
    Pose D = at(0, 0, 0.03);
    haptics::Proxy live{*scene, D}, replayed{*scene, D};
    int cut = 0, whole = 0, contact = 0, recovered = 0;
    Pose target = D;
    for (int n = 0; n < made::trials(3000); ++n) {
      if (n % 50 == 0) target = at(random.in(0.012, 0.02) * random.direction(), random.rotation());
      D = at(D.translation() + 0.05 * (target.translation() - D.translation()),
             Quat{D.linear()}.slerp(0.05, Quat{target.linear()}));
      // now and then the surface leaps past the tool
      const double isovalue = n % 500 > 480 ? -150.0 : 0.0;
      // from a few microseconds to more than it needs
      Budget clock = Budget::timed(random.below(4) == 0 ? 10'000'000 : 1000 * random.below(150));
      const haptics::TickResult first = haptics::tick(*scene, isovalue, felt, D, live, clock, 1e-3);
      Budget count =
          Budget::counted(clock.cut() ? clock.cutAt() : std::numeric_limits<std::int64_t>::max());
      const haptics::TickResult again =
          haptics::tick(*scene, isovalue, felt, D, replayed, count, 1e-3);
      ASSERT_EQ(replayed.X_WP.matrix(), live.X_WP.matrix()) << "tick " << n;
      ASSERT_EQ(again.wrench_W.force, first.wrench_W.force);
      ASSERT_EQ(again.wrench_W.torque, first.wrench_W.torque);
      ASSERT_EQ(again.contacts, first.contacts);
      ASSERT_EQ(again.cut, first.cut);
      ASSERT_EQ(count.spent(), clock.spent());
      (clock.cut() ? cut : whole) += 1;
      contact += first.contacts > 0;
      recovered += !first.outside;
    }
    std::cout << cut << " ticks cut by the clock, " << whole << " not, " << contact
              << " in contact, " << recovered << " inside\n";
    EXPECT_GT(cut, made::trials(3000) / 10);
    EXPECT_GT(contact, made::trials(3000) / 20);
    // under a sanitizer nearly every tick is cut, and the isovalue moves too late
    if (made::trials(10) == 10) {
      EXPECT_GT(whole, made::trials(3000) / 10);
      EXPECT_GT(recovered, 0);
    }
  }
}

}  // namespace
