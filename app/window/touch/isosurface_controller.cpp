// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/touch/isosurface_controller.h"

#include <QStatusBar>

#include "ui/panels/second_surface.h"
#include "ui/views/volume_view.h"

namespace app {
namespace {

constexpr int kRefusedMs = 6000;

}  // namespace

IsosurfaceController::IsosurfaceController(ui::Views& views, ui::Messages& messages,
                                           ui::SidePanel& panels, SharedState& shared)
    : views_(views), shared_(shared), panel_(new ui::IsosurfacePanel) {
  panels.add(panel_, tr("Surface"), tr("Isosurface"), "surfaceSection", ui::Tab::Touch);
  connect(panel_, &ui::IsosurfacePanel::isovalueChanged, this, &IsosurfaceController::apply);
  connect(panel_, &ui::IsosurfacePanel::refused, this,
          [&messages](const QString& sentence) { messages.showBriefly(sentence, kRefusedMs); });
  connect(&views, &ui::Views::isovalueWanted, panel_, &ui::IsosurfacePanel::choose);
  ui::VolumeView& view = views.volume();
  ui::SecondSurface& second = panel_->second();
  connect(&view, &ui::VolumeView::secondSurfaceChanged, &second,
          [&view, &second] { second.show(view.surface().second(), view.secondOpacity()); });
  connect(&second, &ui::SecondSurface::opacityWanted, &view, &ui::VolumeView::setSecondOpacity);
  connect(&second, &ui::SecondSurface::isovalueWanted, &view, [&view](double isovalue) {
    view.setSecondSurface(ui::allowedIsovalue(*view.picture().volume, isovalue));
  });
}

void IsosurfaceController::showScene(bool new_volume) {
  const ui::Picture& picture = shared_.shown->picture;
  if (new_volume)
    panel_->show(picture, shared_.settings.isovalue);
  else
    panel_->replace(picture);
}

void IsosurfaceController::show(const ui::Picture& picture, double isovalue) {
  panel_->show(picture, isovalue);
  views_.setIsovalue(isovalue);
}

void IsosurfaceController::set(double isovalue) {
  panel_->show(shared_.shown->picture, isovalue);
  apply(isovalue);
}

void IsosurfaceController::apply(double isovalue) {
  views_.setIsovalue(isovalue);
  shared_.settings.isovalue = isovalue;
  shared_.apply();
  emit changed(isovalue);
}

}  // namespace app
