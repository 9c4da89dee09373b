// SPDX-License-Identifier: BSD-3-Clause
#include "ui/main_window.h"

#include <QAction>
#include <QApplication>
#include <QCloseEvent>
#include <QDragEnterEvent>
#include <QFrame>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QMessageBox>
#include <QMimeData>
#include <QProgressBar>
#include <QPushButton>
#include <QSplitter>
#include <QStatusBar>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <vector>

#include "ui/banner.h"
#include "ui/bindings.h"
#include "ui/escape_filter.h"
#include "ui/latin_key.h"
#include "ui/panels/force_panel.h"
#include "ui/panels/isosurface_panel.h"
#include "ui/panels/replay_bar.h"
#include "ui/panels/status_line.h"
#include "ui/plane_colours.h"
#include "ui/start_page.h"
#include "ui/state_chip.h"
#include "ui/style/scene_colours.h"
#include "ui/style/style.h"
#include "ui/tab_order.h"
#include "ui/tour.h"
#include "ui/view_actions.h"
#include "ui/view_frame.h"
#include "ui/volume_view.h"

namespace ui {
namespace {

constexpr int kFrame = 40;     // px that a desktop takes for the title of a window
constexpr int kWordsMs = 100;  // between two changes of force and status in words

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
      view_(new VolumeView),
      slice_set_(new SliceSet(this)),
      slices_(slice_set_->slices()),
      start_(new StartPage),
      replay_(new ReplayBar),
      bar_(new TopBar),
      side_(new SidePanel),
      splitter_(new QSplitter),
      status_(new StatusLine),
      scan_line_(new QLabel),
      graphics_(new QLabel),
      details_(new QToolButton),
      fault_(new Banner(Banner::Kind::Fault, "fault")),
      message_(new Banner(Banner::Kind::Attention, "message")),
      done_(new Banner(Banner::Kind::Done, "done")),
      offer_(new Banner(Banner::Kind::Attention, "offer")),
      take_offer_(offer_->addButton("takeOffer")),
      stopped_(new Banner(Banner::Kind::Stopped, "stopped")),
      resume_(stopped_->addButton("forceOn")),
      loading_(new QFrame),
      loading_what_(new QLabel),
      progress_(new QProgressBar),
      tour_(new Tour(*this)) {
  setWindowTitle(QStringLiteral("Palpate"));
  setWindowIcon(QIcon(QStringLiteral(":/icons/palpate.svg")));
  setAcceptDrops(true);
  buildBanners();
  buildViews();
  buildMenus();
  buildStartPage();
  buildStatusBar();
  words_.setSingleShot(true);
  words_.setInterval(kWordsMs);
  connect(&words_, &QTimer::timeout, this, &MainWindow::displayWords);
  new LatinShortcuts(this);
  connect(new EscapeFilter(this), &EscapeFilter::pressed, this,
          [this] { stopForce(tr("Force stopped by Escape")); });
  connect(this, &MainWindow::forceOnWanted, this, [this] { stopped_by_.clear(); });
  connect(side_, &SidePanel::changed, this, &MainWindow::panelsChanged);
  connect(tour_, &Tour::ended, this, &MainWindow::tourEnded);
  bar_->force().show(Mark::Off, tr("Nothing to touch yet"));
  view_->setFocus();  // where Space stops the force
  // with its frame on a small screen, too
  resize(QSize(1280, 840).boundedTo(screen()->availableSize() - QSize(0, kFrame)));
}

void MainWindow::buildBanners() {
  connect(bar_, &TopBar::stopWanted, this, [this] { stopForce(tr("Force stopped")); });
  connect(resume_, &QPushButton::clicked, this, &MainWindow::forceOnWanted);
  resume_->setToolTip(tr("The force may come back: hold the handle"));
  more_of_fault_ = fault_->addButton("faultMore");
  more_of_message_ = message_->addButton("messageMore");
  for (QPushButton* more : {more_of_fault_, more_of_message_}) {
    more->setText(tr("More"));
    more->setToolTip(tr("Shows the cause and the remedy in the help"));
    connect(more, &QPushButton::clicked, this,
            [this, more] { emit helpWanted(more->property("place").toString()); });
  }
  fault_->addClose();
  message_->addClose();
  QPushButton* folder = done_->addButton("showInFolder");
  folder->setText(tr("Show in folder"));
  connect(folder, &QPushButton::clicked, this, [this] { emit folderWanted(done_folder_); });
  done_->addClose();
  connect(take_offer_, &QPushButton::clicked, this, [this] {
    offer_->hide();
    offered_();
  });
  offer_->addClose();
}

void MainWindow::buildViews() {
  ViewLayout::Frames frames{};
  frames[0] = new ViewFrame(view_, style::kViewFrame, false);
  frames[0]->setHint(view_->hint());
  connect(view_, &VolumeView::hintChanged, frames[0], &ViewFrame::setHint);
  for (SliceView* slice : slices_) {
    auto* frame = new ViewFrame(slice, colourOf(slice->plane()), true);
    frames[static_cast<std::size_t>(slice->plane()) + 1] = frame;
    frame->setHint(slice->hint());
    connect(slice, &SliceView::hintChanged, frame, &ViewFrame::setHint);
    connect(slice, &SliceView::toolToCrossWanted, this, &MainWindow::toolToCrossWanted);
    connect(slice, &SliceView::crossToToolWanted, this, &MainWindow::crossToToolWanted);
    connect(frame, &ViewFrame::menuWanted, this,
            [this, slice](QPoint at) { slice_set_->openMenu(*slice, at); });
  }
  for (const ViewFrame* frame : frames)
    connect(frame, &ViewFrame::hintsUnwanted, this, [this] { hints_->trigger(); });
  views_ = new ViewLayout(frames);
  connect(slice_set_, &SliceSet::obliqueShownChanged, views_, &ViewLayout::setObliqueShown);
  connect(slice_set_, &SliceSet::doubleClicked, this, [this](const Eigen::Vector3d& p_W_mm) {
    emit toolWanted(p_W_mm / kMmPerM, haptics::Vec3::Zero());
  });
  auto* right = new QWidget;
  auto* column = new QVBoxLayout(right);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(fault_);
  column->addWidget(stopped_);
  column->addWidget(message_);
  column->addWidget(done_);
  column->addWidget(offer_);
  // in the same place: the page covers the views until there is something to see
  auto* views = new QGridLayout;
  views->addWidget(views_, 0, 0);
  views->addWidget(start_, 0, 0);
  start_->raise();
  start_->hide();  // until someone fills it
  column->addLayout(views, 1);
  column->addWidget(replay_);
  replay_->setObjectName("replayBar");
  replay_->hide();
  splitter_->setObjectName("panelSplitter");
  splitter_->setChildrenCollapsible(false);
  splitter_->addWidget(side_);
  splitter_->addWidget(right);
  splitter_->setStretchFactor(0, 0);
  splitter_->setStretchFactor(1, 1);
  splitter_->setSizes({style::kPanelWidth, 4 * style::kPanelWidth});
  auto* row = new QHBoxLayout;
  row->setSpacing(0);
  row->addWidget(&side_->rail());
  row->addWidget(splitter_, 1);
  auto* centre = new QWidget;
  auto* all = new QVBoxLayout(centre);
  all->setContentsMargins(0, 0, 0, 0);
  all->setSpacing(0);
  all->addWidget(bar_);
  all->addLayout(row, 1);
  setCentralWidget(centre);

  view_->setObjectName("view");
  connect(view_, &VolumeView::forceOffWanted, this,
          [this] { stopForce(tr("Force stopped by Space")); });
  connect(view_, &VolumeView::toolWanted, this, &MainWindow::toolWanted);
  connect(view_, &VolumeView::toolToCrossWanted, this, &MainWindow::toolToCrossWanted);
  connect(view_, &VolumeView::crossToToolWanted, this, &MainWindow::crossToToolWanted);
  connect(view_, &VolumeView::surfaceChosen, this, [this](const SurfaceChoice& choice) {
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
  connect(start_, &StartPage::demoWanted, this, [this] { emit phantomWanted("demo"); });
  connect(start_, &StartPage::deviceWanted, this, &MainWindow::devicesWanted);
  connect(start_, &StartPage::placeWanted, this, &MainWindow::openWanted);
  connect(start_, &StartPage::cancelWanted, this, &MainWindow::cancelWanted);
}

void MainWindow::showTour() {
  std::vector<TourStep> steps;
  const auto add = [&](QWidget* target, const QString& title, const QString& sentence,
                       std::function<void()> revealed = {}) {
    if (target != nullptr) steps.push_back({target, title, sentence, std::move(revealed)});
  };
  add(findChild<QToolButton*>("openFileButton"), tr("Open a scan"),
      tr("Here, with File > Open folder, or by dropping it on the window. Left and right come from "
         "the file."));
  // of an empty window there is nothing else to tell
  if (start_->isHidden()) {
    auto* surface = findChild<IsosurfacePanel*>();
    // the user may have gone to another tab meanwhile
    if (surface != nullptr)
      add(surface->findChild<HistogramSlider*>(), tr("Choose the surface"),
          tr("Drag the line: the surface is where the scan has this value. Picture and touch "
             "change at once."),
          [this, surface] { reveal(surface); });
    add(view_, tr("Touch it"),
        tr("Press %1 and the mouse holds the tool, or drag the tool itself. The tool stops at the "
           "surface, and the card shows the force. Escape stops the force at any time.")
            .arg(keyOf(Action::TakeTool)));
  }
  tour_->begin(std::move(steps));
}

void MainWindow::addPanel(QWidget* panel, const QString& title, const QString& entry,
                          const char* name, Tab tab, Fold fold) {
  side_->add(panel, title, name, tab, fold);
  if (entry.isEmpty()) return;
  view_menu_->addAction(entry, panel, [this, panel] {
    reveal(panel);
    panel->setFocus();
  });
}

void MainWindow::setForceCard(ForcePanel& card) {
  static_cast<ViewFrame*>(view_->parentWidget())->setCard(card);
}

QString MainWindow::viewState() const {
  return ViewLayout::nameOf(views_->arrangement()) +
         (slice_set_->obliqueShown() ? QStringLiteral("+tool") : QString());
}

void MainWindow::restoreViews(const QString& state) {
  const auto arrangement = ViewLayout::arrangementOf(state.section('+', 0, 0));
  if (!arrangement) return;
  views_->arrange(*arrangement);
  slice_set_->setObliqueShown(state.section('+', 1) == QLatin1String("tool"));
}

WindowLayout MainWindow::layoutState() const {
  return {.views = viewState(),
          .borders = views_->borders(),
          .panels = side_->state(),
          .panel_width = splitter_->sizes().value(0),
          .details = details_->isChecked()};
}

void MainWindow::restoreLayout(const WindowLayout& layout) {
  restoreViews(layout.views);
  views_->restoreBorders(layout.borders);
  side_->restore(layout.panels);
  if (layout.panel_width > 0)
    splitter_->setSizes({layout.panel_width, std::max(1, splitter_->width() - layout.panel_width)});
  details_->setChecked(layout.details);
}

void MainWindow::resetLayout() {
  slice_set_->setObliqueShown(false);
  views_->reset();
  side_->reset();
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

void MainWindow::setMouse(const MouseChoices& mouse) {
  view_->setMouse(mouse);
  for (SliceView* slice : slices_) slice->setMouse(mouse);
}

void MainWindow::buildStatusBar() {
  auto* cancel = new QToolButton;
  cancel->setObjectName("cancelLoading");
  cancel->setText(tr("Cancel"));
  cancel->setToolTip(tr("Cancels the loading or the computation"));
  connect(cancel, &QToolButton::clicked, this, &MainWindow::cancelWanted);
  progress_->setRange(0, 1000);
  progress_->setMaximumWidth(180);
  auto* row = new QHBoxLayout(loading_);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(loading_what_);
  row->addWidget(progress_);
  row->addWidget(cancel);
  loading_->hide();
  auto* notice = new QLabel(tr("Not a medical device"));
  for (QLabel* label : {notice, scan_line_, graphics_, static_cast<QLabel*>(status_)})
    style::setDim(*label);
  notice->setContentsMargins(style::kGap, 0, style::kGap, 0);
  graphics_->setContentsMargins(0, 0, style::kGap, 0);
  scan_line_->setObjectName("scanLine");
  scan_line_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  status_->hide();
  details_->setObjectName("details");
  details_->setText(tr("Details"));
  details_->setToolTip(tr("Figures of the servo loop: rate, time of a tick, late ticks"));
  details_->setCheckable(true);
  details_->setAutoRaise(true);
  connect(details_, &QToolButton::toggled, status_, &QWidget::setVisible);
  connect(details_, &QToolButton::toggled, scan_line_, &QWidget::setHidden);
  connect(details_, &QToolButton::clicked, this, &MainWindow::panelsChanged);
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
    views_->setEnabled(true);
    view_->setFocus();  // where Space stops the force
  }
  view_->show(picture, isovalue);
  view_actions_->show(picture);
  slice_set_->show(picture, isovalue, stated);
  title_ = title;
  edited_ = false;
  scan_line_->setText(tr("%1 · %2").arg(title, sizeWords(*picture.volume)));
  showTitle();
}

void MainWindow::replace(const Picture& picture) {
  view_->replace(picture);
  slice_set_->replace(picture);
}

SliceView* MainWindow::activeSlice() const {
  return views_->active() == 0 ? nullptr : slices_[views_->active() - 1];
}

bool MainWindow::showsSlices() const {
  return std::any_of(slices_.begin(), slices_.end(),
                     [](const SliceView* slice) { return slice->isVisible(); });
}

void MainWindow::setEdited(bool edited) {
  edited_ = edited;
  save_edited_->setEnabled(edited);
  showTitle();
}

void MainWindow::showTitle() {
  const QString title = edited_ ? tr("%1 (edited)").arg(title_) : title_;
  setWindowTitle(title.isEmpty() ? QStringLiteral("Palpate") : tr("%1 — Palpate").arg(title));
}

void MainWindow::show(const haptics::TriangleMesh& tool) {
  view_->show(tool);
  slice_set_->show(tool);
}

void MainWindow::setIsovalue(double isovalue) {
  view_->setIsovalue(isovalue);
  slice_set_->setIsovalue(isovalue);
}

void MainWindow::setTouched(const TouchedSurface& touched) {
  view_->setTouched(touched);
  slice_set_->setTouched(touched);
}

void MainWindow::addOverlay(Overlay& overlay) {
  view_->addOverlay(overlay);
  slice_set_->addOverlay(overlay);
}

void MainWindow::addViewAction(QAction& action) {
  view_->addAction(&action);
  for (SliceView* slice : slices_) slice->addAction(&action);
}

ViewLook MainWindow::look() const {
  ViewLook look;
  view_->tell(look);
  look.colours = view_actions_->colours();
  look.second = view_->surface().second();
  slice_set_->tell(look);
  look.layout = views_->look();
  return look;
}

void MainWindow::setLook(const ViewLook& look) {
  view_->look(look);
  view_actions_->look(look);
  slice_set_->setObliqueShown(look.layout.tool_view);
  views_->look(look.layout);
  slice_set_->look(look);
}

void MainWindow::display(const haptics::Snapshot& snapshot) {
  view_->display(snapshot);
  slice_set_->display(snapshot);
  displayForce(snapshot);
}

void MainWindow::displayForce(const haptics::Snapshot& snapshot) {
  unsaid_ = snapshot;
  if (!words_.isActive()) displayWords();
  sayForce(snapshot);
}

void MainWindow::sayForce(const haptics::Snapshot& snapshot) {
  using haptics::ForceState;
  const ForceSaid said = stateOf(snapshot, feel_);
  bar_->force().show(said.mark, said.words);
  is_force_ = isForce(snapshot);
  bar_->stop().setForce(is_force_);
  // what the user can do about it: one button, in one place
  const bool live = snapshot.policy != haptics::SchedulingPolicy::NotStarted;
  const bool fault = snapshot.force_state == ForceState::Fault;
  const bool can = live && feel_ != Feel::Nothing &&
                   (snapshot.force_state == ForceState::Ready ||
                    (fault && snapshot.reason != haptics::ForceReason::Lost));
  if (can) {
    const bool stopped = !fault && !stopped_by_.isEmpty();
    stopped_->setSentence(stopped ? stopped_by_
                          : fault ? tr("The force is off after a fault")
                          : feel_ == Feel::Felt
                              ? tr("The device is ready: no force until you arm it")
                              : tr("The force is off"));
    resume_->setText(fault                             ? tr("Arm again")
                     : feel_ == Feel::Felt && !stopped ? tr("Arm")
                                                       : tr("Resume"));
  }
  stopped_->setVisible(can);
}

void MainWindow::stopForce(const QString& by) {
  if (is_force_) stopped_by_ = by;
  emit forceOffWanted();
}

void MainWindow::displayWords() {
  if (!unsaid_) return;
  emit worded(*unsaid_);
  status_->display(*unsaid_);
  unsaid_.reset();
  words_.start();
}

void MainWindow::showMessage(const QString& sentence) {
  done_->hide();
  explain(*more_of_message_, sentence);
  message_->setSentence(sentence);
  message_->show();
}

void MainWindow::clearMessage() {
  message_->hide();
  done_->hide();
}

void MainWindow::showDone(const QString& sentence, const QString& folder) {
  message_->hide();
  done_->setSentence(sentence);
  done_folder_ = folder;
  done_->show();
}

void MainWindow::showOffer(const QString& sentence, const QString& button,
                           std::function<void()> take) {
  offer_->setSentence(sentence);
  take_offer_->setText(button);
  offered_ = std::move(take);
  offer_->show();
}

void MainWindow::explain(QPushButton& more, const QString& sentence) {
  const QString place = explainer_ ? explainer_(sentence) : QString{};
  more.setProperty("place", place);
  more.setVisible(!place.isEmpty());
}

void MainWindow::showFault(const QString& sentence) {
  explain(*more_of_fault_, sentence);
  fault_->setSentence(sentence);
  fault_->show();
}

void MainWindow::showLoading(const QString& what) {
  if (!start_->isHidden()) return start_->setLoading(what);
  // the same again leaves the bar as it is: a new range paints the window at once
  if (loading_->isVisible() && loading_what_->text() == what) return;
  loading_what_->setText(what);
  progress_->setRange(0, 0);  // busy, until a fraction is known
  loading_->show();
}

void MainWindow::showProgress(double fraction) {
  if (!start_->isHidden()) return start_->setProgress(fraction);
  progress_->setRange(0, 1000);
  progress_->setValue(qRound(fraction * 1000.0));
}

void MainWindow::endLoading() {
  start_->setLoading({});
  loading_->hide();
}

bool MainWindow::askWhether(const QString& what, const QString& consequence, const QString& yes) {
  QMessageBox question(QMessageBox::Question, tr("Please confirm"), what, QMessageBox::Cancel,
                       this);
  question.setInformativeText(consequence);
  const QAbstractButton* agree = question.addButton(yes, QMessageBox::AcceptRole);
  question.setDefaultButton(QMessageBox::Cancel);
  question.exec();
  return question.clickedButton() == agree;
}

Unsaved MainWindow::askToSave(const QString& what, const QString& consequence) {
  QMessageBox question(QMessageBox::Question, tr("Not saved"), what, QMessageBox::Cancel, this);
  question.setInformativeText(consequence);
  const QAbstractButton* save = question.addButton(tr("&Save view…"), QMessageBox::AcceptRole);
  const QAbstractButton* discard = question.addButton(tr("&Discard"), QMessageBox::DestructiveRole);
  question.setDefaultButton(QMessageBox::Cancel);
  question.exec();
  if (question.clickedButton() == save) return Unsaved::Save;
  return question.clickedButton() == discard ? Unsaved::Discard : Unsaved::Cancel;
}

void MainWindow::setHand(const QString& label, Feel feel) {
  feel_ = feel;
  stopped_by_.clear();
  status_->setHand(label);
  bar_->force().setDetail(label);
}

QString noticeText() {
  return MainWindow::tr(
      "Not a medical device. Not for diagnosis. Force feedback hardware can move suddenly.");
}

void MainWindow::showNotice() {
  QMessageBox box(QMessageBox::Warning, tr("Before you begin"), noticeText(), QMessageBox::Ok,
                  this);
  box.setInformativeText(
      tr("Keep hands and face clear of a device until it is at rest. Escape takes the force away "
         "at any time."));
  box.exec();
}

void MainWindow::closeEvent(QCloseEvent* event) {
  const auto guard = close_guard_;
  // a guard that is gone meanwhile was overtaken by an end that asks nobody
  if (guard && !guard() && close_guard_) return event->ignore();
  emit closing();
  event->accept();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasUrls()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  QStringList paths;
  for (const QUrl& url : event->mimeData()->urls())
    if (url.isLocalFile()) paths << url.toLocalFile();
  if (paths.isEmpty())
    return showMessage(tr("The dropped item is not on this machine's disks; copy it there first."));
  event->acceptProposedAction();
  emit dropped(paths);
}

}  // namespace ui
