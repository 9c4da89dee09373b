// SPDX-License-Identifier: BSD-3-Clause
#include "ui/views/slice_view.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QContextMenuEvent>
#include <QLocale>
#include <QPaintEvent>
#include <QPainter>
#include <QRegion>
#include <QTest>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "haptics/field/scalar_field.h"
#include "tests/ui/window_support.h"
#include "ui/views/slice_readout.h"

namespace {

using haptics::Mat3;
using haptics::Vec3;
using ui::Plane;

// a bright ball on the patient's left, another half as bright towards the front and the head
double marked(const Vec3& p_W) {
  return window::ball({0.018, 0.0, 0.0}, 0.006)(p_W) +
         0.5 * window::ball({0.0, -0.016, 0.014}, 0.005)(p_W);
}

struct Axes {
  const char* name;
  Mat3 direction;
};

std::vector<Axes> someAxes() {
  Mat3 permuted, left_handed, sagittal, oblique = Mat3::Identity();
  permuted << 0, 0, 1, 1, 0, 0, 0, 1, 0;
  left_handed = Vec3{1.0, 1.0, -1.0}.asDiagonal();
  sagittal << 0, 0, -1, 1, 0, 0, 0, -1, 0;  // right-handed, as a sagittal series lies
  oblique = Eigen::AngleAxisd(0.5, Vec3{1.0, 2.0, 0.5}.normalized()).toRotationMatrix() *
            Vec3{-1.0, 1.0, 1.0}.asDiagonal();
  return {{"identity", Mat3::Identity()},
          {"permuted", permuted},
          {"left-handed", left_handed},
          {"sagittal", sagittal},
          {"oblique and left-handed", oblique}};
}

ui::Picture marker(const Mat3& direction, bool orientation_known = true) {
  return ui::pictureOf(window::volumeOf(window::cubeGrid(64, direction), haptics::ScalarType::Int16,
                                        marked, {.orientation_known = orientation_known}));
}

bool bright(QColor c) { return c.saturation() < 20 && c.red() > 200; }
bool letter(QColor c) {
  return c.red() > 170 && c.green() > 0.8 * c.red() && c.blue() < 0.3 * c.green();
}

TEST(SliceView, ShowsTheLeftMarkerUnderTheLetterLWhicheverWayTheVoxelsLie) {
  for (const Axes& axes : someAxes()) {
    SCOPED_TRACE(axes.name);
    const ui::Picture picture = marker(axes.direction);
    for (const Plane plane : {Plane::Axial, Plane::Coronal}) {
      ui::SliceView view(plane);
      view.show(picture);
      view.setGrey({.level = 50.0, .width = 100.0});
      view.setCross(Eigen::Vector3d::Zero());
      window::showAndWait(view, {300, 300});
      const QImage image = window::pictureOf(view);
      window::keep(image, "slice_marker");
      const QPointF at = window::centroid(image, bright);
      const QPointF expected = view.projected({18.0, 0.0, 0.0});
      EXPECT_NEAR(at.x(), expected.x(), 3.0);  // px; the crosshair cuts the ball's symmetry
      EXPECT_NEAR(at.y(), expected.y(), 3.0);
      EXPECT_GT(at.x(), 170.0);  // the radiological convention: left is on the right
      EXPECT_EQ(ui::lettersOf(view.axes())[1], "L");
      // and an L is painted on that edge, beside the picture
      EXPECT_GT(window::count(image.copy(280, 130, 20, 40), letter), 10);
    }
    // front and head: the fainter ball, on the sagittal picture
    ui::SliceView view(Plane::Sagittal);
    view.show(picture);
    view.setGrey({.level = 25.0, .width = 50.0});
    view.setCross({0.0, 0.0, 0.0});
    window::showAndWait(view, {300, 300});
    const QPointF at = window::centroid(window::pictureOf(view), bright);
    EXPECT_LT(at.x(), 130.0);  // front on the left
    EXPECT_LT(at.y(), 130.0);  // head up
    EXPECT_EQ(ui::lettersOf(view.axes())[0], "A");
    EXPECT_EQ(ui::lettersOf(view.axes())[2], "S");
  }
}

TEST(SliceView, SaysThatLeftAndRightAreUnknownWhereTheFileDoesNotGiveTheOrientation) {
  ui::SliceView view(Plane::Axial);
  view.show(marker(Mat3::Identity(), false));
  view.setGrey({.level = 50.0, .width = 100.0});
  window::showAndWait(view, {300, 300});
  const QImage image = window::pictureOf(view);
  window::keep(image, "slice_unknown");
  EXPECT_EQ(window::count(image, letter), 0);
  EXPECT_FALSE(view.readout().sides_known);
  // in words, on the margin above the picture
  const auto amber = [](QColor c) { return c.red() > 150 && c.blue() < 0.5 * c.green(); };
  EXPECT_GT(window::count(image.copy(0, 0, 300, view.pictureRect().top()), amber), 40);
  EXPECT_TRUE(view.readout().place.contains("z "));  // no letter in the position either
}

TEST(SliceView, PutsNoLetterOnTheAnatomyInObliqueSlicesEither) {
  const auto white = ui::pictureOf(
      window::volumeOf(window::cubeGrid(64), haptics::ScalarType::Int16,
                       [](const Vec3& p) { return p.norm() < 1e-3 ? 0.0 : 100.0; }, {}));
  ui::SliceView axial(Plane::Axial), oblique(Plane::Oblique);
  for (ui::SliceView* view : {&axial, &oblique}) {
    view->show(white);
    view->setGrey({.level = 50.0, .width = 100.0});
    window::showAndWait(*view, {300, 300});
  }
  const Vec3 right = Vec3{1.0, -1.0, 0.0}.normalized(), up = Vec3::UnitZ();
  oblique.setPlane({right, up, up.cross(right)}, Vec3::Zero(), "Down the tool", "at its tip");
  for (ui::SliceView* view : {&axial, &oblique}) {
    view->zoom(3.0, {150.0, 150.0});  // anatomy fills the picture
    const QImage image = window::pictureOf(*view);
    window::keep(image, view == &axial ? "slice_letters" : "slice_letters_oblique");
    const QRect picture = view->pictureRect();
    EXPECT_EQ(window::count(image.copy(picture), letter), 0);
    EXPECT_GT(window::count(image, letter), 80);
    EXPECT_EQ(window::count(image.copy(0, 0, picture.left(), 300), bright), 0);
  }
  EXPECT_EQ(oblique.readout().letters, (std::array<QString, 4>{"RP", "LA", "S", "I"}));
}

TEST(SliceView, MovesTheCrosshairToAClickAndThroughTheSlicesWithTheWheel) {
  ui::SliceView view(Plane::Coronal);
  view.show(marker(Mat3::Identity()));
  view.setCross({0.0, 5.0, 0.0});
  window::showAndWait(view, {300, 300});
  Eigen::Vector3d cross = Eigen::Vector3d::Zero();
  QObject::connect(&view, &ui::SliceView::crossMoved, [&](const Eigen::Vector3d& p) { cross = p; });
  const Eigen::Vector3d wanted{10.0, 5.0, -12.0};
  QTest::mouseClick(&view, Qt::LeftButton, {}, view.projected(wanted).toPoint());
  EXPECT_LT((cross - wanted).norm(), 0.3);  // mm: a pixel is 0.23

  view.setCross(wanted);
  QWheelEvent wheel({150, 150}, view.mapToGlobal(QPointF{150, 150}), {}, {0, 240}, {}, {},
                    Qt::NoScrollPhase, false);
  QCoreApplication::sendEvent(&view, &wheel);
  EXPECT_NEAR(cross.y(), 7.0, 1e-9);  // two notches of 1 mm
}

void wheel(QWidget& view, QPointF at, int delta, Qt::KeyboardModifiers held = {}) {
  QWheelEvent event(at, view.mapToGlobal(at), {}, {0, delta}, {}, held, Qt::NoScrollPhase, false);
  QCoreApplication::sendEvent(&view, &event);
}

void hover(QWidget& view, QPointF at) {
  QMouseEvent move(QEvent::MouseMove, at, view.mapToGlobal(at), Qt::NoButton, Qt::NoButton, {});
  QCoreApplication::sendEvent(&view, &move);
}

void drag(QWidget& view, Qt::MouseButton button, QPoint from, QPoint to,
          Qt::KeyboardModifiers held = {}) {
  QTest::mousePress(&view, button, held, from);
  for (const QPoint at : {(from + to) / 2, to}) {
    QMouseEvent move(QEvent::MouseMove, at, view.mapToGlobal(QPointF(at)), Qt::NoButton, button,
                     held);
    QCoreApplication::sendEvent(&view, &move);
  }
  QTest::mouseRelease(&view, button, held, to);
}

/// A view of the marker whose wishes for the crosshair are fulfilled.
struct ShownSlice {
  explicit ShownSlice(Plane plane = Plane::Axial) : view(plane) {
    QObject::connect(&view, &ui::SliceView::crossMoved, &view, &ui::SliceView::setCross);
    QObject::connect(&view, &ui::SliceView::greyChanged, &view, [this](const ui::GreyWindow& g) {
      grey = g;
      view.setGrey(g);
    });
    view.show(marker(Mat3::Identity()));
    view.setGrey(grey);
    view.setCross({0.5, 0.5, 0.5});
    window::showAndWait(view, {320, 300});
  }
  ui::SliceView view;
  ui::GreyWindow grey{.level = 50.0, .width = 100.0};
};

TEST(SliceView, ZoomsAtThePointerByWheelAndKeys) {
  ShownSlice s;
  const QPointF at{220.0, 90.0};
  const Vec3 under = s.view.placeUnder(at);
  const double whole = s.view.mmPerPixel();
  wheel(s.view, at, 360, Qt::ControlModifier);
  EXPECT_NEAR(s.view.mmPerPixel(), whole / std::pow(1.2, 3), 1e-9);
  EXPECT_LT((s.view.placeUnder(at) - under).norm(), 1e-9);  // mm
  hover(s.view, at);
  QTest::keyClick(&s.view, Qt::Key_Plus);
  EXPECT_NEAR(s.view.mmPerPixel(), whole / std::pow(1.2, 4), 1e-9);
  EXPECT_LT((s.view.placeUnder(at) - under).norm(), 1e-6);
  QTest::keyClick(&s.view, Qt::Key_Minus);
  EXPECT_NEAR(s.view.mmPerPixel(), whole / std::pow(1.2, 3), 1e-9);
  EXPECT_LT((s.view.placeUnder(at) - under).norm(), 1e-6);
  // the picture is nearer too: the ball is larger
  const int before = window::count(window::pictureOf(s.view), bright);
  wheel(s.view, s.view.projected({18.0, 0.0, 0.5}), 240, Qt::ControlModifier);
  EXPECT_GT(window::count(window::pictureOf(s.view), bright), 1.5 * before);
  QTest::keyClick(&s.view, Qt::Key_R);
  EXPECT_NEAR(s.view.mmPerPixel(), whole, 1e-12);
  // never so near or far that nothing is seen
  for (int n = 0; n < 80; ++n) wheel(s.view, at, 120, Qt::ControlModifier);
  EXPECT_GT(s.view.mmPerPixel(), 0.01);
  for (int n = 0; n < 200; ++n) wheel(s.view, at, -120, Qt::ControlModifier);
  EXPECT_LT(s.view.mmPerPixel(), 5.0 * whole);
}

TEST(SliceView, ShiftsByMiddleDragShiftAndLeftDragAndKeys) {
  for (const auto& [button, held] : {std::pair{Qt::MiddleButton, Qt::KeyboardModifiers{}},
                                     {Qt::LeftButton, Qt::ShiftModifier}}) {
    ShownSlice s;
    const Vec3 under = s.view.placeUnder({150.0, 150.0});
    drag(s.view, button, {150, 150}, {190, 120}, held);
    EXPECT_LT((s.view.placeUnder({190.0, 120.0}) - under).norm(), 1e-9);
  }
  ShownSlice s;
  const Vec3 under = s.view.placeUnder({150.0, 150.0});
  QTest::keyClick(&s.view, Qt::Key_Right, Qt::ShiftModifier);
  EXPECT_GT((s.view.placeUnder({150.0, 150.0}) - under).x(), 1.0);
}

TEST(SliceView, GoesThroughTheSlicesByKeysAndSaysWhichItShows) {
  ShownSlice s;
  EXPECT_TRUE(s.view.readout().place.startsWith("33 / 64")) << qPrintable(s.view.readout().place);
  EXPECT_TRUE(s.view.readout().place.contains("z 0.5 mm"));
  const auto number = [&] { return s.view.readout().place.section(' ', 0, 0).toInt(); };
  QTest::keyClick(&s.view, Qt::Key_Up);
  EXPECT_EQ(number(), 34);
  QTest::keyClick(&s.view, Qt::Key_Down);
  QTest::keyClick(&s.view, Qt::Key_Down);
  EXPECT_EQ(number(), 32);
  EXPECT_TRUE(s.view.readout().place.contains("z -0.5 mm"));
  QTest::keyClick(&s.view, Qt::Key_PageUp);
  EXPECT_EQ(number(), 42);
  QTest::keyClick(&s.view, Qt::Key_PageDown);
  EXPECT_EQ(number(), 32);
  QTest::keyClick(&s.view, Qt::Key_Home);
  EXPECT_EQ(number(), 1);
  QTest::keyClick(&s.view, Qt::Key_Down);
  EXPECT_EQ(number(), 1);
  QTest::keyClick(&s.view, Qt::Key_End);
  EXPECT_EQ(number(), 64);
  wheel(s.view, {150.0, 150.0}, -60);  // half a notch, and the other half
  EXPECT_EQ(number(), 64);
  wheel(s.view, {150.0, 150.0}, -60);
  EXPECT_EQ(number(), 63);
}

TEST(SliceView, MovesTheCrosshairByAVoxelWithAltAndArrows) {
  ShownSlice s(Plane::Coronal);
  Vec3 cross{0.5, 0.5, 0.5};
  QObject::connect(&s.view, &ui::SliceView::crossMoved, [&](const Vec3& p) { cross = p; });
  const std::pair<Qt::Key, Vec3> ways[] = {{Qt::Key_Up, Vec3::UnitZ()},
                                           {Qt::Key_Down, -Vec3::UnitZ()},
                                           {Qt::Key_Right, Vec3::UnitX()},
                                           {Qt::Key_Left, -Vec3::UnitX()}};
  for (const auto& [key, way] : ways) {
    const Vec3 before = cross;
    QTest::keyClick(&s.view, key, Qt::AltModifier);
    EXPECT_LT((cross - before - way).norm(), 1e-9) << key;  // mm
  }
}

TEST(SliceView, CountsTheSlicesOfItsOwnAxisWhateverTheirDistance) {
  haptics::Grid grid;
  grid.dims = {40, 50, 20};
  grid.spacing = Vec3{0.5e-3, 0.8e-3, 2e-3};
  const auto picture = ui::pictureOf(
      window::volumeOf(grid, haptics::ScalarType::Int16, [](const Vec3&) { return 0.0; }));
  const struct {
    Plane plane;
    const char *here, *next;
  } planes[] = {{Plane::Axial, "8 / 20   z 14.0 mm", "9 / 20   z 16.0 mm"},
                {Plane::Coronal, "21 / 50   y 16.0 mm", "22 / 50   y 16.8 mm"},
                {Plane::Sagittal, "11 / 40   x 5.0 mm", "12 / 40   x 5.5 mm"}};
  for (const auto& [plane, here, next] : planes) {
    ui::SliceView view(plane);
    QObject::connect(&view, &ui::SliceView::crossMoved, &view, &ui::SliceView::setCross);
    view.show(picture);
    view.setCross(Vec3{10 * 0.5, 20 * 0.8, 7 * 2.0});
    EXPECT_EQ(view.readout().place, here);
    QTest::keyClick(&view, Qt::Key_Up);
    EXPECT_EQ(view.readout().place, next);
  }
}

TEST(SliceView, ChangesWindowAndLevelByRightDragAndKeysAndOpensChoicesOnlyByAClick) {
  ShownSlice s;
  int menus = 0;
  QObject::connect(&s.view, &ui::SliceView::menuWanted, [&] { ++menus; });
  drag(s.view, Qt::RightButton, {150, 150}, {200, 100});
  EXPECT_NEAR(s.grey.width, 100.0 * std::exp(0.5), 1e-6);
  EXPECT_GT(s.grey.level, 55.0);
  EXPECT_EQ(menus, 0);
  EXPECT_TRUE(s.view.readout().grey.startsWith("W 165  L "));
  const ui::GreyWindow dragged = s.grey;
  QTest::keyClick(&s.view, Qt::Key_Right, Qt::ControlModifier);
  EXPECT_GT(s.grey.width, dragged.width);
  QTest::keyClick(&s.view, Qt::Key_Down, Qt::ControlModifier);
  EXPECT_LT(s.grey.level, dragged.level);
  QTest::mouseClick(&s.view, Qt::RightButton, {}, {150, 150});
  EXPECT_EQ(menus, 1);
  // a hand that trembles clicks too, and changes nothing
  const ui::GreyWindow before = s.grey;
  drag(s.view, Qt::RightButton, {150, 150}, {152, 149});
  EXPECT_EQ(menus, 2);
  EXPECT_EQ(s.grey.width, before.width);
  EXPECT_EQ(s.grey.level, before.level);
  QContextMenuEvent key(QContextMenuEvent::Keyboard, {10, 10}, s.view.mapToGlobal(QPoint{10, 10}));
  QCoreApplication::sendEvent(&s.view, &key);
  EXPECT_EQ(menus, 3);
}

TEST(SliceView, SaysTheValueUnderThePointerWithUnitAndPlace) {
  ui::SliceView view(Plane::Axial);
  view.show(ui::pictureOf(window::volumeOf(
      window::cubeGrid(64), haptics::ScalarType::Int16,
      [](const Vec3& p) { return 1e3 * (3.0 * p.x() + 7.0 * p.y()) - 20.0; }, {.unit = "HU"})));
  view.setCross({0.5, 0.5, 0.5});
  window::showAndWait(view, {500, 500});
  const Vec3 at{-10.5, 12.5, 0.5};
  hover(view, view.projected(at).toPoint());
  const Vec3 seen = view.placeUnder(view.projected(at).toPoint());
  const double value = view.readout().value.section(' ', 0, 0).toDouble();
  EXPECT_NEAR(value, 3.0 * seen.x() + 7.0 * seen.y() - 20.0, 1.6);  // half a pixel, and rounding
  EXPECT_TRUE(view.readout().value.endsWith(" HU"));
  EXPECT_TRUE(view.readout().position.startsWith("LPS -10.") ||
              view.readout().position.startsWith("LPS -11.0"))
      << qPrintable(view.readout().position);
  EXPECT_TRUE(view.readout().position.contains(", 12."));
  EXPECT_TRUE(view.readout().position.contains(", 0.5 mm"));
  // beside the volume there is none
  hover(view, view.pictureRect().topLeft() + QPoint{2, 2});
  EXPECT_EQ(view.readout().value, "");
}

TEST(SliceView, HasARulerOfRoundLength) {
  EXPECT_EQ(ui::rulerLength_mm(73.0), 50.0);
  EXPECT_EQ(ui::rulerLength_mm(49.0), 20.0);
  EXPECT_NEAR(ui::rulerLength_mm(0.3), 0.2, 1e-12);
  ShownSlice s;
  s.view.setGrey({.level = 1000.0, .width = 1.0});  // all black but what is written
  const QImage image = window::pictureOf(s.view);
  const auto ruler = s.view.readoutLayout().ruler;
  ASSERT_TRUE(ruler);
  int longest = 0;
  const int row = qRound(ruler->y1());
  for (int y = row - 1; y <= row + 1; ++y) {
    int run = 0;
    for (int x = qRound(ruler->x1()) - 3; x <= qRound(ruler->x2()) + 3; ++x)
      run += image.pixelColor(x, y).red() > 80;
    longest = std::max(longest, run);
  }
  const double mm = ui::rulerLength_mm(ruler->length() * s.view.mmPerPixel() * 1.01);
  EXPECT_NEAR(longest * s.view.mmPerPixel(), mm, 2.5 * s.view.mmPerPixel());
}

TEST(SliceView, WritesPlaceAndValueAndTheLengthOfItsRuler) {
  ShownSlice s;
  const QPoint at = s.view.projected({18.0, 0.0, 0.5}).toPoint();
  hover(s.view, at);
  s.view.setGrey({.level = 1000.0, .width = 1.0});  // all black but what is written
  const QImage image = window::pictureOf(s.view);
  window::keep(image, "slice_words");
  const ui::SliceReadout readout = s.view.readout();
  ASSERT_EQ(readout.value, "100");
  const ui::ReadoutLayout layout = s.view.readoutLayout();
  ASSERT_TRUE(layout.ruler);
  const QString length =
      ui::rulerWords(ui::rulerLength_mm(layout.ruler->length() * s.view.mmPerPixel() * 1.01));
  for (const QString& text : {readout.place.section("   ", 0, 0), readout.value, readout.position,
                              readout.grey, length}) {
    const auto found = std::ranges::find(layout.texts, text, &ui::ReadoutText::text);
    ASSERT_NE(found, layout.texts.end()) << qPrintable(text);
    QImage expected(image.size(), QImage::Format_RGB32);
    expected.fill(Qt::black);
    QFont font = s.view.font();
    font.setPixelSize(11);
    const QRect ink = found->box;
    QPainter painter(&expected);
    painter.setFont(font);
    painter.setPen(QColor(188, 194, 204));
    painter.drawText(ink, Qt::AlignCenter, text);
    painter.end();
    const auto light = [](QColor c) { return c.green() > 120; };
    EXPECT_GT(window::count(expected.copy(ink), light), 15) << qPrintable(text);
    EXPECT_LT(window::differing(image.copy(ink), expected.copy(ink), 60), 0.01) << qPrintable(text);
  }
}

TEST(SliceView, WritesNothingOverItsPicture) {
  ShownSlice s;
  hover(s.view, s.view.projected({18.0, 0.0, 0.5}).toPoint());
  const QRect picture = s.view.pictureRect();
  const auto at = [&](double level) {
    s.view.setGrey({.level = level, .width = 1.0});
    return window::pictureOf(s.view);
  };
  const QImage on_white = at(-1000.0), on_black = at(1000.0);
  // beside the volume the picture is black in every window
  EXPECT_EQ(on_white.pixelColor(picture.topLeft()).lightness(), 0);
  for (int y = 0; y < on_white.height(); ++y)
    for (int x = 0; x < on_white.width(); ++x) {
      const bool inside = picture.contains(x, y);
      if (inside) ASSERT_TRUE(on_black.pixelColor(x, y).lightness() == 0) << x << ", " << y;
    }
  for (const ui::ReadoutText& text : s.view.readoutLayout().texts)
    EXPECT_FALSE(text.box.intersects(picture)) << qPrintable(text.text);
}

TEST(SliceView, KeepsWhatIsOnViewWhenVoxelsAreReplaced) {
  ShownSlice s;
  wheel(s.view, {200.0, 120.0}, 360, Qt::ControlModifier);
  drag(s.view, Qt::MiddleButton, {150, 150}, {170, 140});
  const double scale = s.view.mmPerPixel();
  const Vec3 under = s.view.placeUnder({100.0, 100.0});
  s.view.replace(
      ui::pictureOf(window::volumeOf(window::cubeGrid(64), haptics::ScalarType::Int16,
                                     [](const Vec3& p) { return p.norm() < 1e-3 ? 1.0 : 0.0; })));
  EXPECT_EQ(s.view.mmPerPixel(), scale);
  EXPECT_LT((s.view.placeUnder({100.0, 100.0}) - under).norm(), 1e-12);
  EXPECT_EQ(window::count(window::pictureOf(s.view), bright), 0);  // the ball is gone
}

bool contourColoured(QColor c) {
  return c.red() > 150 && c.red() > 1.6 * c.blue() && c.green() > 1.1 * c.blue() &&
         c.green() < 0.8 * c.red();
}

TEST(SliceView, DrawsTheContourOfTheFieldThatIsTouched) {
  const auto volume = window::volumeOf(window::cubeGrid(64), haptics::ScalarType::Int16,
                                       [](const Vec3& p) { return marked(p); });
  for (const auto kind : {haptics::FieldKind::Trilinear, haptics::FieldKind::CubicSpline}) {
    const haptics::ScalarField field(volume, kind);
    ui::SliceView view(Plane::Axial);
    view.show(ui::pictureOf(volume));
    view.setGrey({.level = 50.0, .width = 100.0});
    view.setCross({0.0, 0.0, 0.3});
    view.setIsovalue(50.0);
    view.setTouched({.value = [&](const Vec3& p) { return field.value(field.indexOf(p)); }});
    window::showAndWait(view, {400, 400});
    const auto within = [&](double isovalue) {
      const auto pieces = view.contour_W_mm();
      EXPECT_GT(pieces.size(), 20U);
      for (const auto& [a, b] : pieces)
        for (const double t : {0.0, 0.3, 0.5, 0.8}) {
          const auto sample = field.sample(field.indexOf((a + t * (b - a)) * 1e-3));
          EXPECT_LT(std::abs(sample.value - isovalue) / sample.gradient_W.norm(), 0.1e-3);  // m
        }
    };
    window::rest(view);
    const QImage at_50 = window::pictureOf(view);
    within(50.0);
    window::keep(at_50, "slice_contour");
    EXPECT_GT(window::count(at_50, contourColoured), 60);
    // another isovalue, another slice, nearer: the contour follows
    view.setIsovalue(80.0);
    window::rest(view);
    EXPECT_GT(window::differing(at_50, window::pictureOf(view)), 0.0005);
    within(80.0);
    view.setCross({0.0, 0.0, 3.4});
    view.zoom(4.0, view.projected({18.0, 0.0, 3.4}));
    window::rest(view);
    window::keep(window::pictureOf(view), "slice_contour_near");
    within(80.0);
    for (const auto& [a, b] : view.contour_W_mm()) EXPECT_NEAR(a.z(), 3.4, 1e-9);
    view.setContourShown(false);
    EXPECT_EQ(window::count(window::pictureOf(view), contourColoured), 0);
  }
}

TEST(SliceView, DrawsProxyAndDeviceWhereTheirMeshesMeetThePlane) {
  ShownSlice s;
  s.view.setMesh(std::make_shared<const haptics::TriangleMesh>(window::octahedron(0.008)));
  haptics::Pose proxy = haptics::Pose::Identity(), device = proxy;
  proxy.translation() = Vec3{-0.010, 0.0, 0.0};
  device.translation() = Vec3{-0.010, 0.012, 0.0};
  s.view.setTool(proxy, device);
  const QImage image = window::pictureOf(s.view);
  window::keep(image, "slice_tool");
  // the outlines are squares, 0.5 mm above the octahedra's middles: corners 7.5 mm away
  const auto covered = [&](const Vec3& middle_mm) {
    int seen = 0, all = 0;
    for (int corner = 0; corner < 4; ++corner)
      for (double t = 0.05; t < 0.95; t += 0.01) {
        const double a = 0.5 * M_PI * corner, b = a + 0.5 * M_PI;
        const Vec3 p = middle_mm + 7.5 * ((1.0 - t) * Vec3{std::cos(a), std::sin(a), 0.0} +
                                          t * Vec3{std::cos(b), std::sin(b), 0.0});
        const QPointF at = s.view.projected(p);
        ++all;
        seen += image.pixelColor(static_cast<int>(at.x()), static_cast<int>(at.y())).value() > 90;
      }
    return double(seen) / all;
  };
  EXPECT_GT(covered({-10.0, 0.0, 0.5}), 0.95);  // solid
  EXPECT_GT(covered({-10.0, 12.0, 0.5}), 0.4);  // dashed
  EXPECT_LT(covered({-10.0, 12.0, 0.5}), 0.9);
  EXPECT_GT(window::count(image, window::proxyColoured), 80);
  EXPECT_GT(window::count(image, window::deviceColoured), 30);
  // 0.5 mm above its middle: corners 7.5 mm from the axis
  int least = 1000, most = 0;
  for (int x = 0; x < image.width(); ++x)
    for (int y = 0; y < image.height(); ++y)
      if (window::proxyColoured(image.pixelColor(x, y))) {
        least = std::min(least, x);
        most = std::max(most, x);
      }
  EXPECT_NEAR((most - least) * s.view.mmPerPixel(), 15.0, 3.0 * s.view.mmPerPixel());
  // apart from the plane: a ring where the tip is
  s.view.setCross({0.5, 0.5, 20.5});
  const QImage ring = window::pictureOf(s.view);
  EXPECT_LT(
      QLineF(window::centroid(ring, window::proxyColoured), s.view.projected({-10.0, 0.0, 20.5}))
          .length(),
      2.0);
}

/// Counts paints of one widget.
class PaintsOf : public QObject {
 public:
  explicit PaintsOf(QWidget& widget) { widget.installEventFilter(this); }
  int count = 0;
  QRegion region;  ///< of the last

