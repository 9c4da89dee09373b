// SPDX-License-Identifier: BSD-3-Clause
#include "ui/window/view_actions.h"

#include <QAction>
#include <QActionGroup>
#include <QMenu>
#include <array>
#include <utility>

#include "ui/controls/bindings.h"
#include "ui/views/volume_view.h"
#include "ui/window/top_bar.h"

namespace ui {

ViewActions::ViewActions(QMenu& menu, TopBar& bar, VolumeView& view) : view_(view) {
  buildSides(menu);
  buildColours(menu);
  buildTool(menu, bar);
  menu.addSeparator();
  QAction* picture = menu.addAction(tr("Sa&ve picture…"), this, &ViewActions::pictureWanted);
  picture->setObjectName("savePicture");
  giveKeys(*picture, Action::SavePicture, tr("Saves a picture of the view or the window"));
  bar.add(BarGroup::Tools, *picture, "camera");
  QAction* copy = menu.addAction(tr("Cop&y picture"), this, &ViewActions::pictureCopyWanted);
  copy->setObjectName("copyPicture");
  giveKeys(*copy, Action::CopyPicture, tr("Copies a picture of the 3-D view"));
  menu.addSeparator();
}

void ViewActions::buildSides(QMenu& menu) {
  showKey(*menu.addAction(tr("Show &everything"), &view_, &VolumeView::resetCamera),
          Action::ShowEverything);
  QMenu* sides = menu.addMenu(tr("From a &side"));
  sides->setObjectName("sides");
  const std::array<std::pair<QString, Action>, 6> names{
      {{tr("Anterior (from the front)"), Action::ViewAnterior},
       {tr("Posterior (from behind)"), Action::ViewPosterior},
       {tr("Left"), Action::ViewLeft},
       {tr("Right"), Action::ViewRight},
       {tr("Superior (from above)"), Action::ViewSuperior},
       {tr("Inferior (from below)"), Action::ViewInferior}}};
  for (std::size_t i = 0; i < names.size(); ++i)
    showKey(*sides->addAction(names[i].first, &view_,
                              [this, side = kSides[i]] { view_.lookFrom(side); }),
            names[i].second);
  showKey(*menu.addAction(tr("From the &tool's side"), &view_, &VolumeView::lookFromTool),
          Action::LookFromTool);
  showKey(*menu.addAction(tr("&Along the tool"), &view_, &VolumeView::lookAlongTool),
          Action::LookAlongTool);
  QAction* parallel = menu.addAction(tr("Parallel pro&jection"));
  showKey(*parallel, Action::ParallelProjection);
  parallel->setObjectName("parallel");
  parallel->setCheckable(true);
  connect(parallel, &QAction::toggled, &view_, &VolumeView::setParallel);
  connect(&view_, &VolumeView::parallelChanged, parallel, &QAction::setChecked);
  menu.addSeparator();
}

void ViewActions::buildColours(QMenu& menu) {
  presets_ = menu.addMenu(tr("&Presets"));
  presets_->setObjectName("tissuePresets");
  presets_->setToolTipsVisible(true);
  for (const Tissue tissue : kTissues) {
    QAction* preset = presets_->addAction(nameOf(tissue), this, [this, tissue] { choose(tissue); });
    preset->setToolTip(tr("A starting point, not a threshold for diagnosis"));
  }
  colours_ = menu.addMenu(tr("&Colour"));
  colours_->setObjectName("colours");
  auto* group = new QActionGroup(this);
  by_value_ = colours_->addAction(tr("By tissue"));
  by_value_->setObjectName("colourByTissue");
  ivory_ = colours_->addAction(tr("Ivory"));
  ivory_->setObjectName("colourIvory");
  for (QAction* action : {by_value_, ivory_}) {
    action->setCheckable(true);
    group->addAction(action);
  }
  connect(by_value_, &QAction::triggered, this, [this] { setColours(SurfaceColours::Tissue); });
  connect(ivory_, &QAction::triggered, this, [this] { setColours(SurfaceColours::Ivory); });

  second_ = menu.addMenu(tr("Second s&urface (seen, not felt)"));
  second_->setObjectName("secondSurface");
  auto* seconds = new QActionGroup(this);
  const auto entry = [&](const QString& text, auto isovalue) {
    QAction* action = second_->addAction(text, this, [this, isovalue] {
      if (picture_) view_.setSecondSurface(isovalue());
    });
    action->setCheckable(true);
    seconds->addAction(action);
    return action;
  };
  no_second_ = entry(tr("None"), [] { return std::optional<double>{}; });
  for (const Tissue tissue : kTissues)
    entry(nameOf(tissue), [this, tissue] { return std::optional{isovalueOf(tissue, *picture_)}; });
  entry(tr("The present isovalue, held"),
        [this] { return std::optional{view_.surface().isovalue()}; });
  markSecond();
  connect(&view_, &VolumeView::secondSurfaceChanged, this, &ViewActions::markSecond);
  before_after_ = menu.addAction(tr("Before and after"));
  before_after_->setObjectName("beforeAfter");
  before_after_->setCheckable(true);
  giveKeys(*before_after_, Action::BeforeAfter,
           tr("The unedited scan beside what is left of it, seen from the same place"));
  before_after_->setEnabled(false);
  for (QMenu* part : {presets_, colours_, second_}) part->setEnabled(false);
  menu.addSeparator();
}

void ViewActions::buildTool(QMenu& menu, TopBar& bar) {
  QAction* take = menu.addAction(tr("Ta&ke the tool with the mouse"));
  take->setObjectName("takeTool");
  take->setIconText(tr("Take tool"));
  giveKeys(*take, Action::TakeTool,
           tr("The mouse holds the tool. The tool itself can be dragged at any time"));
  take->setCheckable(true);
  connect(take, &QAction::triggered, &view_, [this, take](bool on) {
    view_.setMouseMode(on ? MouseMode::Hand : MouseMode::Look);
    take->setChecked(view_.mouseMode() == MouseMode::Hand);
    view_.setFocus();
  });
  take->setEnabled(view_.mouseHand());
  connect(&view_, &VolumeView::mouseHandChanged, take, &QAction::setEnabled);
  connect(&view_, &VolumeView::mouseModeChanged, take,
          [take](MouseMode mode) { take->setChecked(mode == MouseMode::Hand); });
  bar.add(BarGroup::Tools, *take, "hand");
  QAction* to_cross =
      menu.addAction(tr("T&ool to crosshair"), &view_, &VolumeView::toolToCrossWanted);
  to_cross->setObjectName("toolToCross");
  showKey(*to_cross, Action::ToolToCross);
  QAction* to_tool =
      menu.addAction(tr("Crosshair to tool"), &view_, &VolumeView::crossToToolWanted);
  to_tool->setObjectName("crossToTool");
  showKey(*to_tool, Action::CrossToTool);
  QAction* contacts = menu.addAction(tr("Contacts and &force"));
  contacts->setObjectName("showContacts");
  contacts->setCheckable(true);
  connect(contacts, &QAction::toggled, &view_, &VolumeView::showContacts);
}

void ViewActions::show(const Picture& picture) {
  picture_ = picture;
  before_after_->setEnabled(true);
  for (QMenu* part : {presets_, colours_, second_}) part->setEnabled(true);
  // without a unit no intensity is a tissue until the user says so
  setColours(picture.volume->unit == "HU" ? SurfaceColours::Tissue : SurfaceColours::Ivory);
}

void ViewActions::setColours(SurfaceColours colours) {
  if (!picture_) return;
  colouring_ = colours;
  (colours == SurfaceColours::Ivory ? ivory_ : by_value_)->setChecked(true);
  view_.setColouring(Colouring::of(colours, *picture_));
}

void ViewActions::look(const ViewLook& look) {
  if (!picture_) return;
  setColours(look.colours);
  view_.setSecondSurface(look.second);
  view_.setSecondOpacity(look.second_opacity);
}

void ViewActions::markSecond() {
  const std::optional<double> second = view_.surface().second();
  // the entry of its tissue; another isovalue was held
  QAction* entry = second ? second_->actions().last() : no_second_;
  for (std::size_t n = 0; second && picture_ && n < kTissues.size(); ++n)
    if (isovalueOf(kTissues[n], *picture_) == *second)
      entry = second_->actions()[static_cast<int>(n) + 1];
  entry->setChecked(true);
}

void ViewActions::choose(Tissue tissue) {
  if (!picture_) return;
  setColours(tissue == Tissue::Vessels ? SurfaceColours::Vessels : SurfaceColours::Tissue);
  emit isovalueWanted(isovalueOf(tissue, *picture_));
}

}  // namespace ui
