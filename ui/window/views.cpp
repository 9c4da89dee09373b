// SPDX-License-Identifier: BSD-3-Clause
#include "ui/window/views.h"

#include <QAction>
#include <QPainter>
#include <algorithm>
#include <utility>

#include "ui/controls/bindings.h"
#include "ui/panels/force_panel.h"
#include "ui/style/scene_colours.h"
#include "ui/views/before_view.h"
#include "ui/views/plane_colours.h"
#include "ui/views/volume_view.h"
#include "ui/window/view_actions.h"
#include "ui/window/view_frame.h"
#include "ui/window/view_layout.h"

namespace ui {
namespace {

constexpr int kCardMs = 100;  // between two looks whether the card covers the tool

}  // namespace

Views::Views(QWidget* window)
    : QObject(window), volume_(new VolumeView), slices_(new SliceSet(window)) {
  ViewLayout::Frames frames{};
  frames[0] = new ViewFrame(volume_, style::kViewFrame, false);
  frames[0]->setHint(volume_->hint());
  connect(volume_, &VolumeView::hintChanged, frames[0], &ViewFrame::setHint);
  connect(volume_, &VolumeView::pointedChanged, frames[0],
          [this, frame = frames[0]](const QString& words) {
            frame->setPointed(words, volume_->wordBoxes());
          });
  connect(frames[0], &ViewFrame::coveredChanged, volume_, &VolumeView::setCovered);
  for (SliceView* slice : slices_->slices()) {
    auto* frame = new ViewFrame(slice, colourOf(slice->plane()), true);
    frames[static_cast<std::size_t>(slice->plane()) + 1] = frame;
    frame->setHint(slice->hint());
    connect(slice, &SliceView::hintChanged, frame, &ViewFrame::setHint);
    connect(slice, &SliceView::toolToCrossWanted, this, &Views::toolToCrossWanted);
    connect(slice, &SliceView::crossToToolWanted, this, &Views::crossToToolWanted);
    connect(frame, &ViewFrame::menuWanted, this,
            [this, slice](QPoint at) { slices_->openMenu(*slice, at); });
    slice->setButtonRoom(frame->buttonRoom());
    connect(frame, &ViewFrame::fitWanted, slice, &SliceView::fitBody);
    connect(frame, &ViewFrame::followWanted, slices_, &SliceSet::setFollowing);
    connect(slices_, &SliceSet::followingChanged, frame, &ViewFrame::setFollowing);
  }
  for (const ViewFrame* frame : frames)
    connect(frame, &ViewFrame::hintsUnwanted, this, &Views::hintsUnwanted);
  layout_ = new ViewLayout(frames);
  connect(slices_, &SliceSet::obliqueShownChanged, layout_, &ViewLayout::setObliqueShown);
  connect(slices_, &SliceSet::doubleClicked, this, [this](const Eigen::Vector3d& p_W_mm) {
    emit toolWanted(p_W_mm / kMmPerM, haptics::Vec3::Zero());
  });
  connect(slices_, &SliceSet::pictureWanted, this, [this] {
    const auto& all = slices_->slices();
    const auto shown = std::ranges::find_if(all, &SliceView::isVisible);
    SliceView* first = shown == all.end() ? nullptr : *shown;
    emit pictureWanted(activeSlice() != nullptr ? activeSlice() : first);
  });
  volume_->setObjectName("view");
  connect(volume_, &VolumeView::toolWanted, this, &Views::toolWanted);
  connect(volume_, &VolumeView::toolToCrossWanted, this, &Views::toolToCrossWanted);
  connect(volume_, &VolumeView::crossToToolWanted, this, &Views::crossToToolWanted);
}

void Views::addActions(QMenu& menu, TopBar& bar) {
  actions_ = new ViewActions(menu, bar, *volume_);
  actions_->setParent(this);
  connect(actions_, &ViewActions::isovalueWanted, this, &Views::isovalueWanted);
  connect(actions_, &ViewActions::pictureWanted, this,
          [this] { emit pictureWanted(activeSlice()); });
  connect(actions_, &ViewActions::pictureCopyWanted, this, &Views::pictureCopyWanted);
}

void Views::show(const Picture& picture, double isovalue, const std::vector<GreyPreset>& stated) {
  volume_->show(picture, isovalue);
  actions_->show(picture);
  slices_->show(picture, isovalue, stated);
}

void Views::show(const haptics::TriangleMesh& tool) {
  volume_->show(tool);
  slices_->show(tool);
}

void Views::showLive(const haptics::Volume& voxels, std::shared_ptr<const haptics::Volume> scan,
                     std::span<const haptics::VoxelBox> cut_before) {
  volume_->showLive(voxels, std::move(scan), cut_before);
  slices_->showLive(voxels);
}

void Views::carve(const haptics::VoxelBox& box) {
  volume_->carve(box);
  slices_->carve();
}

void Views::renew(const Picture& picture) {
  volume_->renew(picture);
  slices_->renew(picture.volume);
}

void Views::replace(const Picture& picture) {
  volume_->replace(picture);
  slices_->replace(picture);
}

void Views::setIsovalue(double isovalue) {
  volume_->setIsovalue(isovalue);
  slices_->setIsovalue(isovalue);
}

void Views::setTouched(const TouchedSurface& touched) {
  volume_->setTouched(touched);
  if (before_ != nullptr) before_->setTouched(touched);
  slices_->setTouched(touched);
}

void Views::show(const Structures& structures) {
  volume_->show(structures);
  slices_->show(structures);
}

void Views::display(const haptics::Snapshot& snapshot) {
  volume_->display(snapshot);
  slices_->display(snapshot);
  if (card_placed_.isValid() && !card_placed_.hasExpired(kCardMs)) return;
  card_placed_.start();
  volumeFrame().keepCardClear();
}

void Views::addOverlay(Overlay& overlay) {
  volume_->addOverlay(overlay);
  slices_->addOverlay(overlay);
}

void Views::addAction(QAction& action) {
  volume_->addAction(&action);
  for (SliceView* slice : slices_->slices()) slice->addAction(&action);
}

ViewFrame& Views::volumeFrame() const { return static_cast<ViewFrame&>(*volume_->parentWidget()); }

void Views::setForceCard(ForcePanel& card) {
  volumeFrame().setCard(
      card, [this](const QRect& part) { return volume_->isToolIn(part); },
      [this](const QRect& part) { return volume_->isHandleIn(part); });
  connect(&volumeFrame(), &ViewFrame::cardFoldedChanged, this, &Views::cardFoldedChanged);
}

void Views::setSentences(const QList<QRect>& parts) { volumeFrame().setSentences(parts); }

void Views::showBefore(const Picture& scan) {
  hideBefore();
  before_ = new BeforeView(*volume_, scan);
  before_->setObjectName("before");
  volumeFrame().setBefore(before_);
}

void Views::hideBefore() {
  if (before_ == nullptr) return;
  if (before_->hasFocus()) volume_->setFocus();
  volumeFrame().setBefore(nullptr);
  delete std::exchange(before_, nullptr);
}

QAction& Views::beforeAfter() const { return actions_->beforeAfter(); }

QSize Views::spaceSize() const {
  return before_ == nullptr ? volume_->size()
                            : before_->geometry().united(volume_->geometry()).size();
}

QImage Views::spacePicture(double scale) {
  const QImage after = volume_->picture(scale);
  if (before_ == nullptr || after.isNull()) return after;
  const QImage before = before_->picture(scale);
  if (before.isNull()) return before;
  QImage both((QSizeF(spaceSize()) * scale).toSize(), QImage::Format_RGB32);
  both.fill(style::kBetweenViews);
  QPainter painter(&both);
  painter.drawImage(0, 0, before);
  painter.drawImage(both.width() - after.width(), both.height() - after.height(), after);
  return both;
}

void Views::setMouse(const MouseChoices& mouse) {
  volume_->setMouse(mouse);
  if (before_ != nullptr) before_->setMouse(mouse);
  for (SliceView* slice : slices_->slices()) slice->setMouse(mouse);
}

ViewLook Views::look() const {
  ViewLook look;
  volume_->tell(look);
  look.colours = actions_->colours();
  look.second = volume_->surface().second();
  look.second_opacity = volume_->secondOpacity();
  slices_->tell(look);
  look.layout = layout_->look();
  return look;
}

void Views::setLook(const ViewLook& look) {
  volume_->look(look);
  actions_->look(look);
  slices_->setObliqueShown(look.layout.tool_view);
  layout_->look(look.layout);
  slices_->look(look);
}

SliceView* Views::activeSlice() const {
  return layout_->active() == 0 ? nullptr : slices_->slices()[layout_->active() - 1];
}

bool Views::showsSlices() const {
  return std::ranges::any_of(slices_->slices(), &SliceView::isVisible);
}

QString Views::state() const {
  return ViewLayout::nameOf(layout_->arrangement()) +
         (slices_->obliqueShown() ? QStringLiteral("+tool") : QString()) +
         (volumeFrame().cardFolded() ? QStringLiteral("+folded") : QString());
}

void Views::restore(const QString& state) {
  const QStringList words = state.split('+');
  const auto arrangement = ViewLayout::arrangementOf(words.first());
  if (!arrangement) return;
  layout_->arrange(*arrangement);
  slices_->setObliqueShown(words.contains(QLatin1String("tool")));
  volumeFrame().setCardFolded(words.contains(QLatin1String("folded")));
}

void Views::reset() {
  beforeAfter().setChecked(false);
  volumeFrame().setCardFolded(false);
  slices_->setObliqueShown(false);
  layout_->reset();
}

}  // namespace ui