 protected:
  bool eventFilter(QObject*, QEvent* event) override {
    if (event->type() != QEvent::Paint) return false;
    ++count;
    region = static_cast<QPaintEvent*>(event)->region();
    return false;
  }
};

TEST(SliceView, IsDrawnAgainOnlyIfTheToolMovedVisibly) {
  ShownSlice s;
  s.view.setMesh(std::make_shared<const haptics::TriangleMesh>(window::octahedron(0.008)));
  haptics::Pose pose = haptics::Pose::Identity();
  s.view.setTool(pose, pose);
  window::rest(s.view);
  QTest::qWait(100);
  PaintsOf paints(s.view);
  const double still = 0.05e-3 * s.view.mmPerPixel();  // m: a twentieth of a pixel
  for (int n = 0; n < 20; ++n) {
    pose.translation().x() = n % 2 == 0 ? still : -still;
    s.view.setTool(pose, pose);
    QTest::qWait(10);
  }
  EXPECT_EQ(paints.count, 0);
  pose.translation().x() = 1e-3 * s.view.mmPerPixel();
  s.view.setTool(pose, pose);
  EXPECT_TRUE(window::waitFor([&] { return paints.count > 0; }));
  QTest::qWait(50);
  EXPECT_EQ(paints.count, 1);
}

TEST(SliceView, IsDrawnAgainOnlyWhereTheToolWasAndIs) {
  ShownSlice s;
  s.view.setMesh(std::make_shared<const haptics::TriangleMesh>(window::octahedron(0.004)));
  haptics::Pose proxy = haptics::Pose::Identity(), device = proxy;
  s.view.setTool(proxy, device);
  window::rest(s.view);
  QImage before = window::pictureOf(s.view);
  int compared = 0;
  // in the plane, apart from the device, and off the plane, where a ring stands for the tool
  for (const auto& [to, pulled_to] : {std::pair{Vec3{0.006, 0.004, 0}, Vec3{0.006, 0.004, 0}},
                                      {{-0.006, 0, 0}, {-0.012, 0, 0}},
                                      {{-0.004, 0.010, 0}, {-0.004, 0.010, 0}},
                                      {{-0.004, 0.010, 0.010}, {0.010, 0.010, 0.010}}}) {
    proxy.translation() = to;
    device.translation() = pulled_to;
    PaintsOf paints(s.view);
    s.view.setTool(proxy, device);
    ASSERT_TRUE(window::waitFor([&] { return paints.count > 0; }));
    QTest::qWait(20);
    ASSERT_EQ(paints.count, 1);
    const QRegion painted = paints.region;
    const QImage after = window::pictureOf(s.view);
    for (int y = 0; y < after.height(); ++y)
      for (int x = 0; x < after.width(); ++x) {
        if (after.pixel(x, y) == before.pixel(x, y)) continue;
        ++compared;
        ASSERT_TRUE(painted.contains(QPoint{x, y})) << x << ", " << y;
      }
    const QRect box = painted.boundingRect();
    EXPECT_LT(box.width() * box.height(), s.view.width() * s.view.height() / 2);
    before = after;
  }
  EXPECT_GT(compared, 500);
}

TEST(SliceView, DrawsTheLinesOfOtherPlanesInTheirColours) {
  ShownSlice s;
  s.view.setGrey({.level = 1000.0, .width = 1.0});
  s.view.setCross({5.5, -8.5, 0.5});
  s.view.setCrossedPlanes(
      {{.colour = QColor(0, 0, 255), .through_W_mm = {5.5, -8.5, 0.5}, .normal_W = Vec3::UnitX()},
       {.colour = QColor(255, 0, 255),
        .through_W_mm = {0.0, 0.0, 0.0},
        .normal_W = Vec3{1.0, 1.0, 0.0}.normalized()}});
  const QImage image = window::pictureOf(s.view);
  const auto blue = [](QColor c) { return c.blue() > 80 && c.red() < 40; };
  const QPointF at = s.view.projected({5.5, -8.5, 0.5});
  int beside = 0, along = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x)
      if (blue(image.pixelColor(x, y))) ++(std::abs(x + 0.5 - at.x()) < 1.6 ? along : beside);
  EXPECT_GT(along, 150);
  EXPECT_EQ(beside, 0);
  // x + y = 0 in LPS, which the picture shows from its lower left to its upper right, mirrored
  const auto violet = [](QColor c) { return c.blue() > 80 && c.red() > 80 && c.green() < 40; };
  EXPECT_GT(window::count(image, violet), 150);
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x)
      if (violet(image.pixelColor(x, y))) {
        const Vec3 p = s.view.placeUnder({x + 0.5, y + 0.5});
        ASSERT_NEAR((p.x() + p.y()) / std::sqrt(2.0), 0.0, 1.2 * s.view.mmPerPixel());
      }
}

