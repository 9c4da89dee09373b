// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/readers/nrrd/voxels.h"

#include <teem/air.h>
#include <teem/biff.h>
#include <teem/nrrd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "datasets/readers/files/c_locale.h"
#include "datasets/readers/files/file_geometry.h"
#include "datasets/readers/files/header_words.h"
#include "datasets/readers/files/refusal.h"
#include "datasets/readers/nrrd/header.h"
#include "datasets/readers/nrrd/quiet_terminal.h"
#include "datasets/readers/nrrd/stream.h"

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

constexpr double kDecoding = 0.9;  // of the progress; the rest is for the range of the voxels

using NrrdPtr = std::unique_ptr<Nrrd, decltype(&nrrdNuke)>;
using NrrdIoPtr = std::unique_ptr<NrrdIoState, decltype(&nrrdIoStateNix)>;

/// What teem makes of a header's text, which may be empty, and the file that follows; null where it
/// refuses. The lock must be held.
NrrdPtr load(const std::string& text, const std::filesystem::path& file, bool with_voxels,
             const ReadProgress& progress) {
  const CLocale numbers_with_points;
  const QuietTerminal while_reading;
  NrrdPtr nrrd(nrrdNew(), nrrdNuke);
  const NrrdIoPtr io(nrrdIoStateNew(), nrrdIoStateNix);
  io->skipData = with_voxels ? 0 : 1;
  int failed = 1;
  const NrrdStream stream(text, file, progress);
  if (stream.stream() != nullptr) failed = nrrdRead(nrrd.get(), stream.stream(), io.get());
  if (failed != 0) {
    biffDone(NRRD);
    nrrd.reset();
  }
  return nrrd;
}

/// teem's view of the header. The lock must be held.
NrrdPtr headerByTeem(const std::filesystem::path& path, const NrrdHeader& header) {
  const bool detached = !header.data_files.empty();
  return load(detached ? header.text + "\n" : std::string(),
              detached ? header.data_files.front() : path, false, {});
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
    case nrrdSpaceLeftPosteriorSuperiorTime:
      return FileSpace::LeftPosteriorSuperior;
    case nrrdSpaceRightAnteriorSuperior:
    case nrrdSpaceRightAnteriorSuperiorTime:
      return FileSpace::RightAnteriorSuperior;
    case nrrdSpaceLeftAnteriorSuperior:
    case nrrdSpaceLeftAnteriorSuperiorTime:
      return FileSpace::LeftAnteriorSuperior;
    default:
      return FileSpace::Unknown;
  }
}

/// Whether the first three coordinates of the space are places: those of a fourth are times.
bool hasPlaces(const Nrrd& nrrd) {
  switch (nrrd.space) {
    case nrrdSpaceLeftPosteriorSuperiorTime:
    case nrrdSpaceRightAnteriorSuperiorTime:
    case nrrdSpaceLeftAnteriorSuperiorTime:
    case nrrdSpaceScannerXYZTime:
    case nrrdSpace3DRightHandedTime:
    case nrrdSpace3DLeftHandedTime:
      return true;
    default:
      return nrrd.spaceDim == 3;
  }
}

tl::unexpected<haptics::Error> badUnit(const std::filesystem::path& path) {
  return unsupported("bad-header", {"header-unit-unknown", {quoted(path)}});
}

bool isSameUnit(const char* a, const char* b) {
  return std::string_view(a != nullptr ? a : "") == std::string_view(b != nullptr ? b : "");
}

/// Axes with directions in a space.
Expected<FileGeometry> orientedGeometry(const std::filesystem::path& path, const NrrdHeader& header,
                                        const Nrrd& nrrd) {
  FileGeometry geometry;
  geometry.space = spaceOf(nrrd.space);
  Vec3 scale = Vec3::Ones();  // mm per unit of each coordinate of the space
  for (unsigned int c = 0; c < 3; ++c) {
    const auto millimetres = millimetresIn(nrrd.spaceUnits[c]);
    if (!millimetres || !isSameUnit(nrrd.spaceUnits[c], nrrd.spaceUnits[0])) return badUnit(path);
    scale[c] = *millimetres;
  }
  for (unsigned int a = 0; a < 3; ++a)
    for (unsigned int c = 0; c < 3; ++c)
      geometry.steps_mm(c, a) = nrrd.axis[header.axes[a]].spaceDirection[c] * scale[c];
  if (!geometry.steps_mm.allFinite() ||
      (geometry.steps_mm.colwise().squaredNorm().array() == 0.0).any())
    return malformed("bad-header", {"nrrd-spacing-missing", {quoted(path)}});
  for (unsigned int c = 0; c < 3; ++c) {
    const double origin = nrrd.spaceOrigin[c];
    geometry.origin_mm[c] = std::isnan(origin) ? 0.0 : origin * scale[c];
  }
  return geometry;
}

