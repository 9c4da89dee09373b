// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/views/picture_controller.h"

#include <algorithm>
#include <cstddef>

#include "app/window/scan/touched_surface.h"
#include "ui/views/volume_view.h"

namespace app {
namespace {

constexpr int kDisplayMs = 16;  // 60 Hz
constexpr std::size_t kSamplesAtOnce = 4096;

}  // namespace

PictureController::PictureController(ui::Views& views, ui::TouchState& touch, SharedState& shared)
    : views_(views),
      touch_(touch),
      shared_(shared),
      panel_(new ui::ForcePanel),
      samples_(kSamplesAtOnce) {
  views.setForceCard(*panel_);
  connect(&touch, &ui::TouchState::worded, panel_, [this](const haptics::Snapshot& snapshot) {
    panel_->display(snapshot, touchedIn(snapshot));
  });
  connect(&touch, &ui::TouchState::handNamed, panel_,
          [this](const QString& label) { panel_->setHand(label); });
  mesher_.serve(views.volume());
  display_.setInterval(kDisplayMs);
  display_.setTimerType(Qt::PreciseTimer);
  connect(&display_, &QTimer::timeout, this, &PictureController::refresh);
}

void PictureController::refresh() {
  haptics::Session& session = shared_.session;
  session.collectGarbage();
  // first: after a busy moment the one before is old
  haptics::Snapshot& snapshot = shared_.snapshot;
  const bool fresh = session.latest(snapshot);
  emit refreshing();
  showForces();
  if (!fresh || !shared_.shown) return;
  emit snapshotTaken();
  // poses of the old scene would mislead in the new one
  if (snapshot.scene != shared_.shown->scene->id) return touch_.display(snapshot);
  views_.display(snapshot);
  touch_.display(snapshot);
  if (look_) {
    look_ = false;
    views_.volume().lookFromTool();
  }
}

/// At the place that is pressed hardest.
std::optional<ui::TouchedValue> PictureController::touchedIn(
    const haptics::Snapshot& snapshot) const {
  if (!shared_.shown || snapshot.scene != shared_.shown->scene->id || snapshot.contacts <= 0 ||
      shared_.replays_other)
    return {};
  const auto places = std::span{snapshot.places}.first(
      std::min<std::size_t>(static_cast<std::size_t>(snapshot.contacts), snapshot.places.size()));
  const auto hardest = std::ranges::max_element(places, {}, &haptics::ContactPlace::push);
  const haptics::Vec3 p_W = Eigen::Map<const Eigen::Vector3f>(hardest->p_W.data()).cast<double>();
  return ui::TouchedValue{valueBehind(shared_.shown->seenScene()->field, p_W),
                          QString::fromStdString(shared_.shown->volume()->unit),
                          solid_at_(p_W * ui::kMmPerM)};
}

void PictureController::showForces() {
  while (const std::size_t count = shared_.session.forces(samples_)) {
    appendForces(std::span{samples_}.first(count));
    if (count < samples_.size()) break;
  }
}

}  // namespace app