TEST(SliceView, LooksForACrosshairThatWasMovedElsewhere) {
  ShownSlice s;
  s.view.zoom(6.0, s.view.projected({-15.0, 10.0, 0.5}));
  s.view.setCross({20.5, -15.5, 3.5});
  EXPECT_TRUE(QRectF(s.view.pictureRect()).contains(s.view.projected({20.5, -15.5, 3.5})));
}

TEST(SliceView, AFittedPictureStaysWhileTheCrosshairIsInItAndGivesWayNoFartherThanItMust) {
  ShownSlice s;
  s.view.fitBody();
  const auto corner = [&] { return s.view.placeUnder(s.view.pictureRect().topLeft()); };
  const QRectF room = s.view.pictureRect();
  const Vec3 fitted = corner();
  const double px = s.view.mmPerPixel();
  s.view.setCross(s.view.placeUnder(room.center() + QPointF{0.45 * room.width(), 0.0}));
  EXPECT_LT((corner() - fitted).norm(), 1e-9);
  // 40 px out of the picture, as a tool beside the body
  const Vec3 beside = s.view.placeUnder({room.right() + 40.0, room.center().y()});
  s.view.setCross(beside);
  EXPECT_TRUE(room.contains(s.view.projected(beside)));
  EXPECT_LT((corner() - fitted).norm(), 60.0 * px);
  s.view.setCross(s.view.placeUnder(room.center()));
  EXPECT_LT((corner() - fitted).norm(), 1e-9);
}

