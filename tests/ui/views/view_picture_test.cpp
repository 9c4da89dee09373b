// SPDX-License-Identifier: BSD-3-Clause
// What is seen in the 3-D view: tool, contacts, colours, the second surface, cropped and edited
// voxels, the cube, and pictures of it all.
#include <gtest/gtest.h>
#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkDataArray.h>
#include <vtkFeatureEdges.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <QAction>
#include <QBuffer>
#include <QImageReader>
#include <QMenu>
#include <QPainter>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <cmath>
#include <filesystem>

#include "datasets/readers/volume_reader.h"
#include "tests/support/sentence.h"
#include "tests/ui/window_support.h"
#include "ui/views/volume_view.h"
#include "ui/window/main_window.h"
#include "ui/window/screenshot.h"
#include "ui/window/touch_state.h"
#include "ui/window/views.h"

namespace {

using haptics::Vec3;
using ui::SurfaceMode;

constexpr std::array kModes{SurfaceMode::Mesh, SurfaceMode::RayCast};
const char* wordOf(SurfaceMode mode) { return mode == SurfaceMode::Mesh ? "mesh" : "raycast"; }

std::shared_ptr<haptics::Volume> ballVolume(double radius, const char* unit = "") {
  haptics::VolumeFacts facts;
  facts.unit = unit;
  return std::make_shared<haptics::Volume>(*window::volumeOf(
      window::cubeGrid(64), haptics::ScalarType::Int16, window::ball(Vec3::Zero(), radius), facts));
}

haptics::Snapshot placed(const Vec3& proxy_W, const Vec3& device_W) {
  haptics::Snapshot snapshot;
  snapshot.X_WP.translation() = proxy_W;
  snapshot.X_WD.translation() = device_W;
  return snapshot;
}

void open(ui::VolumeView& view, SurfaceMode mode, QSize size = {400, 400}) {
  view.setSurfaceWish(mode);
  window::showAndWait(view, size);
}

TEST(ViewPicture, ShowsTheDeviceOnlyWhereItDiffersFromTheProxy) {
  ui::VolumeView view;
  open(view, SurfaceMode::Mesh);
  view.show(ui::pictureOf(ballVolume(0.020)), 50.0);
  view.show(window::octahedron(0.004));
  const Vec3 place{0.0, -0.030, 0.0};
  view.display(placed(place, place + Vec3{1e-4, 0.0, 0.0}));
  const QImage together = window::pictureAtRest(view);
  EXPECT_EQ(window::count(together, window::deviceColoured), 0);
  view.display(placed(place, place + Vec3{0.0, 5e-4, 0.0}));
  EXPECT_GT(window::count(window::pictureAtRest(view), window::deviceColoured), 20);
  // the tool is steel: it shines somewhere, and is bluish elsewhere
  EXPECT_GT(window::count(together, window::proxyColoured), 300);
  window::keep(together, "steel");
}

TEST(ViewPicture, IsLitFromTheViewerFromEverySide) {
  ui::VolumeView view;
  open(view, SurfaceMode::Mesh, {240, 240});
  view.show(ui::pictureOf(ballVolume(0.020)), 50.0);
  for (const ui::Side side : ui::kSides) {
    view.lookFrom(side);
    const QImage image = window::pictureAtRest(view);
    EXPECT_GT(image.pixelColor(120, 120).red(), 190) << ui::letterOf(side).toStdString();
    EXPECT_LT(image.pixelColor(120, 48).red(), 190) << ui::letterOf(side).toStdString();
  }
}

TEST(ViewPicture, ShowsContactsAndForceOnRequest) {
  ui::VolumeView view;
  open(view, SurfaceMode::Mesh);
  view.show(ui::pictureOf(ballVolume(0.020)), 50.0);
  view.show(window::octahedron(0.003));
  view.resetCamera();
  haptics::Snapshot snapshot = placed({0.0, -0.023, 0.0}, {0.0, -0.022, 0.0});
  snapshot.contacts = 1;
  snapshot.places[0] = {{0.0F, -0.020F, 0.0F}, 2.0F};
  snapshot.felt_W.force = Vec3{3.0, 0.0, 0.0};  // to the patient's left: to the right on the screen
  view.display(snapshot);
  const auto blue = [](QColor c) { return c.blue() > 220 && c.red() < 130; };
  const QImage without = window::pictureAtRest(view);
  EXPECT_EQ(window::count(without, blue), 0);
  view.showContacts(true);
  const QImage with = window::pictureAtRest(view);
  window::keep(with, "contacts");
  EXPECT_GT(window::count(with, blue), 60);
  const QPointF foot = view.projected({0.0, -0.020, 0.0});
  EXPECT_GT(window::centroid(with, blue).x(), foot.x() + 20.0);
  EXPECT_LT(std::abs(window::centroid(with, blue).y() - foot.y()), 4.0);
  const auto white = [](QColor c) { return c.red() > 235 && c.blue() > 235; };
  EXPECT_GT(window::count(with.copy(int(foot.x()) - 7, int(foot.y()) - 7, 15, 15), white), 8);
  // no contact, no arrow
  snapshot.contacts = 0;
  view.display(snapshot);
  EXPECT_EQ(window::count(window::pictureAtRest(view), blue), 0);
}

TEST(ViewPicture, ColoursTheSurfaceByItsTissue) {
  for (const SurfaceMode mode : kModes) {
    SCOPED_TRACE(wordOf(mode));
    ui::VolumeView view;
    open(view, mode, {200, 200});
    const auto volume = window::volumeOf(
        window::cubeGrid(64), haptics::ScalarType::Int16,
        [](const Vec3& p) { return 2000.0 - 3000.0 * p.norm() / 0.025; }, {.unit = "HU"});
    const ui::Picture picture = ui::pictureOf(volume);
    view.show(picture, -300.0);
    view.setColouring(ui::Colouring::byTissue(picture));
    const auto middle = [&] { return window::pictureAtRest(view).pixelColor(100, 100); };
    const QColor skin = middle();
    view.setIsovalue(50.0);
    const QColor soft = middle();
    view.setIsovalue(600.0);
    const QColor bone = middle();
    EXPECT_GT(soft.red(), 1.6 * soft.blue());
    EXPECT_GT(skin.red(), 1.25 * skin.blue());
    EXPECT_LT(skin.red(), 1.7 * skin.blue());
    EXPECT_LT(bone.red(), 1.25 * bone.blue());
    view.setColouring(ui::Colouring::withVessels(picture));
    view.setIsovalue(180.0);
    EXPECT_GT(middle().red(), 2.5 * middle().blue());
  }
}

TEST(ViewPicture, FollowsTheEntriesOfTheViewMenu) {
  ui::MainWindow window;
  ui::VolumeView& view = window.views().volume();
  view.setSurfaceWish(SurfaceMode::Mesh);
  window::showAndWait(window, {1000, 700});
  const auto falling = [](const Vec3& p) { return 2000.0 - 3000.0 * p.norm() / 0.025; };
  const ui::Picture picture = ui::pictureOf(
      window::volumeOf(window::cubeGrid(64), haptics::ScalarType::Int16, falling, {.unit = "HU"}));
  window.show(picture, -300.0, "CT");
  const auto entries = [&](const char* menu) { return window.findChild<QMenu*>(menu)->actions(); };
  const auto entry = [&](const char* name) { return window.findChild<QAction*>(name); };

  const auto sides = entries("sides");
  ASSERT_EQ(std::size_t(sides.size()), ui::kSides.size());
  for (std::size_t i = 0; i < ui::kSides.size(); ++i) {
    sides[int(i)]->trigger();
    EXPECT_GT(view.viewAxes().col(2).dot(ui::directionOf(ui::kSides[i])), 0.999) << i;
  }
  entry("parallel")->trigger();
  EXPECT_TRUE(view.isParallel());
  entry("parallel")->trigger();
  EXPECT_FALSE(view.isParallel());

  // skin by its colour, or as ivory; without a unit ivory until the user asks
  const auto redness = [&] {
    const QImage image = window::pictureAtRest(view);
    const QColor c =
        image.pixelColor(image.width() / 2, image.height() / 2 + 60);  // beside the tool
    return c.red() / double(c.blue());
  };
  EXPECT_GT(redness(), 1.25);
  entry("colourIvory")->trigger();
  EXPECT_LT(redness(), 1.25);
  entry("colourByTissue")->trigger();
  EXPECT_GT(redness(), 1.25);

  QSignalSpy chosen(&window.views(), &ui::Views::isovalueWanted);
  const auto presets = entries("tissuePresets");
  const auto seconds = entries("secondSurface");
  ASSERT_EQ(std::size_t(presets.size()), ui::kTissues.size());
  for (std::size_t i = 0; i < ui::kTissues.size(); ++i) {
    const double isovalue = ui::isovalueOf(ui::kTissues[i], picture);
    presets[int(i)]->trigger();
    ASSERT_FALSE(chosen.isEmpty());
    EXPECT_EQ(chosen.last()[0].toDouble(), isovalue) << i;
    seconds[int(i) + 1]->trigger();  // the first is none
    EXPECT_EQ(view.surface().second(), isovalue) << i;
  }
  view.setIsovalue(123.0);
  seconds.last()->trigger();
  EXPECT_EQ(view.surface().second(), 123.0);
  seconds.first()->trigger();
  EXPECT_FALSE(view.surface().second());

  window.views().show(window::octahedron(0.003));
  haptics::Snapshot snapshot = placed({0.0, -0.023, 0.0}, {0.0, -0.022, 0.0});
  snapshot.contacts = 1;
  snapshot.places[0] = {{0.0F, -0.020F, 0.0F}, 2.0F};
  snapshot.felt_W.force = Vec3{3.0, 0.0, 0.0};
  sides.first()->trigger();
  window.views().display(snapshot);
  window.touch().display(snapshot);
  const auto blue = [](QColor c) { return c.blue() > 220 && c.red() < 130; };
  EXPECT_EQ(window::count(window::pictureAtRest(view), blue), 0);
  entry("showContacts")->trigger();
  EXPECT_GT(window::count(window::pictureAtRest(view), blue), 60);

  window.show(
      ui::pictureOf(window::volumeOf(window::cubeGrid(64), haptics::ScalarType::Int16, falling)),
      -300.0, "No unit");
  EXPECT_TRUE(entry("colourIvory")->isChecked());
  EXPECT_LT(redness(), 1.25);
}

TEST(ViewPicture, PresetsFollowTheHistogramWithoutAUnit) {
  // half air at 0, then 1 to 100 evenly
  const auto volume = window::volumeOf(
      window::cubeGrid(50), haptics::ScalarType::Float32,
      [](const Vec3& p) { return p.x() < 0.0 ? 0.0 : 1.0 + 99.0 * (p.z() + 0.0245) / 0.049; });
  const ui::Picture picture = ui::pictureOf(volume);
  double last = 0.0;
  for (const ui::Tissue tissue : {ui::Tissue::Airway, ui::Tissue::Skin, ui::Tissue::Vessels,
                                  ui::Tissue::Bone, ui::Tissue::Teeth}) {
    const double isovalue = ui::isovalueOf(tissue, picture);
    EXPECT_GT(isovalue, last);
    last = isovalue;
  }
  EXPECT_NEAR(ui::isovalueOf(ui::Tissue::Skin, picture), 31.0, 2.0);  // 30 % of what is no air
  EXPECT_NEAR(ui::isovalueOf(ui::Tissue::Bone, picture), 93.0, 2.0);  // 93 %
  // with a unit they are what the unit says
  auto ct = std::make_shared<haptics::Volume>(*volume);
  ct->unit = "HU";
  EXPECT_EQ(ui::isovalueOf(ui::Tissue::Bone, ui::pictureOf(ct)), 300.0);
}

TEST(ViewPicture, ShowsASecondSurfaceAsAVeilThatHidesNothing) {
  for (const SurfaceMode mode : kModes) {
    SCOPED_TRACE(wordOf(mode));
    ui::VolumeView view;
    open(view, mode);
    // 100 in the middle, falling to 0 at 25 mm: a small ball at 60, a large one at 20
    const auto volume =
        window::volumeOf(window::cubeGrid(64), haptics::ScalarType::Int16,
                         [](const Vec3& p) { return std::max(0.0, 100.0 - p.norm() * 4000.0); });
    view.show(ui::pictureOf(volume), 60.0);
    view.show(window::octahedron(0.003));
    view.display(placed({0.014, -0.004, 0.0}, {0.014, -0.004, 0.0}));  // between the two
    const QImage alone = window::pictureAtRest(view);
    view.setSecondSurface(20.0);
    const QImage veiled = window::pictureAtRest(view);
    window::keep(veiled, mode == SurfaceMode::Mesh ? "veil_mesh" : "veil_raycast");
    const QPoint beside = view.projected({-0.013, 0.0, 0.005}).toPoint();
    EXPECT_LT(alone.pixelColor(beside).red(), 30);
    const int veil = veiled.pixelColor(beside).red();
    EXPECT_GT(veil, 50);   // there is a veil
    EXPECT_LT(veil, 140);  // and only that
    view.setSecondOpacity(0.8);
    EXPECT_GT(window::pictureAtRest(view).pixelColor(beside).red(), veil + veil / 2);
    view.setSecondOpacity(ui::kFirstOpacity);
    // bone and tool are seen through it
    const QPoint middle = view.projected({0.0, -0.010, 0.0}).toPoint();
    EXPECT_GT(veiled.pixelColor(middle).red(), 150);
    const QPointF tool = view.projected({0.014, -0.004, 0.0});
    const QRect about(tool.toPoint() - QPoint{12, 12}, QSize{25, 25});
    const auto bluish = [](QColor c) { return c.blue() > c.red() + 12; };
    EXPECT_GT(window::count(veiled.copy(about), bluish), 60);
    // a tool in front of it is not veiled
    view.display(placed({0.0, -0.028, 0.0}, {0.0, -0.028, 0.0}));
    const QImage before = window::pictureAtRest(view);
    view.setSecondSurface({});
    const QImage free = window::pictureAtRest(view);
    const QRect tip(view.projected({0.0, -0.028, 0.0}).toPoint() - QPoint{4, 4}, QSize{9, 9});
    EXPECT_LT(window::differing(before.copy(tip), free.copy(tip), 6), 0.05);
    view.display(placed({0.014, -0.004, 0.0}, {0.014, -0.004, 0.0}));
    EXPECT_LT(window::differing(window::pictureAtRest(view), alone, 12), 0.002);
  }
}

TEST(ViewPicture, IsNotDrawnAtRestAndOnceForAMove) {
  ui::VolumeView view;
  open(view, SurfaceMode::Mesh);
  view.show(ui::pictureOf(ballVolume(0.020)), 50.0);
  view.show(window::octahedron(0.003));
  view.setSecondSurface(20.0);
  view.display(placed({0.0, -0.030, 0.0}, {0.0, -0.030, 0.0}));
  window::pictureAtRest(view);
  const int before = view.frames();
  QTest::qWait(500);
  EXPECT_EQ(view.frames(), before);  // nothing moves, nothing is drawn
  view.display(placed({0.0, -0.031, 0.0}, {0.0, -0.031, 0.0}));
  ASSERT_TRUE(window::waitFor([&] { return view.frames() > before; }));
  QTest::qWait(500);
  EXPECT_EQ(view.frames(), before + 1);
}

TEST(ViewPicture, LeavesOutWhatIsCroppedAndClosesTheCut) {
  QImage shown[2];
  for (const SurfaceMode mode : kModes) {
    SCOPED_TRACE(wordOf(mode));
    ui::VolumeView view;
    open(view, mode);
    const auto whole = ballVolume(0.020);
    view.show(ui::pictureOf(whole), 50.0);
    view.resetCamera();
    view.camera()->Azimuth(35.0);
    const double* eye = view.camera()->GetPosition();
    const Vec3 stood{eye};
    const QImage before = window::pictureAtRest(view);
    auto cropped = std::make_shared<haptics::Volume>(*whole);
    // the patient's left of +4 mm is gone, and the front of -10 mm
    cropped->crop = haptics::VoxelBox{{0, 22, 0}, {36, 64, 64}};
    view.replace(ui::pictureOf(cropped));
    const QImage after = window::pictureAtRest(view);
    shown[static_cast<int>(mode)] = after;
    window::keep(after, mode == SurfaceMode::Mesh ? "crop_mesh" : "crop_raycast");
    EXPECT_EQ((Vec3{view.camera()->GetPosition()} - stood).norm(), 0.0);
    EXPECT_EQ(view.surface().isovalue(), 50.0);
    const auto solid = [&](const QImage& image, const Vec3& p_W) {
      return window::surfaceColoured(image.pixelColor(view.projected(p_W).toPoint()));
    };
    EXPECT_TRUE(solid(before, {0.018, 0.0, 0.006}));
    EXPECT_FALSE(solid(after, {0.018, 0.0, 0.006}));
    // both cut faces are solid
    EXPECT_TRUE(solid(after, {0.0035, 0.004, 0.0}));
    EXPECT_TRUE(solid(after, {-0.004, -0.0095, 0.004}));
    view.replace(ui::pictureOf(whole));
    EXPECT_LT(window::differing(window::pictureAtRest(view), before, 30), 0.01);
  }
  const auto area = [](const QImage& image) {
    return double(window::count(image, window::surfaceColoured));
  };
  // the mesh closes half a voxel beyond the last one that exists
  EXPECT_NEAR(area(shown[0]) / area(shown[1]), 1.0, 0.06);
}

TEST(ViewPicture, TheHistogramOfALargeVolumeIsThatOfEvenlySpacedRows) {
  // 8 million voxels of values that go with their place on each axis
  const auto intensity = [](const Vec3& p) {
    return std::round((p.x() + 2.0 * p.y() + 3.0 * p.z()) * 1e3 + 700.0);
  };
  const auto whole = window::volumeOf(window::cubeGrid(200), haptics::ScalarType::Int16, intensity);
  const auto same =
      window::volumeOf(window::cubeGrid(200), haptics::ScalarType::Float32, intensity);
  const ui::Histogram few = ui::histogramOf(*whole, 64);
  EXPECT_EQ(few.counts, ui::histogramOf(*same, 64).counts);  // by another way
  std::vector<double> truth(few.counts.size());
  const double width = (few.greatest - few.least) / double(truth.size());
  const auto* voxels = static_cast<const std::int16_t*>(whole->voxels.get());
  for (std::int64_t n = 0; n < whole->grid.voxelCount(); ++n)
    truth[std::min(truth.size() - 1, std::size_t((voxels[n] - few.least) / width))] += 1.0;
  double all = 0.0;
  for (const double count : few.counts) all += count;
  EXPECT_GT(all, 2e6);
  EXPECT_LT(all, 6e6);
  for (std::size_t n = 0; n < truth.size(); ++n)
    EXPECT_NEAR(few.counts[n] / all, truth[n] / 8e6, 2e-4) << n;
}

vtkIdType openEdgesOf(vtkPolyData* mesh) {
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputData(mesh);
  edges->BoundaryEdgesOn();
  edges->FeatureEdgesOff();
  edges->NonManifoldEdgesOff();
  edges->ManifoldEdgesOff();
  edges->Update();
  return edges->GetOutput()->GetNumberOfCells();
}

TEST(ViewPicture, ALightMeshKeepsTheSurfaceClosedAndItsThinWalls) {
  // a ball, and beside it a wall of a voxel, thinner than what becomes one corner
  const auto ball = window::ball({-0.02, 0, 0}, 0.025);
  const auto volume =
      window::volumeOf(window::cubeGrid(96), haptics::ScalarType::Int16, [&](const Vec3& p) {
        const bool wall =
            std::abs(p.x() - 0.0305) < 0.4e-3 && std::abs(p.y()) < 0.03 && std::abs(p.z()) < 0.03;
        return std::max(ball(p), wall ? 100.0 : 0.0);
      });
  const auto mesh = ui::isosurfaceMesh(ui::imageOf(*volume), 50.0, false);
  ASSERT_EQ(openEdgesOf(mesh), 0);
  EXPECT_EQ(ui::lightMesh(mesh, mesh->GetNumberOfPolys()).Get(), mesh.Get());
  for (const std::int64_t most : {mesh->GetNumberOfPolys() / 2, mesh->GetNumberOfPolys() / 5}) {
    const auto light = ui::lightMesh(mesh, most);
    EXPECT_LT(light->GetNumberOfPolys(), most * 1.3);
    EXPECT_GT(light->GetNumberOfPolys(), most * 0.5);
    EXPECT_EQ(openEdgesOf(light), 0);
    for (int n = 0; n < 6; ++n)
      EXPECT_NEAR(light->GetBounds()[n], mesh->GetBounds()[n], 1.5) << n;  // mm
    vtkDataArray* normals = light->GetPointData()->GetNormals();
    ASSERT_NE(normals, nullptr);
    int on_wall = 0;
    for (vtkIdType n = 0; n < light->GetNumberOfPoints(); ++n) {
      const double* p = light->GetPoint(n);
      const double from_origin = 0.5 * 95.0;  // voxel 0 to the middle, mm
      const Vec3 at{p[0] - from_origin, p[1] - from_origin, p[2] - from_origin};
      if (at.x() < 25.0 || std::max(std::abs(at.y()), std::abs(at.z())) > 24.0) continue;
      ++on_wall;
      const Vec3 normal{normals->GetTuple3(n)};
      EXPECT_GT(std::abs(normal.normalized().x()), 0.9) << at.transpose();
    }
    EXPECT_GT(on_wall, 50);
  }
}

TEST(ViewPicture, InMotionShowsWhatItShowsAtRest) {
  for (const bool mirrored : {false, true}) {
    SCOPED_TRACE(mirrored);
    haptics::Mat3 axes = haptics::Mat3::Identity();
    if (mirrored) axes(0, 0) = -1.0;
    const auto ball = window::ball({-0.008, 0, 0}, 0.020);
    const auto volume = window::volumeOf(
        window::cubeGrid(64, axes), haptics::ScalarType::Int16, [&](const Vec3& p) {
          const bool wall =
              std::abs(p.x() - 0.0225) < 0.4e-3 && std::abs(p.y()) < 0.02 && std::abs(p.z()) < 0.02;
          return std::max(ball(p), wall ? 100.0 : 0.0);
        });
    ui::VolumeView view;
    open(view, SurfaceMode::Mesh);
    view.show(ui::pictureOf(volume), 50.0);
    view.show(window::octahedron(0.004));
    view.display(placed({-0.008, 0.0, 0.0}, {-0.008, 0.0, 0.0}));  // within the ball
    const auto triangles = [&] {
      auto* mapper = vtkPolyDataMapper::SafeDownCast(view.surface().mesh()->GetMapper());
      return mapper->GetInput()->GetNumberOfPolys();
    };
    const auto culls = [&] {
      return view.surface().mesh()->GetProperty()->GetBackfaceCulling() != 0;
    };
    window::pictureAtRest(view);
    const vtkIdType whole = triangles();
    view.surface().setBudget(whole / 3);
    for (const double azimuth : {35.0, 60.0, 170.0}) {
      SCOPED_TRACE(azimuth);
      view.camera()->Azimuth(azimuth);
      window::showCamera(view);
      const QImage moving = view.grabFramebuffer().convertToFormat(QImage::Format_RGB32);
      EXPECT_LT(triangles(), whole / 2);
      EXPECT_TRUE(culls());
      const QImage rest = window::pictureAtRest(view);
      EXPECT_EQ(triangles(), whole);
      window::keep(moving, mirrored ? "light_moving_mirrored" : "light_moving");
      window::keep(rest, "light_rest");
      // lit by how squarely it is seen, so both sides of the wall are as bright as at rest
      // the wall, 40 mm wide, ends up to half a bin earlier on each side: 0.6 mm of 2 mm
      EXPECT_LT(window::differing(moving, rest, 40), 0.04);
      const double all = window::count(rest, window::surfaceColoured);
      EXPECT_NEAR(window::count(moving, window::surfaceColoured) / all, 1.0, 0.10);
      // what lies within the ball is hidden by the faces that look here
      EXPECT_LT(window::count(moving, window::proxyColoured), 20);
    }
    // an eye within the box sees faces from behind
    view.camera()->SetPosition(-8.0, 0.0, 0.0);
    view.camera()->SetFocalPoint(-8.0, 40.0, 0.0);
    window::showCamera(view);
    view.grabFramebuffer();
    EXPECT_FALSE(culls());
  }
}

TEST(ViewPicture, TheHistogramAndTheReducedImageKnowTheCrop) {
  auto volume = std::make_shared<haptics::Volume>(
      *window::volumeOf(window::cubeGrid(40), haptics::ScalarType::Int16,
                        [](const Vec3& p) { return std::round((p.x() + 0.0195) * 1e3); }));
  volume->crop = haptics::VoxelBox{{10, 0, 5}, {20, 40, 40}};
  const ui::Histogram histogram = ui::histogramOf(*volume, 39);
  double all = 0.0;
  for (std::size_t i = 0; i < histogram.counts.size(); ++i) {
    all += histogram.counts[i];
    const bool within = i >= 10 && i < 20;
    EXPECT_EQ(histogram.counts[i], within ? 40.0 * 35.0 : 0.0) << i;
  }
  EXPECT_EQ(all, 10.0 * 40.0 * 35.0);
  const auto reduced = ui::reducedImageOf(*volume, 1'000'000);
  int dims[3];
  reduced->GetDimensions(dims);
  EXPECT_EQ(dims[0], 12);
  EXPECT_EQ(dims[1], 42);
  EXPECT_EQ(dims[2], 37);
  // the first voxel beyond the rim is voxel 10, where it lies
  EXPECT_EQ(reduced->GetScalarComponentAsDouble(1, 1, 1, 0), 10.0);
  EXPECT_EQ(reduced->GetScalarComponentAsDouble(0, 1, 1, 0), 0.0);
  EXPECT_NEAR(reduced->GetOrigin()[0] + reduced->GetSpacing()[0], 10.0, 1e-9);
}

TEST(ViewPicture, DarkensWhatLiesDeepIfTheGraphicsCan) {
  ui::VolumeView view;
  open(view, SurfaceMode::RayCast, {300, 300});
  // a block with a narrow slot, seen from the front
  const auto slot =
      window::volumeOf(window::cubeGrid(48), haptics::ScalarType::Int16, [](const Vec3& p) {
        const bool block = std::abs(p.x()) < 0.018 && std::abs(p.z()) < 0.018 && p.y() > -0.015;
        const bool cut = std::abs(p.x()) < 0.0015 && p.y() < -0.009;
        return block && !cut ? 100.0 : 0.0;
      });
  view.show(ui::pictureOf(slot), 50.0);
  view.resetCamera();
  const QPoint floor = view.projected({0.0, -0.009, 0.0}).toPoint();
  const QPoint top = view.projected({0.010, -0.015, 0.0}).toPoint();
  const QImage without = window::pictureAtRest(view);
  view.surface().setOcclusion(true);
  view.redraw();
  const QImage with = window::pictureAtRest(view);
  window::keep(with, "occlusion");
  EXPECT_LT(with.pixelColor(floor).red(), 0.8 * without.pixelColor(floor).red());
  EXPECT_GT(with.pixelColor(top).red(), 0.95 * without.pixelColor(top).red());
}

TEST(ViewPicture, WritesUnknownWhereTheFileDoesNotSayHowItLies) {
  ui::VolumeView view;
  open(view, SurfaceMode::Mesh, {300, 300});
  auto volume = ballVolume(0.020);
  view.show(ui::pictureOf(volume), 50.0);
  const QImage known = window::pictureAtRest(view);
  auto unknown = std::make_shared<haptics::Volume>(*volume);
  unknown->orientation_known = false;
  view.show(ui::pictureOf(unknown), 50.0);
  const QImage image = window::pictureAtRest(view);
  window::keep(image, "unknown");
  const auto light = [](QColor c) { return c.red() > 120 && c.blue() >= c.red(); };
  const QRect under(180, 96, 120, 22);
  EXPECT_EQ(window::count(known.copy(under), light), 0);
  EXPECT_GT(window::count(image.copy(under), light), 60);
  const auto yellow = [](QColor c) { return c.red() > 170 && c.green() > 130 && c.blue() < 90; };
  EXPECT_GT(window::count(known, yellow), 100);
  EXPECT_EQ(window::count(image, yellow), 0);
}

TEST(ViewPicture, HasSmoothLetters) {
  ui::VolumeView view;
  open(view, SurfaceMode::Mesh, {300, 240});
  view.show(ui::pictureOf(ballVolume(0.010)), 50.0);
  const QImage left = window::pictureAtRest(view).copy(0, 100, 30, 40);
  const auto full = [](QColor c) { return c.red() > 240; };
  const auto half = [](QColor c) { return c.red() > 60 && c.red() < 220; };
  EXPECT_GT(window::count(left, full), 20);
  EXPECT_GT(window::count(left, half), 10);
}

TEST(ViewPicture, IsTakenLargerWithLettersAndWithoutWordsBesideIt) {
  for (const SurfaceMode mode : kModes) {
    SCOPED_TRACE(wordOf(mode));
    ui::VolumeView view;
    open(view, mode, {300, 240});
    view.show(ui::pictureOf(ballVolume(0.020)), 50.0);
    view.setSecondSurface(20.0);
    const QImage shown = window::pictureAtRest(view);
    const QImage one = view.picture(1.0);
    EXPECT_LT(window::differing(one, shown, 24), 0.01);
    const QImage three = view.picture(3.0);
    ASSERT_EQ(three.size(), QSize(900, 720));
    window::keep(three, mode == SurfaceMode::Mesh ? "picture3_mesh" : "picture3_raycast");
    const QImage small = three.scaled(300, 240, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    EXPECT_LT(window::differing(small, shown, 60), 0.02);
    // the letters are in it, and as large as the rest
    const auto yellow = [](QColor c) { return c.red() > 170 && c.green() > 130 && c.blue() < 90; };
    EXPECT_GT(window::count(three, yellow), 5 * window::count(one, yellow));
    // and the view goes on as it was
    EXPECT_LT(window::differing(window::pictureAtRest(view), shown, 24), 0.005);
    QBuffer bytes;
    ASSERT_TRUE(three.save(&bytes, "PNG"));
    for (const char* chunk : {"tEXt", "iTXt", "zTXt", "eXIf", "tIME"})
      EXPECT_FALSE(bytes.data().contains(chunk)) << chunk;
  }
}

/// The same picture with a view's place left black.
QImage blackened(QImage image, const QRect& place) {
  QPainter(&image).fillRect(place, Qt::black);
  return image;
}

TEST(ViewPicture, OfTheWindowHoldsTheView) {
  ui::MainWindow window;
  window.views().volume().setSurfaceWish(SurfaceMode::Mesh);
  window::showAndWait(window, {1000, 700});
  window.show(ui::pictureOf(ballVolume(0.020)), 50.0, "ball");
  window::pictureAtRest(window.views().volume());
  const QImage image = ui::screenshotOf(window, window.views(), {.whole_window = true, .scale = 2});
  ASSERT_EQ(image.size(), window.size() * 2);
  window::keep(image, "picture_window");
  // the view's own picture, with its letters, where the view is
  const QRect place(window.views().volume().mapTo(&window, QPoint{}),
                    window.views().volume().size());
  const QRect twice(place.topLeft() * 2, place.size() * 2);
  const QImage part = image.copy(twice);
  EXPECT_GT(window::count(part, window::surfaceColoured), 40'000);
  EXPECT_LT(window::differing(part, window.views().volume().picture(2.0), 8), 0.001);
  // beside it, what the window shows
  const QImage small = image.scaled(window.size(), Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
  const QImage shown = window::pictureOf(window);
  EXPECT_LT(window::differing(blackened(small, place), blackened(shown, place), 80), 0.01);
  // slices are cut at the picture's own pixels: neighbours differ where the ball ends, away from
  // words and lines
  const ui::SliceView& axial = window.views().slice(ui::Plane::Axial);
  const QPoint off = axial.mapTo(&window, QPoint{});
  EXPECT_GT(window::neighboursApart(
                image, QRect((axial.projected({-22.0, 3.0, 0.5}).toPoint() + off) * 2,
                             (axial.projected({-3.0, 22.0, 0.5}).toPoint() + off) * 2)),
            40);
  EXPECT_FALSE(ui::screenshotOf(window, window.views(), {.scale = 1}).isNull());
}

TEST(ViewPicture, OfTheWindowShowsASliceThatIsShownAlone) {
  ui::MainWindow window;
  window.views().volume().setSurfaceWish(SurfaceMode::Mesh);
  window::showAndWait(window, {1000, 700});
  window.show(ui::pictureOf(ballVolume(0.020)), 50.0, "ball");
  window::pictureAtRest(window.views().volume());
  ui::SliceView& axial = window.views().slice(ui::Plane::Axial);
  axial.parentWidget()->findChild<QToolButton*>("maximise")->click();
  ASSERT_FALSE(window.views().volume().isVisible());
  const QImage shown = window::pictureOf(window);
  const QImage image = ui::screenshotOf(window, window.views(), {.whole_window = true, .scale = 1});
  window::keep(image, "picture_window_slice");
  EXPECT_LT(window::differing(image, shown, 8), 0.002);
}

TEST(ViewPicture, OfTheViewHasNoHint) {
  ui::VolumeView view;
  open(view, SurfaceMode::Mesh, {600, 400});
  view.show(ui::pictureOf(ballVolume(0.020)), 50.0);
  const QString looking = view.hint();
  view.setMouseHand(true);
  EXPECT_NE(view.hint(), looking);  // how the tool is taken
  const auto grey = [](QColor c) { return c.red() > 110 && c.blue() > c.red() + 10; };
  EXPECT_EQ(window::count(window::pictureAtRest(view).copy(0, 350, 500, 50), grey), 0);
  EXPECT_EQ(window::count(view.picture(1.0).copy(0, 350, 500, 50), grey), 0);
}

}  // namespace
