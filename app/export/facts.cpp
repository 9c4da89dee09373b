// SPDX-License-Identifier: BSD-3-Clause
#include "app/export/facts.h"

#include "app/export/text.h"

namespace app::exporting {

using nlohmann::ordered_json;

namespace {

ordered_json listOf(const haptics::Vec3& v) { return {v.x(), v.y(), v.z()}; }

std::string hexOf(const VolumeHash& hash) {
  constexpr char kDigits[] = "0123456789abcdef";
  std::string hex;
  for (const std::uint8_t byte : hash) {
    hex += kDigits[byte >> 4];
    hex += kDigits[byte & 15];
  }
  return hex;
}

}  // namespace

ordered_json factsOf(const Recording& recording) {
  return {{"palpate", plain(recording.version())},
          {"build", plain(recording.build())},
          {"machine", plain(recording.machine())},
          {"vectors", plain(recording.vectors())},
          {"frame", "the scan's, metres: patient LPS where a scene's orientation is known"},
          {"steps", recording.stepCount()},
          {"lost_steps", recording.lostCount()}};
}

ordered_json factsOf(const RecordedScene& scene) {
  const haptics::Volume& volume = scene.volume;
  const haptics::Mat3& direction = volume.grid.direction;
  ordered_json facts = {
      {"tool", plain(scene.tool.name)},
      {"points", scene.tool.shell.points.size()},
      {"tool_origin_m", listOf(scene.tool.shell.origin)},
      {"dims", volume.grid.dims},
      {"spacing_m", listOf(volume.grid.spacing)},
      {"origin_m", listOf(volume.grid.origin)},
      {"direction", {listOf(direction.row(0)), listOf(direction.row(1)), listOf(direction.row(2))}},
      {"scalar", haptics::nameOf(volume.type)},
      {"least", volume.least},
      {"greatest", volume.greatest},
      {"unit", plain(volume.unit)},
      {"modality", plain(volume.modality)},
      {"orientation_known", volume.orientation_known},
      {"resampled", volume.resampled},
      {"slices_left_out", volume.slices_left_out}};
  if (scene.hash) facts["volume_hash"] = hexOf(*scene.hash);
  return facts;
}

}  // namespace app::exporting
