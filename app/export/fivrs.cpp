// SPDX-License-Identifier: BSD-3-Clause
#include "app/export/fivrs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <utility>

#include "app/export/removed_voxels.h"
#include "app/export/selection.h"
#include "app/recording/recorded_cuts.h"

namespace app::exporting {
namespace {

constexpr const char* kTimeMeaning = "time since the recording began";
constexpr int kStepsBetweenQuestions = 512;
constexpr double kMmPerM = 1e3;
// red, green, blue, opacity of 255: bone, as FIVRS has it
constexpr std::array<double, 4> kBone{255.0, 249.0, 219.0, 255.0};

/// The removed voxels: times, and rows that say at which of the times.
struct VoxelTables {
  explicit VoxelTables(hid_t file)
      : time{file, "physics_data/intermittent_data/voxels_removed/voxel_time_stamp", 0, "s",
             "time since the recording began of each step whose cut removed voxels"},
        removed{file, "physics_data/intermittent_data/voxels_removed/voxel_removed", 4, "",
                "row of voxel_time_stamp; index i, j, k of a voxel of the scan whose value fell "
                "below the isovalue of the cut and was not below it before"},
        colour{file, "physics_data/intermittent_data/voxels_removed/voxel_color", 5, "",
               "row of voxel_time_stamp; red, green, blue and opacity of 255: that of bone for "
               "all, as "
               "structures are not told apart"} {}

  void add(double time_s, std::span<const RemovedVoxels::Index> voxels) {
    if (voxels.empty()) return;
    const auto row = static_cast<double>(time.rows());
    time.add(time_s);
    for (const auto& [i, j, k] : voxels) {
      const double at[] = {row, double(i), double(j), double(k)};
      removed.add(at);
      const double looks[] = {row, kBone[0], kBone[1], kBone[2], kBone[3]};
      colour.add(looks);
    }
  }
  bool sound() const { return time.sound() && removed.sound() && colour.sound(); }
  bool flush() { return time.flush() && removed.flush() && colour.flush(); }

  Table<double> time, removed, colour;
};

/// The burrs of the steps, one after another.
struct BurrTables {
  explicit BurrTables(hid_t file)
      : size{file, "physics_data/intermittent_data/burr_change/burr_size", 0, "mm",
             "diameter of the burr from this time on"},
        time{file, "physics_data/intermittent_data/burr_change/time_stamp", 0, "s", kTimeMeaning} {}

  void add(double time_s, double diameter_mm) {
    if (diameter_mm == last_mm_) return;
    last_mm_ = diameter_mm;
    size.add(diameter_mm);
    time.add(time_s);
  }
  bool sound() const { return size.sound() && time.sound(); }
  bool flush() { return size.flush() && time.flush(); }

  Table<double> size, time;

