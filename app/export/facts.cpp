// SPDX-License-Identifier: BSD-3-Clause
#include "app/export/facts.h"

#include "app/export/text.h"
#include "haptics/process/input_file.h"

namespace app::exporting {

using nlohmann::ordered_json;

namespace {

ordered_json listOf(const haptics::Vec3& v) { return {v.x(), v.y(), v.z()}; }

constexpr int kExportVersion = 1;  // README.md says what may change

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

haptics::Vec3 frictionOf(const haptics::Step& step) {
  if (!(step.settings.friction > 0.0)) return haptics::Vec3::Zero();
  haptics::Vec3 pushes = haptics::Vec3::Zero();
  for (const haptics::BearingContact& contact : step.contacts) pushes += contact.push * contact.n_W;
  const double size = pushes.norm();
  if (!(size > 0.0)) return haptics::Vec3::Zero();
  const haptics::Vec3 normal = pushes / size;
  const haptics::Vec3 force =
      step.settings.stiffness * (step.X_WP.translation() - step.X_WD.translation());
  return force - force.dot(normal) * normal;
}

ordered_json conventions() {
  return {
      {"quaternion",
       "A quaternion w, x, y, z turns the tool's coordinates into the scan's: a point of the tool "
       "is at q p q* + position; w is never negative."},
      {"tool_origin",
       "A position is that of the tool's origin, the centroid of its points, which lies at "
       "tool_origin in the frame of the tool's own file."},
      {"force_law",
       "Before the device's limits and the force scale, the force on the hand is the stiffness "
       "times the way from device to proxy, and the torque about the device's origin is the "
       "angular stiffness times the rotation vector from device to proxy; an angular stiffness of "
       "0 stands for the stiffness times the tool's mean inertia about that axis."}};
}

namespace {

/// How a run was asked for, as the recording tells it; nothing of what it does not tell rightly.
void tellAbout(const Recording& recording, ordered_json& facts) {
  const std::string& about = recording.about();
  if (about.empty() || haptics::isNestedDeeper(about, haptics::kDeepestJson)) return;
  const ordered_json told = ordered_json::parse(about, nullptr, false);
  if (!told.is_object()) return;
  for (const char* name :
       {"program", "commit", "run_scene", "run_hand", "run_device", "run_budget_clock"})
    if (told.contains(name) && told[name].is_string())
      facts[name] = plain(told[name].get<std::string>());
  for (const char* name : {"run_seed", "run_budget_work", "began_unix_ns"})
    if (told.contains(name) && told[name].is_number_integer()) facts[name] = told[name];
  if (told.contains("voxels_sha256") && told["voxels_sha256"].is_string())
    facts["voxels_sha256"] = plain(told["voxels_sha256"].get<std::string>());
}

}  // namespace

ordered_json factsOf(const Recording& recording) {
  ordered_json facts{{"export_version", kExportVersion}, {"palpate", plain(recording.version())}};
  tellAbout(recording, facts);
  int rate = haptics::ServoRate{}.hz;
  for (const haptics::ProxyStart& start : recording.starts()) rate = start.rate.hz;
  facts.update(ordered_json{
      {"build", plain(recording.build())},
      {"machine", plain(recording.machine())},
      {"vectors", plain(recording.vectors())},
      {"rate_Hz", rate},
      {"frame", "the scan's, metres: patient LPS where a scene's orientation is known"},
      {"steps", recording.stepCount()},
      {"lost_steps", recording.lostCount()}});
  facts.update(conventions());
  return facts;
}

ordered_json factsOf(const RecordedScene& scene) {
  const haptics::Volume& volume = scene.volume;
  const haptics::Mat3& direction = volume.grid.direction;
  ordered_json facts = {
      {"tool", plain(scene.tool.name)},
      {"field", nameOf(scene.options.field)},
      {"normals", nameOf(scene.options.normal)},
      {"epsilon_voxels", scene.options.fineness.epsilon},
      {"sub_steps", scene.options.fineness.sub_steps},
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
