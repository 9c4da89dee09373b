// SPDX-License-Identifier: BSD-3-Clause
#include "app/film/camera.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "haptics/process/input_file.h"

namespace app {
namespace {

using haptics::Vec3;
using nlohmann::json;

bool sees(const FilmCamera& camera) {
  const Vec3 away = camera.focus_mm - camera.position_mm;
  constexpr double kFarthest_mm = 1e7;
  return camera.position_mm.allFinite() && camera.focus_mm.allFinite() && camera.up.allFinite() &&
         camera.position_mm.norm() < kFarthest_mm && camera.focus_mm.norm() < kFarthest_mm &&
         away.norm() > 1e-3 &&
         away.normalized().cross(camera.up.stableNormalized()).norm() > 1e-3 &&
         camera.angle_deg >= 1.0 && camera.angle_deg <= 170.0;
}

json listOf(const Vec3& v) { return {v.x(), v.y(), v.z()}; }
Vec3 vectorFrom(const json& list) {
  const auto numbers = list.get<std::array<double, 3>>();
  return Vec3{numbers.data()};
}

}  // namespace

std::string wordsOf(const FilmCamera& camera) {
  return json{{"position_mm", listOf(camera.position_mm)},
              {"focus_mm", listOf(camera.focus_mm)},
              {"up", listOf(camera.up)},
              {"angle_deg", camera.angle_deg}}
      .dump();
}

std::optional<FilmCamera> cameraFrom(const std::string& text) {
  if (haptics::isNestedDeeper(text, haptics::kDeepestJson)) return {};
  try {
    const json words = json::parse(text);
    const FilmCamera camera{vectorFrom(words.at("position_mm")), vectorFrom(words.at("focus_mm")),
                            vectorFrom(words.at("up")), words.at("angle_deg").get<double>()};
    if (sees(camera)) return camera;
  } catch (const json::exception&) {
  }
  return {};
}

CameraPath::CameraPath(const Recording& recording) {
  for (const RecordedEvent& event : recording.events()) {
    if (event.kind != "camera") continue;
    if (const auto camera = cameraFrom(event.text)) stations_.push_back({event.time_ns, *camera});
  }
}

const FilmCamera& CameraPath::at(std::int64_t time_ns) const {
  const auto after = std::upper_bound(
      stations_.begin(), stations_.end(), time_ns,
      [](std::int64_t time, const Station& station) { return time < station.time_ns; });
  return (after == stations_.begin() ? after : after - 1)->camera;
}

FilmCamera cameraAround(const std::vector<FilmBall>& balls, const Vec3& from, double aspect) {
  FilmCamera camera;
  haptics::Mat3 axes;  // right, up, towards the eye
  axes.col(2) = from.normalized();
  axes.col(0) = Vec3::UnitZ().cross(axes.col(2)).normalized();
  axes.col(1) = axes.col(2).cross(axes.col(0));
  Eigen::AlignedBox3d seen;
  for (const FilmBall& ball : balls) {
    const Vec3 p = axes.transpose() * ball.centre_mm;
    seen.extend(Vec3{p.array() - ball.radius_mm});
    seen.extend(Vec3{p.array() + ball.radius_mm});
  }
  camera.focus_mm = axes * seen.center();
  constexpr double kFilled = 0.92;  // of the picture's half
  const double slope = kFilled * std::tan(0.5 * camera.angle_deg * std::numbers::pi / 180.0);
  double distance = 1.0;
  for (const FilmBall& ball : balls) {
    const Vec3 p = axes.transpose() * (ball.centre_mm - camera.focus_mm);
    const double r = ball.radius_mm;
    const double across = std::max(std::abs(p.y()) + r, (std::abs(p.x()) + r) / aspect);
    distance = std::max(distance, across / slope + p.z() + r);
  }
  camera.position_mm = camera.focus_mm + axes.col(2) * distance;
  return camera;
}

}  // namespace app
