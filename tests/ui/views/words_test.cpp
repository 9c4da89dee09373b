// SPDX-License-Identifier: BSD-3-Clause
// What is written in the views: nothing stands over the body, over a handle or over other words, in
// any layout, theme or language. Scales are those at which this program is started.
#include <gtest/gtest.h>

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>

#include <QApplication>
#include <QLabel>
#include <QTest>
#include <QToolButton>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

#include "app/window/views/picture_controller.h"
#include "datasets/readers/volume_reader.h"
#include "tests/support/places.h"
#include "tests/support/sentence.h"
#include "tests/ui/window_support.h"
#include "ui/controls/language.h"
#include "ui/overlays/measures.h"
#include "ui/panels/force_panel.h"
#include "ui/style/scene_colours.h"
#include "ui/style/style.h"
#include "ui/views/slice_readout.h"
#include "ui/window/banner.h"
#include "ui/window/main_window.h"
#include "ui/window/touch_state.h"
#include "ui/window/view_layout.h"
#include "ui/window/views.h"

namespace {

using haptics::Vec3;
using ui::Arrangement;
using ui::Plane;
using ui::style::Theme;
using window::waitFor;

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

/// The places of W [mm] that the 3-D view draws as the surface, where it is a mesh.
std::vector<Vec3> drawnSurface_mm(ui::VolumeView& view) {
  auto* mesh =
      vtkPolyData::SafeDownCast(view.surface().mesh()->GetMapper()->GetInputDataObject(0, 0));
  std::vector<Vec3> places;
  for (vtkIdType n = 0; mesh != nullptr && n < mesh->GetNumberOfPoints(); ++n)
    places.emplace_back(view.picture().X_WL_mm * Vec3{mesh->GetPoint(n)});
  return places;
}

/// A way in which the views share the window; `alone`: the view that has all of it.
struct Shared {
  std::string words;
  Arrangement arrangement = Arrangement::FourUp;
  bool tool_view = false, maximised = false;
  std::size_t alone = 0;
};

/// All of them, and those that differ most.
std::vector<Shared> allShared() {
  std::vector<Shared> all;
  for (const bool tool_view : {false, true})
    for (const Arrangement arrangement :
         {Arrangement::FourUp, Arrangement::VolumeLarge, Arrangement::SlicesLarge})
      all.push_back(
          {ui::ViewLayout::nameOf(arrangement).toStdString() + (tool_view ? "_with_tool" : ""),
           arrangement, tool_view});
  for (std::size_t view = 0; view < 5; ++view) {
    all.push_back({"one_" + std::to_string(view), Arrangement::One, true, false, view});
    all.push_back(
        {"maximised_" + std::to_string(view), Arrangement::SlicesLarge, true, true, view});
  }
  return all;
}
std::vector<Shared> fewShared() {
  return {{"volume_large", Arrangement::VolumeLarge},
          {"four_up_with_tool", Arrangement::FourUp, true},
          {"slices_large", Arrangement::SlicesLarge},
          {"one_0", Arrangement::One},
          {"maximised_3", Arrangement::FourUp, false, true, 3}};
}

/// A window with words in all places: measures, a tool that touches, the force's card, sentences.
struct Worded {
  ui::MainWindow window;
  app::SharedState shared;
  app::PictureController picture{window.views(), window.touch(), shared};
  ui::Measures measures;
  SeenByOverlays seen{measures};
  ui::Banner found{ui::Banner::Kind::Question, "found"};

  Worded(const ui::Picture& of, bool german) {
    ui::Views& views = window.views();
    views.volume().setSurfaceWish(ui::SurfaceMode::Mesh);
    window.show(of, 300.0, "Head");
    views.show(window::octahedron(0.006));
    views.addOverlay(seen);
    views.addOverlay(measures);
    measures.setScan({.grid = of.volume->grid});
    const Vec3 c = views.cross_mm();
    measures.replace(
        {{ui::MeasureKind::Distance, "Distance 1", {c + Vec3{-20, 0, 0}, c + Vec3{25, 1, 1}}},
         {ui::MeasureKind::Angle,
          "Angle 1",
          {c + Vec3{0, 10, 0}, c + Vec3{2, 20, 0}, c + Vec3{30, 30, 0}}},
         {ui::MeasureKind::Note, "here", {c}}});
    window.addOverView(found);
    found.setSentence(german ? "Tisch und Kopfhalterung gefunden" : "Table and head holder found");
    for (const char* button : {"Entfernen", "Zeigen", "Behalten"})
      found.addButton("foundButton")->setText(button);
    window.touch().setHand("omega.6", ui::Feel::Felt);
    put({0.0, -0.095, 0.0});
    // a window of this size on most screens
    window::showAndWait(window, {1280, 840});
  }
  ~Worded() { found.setParent(nullptr); }

