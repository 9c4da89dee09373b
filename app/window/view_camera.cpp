// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/view_camera.h"

#include "ui/volume_view.h"

namespace app {

FilmCamera cameraOf(ui::VolumeView& view) {
  vtkCamera* camera = view.camera();
  const auto vector = [](const double* v) { return haptics::Vec3(v[0], v[1], v[2]); };
  return {vector(camera->GetPosition()), vector(camera->GetFocalPoint()),
          vector(camera->GetViewUp()), camera->GetViewAngle()};
}

}  // namespace app
