// SPDX-License-Identifier: BSD-3-Clause
// Structures that are solid or not there: touched, and not seen.
#include <gtest/gtest.h>

#include <functional>
#include <memory>

#include "app/application.h"
#include "app/window/edits/edit_controller.h"
#include "app/window/scan/loader.h"
#include "app/window/structures/structures_controller.h"
#include "datasets/edits/walls.h"
#include "haptics/scene/watch.h"
#include "haptics/session.h"
#include "tests/support/made_distances.h"
#include "tests/ui/views/sphere_in_hand.h"
#include "tests/ui/window_support.h"
#include "ui/window/main_window.h"
#include "ui/window/views.h"

namespace {

using haptics::Feel;
using haptics::Vec3;
using window::sphereInHand;
using window::waitFor;

TEST(StructuresAsWalls, AreTouchedAndNotSeen) {
  app::Application application(sphereInHand("mouse"));
  application.start();
  ASSERT_TRUE(waitFor([&] { return application.snapshot().scene != 0; }));
  const auto shown = [&]() -> const app::Loaded& { return *application.shown(); };
  const auto wallsNow = [&] { return datasets::walledOf(*shown().scene->volume); };
  /// The touch has these walls: the scene on view is the one of the session.
  const auto touches = [&](const std::function<bool()>& done) {
    return waitFor([&] { return done() && application.snapshot().scene == shown().scene->id; });
  };
  const auto scan = shown().volume();
  const double isovalue = shown().isovalue;
  EXPECT_EQ(wallsNow(), nullptr);

  auto watch = std::make_shared<haptics::Watch>();
  const Vec3 middle = scan->grid.worldOf({0.5 * double(scan->grid.dims[0]), 0.0, 0.0});
  watch->structures.push_back(
      {2,
       made::distanceMap(scan->grid, [&](const Vec3& p) { return (p - middle).norm() - 0.008; }),
       {.kind = Feel::Kind::Solid}});
  auto& structures = application.structures();
  emit structures.watchGiven(watch);
  ASSERT_TRUE(touches([&] { return wallsNow() != nullptr; }));
  EXPECT_EQ(wallsNow()->walls, (std::vector<datasets::Walled::Wall>{{2, true}}));
  EXPECT_EQ(wallsNow()->isovalue, isovalue);
  const auto solidAt = [&](const haptics::Volume& volume) {
    const auto at = [&](const auto* v) { return double(v[scan->grid.dims[0] / 2]); };
    return haptics::visitVoxels(volume.type, volume.voxels.get(), at) >= isovalue;
  };
  EXPECT_TRUE(solidAt(*shown().scene->volume));
  EXPECT_FALSE(solidAt(*shown().volume()));
  // what one sees is the scan
  EXPECT_EQ(shown().volume(), scan);
  EXPECT_EQ(shown().picture.volume, scan);

  // another isovalue: they are made again at it
  emit application.window().views().isovalueWanted(isovalue + 40.0);
  ASSERT_TRUE(touches([&] { return wallsNow() != nullptr && wallsNow()->isovalue != isovalue; }));
  EXPECT_EQ(wallsNow()->isovalue, application.snapshot().isovalue);

  // an edit: they follow
  application.editing().restore({datasets::PlaneCut{
      scan->grid.worldOf({0, 0, 0.75 * double(scan->grid.dims[2])}), Vec3::UnitZ(), isovalue}});
  ASSERT_TRUE(touches([&] { return shown().volume() != scan && wallsNow() != nullptr; }));
  EXPECT_EQ(wallsNow()->edits.size(), 1U);
  EXPECT_EQ(wallsNow()->seen, shown().volume());

  // none is felt so any more: the edited scan itself is touched
  emit structures.watchGiven(nullptr);
  ASSERT_TRUE(touches([&] { return wallsNow() == nullptr; }));
  EXPECT_EQ(shown().scene->volume, shown().volume());
  EXPECT_EQ(datasets::editedOf(*shown().volume())->edits.size(), 1U);
}

}  // namespace
