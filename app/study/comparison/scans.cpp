// SPDX-License-Identifier: BSD-3-Clause
#include <filesystem>

#include "app/study/comparison/scenes.h"
#include "datasets/readers/volume_reader.h"

namespace comparison {
namespace {

struct Scan {
  const char* name;
  const char* path;
  double isovalue;
  const char* tool;
  int points;
  double unit_voxel;  ///< m that a voxel of side 1 stands for; 0 keeps the file's own sides
};

constexpr Scan kScans[] = {
    {"scan-bunny", "stanford_bunny/bunny_512x512x361_airflat.nrrd", 1500, "cane", 403, 0},
    {"scan-engine", "volvis_classics/engine.nhdr", 90, "wrench", 2126, 0.0006},
    {"scan-bone", "visible_human_female_head/vhf_head_512x512x234.nrrd", 300, "drill", 518, 0},
    {"scan-skin", "visible_human_female_head/vhf_head_512x512x234.nrrd", -300, "probe", 403, 0},
    {"scan-tooth", "seg3d_tooth/tooth.nhdr", 650, "drill", 518, 0.0002},
};

}  // namespace

const std::vector<std::string>& scanNames() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const Scan& scan : kScans) all.emplace_back(scan.name);
    return all;
  }();
  return names;
}

haptics::Expected<Touched> readScan(const std::string& name, const std::string& folder) {
  for (const Scan& scan : kScans) {
    if (name != scan.name) continue;
    auto volume = datasets::readVolume(std::filesystem::path(folder) / scan.path);
    if (!volume) return tl::unexpected(volume.error());
    if (scan.unit_voxel > 0.0) {
      // about its own middle, so that the origin does not depend on the unit
      haptics::Grid& grid = volume->grid;
      grid.spacing *= scan.unit_voxel / grid.spacing.minCoeff();
      grid.origin = -grid.direction * (0.5 * grid.spacing.cwiseProduct(haptics::Vec3{
                                                 double(grid.dims[0] - 1), double(grid.dims[1] - 1),
                                                 double(grid.dims[2] - 1)}));
    }
    return Touched{scan.name, std::make_shared<const haptics::Volume>(std::move(*volume)),
                   scan.isovalue, scan.tool, scan.points};
  }
  return tl::unexpected(haptics::Error{haptics::Error::Kind::NotFound, {"scan-unknown", {name}}});
}

}  // namespace comparison
