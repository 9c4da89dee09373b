// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "haptics/core/geometry.h"
#include "haptics/recording/recording.h"

namespace app {

/// From where a picture is taken, in W.
struct FilmCamera {
  haptics::Vec3 position_mm = haptics::Vec3::Zero();
  haptics::Vec3 focus_mm = haptics::Vec3::Zero();
  haptics::Vec3 up = haptics::Vec3::UnitZ();
  double angle_deg = 30.0;  ///< from the lower to the upper edge of the picture
};

/// A camera as the text of a recording's event of kind "camera".
std::string wordsOf(const FilmCamera& camera);
/// None of what no picture can be taken from: no such text, a number that is not finite, up along
/// the line of sight, an angle below 1 or above 170 degrees.
std::optional<FilmCamera> cameraFrom(const std::string& text);

/// The cameras that a recording holds: each from its event until the next.
class CameraPath {
 public:
  explicit CameraPath(const haptics::Recording& recording);
  bool empty() const { return stations_.empty(); }
  /// Before the first event, the first. Not of an empty path.
  const FilmCamera& at(std::int64_t time_ns) const;

 private:
  struct Station {
    std::int64_t time_ns;
    FilmCamera camera;
  };
  std::vector<Station> stations_;
};

/// What is to be in the picture, in W.
struct FilmBall {
  haptics::Vec3 centre_mm = haptics::Vec3::Zero();
  double radius_mm = 0.0;
};
/// Sees at least one ball, and all of them, from a direction that is not along z, head up, and from
/// no farther than that takes. `aspect` is width over height.
FilmCamera cameraAround(const std::vector<FilmBall>& balls, const haptics::Vec3& from,
                        double aspect);

}  // namespace app
