// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/picture_controller.h"

#include <vtkPolyData.h>

#include <cstddef>
#include <cstdint>

#include "ui/volume_view.h"

namespace app {
namespace {

constexpr int kDisplayMs = 16;  // 60 Hz
constexpr std::size_t kSamplesAtOnce = 4096;
// A fine mesh of more voxels than this would take seconds to draw where there is no GPU.
constexpr std::int64_t kFineVoxels = 24'000'000;

}  // namespace

PictureController::PictureController(ui::MainWindow& window, SharedState& shared)
    : window_(window), shared_(shared), panel_(new ui::ForcePanel), samples_(kSamplesAtOnce) {
  window.setForceCard(*panel_);
  connect(&window, &ui::MainWindow::worded, panel_, &ui::ForcePanel::display);
  connect(&window.view(), &ui::VolumeView::fineMeshWanted, this, &PictureController::makeFineMesh);
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
  if (snapshot.scene != shared_.shown->scene->id) return window_.displayForce(snapshot);
  window_.display(snapshot);
  if (look_) {
    look_ = false;
    window_.view().lookFromTool();
  }
}

void PictureController::showForces() {
  while (const std::size_t count = shared_.session.forces(samples_)) {
    appendForces(std::span{samples_}.first(count));
    if (count < samples_.size()) break;
  }
}

void PictureController::makeFineMesh(double isovalue) {
  // the one on view: in a replay it is not the one that is touched
  const ui::Picture& picture = window_.view().picture();
  if (!picture.volume) return;
  mesh_next_ = isovalue;
  if (mesher_.isRunning()) return;
  mesh_next_.reset();
  mesher_.start(
      [isovalue, volume = picture.volume, mirrored = picture.mirrored()](
          const background::Watch&) -> haptics::Expected<vtkSmartPointer<vtkPolyData>> {
        background::goLast();  // an edit or another volume comes first
        // with a crop: closed at its faces, as the reduced mesh is
        const auto image = volume->grid.voxelCount() <= kFineVoxels && !volume->crop
                               ? ui::imageOf(*volume)
                               : ui::reducedImageOf(*volume, kFineVoxels);
        return ui::isosurfaceMesh(image, isovalue, mirrored);
      },
      [this, isovalue,
       volume = picture.volume](const haptics::Expected<vtkSmartPointer<vtkPolyData>>& mesh) {
        // without one the reduced mesh stays
        const bool same = window_.view().picture().volume == volume;
        if (same && mesh && *mesh) window_.view().showFine(*mesh, isovalue);
        if (mesh_next_ && !(same && *mesh_next_ == isovalue)) makeFineMesh(*mesh_next_);
      });
}

}  // namespace app
