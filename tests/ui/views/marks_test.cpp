// SPDX-License-Identifier: BSD-3-Clause
// Measures, marks and notes: placed, dragged, listed and read by mouse and keys.
#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QDoubleSpinBox>
#include <QElapsedTimer>
#include <QLabel>
#include <QLineEdit>
#include <QMenuBar>
#include <QPainter>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableWidget>
#include <QWheelEvent>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <numbers>
#include <random>

#include "app/application.h"
#include "app/window/scan/loader.h"
#include "app/window/views/marks_controller.h"
#include "tests/support/places.h"
#include "tests/ui/views/marked_scan.h"
#include "tests/ui/views/sphere_in_hand.h"
#include "ui/controls/lengths.h"
#include "ui/overlays/measure_words.h"
#include "ui/views/volume_view.h"
#include "ui/window/main_window.h"
#include "ui/window/touch_state.h"
#include "ui/window/views.h"

namespace {

using haptics::Mat3;
using haptics::Vec3;
using ui::Measure;
using ui::MeasureKind;
using ui::Plane;
using window::click;
using window::dragFrom;
using window::MarkedScan;
using window::readingOf;
using window::waitFor;

constexpr double kBall_mm = 20.0;

std::shared_ptr<const haptics::Volume> ballVolume(int n = 64) {
  return window::volumeOf(window::cubeGrid(n), haptics::ScalarType::Int16,
                          window::ball(Vec3::Zero(), kBall_mm * 1e-3), {.unit = "HU"});
}

haptics::Grid markedGrid(std::array<std::int64_t, 3> dims, const Vec3& spacing_mm,
                         const Mat3& direction) {
  haptics::Grid grid;
  grid.dims = dims;
  grid.spacing = spacing_mm * 1e-3;
  grid.direction = direction;
  const Vec3 half{0.5 * double(dims[0] - 1), 0.5 * double(dims[1] - 1), 0.5 * double(dims[2] - 1)};
  grid.origin = -direction * half.cwiseProduct(grid.spacing);
  return grid;
}

/// Two voxels' centres 30 mm apart along an axis of the grid, in the plane of a slice.
struct Known {
  const char* name;
  haptics::Grid grid;
  Vec3 one, other;  ///< indices
  Plane plane;
  const char* reads;
};

std::vector<Known> knownDistances() {
  const Mat3 left_handed = Vec3{1.0, 1.0, -1.0}.asDiagonal();
  Mat3 permuted;
  permuted << 0, 0, 1, 1, 0, 0, 0, 1, 0;  // i along y, j along z, k along x
  return {{"voxels of 1 mm",
           window::cubeGrid(64),
           {17, 30, 31},
           {47, 30, 31},
           Plane::Axial,
           "30 mm ± 1 mm"},
          {"voxels of 0.3 mm",
           markedGrid({120, 120, 20}, Vec3::Constant(0.3), Mat3::Identity()),
           {10, 60, 9},
           {110, 60, 9},
           Plane::Axial,
           "30.0 mm ± 0.4 mm"},
          {"thick slices, left-handed, within a slice",
           markedGrid({100, 100, 20}, {0.5, 0.5, 3.0}, left_handed),
           {20, 50, 9},
           {80, 50, 9},
           Plane::Axial,
           "30.0 mm ± 0.6 mm"},
          {"thick slices, left-handed, across them",
           markedGrid({100, 100, 20}, {0.5, 0.5, 3.0}, left_handed),
           {50, 50, 4},
           {50, 50, 14},
           Plane::Coronal,
           "30 mm ± 2 mm"},
          {"permuted",
           markedGrid({60, 40, 30}, {1.0, 1.5, 2.0}, permuted),
           {30, 5, 15},
           {30, 25, 15},
           Plane::Sagittal,
           "30 mm ± 2 mm"}};
}

TEST(Marks, ADistanceOfTwoVoxelsReadsWithinItsStatedAccuracyWhicheverWayTheVoxelsLie) {
  for (const Known& known : knownDistances()) {
    SCOPED_TRACE(known.name);
    MarkedScan scan;
    scan.show(
        window::volumeOf(known.grid, haptics::ScalarType::Int16, window::ball(Vec3::Zero(), 0.01)),
        50.0);
    window::showActive(scan.window);
    const Vec3 one = known.grid.worldOf(known.one) * 1e3,
               other = known.grid.worldOf(known.other) * 1e3;
    ASSERT_NEAR((one - other).norm(), 30.0, 1e-9);
    scan.window.views().setCross(one);
    ui::SliceView& slice = scan.slice(known.plane);
    click(slice, {3.0, 50.0});  // takes the focus
    scan.window.views().setCross(one);
    QTest::keyClick(&slice, Qt::Key_D);
    click(slice, slice.projected(one));
    click(slice, slice.projected(other));
    ASSERT_EQ(scan.measures().all().size(), 1U);
    const Measure& distance = scan.last();
    ASSERT_EQ(distance.kind, MeasureKind::Distance);
    // a click is a whole pixel
    const double pixel = 1.0 / (slice.projected(one + Vec3{1, 1, 1}) - slice.projected(one)).x();
    EXPECT_LT((distance.places_mm[0] - one).norm(), 1.0 * std::abs(pixel));
    EXPECT_LT((distance.places_mm[1] - other).norm(), 1.0 * std::abs(pixel));
    const auto reading = readingOf(scan.value(0));
    ASSERT_TRUE(reading) << scan.value(0).toStdString();
    EXPECT_LE(std::abs(reading->number - 30.0), reading->accuracy);
    // and at the very centres it is 30
    Measure exact{MeasureKind::Distance, "d", {one, other}};
    EXPECT_EQ(ui::valueOf(exact, scan.measures().scan()).replace(QChar(QChar::Nbsp), ' '),
              QString(known.reads));
  }
}

TEST(Marks, ADistanceIsReadInTheUnitThatWasChosen) {
  MarkedScan scan;
  scan.show(window::volumeOf(window::cubeGrid(64), haptics::ScalarType::Int16,
                             window::ball(Vec3::Zero(), 0.01)),
            50.0);
  window::showActive(scan.window);
  ui::SliceView& slice = scan.slice(Plane::Axial);
  click(slice, {3.0, 50.0});
  QTest::keyClick(&slice, Qt::Key_D);
  click(slice, slice.projected({-10.0, 0.0, 0.0}));
  click(slice, slice.projected({10.0, 0.0, 0.0}));
  const auto mm = readingOf(scan.value(0));
  ASSERT_TRUE(mm);
  EXPECT_NEAR(mm->number, 20.0, 1.0);
  EXPECT_TRUE(scan.value(0).contains("mm"));
  ui::setLengthUnit(ui::LengthUnit::Centimetres);
  const QString told = scan.value(0);
  ui::setLengthUnit(ui::LengthUnit::Millimetres);
  const auto cm = readingOf(told);
  ASSERT_TRUE(cm) << told.toStdString();
  EXPECT_TRUE(told.contains("cm"));
  EXPECT_NEAR(cm->number, 0.1 * mm->number, 1e-9);
  EXPECT_NEAR(cm->accuracy, 0.1 * mm->accuracy, 1e-9);
}

TEST(Marks, ANumberEndsAtTheFirstDigitOfItsAccuracy) {
  const auto words = [](double number, double accuracy, const char* unit) {
    return ui::rounded(number, accuracy, unit).replace(QChar(QChar::Nbsp), ' ').toStdString();
  };
  EXPECT_EQ(words(12.345, 0.367, "mm"), "12.3 mm ± 0.4 mm");
  EXPECT_EQ(words(30.4, 1.22, "mm"), "30 mm ± 1 mm");
  EXPECT_EQ(words(30.44, 0.94, "mm"), "30.4 mm ± 0.9 mm");
  EXPECT_EQ(words(30.44, 0.96, "mm"), "30 mm ± 1 mm");
  EXPECT_EQ(words(123.0, 12.2, "mm"), "120 mm ± 10 mm");
  EXPECT_EQ(words(0.0123, 0.0122, "mm"), "0.01 mm ± 0.01 mm");
  EXPECT_EQ(words(89.7, 2.3, "°"), "90° ± 2°");
  EXPECT_EQ(words(-0.2, 1.2, "mm"), "0 mm ± 1 mm");
  EXPECT_EQ(words(std::nan(""), 1.0, "mm"), "unknown");
}

TEST(Marks, AnAngleStatesTheAccuracyThatItsPlacesHaveTogether) {
  // against the same by differences, for legs of any length and direction
  std::mt19937 random{5};
  std::uniform_real_distribution<double> place(-25.0, 25.0);
  ui::MeasuredScan scan;
  scan.grid = markedGrid({64, 64, 64}, {0.4, 0.7, 1.6}, Mat3::Identity());
  int checked = 0;
  for (int trial = 0; trial < 200; ++trial) {
    Measure angle{MeasureKind::Angle, "a", {}};
    for (int p = 0; p < 3; ++p)
      angle.places_mm.push_back({place(random), place(random), place(random)});
    std::vector<Eigen::Vector3d> changes;
    for (std::size_t p = 0; p < 3; ++p) {
      Eigen::Vector3d change;
      for (int a = 0; a < 3; ++a) {
        Measure more = angle, less = angle;
        more.places_mm[p][a] += 1e-4;
        less.places_mm[p][a] -= 1e-4;
        change[a] = (ui::angleOf_deg(more) - ui::angleOf_deg(less)) / 2e-4;
      }
      changes.push_back(change);
    }
    const double accuracy = ui::accuracyOf(scan.grid, changes);
    const auto reading = readingOf(ui::valueOf(angle, scan));
    if (accuracy > 80.0) continue;
    ASSERT_TRUE(reading);
    const double digit = std::pow(10.0, std::floor(std::log10(accuracy)));
    EXPECT_LE(std::abs(reading->accuracy - accuracy), 0.51 * digit) << trial;
    EXPECT_LE(std::abs(reading->number - ui::angleOf_deg(angle)), 5.1 * digit) << trial;
    ++checked;
  }
  EXPECT_GT(checked, 150);
  // legs in one line, and a leg without length
  const Measure straight{MeasureKind::Angle, "a", {{-20, 0, 0}, {0, 0, 0}, {20, 0, 0}}};
  EXPECT_EQ(readingOf(ui::valueOf(straight, scan))->number, 180.0);
  const Measure none{MeasureKind::Angle, "a", {{1, 1, 1}, {1, 1, 1}, {20, 0, 0}}};
  EXPECT_EQ(ui::valueOf(none, scan), "unknown");
}

TEST(Marks, AnAngleIsPlacedByThreeClicksWithItsCornerSecond) {
  MarkedScan scan;
  scan.show(ballVolume(), 50.0);
  window::showActive(scan.window);
  ui::SliceView& slice = scan.slice(Plane::Coronal);
  click(slice, slice.projected({0, 0, 0}));
  scan.window.views().setCross({0, 0, 0});
  QTest::keyClick(&slice, Qt::Key_A);
  for (const Eigen::Vector3d& p :
       {Eigen::Vector3d{20, 0, 0}, Eigen::Vector3d{0, 0, 0}, Eigen::Vector3d{0, 0, 20}})
    click(slice, slice.projected(p));
  ASSERT_EQ(scan.measures().all().size(), 1U);
  EXPECT_EQ(scan.last().kind, MeasureKind::Angle);
  EXPECT_NEAR(ui::angleOf_deg(scan.last()), 90.0, 1.5);  // a pixel is 0.3 mm
  const auto reading = readingOf(scan.value(0));
  ASSERT_TRUE(reading);
  EXPECT_LE(std::abs(reading->number - 90.0), reading->accuracy);
  EXPECT_FALSE(scan.measures().placing());  // one measure, then the mouse is the view's again
  window::keep(window::pictureOf(scan.window), "marks_angle");
}

TEST(Marks, APointReadsTheValueOfItsVoxel) {
  const haptics::Grid grid =
      markedGrid({32, 40, 24}, {1.0, 0.8, 1.5}, Vec3{-1.0, 1.0, 1.0}.asDiagonal());
  const auto intensity = [&](const Vec3& p_W) {
    const Vec3 index = grid.indexOf(p_W);
    return std::round(index.x()) * 20.0 - std::round(index.y()) * 3.0 +
           std::round(index.z()) * 50.0;
  };
  MarkedScan scan;
  scan.show(window::volumeOf(grid, haptics::ScalarType::Int16, intensity, {.unit = "HU"}), 900.0);
  window::showActive(scan.window);
  std::mt19937 random{3};
  for (int trial = 0; trial < 20; ++trial) {
    const Vec3 index{double(random() % 32), double(random() % 40), double(random() % 24)};
    const Measure point{MeasureKind::Point, "p", {grid.worldOf(index) * 1e3}};
    EXPECT_EQ(ui::valueOf(point, scan.measures().scan()).replace(QChar(QChar::Nbsp), ' '),
              QString("%1 HU").arg(std::lround(intensity(grid.worldOf(index)))));
  }
  // by a click, within the slope of a pixel
  const Vec3 index{20, 21, 12};
  const Eigen::Vector3d p = grid.worldOf(index) * 1e3;
  ui::SliceView& slice = scan.slice(Plane::Axial);
  click(slice, slice.projected(p));
  scan.window.views().setCross(p);
  QTest::keyClick(&slice, Qt::Key_V);
  click(slice, slice.projected(p));
  ASSERT_EQ(scan.measures().all().size(), 1U);
  const double value = scan.value(0).section(QChar(QChar::Nbsp), 0, 0).toDouble();
  EXPECT_NEAR(value, intensity(grid.worldOf(index)), 20.0 * 0.3 + 3.0 * 0.3);
  // beyond the scan there is no value
  const Measure outside{MeasureKind::Point, "p", {Eigen::Vector3d{400, 0, 0}}};
  EXPECT_EQ(ui::valueOf(outside, scan.measures().scan()), "outside the scan");
}

TEST(Marks, ADistanceMayBeDrawnAndItsHandleDraggedInThePlaneOfASlice) {
  MarkedScan scan;
  scan.show(ballVolume(), 50.0);
  window::showActive(scan.window);
  ui::SliceView& axial = scan.slice(Plane::Axial);
  scan.window.views().setCross({0, 0, 4.0});
  axial.setFocus();
  QTest::keyClick(&axial, Qt::Key_D);
  dragFrom(axial, axial.projected({-10, 0, 4}), axial.projected({10, 0, 4}));
  ASSERT_EQ(scan.measures().all().size(), 1U);
  EXPECT_NEAR(ui::distanceOf_mm(scan.last()), 20.0, 0.7);
  const QString before = scan.value(0);
  // seen from another slice 3 mm beside it: the handle keeps its depth
  scan.window.views().setCross({0, 0, 1.0});
  dragFrom(axial, axial.projected(scan.last().places_mm[1]), axial.projected({10, 12, 1}));
  EXPECT_LT((scan.last().places_mm[1] - Eigen::Vector3d{10, 12, 4}).norm(), 0.7);
  EXPECT_NE(scan.value(0), before);
  EXPECT_EQ(scan.window.findChild<QTableWidget*>("marks")->item(0, 1)->text(), scan.value(0));
  // and not beyond the scan
  dragFrom(axial, axial.projected(scan.last().places_mm[1]), QPointF{axial.width() - 2.0, 60.0});
  EXPECT_LE(scan.last().places_mm[1].cwiseAbs().maxCoeff(), 31.5 + 1e-9);
}

TEST(Marks, InThreeDimensionsPlacesLieOnTheSurfaceAndHandlesMoveAlongIt) {
  MarkedScan scan;
  scan.show(ballVolume(), 50.0);
  window::showActive(scan.window);
  ui::VolumeView& view = scan.window.views().volume();
  const auto at = [&](const Eigen::Vector3d& p_mm) { return view.projected(p_mm * 1e-3); };
  view.setFocus();
  QTest::keyClick(&view, Qt::Key_D);
  // the view looks from the front: -y is towards it
  const Eigen::Vector3d one = Eigen::Vector3d{-0.5, -1.0, 0.2}.normalized() * kBall_mm;
  const Eigen::Vector3d other = Eigen::Vector3d{0.5, -1.0, 0.2}.normalized() * kBall_mm;
  click(view, at(one));
  click(view, at(other));
  ASSERT_EQ(scan.measures().all().size(), 1U);
  const auto onSurface = [&] {
    for (const Eigen::Vector3d& p : scan.last().places_mm)
      EXPECT_NEAR(p.norm(), kBall_mm, 0.2);  // mm: the voxels' own roundness
  };
  onSurface();
  EXPECT_NEAR(ui::distanceOf_mm(scan.last()), (one - other).norm(), 0.6);
  window::keep(window::pictureAtRest(view), "marks_3d");

  const Eigen::Vector3d third = Eigen::Vector3d{0.3, -1.0, -0.6}.normalized() * kBall_mm;
  const Eigen::Matrix3d axes = view.viewAxes();
  dragFrom(view, at(scan.last().places_mm[1]), at(third));
  EXPECT_LT((scan.last().places_mm[1] - third).norm(), 0.6);
  onSurface();
  EXPECT_EQ(view.viewAxes(), axes);  // the camera stayed
  // beside the surface the drag is nobody's, and beside any handle it turns the camera
  const Eigen::Vector3d kept = scan.last().places_mm[1];
  dragFrom(view, at(kept), {5.0, 5.0});
  EXPECT_NEAR(scan.last().places_mm[1].norm(), kBall_mm, 0.2);
  QTest::keyClick(&view, Qt::Key_D);
  dragFrom(view, {5.0, 5.0}, {60.0, 30.0});
  EXPECT_NE(view.viewAxes(), axes);
  EXPECT_EQ(scan.measures().all().size(), 1U);
}

TEST(Marks, HandlesAreSolidInTheirSliceHollowBesideItAndGoneFurtherOff) {
  MarkedScan scan;
  scan.show(ballVolume(), 50.0);
  window::showActive(scan.window);
  scan.measures().replace({{MeasureKind::Point, "p", {{10.0, 5.0, 0.0}}}});
  ui::SliceView& axial = scan.slice(Plane::Axial);
  const auto inkAt = [&](double z) {
    scan.window.views().setCross({-25.0, -25.0, z});
    const QImage image = window::pictureOf(axial);
    const QPoint at = axial.projected({10.0, 5.0, 0.0}).toPoint();
    return window::count(image.copy(at.x() - 8, at.y() - 8, 17, 17), window::inked);
  };
  const int solid = inkAt(0.0), near_by = inkAt(0.4), hollow = inkAt(3.0), gone = inkAt(7.0);
  EXPECT_GT(solid, 60);
  EXPECT_GT(near_by, 60);
  EXPECT_LT(hollow, solid - 20);
  EXPECT_GT(hollow, 15);
  EXPECT_EQ(gone, 0);
  scan.window.views().setCross({-25.0, -25.0, 3.0});
  window::keep(window::pictureOf(axial), "marks_hollow");
}

TEST(Marks, InThreeDimensionsAHandleBehindTheSurfaceIsHollow) {
  MarkedScan scan;
  scan.show(ballVolume(), 50.0);
  window::showActive(scan.window);
  ui::VolumeView& view = scan.window.views().volume();
  const auto inkOf = [&](const Eigen::Vector3d& p) {
    scan.measures().replace({{MeasureKind::Point, "p", {p}}});
    const QImage image = window::pictureAtRest(view);
    const QPoint at = view.projected(p * 1e-3).toPoint();
    return window::count(image.copy(at.x() - 8, at.y() - 8, 17, 17), window::inked);
  };
  const int front = inkOf({6.0, -std::sqrt(kBall_mm * kBall_mm - 36.0), 0.0});
  const int behind = inkOf({6.0, std::sqrt(kBall_mm * kBall_mm - 36.0), 0.0});
  EXPECT_GT(front, 60);
  EXPECT_GT(behind, 15);
  EXPECT_LT(behind, front - 20);
}

TEST(Marks, LabelsCoverNoneOfTheirOwnPointsAndAreReadOnBrightAndDarkGround) {
  for (const double level : {-5000.0, 5000.0}) {  // all white, all black
    MarkedScan scan;
    scan.show(ballVolume(), 50.0);
    window::showActive(scan.window);
    ui::SliceView& axial = scan.slice(Plane::Axial);
    emit axial.greyChanged({.level = level, .width = 100.0});
    scan.window.views().setCross({-31.0, -31.0, 0.0});
    std::mt19937 random{9};
    // within the words of the slice, which stand above marks
    std::uniform_real_distribution<double> place(-19.0, 19.0);
    int checked = 0;
    for (int trial = 0; trial < 25; ++trial) {
      Measure angle{MeasureKind::Angle, "Angle of a wall", {}};
      for (int p = 0; p < 3; ++p) angle.places_mm.push_back({place(random), place(random), 0.0});
      // handles over one another hide each other
      const auto apart = [&](int one, int other) {
        const QPointF by = axial.projected(angle.places_mm[std::size_t(one)]) -
                           axial.projected(angle.places_mm[std::size_t(other)]);
        return std::hypot(by.x(), by.y()) > 16.0;  // pixels
      };
      if (!apart(0, 1) || !apart(1, 2) || !apart(0, 2)) continue;
      ++checked;
      scan.measures().replace({angle});
      const QImage image = window::pictureOf(axial);
      for (const Eigen::Vector3d& p : angle.places_mm) {
        const QPointF at = axial.projected(p);
        int ink = 0, dark = 0;
        const auto pixel = [&](const QPointF& spot) {
          return image.pixelColor(int(std::floor(spot.x())), int(std::floor(spot.y())));
        };
        for (int turn = 0; turn < 8; ++turn) {
          const double a = turn * std::numbers::pi / 4.0;
          const QPointF way{std::cos(a), std::sin(a)};
          ink += window::inked(pixel(at + 3.5 * way));
          dark += pixel(at + 6.6 * way).lightness() < 140;
        }
        EXPECT_GE(ink, 6) << "trial " << trial;  // of 8
        EXPECT_GE(dark, 4) << "trial " << trial;
      }
      if (checked == 1) window::keep(image, level < 0 ? "marks_on_white" : "marks_on_black");
    }
    EXPECT_GT(checked, 15);
  }
}

TEST(Marks, KeysPlaceOnlyWhileAViewHasTheFocus) {
  MarkedScan scan;
  scan.show(ballVolume(), 50.0);
  window::showActive(scan.window);
  const std::pair<Qt::Key, MeasureKind> keys[] = {{Qt::Key_D, MeasureKind::Distance},
                                                  {Qt::Key_A, MeasureKind::Angle},
                                                  {Qt::Key_V, MeasureKind::Point},
                                                  {Qt::Key_N, MeasureKind::Note}};
  for (QWidget* view : {static_cast<QWidget*>(&scan.window.views().volume()),
                        static_cast<QWidget*>(&scan.slice(Plane::Axial)),
                        static_cast<QWidget*>(&scan.slice(Plane::Sagittal))})
    for (const auto& [key, kind] : keys) {
      view->setFocus();
      QTest::keyClick(view, key);
      EXPECT_EQ(scan.measures().placing(), kind);
      EXPECT_TRUE(scan.panel().placeAction(kind)->isChecked());
      QTest::keyClick(view, key);  // again: no more
      EXPECT_FALSE(scan.measures().placing());
    }
  auto* typed = scan.window.findChild<QDoubleSpinBox*>("isovalueTyped");
  typed->setFocus();
  for (const auto& [key, kind] : keys) QTest::keyClick(typed, key);
  EXPECT_FALSE(scan.measures().placing());
}

TEST(Marks, EscapePutsAMeasureAwayThatIsBeingPlaced) {
  MarkedScan scan;
  scan.show(ballVolume(), 50.0);
  window::showActive(scan.window);
  ui::SliceView& axial = scan.slice(Plane::Axial);
  axial.setFocus();
  QTest::keyClick(&axial, Qt::Key_A);
  click(axial, axial.projected({-5.0, 0.0, 0.0}));
  ASSERT_EQ(scan.measures().placing(), MeasureKind::Angle);
  QSignalSpy stopped(&scan.window.touch(), &ui::TouchState::forceOffWanted);
  QTest::keyClick(&axial, Qt::Key_Escape);
  EXPECT_FALSE(scan.measures().placing());
  EXPECT_EQ(stopped.count(), 0);  // of a mouse: the next one stops
  QTest::keyClick(&axial, Qt::Key_Escape);
  EXPECT_GT(stopped.count(), 0);
  EXPECT_FALSE(scan.panel().placeAction(MeasureKind::Angle)->isChecked());
  // the click of afterwards is the view's
  click(axial, axial.projected({5.0, 6.0, 0.0}));
  EXPECT_NEAR(scan.window.views().cross_mm().x(), 5.0, 1.0);
  EXPECT_TRUE(scan.measures().all().empty());
}

TEST(Marks, BackspaceTakesAPlaceBackDeleteDeletesAndUndoBringsBack) {
  MarkedScan scan;
  scan.show(ballVolume(), 50.0);
  window::showActive(scan.window);
  ui::SliceView& axial = scan.slice(Plane::Axial);
  axial.setFocus();
  const auto placePoint = [&](double x) {
    QTest::keyClick(&axial, Qt::Key_V);
    click(axial, axial.projected({x, -20.0, 0.0}));
  };
  QTest::keyClick(&axial, Qt::Key_D);
  click(axial, axial.projected({-15, 0, 0}));
  QTest::keyClick(&axial, Qt::Key_Backspace);
  click(axial, axial.projected({-5, 0, 0}));
  EXPECT_TRUE(scan.measures().all().empty());
  click(axial, axial.projected({15, 0, 0}));
  ASSERT_EQ(scan.measures().all().size(), 1U);
  EXPECT_NEAR(scan.last().places_mm[0].x(), -5.0, 0.4);
  for (const double x : {-10.0, 0.0, 10.0}) placePoint(x);
  ASSERT_EQ(scan.measures().all().size(), 4U);
  EXPECT_EQ(scan.measures().all()[2].text, "Point 2");
  // chosen by a click on its handle, deleted with the key
  click(axial, axial.projected(scan.measures().all()[2].places_mm[0]));
  EXPECT_EQ(scan.measures().selected(), 2);
  QTest::keyClick(&axial, Qt::Key_Delete);
  ASSERT_EQ(scan.measures().all().size(), 3U);
  auto* list = scan.window.findChild<QTableWidget*>("marks");
  list->selectRow(0);
  QTest::keyClick(list, Qt::Key_Delete);
  ASSERT_EQ(scan.measures().all().size(), 2U);
  auto* undo = scan.window.findChild<QPushButton*>("restoreMark");
  ASSERT_TRUE(undo->isEnabled());
  undo->click();
  undo->click();
  EXPECT_FALSE(undo->isEnabled());
  ASSERT_EQ(scan.measures().all().size(), 4U);
  EXPECT_EQ(scan.measures().all()[0].text, "Distance 1");
  EXPECT_EQ(scan.measures().all()[2].text, "Point 2");
  EXPECT_EQ(list->rowCount(), 4);
}

TEST(Marks, TheListRenamesGoesToAPlaceAndIsReachedWithTab) {
  MarkedScan scan;
  scan.show(ballVolume(), 50.0);
  window::showActive(scan.window);
  scan.measures().replace({{MeasureKind::Distance, "Distance 1", {{1, 2, 3}, {4, 5, 6}}},
                           {MeasureKind::Point, "Point 1", {{7, 8, 9}}}});
  for (QAction* menu : scan.window.menuBar()->actions())
    if (menu->text() == "&View")
      for (QAction* action : menu->menu()->actions())
        if (action->text() == "&Measures and marks") action->trigger();
  auto* list = scan.window.findChild<QTableWidget*>("marks");
  ASSERT_TRUE(list->isVisible());
  QTest::qWait(50);
  window::keep(window::pictureOf(scan.window), "marks_panel");
  // nothing is cut off at the side, and the warning is always in sight
  for (const char* name : {"placeNoteButton", "restoreMark", "travelEnd"}) {
    auto* button = scan.panel().findChild<QWidget*>(name);
    ASSERT_NE(button, nullptr) << name;
    EXPECT_LE(button->mapTo(&scan.panel(), QPoint{button->width(), 0}).x(), scan.panel().width());
  }
  const auto* warning = scan.panel().findChild<QLabel*>("marksAccuracy");
  EXPECT_FALSE(warning->visibleRegion().isEmpty());
  EXPECT_TRUE(list->hasFocus());
  scan.window.setFocus();
  bool reached = false;
  for (int i = 0; i < 100 && !reached; ++i) {
    QTest::keyClick(QApplication::focusWidget() ? QApplication::focusWidget() : &scan.window,
                    Qt::Key_Tab);
    reached = list->hasFocus();
  }
  EXPECT_TRUE(reached);

  list->setCurrentCell(0, 0);
  QTest::keyClick(list, Qt::Key_F2);
  auto* editor = list->findChild<QLineEdit*>();
  ASSERT_NE(editor, nullptr);
  editor->setText(QString("The canal\x07 <b>wide</b>"));
  QTest::keyClick(editor, Qt::Key_Return);
  QTest::qWait(50);  // the list takes the text when the key has been handled
  EXPECT_EQ(scan.measures().all()[0].text, "The canal  <b>wide</b>");
  EXPECT_EQ(list->item(0, 0)->text(), "The canal  <b>wide</b>");

  list->selectRow(0);
  QTest::keyClick(list, Qt::Key_Return);
  EXPECT_LT((scan.window.views().cross_mm() - Eigen::Vector3d{1, 2, 3}).norm(), 1e-9);
  QTest::mouseClick(scan.window.findChild<QPushButton*>("goToMark"), Qt::LeftButton);
  EXPECT_LT((scan.window.views().cross_mm() - Eigen::Vector3d{4, 5, 6}).norm(), 1e-9);
  list->selectRow(1);
  QTest::keyClick(list, Qt::Key_Return);
  EXPECT_LT((scan.window.views().cross_mm() - Eigen::Vector3d{7, 8, 9}).norm(), 1e-9);
}

TEST(Marks, ANoteIsTypedWhereItWasPlaced) {
  MarkedScan scan;
  scan.show(ballVolume(), 50.0);
  window::showActive(scan.window);
  ui::VolumeView& view = scan.window.views().volume();
  view.setFocus();
  auto* hint = view.parentWidget()->findChild<QLabel*>("viewHint");
  const QString before = hint->text();
  QTest::keyClick(&view, Qt::Key_N);
  EXPECT_NE(hint->text(), before);  // at once
  click(view, view.projected({0.0, -kBall_mm * 1e-3, 0.0}));
  auto* list = scan.window.findChild<QTableWidget*>("marks");
  auto* editor = list->findChild<QLineEdit*>();
  ASSERT_NE(editor, nullptr);
  EXPECT_TRUE(list->isVisible());
  // the text before does not shine through
  editor->clear();
  const QRect inside(editor->mapTo(list, QPoint{8, 4}), editor->size() - QSize{16, 8});
  const QImage empty = window::pictureOf(*list).copy(inside);
  window::keep(empty, "marks_note_empty");
  EXPECT_EQ(
      window::count(empty, [&](QColor c) { return c != empty.pixelColor(empty.rect().center()); }),
      0);
  QTest::keyClicks(editor, "thin wall");
  QTest::keyClick(editor, Qt::Key_Return);
  QTest::qWait(50);  // the list takes the text when the key has been handled
  ASSERT_EQ(scan.measures().all().size(), 1U);
  EXPECT_EQ(scan.last().kind, MeasureKind::Note);
  EXPECT_EQ(scan.last().text, "thin wall");
  // the view in which it was set has the keys again
  EXPECT_TRUE(waitFor([&] { return QApplication::focusWidget() == &view; }));
  EXPECT_EQ(scan.value(0), "");
  window::keep(window::pictureAtRest(view), "marks_note_3d");
  window::keep(window::pictureOf(scan.window), "marks_note");
}

TEST(Marks, TheWayOfTheToolIsAddedUpAndNothingIsPaintedWhileItRests) {
  MarkedScan scan;
  scan.show(ballVolume(), 50.0);
  window::showActive(scan.window);
  haptics::Snapshot& snapshot = scan.shared.snapshot;
  snapshot.scene = scan.shared.shown->scene->id;
  const auto put = [&](const Vec3& p_W) {
    ++snapshot.tick;
    snapshot.X_WP.translation() = p_W;
    scan.controller.refresh();
  };
  auto* words = scan.window.findChild<QLabel*>("travelled");
  const QString unmeasured = words->text();
  put({0.05, 0.0, 0.0});
  EXPECT_EQ(words->text(), unmeasured);
  scan.window.findChild<QPushButton*>("travelStart")->click();
  // three quarters of a circle of 50 mm, with the tremor of a hand at rest in between
  constexpr int kSteps = 600;
  const double quarters = 1.5 * std::numbers::pi;
  for (int i = 0; i <= kSteps; ++i) {
    const double a = quarters * i / kSteps;
    const double tremor = (i % 2) * 2e-6;
    put({0.05 * std::cos(a) + tremor, 0.05 * std::sin(a), 0.0});
    if (i % 100 == 0)
      for (int n = 0; n < 1000; ++n)
        put({0.05 * std::cos(a) + (n % 2) * 5e-6, 0.05 * std::sin(a), 0.0});
  }
  QTest::qWait(120);
  scan.controller.refresh();
  // 50 mm · 1.5 π = 235.6 mm; straight 50 mm · √2 = 70.7 mm
  EXPECT_TRUE(words->text().contains(QStringLiteral("235.6\u00a0mm")) ||
              words->text().contains(QStringLiteral("235.5\u00a0mm")))
      << words->text().toStdString();
  EXPECT_TRUE(words->text().contains(QStringLiteral("70.7\u00a0mm")))
      << words->text().toStdString();
  window::keep(window::pictureOf(scan.window), "marks_travelled");

  // at rest: no text and no view changes
  int painted = 0;
  class PaintCount : public QObject {
   public:
    explicit PaintCount(int& count) : count_(count) { qApp->installEventFilter(this); }
    bool eventFilter(QObject*, QEvent* event) override {
      count_ += event->type() == QEvent::Paint;
      return false;
    }
    int& count_;
  };
  window::rest(scan.window.views().volume());
  for (ui::SliceView* slice : scan.window.views().slices().slices()) window::rest(*slice);
  QTest::qWait(200);
  {
    const PaintCount paints(painted);
    for (int i = 0; i < 40; ++i) {
      put(snapshot.X_WP.translation());
      QTest::qWait(10);
    }
    EXPECT_EQ(painted, 0);
  }
  // while it moves: ten times a second at most
  int changes = 0;
  QString shown = words->text();
  QElapsedTimer clock;
  clock.start();
  for (int i = 0; changes < 6; ++i) {
    ASSERT_LT(i, 10'000);
    put({0.0, -0.05 + 1e-4 * i, 0.0});
    if (words->text() != shown) ++changes;
    shown = words->text();
    QTest::qWait(4);
  }
  EXPECT_GE(clock.elapsed(), (changes - 1) * 95);
  // another hand begins elsewhere: no way lies between
  const double before =
      words->text().section("travelled ", 1).section(QChar(QChar::Nbsp), 0, 0).toDouble();
  snapshot.tick = 0;
  QTest::qWait(120);
  put({0.0, 0.0, 0.3});
  QTest::qWait(120);
  put({0.0, 0.0, 0.301});
  const double after =
      words->text().section("travelled ", 1).section(QChar(QChar::Nbsp), 0, 0).toDouble();
  EXPECT_LT(after - before, 25.0);
  scan.window.findChild<QPushButton*>("travelEnd")->click();
  EXPECT_EQ(words->text(), unmeasured);
}

TEST(Marks, NotForTreatmentStandsOnceInTheWindowAndInEveryPictureOfAMeasure) {
  MarkedScan scan;
  scan.show(ballVolume(), 50.0);
  window::showActive(scan.window);
  ui::SliceView& axial = scan.slice(Plane::Axial);
  const auto said = [&] {
    int times = 0;
    for (const QLabel* label : scan.window.findChildren<QLabel*>())
      times += label->isVisible() && label->text().contains("Not for treatment");
    return times;
  };
  EXPECT_EQ(said(), 1);
  const auto amber = [](QColor c) { return c.red() > 150 && c.blue() < 0.5 * c.green(); };
  const auto foot = [&](const QImage& image) {
    const int top = axial.pictureRect().bottom() + 1;
    return image.copy(image.width() / 2 + 20, top, image.width() / 2 - 20, image.height() - top);
  };
  const QImage before = axial.picture(1), shown = window::pictureOf(axial);
  const QImage space = scan.window.views().volume().picture(1);
  scan.measures().replace({{MeasureKind::Point, "p", {{0, 0, 0}}}});
  EXPECT_EQ(said(), 1);
  EXPECT_EQ(window::count(foot(window::pictureOf(axial)), amber),
            window::count(foot(shown), amber));
  EXPECT_GT(window::count(foot(axial.picture(1)), amber), window::count(foot(before), amber) + 30);
  const QRect corner(4, space.height() - 26, 140, 24);
  EXPECT_GT(
      window::differing(scan.window.views().volume().picture(1).copy(corner), space.copy(corner)),
      0.02);
}

TEST(Marks, LabelsLeaveTheWordsOfANarrowSliceReadable) {
  MarkedScan scan;
  scan.show(ballVolume(), 50.0);
  window::showActive(scan.window);
  ui::SliceView& axial = scan.slice(Plane::Axial);
  const QRect picture = axial.pictureRect();
  ASSERT_LT(picture.width(), 290);
  const auto margin = [&] {
    QImage image = window::pictureOf(axial);
    QPainter(&image).fillRect(picture, Qt::black);
    return image;
  };
  const QImage before = margin();
  for (const double x : {-8.0, 0.0, 6.0})
    for (const double y : {-6.0, -2.0, 2.0, 6.0}) {
      scan.measures().replace(
          {{MeasureKind::Distance, "Distance 1", {{x, y, 0}, {x + 2, y - 2, 0}}}});
      EXPECT_EQ(window::differing(margin(), before, 0), 0.0) << x << ", " << y;
    }
}

TEST(Marks, BelongToTheirScanAndComeBackWithIt) {
  MarkedScan scan;
  const auto ball = ballVolume();
  scan.show(ball, 50.0, "ball", "/scans/ball.nrrd");
  window::showActive(scan.window);
  scan.measures().replace({{MeasureKind::Point, "here", {{1, 2, 3}}}});
  // the same volume again, as with another tool: they stay
  scan.controller.showScene();
  EXPECT_EQ(scan.measures().all().size(), 1U);
  scan.show(ballVolume(48), 50.0, "other", "/scans/other.nrrd");
  EXPECT_TRUE(scan.measures().all().empty());
  EXPECT_FALSE(scan.measures().canRestore());  // not over this one
  scan.show(ballVolume(), 50.0, "ball", "/scans/ball.nrrd");
  ASSERT_EQ(scan.measures().all().size(), 1U);
  EXPECT_EQ(scan.last().text, "here");
}

/// The path of a first user: the height of the left ear canal's bony opening, by clicks.
TEST(Marks, TheEarCanalIsMeasuredInSixActions) {
  const std::filesystem::path path = places::scan("philips_head_phantom/bone_1mm");
  // without the real head the made one, whose canals are cones of about 3.3 mm in radius
  const bool real = std::filesystem::exists(path);
  app::Arguments arguments = window::sphereInHand("mouse");
  arguments.load = {};
  if (real)
    arguments.load.path = path;
  else
    arguments.load.phantom = "demo";
  app::Application application(arguments);
  application.start();
  ASSERT_TRUE(waitFor([&] { return application.shown().has_value(); }));
  ui::MainWindow& window = application.window();
  window.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window, 120'000));
  ui::Measures& measures = application.marks().measures();
  // where the walls of the canal are, along a line from front to back: at the half between bone and
  // air, in the touched field
  const Eigen::Vector3d start =
      real ? Eigen::Vector3d{42.41, 109.7, 719.21} : Eigen::Vector3d{54.0, 16.5, -16.5};
  const auto wall = [&](double way) {
    Eigen::Vector3d p = start;
    while (measures.scan().value(p) < 300.0) p.y() += way;
    return p;
  };
  const Eigen::Vector3d front = wall(-0.01), back = wall(0.01);
  ASSERT_NEAR((back - front).norm(), real ? 6.9 : 6.6, real ? 0.3 : 0.5);
  QElapsedTimer clock;
  clock.start();
  int actions = 0;
  ui::SliceView& coronal = window.views().slice(Plane::Coronal);
  ui::SliceView& axial = window.views().slice(Plane::Axial);
  click(coronal, coronal.projected(start));
  ++actions;
  EXPECT_NEAR(window.views().cross_mm().z(), start.z(), 0.6);
  // near enough that a pixel is less than a voxel: the axial slice alone, and the wheel at the ear
  axial.setFocus();
  QTest::keyClick(&axial, Qt::Key_F);
  ++actions;
  QTest::qWait(50);
  const QPointF ear = axial.projected(start);
  QWheelEvent wheel(ear, axial.mapToGlobal(ear), {}, {0, 6 * 120}, {}, Qt::ControlModifier,
                    Qt::NoScrollPhase, false);
  QCoreApplication::sendEvent(&axial, &wheel);
  ++actions;
  QTest::keyClick(&axial, Qt::Key_D);
  ++actions;
  click(axial, axial.projected(front));
  ++actions;
  click(axial, axial.projected(back));
  ++actions;
  ASSERT_EQ(measures.all().size(), 1U);
  const QString value = ui::valueOf(measures.all()[0], measures.scan());
  const auto reading = readingOf(value);
  ASSERT_TRUE(reading);
  // a click is a whole pixel of the picture
  const double pixel_mm =
      10.0 / (axial.projected(start + Eigen::Vector3d{10, 0, 0}).x() - axial.projected(start).x());
  EXPECT_LE(std::abs(reading->number - (back - front).norm()), reading->accuracy + pixel_mm);
  EXPECT_LT(pixel_mm, 0.45);
  EXPECT_EQ(actions, 6);
  std::printf("ear canal: %s in %d actions, %lld ms; true %.2f mm, a pixel is %.2f mm\n",
              value.toUtf8().constData(), actions, static_cast<long long>(clock.elapsed()),
              (back - front).norm(), pixel_mm);
  window::pictureAtRest(window.views().volume());
  window::keep(window::pictureOf(window), "marks_ear_canal");
}

}  // namespace
