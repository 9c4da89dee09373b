// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/views/before_controller.h"

#include <QAction>

#include "app/window/scan/edited_volume.h"
#include "app/window/scan/sentence.h"
#include "ui/views/before_view.h"

namespace app {

BeforeController::BeforeController(ui::Views& views, ui::Messages& messages, SharedState& shared)
    : views_(views), messages_(messages), shared_(shared) {
  connect(&views.beforeAfter(), &QAction::toggled, this, &BeforeController::want);
}

void BeforeController::showScene() {
  if (scan_ && scanOf(shared_.shown->volume()) != scan_) views_.beforeAfter().setChecked(false);
}

void BeforeController::want(bool on) {
  painter_.abandon();
  scan_ = on && shared_.shown ? scanOf(shared_.shown->volume()) : nullptr;
  if (!scan_) return views_.hideBefore();
  // nothing was taken away from it: it has a picture
  if (shared_.shown->picture.volume == scan_) return show(shared_.shown->picture);
  painter_.start(
      [scan = scan_](const background::Watch& watch) -> haptics::Expected<ui::Picture> {
        return ui::pictureOf(scan, &watch.cancel);
      },
      [this](const haptics::Expected<ui::Picture>& picture) {
        if (picture) return show(*picture);
        messages_.showMessage(sentenceOf(picture.error()));
        views_.beforeAfter().setChecked(false);
      });
}

void BeforeController::show(const ui::Picture& picture) {
  views_.showBefore(picture);
  mesher_.serve(*views_.before());
}

}  // namespace app
