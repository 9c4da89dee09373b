// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/readers/nrrd/writer.h"

#include <bit>
#include <charconv>
#include <cstdio>
#include <string>
#include <string_view>

#include "datasets/readers/files/refusal.h"
#include "haptics/process/output_file.h"

namespace datasets {

namespace fs = std::filesystem;
using haptics::ScalarType;
using haptics::Vec3;

static_assert(std::endian::native == std::endian::little,
              "voxels are written as they lie in memory");

namespace {

constexpr std::size_t kAligned = 64;       // bytes
constexpr std::size_t kAtOnce = 16 << 20;  // bytes between two looks at Cancel

/// NRRD knows our names but for one.
const char* nrrdTypeOf(ScalarType type) {
  return type == ScalarType::Float32 ? "float" : nameOf(type);
}

/// Metres as millimetres, such that reading them gives the same metres wherever a decimal of 15
/// digits can: 0.337891 and not 0.33789100000000003.
std::string millimetres(double metres) {
  char text[40];
  for (const int digits : {15, 16}) {
    std::snprintf(text, sizeof text, "%.*g", digits, metres * 1e3);
    for (char& c : text)
      if (c == ',') c = '.';  // the locale's
    double mm = 0.0;
    std::from_chars(text, text + std::char_traits<char>::length(text), mm);
    if (mm * 1e-3 == metres) return text;
  }
  return exact(metres * 1e3);
}

std::string vectorOf(const Vec3& v) {
  return "(" + millimetres(v.x()) + "," + millimetres(v.y()) + "," + millimetres(v.z()) + ")";
}

/// Where the voxels of a space lie, from a line that names it.
std::string placeIn(std::string space, const haptics::Grid& grid, bool layered) {
  space += layered ? "\nspace directions: none" : "\nspace directions:";
  for (int a = 0; a < 3; ++a) space += " " + vectorOf(grid.direction.col(a) * grid.spacing[a]);
  return space + "\nspace units: \"mm\" \"mm\" \"mm\"\nspace origin: " + vectorOf(grid.origin);
}

std::string nrrdHeaderOf(const haptics::Volume& volume) {
  const haptics::Grid& grid = volume.grid;
  std::string text = "NRRD0005\n# Palpate\ntype: ";
  text += std::string(nrrdTypeOf(volume.type)) + "\ndimension: 3\nsizes:";
  for (const std::int64_t n : grid.dims) text += " " + std::to_string(n);
  if (volume.orientation_known) {
    text += "\n" + nrrdSpaceOf(grid);
  } else if (grid.direction.isIdentity(0.0) && grid.origin.isZero(0.0)) {
    text += "\nspacings:";
    for (int a = 0; a < 3; ++a) text += " " + millimetres(grid.spacing[a]);
    text += "\nunits: \"mm\" \"mm\" \"mm\"";
  } else {
    // a place, but in a space whose left and right nobody knows
    text += "\n" + placeIn("space dimension: 3", grid, false);
  }
  text += "\nkinds: domain domain domain\nendian: little\nencoding: raw\n";
  if (!volume.unit.empty()) text += "unit:=" + volume.unit + "\n";
  if (!volume.modality.empty()) text += "modality:=" + volume.modality + "\n";
  // voxels begin where a file that is mapped has them aligned
  const std::size_t rest = (text.size() + std::string_view("#\n\n").size()) % kAligned;
  return text + "#" + std::string(rest == 0 ? 0 : kAligned - rest, ' ') + "\n\n";
}

}  // namespace

std::string nrrdSpaceOf(const haptics::Grid& grid, bool layered) {
  return placeIn("space: left-posterior-superior", grid, layered);
}

haptics::Expected<void> writeNrrd(const haptics::Volume& volume, const fs::path& out,
                                  const ReadProgress& progress) {
  auto file = haptics::OutputFile::open(out);
  if (!file) return tl::unexpected(file.error());
  file->write(nrrdHeaderOf(volume));
  const std::string_view voxels{
      static_cast<const char*>(volume.voxels.get()),
      static_cast<std::size_t>(volume.grid.voxelCount()) * haptics::sizeOf(volume.type)};
  for (std::size_t at = 0; at < voxels.size(); at += kAtOnce) {
    if (progress.isCancelled()) return cancelled();
    if (!file->write(voxels.substr(at, kAtOnce))) break;
  }
  if (auto closed = file->close(); !closed) return closed;
  if (progress.isCancelled()) return cancelled();
  if (auto finished = file->finish(); !finished) return tl::unexpected(finished.error());
  return {};
}

}  // namespace datasets