 private:
  std::optional<double> last_mm_;
};

bool writeVoxelVolume(hid_t file, const haptics::Grid& grid) {
  const double volume = (grid.spacing * kMmPerM).prod();
  const Handle way{H5Pcreate(H5P_LINK_CREATE), H5Pclose};
  H5Pset_create_intermediate_group(way, 1);
  const Handle layout{H5Pcreate(H5P_DATASET_CREATE), H5Pclose};
  H5Pset_obj_track_times(layout, false);
  const Handle space{H5Screate(H5S_SCALAR), H5Sclose};
  const Handle dataset{H5Dcreate2(file, "metadata_v3/voxel_volume", H5T_NATIVE_DOUBLE, space, way,
                                  layout, H5P_DEFAULT),
                       H5Dclose};
  attach(dataset, "unit", std::string{"mm3"});
  attach(dataset, "meaning", std::string{"volume of a voxel of the scan"});
  return H5Dwrite(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, &volume) >= 0;
}

/// FIVRS had its groups at the root before, and some of its scripts look for them there.
bool linkAtRoot(hid_t file, bool metadata, bool voxels) {
  const auto link = [&](const char* to, const char* name) {
    return H5Lcreate_soft(to, file, name, H5P_DEFAULT, H5P_DEFAULT) >= 0;
  };
  return (!metadata || link("/metadata_v3", "metadata")) &&
         link("/physics_data/intermittent_data/burr_change", "burr_change") &&
         link("/physics_data/intermittent_data/drill_force_feedback", "drill_force_feedback") &&
         (!voxels || link("/physics_data/intermittent_data/voxels_removed", "voxels_removed"));
}

}  // namespace

DrillForce::DrillForce(hid_t file)
    : wrench{file, "physics_data/intermittent_data/drill_force_feedback/wrench", 6, "N, N.m",
             "force x, y, z and torque x, y, z sent to the hand, the torque about the device's "
             "origin"},
      time{file, "physics_data/intermittent_data/drill_force_feedback/time_stamp", 0, "s",
           kTimeMeaning} {}

void DrillForce::add(const haptics::Step& step) {
  const haptics::Wrench& sent = step.sent_W;
  const double row[] = {sent.force.x(),  sent.force.y(),  sent.force.z(),
                        sent.torque.x(), sent.torque.y(), sent.torque.z()};
  wrench.add(row);
  time.add(double(step.time_ns) * 1e-9);
}

haptics::Expected<bool> writeDrilling(hid_t file, Recording& recording,
                                      const ExportOptions& options, Exported& exported) {
  const auto laws = lawsOf(recording);
  if (!laws) return tl::unexpected(laws.error());
  std::map<std::uint32_t, std::shared_ptr<const haptics::Volume>> volumes;
  if (options.volume)
    for (const RecordedScene& scene : recording.scenes())
      if (auto volume = options.volume(scene.id)) volumes[scene.id] = std::move(volume);
  std::optional<VoxelTables> voxels;
  if (!volumes.empty()) voxels.emplace(file);
  BurrTables burrs{file};
  std::optional<RemovedVoxels> removed;  // of the scene of the last cut
  std::uint32_t scene = 0;

  const Window window = windowOf(options);
  std::int64_t read = 0, count = 0;
  bool sound = true, cancelled = false;
  std::optional<haptics::Error> failed;
  const auto add = [&](const haptics::Step& step) -> haptics::Expected<void> {
    const double time = double(step.time_ns) * 1e-9;
    const bool chosen = step.time_ns >= window.from;
    const auto law = laws->find(step.scene);
    if (chosen && law != laws->end()) burrs.add(time, 2.0 * law->second.burr.radius * kMmPerM);
    if (!step.cut) return {};
    const auto volume = volumes.find(step.scene);
    if (volume == volumes.end()) {
      exported.cuts_without_voxels += chosen;
      return {};
    }
    if (!removed || step.scene != scene) removed.emplace(volume->second);
    scene = step.scene;
    const auto gone = removed->carve(*step.cut);
    if (!gone) return tl::unexpected(gone.error());
    if (!chosen) return {};
    voxels->add(time, *gone);
    count += static_cast<std::int64_t>(gone->size());
    return {};
  };
  // from the beginning, since what was cut before `from` is not cut again
  constexpr double kMargin = 1e-3;  // s, as in forEachChosen
  const auto done =
      recording.forEach(-INFINITY, options.to + kMargin, [&](const RecordedStep& row) {
        if (row.step.time_ns > window.to) return false;
        if (read++ % kStepsBetweenQuestions == 0 && options.goes_on)
          cancelled = !options.goes_on(1.0);
        if (cancelled) return false;
        if (const auto added = add(row.step); !added) failed = added.error();
        sound = burrs.sound() && (!voxels || voxels->sound());
        return sound && !failed;
      });
  if (!done) return tl::unexpected(done.error());
  if (failed) return tl::unexpected(*failed);
  if (cancelled)
    return tl::unexpected(
        haptics::Error{haptics::Error::Kind::Cancelled, {"work-cancelled", {}}, "cancelled"});
  if (voxels) exported.removed_voxels = count;
  const auto& scenes = recording.scenes();
  const auto cut = std::ranges::find_if(
      scenes, [&](const RecordedScene& one) { return laws->contains(one.id); });
  return sound && burrs.flush() && (!voxels || voxels->flush()) &&
         (cut == scenes.end() || writeVoxelVolume(file, cut->volume.grid)) &&
         linkAtRoot(file, cut != scenes.end(), voxels.has_value());
}

}  // namespace app::exporting