  /// The tool is at a place [m] and touches; the device is ready, which a sentence says.
  void put(const Vec3& p_W) {
    haptics::Snapshot snapshot;
    snapshot.policy = haptics::SchedulingPolicy::Ordinary;
    snapshot.force_state = haptics::ForceState::Ready;
    snapshot.contacts = 1;
    snapshot.X_WP.translation() = p_W;
    snapshot.X_WD = snapshot.X_WP;
    window.touch().display(snapshot);
    window.views().slices().setFollowing(false);
    // not as often as poses come
    waitFor(
        [&] {
          window.views().display(snapshot);
          QTest::qWait(20);
          return !cardIsOnTool();
        },
        1.0);
  }
  QRect inSpace(const QWidget& part) {
    return {window.views().volume().mapFrom(&window, part.mapTo(&window, QPoint{})), part.size()};
  }
  QWidget& card() { return *window.findChild<ui::ForcePanel*>("forceCard"); }
  bool cardIsOnTool() { return window.views().volume().isToolIn(inSpace(card())); }

  void share(const Shared& as) {
    ui::Views& views = window.views();
    ui::ViewLayout& layout = views.layout();
    views.slices().setObliqueShown(as.tool_view);
    layout.arrange(as.arrangement);
    while (layout.active() != as.alone) layout.nextView();
    if (as.maximised) layout.toggleMaximised();
    QTest::qWait(20);
  }
};

class Words : public testing::Test {
 protected:
  ~Words() override { ui::style::applyTheme(*qApp, Theme::Dark); }

  static void expectApart(const std::shared_ptr<const haptics::Volume>& volume, const char* name,
                          const std::vector<Theme>& themes, const std::vector<Shared>& shared);
  static int expectApartIn(ui::SliceView& view, const haptics::Volume& volume,
                           const SeenByOverlays& seen);
  static int expectApartInSpace(Worded& worded, bool at_first);
};

/// All layouts and themes, for every release, since they take minutes.
class EveryWord : public Words {};

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

/// `at_first`: the camera is where it was when the scan was opened, and nothing is written over the
/// body but the card, which moves away, and sentences.
int Words::expectApartInSpace(Worded& worded, bool at_first) {
  ui::VolumeView& view = worded.window.views().volume();
  std::vector<WordBox> boxes;
  for (const QRectF& box : view.wordBoxes()) boxes.push_back({"letters or cube", box});
  const std::size_t letters = boxes.size();
  boxes.front().what = "cube";
  for (const ui::MeasureLabel& label : worded.seen.labels[&view])
    boxes.push_back({label.text.toStdString(), label.box});
  const std::size_t labels = boxes.size();
  if (worded.card().isVisible()) {
    boxes.push_back({"card", worded.inSpace(worded.card())});
    EXPECT_FALSE(worded.cardIsOnTool());
  }
  for (const auto* banner : worded.window.findChildren<ui::Banner*>())
    if (banner->isVisible() && worded.inSpace(*banner).intersects(view.rect()))
      boxes.push_back({banner == &worded.found ? "offer" : "sentence", worded.inSpace(*banner)});
  const auto* pointed = view.parentWidget()->findChild<QLabel*>("pointed");
  emit view.pointedChanged("1480 HU   L 102.4  P 113.5  S 108.2 mm   Facial nerve, canal");
  EXPECT_TRUE(pointed->isVisible());
  const QRectF plate = worded.inSpace(*pointed);
  EXPECT_TRUE(view.rect().contains(plate.toRect()));
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    // over labels it lies as long as the pointer is on the surface
    if (i < letters || i >= labels)
      EXPECT_FALSE(boxes[i].box.intersects(plate)) << boxes[i].what << " and value";
    for (std::size_t j = i + 1; j < boxes.size(); ++j)
      EXPECT_FALSE(boxes[i].box.intersects(boxes[j].box))
          << boxes[i].what << " and " << boxes[j].what;
    if (i < labels) EXPECT_TRUE(QRectF(view.rect()).contains(boxes[i].box)) << boxes[i].what;
    // near the eye handles are anywhere, and letters and card give way to other things
    if (at_first || (i >= letters && i < labels))
      for (const QPointF& p : worded.seen.handles[&view])
        EXPECT_FALSE(boxes[i].box.adjusted(-5, -5, 5, 5).contains(p)) << boxes[i].what;
  }
  emit view.pointedChanged({});
  if (at_first)
    for (const Vec3& p_mm : drawnSurface_mm(view)) {
      const QPointF p = view.projected(p_mm * 1e-3);
      for (std::size_t i = 1; i < labels; ++i)
        if (boxes[i].box.contains(p)) {
          ADD_FAILURE() << boxes[i].what << " is over the body";
          return 0;
        }
    }
  return static_cast<int>(boxes.size());
}

