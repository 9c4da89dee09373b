// SPDX-License-Identifier: BSD-3-Clause
// A head in its holder: the way from the start to the touched mastoid.
#include <QComboBox>
#include <QPushButton>
#include <QSettings>
#include <QToolButton>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <fstream>

#include "app/window/edits/edit_controller.h"
#include "datasets/readers/nrrd/writer.h"
#include "tests/support/places.h"
#include "tests/ui/edits/editing.h"
#include "tests/ui/views/sphere_in_hand.h"
#include "tests/ui/window_support.h"
#include "ui/panels/device_panel.h"
#include "ui/panels/force_panel.h"
#include "ui/views/volume_view.h"
#include "ui/window/main_window.h"
#include "ui/window/menus.h"
#include "ui/window/views.h"

namespace {

namespace fs = std::filesystem;
using Eigen::Vector3d;
using window::waitFor;

class Mastoid : public window::Editing {
 protected:
  // behind the left ear canal, seen in the slices: bone begins at x = 54.6, the holder's wall lies
  // at 99 to 102, in the way from the left
  const Vector3d mastoid_{54.6, 130.0, 708.2};
  static constexpr double kHolder_mm = 99.0;

  fs::path scan();
  /// From an empty window to the touch, with mouse and keys alone. Returns how many actions it
  /// took.
  int touch(QSize size);
};

/// A ball as a mesh file, mm.
fs::path ballFile(const QTemporaryDir& folder, double diameter_mm) {
  constexpr int kRings = 12, kAround = 24;
  const auto at = [&](int ring, int around) -> Vector3d {
    const double down = 3.14159265358979 * ring / kRings;
    const double turn = 2.0 * 3.14159265358979 * (around % kAround) / kAround;
    return Vector3d{std::sin(down) * std::cos(turn), std::sin(down) * std::sin(turn),
                    std::cos(down)} *
           (0.5 * diameter_mm);
  };
  const fs::path path = fs::path(folder.path().toStdString()) / "burr.stl";
  std::ofstream out{path};
  out << "solid burr\n";
  const auto triangle = [&](const Vector3d& a, const Vector3d& b, const Vector3d& c) {
    out << "facet normal 0 0 0\nouter loop\n";
    for (const Vector3d& p : {a, b, c}) out << "vertex " << p.transpose() << '\n';
    out << "endloop\nendfacet\n";
  };
  for (int ring = 0; ring < kRings; ++ring)
    for (int n = 0; n < kAround; ++n) {
      const Vector3d a = at(ring, n), b = at(ring + 1, n), c = at(ring + 1, n + 1);
      const Vector3d d = at(ring, n + 1);
      if (ring + 1 < kRings) triangle(a, b, c);
      if (ring > 0) triangle(a, c, d);
    }
  out << "endsolid burr\n";
  return path;
}

/// In place of the real scan: a head about (0, 130, 708), and the wall of a holder on its left.
fs::path madeHeadInHolder(const QTemporaryDir& folder) {
  haptics::Grid grid;
  grid.dims = {112, 112, 80};
  grid.spacing = haptics::Vec3::Constant(2e-3);
  const haptics::Vec3 middle{0.0, 0.130, 0.7082};
  grid.origin = middle - 1e-3 * haptics::Vec3{111, 111, 79};
  const auto filled = [](double depth) { return std::clamp(0.5 + depth / 2e-3, 0.0, 1.0); };
  const auto scan =
      window::volumeOf(grid, haptics::ScalarType::Int16, [&](const haptics::Vec3& p_W) {
        const haptics::Vec3 p = p_W - middle;
        const double wall = 2e-3 - std::abs(std::hypot(p.x(), p.y()) - 0.1005);
        return std::max(1000.0 * filled(54.6e-3 - p.norm()),
                        p.x() > 0.0 ? 1000.0 * filled(wall) : 0.0);
      });
  const fs::path path = fs::path(folder.path().toStdString()) / "head.nrrd";
  EXPECT_TRUE(datasets::writeNrrd(*scan, path).has_value());
  return path;
}

constexpr const char* kNotRun = "NOT RUN: the head phantom is not there";

/// The made head has no unit, so nothing of it is called bone.
bool isReal() { return fs::exists(places::scan("philips_head_phantom/bone_1mm")); }

fs::path Mastoid::scan() {
  return isReal() ? fs::path{places::scan("philips_head_phantom/bone_1mm")}
                  : madeHeadInHolder(scans_);
}

int Mastoid::touch(QSize size) {
  int actions = 0;
  const auto act = [&](const auto& what) {
    ++actions;
    what();
  };
  const QString place = QString::fromStdString(scan().string());
  QSettings().setValue("places/recent", QStringList{place});
  app::Arguments arguments = window::recordedSphere(recordings_, "mouse");
  arguments.load = {};
  application_ = std::make_unique<app::Application>(arguments);
  application_->start();
  window().resize(size);
  window().activateWindow();
  EXPECT_TRUE(QTest::qWaitForWindowActive(&window(), 120'000));
  auto* tile = window().findChild<QToolButton*>("lastScan");
  if (tile == nullptr) return -1;
  act([&] { QTest::mouseClick(tile, Qt::LeftButton); });
  const auto offered = [&] { return child<QPushButton>("holderRemove").isVisible(); };
  EXPECT_TRUE(waitFor([&] { return application_->snapshot().scene != 0 && offered(); }));
  isovalue_ = application_->snapshot().isovalue;
  ui::VolumeView& view = window().views().volume();
  window::pictureAtRest(view);
  keepWindow("holder_found");
  EXPECT_TRUE(application_->editing().edits().empty());  // nothing goes without a click
  act([&] { QTest::mouseClick(&child("holderRemove"), Qt::LeftButton); });
  settle();
  EXPECT_EQ(application_->editing().edits().size(), 1U);
  EXPECT_FALSE(offered());
  act([&] { QTest::keyClick(window().focusWidget(), Qt::Key_3); });
  window::pictureAtRest(view);
  EXPECT_FALSE(felt({0.5 * (kHolder_mm + 102.0), mastoid_.y(), mastoid_.z()}) >= isovalue_);
  act([&] {
    const QPointF at = inSpace(mastoid_);
    clickAt(view, at);
    mouse(view, QEvent::MouseButtonDblClick, at, Qt::LeftButton);
    mouse(view, QEvent::MouseButtonRelease, at, Qt::NoButton);
  });
  // it comes to rest on the surface, and the slices come with it
  EXPECT_TRUE(waitFor([&] { return application_->snapshot().contacts > 0; }, 20.0));
  EXPECT_LT((window().views().cross_mm() - mastoid_).norm(), 6.0);
  const QPointF tip = view.projected(application_->snapshot().X_WP.translation());
  act([&] { drag(view, {tip, tip + QPointF(6, 4), tip + QPointF(1, 1)}); });
  QTest::qWait(500);
  const auto words = [&] { return child<QLabel>("touchNow").text(); };
  EXPECT_TRUE(waitFor([&] { return words().startsWith("Touching bone, "); }, 20.0))
      << words().toStdString();
  // half a voxel behind the surface bone is denser than its surface
  EXPECT_GT(words().section(", ", 1).section(' ', 0, 0).toDouble(), isovalue_ + 20.0);
  EXPECT_GT(application_->snapshot().felt_W.force.norm(), 0.0);
  const Vector3d tip_mm = application_->snapshot().X_WP.translation() * 1e3;
  std::printf("  %d actions; \"%s\"; the tool is at x = %.1f, y = %.1f, z = %.1f mm\n", actions,
              words().toUtf8().constData(), tip_mm.x(), tip_mm.y(), tip_mm.z());
  // the card lies beside the tool
  const auto& card = child<ui::ForcePanel>("forceCard");
  EXPECT_TRUE(card.isVisible());
  EXPECT_FALSE(
      view.isToolIn({view.mapFrom(&window(), card.mapTo(&window(), QPoint{})), card.size()}));
  keepWindow(qPrintable(QString("mastoid_%1x%2").arg(size.width()).arg(size.height())));
  return actions;
}

TEST_F(Mastoid, FiveActionsFromTheStartToTheTouch) {
  if (!isReal()) GTEST_SKIP() << kNotRun;
  EXPECT_EQ(touch({1280, 800}), 5);
  // as far as the foot of the panel, nothing of the usual path is out of sight
  for (const char* name : {"presetBone", "presetTeeth", "tile-burr-4", "tools", "stiffness",
                           "friction", "cropTool", "holderTool", "scalpelTool"}) {
    const auto& control = child<QWidget>(name);
    EXPECT_EQ(control.visibleRegion().boundingRect(), control.rect()) << name;
  }
  // another scan begins with the tool that was chosen
  QTest::mouseClick(&child("tile-hook"), Qt::LeftButton);
  EXPECT_TRUE(waitFor([&] { return application_->shown()->tool.name == "hook"; }));
  // a file that is no tool is refused, and not asked of the next scan
  const fs::path broken = fs::path(scans_.path().toStdString()) / "broken.stl";
  std::ofstream(broken) << "solid";
  emit window::panelOf<ui::DevicePanel>(window()).toolFileChosen(
      QString::fromStdString(broken.string()), "mm");
  EXPECT_TRUE(waitFor([&] { return messageIsShown(); }));
  const auto before = application_->shown()->scene->id;
  window::discardWhenAsked(window());
  emit window().menus().openWanted(QString::fromStdString(scan().string()));
  EXPECT_TRUE(waitFor([&] { return application_->shown()->scene->id != before; }));
  EXPECT_EQ(application_->shown()->tool.name, "hook");
}

TEST_F(Mastoid, FiveActionsOnAnotherScreen) {
  if (!isReal()) GTEST_SKIP() << kNotRun;
  EXPECT_EQ(touch({1366, 768}), 5);
}

// What a surgeon does first: the holder goes, and the mastoid that it hid is touched with a burr.
TEST_F(Mastoid, TheHolderOfAScanIsRemovedAndTheMastoidBehindItTouched) {
  constexpr double kBurr_mm = 4.0;
  isovalue_ = 300.0;
  const auto begin = std::chrono::steady_clock::now();
  int actions = 1;  // the folder was opened
  open(scan(), isovalue_);
  ASSERT_FALSE(HasFatalFailure());
  ui::VolumeView& view = window().views().volume();
  const auto act = [&](const auto& what) {
    ++actions;
    what();
  };
  act([&] {
    const auto scene = application_->shown()->scene;
    emit window::panelOf<ui::DevicePanel>(window()).toolFileChosen(
        QString::fromStdString(ballFile(scans_, kBurr_mm).string()), "mm");
    ASSERT_TRUE(waitFor([&] { return application_->snapshot().scene != scene->id; }));
  });
  EXPECT_NEAR(application_->shown()->scene->tool.shell.radius, 0.5 * kBurr_mm * 1e-3, 0.2e-3);
  // a double click on a place brings the burr to what is seen there, and a hand presses it on
  const auto bring = [&] {
    const QPointF at = inSpace(mastoid_);
    clickAt(view, at);
    mouse(view, QEvent::MouseButtonDblClick, at, Qt::LeftButton);
    mouse(view, QEvent::MouseButtonRelease, at, Qt::NoButton);
    QTest::qWait(1'500);
  };
  const auto press_on = [&] {
    const Vector3d burr = pulledTo(mastoid_ - Vector3d{2.0, 0, 0});
    std::printf("  the burr's middle comes to x = %.2f, y = %.2f, z = %.2f mm\n", burr.x(),
                burr.y(), burr.z());
    return burr;
  };
  act([&] { QTest::keyClick(&view, Qt::Key_3); });
  const double until_holder =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();

  // not counted: as it is without the edit
  window::pictureAtRest(view);
  bring();
  EXPECT_GT(press_on().x(), kHolder_mm);
  EXPECT_GT(application_->snapshot().contacts, 0);
  pulledTo({108.0, mastoid_.y(), mastoid_.z()});

  const auto again = std::chrono::steady_clock::now();
  act([&] { press("Edit", "Table and holder"); });
  EXPECT_EQ(panel().tool(), ui::EditTool::Holder);
  act([&] { click("showHolder"); });
  ASSERT_TRUE(previewed()) << message().toStdString();
  const QString words = child<QLabel>("editPreview").text();
  EXPECT_TRUE(words.contains("cm³")) << words.toStdString();
  keepWindow("edit_holder");
  act([&] { click("applyRemoval"); });
  ASSERT_EQ(application_->editing().edits().size(), 1U);
  window::pictureAtRest(view);
  keepWindow("edit_holder_gone");
  act(bring);
  Vector3d burr;
  act([&] { burr = press_on(); });
  EXPECT_GT(application_->snapshot().contacts, 0);
  // a ball that touches the bone there: half its diameter away
  EXPECT_LT((burr - mastoid_).norm(), 0.5 * kBurr_mm + 2.0) << burr.transpose();
  EXPECT_GT(burr.x(), mastoid_.x());
  keepWindow("edit_mastoid_touched");
  EXPECT_LT(actions, 12);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - again;
  std::printf("holder removed, mastoid touched: %d actions, %.1f s; %s\n", actions,
              until_holder + took.count(), words.toUtf8().constData());
}

}  // namespace