TEST(SliceView, TheMarkOfAToolOffThePlaneIsDashedAndNotDrawnFarFromIt) {
  ShownSlice s;
  s.view.setMesh(std::make_shared<const haptics::TriangleMesh>(window::octahedron(0.004)));
  const auto shown = [&](double off) {
    haptics::Pose pose = haptics::Pose::Identity();
    pose.translation() = Vec3{0.020, 0.020, off};
    s.view.setTool(pose, pose);
    window::rest(s.view);
    return window::pictureOf(s.view);
  };
  const QImage none = shown(0.200), near = shown(0.010);
  EXPECT_EQ(shown(0.045), none);
  // along the ring there is ink, and there are gaps
  const QPointF tip = s.view.projected({20.0, 20.0, 0.0});
  int inked = 0, bare = 0;
  for (int n = 0; n < 72; ++n) {
    const double turn = n * 3.14159265 / 36.0;
    int most = 0;
    for (const double radius : {3.0, 3.5, 4.0, 4.5, 5.0}) {
      const QPoint at((tip + radius * QPointF{std::cos(turn), std::sin(turn)}).toPoint());
      most = std::max(most, std::abs(qGray(near.pixel(at)) - qGray(none.pixel(at))));
    }
    ++(most > 60 ? inked : most < 50 ? bare : inked);
  }
  EXPECT_GT(inked, 15);
  EXPECT_GT(bare, 3);
}