void Words::expectApart(const std::shared_ptr<const haptics::Volume>& volume, const char* name,
                        const std::vector<Theme>& themes, const std::vector<Shared>& shared) {
  ASSERT_TRUE(volume);
  const ui::Picture picture = ui::pictureOf(volume);
  int boxes = 0;
  for (const char* language : {"en", "de"}) {
    ui::setLanguage(language);
    int shown = language == std::string_view("de") ? 1 : 0;
    Worded worded(picture, language == std::string_view("de"));
    ui::Views& views = worded.window.views();
    for (const Theme theme : themes) {
      ui::style::applyTheme(*qApp, theme);
      for (const Shared& as : shared) {
        SCOPED_TRACE(std::string(name) + ", " + language + ", " +
                     ui::style::nameOf(theme).toStdString() + ", " + as.words);
        worded.found.setVisible(++shown % 2 == 0);  // in each layout in one of the languages
        worded.share(as);
        const QImage image = window::pictureOf(worded.window);
        for (ui::SliceView* slice : views.slices().slices()) {
          if (!slice->isVisible()) continue;
          SCOPED_TRACE(slice->readout().name.toStdString());
          boxes += expectApartIn(*slice, *volume, worded.seen);
          for (const auto* banner : worded.window.findChildren<ui::Banner*>())
            EXPECT_FALSE(banner->isVisible() &&
                         worded.inSpace(*banner).intersects(worded.inSpace(*slice)));
          if (slice->plane() == Plane::Oblique) continue;
          // the body fills it: one of its sides is near the edges of the picture
          const Eigen::AlignedBox3d& body = picture.body_mm;
          const QRectF shown =
              QRectF(slice->projected(body.min()), slice->projected(body.max())).normalized();
          const QRectF room = slice->pictureRect();
          EXPECT_GT(std::max(shown.width() / room.width(), shown.height() / room.height()), 0.9);
          EXPECT_TRUE(room.adjusted(-1, -1, 1, 1).contains(shown));
        }
        if (views.volume().isVisible()) boxes += expectApartInSpace(worded, true);
        if (theme == themes.front()) {
          const std::string words = std::string("words_") + name + "_" + language + "_" + as.words;
          window::keep(image, words.c_str());
          // a picture of the window is without what is painted over the 3-D view
          if (views.volume().isVisible())
            window::keep(views.volume().grabFramebuffer(), (words + "_space").c_str());
        }
        if (HasFailure()) return;
      }
    }
  }
  EXPECT_GT(boxes, 15 * static_cast<int>(themes.size() * shared.size()));
}

TEST_F(Words, StandOverNoBodyNoHandleAndNoOtherWords) {
  expectApart(madeHead(), "made", {Theme::Dark}, fewShared());
}

// Near the eye the body is everywhere, so words stand on plates, and the tool comes anywhere.
TEST_F(Words, KeepApartAroundToolAndCardAndStandOnPlatesWhereTheBodyFillsTheView) {
  Worded worded(ui::pictureOf(madeHead()), false);
  ui::VolumeView& view = worded.window.views().volume();
  view.camera()->Zoom(4.0);
  for (const Arrangement arrangement : {Arrangement::VolumeLarge, Arrangement::FourUp}) {
    worded.share({"", arrangement});
    const Vec3 focus = Vec3{view.camera()->GetFocalPoint()} * 1e-3;
    const Eigen::Matrix3d axes = view.viewAxes();
    const double px_per_m =
        1e3 * (view.projected(focus + axes.col(0) * 1e-3).x() - view.projected(focus).x());
    for (const QPointF at : {QPointF(view.width() - 60.0, view.height() - 60.0),
                             QPointF(60.0, view.height() - 60.0), QPointF(view.rect().center())}) {
      SCOPED_TRACE(testing::Message() << at.x() << ' ' << at.y());
      const QPointF by = (at - view.projected(focus)) / px_per_m;
      worded.put(focus + axes.col(0) * by.x() - axes.col(1) * by.y());
      window::pictureOf(worded.window);
      expectApartInSpace(worded, false);
    }
    const QImage image = view.picture(1.0);
    window::keep(image, "words_plates");
    for (const QRectF& box : view.wordBoxes())
      if (box.height() < 40.0) {
        EXPECT_EQ(image.pixelColor(QPointF(box.left() + 1.5, box.center().y()).toPoint()),
                  ui::style::kViewGround);
      }
  }
}

TEST_F(EveryWord, StandsOverNoBodyNoHandleAndNoOtherWords) {
  expectApart(madeHead(), "every", {Theme::Dark, Theme::Light, Theme::HighContrast}, allShared());
}

std::shared_ptr<const haptics::Volume> realHead() {
  const std::filesystem::path place =
      places::scan("visible_human_female_head/vhf_head_512x512x234.nrrd");
  if (!std::filesystem::exists(place)) return nullptr;
  auto volume = datasets::readVolume(place);
  EXPECT_TRUE(volume) << sentence(volume.error());
  return volume ? std::make_shared<const haptics::Volume>(std::move(*volume)) : nullptr;
}

TEST_F(Words, StandOverNoBodyInARealScanEither) {
  const auto head = realHead();
  if (head == nullptr) GTEST_SKIP() << "the head is not there";
  expectApart(head, "real", {Theme::Dark}, {{"four_up", Arrangement::FourUp}});
}

TEST_F(EveryWord, StandsOverNoBodyInARealScanEither) {
  const auto head = realHead();
  if (head == nullptr) GTEST_SKIP() << "the head is not there";
  expectApart(head, "every_real", {Theme::Dark}, allShared());
}

}  // namespace
