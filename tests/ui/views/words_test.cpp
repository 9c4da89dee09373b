// SPDX-License-Identifier: BSD-3-Clause
// What is written in the views: nothing stands over the body, over a handle or over other words, in
// any layout, theme or language. Scales are those at which this program is started.
#include <gtest/gtest.h>

#include <QApplication>
#include <QLabel>
#include <QLocale>
#include <QTest>
#include <QToolButton>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

#include "datasets/readers/volume_reader.h"
#include "tests/support/places.h"
#include "tests/support/sentence.h"
#include "tests/ui/window_support.h"
#include "ui/controls/language.h"
#include "ui/overlays/measures.h"
#include "ui/style/style.h"
#include "ui/views/slice_readout.h"
#include "ui/window/main_window.h"
#include "ui/window/view_layout.h"
#include "ui/window/views.h"

namespace {

using haptics::Vec3;
using ui::Arrangement;
using ui::Plane;
using ui::style::Theme;

/// A head of 1 mm voxels about the origin, with skin, skull and brain, in air.
std::shared_ptr<const haptics::Volume> madeHead() {
  haptics::Grid grid;
  grid.dims = {120, 130, 110};
  grid.spacing = Vec3::Constant(2e-3);
  for (int a = 0; a < 3; ++a)
    grid.origin[a] = -1e-3 * static_cast<double>(grid.dims[static_cast<std::size_t>(a)] - 1);
  return window::volumeOf(
      grid, haptics::ScalarType::Int16,
      [](const Vec3& p) {
        const double r = Vec3{p.x() / 0.075, p.y() / 0.095, p.z() / 0.085}.norm();
        return r > 1.0 ? -1000.0 : r > 0.95 ? 20.0 : r > 0.85 ? 1000.0 : 35.0;
      },
      {.unit = "HU", .modality = "CT"});
}

/// Knows how overlays see a view.
class SeenByOverlays : public ui::Overlay {
 public:
  explicit SeenByOverlays(const ui::Measures& measures) : measures_(measures) {}
  void paint(QPainter&, const ui::ViewGeometry& view) const override {
    labels[&view.widget()] = measures_.labelsIn(view);
    handles[&view.widget()].clear();
    for (const ui::Measure& measure : measures_.all())
      for (const Vec3& p : measure.places_mm)
        if (!view.isSlice() || std::abs(view.offset_mm(p)) < ui::Measures::kFaint_mm)
          handles[&view.widget()] << view.projected(p);
  }
  mutable std::map<const QWidget*, std::vector<ui::MeasureLabel>> labels;
  mutable std::map<const QWidget*, QPolygonF> handles;

 private:
  const ui::Measures& measures_;
};

struct WordBox {
  std::string what;
  QRectF box;
};

/// Whether a voxel of the body is seen in a box of a slice.
bool meetsBody(const ui::SliceView& view, const haptics::Volume& volume, const QRectF& box) {
  const auto* voxels = static_cast<const std::int16_t*>(volume.voxels.get());
  const QRectF seen = box.intersected(view.pictureRect());
  for (double y = seen.top(); y < seen.bottom(); y += 2.0)
    for (double x = seen.left(); x < seen.right(); x += 2.0) {
      const Vec3 at = volume.grid.indexOf(view.placeUnder({x, y}) * 1e-3);
      std::array<std::int64_t, 3> i{};
      bool inside = true;
      for (std::size_t a = 0; a < 3; ++a) {
        i[a] = std::lround(at[static_cast<Eigen::Index>(a)]);
        inside = inside && i[a] >= 0 && i[a] < volume.grid.dims[a];
      }
      if (inside && voxels[(i[2] * volume.grid.dims[1] + i[1]) * volume.grid.dims[0] + i[0]] > -300)
        return true;
    }
  return false;
}

class Words : public testing::Test {
 protected:
  ~Words() override {
    ui::setLanguage("en");
    QLocale::setDefault(QLocale::c());
    ui::style::applyTheme(*qApp, Theme::Dark);
  }

