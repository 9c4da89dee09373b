// SPDX-License-Identifier: BSD-3-Clause
// What the slices have in common: crosshair, grey window, voxels' look, the view with the tool.
#include "ui/views/slice_set.h"

#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QDoubleSpinBox>
#include <QElapsedTimer>
#include <QLabel>
#include <QMenu>
#include <QMouseEvent>
#include <QPainter>
#include <QSignalSpy>
#include <QTest>
#include <QTimer>
#include <QToolButton>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "app/window/scan/shared_state.h"
#include "app/window/views/grey_keeper.h"
#include "datasets/phantoms/phantoms.h"
#include "datasets/readers/volume_reader.h"
#include "haptics/field/scalar_field.h"
#include "tests/support/places.h"
#include "tests/support/sentence.h"
#include "tests/ui/window_support.h"
#include "ui/controls/lengths.h"
#include "ui/overlays/overlay.h"
#include "ui/panels/force_panel.h"
#include "ui/views/plane_colours.h"
#include "ui/views/slice_readout.h"
#include "ui/views/volume_view.h"
#include "ui/window/main_window.h"
#include "ui/window/touch_state.h"
#include "ui/window/view_frame.h"
#include "ui/window/view_layout.h"
#include "ui/window/views.h"

namespace {

using haptics::Vec3;
using ui::Plane;

ui::Picture ctPicture(const char* unit = "HU") {
  const auto bone = window::ball({0.004, 0.0, 0.0}, 0.014);
  return ui::pictureOf(
      window::volumeOf(window::cubeGrid(64), haptics::ScalarType::Int16,
                       [=](const Vec3& p) { return -1000.0 + 20.0 * bone(p) + 2e3 * p.z(); },
                       {.unit = unit, .modality = "CT"}));
}

struct Window {
  explicit Window(const char* unit = "HU") {
    window.views().volume().setSurfaceWish(ui::SurfaceMode::Mesh);
    window.show(ctPicture(unit), 300.0, "Ball");
    window.views().show(window::octahedron(0.006));
    window.views().layout().arrange(ui::Arrangement::FourUp);
    window::showAndWait(window, {1240, 860});
  }
  QAction* action(const char* name) {
    auto* found = slices().menu().findChild<QAction*>(name);
    EXPECT_NE(found, nullptr) << name;
    return found;
  }
  ui::SliceSet& slices() { return window.views().slices(); }
  void show(const Vec3& tip_W, const haptics::Quat& turn = haptics::Quat::Identity()) {
    haptics::Snapshot snapshot;
    // the octahedron's tip is 6 mm along -z
    snapshot.X_WP = haptics::poseOf(tip_W + turn * Vec3{0.0, 0.0, 0.006}, turn);
    snapshot.X_WD = snapshot.X_WP;
    window.views().display(snapshot);
    window.touch().display(snapshot);
    QTest::qWait(20);
  }
  ui::MainWindow window;
};

TEST(Slices, AreLinkedByTheCrosshairWhoseLinesHaveThePlanesColours) {
  Window w;
  ui::SliceView& axial = w.window.views().slice(Plane::Axial);
  const Vec3 at = axial.placeUnder(axial.projected({10.2, -8.3, 0.0}).toPoint());
  QTest::mouseClick(&axial, Qt::LeftButton, {}, axial.projected(at).toPoint());
  EXPECT_LT((w.slices().cross_mm() - at).norm(), 0.3);
  EXPECT_NEAR(w.window.views().slice(Plane::Sagittal).through_mm().x(), at.x(), 0.3);
  EXPECT_NEAR(w.window.views().slice(Plane::Coronal).through_mm().y(), at.y(), 0.3);
  w.slices().setGrey({.level = 9000.0, .width = 1.0});
  const auto near = [](const QColor& wanted) {
    return [wanted](QColor c) {
      // a line of one pixel, mixed with black
      const double share = c.value() / double(wanted.value());
      return share > 0.3 && std::abs(c.red() - share * wanted.red()) < 12 &&
             std::abs(c.green() - share * wanted.green()) < 12 &&
             std::abs(c.blue() - share * wanted.blue()) < 12;
    };
  };
  for (const Plane shown : {Plane::Axial, Plane::Coronal, Plane::Sagittal}) {
    ui::SliceView& view = w.window.views().slice(shown);
    const QImage image = window::pictureOf(view);
    const QRect inner = view.pictureRect();
    for (const Plane other : {Plane::Axial, Plane::Coronal, Plane::Sagittal})
      EXPECT_EQ(window::count(image.copy(inner), near(ui::colourOf(other))) > 60, other != shown)
          << int(shown) << " shows " << int(other);
    // the line above the view has the plane's own colour
    const QImage frame = window::pictureOf(*view.parentWidget());
    EXPECT_EQ(frame.pixelColor(frame.width() / 2, 0).rgb(), ui::colourOf(shown).rgb());
    EXPECT_EQ(frame.pixelColor(4, 1).rgb(), ui::colourOf(shown).rgb());
    EXPECT_NE(frame.pixelColor(frame.width() / 2, 2).rgb(), ui::colourOf(shown).rgb());
  }
  w.action("showCrosshair")->trigger();
  const ui::SliceView& view = w.window.views().slice(Plane::Axial);
  const QImage without = window::pictureOf(w.window.views().slice(Plane::Axial));
  EXPECT_EQ(window::count(without.copy(view.pictureRect()), near(ui::colourOf(Plane::Coronal))), 0);
}

TEST(Slices, HavePresetsOfTheGreyWindowForHounsfieldUnitsAndFullRangeForAll) {
  Window w;
  const auto brain = [&] {
    for (QAction* action : w.slices().menu().findChild<QMenu*>("greyMenu")->actions())
      if (action->text().startsWith("Brain")) return action;
    return static_cast<QAction*>(nullptr);
  };
  ASSERT_NE(brain(), nullptr);
  EXPECT_TRUE(brain()->isVisible());
  EXPECT_EQ(w.slices().grey().width, 1600.0);
  const struct {
    const char* name;
    double level, width;  // HU
  } presets[] = {{"Bone", 500.0, 2000.0},      {"Temporal bone", 700.0, 4000.0},
                 {"Soft tissue", 40.0, 400.0}, {"Lung", -600.0, 1500.0},
                 {"Brain", 40.0, 80.0},        {"Mediastinum", 50.0, 350.0}};
  for (const auto& [name, level, width] : presets) {
    SCOPED_TRACE(name);
    const QString words = QString("%1 (W %2, L %3)").arg(name).arg(width).arg(level);
    for (QAction* action : w.slices().menu().findChild<QMenu*>("greyMenu")->actions())
      if (action->text().section('\t', 0, 0) == words) action->trigger();
    EXPECT_EQ(w.slices().grey().level, level);
    EXPECT_EQ(w.slices().grey().width, width);
    for (ui::SliceView* slice : w.slices().slices())
      EXPECT_TRUE(slice->readout().grey.startsWith(QString("W %1  L ").arg(width)));
  }
  w.action("greyFullRange")->trigger();
  EXPECT_GT(w.slices().grey().width, 1900.0);
  w.action("greyReset")->trigger();
  EXPECT_EQ(w.slices().grey().width, 1600.0);
  w.window.show(ctPicture(""), 300.0, "No unit");
  EXPECT_FALSE(brain()->isVisible());
  EXPECT_GT(w.slices().grey().width, 1900.0);  // the full range
}

TEST(Slices, BeginWithTheWindowOfTheFileAndOfferAllThatItStates) {
  Window w;
  const auto offered = [&] {
    QStringList texts;
    for (QAction* action : w.slices().menu().findChild<QMenu*>("greyMenu")->actions())
      if (action->text().startsWith("As in the file")) texts << action->text();
    return texts;
  };
  EXPECT_TRUE(offered().isEmpty());
  const std::vector<ui::GreyPreset> stated{{"", {.level = 35.0, .width = 350.0}},
                                           {"  BONE &\n%2 ", {.level = 450.5, .width = 1500.0}}};
  for (const char* unit : {"HU", ""}) {
    SCOPED_TRACE(unit);
    w.window.show(ctPicture(unit), 300.0, "Ball", stated);
    EXPECT_EQ(w.slices().grey().level, 35.0);
    EXPECT_EQ(w.slices().grey().width, 350.0);
    for (ui::SliceView* slice : w.slices().slices())
      EXPECT_EQ(slice->readout().grey, "W 350  L 35");
    EXPECT_EQ(offered(), (QStringList{"As in the file (W 350, L 35)",
                                      "As in the file: BONE && %2 (W 1500, L 450.5)"}));
    // above the usual ones
    QAction* const second = w.slices().menu().findChild<QMenu*>("greyMenu")->actions()[1];
    second->trigger();
    EXPECT_EQ(w.slices().grey().level, 450.5);
    EXPECT_EQ(w.slices().grey().width, 1500.0);
    // what was chosen stays while the voxels are edited; a reset goes back to the file's
    w.window.views().replace(ctPicture(unit));
    EXPECT_EQ(w.slices().grey().width, 1500.0);
    w.action("greyReset")->trigger();
    EXPECT_EQ(w.slices().grey().width, 350.0);
  }
  w.window.show(ctPicture(), 300.0, "Another");
  EXPECT_TRUE(offered().isEmpty());
  EXPECT_EQ(w.slices().grey().width, 1600.0);
}

TEST(Slices, AreInterpolatedOrNotAndThickByChoice) {
  Window w;
  ui::SliceView& axial = w.window.views().slice(Plane::Axial);
  w.action("showContour")->trigger();
  axial.zoom(8.0, axial.projected({18.0, 0.0, 0.5}));
  w.slices().setGrey({.level = 0.0, .width = 2400.0});
  const QImage smooth = window::pictureOf(axial);
  w.action("nearest")->trigger();
  const QImage blocks = window::pictureOf(axial);
  // where voxels are blocks, most neighbours are equal
  const auto equals = [&](const QImage& image) {
    const QRect inner = axial.pictureRect().adjusted(60, 60, -60, -60);
    int equal = 0;
    for (int y = inner.top(); y < inner.bottom(); ++y)
      for (int x = inner.left(); x < inner.right(); ++x)
        equal += image.pixel(x, y) == image.pixel(x + 1, y);
    return double(equal) / (inner.width() * inner.height());
  };
  EXPECT_GT(equals(blocks), 0.85);
  EXPECT_LT(equals(smooth), equals(blocks) - 0.1);
  w.action("linear")->trigger();
  EXPECT_LT(window::differing(window::pictureOf(axial), smooth), 1e-4);

  // beside the ball's edge: a slab's maximum reaches it, its mean does not
  ui::SliceView& coronal = w.window.views().slice(Plane::Coronal);
  w.slices().moveCross({4.5, 15.5, 0.5});
  const auto valueAt = [&](const Vec3& p) {
    window::pictureOf(coronal);  // it is cut when it is painted
    const QPointF at = coronal.projected(p);
    QMouseEvent move(QEvent::MouseMove, at, coronal.mapToGlobal(at), Qt::NoButton, Qt::NoButton,
                     {});
    QCoreApplication::sendEvent(&coronal, &move);
    return coronal.readout().value.section(' ', 0, 0).toDouble();
  };
  const Vec3 beside{4.5, 15.5, 0.5};
  const double plane = valueAt(beside);
  w.action("slabMaximum")->trigger();
  const double greatest = valueAt(beside);
  EXPECT_TRUE(coronal.readout().slab.contains("5 mm"));
  w.action("slabMinimum")->trigger();
  EXPECT_TRUE(coronal.readout().slab.startsWith("minimum of"));
  EXPECT_LT(valueAt(beside), plane + 1.0);
  w.action("slabMean")->trigger();
  const double mean = valueAt(beside);
  EXPECT_GT(greatest, plane + 300.0);
  EXPECT_GT(mean, plane);
  EXPECT_LT(mean, greatest - 200.0);
  w.action("slabNone")->trigger();
  EXPECT_EQ(coronal.readout().slab, "");
}

TEST(Slices, AreAsThickAsIsChosen) {
  Window w;
  // one bright layer of voxels, 4 mm from the slice
  w.window.show(ui::pictureOf(window::volumeOf(
                    window::cubeGrid(64), haptics::ScalarType::Int16,
                    [](const Vec3& p) { return std::abs(p.z() - 4.5e-3) < 1e-4 ? 100.0 : 0.0; })),
                50.0, "Layer");
  w.slices().moveCross({0.5, 0.5, 0.5});
  ui::SliceView& axial = w.window.views().slice(Plane::Axial);
  const auto shown = [&](double thickness_mm) {
    for (QAction* action : w.slices().menu().findChild<QMenu*>("slabMenu")->actions())
      if (action->data().toDouble() == thickness_mm) action->trigger();
    window::pictureOf(axial);  // it is cut when it is painted
    const QPointF at = axial.projected({0.5, 0.5, 0.5});
    QMouseEvent move(QEvent::MouseMove, at, axial.mapToGlobal(at), Qt::NoButton, Qt::NoButton, {});
    QCoreApplication::sendEvent(&axial, &move);
    return axial.readout().value.toDouble();
  };
  w.action("slabMaximum")->trigger();
  EXPECT_EQ(shown(5.0), 0.0);
  EXPECT_EQ(axial.readout().slab, "maximum of 5 mm");
  EXPECT_GT(shown(10.0), 90.0);
  EXPECT_EQ(axial.readout().slab, "maximum of 10 mm");
  w.action("slabMean")->trigger();
  EXPECT_NEAR(shown(10.0), 10.0, 2.0);
  EXPECT_EQ(axial.readout().slab, "mean of 10 mm");
  // in the layer itself
  w.slices().moveCross({0.5, 0.5, 4.5});
  EXPECT_GT(shown(10.0), 5.0);
  w.action("slabMinimum")->trigger();
  EXPECT_EQ(shown(10.0), 0.0);
  EXPECT_EQ(axial.readout().slab, "minimum of 10 mm");
  w.action("slabNone")->trigger();
  EXPECT_EQ(shown(10.0), 100.0);
}

TEST(Slices, AreAsThickAsIsTypedWithEitherMarkInEitherUnit) {
  Window w;
  w.action("slabMaximum")->trigger();
  ui::SliceView& axial = w.window.views().slice(Plane::Axial);
  const auto type = [&](const char* text) {
    QTimer::singleShot(0, &w.window, [&] {
      auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
      ASSERT_NE(dialog, nullptr);
      auto* field = dialog->findChild<QDoubleSpinBox*>();
      EXPECT_EQ(field->suffix(), QString(" %1").arg(ui::lengthUnitName()));
      field->selectAll();
      QTest::keyClicks(field, text);
      QTest::keyClick(dialog, Qt::Key_Return);
      if (dialog->isVisible()) dialog->reject();
    });
    w.action("otherThickness")->trigger();
    window::pictureOf(axial);
    return axial.readout().slab;
  };
  EXPECT_EQ(type("7.5"), "maximum of 7.5 mm");
  EXPECT_EQ(type("0,5"), "maximum of 0.5 mm");
  EXPECT_EQ(type("5.0.0"), "maximum of 0.5 mm");
  ui::setLengthUnit(ui::LengthUnit::Centimetres);
  const auto menu = w.slices().menu().findChild<QMenu*>("slabMenu")->actions();
  EXPECT_TRUE(std::ranges::any_of(menu, [](auto* a) { return a->text() == "0.5 cm thick"; }));
  EXPECT_EQ(type("1,25"), "maximum of 1.25 cm");
  ui::setLengthUnit(ui::LengthUnit::Millimetres);
  window::pictureOf(axial);
  EXPECT_EQ(axial.readout().slab, "maximum of 12.5 mm");
}

TEST(Slices, ShareTheGreyWindowTheContourTheMenuAndTheWayBackToTheWholeSlice) {
  Window w;
  w.window.views().setTouched(
      {.value = [](const Vec3& p) { return p.norm() < 0.014 ? 2000.0 : 0.0; }});
  ui::SliceView &axial = w.window.views().slice(Plane::Axial),
                &coronal = w.window.views().slice(Plane::Coronal);
  // a drag in one slice changes all
  const QString before = axial.readout().grey;
  const QPoint from = coronal.pictureRect().center();
  QTest::mousePress(&coronal, Qt::RightButton, {}, from);
  QMouseEvent move(QEvent::MouseMove, from + QPoint{40, 0},
                   coronal.mapToGlobal(QPointF(from + QPoint{40, 0})), Qt::NoButton,
                   Qt::RightButton, {});
  QCoreApplication::sendEvent(&coronal, &move);
  QTest::mouseRelease(&coronal, Qt::RightButton, {}, from + QPoint{40, 0});
  EXPECT_NE(axial.readout().grey, before);
  EXPECT_EQ(axial.readout().grey, coronal.readout().grey);
  // a click opens the menu
  EXPECT_FALSE(w.slices().menu().isVisible());
  QTest::mouseClick(&coronal, Qt::RightButton, {}, from);
  EXPECT_TRUE(w.slices().menu().isVisible());
  w.slices().menu().close();
  // the contour goes and comes in all
  const auto orange = [](QColor c) { return c.red() > 200 && c.blue() < 0.6 * c.red(); };
  w.slices().setGrey({.level = 9000.0, .width = 1.0});
  w.action("showCrosshair")->trigger();
  const auto contours = [&](ui::SliceView& view) {
    const QImage image = window::pictureOf(view);
    return window::count(image.copy(view.pictureRect()), orange);
  };
  EXPECT_GT(contours(axial), 60);
  EXPECT_GT(contours(coronal), 60);
  w.action("showContour")->trigger();
  EXPECT_EQ(contours(axial), 0);
  EXPECT_EQ(contours(coronal), 0);
  // and all are whole again
  w.action("resetSlices")->trigger();
  const double whole = axial.mmPerPixel();
  const Vec3 middle = coronal.placeUnder(from);
  axial.zoom(3.0, {50.0, 50.0});
  coronal.pan({30.0, 10.0});
  w.action("resetSlices")->trigger();
  EXPECT_NEAR(axial.mmPerPixel(), whole, 1e-12);
  EXPECT_LT((coronal.placeUnder(from) - middle).norm(), 1e-9);
}

TEST(Slices, FollowTheToolWhileItMovesUnlessTheUserLooksElsewhere) {
  Window w;
  const Vec3 before = w.slices().cross_mm();
  const auto show = [&](const Vec3& tip) {
    QTest::qWait(60);  // at most 20 times a second
    w.show(tip);
  };
  // where the tool is at first changes nothing
  show({0.010, 0.005, -0.008});
  EXPECT_EQ((w.slices().cross_mm() - before).norm(), 0.0);
  show({-0.010, 0.005, -0.008});
  EXPECT_LT((w.slices().cross_mm() - Vec3{-10.0, 5.0, -8.0}).norm(), 1e-9);
  EXPECT_NEAR(w.window.views().slice(Plane::Sagittal).through_mm().x(), -10.0, 1e-9);
  // less than half a voxel of 1 mm is no move
  show({-0.0096, 0.005, -0.008});
  EXPECT_NEAR(w.slices().cross_mm().x(), -10.0, 1e-9);
  // also where the slice is near and the tool is out of its picture
  ui::SliceView& axial = w.window.views().slice(Plane::Axial);
  axial.zoom(8.0, axial.projected({-10.0, 5.0, -8.0}));
  show({0.020, -0.015, -0.008});
  EXPECT_TRUE(QRectF(axial.pictureRect()).contains(axial.projected({20.0, -15.0, -8.0})));
  show({0.5, 0.0, 0.0});  // not beyond the volume
  EXPECT_NEAR(w.slices().cross_mm().x(), 31.5, 1e-9);
  // a hand that trembles does not take the slice from the user who scrolls
  axial.scroll(3);
  const Vec3 scrolled = w.slices().cross_mm();
  show({0.499, 0.0, 0.0});
  EXPECT_EQ((w.slices().cross_mm() - scrolled).norm(), 0.0);
  show({0.012, 0.0, 0.0});
  EXPECT_NEAR(w.slices().cross_mm().x(), 12.0, 1e-9);
  // any slice's button stops it in all of them
  auto* button = axial.parentWidget()->findChild<QToolButton*>("followTool");
  ASSERT_NE(button, nullptr);
  EXPECT_TRUE(button->isChecked());
  button->click();
  EXPECT_FALSE(w.action("followTool")->isChecked());
  show({0.0, 0.0, 0.0});
  EXPECT_NEAR(w.slices().cross_mm().x(), 12.0, 1e-9);
  w.action("followTool")->trigger();
  EXPECT_TRUE(button->isChecked());
  EXPECT_NEAR(w.slices().cross_mm().x(), 0.0, 1e-9);
}

TEST(Slices, MoveNothingWhileTheToolRestsAndAtMostTwentyTimesASecond) {
  Window w;
  w.show({0.0, 0.0, 0.0});
  QSignalSpy moved(&w.slices(), &ui::SliceSet::crossMoved);
  QElapsedTimer clock;
  clock.start();
  haptics::Snapshot snapshot;
  for (int n = 0; n < 200; ++n) {
    snapshot.X_WP = haptics::poseOf({1e-3 * (n % 20), 0.0, 0.006}, haptics::Quat::Identity());
    snapshot.X_WD = snapshot.X_WP;
    w.slices().display(snapshot);
  }
  EXPECT_LE(moved.count(), 1 + clock.elapsed() / 50);
  EXPECT_GE(moved.count(), 1);
  // what came in the pause is followed after it
  EXPECT_TRUE(window::waitFor([&] { return w.slices().cross_mm().x() == 19.0; }));
  QTest::qWait(120);
  const auto before = moved.count();
  for (int n = 0; n < 30; ++n) w.slices().display(snapshot);
  QTest::qWait(60);
  EXPECT_EQ(moved.count(), before);
}

TEST(Slices, TakePresetsByNumberKeysAndTypedNumbers) {
  Window w;
  ui::SliceView& axial = w.window.views().slice(Plane::Axial);
  QSignalSpy chosen(&w.slices(), &ui::SliceSet::greyChosen);
  const struct {
    Qt::Key key;
    double level, width;
  } keys[] = {{Qt::Key_1, 40.0, 400.0},  {Qt::Key_2, 500.0, 2000.0}, {Qt::Key_3, -600.0, 1500.0},
              {Qt::Key_4, 40.0, 80.0},   {Qt::Key_5, 50.0, 350.0},   {Qt::Key_6, 700.0, 4000.0},
              {Qt::Key_0, 200.0, 1600.0}};
  for (const auto& [key, level, width] : keys) {
    QTest::keyClick(&axial, key);
    EXPECT_EQ(w.slices().grey().level, level) << key;
    EXPECT_EQ(w.slices().grey().width, width) << key;
  }
  EXPECT_EQ(chosen.count(), 7);
  QTimer::singleShot(0, &w.window, [&] {
    auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
    ASSERT_NE(dialog, nullptr);
    for (const auto& [name, text] :
         {std::pair{"greyLevel", "-12"}, std::pair{"greyWidth", "345"}}) {
      auto* field = dialog->findChild<QDoubleSpinBox*>(name);
      field->setFocus();
      field->selectAll();
      QTest::keyClicks(field, text);
    }
    QTest::keyClick(dialog, Qt::Key_Return);
    if (dialog->isVisible()) dialog->reject();
  });
  QTest::keyClick(&axial, Qt::Key_W);
  EXPECT_EQ(w.slices().grey().level, -12.0);
  EXPECT_EQ(w.slices().grey().width, 345.0);
  // without Hounsfield units the presets mean nothing
  w.window.show(ctPicture(""), 300.0, "No unit");
  const double width = w.slices().grey().width;
  QTest::keyClick(&axial, Qt::Key_1);
  EXPECT_EQ(w.slices().grey().width, width);
}

TEST(Slices, TakeTheGreyWindowOfTheirScanAgain) {
  Window w;
  app::SharedState shared;
  app::GreyKeeper keeper(w.slices(), shared);
  const auto show = [&](const char* place) {
    shared.shown.emplace();
    shared.shown->place = place;
    w.window.show(ctPicture(), 300.0, "Ball");
    keeper.showScene();
  };
  show("/scans/one");
  QTest::keyClick(&w.window.views().slice(Plane::Axial), Qt::Key_3);
  show("/scans/another");
  EXPECT_EQ(w.slices().grey().width, 1600.0);
  EXPECT_FALSE(keeper.kept());
  show("/scans/one");
  EXPECT_EQ(w.slices().grey().level, -600.0);
  EXPECT_EQ(w.slices().grey().width, 1500.0);
}

TEST(Slices, TheSpaceViewSaysValueAndPlaceUnderThePointerToo) {
  Window w;
  const Vec3 p{0.001, -0.014, 0.002};
  int asked = 0;
  w.window.views().setTouched({.value = [](const Vec3&) { return 300.0; },
                               .behind = [](const Vec3&) { return 478.4; },
                               .firstMet =
                                   [&](const Vec3&, const Vec3&, double) {
                                     ++asked;
                                     return ui::SurfacePlace{p, Vec3::UnitY()};
                                   }});
  ui::VolumeView& view = w.window.views().volume();
  const auto* plate = view.parentWidget()->findChild<QLabel*>("pointed");
  ASSERT_NE(plate, nullptr);
  EXPECT_FALSE(plate->isVisible());
  const auto move = [&](QPointF at) {
    QMouseEvent event(QEvent::MouseMove, at, view.mapToGlobal(at), Qt::NoButton, Qt::NoButton, {});
    QCoreApplication::sendEvent(&view, &event);
  };
  for (int n = 0; n < 100; ++n) move({200.0 + n, 150.0});
  EXPECT_EQ(asked, 0);  // not for every move
  ASSERT_TRUE(window::waitFor([&] { return plate->isVisible(); }));
  EXPECT_EQ(asked, 1);
  // as the card says it of a tool that touches there
  EXPECT_EQ(plate->text(), "480 HU   LPS 1.0, -14.0, 2.0 mm");
  QTest::qWait(250);
  EXPECT_EQ(asked, 1);  // nothing is asked while the pointer rests
  QEvent leave(QEvent::Leave);
  QCoreApplication::sendEvent(&view, &leave);
  EXPECT_TRUE(window::waitFor([&] { return !plate->isVisible(); }));
}

TEST(Slices, ThePlateUnderThePointerKeepsOffTheCard) {
  auto* view = new QWidget;
  view->setMinimumSize(200, 150);
  ui::ViewFrame frame(view, Qt::gray, false);
  auto* card = new ui::ForcePanel;
  frame.setCard(
      *card, [](const QRect& part) { return part.left() > 200; },
      [](const QRect&) { return false; });
  frame.resize(700, 500);
  frame.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&frame));
  frame.keepCardClear();
  ASSERT_LT(card->x(), 100);  // in the lower left corner
  ASSERT_GT(card->y(), 200);
  const auto* plate = frame.findChild<QLabel*>("pointed");
  QCursor::setPos(frame.mapToGlobal(QPoint{30, 20}));
  frame.setPointed("312 HU   LPS 1.0, -14.0, 2.0 mm", {});
  EXPECT_FALSE(plate->geometry().contains(QPoint{30, 20}));
  // where words fill the upper half it goes down
  frame.setPointed("312 HU   LPS 1.0, -14.0, 2.0 mm", {QRectF{0.0, 0.0, 700.0, 250.0}});
  ASSERT_TRUE(plate->isVisible());
  EXPECT_GT(plate->y(), 240);
  EXPECT_FALSE(plate->geometry().intersects(card->geometry()));
  EXPECT_TRUE(view->geometry().contains(plate->geometry()));
}

