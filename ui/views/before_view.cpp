// SPDX-License-Identifier: BSD-3-Clause
#include "ui/views/before_view.h"

#include <QKeyEvent>

namespace ui {

BeforeView::BeforeView(VolumeView& after, const Picture& scan) : after_(&after) {
  setAccessibleName(tr("Unedited scan"));
  // both have the long words, or both the short ones
  const QString here = tr("Before: unedited scan"), there = tr("After: what is left");
  const QString& widest = here.size() > there.size() ? here : there;
  setCaption(here, tr("Before"), widest);
  after.setCaption(there, tr("After"), widest);
  setMouse(after.mouse());
  setTouched(after.touched());  // a zoom keeps the place of what is left, in both
  show(scan, after.surface().isovalue());
  takeLook();
  follow(after);
  connect(&after, &VolumeView::lookChanged, this, &BeforeView::takeLook);
  connect(&after, &VolumeView::secondSurfaceChanged, this, &BeforeView::takeLook);
  connect(&after, &VolumeView::surfaceChosen, this, &BeforeView::takeLook);
  connect(&after, &VolumeView::cameraChanged, this, [this] { follow(*after_); });
  connect(this, &VolumeView::cameraChanged, &after, [this] { after_->follow(*this); });
  connect(this, &VolumeView::forceOffWanted, &after, &VolumeView::forceOffWanted);
}

BeforeView::~BeforeView() {
  if (after_) after_->setCaption({}, {}, {});
}

void BeforeView::takeLook() {
  setSurfaceWish(after_->surface().mode());
  setIsovalue(after_->surface().isovalue());
  setColouring(after_->surface().colouring());
  setSecondSurface(after_->surface().second());
  setSecondOpacity(after_->secondOpacity());
}

void BeforeView::keyPressEvent(QKeyEvent* event) {
  // the tool is in the other one
  const Binding* meaning = meaningOf(Where::Space, *event);
  if (meaning != nullptr && meaning->action == Action::LookAlongTool)
    return after_->lookAlongTool();
  if (meaning != nullptr && meaning->action == Action::LookFromTool) return after_->lookFromTool();
  VolumeView::keyPressEvent(event);
}

}  // namespace ui
