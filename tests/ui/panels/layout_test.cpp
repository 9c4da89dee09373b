// SPDX-License-Identifier: BSD-3-Clause
// How the views share the window.
#include <gtest/gtest.h>

#include <vtkCamera.h>

#include <QAction>
#include <QApplication>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QMouseEvent>
#include <QSettings>
#include <QTest>
#include <QToolButton>
#include <QWheelEvent>
#include <algorithm>
#include <stdexcept>
#include <vector>

#include "app/window/program/preferences.h"
#include "tests/ui/panelled_window.h"
#include "tests/ui/window_support.h"
#include "ui/panels/edit_panel.h"
#include "ui/views/volume_view.h"
#include "ui/window/main_window.h"
#include "ui/window/view_frame.h"
#include "ui/window/view_layout.h"
#include "ui/window/views.h"

namespace {

using haptics::Vec3;
using ui::Arrangement;
using ui::Plane;

ui::Picture ballPicture() {
  return ui::pictureOf(window::volumeOf(window::cubeGrid(48), haptics::ScalarType::Int16,
                                        window::ball(Vec3::Zero(), 0.015)));
}

/// A window with a volume.
struct Window {
  Window() {
    window.views().volume().setSurfaceWish(ui::SurfaceMode::Mesh);
    panelled.show(ballPicture(), 50.0, "Ball");
    window::showAndWait(window, {1240, 860});
    window.activateWindow();
    EXPECT_TRUE(QTest::qWaitForWindowActive(&window, 120'000));
  }
  void choose(const char* action) {
    auto* found = window.findChild<QAction*>(action);
    ASSERT_NE(found, nullptr) << action;
    found->trigger();
    QTest::qWait(50);
  }
  QRect placeOf(QWidget& view) {
    return view.isVisible() ? QRect(view.mapTo(&window.views().layout(), QPoint{}), view.size())
                            : QRect();
  }
  QRect volume() { return placeOf(window.views().volume()); }
  QRect slice(Plane plane) { return placeOf(window.views().slice(plane)); }
  /// No view over another, and all in the room there is.
  void expectApart() {
    std::vector<QRect> rects{volume()};
    for (const Plane plane : {Plane::Axial, Plane::Coronal, Plane::Sagittal, Plane::Oblique})
      rects.push_back(slice(plane));
    for (std::size_t a = 0; a < rects.size(); ++a) {
      EXPECT_TRUE(rects[a].isNull() || window.views().layout().rect().contains(rects[a]));
      for (std::size_t b = a + 1; b < rects.size(); ++b)
        EXPECT_FALSE(rects[a].intersects(rects[b])) << a << " and " << b;
    }
  }
  window::Panelled panelled;
  ui::MainWindow& window = panelled.window;
};

double areaOf(QRect rect) { return double(rect.width()) * rect.height(); }

TEST(Layout, HasOneTwoByTwoVolumeLargeAndSlicesLarge) {
  Window w;
  EXPECT_EQ(w.window.views().layout().arrangement(), Arrangement::VolumeLarge);
  w.expectApart();
  EXPECT_GT(areaOf(w.volume()), 4.0 * areaOf(w.slice(Plane::Axial)));
  window::keep(window::pictureOf(w.window), "layout_volume_large");

  w.choose("four_up");
  w.expectApart();
  for (const Plane plane : {Plane::Axial, Plane::Coronal, Plane::Sagittal})
    EXPECT_NEAR(areaOf(w.slice(plane)) / areaOf(w.volume()), 1.0, 0.05);
  window::keep(window::pictureOf(w.window), "layout_four_up");

  w.choose("slices_large");
  w.expectApart();
  EXPECT_GT(areaOf(w.slice(Plane::Axial)), 1.4 * areaOf(w.volume()));
  EXPECT_GT(w.slice(Plane::Coronal).width(), 1.3 * w.volume().width());
  window::keep(window::pictureOf(w.window), "layout_slices_large");

  w.choose("one");
  EXPECT_TRUE(w.volume().isValid());
  EXPECT_FALSE(w.slice(Plane::Axial).isValid());
  EXPECT_EQ(areaOf(w.volume()) > 0.95 * areaOf(w.window.views().layout().rect()), true);
  EXPECT_TRUE(w.window.findChild<QAction*>("one")->isChecked());
  EXPECT_FALSE(w.window.findChild<QAction*>("slices_large")->isChecked());
  // and the 3-D view draws as before: it was never taken apart
  w.choose("volume_large");
  EXPECT_GT(
      window::count(window::pictureAtRest(w.window.views().volume()), window::surfaceColoured),
      2'000);
}

TEST(Layout, ShowsAViewAloneByItsButtonAndByKeyFAndGivesTheOthersBack) {
  Window w;
  const QRect before = w.slice(Plane::Coronal);
  auto* frame = w.window.views().slice(Plane::Coronal).parentWidget();
  auto* button = frame->findChild<QToolButton*>("maximise");
  QTest::mouseClick(button, Qt::LeftButton);
  EXPECT_GT(areaOf(w.slice(Plane::Coronal)), 0.95 * areaOf(w.window.views().layout().rect()));
  EXPECT_FALSE(w.volume().isValid());
  window::keep(window::pictureOf(w.window), "layout_coronal_alone");
  QTest::mouseClick(button, Qt::LeftButton);
  EXPECT_EQ(w.slice(Plane::Coronal), before);
  EXPECT_TRUE(w.volume().isValid());

  for (QWidget* view : {static_cast<QWidget*>(&w.window.views().slice(Plane::Sagittal)),
                        static_cast<QWidget*>(&w.window.views().volume())}) {
    view->setFocus();
    QTest::keyClick(view, Qt::Key_F);
    EXPECT_GT(areaOf(w.placeOf(*view)), 0.95 * areaOf(w.window.views().layout().rect()));
    QTest::keyClick(view, Qt::Key_F);
    EXPECT_EQ(w.slice(Plane::Coronal), before);
  }
  // in a field for text it is a letter
  auto* field = w.window.findChild<QDoubleSpinBox*>("isovalueTyped");
  field->setFocus();
  QTest::keyClick(field, Qt::Key_F);
  EXPECT_FALSE(w.window.views().layout().maximised());
  // out of "one view", F goes back to several
  w.choose("one");
  w.window.views().volume().setFocus();
  QTest::keyClick(&w.window.views().volume(), Qt::Key_F);
  EXPECT_EQ(w.window.views().layout().arrangement(), Arrangement::VolumeLarge);
}

TEST(Layout, GoesToTheNextViewByKey) {
  Window w;
  w.window.views().volume().setFocus();
  QTest::keyClick(&w.window, Qt::Key_F6);
  EXPECT_TRUE(w.window.views().slice(Plane::Axial).hasFocus());
  w.choose("one");
  QTest::keyClick(&w.window, Qt::Key_F6);
  EXPECT_TRUE(w.window.views().slice(Plane::Coronal).hasFocus());
  EXPECT_TRUE(w.slice(Plane::Coronal).isValid());
  EXPECT_FALSE(w.slice(Plane::Axial).isValid());
}

TEST(Layout, HasAPlaceForTheViewWithTheToolInEveryArrangement) {
  Window w;
  w.choose("showOblique");
  for (const char* name : {"volume_large", "four_up", "slices_large"}) {
    w.choose(name);
    EXPECT_TRUE(w.slice(Plane::Oblique).isValid()) << name;
    w.expectApart();
  }
  w.choose("showOblique");
  EXPECT_FALSE(w.slice(Plane::Oblique).isValid());
}

/// The border to the right of a view, or below it.
ui::ViewGap& gapAfter(Window& w, QRect view, bool right) {
  for (auto* gap : w.window.views().layout().findChildren<ui::ViewGap*>()) {
    const QRect at = gap->geometry();
    const int off = right ? at.x() - view.right() : at.y() - view.bottom();
    if (gap->isVisible() && off > 0 && off < 45 && (right || at.left() <= view.center().x()) &&
        (right ? at.width() < at.height() : at.right() >= view.center().x()))
      return *gap;
  }
  throw std::logic_error("there is no such border");
}

TEST(Layout, LetsTheBordersBeDraggedAndGivesTheFirstSizesBack) {
  Window w;
  const QRect before = w.volume();
  ui::ViewGap& gap = gapAfter(w, before, true);
  const QPoint on{2, 300};
  QTest::mousePress(&gap, Qt::LeftButton, {}, on);
  QMouseEvent move(QEvent::MouseMove, on - QPoint{120, 0}, gap.mapToGlobal(on - QPoint{120, 0}),
                   Qt::NoButton, Qt::LeftButton, {});
  QCoreApplication::sendEvent(&gap, &move);
  QTest::mouseRelease(&gap, Qt::LeftButton, {}, on);
  EXPECT_NEAR(w.volume().width(), before.width() - 120, 4);
  w.expectApart();
  w.choose("resetBorders");
  EXPECT_EQ(w.volume(), before);
  // and so does a double-click
  emit gap.moved(-60);
  EXPECT_NE(w.volume(), before);
  QTest::mouseDClick(&gap, Qt::LeftButton, {}, on);
  EXPECT_EQ(w.volume(), before);
}

TEST(Layout, EachArrangementKeepsItsBordersAlsoFromStartToStart) {
  QSettings().remove("window");
  QRect large, four, with_tool;
  const auto move = [](Window& w, QRect view, int px) {
    ui::ViewGap& gap = gapAfter(w, view, true);
    gap.setFocus();
    for (int n = 0; n < px / 16; ++n) QTest::keyClick(&gap, Qt::Key_Left);
  };
  {
    Window w;
    app::PreferencesController kept(w.window, true);
    const QRect first = w.volume();
    move(w, w.volume(), 96);
    large = w.volume();
    EXPECT_NEAR(large.width(), first.width() - 96, 5);
    // a view that was alone comes back to its place
    w.window.views().volume().setFocus();
    QTest::keyClick(&w.window.views().volume(), Qt::Key_F);
    EXPECT_NE(w.volume(), large);
    EXPECT_EQ(w.window.views().layout().borders().isEmpty(), false);
    QTest::keyClick(&w.window.views().volume(), Qt::Key_F);
    EXPECT_EQ(w.volume(), large);
    w.choose("four_up");
    move(w, w.slice(Plane::Axial), 48);  // the 3-D view is beyond it
    four = w.volume();
    w.choose("volume_large");
    EXPECT_EQ(w.volume(), large);
    w.choose("showOblique");
    EXPECT_EQ(w.volume().width(), first.width());  // other views, other borders
    move(w, w.volume(), 32);
    with_tool = w.volume();
    w.choose("showOblique");
    EXPECT_EQ(w.volume(), large);
    kept.save();
  }
  Window w;
  app::PreferencesController kept(w.window, true);
  kept.restoreWindow();
  QTest::qWait(100);
  EXPECT_NEAR(w.volume().width(), large.width(), 2);
  w.choose("four_up");
  EXPECT_NEAR(w.volume().width(), four.width(), 2);
  w.choose("volume_large");
  w.choose("showOblique");
  EXPECT_NEAR(w.volume().width(), with_tool.width(), 2);
  w.choose("showOblique");
  // first sizes of what is on view, and with the layout of all
  w.choose("resetBorders");
  EXPECT_GT(w.volume().width(), large.width() + 80);
  w.choose("four_up");
  EXPECT_NEAR(w.volume().width(), four.width(), 2);
  w.choose("resetLayout");
  w.choose("four_up");
  EXPECT_LT(w.volume().width(), four.width() - 30);
  EXPECT_TRUE(w.window.views().layout().borders().isEmpty());
  QSettings().remove("window");
}

TEST(Layout, BordersAreReachedAndMovedWithTheKeyboard) {
  Window w;
  const QRect volume = w.volume(), axial = w.slice(Plane::Axial);
  w.window.views().slice(Plane::Sagittal).setFocus();
  std::vector<ui::ViewGap*> reached;
  for (int tabs = 0; tabs < 60 && reached.size() < 3; ++tabs) {
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
    auto* gap = qobject_cast<ui::ViewGap*>(QApplication::focusWidget());
    if (gap != nullptr && std::ranges::find(reached, gap) == reached.end()) reached.push_back(gap);
  }
  EXPECT_EQ(reached.size(), 3U);  // between 3-D and slices, and between the slices

  ui::ViewGap& upright = gapAfter(w, volume, true);
  upright.setFocus();
  window::keep(window::pictureOf(w.window), "layout_border_focused");
  for (int n = 0; n < 5; ++n) QTest::keyClick(&upright, Qt::Key_Left);
  EXPECT_NEAR(w.volume().width(), volume.width() - 80, 5);
  QTest::keyClick(&upright, Qt::Key_Right);
  EXPECT_NEAR(w.volume().width(), volume.width() - 64, 5);
  QTest::keyClick(&upright, Qt::Key_Up);  // not along itself
  EXPECT_NEAR(w.volume().width(), volume.width() - 64, 5);
  // it ends before a view is gone
  for (int n = 0; n < 100; ++n) QTest::keyClick(&upright, Qt::Key_Right);
  EXPECT_GT(w.slice(Plane::Axial).width(), 100);
  EXPECT_TRUE(upright.hasFocus());
  QTest::keyClick(&upright, Qt::Key_Home);
  EXPECT_EQ(w.volume(), volume);
  EXPECT_TRUE(upright.hasFocus());

  ui::ViewGap& level = gapAfter(w, axial, false);
  level.setFocus();
  QTest::keyClick(&level, Qt::Key_Down);
  EXPECT_NEAR(w.slice(Plane::Axial).height(), axial.height() + 16, 3);
  QTest::keyClick(&level, Qt::Key_Up);
  EXPECT_NEAR(w.slice(Plane::Axial).height(), axial.height(), 3);
  w.expectApart();
}

TEST(Layout, HintsSayWhatTheMouseDoesAndCanBeHiddenForEver) {
  QSettings().remove("window");
  const auto hintOf = [](QWidget& view) {
    return view.parentWidget()->findChild<QLabel*>("viewHint");
  };
  {
    Window w;
    app::PreferencesController kept(w.window, true);
    for (const Plane plane : {Plane::Axial, Plane::Coronal, Plane::Sagittal})
      EXPECT_TRUE(hintOf(w.window.views().slice(plane))->isVisible());
    const QLabel* hint = hintOf(w.window.views().volume());
    ASSERT_TRUE(hint->isVisible());
    // at the foot of its view, and not over it
    EXPECT_GE(hint->y(), w.window.views().volume().geometry().bottom());
    const QString looking = hint->accessibleName();
    EXPECT_TRUE(hint->text().startsWith("Drag: turns"));
    w.window.views().volume().setMouseHand(true);
    EXPECT_TRUE(hint->accessibleName().contains("To touch"));
    w.window.views().volume().setFocus();
    QTest::keyClick(&w.window.views().volume(), Qt::Key_G);
    EXPECT_TRUE(hint->accessibleName().contains("move the tool"));
    QTest::keyClick(&w.window.views().volume(), Qt::Key_G);
    w.window.views().volume().setMouseHand(false);
    EXPECT_EQ(hint->accessibleName(), looking);
    window::keep(window::pictureOf(w.window), "layout_hints");
    // a narrow view has two lines, and in a very narrow one fewer sentences, each of them whole
    auto& slice = w.window.views().slice(Plane::Axial);
    auto* frame = static_cast<ui::ViewFrame*>(slice.parentWidget());
    const QSize size = frame->size();
    const QString whole = hintOf(slice)->accessibleName();
    for (const int width : {120, 160, 220, 290, 400, 700}) {
      frame->resize(width, size.height());
      const QLabel& below = *hintOf(slice);
      const QString read = below.text();
      EXPECT_TRUE(read.endsWith('.')) << read.toStdString();
      EXPECT_LE(read.count('\n'), 1);
      EXPECT_TRUE(whole.startsWith(QString(read).replace('\n', ' '))) << read.toStdString();
      EXPECT_LE(below.sizeHint().width(), below.width());
      EXPECT_LE(below.sizeHint().height(), below.height());
      EXPECT_EQ(below.geometry().bottom(), frame->height() - 1);
      if (width >= 290) {
        EXPECT_EQ(QString(read).replace('\n', ' '), whole);
      }
    }
    frame->resize(size);

    const int height = w.window.views().volume().height();
    auto* axial = w.window.views().slice(Plane::Axial).parentWidget();
    QTest::mouseClick(axial->findChild<QToolButton*>("hideHints"), Qt::LeftButton);
    EXPECT_FALSE(hint->isVisible());
    EXPECT_FALSE(hintOf(w.window.views().slice(Plane::Sagittal))->isVisible());
    EXPECT_GT(w.window.views().volume().height(), height + 10);
    EXPECT_FALSE(w.window.findChild<QAction*>("showHints")->isChecked());
    EXPECT_FALSE(app::loadPreferences().hints);  // at once, not when the window closes
    window::keep(window::pictureOf(w.window), "layout_without_hints");
  }
  Window w;
  app::PreferencesController kept(w.window, true);
  kept.restoreWindow();
  EXPECT_FALSE(hintOf(w.window.views().volume())->isVisible());
  w.choose("showHints");
  EXPECT_TRUE(hintOf(w.window.views().volume())->isVisible());
  EXPECT_TRUE(app::loadPreferences().hints);
  QSettings().remove("window");
}

TEST(Layout, The3DViewShowsTheWholeBallInANarrowColumnAndKeepsTheUsersZoom) {
  Window w;
  ui::VolumeView& view = w.window.views().volume();
  const auto holdsBall = [&] {
    for (const Vec3& p :
         {Vec3{0.015, 0, 0}, Vec3{-0.015, 0, 0}, Vec3{0, 0, 0.015}, Vec3{0, 0, -0.015}})
      if (!QRectF(view.rect()).contains(view.projected(p))) return false;
    return true;
  };
  const auto across = [&] {
    return view.projected({0.015, 0, 0}).x() - view.projected({-0.015, 0, 0}).x();
  };
  EXPECT_TRUE(holdsBall());
  w.choose("slices_large");
  EXPECT_LT(view.width(), 0.5 * view.height());
  EXPECT_TRUE(holdsBall());
  EXPECT_GT(across(), 0.4 * view.width());
  window::pictureAtRest(view);
  window::keep(window::pictureOf(w.window), "layout_narrow_column");
  // it is turned and shifted: that is no zoom
  view.camera()->Azimuth(30.0);
  w.choose("volume_large");
  EXPECT_TRUE(holdsBall());
  EXPECT_GT(across(), 0.25 * view.width());
  const double height_before = view.height();
  QWheelEvent wheel({150, 150}, view.mapToGlobal(QPointF{150, 150}), {}, {0, 360}, {}, {},
                    Qt::NoScrollPhase, false);
  QCoreApplication::sendEvent(&view, &wheel);
  const double distance = view.camera()->GetDistance();
  w.choose("slices_large");
  EXPECT_EQ(view.camera()->GetDistance(), distance);
  EXPECT_GT(view.height(), 0.9 * height_before);
  // "show everything" fits again from then on
  view.resetCamera();
  EXPECT_TRUE(holdsBall());
  w.choose("volume_large");
  EXPECT_NE(view.camera()->GetDistance(), distance);
  EXPECT_TRUE(holdsBall());
}

TEST(Layout, IsRemembered) {
  {
    Window w;
    w.choose("slices_large");
    w.choose("showOblique");
    app::Preferences preferences = app::loadPreferences();
    preferences.layout.views = w.window.views().state();
    app::savePreferences(preferences);
  }
  Window w;
  w.window.views().restore(app::loadPreferences().layout.views);
  EXPECT_EQ(w.window.views().layout().arrangement(), Arrangement::SlicesLarge);
  EXPECT_TRUE(w.window.views().slices().obliqueShown());
  w.window.views().restore("nonsense+tool");
  EXPECT_EQ(w.window.views().layout().arrangement(), Arrangement::SlicesLarge);
  w.window.views().restore("four_up");
  EXPECT_EQ(w.window.views().state(), "four_up");
  EXPECT_FALSE(w.window.views().slices().obliqueShown());
  QSettings().remove("window/views");
}

TEST(Layout, TheWidthOfTheEditPanelDoesNotDependOnWhatItSays) {
  ui::EditPanel panel;
  panel.QWidget::show();
  const int width = panel.minimumSizeHint().width();
  panel.show(ui::EditSteps{.in_force = 12'345, .undo = true, .redo = true});
  QCoreApplication::processEvents();
  EXPECT_EQ(panel.minimumSizeHint().width(), width);
  const QString words = "Undo waits until the tool no longer touches.";
  panel.showWait(words);
  for (const auto confirm :
       {ui::EditConfirm::Removal, ui::EditConfirm::Cut, ui::EditConfirm::Piece}) {
    panel.showPreview(words, confirm);
    QCoreApplication::processEvents();
    EXPECT_EQ(panel.minimumSizeHint().width(), width);
  }
}

}  // namespace
