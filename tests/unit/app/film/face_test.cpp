// SPDX-License-Identifier: BSD-3-Clause
#include "app/film/face.h"

#include <gtest/gtest.h>

#include <limits>

#include "app/film/camera.h"

namespace {

haptics::Volume volumeOf(haptics::Vec3 edges_mm, const char* unit) {
  haptics::Volume volume;
  volume.grid.dims = {100, 100, 100};
  volume.grid.spacing = edges_mm * 1e-5;
  volume.unit = unit;
  return volume;
}

TEST(Face, MayBeShownBelowBoneOrWhereTheUnitIsUnknown) {
  const haptics::Vec3 head(200.0, 200.0, 160.0);
  for (const double skin : {-900.0, -300.0, 0.0, 150.0, 199.0})
    EXPECT_TRUE(app::mayShowAFace(volumeOf(head, "HU"), skin)) << skin;
  for (const double bone : {200.0, 300.0, 1500.0})
    EXPECT_FALSE(app::mayShowAFace(volumeOf(head, "HU"), bone)) << bone;
  for (const double any : {-300.0, 40.0, 300.0, 1500.0})
    EXPECT_TRUE(app::mayShowAFace(volumeOf(head, ""), any)) << any;
  EXPECT_TRUE(app::mayShowAFace(volumeOf(head, "HU"), std::numeric_limits<double>::quiet_NaN()));
}

TEST(Face, HasNoRoomInASmallVolumeHoweverItLies) {
  EXPECT_FALSE(app::mayShowAFace(volumeOf({40.0, 40.0, 40.0}, ""), 0.0));
  EXPECT_FALSE(app::mayShowAFace(volumeOf({10.0, 200.0, 200.0}, "HU"), 0.0));
  EXPECT_FALSE(app::mayShowAFace(volumeOf({200.0, 50.0, 50.0}, "HU"), 0.0));
  EXPECT_TRUE(app::mayShowAFace(volumeOf({100.0, 25.0, 100.0}, "HU"), 0.0));
  EXPECT_TRUE(app::mayShowAFace(volumeOf({25.0, 100.0, 100.0}, "HU"), 0.0));
}

TEST(FilmCamera, IsReadAsItIsWritten) {
  const app::FilmCamera camera{{1.5, -300.25, 0.1}, {1.0, 2.0, 3.0}, {0.0, 0.6, 0.8}, 25.0};
  const auto read = app::cameraFrom(app::wordsOf(camera));
  ASSERT_TRUE(read);
  EXPECT_EQ(read->position_mm, camera.position_mm);
  EXPECT_EQ(read->focus_mm, camera.focus_mm);
  EXPECT_EQ(read->up, camera.up);
  EXPECT_EQ(read->angle_deg, camera.angle_deg);
}

TEST(FilmCamera, OfWhichNoPictureCanBeTakenIsNone) {
  for (const char* text :
       {"", "here", "[]", "{}",
        R"({"position_mm":[0,0],"focus_mm":[0,0,1],"up":[0,1,0],"angle_deg":30})",
        R"({"position_mm":[0,0,1],"focus_mm":[0,0,1],"up":[0,1,0],"angle_deg":30})",
        R"({"position_mm":[0,0,0],"focus_mm":[0,0,1],"up":[0,0,1],"angle_deg":30})",
        R"({"position_mm":[0,0,0],"focus_mm":[0,0,1],"up":[0,0,0],"angle_deg":30})",
        R"({"position_mm":[0,0,1e300],"focus_mm":[0,0,1],"up":[0,1,0],"angle_deg":30})",
        R"({"position_mm":[0,0,1e999],"focus_mm":[0,0,1],"up":[0,1,0],"angle_deg":30})",
        R"({"position_mm":["a",0,0],"focus_mm":[0,0,1],"up":[0,1,0],"angle_deg":30})",
        R"({"position_mm":[0,0,0],"focus_mm":[0,0,1],"up":[0,1,0],"angle_deg":180})",
        R"({"position_mm":[0,0,0],"focus_mm":[0,0,1],"up":[0,1,0],"angle_deg":-1})"})
    EXPECT_FALSE(app::cameraFrom(text)) << text;
}

TEST(FilmCamera, AroundABoxSeesItWholeAndFromNoFartherThanThatTakes) {
  const Eigen::AlignedBox3d box(haptics::Vec3(-40.0, -100.0, 10.0),
                                haptics::Vec3(60.0, 50.0, 90.0));
  for (const haptics::Vec3& from :
       {haptics::Vec3{0, -1, 0}, haptics::Vec3{1, 0.3, 0.7}, haptics::Vec3{-2, 5, -3}})
    for (const double aspect : {16.0 / 9.0, 0.5}) {
      std::vector<app::FilmBall> corners;
      for (int corner = 0; corner < 8; ++corner)
        corners.push_back({box.corner(Eigen::AlignedBox3d::CornerType(corner)), 0.0});
      const app::FilmCamera camera = app::cameraAround(corners, from, aspect);
      const haptics::Vec3 away = (camera.focus_mm - camera.position_mm).normalized();
      const haptics::Vec3 right = away.cross(camera.up).normalized(), up = right.cross(away);
      const double slope = std::tan(0.5 * camera.angle_deg * EIGEN_PI / 180.0);
      double widest = 0.0;
      for (int corner = 0; corner < 8; ++corner) {
        const haptics::Vec3 p =
            box.corner(Eigen::AlignedBox3d::CornerType(corner)) - camera.position_mm;
        ASSERT_GT(away.dot(p), 0.0);
        const double x = std::abs(right.dot(p) / away.dot(p) / slope / aspect);
        const double y = std::abs(up.dot(p) / away.dot(p) / slope);
        widest = std::max({widest, x, y});
      }
      EXPECT_NEAR(widest, 0.92, 1e-9);
    }
}

}  // namespace
