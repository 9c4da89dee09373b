// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/recording/recording.h"
#include "haptics/core/geometry.h"

namespace app {

/// The view of a picture, in W.
struct FilmCamera {
  haptics::Vec3 position_mm = haptics::Vec3::Zero();
  haptics::Vec3 focus_mm = haptics::Vec3::Zero();
  haptics::Vec3 up = haptics::Vec3::UnitZ();
  double angle_deg = 30.0;  ///< vertical field of view
};

/// A camera as the text of a recording's event of kind "camera".
std::string wordsOf(const FilmCamera& camera);
/// Nullopt for an invalid camera: text in another form, a number that is not finite, `up` along the
/// line of sight, or an angle below 1 or above 170 degrees.
std::optional<FilmCamera> cameraFrom(const std::string& text);

/// The cameras of a recording. Each is valid from its event until the next.
class CameraPath {
 public:
  explicit CameraPath(const Recording& recording);
  bool empty() const { return stations_.empty(); }
  /// Times before the first event use the first camera. The path must not be empty.
  const FilmCamera& at(std::int64_t time_ns) const;

 private:
  struct Station {
    std::int64_t time_ns;
    FilmCamera camera;
  };
  std::vector<Station> stations_;
};

/// A ball that the picture must show, in W.
struct FilmBall {
  haptics::Vec3 centre_mm = haptics::Vec3::Zero();
  double radius_mm = 0.0;
};
/// The nearest camera that sees all balls. There must be at least one. `from` is the direction from
/// the balls to the camera and must not be along z; +z is up in the picture. `aspect` is width over
/// height.
FilmCamera cameraAround(const std::vector<FilmBall>& balls, const haptics::Vec3& from,
                        double aspect);

}  // namespace app
