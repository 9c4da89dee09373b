// SPDX-License-Identifier: BSD-3-Clause
#include "tests/ui/edits/cutting.h"

#include <vtkCamera.h>

#include <QAbstractButton>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <variant>

#include "app/window/edits/edit_controller.h"
#include "datasets/readers/nrrd/writer.h"
#include "haptics/session.h"
#include "tests/ui/views/sphere_in_hand.h"
#include "ui/views/volume_view.h"
#include "ui/window/views.h"

namespace window {

void Cutting::openWithBurr() {
  const auto path = std::filesystem::path(scans_.path().toStdString()) / "plate.nrrd";
  const auto scan =
      volumeOf(cubeGrid(64), haptics::ScalarType::Int16, [&](const haptics::Vec3& p_W) {
        const Vector3d p = p_W * 1e3;
        const double out =
            std::max({std::abs(p.y()) + kFront_mm, std::abs(p.x()) - 24.0, std::abs(p.z()) - 24.0});
        return 100.0 * std::clamp(0.5 - out / 3.0, 0.0, 1.0);
      });
  ASSERT_TRUE(datasets::writeNrrd(*scan, path).has_value());
  open(path, 50.0);
  QTest::mouseClick(&child("cut_burr-4"), Qt::LeftButton);
  ASSERT_TRUE(waitFor([&] { return application_->shown()->tool.name == "burr-4"; }));
  ASSERT_TRUE(isReady()) << state().toStdString();
  // the tool stands straight on the plate: seen aslant, it hides nothing
  ui::VolumeView& view = window().views().volume();
  view.camera()->Azimuth(50.0);
  view.camera()->Elevation(25.0);
  showCamera(view);
  EXPECT_TRUE(child("cut_burr-4").isChecked());
  EXPECT_FALSE(child("cut_burr-6").isChecked());
  EXPECT_TRUE(view.hint().startsWith("Hold X: cuts. "));
}

void Cutting::pullTip(const Vector3d& p_mm) {
  // straight at the plate: aslant, it would turn in the mouse's grip
  haptics::Pose X = haptics::Pose::Identity();
  X.linear() << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  const haptics::Vec3 tip = application_->shown()->scene->tool.shell.tip;
  const haptics::Vec3 from = application_->snapshot().X_WD * tip;
  for (int n = 1; n <= 25; ++n) {
    X.translation() = from + (p_mm * 1e-3 - from) * (n / 25.0) - X.linear() * tip;
    application_->session().pull(X);
    afterTicks(*application_, 12);
  }
  afterTicks(*application_, 300);
}

void Cutting::holdKey(bool down) {
  ui::VolumeView& view = window().views().volume();
  view.setFocus();
  if (down)
    QTest::keyPress(&view, Qt::Key_X);
  else
    QTest::keyRelease(&view, Qt::Key_X);
}

double Cutting::removed_mm3() {
  const QString words = child<QLabel>("cutRemoved").text();
  return words.section(' ', 1, 1).toDouble();
}

std::size_t Cutting::strokes() {
  return static_cast<std::size_t>(std::ranges::count_if(
      application_->editing().edits(),
      [](const datasets::Edit& edit) { return std::holds_alternative<datasets::Stroke>(edit); }));
}

void Cutting::cut(double aside_mm, double mm3) {
  const double before = removed_mm3();
  const std::size_t strokes_before = strokes();
  pullTip(at(-6.0, aside_mm));
  pullTip(at(5.0, aside_mm));
  ASSERT_GT(application_->snapshot().contacts, 0);
  EXPECT_EQ(removed_mm3(), before);  // nothing without the key
  holdKey(true);
  bool turned = false;  // a window that is slow lets it rest now and then
  ASSERT_TRUE(waitFor([&] {
    turned = turned || state().startsWith("The burr turns: ");
    return removed_mm3() >= before + mm3;
  })) << state().toStdString();
  EXPECT_TRUE(turned);
  EXPECT_EQ(strokes(), strokes_before);
  holdKey(false);
  ASSERT_TRUE(waitFor([&] { return strokes() == strokes_before + 1; }));
  settle();
  EXPECT_TRUE(state().startsWith("Hold X"));
}

void Cutting::lift() {
  pullTip(at(-25.0));
  ASSERT_TRUE(waitFor([&] { return application_->snapshot().contacts == 0; }));
}

}  // namespace window