TEST(Slices, ALowViewHasItsScaleAndItsPlace) {
  const ui::SliceReadout readout{.name = "Coronal",
                                 .place = "12 / 32   P 3.0 mm",
                                 .grey = "W 400  L 40",
                                 .letters = {"R", "L", "S", "I"}};
  const QRect widget(0, 0, 320, 150);
  const auto layout =
      ui::layOut(readout, QApplication::font(), widget, ui::pictureIn(widget, false), 92, 1.0);
  EXPECT_TRUE(layout.ruler.has_value());
  EXPECT_EQ(std::ranges::count(layout.texts, "P 3.0 mm", &ui::ReadoutText::text), 1);
}

TEST(Slices, FitTheBodyAtFirstByKeyAndByButton) {
  Window w;
  // a ball of 14 mm about (4, 0, 0) in air
  const auto bone = window::ball({0.004, 0.0, 0.0}, 0.014);
  w.window.show(ui::pictureOf(window::volumeOf(window::cubeGrid(64), haptics::ScalarType::Int16,
                                               [=](const Vec3& p) {
                                                 // and a table below it, which is no body
                                                 return std::abs(p.y() - 0.028) < 1e-3
                                                            ? 200.0
                                                            : -1000.0 + 20.0 * bone(p);
                                               },
                                               {.unit = "HU", .modality = "CT"})),
                300.0, "Ball");
  for (ui::SliceView* slice : w.slices().slices()) {
    if (slice->plane() == Plane::Oblique) continue;
    const QRectF room = slice->pictureRect();
    const auto fits = [&] {
      const double across = 31.0 / slice->mmPerPixel();  // px, with what is mixed with air
      EXPECT_LT(QLineF(slice->projected({4.0, 0.0, 0.0}), room.center()).length(), 0.06 * across);
      EXPECT_NEAR(across / std::min(room.width(), room.height()), 1.0, 0.12);
    };
    fits();
    const double fitted = slice->mmPerPixel();
    QTest::keyClick(slice, Qt::Key_R);
    EXPECT_GT(slice->mmPerPixel(), 1.5 * fitted);  // the whole slice
    QTest::keyClick(slice, Qt::Key_B);
    fits();
    // of all slices, as the menu says
    for (ui::SliceView* other : w.slices().slices()) other->resetView();
    QTest::keyClick(slice, Qt::Key_B);
    for (ui::SliceView* other : w.slices().slices())
      if (other->plane() != Plane::Oblique)
        EXPECT_LT(
            other->mmPerPixel(),
            31.0 / 0.85 / std::min(other->pictureRect().width(), other->pictureRect().height()));
    slice->pan({20.0, 0.0});
    slice->parentWidget()->findChild<QToolButton*>("fitBody")->click();
    fits();
  }
}

