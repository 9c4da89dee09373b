// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/views/marks_controller.h"

#include <QAction>
#include <QApplication>
#include <QMenu>
#include <QTimer>
#include <algorithm>

#include "app/log/log.h"
#include "app/recording/recording.h"
#include "app/window/scan/edited_volume.h"
#include "app/window/scan/touched_surface.h"
#include "ui/controls/lengths.h"
#include "ui/panels/marks_panel.h"

namespace app {
namespace {

constexpr qint64 kWayMs = 100;
constexpr std::size_t kMostKept = 20;

QString lengthWords(double metres) {
  return ui::numberWords(metres * ui::kMmPerM / ui::mmPerLengthUnit(), ui::lengthDecimals(1)) +
         QChar(QChar::Nbsp) + ui::lengthUnitName();
}

/// What is known of a scan without its voxels.
haptics::Volume factsOf(const haptics::Volume& scan) {
  haptics::Volume facts;
  facts.grid = scan.grid;
  facts.type = scan.type;
  facts.least = scan.least;
  facts.greatest = scan.greatest;
  return facts;
}

}  // namespace

MarksController::MarksController(ui::Views& views, ui::Menus& menus, ui::SidePanel& panels,
                                 ui::TopBar& bar, ui::EscapeFilter& escape, SharedState& shared)
    : views_(views), panels_(panels), shared_(shared), panel_(new ui::MarksPanel) {
  panels.add(panel_, tr("Measures and marks"), tr("&Measures and marks"), "marksSection",
             ui::Tab::Scan);
  views.addOverlay(measures_);
  for (const ui::MeasureKind kind : ui::kMeasureKinds) views.addAction(*panel_->placeAction(kind));
  bar.add(ui::BarGroup::Tools, *panel_->placeAction(ui::MeasureKind::Distance), "distance");
  buildMenu(menus.addMenu(tr("&Measure")));
  connectPanel();
  escape.addEnder(*this, [this] {
    const bool placing = measures_.placing().has_value();
    if (placing) measures_.setPlacing({});
    return placing;
  });
  ui::whenLengthUnitChanges(*this, [this] {
    if (way_ && way_->begun()) showWay();
  });
}

void MarksController::buildMenu(QMenu& menu) {
  menu.setToolTipsVisible(true);
  for (const ui::MeasureKind kind : ui::kMeasureKinds) menu.addAction(panel_->placeAction(kind));
  menu.addSeparator();
  menu.addAction(tr("&Way of the tool from here"), this, [this] { measureWay(true); });
}

void MarksController::connectPanel() {
  using ui::MarksPanel;
  using ui::Measures;
  connect(panel_, &MarksPanel::placingWanted, &measures_, [this](int kind) {
    measures_.setPlacing(kind < 0 ? std::nullopt
                                  : std::optional{static_cast<ui::MeasureKind>(kind)});
  });
  connect(panel_, &MarksPanel::selected, &measures_, &Measures::select);
  connect(panel_, &MarksPanel::renamed, &measures_, &Measures::rename);
  connect(panel_, &MarksPanel::removeWanted, &measures_, &Measures::remove);
  connect(panel_, &MarksPanel::restoreWanted, &measures_, &Measures::restore);
  connect(panel_, &MarksPanel::goToWanted, this, &MarksController::goTo);
  connect(panel_, &MarksPanel::travelWanted, this, &MarksController::measureWay);
  connect(&measures_, &Measures::listChanged, this, &MarksController::showList);
  connect(&measures_, &Measures::selectionChanged, panel_, &MarksPanel::select);
  connect(&measures_, &Measures::placingChanged, panel_, &MarksPanel::showPlacing);
  connect(&measures_, &Measures::placed, this, [this](int index) {
    log::write(log::Level::Info, "mark-placed");
    if (measures_.all()[static_cast<std::size_t>(index)].kind != ui::MeasureKind::Note) return;
    // its words are typed in the list
    noted_in_ = QApplication::focusWidget();
    panels_.reveal(panel_);
    panel_->edit(index);
  });
  // then the view has the keys again; not before the list has dealt with the key
  connect(panel_, &MarksPanel::typed, this, [this] {
    QTimer::singleShot(0, this, [this] {
      const QWidget* focus = QApplication::focusWidget();
      if (noted_in_ && focus != nullptr && panel_->isAncestorOf(focus)) noted_in_->setFocus();
      noted_in_ = nullptr;
    });
  });
}

void MarksController::showScene() {
  if (!shared_.shown) return;
  const Loaded& shown = *shared_.shown;
  const auto scan = scanOf(shown.volume());
  if (!marked_ || marked_->scan.lock() != scan) {
    if (marked_ && !measures_.all().empty()) {
      marked_->measures = measures_.all();
      kept_.push_back(std::move(*marked_));
      if (kept_.size() > kMostKept) kept_.erase(kept_.begin());
    }
    marked_ = Marked{shown.place, shown.title, factsOf(*scan), scan};
    measures_.clear();
    measureWay(false);
    const auto before = std::find_if(kept_.begin(), kept_.end(), [&](const Marked& kept) {
      return kept.place == shown.place && kept.title == shown.title &&
             liesLike(kept.facts, *scan) && kept.facts.least == scan->least &&
             kept.facts.greatest == scan->greatest;
    });
    if (before != kept_.end()) {
      measures_.replace(std::move(before->measures));
      marked_->saved = std::move(before->saved);
      kept_.erase(before);
    }
  }
  measures_.setScan(
      {.grid = scan->grid,
       .unit = QString::fromStdString(scan->unit),
       .value = [touched = touchedSurfaceOf(shown.seenScene())](const Eigen::Vector3d& p_mm) {
         return touched.value(p_mm / ui::kMmPerM);
       }});
  panel_->setReady(true);
}

void MarksController::setSaved(std::vector<ui::Measure> marks) {
  if (marked_) marked_->saved = std::move(marks);
}

bool MarksController::areUnsaved() const {
  return marked_ && !measures_.all().empty() && measures_.all() != marked_->saved;
}

int MarksController::scansUnsaved() const {
  return static_cast<int>(
      std::ranges::count_if(kept_, [](const Marked& kept) { return kept.measures != kept.saved; }));
}

void MarksController::showList() {
  QList<ui::MarkRow> rows;
  for (const ui::Measure& measure : measures_.all())
    rows.append({QString::fromStdString(measure.text), ui::valueOf(measure, measures_.scan())});
  panel_->show(rows);
  panel_->setCanRestore(measures_.canRestore());
}

void MarksController::goTo(int index) {
  if (index < 0 || index >= static_cast<int>(measures_.all().size())) return;
  const auto& places = measures_.all()[static_cast<std::size_t>(index)].places_mm;
  // again: the next end of a distance, say
  const std::size_t place = gone_to_.first == index ? (gone_to_.second + 1) % places.size() : 0;
  gone_to_ = {index, place};
  measures_.select(index);
  views_.setCross(places[place]);
}

void MarksController::measureWay(bool measure) {
  way_.reset();
  if (measure && shared_.shown) way_.emplace();
  way_scene_ = 0;
  length_shown_ = -1.0;
  since_shown_.invalidate();
  if (way_)
    refresh();
  else
    measures_.setTravel({});
  if (!way_ || !way_->begun())
    panel_->showTravel(way_ ? std::optional{tr("Waiting for the tool.")} : std::nullopt);
}

void MarksController::refresh() {
  if (!way_) return;
  const haptics::Snapshot& snapshot = shared_.snapshot;
  const bool live =
      shared_.shown && !shared_.replaying && snapshot.scene == shared_.shown->scene->id;
  // another scene, or another hand whose ticks begin anew
  if (!live || snapshot.scene != way_scene_ || snapshot.tick < way_tick_) way_->jump();
  if (!live) return;
  way_scene_ = snapshot.scene;
  way_tick_ = snapshot.tick;
  way_->add(snapshot.X_WP.translation());
  if (since_shown_.isValid() && since_shown_.elapsed() < kWayMs) return;
  const bool moved =
      way_->length() != length_shown_ || (way_->here() - way_shown_).norm() >= ToolWay::kStep;
  if (moved) showWay();
}

void MarksController::showWay() {
  since_shown_.start();
  length_shown_ = way_->length();
  way_shown_ = way_->here();
  measures_.setTravel(ui::Travel{.from_mm = way_->from() * ui::kMmPerM,
                                 .to_mm = way_->here() * ui::kMmPerM,
                                 .length_mm = way_->length() * ui::kMmPerM});
  panel_->showTravel(tr("The tool has travelled %1 since the start, %2 in a straight line.")
                         .arg(lengthWords(way_->length()), lengthWords(way_->straight())));
}

}  // namespace app
