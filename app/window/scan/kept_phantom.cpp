// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/scan/kept_phantom.h"

#include <libdeflate.h>

#include <QStandardPaths>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string_view>
#include <system_error>
#include <utility>

#include "haptics/process/input_file.h"
#include "haptics/process/output_file.h"

namespace app {
namespace {

using nlohmann::json;

constexpr std::int64_t kMostVoxels = std::int64_t{1} << 28;
constexpr double kLargest_m = 100.0;

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
  constexpr std::size_t kLongestHead = 4096;  // bytes
  auto stream = haptics::openInput(file, kLongestHead + kMostVoxels * sizeof(std::int16_t));
  std::string line;
  if (!stream || haptics::takeLine(*stream, line, kLongestHead) != haptics::LineRead::Whole)
    return {};
  if (haptics::isNestedDeeper(line, haptics::kDeepestJson)) return {};
  const json head = json::parse(line, nullptr, false);
  if (!head.is_object()) return {};
  haptics::Grid grid;
  datasets::Phantom phantom;
  std::uint32_t checksum = 0;
  std::string unit, modality;
  try {
    if (head.at("build").get<std::string>() != build) return {};
    for (std::size_t a = 0; a < 3; ++a) {
      const auto axis = static_cast<Eigen::Index>(a);
      const double voxels = head.at("dims").at(a);
      if (!(voxels >= 1.0 && voxels <= double{kMostVoxels})) return {};
      grid.dims[a] = static_cast<std::int64_t>(voxels);
      grid.spacing[axis] = head.at("spacing_m").at(a);
      grid.origin[axis] = head.at("origin_m").at(a);
      if (!(grid.spacing[axis] > 0.0 && grid.spacing[axis] < kLargest_m)) return {};
      if (!(std::abs(grid.origin[axis]) < kLargest_m)) return {};
    }
    phantom.isovalue = head.at("isovalue");
    phantom.tool = head.at("tool");
    checksum = head.at("crc32");
    unit = head.value("unit", "");
    modality = head.value("modality", "");
  } catch (const json::exception&) {
    return {};
  }
  if (grid.dims[0] * grid.dims[1] > kMostVoxels || grid.voxelCount() > kMostVoxels) return {};
  if (!std::isfinite(phantom.isovalue)) return {};
  const std::size_t bytes = bytesOf(grid);
  // before memory is taken that the file cannot fill
  std::error_code error;
  if (const auto size = std::filesystem::file_size(file, error); error || size < bytes) return {};
  auto voxels = haptics::allocateVoxels(grid.voxelCount(), haptics::ScalarType::Int16);
  if (!voxels) return {};
  stream->read(static_cast<char*>(voxels->get()), static_cast<std::streamsize>(bytes));
  if (static_cast<std::size_t>(stream->gcount()) != bytes ||
      checksumOf(voxels->get(), bytes) != checksum)
    return {};
  auto volume = haptics::makeVolume(grid, haptics::ScalarType::Int16, std::move(*voxels),
                                    {.unit = unit, .modality = modality});
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
  // a pipe would be written to, and its reader waited for
  if (std::filesystem::exists(file, error) && !std::filesystem::is_regular_file(file, error))
    return;
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
