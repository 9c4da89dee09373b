// SPDX-License-Identifier: BSD-3-Clause
#include "tests/ui/edits/editing.h"

#include <QAction>
#include <QApplication>
#include <QColor>
#include <QCoreApplication>
#include <QImage>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QMouseEvent>
#include <QPainter>
#include <QTimer>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "app/window/edits/edit_controller.h"
#include "app/window/scan/loader.h"
#include "datasets/readers/nrrd/writer.h"
#include "haptics/session.h"
#include "tests/ui/views/sphere_in_hand.h"
#include "tests/ui/window_support.h"
#include "ui/controls/number_box.h"
#include "ui/panels/histogram_slider.h"
#include "ui/views/volume_view.h"
#include "ui/window/views.h"

namespace window {
namespace {

constexpr std::array kPlanes{ui::Plane::Axial, ui::Plane::Coronal, ui::Plane::Sagittal};
constexpr double kGreyLevel = 50.0, kGreyWidth = 100.0;  // of the balls at first
constexpr double kMiddle_mm = 22.0;  // of a slice from its middle: beyond, words are written

/// A grey pixel as an intensity; none where something is drawn in colour.
std::optional<double> intensityOf(QColor c) {
  if (std::abs(c.red() - c.green()) > 6 || std::abs(c.green() - c.blue()) > 6) return {};
  return kGreyLevel + (c.red() / 255.0 - 0.5) * kGreyWidth;
}

QImage grabbed(QWidget& view) {
  return view.grab().toImage().convertToFormat(QImage::Format_RGB32);
}

}  // namespace

const Eigen::Vector3d Editing::kLargeAt{-12, 0, 0}, Editing::kSmallAt{16, 0, 12};

void Editing::open(const std::filesystem::path& scan, double isovalue) {
  app::Arguments arguments = recordedSphere(recordings_, "mouse");
  arguments.load.phantom = {};
  arguments.load.path = scan;
  arguments.load.isovalue = isovalue;
  application_ = std::make_unique<app::Application>(arguments);
  application_->start();
  ASSERT_TRUE(waitFor([&] { return application_->snapshot().scene != 0; }));
  // a shortcut is the active window's
  window().activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window(), 120'000));
  press("View", "Remove parts");
  window().views().volume().resetCamera();  // from the front
}

void Editing::openBalls() {
  const auto path = std::filesystem::path(scans_.path().toStdString()) / "balls.nrrd";
  const auto large = ball(kLargeAt * 1e-3, kLarge_mm * 1e-3);
  const auto small = ball(kSmallAt * 1e-3, kSmall_mm * 1e-3);
  const auto scan = volumeOf(cubeGrid(64), haptics::ScalarType::Int16,
                             [&](const haptics::Vec3& p) { return std::max(large(p), small(p)); });
  ASSERT_TRUE(datasets::writeNrrd(*scan, path).has_value());
  open(path, 50.0);
}

double Editing::number(const char* name) { return child<ui::NumberBox>(name).value(); }

void Editing::press(const char* menu, const char* entry) {
  for (QAction* top : window().menuBar()->actions())
    if (top->text().remove('&') == menu)
      for (QAction* action : top->menu()->actions())
        if (action->text().remove('&') == entry) action->trigger();
}

void Editing::click(const char* button) {
  QTest::mouseClick(&child(button), Qt::LeftButton);
  settle();
}

void Editing::type(const char* number, const char* text) {
  auto& box = child<ui::NumberBox>(number);
  box.setFocus();
  box.selectAll();
  QTest::keyClicks(&box, text);
  QTest::keyClick(&box, Qt::Key_Return);
}

void Editing::undo() {
  QTest::keyClick(&window(), Qt::Key_Z, Qt::ControlModifier);
  settle();
}

void Editing::redo() {
  QTest::keyClick(&window(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  settle();
}

void Editing::settle() {
  ASSERT_TRUE(waitFor([&] { return !application_->editing().isBusy(); }));
}

bool Editing::previewed() {
  return waitFor([&] { return child<QLabel>("editPreview").isVisible(); });
}

void Editing::mouse(QWidget& view, QEvent::Type type, QPointF at, Qt::MouseButtons held) {
  QMouseEvent event(type, at, view.mapToGlobal(at),
                    type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton, held,
                    Qt::NoModifier);
  QCoreApplication::sendEvent(&view, &event);
}

void Editing::drag(QWidget& view, const std::vector<QPointF>& way,
                   const std::function<void()>& before_release) {
  mouse(view, QEvent::MouseButtonPress, way.front(), Qt::LeftButton);
  for (const QPointF& at : way) mouse(view, QEvent::MouseMove, at, Qt::LeftButton);
  if (before_release) before_release();
  mouse(view, QEvent::MouseButtonRelease, way.back(), Qt::NoButton);
}

void Editing::keepWindow(const char* name) {
  QImage whole = pictureOf(window());
  ui::VolumeView& view = window().views().volume();
  QPainter{&whole}.drawImage(view.mapTo(&window(), QPoint{}), view.grabFramebuffer());
  keep(whole, name);
}

double Editing::felt(const Vector3d& p_mm) {
  const haptics::ScalarField& field = application_->shown()->scene->field;
  return field.value(field.indexOf(p_mm * 1e-3));
}

bool Editing::isThere(const Vector3d& p_mm) {
  // beside the lines of the crosshair
  window().views().setCross(p_mm);
  for (const ui::Plane plane : kPlanes) {
    ui::SliceView& view = slice(plane);
    const QImage image = grabbed(view);
    int compared = 0;
    for (const QPoint by : {QPoint{-4, 4}, QPoint{4, 4}, QPoint{-4, -4}, QPoint{4, -4}}) {
      const QPoint at = view.projected(p_mm).toPoint() + by;
      const auto seen = intensityOf(image.pixelColor(at));
      if (!seen) continue;
      ++compared;
      EXPECT_NEAR(*seen, felt(view.placeUnder(QPointF(at) + QPointF{0.5, 0.5})), 8.0)
          << "slice " << int(plane) << " at " << p_mm.transpose();
    }
    EXPECT_GT(compared, 0) << "slice " << int(plane) << " at " << p_mm.transpose();
  }
  return felt(p_mm) >= isovalue_;
}

bool Editing::isSeen(const Vector3d& p_mm) {
  const QImage picture = pictureAtRest(window().views().volume());
  return surfaceColoured(picture.pixelColor(inSpace(p_mm).toPoint()));
}

void Editing::expectSlicesShow(const std::function<double(const Vector3d& p_mm)>& field) {
  for (const ui::Plane plane : kPlanes) {
    ui::SliceView& view = slice(plane);
    const QImage image = grabbed(view);
    const QRect picture = view.pictureRect();
    int compared = 0, apart = 0;
    for (int y = picture.top(); y < picture.bottom(); y += 3)
      for (int x = picture.left(); x < picture.right(); x += 3) {
        const Vector3d place = view.placeUnder({x + 0.5, y + 0.5});
        if (place.cwiseAbs().maxCoeff() > kMiddle_mm) continue;
        const auto seen = intensityOf(image.pixelColor(x, y));
        if (!seen) continue;
        ++compared;
        apart += std::abs(*seen - std::clamp(field(place), 0.0, 100.0)) > 12.0;
      }
    EXPECT_GT(compared, 300) << "slice " << int(plane);
    EXPECT_LT(apart, 0.01 * compared) << "of " << compared << ", slice " << int(plane);
    for (const auto& [from_mm, to_mm] : view.contour_W_mm())
      EXPECT_NEAR(field(from_mm), isovalue_, 4.0) << "slice " << int(plane);
  }
}

void Editing::expectTheSameEverywhere() {
  expectSlicesShow([&](const Vector3d& p_mm) { return felt(p_mm); });
  const auto& shown = *application_->shown();
  EXPECT_EQ(shown.scene->volume, shown.picture.volume);
  EXPECT_EQ(window().views().volume().picture().volume, shown.picture.volume);
  const ui::Histogram& drawn = window().findChild<ui::HistogramSlider*>()->histogram();
  EXPECT_EQ(drawn.counts,
            ui::histogramOf(*shown.picture.volume, static_cast<int>(drawn.counts.size())).counts);
  EXPECT_TRUE(waitFor([&] { return application_->snapshot().scene == shown.scene->id; }));
}

Eigen::Vector3d Editing::pulledTo(const Vector3d& p_mm) {
  haptics::Pose hand = application_->snapshot().X_WD;
  const Vector3d from = hand.translation();
  for (int n = 1; n <= 25; ++n) {
    hand.translation() = from + (p_mm * 1e-3 - from) * (n / 25.0);
    application_->session().pull(hand);
    afterTicks(*application_, 12);
  }
  afterTicks(*application_, 300);
  return application_->snapshot().X_WP.translation() * 1e3;
}

void discardWhenAsked(ui::MainWindow& window) {
  auto* look = new QTimer(&window);
  QObject::connect(look, &QTimer::timeout, look, [look] {
    auto* question = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
    if (question == nullptr) return;
    look->deleteLater();
    for (QAbstractButton* button : question->buttons())
      if (button->text().remove('&') == "Discard") return button->click();
  });
  look->start(50);
}

}  // namespace window
