// SPDX-License-Identifier: BSD-3-Clause
#include "ui/views/volume_view.h"

#include <gtest/gtest.h>

#include <vtkCamera.h>
#include <vtkImageData.h>
#include <vtkPolyData.h>

#include <QTest>
#include <filesystem>
#include <string>
#include <utility>

#include "datasets/phantoms/phantoms.h"
#include "datasets/readers/volume_reader.h"
#include "tests/support/places.h"
#include "tests/support/sentence.h"
#include "tests/ui/window_support.h"

namespace {

using haptics::Mat3;
using haptics::Vec3;
using ui::SurfaceMode;

const char* nameOf(SurfaceMode mode) { return mode == SurfaceMode::Mesh ? "mesh" : "raycast"; }

ui::Picture ballPicture(const Vec3& centre_W, double radius,
                        const Mat3& direction = Mat3::Identity(),
                        haptics::ScalarType type = haptics::ScalarType::Int16) {
  return ui::pictureOf(
      window::volumeOf(window::cubeGrid(64, direction), type, window::ball(centre_W, radius)));
}

haptics::Snapshot at(const Vec3& proxy_W, const Vec3& device_W) {
  haptics::Snapshot snapshot;
  snapshot.X_WP.translation() = proxy_W;
  snapshot.X_WD.translation() = device_W;
  return snapshot;
}

TEST(VolumeView, LooksAtFirstFromTheFrontLeftAndAboveAndFillsTheViewWithTheSurface) {
  ui::VolumeView view;
  window::showAndWait(view, {500, 400});
  // a ball beside the middle of the grid, and a few specks far away from it
  const Vec3 centre{-0.008, 0.009, 0.008};
  const auto ball = window::ball(centre, 0.020);
  view.show(ui::pictureOf(window::volumeOf(
                window::cubeGrid(64), haptics::ScalarType::Int16,
                [&](const Vec3& p) {
                  return (p - Vec3{0.0285, -0.0285, -0.0285}).norm() < 5e-4 ? 100.0 : ball(p);
                })),
            50.0);
  const Eigen::Matrix3d axes = view.viewAxes();
  EXPECT_GT(axes(0, 2), 0.2);   // from the patient's left
  EXPECT_LT(axes(1, 2), -0.5);  // and the front
  EXPECT_GT(axes(2, 2), 0.2);   // and above
  EXPECT_GT(axes(2, 1), 0.7);   // the head is up
  const QPointF middle = view.projected(centre);
  EXPECT_LT(QLineF(middle, QPointF(250, 200)).length(), 8.0);
  const double radius = QLineF(middle, view.projected(centre + 0.020 * axes.col(1))).length();
  EXPECT_GT(radius, 0.7 * 200.0);
  EXPECT_LT(radius, 0.95 * 200.0);
}

TEST(VolumeView, LooksAtASlabFromItsBroadSide) {
  ui::VolumeView view;
  window::showAndWait(view, {500, 400});
  for (int thin = 0; thin < 3; ++thin) {
    view.show(ui::pictureOf(window::volumeOf(window::cubeGrid(64), haptics::ScalarType::Int16,
                                             [&](const Vec3& p) {
                                               Vec3 scaled = p;
                                               scaled[thin] *= 10.0;
                                               return scaled.cwiseAbs().maxCoeff() < 0.025 ? 100.0
                                                                                           : 0.0;
                                             })),
              50.0);
    EXPECT_GT(std::abs(view.viewAxes()(thin, 2)), 0.75) << thin;
    EXPECT_GT(view.viewAxes()(0, 2), 0.0);
    EXPECT_LT(view.viewAxes()(1, 2), 0.0);
    EXPECT_GT(view.viewAxes()(2, 2), 0.0);
  }
}

TEST(VolumeView, DrawsTheProxyWhereItIsAndTheDeviceInsideTheBone) {
  for (const SurfaceMode mode : {SurfaceMode::Mesh, SurfaceMode::RayCast}) {
    SCOPED_TRACE(nameOf(mode));
    ui::VolumeView view;
    view.setSurfaceWish(mode);
    window::showAndWait(view, {400, 400});
    view.show(ballPicture(Vec3::Zero(), 0.020), 50.0);
    view.show(window::octahedron(0.003));
    for (const Vec3& proxy : {Vec3{0.004, -0.026, 0.006}, Vec3{-0.008, -0.025, -0.009}}) {
      const Vec3 device = proxy * 0.4;  // well inside the ball
      view.display(at(proxy, device));
      const QImage image = window::pictureAtRest(view);
      window::keep(image, mode == SurfaceMode::Mesh ? "tool_mesh" : "tool_raycast");
      EXPECT_GT(window::count(image, window::surfaceColoured), 10'000);
      const QPointF seen = window::centroid(image, window::proxyColoured);
      const QPointF meant = view.projected(proxy);
      EXPECT_LT(QLineF(seen, meant).length(), 3.0);  // px
      const QPointF wire = window::centroid(image, window::deviceColoured);
      EXPECT_LT(QLineF(wire, view.projected(device)).length(), 6.0);
      EXPECT_GT(window::count(image, window::deviceColoured), 20);
    }
    // behind the ball the proxy is hidden, the device is not
    view.display(at({0.0, 0.030, 0.0}, {0.0, 0.005, 0.0}));
    const QImage behind = window::pictureAtRest(view);
    window::keep(behind, mode == SurfaceMode::Mesh ? "behind_mesh" : "behind_raycast");
    EXPECT_EQ(window::count(behind, window::proxyColoured), 0);
    EXPECT_GT(window::count(behind, window::deviceColoured), 20);
  }
}

TEST(VolumeView, PutsLOnTheSideOfTheLeftMarkerWhicheverWayTheVoxelsLie) {
  Mat3 permuted, left_handed;
  permuted << 0, 0, 1, 1, 0, 0, 0, 1, 0;
  left_handed = Vec3{1.0, 1.0, -1.0}.asDiagonal();
  const Mat3 oblique = Eigen::AngleAxisd(0.5, Vec3{1.0, 2.0, 0.5}.normalized()).toRotationMatrix() *
                       Vec3{-1.0, 1.0, 1.0}.asDiagonal();
  const Vec3 marker{0.016, -0.004, 0.010};  // left, front, head
  for (const SurfaceMode mode : {SurfaceMode::Mesh, SurfaceMode::RayCast})
    for (const Mat3& direction : {Mat3{Mat3::Identity()}, permuted, left_handed, oblique}) {
      SCOPED_TRACE(testing::Message() << nameOf(mode) << "\n" << direction);
      ui::VolumeView view;
      view.setSurfaceWish(mode);
      window::showAndWait(view, {300, 300});
      view.show(ballPicture(marker, 0.008, direction), 50.0);
      // look at the volume's middle, not at the marker
      view.camera()->SetFocalPoint(0.0, 0.0, 0.0);
      view.camera()->SetPosition(0.0, -180.0, 0.0);
      const QImage image = window::pictureAtRest(view);
      window::keep(image, mode == SurfaceMode::Mesh ? "left_mesh" : "left_raycast");
      const QPointF seen = window::centroid(image, window::surfaceColoured, 200);
      const QPointF meant = view.projected(marker);
      EXPECT_LT(QLineF(seen, meant).length(), 3.0);
      // seen from the front, the patient's left is on the right; letters_test reads the letter
      EXPECT_EQ(ui::edgeLettersOf(view.viewAxes())[1], "L");
      EXPECT_GT(seen.x(), 160.0);
      const auto yellow = [](QColor c) {
        return c.red() > 170 && c.green() > 130 && c.blue() < 90;
      };
      EXPECT_GT(window::count(image.copy(270, 136, 28, 28), yellow), 20);
      // lit from the viewer: the middle of the ball is bright, so its normals point outwards
      EXPECT_GT(image.pixelColor(meant.toPoint()).red(), 150);
    }
}

TEST(VolumeView, WantsOneFineMeshOfEachPictureAndIsovalue) {
  const ui::Picture picture = ballPicture({0.003, 0.0, -0.002}, 0.020);
  ui::VolumeView view;
  int wanted = 0;
  QObject::connect(&view, &ui::VolumeView::fineMeshWanted, &view, [&](double isovalue) {
    ++wanted;
    view.showFine(ui::isosurfaceMesh(picture.image, isovalue, picture.mirrored()), isovalue);
  });
  view.setSurfaceWish(SurfaceMode::Mesh);
  window::showAndWait(view, {300, 300});
  view.show(picture, 50.0);
  window::rest(view);
  EXPECT_EQ(wanted, 1);
  view.lookFrom(ui::Side::Left);
  window::rest(view);
  EXPECT_EQ(wanted, 1);
  view.setIsovalue(60.0);
  window::rest(view);
  EXPECT_EQ(wanted, 2);
  view.renew(picture);  // the old one is shown until this one's is there
  window::rest(view);
  EXPECT_EQ(wanted, 3);
  view.replace(picture);
  window::rest(view);
  EXPECT_EQ(wanted, 4);
}

TEST(VolumeView, CastsTheSameSilhouetteAsTheMeshAndRefinesTheHit) {
  const ui::Picture picture = ballPicture({0.003, 0.0, -0.002}, 0.020);
  QImage shown[2];
  QImage unrefined;
  for (const SurfaceMode mode : {SurfaceMode::Mesh, SurfaceMode::RayCast}) {
    ui::VolumeView view;
    view.setSurfaceWish(mode);
    window::showAndWait(view, {300, 300});
    view.show(picture, 50.0);
    view.showFine(ui::isosurfaceMesh(picture.image, 50.0, picture.mirrored()), 50.0);
    shown[static_cast<int>(mode)] = window::pictureAtRest(view);
    if (mode == SurfaceMode::RayCast) {
      view.surface().setHitRefinement(false);
      view.redraw();
      unrefined = window::pictureAtRest(view);
    }
  }
  const QImage& cast = shown[static_cast<int>(SurfaceMode::RayCast)];
  const QImage& mesh = shown[static_cast<int>(SurfaceMode::Mesh)];
  window::keep(cast, "silhouette_raycast");
  window::keep(mesh, "silhouette_mesh");
  window::keep(unrefined, "silhouette_unrefined");
  const double area_cast = window::count(cast, window::surfaceColoured);
  const double area_mesh = window::count(mesh, window::surfaceColoured);
  // one voxel at the rim of a ball of 20: a tenth of its area
  EXPECT_GT(area_mesh, 5'000);
  EXPECT_NEAR(area_cast / area_mesh, 1.0, 0.05);
  EXPECT_LT(QLineF(window::centroid(cast, window::surfaceColoured),
                   window::centroid(mesh, window::surfaceColoured))
                .length(),
            1.5);
  EXPECT_GT(window::differing(cast, unrefined, 4), 0.01);
}

TEST(VolumeView, DrawsEveryScalarTypeByRayCasting) {
  using haptics::ScalarType;
  for (const ScalarType type :
       {ScalarType::UInt8, ScalarType::Int8, ScalarType::UInt16, ScalarType::Int16,
        ScalarType::UInt32, ScalarType::Int32, ScalarType::Float32}) {
    SCOPED_TRACE(haptics::nameOf(type));
    ui::VolumeView view;
    view.setSurfaceWish(SurfaceMode::RayCast);
    window::showAndWait(view, {200, 200});
    view.show(ballPicture(Vec3::Zero(), 0.020, Mat3::Identity(), type), 50.0);
    const QImage image = window::pictureAtRest(view);
    window::keep(image, haptics::nameOf(type));
    EXPECT_GT(window::count(image, window::surfaceColoured), 3'000);
  }
}

TEST(VolumeView, TintsWhatWasCutAndNothingElseHoweverFarASingleValueIs) {
  using haptics::ScalarType;
  const auto ball = window::ball(Vec3::Zero(), 0.016);
  const auto drawn = [&](ScalarType type, double far_off, bool pit) {
    const auto made = [&](bool cut) {
      return window::volumeOf(window::cubeGrid(48), type, [&, cut](const Vec3& p) {
        if ((p - Vec3::Constant(0.0225)).norm() < 5e-4) return far_off;
        return cut && (p - Vec3{0.0, -0.016, 0.0}).norm() < 0.005 ? 0.0 : ball(p);
      });
    };
    const auto scan = made(false), left = pit ? made(true) : scan;
    ui::VolumeView view;
    view.setSurfaceWish(SurfaceMode::RayCast);
    window::showAndWait(view, {200, 200});
    view.show(ui::pictureOf(left), 50.0);
    view.resetCamera();
    view.showLive(*left, scan, {});
    view.carve(left->bounds());
    const QImage image = window::pictureAtRest(view);
    window::keep(image,
                 (std::string("tinted_") + haptics::nameOf(type) + (pit ? "_pit" : "")).c_str());
    EXPECT_GT(window::count(image, [](QColor c) { return c.red() > 60; }), 2'000);
    return window::count(image, window::cutColoured);
  };
  for (const auto& [type, far_off] : {std::pair{ScalarType::UInt8, 255.0},
                                      {ScalarType::Int16, 30'000.0},
                                      {ScalarType::UInt32, 4e9},
                                      {ScalarType::Float32, 3e38}}) {
    SCOPED_TRACE(haptics::nameOf(type));
    EXPECT_LT(drawn(type, far_off, false), 5);
  }
  EXPECT_GT(drawn(ScalarType::Int16, 30'000.0, true), 100);
}

TEST(VolumeView, ShowsACutFaceAsSolid) {
  for (const SurfaceMode mode : {SurfaceMode::Mesh, SurfaceMode::RayCast}) {
    SCOPED_TRACE(nameOf(mode));
    ui::VolumeView view;
    view.setSurfaceWish(mode);
    window::showAndWait(view, {300, 300});
    // the ball reaches through the front face of the volume
    view.show(ballPicture({0.0, -0.0315, 0.0}, 0.020), 50.0);
    const QImage image = window::pictureAtRest(view);
    window::keep(image, mode == SurfaceMode::Mesh ? "cut_mesh" : "cut_raycast");
    EXPECT_TRUE(window::surfaceColoured(image.pixelColor(150, 150)));
    EXPECT_GT(window::count(image, window::surfaceColoured), 5'000);
  }
}

TEST(VolumeView, DoesNotDrawTheSurfaceAgainWhenOnlyTheToolMoves) {
  ui::VolumeView view;
  view.setSurfaceWish(SurfaceMode::Mesh);
  window::showAndWait(view, {300, 300});
  view.show(ballPicture(Vec3::Zero(), 0.020), 50.0);
  view.show(window::octahedron(0.003));
  window::pictureAtRest(view);
  const int before = view.frames();
  view.display(at({0.0, -0.025, 0.0}, {0.0, -0.025, 0.0}));
  view.display(at({0.0, -0.025, 0.0}, {0.0, -0.025, 0.0}));  // not moved: nothing to draw
  window::pictureAtRest(view);
  EXPECT_EQ(view.frames(), before + 1);
}

TEST(VolumeView, LooksFromInFrontAtAToolStraightAbove) {
  ui::VolumeView view;
  view.setSurfaceWish(SurfaceMode::Mesh);
  window::showAndWait(view, {400, 400});
  view.show(ballPicture(Vec3::Zero(), 0.020), 50.0);
  view.show(window::octahedron(0.003));
  const Vec3 middle = view.surface().bounds_mm().center() * 1e-3;
  for (const double z : {0.03, -0.03}) {
    const Vec3 above = middle + z * Vec3::UnitZ();
    view.display(at(above, above));
    view.lookFromTool();
    const QPointF seen = view.projected(above);
    EXPECT_GT(seen.x(), 100.0);
    EXPECT_LT(seen.x(), 300.0);
    EXPECT_EQ(seen.y() < 200.0, z > 0.0);
  }
}

TEST(VolumeView, TurnsTheCameraOrMovesTheHand) {
  ui::VolumeView view;
  window::showAndWait(view, {300, 300});
  view.show(ballPicture(Vec3::Zero(), 0.020), 50.0);
  view.show(window::octahedron(0.003));
  view.display(at({0.0, -0.03, 0.0}, {0.0, -0.03, 0.0}));
  std::optional<haptics::Pose> hand;
  QObject::connect(&view, &ui::VolumeView::handPulled,
                   [&](const haptics::Pose& X_WH) { hand = X_WH; });
  const auto drag = [&](QPoint by, Qt::MouseButton button, Qt::KeyboardModifiers keys = {}) {
    QTest::mousePress(&view, button, keys, {150, 150});
    // QTest's moves carry no buttons: send the event itself
    QMouseEvent move(QEvent::MouseMove, QPointF{150, 150} + by,
                     view.mapToGlobal(QPointF{150, 150} + by), Qt::NoButton, button, keys);
    QCoreApplication::sendEvent(&view, &move);
    QTest::mouseRelease(&view, button, keys, QPoint{150, 150} + by);
  };
  const double* eye = view.camera()->GetPosition();
  const Vec3 before{eye};
  drag({40, 0}, Qt::LeftButton);
  EXPECT_FALSE(hand.has_value());
  EXPECT_GT((Vec3{view.camera()->GetPosition()} - before).norm(), 10.0);  // mm

  view.setMouseHand(true);
  view.setMouseMode(ui::MouseMode::Hand);
  drag({40, 0}, Qt::LeftButton);
  EXPECT_FALSE(hand.has_value());  // the last pose was another hand's
  view.resetCamera();
  view.display(at({0.0, -0.03, 0.0}, {0.0, -0.03, 0.0}));
  drag({40, 0}, Qt::LeftButton);
  ASSERT_TRUE(hand.has_value());
  EXPECT_GT(hand->translation().x(), 0.003);  // to the right: the patient's left
  EXPECT_NEAR(hand->translation().y(), -0.03, 1e-6);
  // the hand's pixel is the mouse's
  EXPECT_NEAR(view.projected(hand->translation()).x() - view.projected({0, -0.03, 0}).x(), 40.0,
              0.5);
  drag({0, -40}, Qt::LeftButton);
  EXPECT_GT(hand->translation().z(), 0.003);  // up: the head
  drag({40, 0}, Qt::LeftButton, Qt::ShiftModifier);
  EXPECT_GT(Eigen::AngleAxisd(hand->linear()).angle(), 0.1);
  QWheelEvent wheel({150, 150}, view.mapToGlobal(QPointF{150, 150}), {}, {0, 120}, {}, {},
                    Qt::NoScrollPhase, false);
  QCoreApplication::sendEvent(&view, &wheel);
  EXPECT_GT(hand->translation().y(), -0.029);  // away from the viewer: into the patient
}

TEST(VolumeView, ChoosesTheMeansByWhatTheGraphicsCan) {
  haptics::Grid grid = window::cubeGrid(64);
  ui::Graphics card{.major = 4, .minor = 6, .renderer = "A card", .max_3d_texture = 2048};
  EXPECT_EQ(ui::chooseSurface({}, card, grid).mode, SurfaceMode::RayCast);
  EXPECT_EQ(ui::chooseSurface(SurfaceMode::Mesh, card, grid).mode, SurfaceMode::Mesh);
  ui::Graphics software = card;
  software.renderer = "llvmpipe (LLVM 15.0.6, 256 bits)";
  EXPECT_EQ(ui::chooseSurface({}, software, grid).mode, SurfaceMode::Mesh);
  EXPECT_EQ(ui::chooseSurface(SurfaceMode::RayCast, software, grid).mode, SurfaceMode::RayCast);
  ui::Graphics old = card;
  old.major = 3;
  old.minor = 1;
  EXPECT_EQ(ui::chooseSurface(SurfaceMode::RayCast, old, grid).mode, SurfaceMode::Mesh);
  grid.dims[1] = 4096;
  EXPECT_EQ(ui::chooseSurface(SurfaceMode::RayCast, card, grid).mode, SurfaceMode::Mesh);
  // no axis too long, and more than a card holds
  EXPECT_EQ(ui::chooseSurface(SurfaceMode::RayCast, card, window::cubeGrid(1024)).mode,
            SurfaceMode::RayCast);
  EXPECT_EQ(ui::chooseSurface(SurfaceMode::RayCast, card, window::cubeGrid(1025)).mode,
            SurfaceMode::Mesh);
}

// the real head, from its folder beside the checkout, or in its place the made one
std::shared_ptr<const haptics::Volume> head() {
  const std::filesystem::path path = places::scan("visible_human_female_head");
  for (const auto& entry : std::filesystem::exists(path) ? std::filesystem::directory_iterator(path)
                                                         : std::filesystem::directory_iterator()) {
    if (entry.path().extension() != ".nrrd" && entry.path().extension() != ".nhdr") continue;
    auto volume = datasets::readVolume(entry.path());
    if (volume) return std::make_shared<const haptics::Volume>(std::move(*volume));
    ADD_FAILURE() << sentence(volume.error());
  }
  auto made = datasets::makePhantom("demo");
  return std::make_shared<const haptics::Volume>(std::move(made.value().volume));
}

TEST(VolumeView, ShowsBoneAndSkinOfTheHeadUnlike) {
  const auto volume = head();
  const ui::Picture picture = ui::pictureOf(volume);
  ui::VolumeView view;
  view.setSurfaceWish(SurfaceMode::Mesh);
  window::showAndWait(view, {500, 500});
  view.show(picture, 300.0);
  const QImage bone = window::pictureAtRest(view);
  view.setIsovalue(-300.0);
  const QImage skin = window::pictureAtRest(view);
  window::keep(bone, "head_bone");
  window::keep(skin, "head_skin");
  // the made head is farther from the edges of its picture
  const bool real = std::filesystem::exists(places::scan("visible_human_female_head"));
  EXPECT_GT(window::differing(bone, skin), real ? 0.20 : 0.08);
}

TEST(VolumeView, CastsTheHeadAsTheMeshShowsIt) {
  const auto volume = head();
  const ui::Picture picture = ui::pictureOf(volume);
  QImage shown[2];
  for (const SurfaceMode mode : {SurfaceMode::Mesh, SurfaceMode::RayCast}) {
    ui::VolumeView view;
    view.setSurfaceWish(mode);
    window::showAndWait(view, {200, 150});
    view.show(picture, -300.0);
    if (mode == SurfaceMode::Mesh)
      view.showFine(ui::isosurfaceMesh(picture.image, -300.0, picture.mirrored()), -300.0);
    shown[static_cast<int>(mode)] = window::pictureAtRest(view);
    window::keep(shown[static_cast<int>(mode)],
                 mode == SurfaceMode::Mesh ? "head_small_mesh" : "head_small_raycast");
  }
  // a pixel is larger than a voxel here: count pixels without an equal beside them
  const auto solid = [](QColor c) { return c.red() > c.blue() + 4 && c.red() < 200 + c.blue(); };
  const auto beside = [&](const QImage& image, int x, int y) {
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx)
        if (image.rect().contains(x + dx, y + dy) && solid(image.pixelColor(x + dx, y + dy)))
          return true;
    return false;
  };
  int lonely = 0, all = 0;
  for (int i = 0; i < 2; ++i)
    for (int y = 0; y < shown[i].height(); ++y)
      for (int x = 0; x < shown[i].width(); ++x)
        if (solid(shown[i].pixelColor(x, y))) {
          ++all;
          lonely += !beside(shown[1 - i], x, y);
        }
  EXPECT_GT(all, 4'000);
  EXPECT_LE(lonely, all / 200);
}

}  // namespace
