// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/readers/nrrd_voxels.h"

#include <teem/air.h>
#include <teem/biff.h>
#include <teem/nrrd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

#include "datasets/readers/c_locale.h"
#include "datasets/readers/file_geometry.h"
#include "datasets/readers/nrrd_header.h"
#include "datasets/readers/nrrd_stream.h"
#include "datasets/readers/refusal.h"

namespace datasets {

using haptics::Expected;
using haptics::ScalarType;
using haptics::Vec3;

namespace {

// teem keeps its error messages in one global list
std::mutex& teem() {
  static std::mutex mutex;
  return mutex;
}

using NrrdPtr = std::unique_ptr<Nrrd, decltype(&nrrdNuke)>;
using NrrdIoPtr = std::unique_ptr<NrrdIoState, decltype(&nrrdIoStateNix)>;

/// teem's view of the file; null where it refuses. The lock must be held.
NrrdPtr load(const std::filesystem::path& path, const NrrdHeader& header, bool with_voxels,
             const ReadProgress& progress) {
  const CLocale numbers_with_points;
  NrrdPtr nrrd(nrrdNew(), nrrdNuke);
  const NrrdIoPtr io(nrrdIoStateNew(), nrrdIoStateNix);
  io->skipData = with_voxels ? 0 : 1;
  int failed = 1;
  if (header.data_files.size() > 1) {
    failed = nrrdLoad(nrrd.get(), path.c_str(), io.get());
  } else {
    const bool detached = header.data_files.size() == 1;
    const NrrdStream stream(detached ? header.text + "\n" : std::string(),
                            detached ? header.data_files.front() : path, progress);
    if (stream.stream() != nullptr) failed = nrrdRead(nrrd.get(), stream.stream(), io.get());
  }
  if (failed != 0) {
    biffDone(NRRD);
    nrrd.reset();
  }
  return nrrd;
}

/// Millimetres in one unit of length; empty for what is no length.
std::optional<double> millimetresIn(const char* unit) {
  if (unit == nullptr || *unit == '\0') return 1.0;
  const std::string_view u(unit);
  if (u == "mm" || u == "millimeter" || u == "millimeters" || u == "millimetre") return 1.0;
  if (u == "cm" || u == "centimeter" || u == "centimetre") return 10.0;
  if (u == "m" || u == "meter" || u == "metre") return 1000.0;
  if (u == "um" || u == "µm" || u == "μm" || u == "micron" || u == "microns" || u == "micrometer")
    return 1e-3;
  return {};
}

FileSpace spaceOf(int space) {
  switch (space) {
    case nrrdSpaceLeftPosteriorSuperior:
      return FileSpace::LeftPosteriorSuperior;
    case nrrdSpaceRightAnteriorSuperior:
      return FileSpace::RightAnteriorSuperior;
    case nrrdSpaceLeftAnteriorSuperior:
      return FileSpace::LeftAnteriorSuperior;
    default:
      return FileSpace::Unknown;
  }
}

tl::unexpected<haptics::Error> badUnit(const std::filesystem::path& path) {
  return unsupported("bad-header", "The header of " + quoted(path) +
                                       " measures its axes in a unit that is no length known here; "
                                       "export it in millimetres.");
}

/// Axes with directions in a space.
Expected<FileGeometry> orientedGeometry(const std::filesystem::path& path, const Nrrd& nrrd) {
  FileGeometry geometry;
  geometry.space = spaceOf(nrrd.space);
  Vec3 scale = Vec3::Ones();  // mm per unit of each coordinate of the space
  for (unsigned int c = 0; c < 3; ++c) {
    const auto millimetres = millimetresIn(nrrd.spaceUnits[c]);
    if (!millimetres) return badUnit(path);
    scale[c] = *millimetres;
  }
  for (unsigned int a = 0; a < 3; ++a)
    for (unsigned int c = 0; c < 3; ++c)
      geometry.steps_mm(c, a) = nrrd.axis[a].spaceDirection[c] * scale[c];
  if (!geometry.steps_mm.allFinite())
    return malformed("bad-header", "An axis of " + quoted(path) +
                                       " has no direction in space; export it again with its "
                                       "geometry.");
  for (unsigned int c = 0; c < 3; ++c) {
    const double origin = nrrd.spaceOrigin[c];
    geometry.origin_mm[c] = std::isnan(origin) ? 0.0 : origin * scale[c];
  }
  return geometry;
}

/// Axes with spacings only, or with nothing. `stated` tells which.
Expected<FileGeometry> plainGeometry(const std::filesystem::path& path, const Nrrd& nrrd,
                                     bool& stated) {
  FileGeometry geometry;
  geometry.space = FileSpace::Unknown;
  int known = 0;
  for (unsigned int a = 0; a < 3; ++a) {
    const NrrdAxisInfo& axis = nrrd.axis[a];
    const auto millimetres = millimetresIn(axis.units);
    if (!millimetres) return badUnit(path);
    if (std::isnan(axis.spacing) && (!std::isnan(axis.min) || !std::isnan(axis.max)))
      return unsupported("bad-header", "The header of " + quoted(path) +
                                           " places its axes by their ends instead of a spacing; "
                                           "export it with spacings.");
    if (std::isnan(axis.spacing)) continue;
    ++known;
    geometry.steps_mm(a, a) = axis.spacing * *millimetres;
  }
  stated = known > 0;
  if (known != 0 && known != 3)
    return malformed("bad-header", "The header of " + quoted(path) +
                                       " does not state the spacing of every axis; export it again "
                                       "with its geometry.");
  return geometry;
}

std::string valueOf(const Nrrd& nrrd, const char* key) {
  char* value = nrrdKeyValueGet(&nrrd, key);
  std::string text = value != nullptr ? value : "";
  airFree(value);
  return text;
}

/// "HU" where the file says so: our own key, the format's field, or the end of its description.
std::string unitOf(const Nrrd& nrrd) {
  const std::string key = valueOf(nrrd, "unit");
  const std::string_view units = nrrd.sampleUnits != nullptr ? nrrd.sampleUnits : "";
  const std::string_view content = nrrd.content != nullptr ? nrrd.content : "";
  if (!key.empty()) return key == "HU" ? "HU" : "";
  return units == "HU" || units == "hu" || content.ends_with(", HU") ? "HU" : "";
}

std::string modalityOf(const Nrrd& nrrd) {
  const std::string modality = valueOf(nrrd, "modality");
  // a code such as "CT", never free text
  const bool code = modality.size() <= 8 && std::ranges::all_of(modality, [](char c) {
                      return (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
                    });
  return code ? modality : "";
}

Expected<NrrdDescription> describe(const std::filesystem::path& path, const NrrdHeader& header,
                                   const Nrrd& nrrd) {
  const bool oriented = nrrd.spaceDim == 3;
  NrrdDescription description;
  auto geometry = oriented ? orientedGeometry(path, nrrd)
                           : plainGeometry(path, nrrd, description.spacing_stated);
  if (!geometry) return tl::unexpected(std::move(geometry.error()));
  geometry->dims = header.dims;
  auto grid = gridOf(*geometry);
  if (!grid) return tl::unexpected(std::move(grid.error()));
  description.grid = *grid;
  description.facts.unit = unitOf(nrrd);
  description.facts.modality = modalityOf(nrrd);
  description.facts.orientation_known = geometry->space != FileSpace::Unknown;
  return description;
}

tl::unexpected<haptics::Error> headerRefused(const std::filesystem::path& path) {
  return malformed("bad-header", "The header of " + quoted(path) +
                                     " cannot be understood; export the volume again.");
}

std::optional<ScalarType> typeOf(int teem_type) {
  switch (teem_type) {
    case nrrdTypeChar:
      return ScalarType::Int8;
    case nrrdTypeUChar:
      return ScalarType::UInt8;
    case nrrdTypeShort:
      return ScalarType::Int16;
    case nrrdTypeUShort:
      return ScalarType::UInt16;
    case nrrdTypeInt:
      return ScalarType::Int32;
    case nrrdTypeUInt:
      return ScalarType::UInt32;
    case nrrdTypeFloat:
      return ScalarType::Float32;
    default:
      return {};
  }
}

/// Takes teem's voxels over without copying them, grown by the padding.
Expected<std::shared_ptr<void>> adopted(Nrrd& nrrd, std::int64_t bytes) {
  const auto size = static_cast<std::size_t>(bytes);
  void* grown = std::realloc(nrrd.data, size + haptics::kVoxelPadding);
  if (grown == nullptr)
    return unsupported("too-large",
                       "The memory of this machine does not hold the volume; close "
                       "other programs.");
  nrrd.data = nullptr;
  std::memset(static_cast<char*>(grown) + size, 0, haptics::kVoxelPadding);
  return std::shared_ptr<void>(grown, [](void* p) { std::free(p); });
}

Expected<std::shared_ptr<void>> narrowed(const Nrrd& nrrd, std::int64_t count) {
  auto voxels = haptics::allocateVoxels(count, ScalarType::Float32);
  if (!voxels) return voxels;
  const auto* from = static_cast<const double*>(nrrd.data);
  auto* to = static_cast<float*>(voxels->get());
  for (std::int64_t i = 0; i < count; ++i) to[i] = static_cast<float>(from[i]);
  return voxels;
}

}  // namespace

Expected<NrrdDescription> describeNrrd(const std::filesystem::path& path) {
  const auto header = readNrrdHeader(path);
  if (!header) return tl::unexpected(header.error());
  const std::scoped_lock lock(teem());
  const NrrdPtr nrrd = load(path, *header, false, {});
  if (!nrrd) return headerRefused(path);
  return describe(path, *header, *nrrd);
}

Expected<haptics::Volume> decodeNrrd(const std::filesystem::path& path,
                                     const ReadProgress& progress) {
  const auto stopped = [&] { return progress.isCancelled(); };
  // geometry first: a volume that will be refused is not worth decoding
  const auto header = readNrrdHeader(path);
  if (!header) return tl::unexpected(header.error());
  const std::scoped_lock lock(teem());
  const NrrdPtr outline = load(path, *header, false, {});
  if (!outline) return headerRefused(path);
  auto description = describe(path, *header, *outline);
  if (!description) return tl::unexpected(std::move(description.error()));
  if (stopped()) return cancelled();

  const NrrdPtr nrrd = load(path, *header, true, progress);
  if (stopped()) return cancelled();
  if (!nrrd || nrrd->data == nullptr)
    return malformed("truncated", "The voxels of " + quoted(path) +
                                      " end early or are damaged; copy or fetch the file again.");
  const std::int64_t count = description->grid.voxelCount();
  if (nrrd->dim != 3 || nrrdElementNumber(nrrd.get()) != static_cast<std::size_t>(count))
    return headerRefused(path);
  const bool is_double = nrrd->type == nrrdTypeDouble;
  const auto type = is_double ? ScalarType::Float32 : typeOf(nrrd->type);
  if (!type) return headerRefused(path);
  auto voxels = is_double
                    ? narrowed(*nrrd, count)
                    : adopted(*nrrd, count * static_cast<std::int64_t>(haptics::sizeOf(*type)));
  if (!voxels) return tl::unexpected(std::move(voxels.error()));
  progress.advanced(1.0);
  return haptics::makeVolume(description->grid, *type, std::move(*voxels),
                             std::move(description->facts));
}

}  // namespace datasets
