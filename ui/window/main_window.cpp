// SPDX-License-Identifier: BSD-3-Clause
#include "ui/window/main_window.h"

#include <QAction>
#include <QCloseEvent>
#include <QDragEnterEvent>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QMimeData>
#include <QSplitter>
#include <QStatusBar>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <vector>

#include "ui/controls/bindings.h"
#include "ui/controls/latin_key.h"
#include "ui/panels/isosurface_panel.h"
#include "ui/panels/replay_bar.h"
#include "ui/panels/status_line.h"
#include "ui/style/style.h"
#include "ui/views/volume_view.h"
#include "ui/window/banner.h"
#include "ui/window/drop_area.h"
#include "ui/window/escape_filter.h"
#include "ui/window/loading.h"
#include "ui/window/menus.h"
#include "ui/window/messages.h"
#include "ui/window/side_panel.h"
#include "ui/window/start_page.h"
#include "ui/window/tab_order.h"
#include "ui/window/top_bar.h"
#include "ui/window/touch_state.h"
#include "ui/window/tour.h"
#include "ui/window/view_layout.h"
#include "ui/window/views.h"

namespace ui {
namespace {

constexpr int kFrame = 40;  // px that a desktop takes for the title of a window
// px of the 3-D view that stay in sight beside a sentence over it
constexpr int kTopOfView = 36;  // a letter and a button
constexpr int kCube = 100;      // the cube, at the right
constexpr int kBelowCube = 108;
constexpr int kLowView = 350;  // below that handles of marks may be anywhere beside it

QString sizeWords(const haptics::Volume& volume) {
  const auto& dims = volume.grid.dims;
  const haptics::Vec3 mm = volume.grid.spacing * 1e3;
  return MainWindow::tr("%1 × %2 × %3 voxels · %L4 × %L5 × %L6 mm")
      .arg(dims[0])
      .arg(dims[1])
      .arg(dims[2])
      .arg(mm.x(), 0, 'g', 3)
      .arg(mm.y(), 0, 'g', 3)
      .arg(mm.z(), 0, 'g', 3);
}

}  // namespace

MainWindow::MainWindow(QWidget* parent)
    : QMainWindow(parent),
      views_(new Views(this)),
      start_(new StartPage),
      replay_(new ReplayBar),
      bar_(new TopBar),
      messages_(new Messages(*this)),
      loading_(new Loading(*start_)),
      status_(new StatusLine),
      stopped_(new Banner(Banner::Kind::Stopped, "stopped")),
      above_(new QWidget),
      touch_(new TouchState(*bar_, *stopped_, *status_)),
      escape_(new EscapeFilter(*this)),
      menus_(new Menus(*this, *bar_, *views_)),
      panels_(new SidePanel(menus_->view())),
      splitter_(new QSplitter),
      scan_line_(new ScanLine),
      graphics_(new QLabel),
      details_(new QToolButton),
      tour_(new Tour(*this)),
      drop_(new DropArea(this)) {
  setWindowTitle(QStringLiteral("Palpate"));
  setWindowIcon(QIcon(QStringLiteral(":/icons/palpate.svg")));
  setAcceptDrops(true);
  touch_->setParent(this);
  buildViews();
  buildStartPage();
  buildStatusBar();
  new LatinShortcuts(this);
  // motors stop whatever else it closes; what is only shown stays while there is something to close
  connect(escape_, &EscapeFilter::pressed, touch_, [this](bool closes) {
    if (!closes || touch_->hasMotors()) touch_->stop(tr("Force stopped by Escape"));
  });
  escape_->addEnder(*this, [this] { return tour_->close(); });
  connect(panels_, &SidePanel::changed, this, &MainWindow::layoutChanged);
  connect(views_, &Views::cardFoldedChanged, this, &MainWindow::layoutChanged);
  connect(tour_, &Tour::ended, this, &MainWindow::tourEnded);
  connect(menus_, &Menus::tourWanted, this, &MainWindow::showTour);
  connect(menus_, &Menus::layoutResetWanted, this, [this] {
    resetLayout();
    emit layoutChanged();
  });
  views_->volume().setFocus();  // where Space stops the force
  // with its frame on a small screen, too
  resize(QSize(1280, 840).boundedTo(screen()->availableSize() - QSize(0, kFrame)));
}

void MainWindow::buildViews() {
  auto* right = new QWidget;
  auto* column = new QVBoxLayout(right);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(above_);
  messages_->placeIn(*column);
  // in the same place: the page covers the views until there is something to see
  auto* views = new QGridLayout;
  views->addWidget(&views_->layout(), 0, 0);
  views->addWidget(start_, 0, 0);
  start_->raise();
  start_->hide();  // until someone fills it
  for (QWidget* moved :
       {static_cast<QWidget*>(&views_->volume()), views_->volume().parentWidget(), above_})
    moved->installEventFilter(this);
  column->addLayout(views, 1);
  column->addWidget(replay_);
  replay_->setObjectName("replayBar");
  replay_->hide();
  splitter_->setObjectName("panelSplitter");
  splitter_->setChildrenCollapsible(false);
  splitter_->addWidget(panels_);
  splitter_->addWidget(right);
  splitter_->setStretchFactor(0, 0);
  splitter_->setStretchFactor(1, 1);
  splitter_->setSizes({style::kPanelWidth, 4 * style::kPanelWidth});
  auto* row = new QHBoxLayout;
  row->setSpacing(0);
  row->addWidget(&panels_->rail());
  row->addWidget(splitter_, 1);
  auto* centre = new QWidget;
  auto* all = new QVBoxLayout(centre);
  all->setContentsMargins(0, 0, 0, 0);
  all->setSpacing(0);
  all->addWidget(bar_);
  all->addLayout(row, 1);
  setCentralWidget(centre);
  addOverView(*stopped_);
  connect(&views_->volume(), &VolumeView::forceOffWanted, touch_,
          [this] { touch_->stop(tr("Force stopped by Space")); });
  connect(&views_->volume(), &VolumeView::surfaceChosen, this, [this](const SurfaceChoice& choice) {
    status_->setSurface(choice);
    graphics_->setText(choice.mode == SurfaceMode::Mesh ? tr("Mesh: %1").arg(choice.reason)
                                                        : QString());
  });
}

void MainWindow::buildStartPage() {
  const auto triggers = [this](void (StartPage::*wish)(), const char* action) {
    connect(start_, wish, findChild<QAction*>(action), &QAction::trigger);
  };
  triggers(&StartPage::fileWanted, "openFile");
  triggers(&StartPage::folderWanted, "openFolder");
  connect(start_, &StartPage::demoWanted, menus_,
          [this] { emit menus_->phantomWanted(QStringLiteral("demo")); });
  connect(start_, &StartPage::placeWanted, menus_, &Menus::openWanted);
}

void MainWindow::showTour() {
  std::vector<TourStep> steps;
  const auto add = [&](QWidget* target, const QString& title, const QString& sentence,
                       std::function<void()> revealed = {}) {
    if (target != nullptr) steps.push_back({target, title, sentence, std::move(revealed)});
  };
  add(findChild<QToolButton*>("openFolderButton"), tr("Open a scan"),
      tr("Here, with File > Open file, or by dropping it on the window. Left and right come from "
         "the file."));
  // of an empty window there is nothing else to tell
  if (start_->isHidden()) {
    auto* surface = findChild<IsosurfacePanel*>();
    // the user may have gone to another tab meanwhile
    if (surface != nullptr)
      add(surface->findChild<HistogramSlider*>(), tr("Choose the surface"),
          tr("Drag the line: the surface is where the scan has this value. Picture and touch "
             "change at once."),
          [this, surface] { panels_->reveal(surface); });
    add(&views_->volume(), tr("Touch it"),
        tr("Press %1 and the mouse holds the tool, or drag the tool itself. The tool stops at the "
           "surface, and the card shows the force. Escape stops the force at any time.")
            .arg(keyOf(Action::TakeTool)));
  }
  tour_->begin(std::move(steps));
}

WindowLayout MainWindow::layoutState() const {
  return {.views = views_->state(),
          .borders = views_->layout().borders(),
          .panels = panels_->state(),
          .panel_width = splitter_->sizes().value(0),
          .details = details_->isChecked()};
}

void MainWindow::restoreLayout(const WindowLayout& layout) {
  views_->restore(layout.views);
  views_->layout().restoreBorders(layout.borders);
  panels_->restore(layout.panels);
  if (layout.panel_width > 0)
    splitter_->setSizes({layout.panel_width, std::max(1, splitter_->width() - layout.panel_width)});
  details_->setChecked(layout.details);
}

void MainWindow::resetLayout() {
  views_->reset();
  panels_->reset();
  restoreLayout({.views = {}, .borders = {}, .panels = {}, .panel_width = style::kPanelWidth});
}

bool MainWindow::focusNextPrevChild(bool next) {
  // Qt goes in the order in which widgets were made
  std::vector<QWidget*> stops;
  for (QWidget* part :
       {centralWidget(), static_cast<QWidget*>(statusBar()), static_cast<QWidget*>(tour_)})
    for (QWidget* stop : tabStopsOf(*part)) stops.push_back(stop);
  QWidget* stop = nextTabStop(stops, next);
  if (stop == nullptr) return false;
  stop->setFocus(next ? Qt::TabFocusReason : Qt::BacktabFocusReason);
  return true;
}

void MainWindow::buildStatusBar() {
  auto* notice = new QLabel(tr("Not a medical device. Not for treatment."));
  for (QLabel* label :
       {notice, static_cast<QLabel*>(scan_line_), graphics_, static_cast<QLabel*>(status_)})
    style::setDim(*label);
  notice->setContentsMargins(style::kGap, 0, style::kGap, 0);
  graphics_->setContentsMargins(0, 0, style::kGap, 0);
  status_->hide();
  details_->setObjectName("details");
  details_->setText(tr("Details"));
  details_->setToolTip(tr("Figures of the servo loop: rate, time of a tick, late ticks"));
  details_->setCheckable(true);
  details_->setAutoRaise(true);
  connect(details_, &QToolButton::toggled, status_, &QWidget::setVisible);
  connect(details_, &QToolButton::toggled, scan_line_, &QWidget::setHidden);
  connect(details_, &QToolButton::clicked, this, &MainWindow::layoutChanged);
  statusBar()->setSizeGripEnabled(false);
  statusBar()->addWidget(notice);
  statusBar()->addWidget(scan_line_, 1);
  statusBar()->addWidget(status_, 1);
  statusBar()->addPermanentWidget(loading_);
  statusBar()->addPermanentWidget(graphics_);
  statusBar()->addPermanentWidget(details_);
}

void MainWindow::show(const Picture& picture, double isovalue, const QString& title,
                      const std::vector<GreyPreset>& stated) {
  if (!start_->isHidden()) {
    start_->hide();
    views_->layout().setEnabled(true);
    views_->volume().setFocus();  // where Space stops the force
  }
  views_->show(picture, isovalue, stated);
  title_ = title;
  edited_ = false;
  scan_line_->setScan(title, sizeWords(*picture.volume));
  showTitle();
}

void MainWindow::setEdited(bool edited) {
  edited_ = edited;
  menus_->setEdited(edited);
  showTitle();
}

void MainWindow::showTitle() {
  const QString title = edited_ ? tr("%1 (edited)").arg(title_) : title_;
  setWindowTitle(title.isEmpty() ? QStringLiteral("Palpate") : tr("%1 — Palpate").arg(title));
}

bool MainWindow::eventFilter(QObject* watched, QEvent* event) {
  switch (event->type()) {
    case QEvent::Resize:
    case QEvent::Move:
    case QEvent::Show:
    case QEvent::Hide:
    case QEvent::LayoutRequest:
      placeOverView();
      break;
    default:
      break;
  }
  return QMainWindow::eventFilter(watched, event);
}

void MainWindow::addOverView(Banner& banner) {
  banner.setParent(splitter_->widget(1));
  banner.installEventFilter(this);
  over_view_.push_back(&banner);
}

/// Over the upper third of the 3-D view: beside its cube, or below it where it is narrow. Without
/// room for that they stand above the views; why there is no force moves them only where the view
/// is low.
void MainWindow::placeOverView() {
  const QWidget& volume = views_->volume();
  QList<QRect> covered;
  int top = kTopOfView, height_above = 0;
  for (Banner* banner : over_view_) {
    if (banner->isHidden()) continue;
    const auto holds = [&](int width, bool stacked) {
      return volume.isVisibleTo(this) && banner->leastWidth(stacked) <= width;
    };
    const bool beside = holds(volume.width() - kCube, true);
    const bool stacked = !holds(volume.width() - kCube, false);
    int width = beside ? volume.width() - kCube : volume.width();
    const int from = beside ? top : std::max(top, kBelowCube);
    const int height = banner->heightIf(stacked, width);
    const bool low =
        banner == stopped_ ? volume.height() < kLowView : from + height > volume.height() / 3;
    const bool above = low || !holds(width, true);
    banner->setStacked(stacked && !above);
    QRect place(volume.mapTo(banner->parentWidget(), QPoint{0, from}), QSize(width, height));
    if (above) {
      width = above_->width();
      place = QRect(0, height_above, width, banner->heightIf(false, width));
      height_above += place.height();
    } else {
      top = from + place.height() + style::kStep;
      covered << QRect(volume.mapFrom(this, banner->parentWidget()->mapTo(this, place.topLeft())),
                       place.size());
    }
    if (banner->geometry() == place) continue;
    banner->setGeometry(place);
    banner->raise();
  }
  above_->setFixedHeight(height_above);
  views_->setSentences(covered);
}

void MainWindow::closeEvent(QCloseEvent* event) {
  const auto guard = close_guard_;
  // a guard that is gone meanwhile was overtaken by an end that asks nobody
  if (guard && !guard() && close_guard_) return event->ignore();
  emit closing();
  event->accept();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (!event->mimeData()->hasUrls()) return;
  event->acceptProposedAction();
  drop_->cover(*centralWidget());
}

void MainWindow::dragLeaveEvent(QDragLeaveEvent*) { drop_->hide(); }

void MainWindow::dropEvent(QDropEvent* event) {
  drop_->hide();
  QStringList paths;
  for (const QUrl& url : event->mimeData()->urls())
    if (url.isLocalFile()) paths << url.toLocalFile();
  if (paths.isEmpty())
    return messages_->showMessage(
        tr("The dropped item is not on this machine's disks; copy it there first."));
  event->acceptProposedAction();
  emit dropped(paths);
}

}  // namespace ui