  void expectApart(const std::shared_ptr<const haptics::Volume>& volume, const char* name);
  static int expectApartIn(ui::SliceView& view, const haptics::Volume& volume,
                           const SeenByOverlays& seen);
};

int Words::expectApartIn(ui::SliceView& view, const haptics::Volume& volume,
                         const SeenByOverlays& seen) {
  std::vector<WordBox> boxes;
  const ui::ReadoutLayout layout = view.readoutLayout();
  for (const ui::ReadoutText& text : layout.texts) {
    boxes.push_back({text.text.toStdString(), text.box});
    EXPECT_FALSE(text.box.intersects(view.pictureRect())) << text.text.toStdString();
    EXPECT_TRUE(view.rect().contains(text.box)) << text.text.toStdString();
  }
  // no letter is ever left out
  EXPECT_EQ(std::ranges::count_if(layout.texts,
                                  [&](const ui::ReadoutText& text) {
                                    return std::ranges::count(view.readout().letters, text.text) >
                                           0;
                                  }),
            4);
  if (layout.ruler)
    boxes.push_back(
        {"ruler", QRectF(layout.ruler->p1(), layout.ruler->p2()).adjusted(0, -3, 0, 3)});
  for (const auto* button : view.parentWidget()->findChildren<QToolButton*>())
    if (button->isVisible())
      boxes.push_back({button->objectName().toStdString(),
                       QRectF(view.mapFromParent(button->pos()), QSizeF(button->size()))});
  const QPolygonF handles = seen.handles.count(&view) > 0 ? seen.handles.at(&view) : QPolygonF{};
  for (const ui::MeasureLabel& label : seen.labels.at(&view))
    boxes.push_back({label.text.toStdString(), label.box});
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    for (std::size_t j = i + 1; j < boxes.size(); ++j)
      EXPECT_FALSE(boxes[i].box.intersects(boxes[j].box))
          << boxes[i].what << " and " << boxes[j].what;
    for (const QPointF& p : handles)
      EXPECT_FALSE(boxes[i].box.adjusted(-5, -5, 5, 5).contains(p)) << boxes[i].what;
    EXPECT_FALSE(meetsBody(view, volume, boxes[i].box)) << boxes[i].what;
  }
  const auto* hint = view.parentWidget()->findChild<QLabel*>("viewHint");
  EXPECT_LE(hint->sizeHint().height(), hint->height());
  EXPECT_LE(hint->sizeHint().width(), hint->width());
  return static_cast<int>(boxes.size());
}

void Words::expectApart(const std::shared_ptr<const haptics::Volume>& volume, const char* name) {
  ASSERT_TRUE(volume);
  const ui::Picture picture = ui::pictureOf(volume);
  // the views are dark in every theme: one is enough for a large scan
  std::vector<Theme> themes{Theme::Dark};
  if (volume->grid.dims[0] < 200) themes.insert(themes.end(), {Theme::Light, Theme::HighContrast});
  int boxes = 0;
  for (const char* language : {"en", "de"}) {
    ui::setLanguage(language);
    ui::MainWindow window;
    window.views().volume().setSurfaceWish(ui::SurfaceMode::Mesh);
    window.show(picture, 300.0, "Head");
    window.views().show(window::octahedron(0.006));
    ui::Measures measures;
    SeenByOverlays seen(measures);
    window.views().addOverlay(seen);
    window.views().addOverlay(measures);
    measures.setScan({.grid = volume->grid});
    const Vec3 c = window.views().cross_mm();
    measures.replace(
        {{ui::MeasureKind::Distance, "Distance 1", {c + Vec3{-20, 0, 0}, c + Vec3{25, 1, 1}}},
         {ui::MeasureKind::Angle,
          "Angle 1",
          {c + Vec3{0, 10, 0}, c + Vec3{2, 20, 0}, c + Vec3{30, 30, 0}}},
         {ui::MeasureKind::Note, "here", {c}}});
    window::showAndWait(window, {1280, 840});
    for (const Theme theme : themes) {
      ui::style::applyTheme(*qApp, theme);
      for (const auto& [arrangement, words] : {std::pair{Arrangement::FourUp, "four_up"},
                                               std::pair{Arrangement::VolumeLarge, "volume"},
                                               std::pair{Arrangement::SlicesLarge, "slices"}}) {
        SCOPED_TRACE(std::string(name) + ", " + language + ", " +
                     ui::style::nameOf(theme).toStdString() + ", " + words);
        window.views().layout().arrange(arrangement);
        QTest::qWait(50);
        const QImage image = window::pictureOf(window);
        if (theme == Theme::Dark)
          window::keep(image,
                       (std::string("words_") + name + "_" + language + "_" + words).c_str());
        for (ui::SliceView* slice : window.views().slices().slices()) {
          if (!slice->isVisible()) continue;
          SCOPED_TRACE(slice->readout().name.toStdString());
          boxes += expectApartIn(*slice, *volume, seen);
          // the body fills it: one of its sides is near the edges of the picture
          const Eigen::AlignedBox3d& body = picture.body_mm;
          const QRectF shown =
              QRectF(slice->projected(body.min()), slice->projected(body.max())).normalized();
          const QRectF room = slice->pictureRect();
          EXPECT_GT(std::max(shown.width() / room.width(), shown.height() / room.height()), 0.9);
          EXPECT_TRUE(room.adjusted(-1, -1, 1, 1).contains(shown));
        }
        const QWidget* space = &window.views().volume();
        for (const ui::MeasureLabel& label : seen.labels[space])
          for (const QPointF& p : seen.handles[space])
            EXPECT_FALSE(label.box.adjusted(-5, -5, 5, 5).contains(p)) << label.text.toStdString();
        if (HasFailure()) return;
      }
    }
  }
  EXPECT_GT(boxes, 150);
}

TEST_F(Words, StandOverNoBodyNoHandleAndNoOtherWords) { expectApart(madeHead(), "made"); }

TEST_F(Words, StandOverNoBodyInARealScanEither) {
  const std::filesystem::path place =
      places::scan("visible_human_female_head/vhf_head_512x512x234.nrrd");
  if (!std::filesystem::exists(place)) GTEST_SKIP() << place << " is not there";
  auto volume = datasets::readVolume(place);
  ASSERT_TRUE(volume) << sentence(volume.error());
  expectApart(std::make_shared<const haptics::Volume>(std::move(*volume)), "real");
}

}  // namespace
