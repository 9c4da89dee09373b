// SPDX-License-Identifier: BSD-3-Clause
// Where a replay begins anew: the state of the proxy is the one that a start stores, and no more.
#include <gtest/gtest.h>

#include <limits>

#include "haptics/proxy/tick.h"
#include "haptics/simulation/hand.h"
#include "tests/unit/app/recording/recorded_hand.h"

namespace recording_tests {
namespace {

// A replay goes on from a start with a new proxy, and the live one has only forgotten.
TEST(Recording, AProxyThatForgotIsAsANewOneWhereverTicksAreCut) {
  const auto touched = scene();
  const auto hand = Hand::aimed(HandMotion::Slide, *touched, 0.0, 0.012, 1);
  ASSERT_TRUE(hand);
  const VirtualCoupling coupling{Settings{}.stiffness};
  const auto step = [&](Proxy& proxy, int n, Budget& budget) {
    return tick(*touched, 0.0, coupling, hand->at(1e-3 * n), proxy, budget, 1e-3).contacts;
  };
  Proxy live(*touched, hand->at(0.0));
  int cut = 0, touching = 0;
  for (int n = 0; n < 12'000; ++n) {
    Budget whole = Budget::counted(std::numeric_limits<std::int64_t>::max());
    touching += step(live, n, whole) > 0;
    if (n < 1000 || n % 500 != 0) continue;
    for (int work = 300; work < 1000; work += 13) {
      Proxy old = live;
      old.forget();
      Proxy fresh(*touched, old.X_WP);
      fresh.turn = old.turn;
      for (int later = n + 1; later < n + 6; ++later) {
        Budget a = Budget::counted(work), b = Budget::counted(work);
        step(old, later, a);
        step(fresh, later, b);
        cut += a.cut();
        ASSERT_EQ(a.spent(), b.spent()) << "after tick " << n << ", work " << work;
        ASSERT_TRUE(same(old.X_WP, fresh.X_WP)) << "after tick " << n << ", work " << work;
      }
    }
  }
  EXPECT_GT(cut, 100);
  EXPECT_GT(touching, 1000);
}

}  // namespace
}  // namespace recording_tests