TEST(Slices, LookDownTheToolAndAlongItAndGoWithIt) {
  Window w;
  w.action("showOblique")->trigger();
  ui::SliceView& view = w.window.views().slice(Plane::Oblique);
  ASSERT_TRUE(view.isVisible());
  EXPECT_TRUE(view.readout().place.contains("no tool"));
  const haptics::Quat turn{Eigen::AngleAxisd(0.7, Vec3{0.3, 1.0, 0.2}.normalized())};
  const Vec3 tip{0.012, -0.004, 0.006};
  w.show(tip, turn);
  const Vec3 axis = turn * Vec3::UnitZ();
  // towards the viewer is the handle; the plane goes through the tip
  EXPECT_LT((view.axes().right.cross(view.axes().up) - axis).norm(), 1e-9);
  EXPECT_LT((view.through_mm() - tip * 1e3).norm(), 1e-9);
  EXPECT_LT(QLineF(view.projected(tip * 1e3), QRectF(view.pictureRect()).center()).length(), 1e-6);
  EXPECT_EQ(view.readout().place, "at its tip");
  EXPECT_GT(view.readout().letters[0].size(), 0);

  // the wheel goes ahead of the tip
  QWheelEvent wheel({90, 90}, view.mapToGlobal(QPointF{90, 90}), {}, {0, 360}, {}, {},
                    Qt::NoScrollPhase, false);
  QCoreApplication::sendEvent(&view, &wheel);
  EXPECT_LT((view.through_mm() - (tip * 1e3 - 3.0 * axis)).norm(), 1e-9);
  EXPECT_TRUE(view.readout().place.contains("+ 3.0 mm")) << qPrintable(view.readout().place);

  // it goes with the tool, and the picture does not spin as it tilts
  const Vec3 right = view.axes().right;
  const haptics::Quat more = haptics::Quat{Eigen::AngleAxisd(0.02, Vec3::UnitX())} * turn;
  w.show(tip + Vec3{0.001, 0.0, 0.0}, more);
  EXPECT_LT((view.axes().right.cross(view.axes().up) - more * Vec3::UnitZ()).norm(), 1e-9);
  EXPECT_LT((view.axes().right - right).norm(), 0.03);
  // rolling the handle alone leaves the picture as it is
  const Vec3 still = view.axes().right;
  w.show(tip, more * haptics::Quat{Eigen::AngleAxisd(1.0, Vec3::UnitZ())});
  EXPECT_LT((view.axes().right - still).norm(), 1e-9);

  QTest::keyClick(&view, Qt::Key_R);
  EXPECT_EQ(view.readout().place, "at its tip");
  w.action("obliqueAlong")->trigger();
  EXPECT_NEAR(std::abs(view.axes().normal.dot(more * Vec3::UnitZ())), 0.0, 1e-9);
  EXPECT_LT((view.axes().up - more * Vec3::UnitZ()).norm(), 1e-9);  // the handle is above
  EXPECT_LT((view.axes().right.cross(view.axes().up) + view.axes().normal).norm(), 1e-9);
  const QImage image = window::pictureOf(view);
  EXPECT_GT(window::count(image, window::proxyColoured), 20);
  // other slices show where its plane is
  w.slices().setGrey({.level = 9000.0, .width = 1.0});
  const QImage axial = window::pictureOf(w.window.views().slice(Plane::Axial));
  const auto violet = [](QColor c) {
    return c.blue() > 90 && c.blue() > 1.2 * c.red() && c.red() > 1.1 * c.green();
  };
  EXPECT_GT(window::count(axial, violet), 40);
}