TEST(SliceView, WordsGiveWayToTheNumberOfASlice) {
  const ui::SliceReadout said{.name = "Koronalschnitt",
                              .short_name = "Kor.",
                              .place = "214 / 512   y 177.2 mm",
                              .letters = {"R", "L", "S", "I"}};
  for (const int width : {150, 180, 220, 300, 420}) {
    const QRect widget(0, 0, width, 200);
    const auto layout =
        ui::layOut(said, QApplication::font(), widget, ui::pictureIn(widget, false), 40, 0.5);
    const auto has = [&](const char* text) {
      return std::ranges::any_of(layout.texts, [&](const auto& one) { return one.text == text; });
    };
    EXPECT_TRUE(has("214 / 512")) << width;
    EXPECT_TRUE(has("Kor.") || has("Koronalschnitt")) << width;
  }
}

TEST(SliceView, APlaceIsThreeNumbersWithTheirFrameSaidOnce) {
  EXPECT_EQ(ui::positionWords({177.2, -169.3, 1610.8}, true), "LPS 177.2, -169.3, 1610.8 mm");
  EXPECT_EQ(ui::positionWords({177.2, -169.3, 1610.8}, false), "scan 177.2, -169.3, 1610.8 mm");
  QLocale::setDefault(QLocale(QLocale::German));
  EXPECT_EQ(ui::positionWords({177.2, -169.3, 1610.8}, true), "LPS 177,2; -169,3; 1610,8 mm");
}

}  // namespace
