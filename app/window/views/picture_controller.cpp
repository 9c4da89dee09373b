// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/views/picture_controller.h"

#include <vtkPolyData.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "app/window/scan/touched_surface.h"
#include "ui/views/volume_view.h"

namespace app {
namespace {

constexpr int kDisplayMs = 16;  // 60 Hz
constexpr std::size_t kSamplesAtOnce = 4096;
// A fine mesh of more voxels than this would take seconds to draw where there is no GPU.
constexpr std::int64_t kFineVoxels = 24'000'000;

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
  connect(&views.volume(), &ui::VolumeView::fineMeshWanted, this, &PictureController::makeFineMesh);
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

void PictureController::makeFineMesh(double isovalue) {
  // the one on view: in a replay it is not the one that is touched
  const ui::Picture& picture = views_.volume().picture();
  if (!picture.volume) return;
  mesh_next_ = isovalue;
  if (mesher_.isRunning()) return;
  mesh_next_.reset();
  mesher_.start(
      [isovalue, volume = picture.volume, mirrored = picture.mirrored()](
          const background::Watch&) -> haptics::Expected<vtkSmartPointer<vtkPolyData>> {
        background::goLast();  // an edit or another volume comes first
        // closed at the cut faces, which are felt too
        return ui::isosurfaceMesh(ui::reducedImageOf(*volume, kFineVoxels), isovalue, mirrored);
      },
      [this, isovalue,
       volume = picture.volume](const haptics::Expected<vtkSmartPointer<vtkPolyData>>& mesh) {
        // without one the reduced mesh stays
        const bool same = views_.volume().picture().volume == volume;
        if (same && mesh && *mesh) views_.volume().showFine(*mesh, isovalue);
        if (mesh_next_ && !(same && *mesh_next_ == isovalue)) makeFineMesh(*mesh_next_);
      });
}

}  // namespace app