/// Counts paints of one slice.
class PaintsSeen : public QObject {
 public:
  explicit PaintsSeen(QWidget& widget) { widget.installEventFilter(this); }
  int count = 0;

 protected:
  bool eventFilter(QObject*, QEvent* event) override {
    count += event->type() == QEvent::Paint;
    return false;
  }
};

/// Takes presses, and paints a magenta square over every view.
class Square : public ui::Overlay {
 public:
  void paint(QPainter& painter, const ui::ViewGeometry& view) const override {
    painter.fillRect(QRectF(view.projected(Vec3{0.5, 0.5, 0.5}) - QPointF{4, 4}, QSizeF{8, 8}),
                     QColor(255, 0, 255));
  }
  bool press(const ui::ViewGeometry& view, const QMouseEvent&) override {
    ++presses;
    return view.isSlice();
  }
  bool key(const ui::ViewGeometry&, const QKeyEvent& event) override {
    return event.key() == Qt::Key_PageUp;
  }
  int presses = 0;
};

TEST(Slices, GiveOverlaysMouseAndKeysFirst) {
  Window w;
  Square square;
  w.window.views().addOverlay(square);
  ui::SliceView& axial = w.window.views().slice(Plane::Axial);
  const Vec3 before = w.slices().cross_mm();
  QTest::mouseClick(&axial, Qt::LeftButton, {}, axial.pictureRect().center() + QPoint{30, 30});
  QTest::keyClick(&axial, Qt::Key_PageUp);
  EXPECT_EQ(square.presses, 1);
  EXPECT_EQ((w.slices().cross_mm() - before).norm(), 0.0);
  // the second click of a double click too: no tool comes where an edit is at work
  QSignalSpy wished(&axial, &ui::SliceView::doubleClicked);
  QTest::mouseDClick(&axial, Qt::LeftButton, {}, axial.pictureRect().center() + QPoint{30, 30});
  EXPECT_EQ(square.presses, 2);
  EXPECT_TRUE(wished.empty());
  EXPECT_EQ((w.slices().cross_mm() - before).norm(), 0.0);
  const auto magenta = [](QColor c) { return c.red() > 240 && c.blue() > 240 && c.green() < 20; };
  EXPECT_GT(window::count(window::pictureOf(axial), magenta), 30);
}

