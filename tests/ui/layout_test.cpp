// SPDX-License-Identifier: BSD-3-Clause
// How the views share the window.
#include <gtest/gtest.h>

#include <QAction>
#include <QDoubleSpinBox>
#include <QSettings>
#include <QTest>
#include <QToolButton>

#include "app/window/preferences.h"
#include "panelled_window.h"
#include "ui/main_window.h"
#include "ui/volume_view.h"
#include "window_support.h"

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
    window.view().setSurfaceWish(ui::SurfaceMode::Mesh);
    panelled.show(ballPicture(), 50.0, "Ball");
    window::showAndWait(window, {1240, 860});
    window.activateWindow();
    EXPECT_TRUE(QTest::qWaitForWindowActive(&window, 20'000));
  }
  void choose(const char* action) {
    auto* found = window.findChild<QAction*>(action);
    ASSERT_NE(found, nullptr) << action;
    found->trigger();
    QTest::qWait(50);
  }
  QRect placeOf(QWidget& view) {
    return view.isVisible() ? QRect(view.mapTo(&window.views(), QPoint{}), view.size()) : QRect();
  }
  QRect volume() { return placeOf(window.view()); }
  QRect slice(Plane plane) { return placeOf(window.slice(plane)); }
  /// No view over another, and all in the room there is.
  void expectApart() {
    std::vector<QRect> rects{volume()};
    for (const Plane plane : {Plane::Axial, Plane::Coronal, Plane::Sagittal, Plane::Oblique})
      rects.push_back(slice(plane));
    for (std::size_t a = 0; a < rects.size(); ++a) {
      EXPECT_TRUE(rects[a].isNull() || window.views().rect().contains(rects[a]));
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
  EXPECT_EQ(w.window.views().arrangement(), Arrangement::VolumeLarge);
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
  EXPECT_EQ(areaOf(w.volume()) > 0.97 * areaOf(w.window.views().rect()), true);
  EXPECT_TRUE(w.window.findChild<QAction*>("one")->isChecked());
  EXPECT_FALSE(w.window.findChild<QAction*>("slices_large")->isChecked());
  // and the 3-D view draws as before: it was never taken apart
  w.choose("volume_large");
  EXPECT_GT(window::count(window::pictureAtRest(w.window.view()), window::surfaceColoured), 2'000);
}

TEST(Layout, ShowsAViewAloneByItsButtonAndByKeyFAndGivesTheOthersBack) {
  Window w;
  const QRect before = w.slice(Plane::Coronal);
  auto* frame = w.window.slice(Plane::Coronal).parentWidget();
  auto* button = frame->findChild<QToolButton*>("maximise");
  QTest::mouseClick(button, Qt::LeftButton);
  EXPECT_GT(areaOf(w.slice(Plane::Coronal)), 0.97 * areaOf(w.window.views().rect()));
  EXPECT_FALSE(w.volume().isValid());
  window::keep(window::pictureOf(w.window), "layout_coronal_alone");
  QTest::mouseClick(button, Qt::LeftButton);
  EXPECT_EQ(w.slice(Plane::Coronal), before);
  EXPECT_TRUE(w.volume().isValid());

  for (QWidget* view : {static_cast<QWidget*>(&w.window.slice(Plane::Sagittal)),
                        static_cast<QWidget*>(&w.window.view())}) {
    view->setFocus();
    QTest::keyClick(view, Qt::Key_F);
    EXPECT_GT(areaOf(w.placeOf(*view)), 0.97 * areaOf(w.window.views().rect()));
    QTest::keyClick(view, Qt::Key_F);
    EXPECT_EQ(w.slice(Plane::Coronal), before);
  }
  // in a field for text it is a letter
  auto* field = w.window.findChild<QDoubleSpinBox*>("isovalueTyped");
  field->setFocus();
  QTest::keyClick(field, Qt::Key_F);
  EXPECT_FALSE(w.window.views().maximised());
  // out of "one view", F goes back to several
  w.choose("one");
  w.window.view().setFocus();
  QTest::keyClick(&w.window.view(), Qt::Key_F);
  EXPECT_EQ(w.window.views().arrangement(), Arrangement::VolumeLarge);
}

TEST(Layout, GoesToTheNextViewByKey) {
  Window w;
  w.window.view().setFocus();
  QTest::keyClick(&w.window, Qt::Key_F6);
  EXPECT_TRUE(w.window.slice(Plane::Axial).hasFocus());
  w.choose("one");
  QTest::keyClick(&w.window, Qt::Key_F6);
  EXPECT_TRUE(w.window.slice(Plane::Coronal).hasFocus());
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

TEST(Layout, LetsTheGapsBeDragged) {
  Window w;
  ui::ViewLayout& views = w.window.views();
  const QRect before = w.volume();
  const QPoint gap{before.right() + 5, views.height() / 2};
  QTest::mousePress(&views, Qt::LeftButton, {}, gap);
  QMouseEvent move(QEvent::MouseMove, gap - QPoint{120, 0},
                   views.mapToGlobal(QPointF(gap - QPoint{120, 0})), Qt::NoButton, Qt::LeftButton,
                   {});
  QCoreApplication::sendEvent(&views, &move);
  QTest::mouseRelease(&views, Qt::LeftButton, {}, gap - QPoint{120, 0});
  EXPECT_NEAR(w.volume().width(), before.width() - 120, 4);
  w.expectApart();
}

TEST(Layout, IsRemembered) {
  {
    Window w;
    w.choose("slices_large");
    w.choose("showOblique");
    app::Preferences preferences = app::loadPreferences();
    preferences.views = w.window.viewState();
    app::savePreferences(preferences);
  }
  Window w;
  w.window.restoreViews(app::loadPreferences().views);
  EXPECT_EQ(w.window.views().arrangement(), Arrangement::SlicesLarge);
  EXPECT_TRUE(w.window.slices().obliqueShown());
  w.window.restoreViews("nonsense+tool");
  EXPECT_EQ(w.window.views().arrangement(), Arrangement::SlicesLarge);
  w.window.restoreViews("four_up");
  EXPECT_EQ(w.window.viewState(), "four_up");
  EXPECT_FALSE(w.window.slices().obliqueShown());
  QSettings().remove("window/views");
}

}  // namespace
