// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/views/fine_mesher.h"

#include <vtkPolyData.h>

#include <cstdint>

namespace app {
namespace {

// A fine mesh of more voxels than this would take seconds to draw where there is no GPU.
constexpr std::int64_t kFineVoxels = 24'000'000;

}  // namespace

void FineMesher::serve(ui::VolumeView& view) {
  task_.abandon();
  view_ = &view;
  connect(&view, &ui::VolumeView::fineMeshWanted, this, &FineMesher::make);
}

void FineMesher::make(double isovalue) {
  if (!view_) return;
  // the one on view: in a replay it is not the one that is touched
  const ui::Picture& picture = view_->picture();
  if (!picture.volume) return;
  next_ = isovalue;
  if (task_.isRunning()) return;
  next_.reset();
  task_.start(
      [isovalue, volume = picture.volume, mirrored = picture.mirrored()](
          const background::Watch&) -> haptics::Expected<vtkSmartPointer<vtkPolyData>> {
        background::goLast();  // an edit or another volume comes first
        // closed at the cut faces, which are felt too
        return ui::isosurfaceMesh(ui::reducedImageOf(*volume, kFineVoxels), isovalue, mirrored);
      },
      [this, isovalue,
       volume = picture.volume](const haptics::Expected<vtkSmartPointer<vtkPolyData>>& mesh) {
        // without one the reduced mesh stays
        const bool same = view_ && view_->picture().volume == volume;
        if (same && mesh && *mesh) view_->showFine(*mesh, isovalue);
        if (next_ && !(same && *next_ == isovalue)) make(*next_);
      });
}

}  // namespace app