TEST(Slices, KeepCrosshairZoomAndGreyWhenVoxelsAreReplaced) {
  Window w;
  ui::SliceView& axial = w.window.views().slice(Plane::Axial);
  w.slices().moveCross({5.5, 6.5, 7.5});
  w.slices().setGrey({.level = 11.0, .width = 222.0});
  axial.zoom(2.0, {100.0, 100.0});
  const double scale = axial.mmPerPixel();
  w.window.views().replace(ctPicture());
  EXPECT_EQ((w.slices().cross_mm() - Vec3{5.5, 6.5, 7.5}).norm(), 0.0);
  EXPECT_EQ(w.slices().grey().width, 222.0);
  EXPECT_EQ(axial.mmPerPixel(), scale);
}

TEST(Slices, BeginOnAVoxelsCentre) {
  Window w;
  const Vec3 index = window::cubeGrid(64).indexOf(w.slices().cross_mm() * 1e-3);
  EXPECT_LT((index - Vec3::Constant(32.0)).norm(), 1e-9);
}

/// A real scan, or in its place the made head, which has the noise of a scanner.
std::shared_ptr<const haptics::Volume> scanOrMadeHead(const char* path) {
  const std::filesystem::path place = places::scan(path);
  if (!std::filesystem::exists(place)) {
    auto made = datasets::makePhantom("demo");
    return std::make_shared<const haptics::Volume>(std::move(made.value().volume));
  }
  auto volume = datasets::readVolume(place);
  EXPECT_TRUE(volume) << sentence(volume.error());
  return volume ? std::make_shared<const haptics::Volume>(std::move(*volume)) : nullptr;
}

