// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/kept_phantom.h"

#include <libdeflate.h>

#include <QStandardPaths>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string_view>
#include <system_error>
#include <utility>

#include "haptics/core/output_file.h"

namespace app {
namespace {

using nlohmann::json;

constexpr std::int64_t kMostVoxels = std::int64_t{1} << 28;

std::size_t bytesOf(const haptics::Grid& grid) {
  return static_cast<std::size_t>(grid.voxelCount()) * sizeof(std::int16_t);
}

std::uint32_t checksumOf(const void* voxels, std::size_t bytes) {
  return libdeflate_crc32(0, voxels, bytes);
}

}  // namespace

std::filesystem::path fileOfDemo() {
  return std::filesystem::path(
             QStandardPaths::writableLocation(QStandardPaths::CacheLocation).toStdString()) /
         "demo.voxels";
}

// one line of JSON that says what the voxels are, then the voxels, as they lie in memory
std::optional<datasets::Phantom> keptPhantom(const std::filesystem::path& file,
                                             const std::string& build) {
  std::ifstream stream{file, std::ios::binary};
  std::string line;
  if (!std::getline(stream, line)) return {};
  const json head = json::parse(line, nullptr, false);
  if (!head.is_object() || head.value("build", "") != build) return {};
  haptics::Grid grid;
  datasets::Phantom phantom;
  std::uint32_t checksum = 0;
  try {
    for (std::size_t a = 0; a < 3; ++a) {
      const auto axis = static_cast<Eigen::Index>(a);
      grid.dims[a] = head.at("dims").at(a);
      grid.spacing[axis] = head.at("spacing_m").at(a);
      grid.origin[axis] = head.at("origin_m").at(a);
      if (grid.dims[a] < 1 || grid.dims[a] > kMostVoxels) return {};
    }
    phantom.isovalue = head.at("isovalue");
    phantom.tool = head.at("tool");
    checksum = head.at("crc32");
  } catch (const json::exception&) {
    return {};
  }
  if (grid.dims[0] * grid.dims[1] > kMostVoxels || grid.voxelCount() > kMostVoxels) return {};
  const std::size_t bytes = bytesOf(grid);
  auto voxels = haptics::allocateVoxels(grid.voxelCount(), haptics::ScalarType::Int16);
  if (!voxels) return {};
  stream.read(static_cast<char*>(voxels->get()), static_cast<std::streamsize>(bytes));
  if (static_cast<std::size_t>(stream.gcount()) != bytes ||
      checksumOf(voxels->get(), bytes) != checksum)
    return {};
  auto volume =
      haptics::makeVolume(grid, haptics::ScalarType::Int16, std::move(*voxels),
                          {.unit = head.value("unit", ""), .modality = head.value("modality", "")});
  if (!volume) return {};
  phantom.volume = std::move(*volume);
  return phantom;
}

void keepPhantom(const std::filesystem::path& file, const std::string& build,
                 const datasets::Phantom& phantom) {
  const haptics::Volume& volume = phantom.volume;
  const haptics::Grid& grid = volume.grid;
  if (volume.type != haptics::ScalarType::Int16 || !grid.direction.isIdentity()) return;
  std::error_code error;
  std::filesystem::create_directories(file.parent_path(), error);
  auto out = haptics::OutputFile::open(file);
  if (!out) return;
  const std::size_t bytes = bytesOf(grid);
  const json head{{"build", build},
                  {"dims", grid.dims},
                  {"spacing_m", {grid.spacing.x(), grid.spacing.y(), grid.spacing.z()}},
                  {"origin_m", {grid.origin.x(), grid.origin.y(), grid.origin.z()}},
                  {"unit", volume.unit},
                  {"modality", volume.modality},
                  {"isovalue", phantom.isovalue},
                  {"tool", phantom.tool},
                  {"crc32", checksumOf(volume.voxels.get(), bytes)}};
  const bool written = out->write(head.dump() + '\n') &&
                       out->write({static_cast<const char*>(volume.voxels.get()), bytes});
  if (out->close() && written) (void)out->finish();
}

}  // namespace app
