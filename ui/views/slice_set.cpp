// SPDX-License-Identifier: BSD-3-Clause
#include "ui/views/slice_set.h"

#include <QAction>
#include <QActionGroup>
#include <QDialog>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <algorithm>
#include <cmath>

#include "ui/controls/bindings.h"
#include "ui/controls/lengths.h"
#include "ui/controls/number_box.h"
#include "ui/props/section.h"
#include "ui/views/plane_colours.h"
#include "ui/views/slice_readout.h"

namespace ui {
namespace {

constexpr double kFollow_voxels = 0.2;       // a tool that moved less moves no oblique plane
constexpr double kCrossFollow_voxels = 0.5;  // and no crosshair
constexpr double kResume_mm = 2.0;           // from where it was when the user moved the crosshair
constexpr int kFollowMs = 50;
constexpr std::array<double, 5> kThicknesses_mm{1.0, 2.0, 5.0, 10.0, 20.0};

/// Where the picture's right is for a first look along `towards`, which points to the viewer: the
/// patient's head is above, or the front where the look goes along the body.
Eigen::Vector3d firstRight(const Eigen::Vector3d& towards) {
  Eigen::Vector3d up = std::abs(towards.z()) > 0.8 ? Eigen::Vector3d{-Eigen::Vector3d::UnitY()}
                                                   : Eigen::Vector3d{Eigen::Vector3d::UnitZ()};
  up = (up - towards * towards.dot(up)).normalized();
  return up.cross(towards);
}

}  // namespace

SliceSet::SliceSet(QWidget* parent) : QObject(parent), menu_(new QMenu(parent)) {
  for (const Plane plane : {Plane::Axial, Plane::Coronal, Plane::Sagittal, Plane::Oblique}) {
    auto* slice = new SliceView(plane);
    slices_[static_cast<std::size_t>(plane)] = slice;
    connect(slice, &SliceView::crossMoved, this, &SliceSet::holdCross);
    connect(slice, &SliceView::greyChanged, this, &SliceSet::chooseGrey);
    connect(slice, &SliceView::greyWanted, this, &SliceSet::takeGrey);
    connect(slice, &SliceView::fitWanted, this, &SliceSet::fitBody);
    connect(slice, &SliceView::doubleClicked, this, &SliceSet::doubleClicked);
    connect(slice, &SliceView::menuWanted, this,
            [this, slice](QPoint at) { openMenu(*slice, at); });
  }
  SliceView& oblique = slice(Plane::Oblique);
  connect(&oblique, &SliceView::depthChanged, this, [this](double by_mm) {
    depth_mm_ += by_mm;
    placeOblique();
  });
  connect(&oblique, &SliceView::resetWanted, this, [this] {
    depth_mm_ = 0.0;
    right_W_.reset();
    placeOblique();
  });
  follow_pause_.setSingleShot(true);
  follow_pause_.setInterval(kFollowMs);
  connect(&follow_pause_, &QTimer::timeout, this, &SliceSet::followTool);
  buildMenu();
}

QAction* SliceSet::toggle(const QString& text, const char* name, bool on,
                          const std::function<void(bool)>& set) {
  QAction* action = menu_->addAction(text);
  action->setObjectName(name);
  action->setCheckable(true);
  action->setChecked(on);
  connect(action, &QAction::toggled, this, set);
  return action;
}

void SliceSet::fitBody() {
  for (SliceView* slice : slices_) slice->fitBody();
}

void SliceSet::openMenu(SliceView& over, QPoint at) {
  over.setFocus(Qt::PopupFocusReason);
  menu_->popup(at);
}

void SliceSet::buildMenu() {
  menu_->setTitle(tr("Sl&ices"));
  menu_->setObjectName("slicesMenu");
  QAction* reset = menu_->addAction(tr("&Show all slices whole"), this, [this] {
    for (SliceView* slice : slices_) slice->resetView();
  });
  reset->setObjectName("resetSlices");
  QAction* fit = menu_->addAction(tr("Fit all slices to the &body"), this, &SliceSet::fitBody);
  fit->setObjectName("fitSlices");
  showKey(*fit, Action::FitBody);
  menu_->addSeparator();
  buildGreyMenu();
  buildLookMenu();
  menu_->addSeparator();
  toggle(tr("&Contour of the touched surface"), "showContour", true, [this](bool on) {
    for (SliceView* slice : slices_) slice->setContourShown(on);
  });
  toggle(tr("Cross&hair"), "showCrosshair", true, [this](bool on) {
    crosshair_ = on;
    linkPlanes();
  });
  follow_ = toggle(tr("&Follow the tool"), "followTool", true, [this](bool on) {
    emit followingChanged(on);
    held_ = false;
    if (!on || !X_WP_ || !volume_) return;
    followed_mm_.reset();
    followTool();
  });
  menu_->addSeparator();
  oblique_ = toggle(tr("View with the &tool"), "showOblique", false, [this](bool on) {
    placed_.reset();
    emit obliqueShownChanged(on);
    placeOblique();
  });
  directions_ = new QActionGroup(this);
  for (const bool along : {false, true}) {
    QAction* action = menu_->addAction(along ? tr("Tool view: &along its axis")
                                             : tr("Tool view: &down its axis"));
    action->setObjectName(along ? "obliqueAlong" : "obliqueDown");
    action->setCheckable(true);
    action->setChecked(along == along_);
    action->setData(along);
    directions_->addAction(action);
    connect(action, &QAction::triggered, this, [this, along] {
      along_ = along;
      depth_mm_ = 0.0;
      placeOblique();
    });
  }
  menu_->addSeparator();
  QAction* save = menu_->addAction(tr("Save &picture of a slice…"), this, &SliceSet::pictureWanted);
  save->setObjectName("saveSlicePicture");
  showKey(*save, Action::SavePicture, tr("Saves the slice as it is shown"));
}

void SliceSet::buildGreyMenu() {
  QMenu* menu = menu_->addMenu(tr("&Window and level"));
  grey_menu_ = menu;
  menu->setObjectName("greyMenu");
  for (const GreyPreset& preset : hounsfieldPresets()) {
    QAction* action = menu->addAction(
        tr("%1 (W %2, L %3)").arg(preset.name).arg(preset.grey.width).arg(preset.grey.level), this,
        [this, grey = preset.grey] { chooseGrey(grey); });
    action->setProperty("level", preset.grey.level);
    showKey(*action, static_cast<Action>(static_cast<int>(Action::GreySoftTissue) +
                                         static_cast<int>(presets_.size())));
    presets_ << action;
  }
  QAction* full = menu->addAction(tr("&Full range"), this, [this] {
    if (volume_) chooseGrey(fullRange(*volume_));
  });
  full->setObjectName("greyFullRange");
  QAction* reset = menu->addAction(tr("&Reset"), this, [this] {
    if (volume_) chooseGrey(firstGrey(*volume_, stated_));
  });
  reset->setObjectName("greyReset");
  showKey(*reset, Action::GreyAtFirst);
  menu->addSeparator();
  QAction* type = menu->addAction(tr("&Level and width…"), this, &SliceSet::askGrey);
  type->setObjectName("typeGrey");
  showKey(*type, Action::TypeGrey);
}

/// Puts what the file states above the other windows.
void SliceSet::offerStated() {
  qDeleteAll(stated_actions_);
  stated_actions_.clear();
  QAction* const first = grey_menu_->actions().constFirst();
  for (const GreyPreset& preset : stated_) {
    auto* action = new QAction(wordsOfStated(preset), grey_menu_);
    connect(action, &QAction::triggered, this, [this, grey = preset.grey] { chooseGrey(grey); });
    grey_menu_->insertAction(first, action);
    stated_actions_ << action;
  }
}

void SliceSet::buildLookMenu() {
  QMenu* voxels = menu_->addMenu(tr("&Voxels"));
  voxels->setObjectName("voxelsMenu");
  // an entry is checked while the look has its value
  const auto choice = [this](QMenu* menu, QActionGroup* group, const QString& text,
                             const char* name, auto value, auto SliceLook::*part) {
    QAction* action = menu->addAction(text);
    action->setObjectName(name);
    action->setCheckable(true);
    action->setData(static_cast<double>(value));
    group->addAction(action);
    connect(action, &QAction::triggered, this, [this, value, part] {
      SliceLook look = look_;
      look.*part = value;
      setLook(look);
    });
  };
  interpolations_ = new QActionGroup(this);
  const auto interpolation = &SliceLook::interpolation;
  choice(voxels, interpolations_, tr("&Interpolated"), "linear", Interpolation::Linear,
         interpolation);
  choice(voxels, interpolations_, tr("As they a&re"), "nearest", Interpolation::Nearest,
         interpolation);
  QMenu* slab_menu = menu_->addMenu(tr("Thick s&lab"));
  slab_menu->setObjectName("slabMenu");
  slabs_ = new QActionGroup(this);
  const auto slab = &SliceLook::slab;
  choice(slab_menu, slabs_, tr("&One plane"), "slabNone", SlabKind::None, slab);
  choice(slab_menu, slabs_, tr("&Maximum"), "slabMaximum", SlabKind::Maximum, slab);
  choice(slab_menu, slabs_, tr("Mi&nimum"), "slabMinimum", SlabKind::Minimum, slab);
  choice(slab_menu, slabs_, tr("M&ean"), "slabMean", SlabKind::Mean, slab);
  slab_menu->addSeparator();
  thicknesses_ = new QActionGroup(this);
  for (const double mm : kThicknesses_mm)
    choice(slab_menu, thicknesses_, {}, "", mm, &SliceLook::thickness_mm);
  const auto name = [this] {
    for (QAction* action : thicknesses_->actions())
      action->setText(
          tr("%1 thick")
              .arg(readoutLocale().toString(action->data().toDouble() / mmPerLengthUnit()) + ' ' +
                   lengthUnitName()));
  };
  name();
  whenLengthUnitChanges(*this, [this, name] {
    name();
    placeOblique();
  });
  QAction* other = slab_menu->addAction(tr("Other &thickness…"), this, &SliceSet::askThickness);
  other->setObjectName("otherThickness");
  showLook();
}

void SliceSet::askThickness() {
  const double unit = mmPerLengthUnit();
  QDialog dialog(slices_.front()->window());
  dialog.setObjectName("thicknessQuestion");
  dialog.setWindowTitle(tr("Thick slab"));
  auto* thickness = new NumberBox;
  thickness->setAccessibleName(tr("Thickness"));
  thickness->setDecimals(lengthDecimals(1));
  thickness->setRange(SliceLook::kThinnest_mm / unit, SliceLook::kThickest_mm / unit);
  thickness->setValue(look_.thickness_mm / unit);
  thickness->setSuffix(' ' + lengthUnitName());
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
  connect(buttons, &QDialogButtonBox::accepted, &dialog, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
  auto* form = new QFormLayout(&dialog);
  form->addRow(tr("&Thickness"), thickness);
  form->addRow(buttons);
  thickness->selectAll();
  if (dialog.exec() != QDialog::Accepted) return;
  SliceLook look = look_;
  look.thickness_mm = unit * thickness->value();
  setLook(look);
}

void SliceSet::takeGrey(Action which) {
  if (!volume_) return;
  if (which == Action::TypeGrey) return askGrey();
  if (which == Action::GreyAtFirst) return chooseGrey(firstGrey(*volume_, stated_));
  const int n = static_cast<int>(which) - static_cast<int>(Action::GreySoftTissue);
  if (presets_[n]->isVisible()) presets_[n]->trigger();
}

void SliceSet::askGrey() {
  if (!volume_) return;
  const double full = std::max(volume_->greatest - volume_->least, 1e-6);
  const int decimals = std::clamp(2 - static_cast<int>(std::floor(std::log10(full / 100.0))), 0, 9);
  QDialog dialog(slices_.front()->window());
  dialog.setObjectName("greyQuestion");
  dialog.setWindowTitle(tr("Level and width"));
  auto* form = new QFormLayout(&dialog);
  const auto field = [&](const QString& label, const char* name, double value, double least) {
    auto* box = new NumberBox;
    box->setObjectName(name);
    box->setDecimals(decimals);
    box->setRange(least, 1e9);
    box->setValue(value);
    if (!volume_->unit.empty()) box->setSuffix(' ' + QString::fromStdString(volume_->unit));
    form->addRow(label, box);
    return box;
  };
  auto* level = field(tr("&Level"), "greyLevel", grey_.level, -1e9);
  auto* width = field(tr("&Width"), "greyWidth", grey_.width, std::pow(10.0, -decimals));
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
  connect(buttons, &QDialogButtonBox::accepted, &dialog, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
  form->addRow(buttons);
  level->selectAll();
  if (dialog.exec() == QDialog::Accepted)
    chooseGrey({.level = level->value(), .width = width->value()});
}

void SliceSet::chooseGrey(const GreyWindow& grey) {
  setGrey(grey);
  emit greyChosen(grey);
}

void SliceSet::setLook(const SliceLook& look) {
  look_ = look;
  for (SliceView* slice : slices_) slice->setLook(look);
  showLook();
}

void SliceSet::showLook() {
  const auto check = [](const QActionGroup* group, double value) {
    for (QAction* action : group->actions()) action->setChecked(action->data().toDouble() == value);
  };
  check(interpolations_, static_cast<double>(look_.interpolation));
  check(slabs_, static_cast<double>(look_.slab));
  check(thicknesses_, look_.thickness_mm);
}

void SliceSet::tell(ViewLook& look) const {
  look.cross_mm = cross_mm_;
  look.grey_level = grey_.level;
  look.grey_width = grey_.width;
  look.voxels = look_;
  look.tool_plane = {.along = along_, .depth_mm = depth_mm_};
  for (std::size_t i = 0; i < slices_.size(); ++i) look.slices[i] = slices_[i]->frame();
}

void SliceSet::look(const ViewLook& look) {
  setGrey({.level = look.grey_level, .width = look.grey_width});
  setLook(look.voxels);
  along_ = look.tool_plane.along;
  depth_mm_ = look.tool_plane.depth_mm;
  for (QAction* action : directions_->actions())
    action->setChecked(action->data().toBool() == along_);
  moveCross(look.cross_mm);
  followed_mm_.reset();  // the tool comes to its place without being moved
  placeOblique();
  for (std::size_t i = 0; i < slices_.size(); ++i) slices_[i]->setFrame(look.slices[i]);
}

void SliceSet::show(const Picture& picture, double isovalue,
                    const std::vector<GreyPreset>& stated) {
  volume_ = picture.volume;
  stated_ = stated;
  offerStated();
  box_mm_ = boxOf_mm(volume_->grid);
  X_WP_.reset();
  followed_mm_.reset();
  placed_.reset();
  right_W_.reset();
  depth_mm_ = 0.0;
  for (SliceView* slice : slices_) slice->show(picture);
  for (QAction* preset : presets_) preset->setVisible(volume_->unit == "HU");
  setIsovalue(isovalue);
  setGrey(firstGrey(*volume_, stated_));
  // on a voxel's centre: no slice is blurred by interpolation
  haptics::Vec3 middle;
  for (int a = 0; a < 3; ++a)
    middle[a] = static_cast<double>(volume_->grid.dims[static_cast<std::size_t>(a)] / 2);
  moveCross(volume_->grid.worldOf(middle) * kMmPerM);
  placeOblique();
}

void SliceSet::replace(const Picture& picture) {
  volume_ = picture.volume;
  for (SliceView* slice : slices_) slice->replace(picture);
}

void SliceSet::showLive(const haptics::Volume& voxels) {
  for (SliceView* slice : slices_) slice->showLive(voxels);
}

void SliceSet::carve() {
  for (SliceView* slice : slices_) slice->carve();
}

void SliceSet::renew(std::shared_ptr<const haptics::Volume> volume) {
  volume_ = std::move(volume);
  for (SliceView* slice : slices_) slice->renew(volume_);
}

void SliceSet::show(const haptics::TriangleMesh& tool) {
  const auto mesh = std::make_shared<const haptics::TriangleMesh>(tool);
  tip_T_ = tipOf(tool);
  followed_mm_.reset();
  for (SliceView* slice : slices_) slice->setMesh(mesh);
  placeOblique();
}

void SliceSet::setTouched(const TouchedSurface& touched) {
  for (SliceView* slice : slices_) slice->setTouched(touched);
}

void SliceSet::addOverlay(Overlay& overlay) {
  for (SliceView* slice : slices_) slice->addOverlay(overlay);
}

void SliceSet::show(const Structures& structures) {
  for (SliceView* slice : slices_) slice->setStructures(structures);
}

void SliceSet::setIsovalue(double isovalue) {
  for (SliceView* slice : slices_) slice->setIsovalue(isovalue);
}

void SliceSet::setGrey(const GreyWindow& grey) {
  grey_ = grey;
  for (SliceView* slice : slices_) slice->setGrey(grey);
}

void SliceSet::moveCross(const Eigen::Vector3d& cross_W_mm) {
  cross_mm_ = cross_W_mm;
  for (SliceView* slice : slices_) slice->setCross(cross_W_mm);
  linkPlanes();
  emit crossMoved(cross_W_mm);
}

void SliceSet::display(const haptics::Snapshot& snapshot) {
  X_WP_ = snapshot.X_WP;
  // in another scene the tool begins elsewhere
  if (!followed_mm_ || snapshot.scene != scene_) followed_mm_ = tip_mm();
  scene_ = snapshot.scene;
  for (SliceView* slice : slices_) slice->setTool(snapshot.X_WP, snapshot.X_WD);
  followTool();
  if (!obliqueShown()) return;
  const double least = kFollow_voxels * (volume_ ? volume_->grid.spacing.minCoeff() : 1e-3);
  const double reach = tip_T_.norm() + 0.05;  // m; half of what such a view shows
  if (!placed_ || (placed_->translation() - X_WP_->translation()).norm() > least ||
      (placed_->linear() - X_WP_->linear()).cwiseAbs().maxCoeff() * reach > least)
    placeOblique();
}

Eigen::Vector3d SliceSet::tip_mm() const { return *X_WP_ * tip_T_ * kMmPerM; }

bool SliceSet::follows() const { return follow_->isChecked(); }

void SliceSet::setFollowing(bool on) { follow_->setChecked(on); }

void SliceSet::holdCross(const Eigen::Vector3d& cross_W_mm) {
  held_ = true;
  if (X_WP_) followed_mm_ = tip_mm();
  moveCross(cross_W_mm);
}

void SliceSet::followTool() {
  if (!follows() || !X_WP_ || !volume_ || follow_pause_.isActive()) return;
  const Eigen::Vector3d tip = tip_mm();
  const double voxel_mm = volume_->grid.spacing.minCoeff() * kMmPerM;
  const double least_mm = held_ ? std::max(kResume_mm, voxel_mm) : kCrossFollow_voxels * voxel_mm;
  if (followed_mm_ && (tip - *followed_mm_).norm() < least_mm) return;
  followed_mm_ = tip;
  held_ = false;
  const Eigen::Vector3d cross = tip.cwiseMax(box_mm_.min()).cwiseMin(box_mm_.max());
  if (cross == cross_mm_) return;
  follow_pause_.start();
  moveCross(cross);
}

bool SliceSet::obliqueShown() const { return oblique_->isChecked(); }

void SliceSet::setObliqueShown(bool shown) { oblique_->setChecked(shown); }

void SliceSet::placeOblique() {
  if (!volume_ || !obliqueShown()) return linkPlanes();
  SliceView& view = slice(Plane::Oblique);
  const QString name = along_ ? tr("Along the tool") : tr("Down the tool");
  if (!X_WP_) {
    view.setPlane(axesOf(Plane::Oblique), cross_mm_, name, tr("no tool yet"));
    return linkPlanes();
  }
  placed_ = X_WP_;
  const Eigen::Vector3d back = X_WP_->linear().col(2);  // from the tip to the handle
  // as it was, turned as little as can be, so that the picture does not spin
  Eigen::Vector3d right = right_W_.value_or(Eigen::Vector3d::Zero());
  right -= back * back.dot(right);
  right = right.norm() > 0.1 ? Eigen::Vector3d{right.normalized()} : firstRight(back);
  right_W_ = right;
  const PlaneAxes axes = along_ ? PlaneAxes{right, back, back.cross(right)}
                                : PlaneAxes{right, back.cross(right), -back};
  const Eigen::Vector3d tip = *X_WP_ * tip_T_ * kMmPerM;
  const QString from = along_ ? tr("axis") : tr("tip");
  const QString place =
      std::abs(depth_mm_) < 0.05
          ? (along_ ? tr("through its axis") : tr("at its tip"))
          : QStringLiteral("%1 %2 %3 %4")
                .arg(from, depth_mm_ > 0.0 ? QChar('+') : QChar(0x2212),
                     readoutLocale().toString(std::abs(depth_mm_) / mmPerLengthUnit(), 'f',
                                              lengthDecimals(1)),
                     lengthUnitName());
  view.setPlane(axes, tip + axes.normal * depth_mm_, name, place);
  linkPlanes();
}

void SliceSet::linkPlanes() {
  for (const SliceView* shown : slices_) {
    std::vector<CrossedPlane> planes;
    for (const SliceView* other : slices_) {
      const bool there = other->plane() != Plane::Oblique || obliqueShown();
      if (other != shown && there && crosshair_)
        planes.push_back({.colour = colourOf(other->plane()),
                          .through_W_mm = other->through_mm(),
                          .normal_W = other->axes().normal});
    }
    slice(shown->plane()).setCrossedPlanes(std::move(planes));
  }
}

}  // namespace ui