/// As stated, or from the ends of the axis: of its outer voxels' centres, or of their far sides, as
/// the format has it where nothing is said. NaN where none of it is known.
double spacingOf(const NrrdAxisInfo& axis) {
  if (!std::isnan(axis.spacing)) return axis.spacing;
  const double intervals =
      static_cast<double>(axis.size) - (axis.center == nrrdCenterNode ? 1.0 : 0.0);
  return (axis.max - axis.min) / intervals;
}

/// Axes with spacings only, or with nothing. `stated` tells which.
Expected<FileGeometry> plainGeometry(const std::filesystem::path& path, const NrrdHeader& header,
                                     const Nrrd& nrrd, bool& stated) {
  FileGeometry geometry;
  geometry.space = FileSpace::Unknown;
  int known = 0;
  for (unsigned int a = 0; a < 3; ++a) {
    const NrrdAxisInfo& axis = nrrd.axis[header.axes[a]];
    const auto millimetres = millimetresIn(axis.units);
    if (!millimetres || !isSameUnit(axis.units, nrrd.axis[header.axes[0]].units))
      return badUnit(path);
    const double spacing = spacingOf(axis);
    if (std::isnan(spacing)) continue;
    ++known;
    geometry.steps_mm(a, a) = spacing * *millimetres;
    if (std::isnan(axis.min)) continue;
    const double centre = axis.min + (axis.center == nrrdCenterNode ? 0.0 : 0.5 * spacing);
    geometry.origin_mm[a] = centre * *millimetres;
    const double end =
        centre +
        (static_cast<double>(axis.size) - (axis.center == nrrdCenterNode ? 1.0 : 0.5)) * spacing;
    if (!std::isnan(axis.max) && std::abs(axis.max - end) > 0.01 * std::abs(spacing))
      return malformed("bad-header", {"nrrd-spacing-contradicts-axis", {quoted(path)}});
  }
  stated = known > 0;
  if (known != 0 && known != 3)
    return malformed("bad-header", {"nrrd-spacing-missing", {quoted(path)}});
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

tl::unexpected<haptics::Error> headerRefused(const std::filesystem::path& path) {
  return malformed("bad-header", {"header-unreadable", {quoted(path)}});
}

std::optional<ScalarType> typeOfTeem(int teem_type) {
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

/// How the voxels lie; where they are in one file that needs no decoder of teem's, also where.
Expected<StoredVoxels> voxelsOf(const std::filesystem::path& path, const NrrdHeader& header,
                                const Nrrd& nrrd) {
  StoredVoxels stored;
  VoxelLayout& layout = stored.layout;
  layout.doubles = nrrd.type == nrrdTypeDouble;
  const auto type = layout.doubles ? ScalarType::Float32 : typeOfTeem(nrrd.type);
  if (!type || nrrd.dim != header.sizes.size()) return headerRefused(path);
  layout.type = *type;
  layout.swapped = header.big_endian && header.bytes_per_voxel > 1;
  std::ranges::copy(header.sizes, layout.sizes.begin());
  layout.volume_axis = header.volume_axis < 0 ? 3 : header.volume_axis;
  stored.deflated = header.encoding == NrrdEncoding::Gzip;
  stored.file = header.data_files.empty() ? path : header.data_files.front();
  stored.offset = header.data_files.empty() ? header.header_bytes : 0;
  stored.skip = header.byte_skip;
  return stored;
}

/// Where the voxels of a file lie behind `offset`: behind the lines that are to be skipped, and
/// plain ones that are the last of the file behind all else.
Expected<FileBytes> foundIn(const std::filesystem::path& file, std::int64_t offset,
                            const NrrdHeader& header) {
  FileBytes found{file, offset, header.encoding == NrrdEncoding::Gzip, header.byte_skip};
  std::ifstream in(file, std::ios::binary);
  in.seekg(offset);
  for (std::int64_t line = 0; line < header.line_skip && in; ++line)
    in.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
  if (header.line_skip > 0) found.offset = in ? static_cast<std::int64_t>(in.tellg()) : -1;
  if (found.offset >= 0 && found.skip < 0 && !found.deflated) {
    std::error_code error;
    const auto length = static_cast<std::int64_t>(std::filesystem::file_size(file, error));
    found.offset = error ? -1 : length - header.voxelsPerFile() * header.bytes_per_voxel;
    found.skip = 0;
  }
  if (found.offset < 0) return malformed("truncated", {"file-damaged", {quoted(file)}});
  return found;
}

/// Reads a window of voxels that lie plain or deflated in several files, the same part in each.
Expected<std::shared_ptr<void>> windowOfSeveral(const ParsedNrrd& nrrd, int number,
                                                const Window& window,
                                                const ReadProgress& progress) {
  std::vector<FileBytes> files;
  for (const std::filesystem::path& file : nrrd.header.data_files) {
    auto found = foundIn(file, 0, nrrd.header);
    if (!found) return tl::unexpected(std::move(found.error()));
    files.push_back(std::move(*found));
  }
  const auto bytes =
      joinedBytes(std::move(files), nrrd.header.voxelsPerFile() * nrrd.header.bytes_per_voxel);
  return pickVoxels(*bytes, 0, nrrd.stored.voxels.layout, number, window, nrrd.path, progress);
}

Expected<StoredVolumes> describe(const std::filesystem::path& path, const NrrdHeader& header,
                                 const Nrrd& nrrd) {
  const bool oriented = nrrd.spaceDim > 0;
  if (oriented && !hasPlaces(nrrd))
    return unsupported("bad-header",
                       {"nrrd-space-dimension", {quoted(path), std::to_string(nrrd.spaceDim)}});
  StoredVolumes description;
  auto voxels = voxelsOf(path, header, nrrd);
  if (!voxels) return tl::unexpected(std::move(voxels.error()));
  description.voxels = std::move(*voxels);
  auto geometry = oriented ? orientedGeometry(path, header, nrrd)
                           : plainGeometry(path, header, nrrd, description.spacing_stated);
  if (!geometry) return tl::unexpected(std::move(geometry.error()));
  geometry->dims = header.dims;
  if (auto done = place(description, *geometry); !done)
    return tl::unexpected(std::move(done.error()));
  description.facts.unit = unitOf(nrrd);
  description.facts.modality = modalityFrom(valueOf(nrrd, "modality"));
  description.facts.orientation_known = geometry->space != FileSpace::Unknown;
  return description;
}

/// Takes teem's voxels over into a memory object. From the end, and what was taken is given back at
/// once, so that they do not lie in memory twice.
Expected<std::shared_ptr<void>> adopted(Nrrd& nrrd, std::int64_t count, ScalarType type) {
  constexpr std::size_t kAtOnce = std::size_t{64} << 20;  // bytes
  auto voxels = haptics::allocateVoxels(count, type);
  if (!voxels) return voxels;
  std::size_t left = static_cast<std::size_t>(count) * haptics::sizeOf(type);
  while (left > 0) {
    const std::size_t piece = std::min(kAtOnce, left);
    left -= piece;
    std::memcpy(static_cast<char*>(voxels->get()) + left,
                static_cast<const char*>(nrrd.data) + left, piece);
    if (left == 0) break;
    if (void* shrunk = std::realloc(nrrd.data, left)) nrrd.data = shrunk;
  }
  return voxels;
}

Expected<std::shared_ptr<void>> narrowed(const Nrrd& nrrd, std::int64_t count) {
  auto voxels = haptics::allocateVoxels(count, ScalarType::Float32);
  if (!voxels) return voxels;
  const auto* from = static_cast<const double*>(nrrd.data);
  auto* to = static_cast<float*>(voxels->get());
  for (std::int64_t i = 0; i < count; ++i) to[i] = static_cast<float>(from[i]);
  return voxels;
}

/// Whether a word is a value of this type as a whole: teem takes "300" for 44 where a byte is
/// meant, and "1,5" for 1.
bool isValueOf(std::string_view word, ScalarType type) {
  if (type == ScalarType::Float32) return numberOf(word).has_value();
  const auto value = integerOf(word);
  return value && haptics::visitVoxels(type, nullptr, [&](auto* v) {
           using T = std::remove_const_t<std::remove_pointer_t<decltype(v)>>;
           if constexpr (std::is_integral_v<T>) return std::in_range<T>(*value);
           return true;
         });
}

/// Voxels as text: every word is a value of their type.
Expected<void> checkText(const std::filesystem::path& path, const NrrdHeader& header,
                         ScalarType type) {
  std::vector<std::filesystem::path> files = header.data_files;
  if (files.empty()) files.push_back(path);
  std::int64_t read = 0, end = 0;
  for (const std::filesystem::path& file : files) {
    end += header.voxelsPerFile();
    std::ifstream in(file, std::ios::binary);
    if (header.data_files.empty()) in.seekg(header.header_bytes);
    for (std::int64_t line = 0; line < header.line_skip && in; ++line)
      in.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
    if (header.byte_skip > 0) in.ignore(header.byte_skip);
    for (std::string word; read < end && in >> word;) {
      if (word.back() == ',') word.pop_back();  // which teem takes as well
      if (word.empty()) continue;
      ++read;
      if (!isValueOf(word, type))
        return malformed("bad-header",
                         {"nrrd-value-unreadable", {std::to_string(read), quoted(path)}});
    }
  }
  return {};
}

/// A header for the voxels of one of several files, in a row.
std::string headerOfPiece(const NrrdHeader& header) {
  const char* encoding = header.encoding == NrrdEncoding::Ascii ? "ascii"
                         : header.encoding == NrrdEncoding::Hex ? "hex"
                                                                : "bzip2";
  return "NRRD0004\ntype: " + header.type +
         "\ndimension: 1\nsizes: " + std::to_string(header.voxelsPerFile()) +
         "\nendian: " + (header.big_endian ? "big" : "little") + "\nencoding: " + encoding + "\n" +
         header.skips + "\n";
}

/// The voxels of several files, each decoded by teem; null where it refuses. The lock must be held.
NrrdPtr decodedPieces(const NrrdHeader& header, const ReadProgress& progress) {
  NrrdPtr whole(nrrdNew(), nrrdNuke);
  const auto count = static_cast<std::size_t>(header.voxelCount());
  const std::string text = headerOfPiece(header);
  char* to = nullptr;
  for (std::size_t n = 0; n < header.data_files.size(); ++n) {
    const double files = static_cast<double>(header.data_files.size());
    const ReadProgress reading =
        progress.part(static_cast<double>(n) / files, static_cast<double>(n + 1) / files);
    const NrrdPtr piece = load(text, header.data_files[n], true, reading);
    if (!piece || piece->data == nullptr) return {nullptr, nrrdNuke};
    if (to == nullptr) {
      if (nrrdAlloc_nva(whole.get(), piece->type, 1, &count) != 0) {
        biffDone(NRRD);
        return {nullptr, nrrdNuke};
      }
      to = static_cast<char*>(whole->data);
    }
    const std::size_t bytes = nrrdElementNumber(piece.get()) * nrrdElementSize(piece.get());
    std::memcpy(to, piece->data, bytes);
    to += bytes;
  }
  return whole;
}

/// The whole file's voxels, as teem decodes them. The lock must be held.
Expected<NrrdPtr> decodedByTeem(const std::filesystem::path& path, const NrrdHeader& header,
                                ScalarType type, const ReadProgress& progress) {
  const std::int64_t count = header.voxelCount();
  if (auto room = checkRoom(count, header.bytes_per_voxel, adviceToSaveRaw()); !room)
    return tl::unexpected(std::move(room.error()));
  if (header.encoding == NrrdEncoding::Ascii)
    if (auto text = checkText(path, header, type); !text)
      return tl::unexpected(std::move(text.error()));
  const bool detached = !header.data_files.empty();
  NrrdPtr nrrd = header.data_files.size() > 1
                     ? decodedPieces(header, progress)
                     : load(detached ? header.text + header.skips + "\n" : std::string(),
                            detached ? header.data_files.front() : path, true, progress);
  if (progress.isCancelled()) return cancelled();
  if (!nrrd || nrrd->data == nullptr)
    return malformed("truncated", {"file-damaged", {quoted(path)}});
  if (nrrdElementNumber(nrrd.get()) != static_cast<std::size_t>(count)) return headerRefused(path);
  return nrrd;
}

/// The only volume of a file, whole.
Expected<std::shared_ptr<void>> wholeByTeem(const std::filesystem::path& path,
                                            const NrrdHeader& header, const VoxelLayout& layout,
                                            const ReadProgress& progress) {
  const auto nrrd = decodedByTeem(path, header, layout.type, progress);
  if (!nrrd) return tl::unexpected(nrrd.error());
  if (layout.doubles) return narrowed(**nrrd, layout.voxelCount());
  return adopted(**nrrd, layout.voxelCount(), layout.type);
}

/// A window of a file that only teem can decode.
Expected<std::shared_ptr<void>> windowByTeem(const std::filesystem::path& path,
                                             const NrrdHeader& header, VoxelLayout layout,
                                             int number, const Window& window,
                                             const ReadProgress& progress) {
  const auto nrrd = decodedByTeem(path, header, layout.type, progress);
  if (!nrrd) return tl::unexpected(nrrd.error());
  layout.swapped = false;  // teem has done it
  const auto bytes = bytesOf((*nrrd)->data, layout.voxelCount() * layout.bytesPerVoxel());
  return pickVoxels(*bytes, 0, layout, number, window, path, progress);
}

}  // namespace

bool needsTeem(const NrrdHeader& header) {
  return header.encoding != NrrdEncoding::Raw && header.encoding != NrrdEncoding::Gzip;
}

Expected<ParsedNrrd> parseNrrd(const std::filesystem::path& path) {
  auto header = readNrrdHeader(path);
  if (!header) return tl::unexpected(std::move(header.error()));
  const std::scoped_lock lock(teem());
  const NrrdPtr nrrd = headerByTeem(path, *header);
  if (!nrrd) return headerRefused(path);
  auto stored = describe(path, *header, *nrrd);
  if (!stored) return tl::unexpected(std::move(stored.error()));
  return ParsedNrrd{path, std::move(*header), std::move(*stored)};
}

Expected<haptics::Volume> decodeNrrd(const ParsedNrrd& nrrd, int number, const Part& part,
                                     const ReadProgress& progress) {
  const std::filesystem::path& path = nrrd.path;
  const NrrdHeader& header = nrrd.header;
  const auto window = windowOf(part, nrrd.stored.grid.dims);
  if (!window) return tl::unexpected(window.error());
  if (progress.isCancelled()) return cancelled();
  StoredVolumes stored = nrrd.stored;
  const VoxelLayout& layout = stored.voxels.layout;
  const bool several = header.data_files.size() > 1;
  if (!needsTeem(header) && !several) {
    auto found = foundIn(stored.voxels.file, stored.voxels.offset, header);
    if (!found) return tl::unexpected(std::move(found.error()));
    stored.voxels.offset = found->offset;
    stored.voxels.skip = found->skip;
    return readVolume(stored, number, part, progress);
  }
  const ReadProgress decoding = progress.part(0.0, kDecoding);
  auto voxels = [&] {
    if (!needsTeem(header)) return windowOfSeveral(nrrd, number, *window, decoding);
    const std::scoped_lock lock(teem());
    return header.volumes == 1 && part.isWhole()
               ? wholeByTeem(path, header, layout, decoding)
               : windowByTeem(path, header, layout, number, *window, decoding);
  }();
  if (!voxels) return tl::unexpected(std::move(voxels.error()));
  return finished(stored, *window, layout.type, std::move(*voxels), progress.part(kDecoding, 1.0));
}

}  // namespace datasets
