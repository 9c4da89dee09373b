// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/scan/view_camera.h"

#include <vtkCamera.h>

#include <cmath>
#include <numbers>

#include "ui/views/volume_view.h"

namespace app {

FilmCamera cameraOf(ui::VolumeView& view) {
  vtkCamera* camera = view.camera();
  const auto vector = [](const double* v) { return haptics::Vec3(v[0], v[1], v[2]); };
  FilmCamera film{vector(camera->GetPosition()), vector(camera->GetFocalPoint()),
                  vector(camera->GetViewUp()), camera->GetViewAngle()};
  if (camera->GetParallelProjection() == 0) return film;
  // from where perspective shows the focal point as large
  const double half = std::tan(0.5 * film.angle_deg * std::numbers::pi / 180.0);
  const haptics::Vec3 towards = (film.position_mm - film.focus_mm).normalized();
  film.position_mm = film.focus_mm + towards * (camera->GetParallelScale() / half);
  return film;
}

}  // namespace app