// pictures of every state, to be looked at; and what scrolling takes
TEST(Slices, ShowAHeadInAllStates) {
  const auto volume = scanOrMadeHead("visible_human_female_head/vhf_head_512x512x234.nrrd");
  ASSERT_TRUE(volume);
  ui::MainWindow window;
  window.views().volume().setSurfaceWish(ui::SurfaceMode::Mesh);
  const auto field = std::make_shared<haptics::ScalarField>(volume);
  window.show(ui::pictureOf(volume), 300.0, "Head");
  window.views().setTouched(
      {.value = [field](const Vec3& p) { return field->value(field->indexOf(p)); }});
  haptics::TriangleMesh tool = window::octahedron(0.004);
  for (Vec3& v : tool.vertices)
    if (v.z() > 0.003) v.z() = 0.060;  // as long as a drill
  window.views().show(tool);
  window::showAndWait(window, {1280, 880});
  window.activateWindow();
  const auto act = [&](const char* name) {
    auto* action = window.findChild<QAction*>(name);
    if (action == nullptr) action = window.views().slices().menu().findChild<QAction*>(name);
    ASSERT_NE(action, nullptr) << name;
    action->trigger();
  };
  const auto keep = [&](const char* name) {
    QTest::qWait(600);
    window::keep(window::pictureOf(window), name);
  };
  keep("head_volume_large");
  act("four_up");
  keep("head_four_up");
  act("slices_large");
  keep("head_slices_large");
  // down to the surface along a ray from above the ear, and into contact
  const Eigen::AlignedBox3d box = ui::boxOf_mm(volume->grid);
  const Vec3 middle = box.center();
  const Vec3 outwards = Vec3{0.8, 0.2, 0.55}.normalized();
  double far = 200.0;
  while (far > 0.0 && field->value(field->indexOf((middle + far * outwards) * 1e-3)) < 300.0)
    far -= 0.1;
  const haptics::Quat turn = haptics::Quat::FromTwoVectors(Vec3::UnitZ(), outwards);
  haptics::Snapshot snapshot;
  snapshot.X_WP = haptics::poseOf((middle + far * outwards) * 1e-3 + turn * Vec3(0, 0, 4e-3), turn);
  snapshot.X_WD = snapshot.X_WP;
  snapshot.X_WD.translation() -= outwards * 3e-3;
  act("showOblique");
  window.views().slices().setFollowing(false);
  act("followTool");
  window.views().display(snapshot);
  window.touch().display(snapshot);
  keep("head_tool");
  act("obliqueAlong");
  act("four_up");
  keep("head_tool_along");
  for (ui::SliceView* slice : window.views().slices().slices())
    slice->zoom(6.0, slice->projected(window.views().slices().cross_mm()));
  keep("head_tool_near");
  act("resetSlices");
  act("showOblique");
  act("followTool");
  act("slabMaximum");
  keep("head_slab_maximum");
  act("slabMean");
  keep("head_slab_mean");
  act("slabNone");
  for (QAction* preset : window.views().slices().menu().findChild<QMenu*>("greyMenu")->actions()) {
    if (preset->objectName() == "typeGrey") continue;  // it asks
    preset->trigger();
    QTest::qWait(100);
    const QString name = "head_grey_" + preset->text().section(' ', 0, 0).toLower().remove('&');
    window::keep(window::pictureOf(window.views().slice(Plane::Axial)), qPrintable(name));
  }
  // scrolling, large
  ui::SliceView& axial = window.views().slice(Plane::Axial);
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window, 120'000));
  axial.setFocus();
  window.views().layout().toggleMaximised();
  ASSERT_TRUE(axial.isVisible());
  QTest::qWait(300);
  QTest::keyClick(&axial, Qt::Key_Home);
  const auto rate = [&](const char* what) {
    PaintsSeen paints(axial);
    QElapsedTimer timer;
    timer.start();
    for (int n = 1; n <= 60; ++n) {
      QTest::keyClick(&axial, Qt::Key_Up);
      while (paints.count < n && timer.elapsed() < 30'000) QCoreApplication::processEvents();
    }
    EXPECT_EQ(paints.count, 60);
    std::printf("%s: %.1f pictures a second at %d x %d\n", what,
                60e3 / double(std::max<qint64>(1, timer.elapsed())), axial.width(), axial.height());
  };
  rate("scrolling");
  act("showContour");
  rate("scrolling without contour");
  act("showContour");
  // and what one fine contour takes, without the window around it
  QTest::qWait(400);
  window.views().setIsovalue(301.0);
  QElapsedTimer timer;
  timer.start();
  const QPixmap alone = axial.grab();
  std::printf("contour and paint at rest: %lld ms, %zu pieces\n",
              static_cast<long long>(timer.elapsed()), axial.contour_W_mm().size());
  keep("head_axial_alone");
  SUCCEED();
}

TEST(Slices, ShowABoneScanInAllStates) {
  const auto volume = scanOrMadeHead("philips_head_phantom/bone_1mm");
  ASSERT_TRUE(volume);
  ui::MainWindow window;
  window.views().volume().setSurfaceWish(ui::SurfaceMode::Mesh);
  const auto field =
      std::make_shared<haptics::ScalarField>(volume, haptics::FieldKind::CubicSpline);
  window.show(ui::pictureOf(volume), 300.0, "Phantom");
  window.views().setTouched(
      {.value = [field](const Vec3& p) { return field->value(field->indexOf(p)); }});
  window.views().layout().arrange(ui::Arrangement::SlicesLarge);
  window::showAndWait(window, {1280, 880});
  QTest::qWait(600);
  window::keep(window::pictureOf(window), "phantom_slices_large");
  ui::SliceView& axial = window.views().slice(Plane::Axial);
  // at bone on the right, 50 mm from the middle or farther
  Vec3 bone = window.views().slices().cross_mm() + Vec3{-50.0, 5.0, 0.0};
  while (field->value(field->indexOf(1e-3 * bone)) < 300.0 && bone.x() > -150.0) bone.x() -= 0.5;
  axial.zoom(12.0, axial.projected(bone));
  QTest::qWait(600);
  window::keep(window::pictureOf(window), "phantom_near");
  // a tenth of a voxel holds on noise as well
  int places = 0, apart = 0;
  for (const auto& [a, b] : axial.contour_W_mm()) {
    const auto sample = field->sample(field->indexOf(0.5e-3 * (a + b)));
    ++places;
    apart += std::abs(sample.value - 300.0) / sample.gradient_W.norm() > 0.1 * field->voxel();
  }
  EXPECT_GT(places, 0);
  EXPECT_EQ(apart, 0) << "of " << places;
}

}  // namespace
