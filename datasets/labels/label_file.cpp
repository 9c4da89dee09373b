// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/labels/label_file.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <map>
#include <new>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "datasets/labels/dicom_contours.h"
#include "datasets/labels/dicom_segments.h"
#include "datasets/labels/label_table.h"
#include "datasets/labels/segments.h"
#include "datasets/labels/surface_inside.h"
#include "datasets/readers/dicom/file.h"
#include "datasets/readers/dicom/parsed.h"
#include "datasets/readers/files/beginning.h"
#include "datasets/readers/files/c_locale.h"
#include "datasets/readers/files/header_words.h"
#include "datasets/readers/files/refusal.h"
#include "datasets/readers/nrrd/header.h"
#include "datasets/readers/volume_header.h"
#include "datasets/readers/volume_reader.h"

namespace datasets {

namespace fs = std::filesystem;
using haptics::Expected;

namespace {

/// The whole numbers other than 0 in a volume.
Expected<std::set<std::int64_t>> labelsIn(const haptics::Volume& volume, const fs::path& path) {
  const auto noLabels = [&] {
    return unsupported("not-labels", {"labels-not-whole", {quoted(path)}});
  };
  if (volume.replaced > 0) return noLabels();  // what was no number has become one
  return haptics::visitVoxels(
      volume.type, volume.voxels.get(),
      [&](const auto* voxels) -> Expected<std::set<std::int64_t>> {
        constexpr double kGreatest = 9'999'999;  // float32 holds each whole number up to it
        std::set<std::int64_t> labels;
        for (std::int64_t n = 0; n < volume.grid.voxelCount(); ++n) {
          if (n > 0 && voxels[n] == voxels[n - 1]) continue;
          const auto value = double(voxels[n]);
          if (value != std::floor(value) || std::abs(value) > kGreatest) return noLabels();
          if (value != 0.0) labels.insert(std::int64_t(value));
          if (labels.size() > kMostStructures)
            return unsupported("labels-too-many", {"labels-too-many", {quoted(path)}});
        }
        return labels;
      });
}

/// Whether two grids have the same voxels, whatever is known of where they lie.
bool isSame(const haptics::Grid& one, const haptics::Grid& other) {
  const auto at = [](const haptics::Grid& grid, double i, double j, double k) {
    return grid.worldOf({i, j, k});
  };
  if (one.dims != other.dims) return false;
  const double most = 1e-3 * one.spacing.minCoeff();
  for (const double i : {0.0, double(one.dims[0] - 1)})
    for (const double j : {0.0, double(one.dims[1] - 1)})
      for (const double k : {0.0, double(one.dims[2] - 1)})
        if ((at(one, i, j, k) - at(other, i, j, k)).norm() > most) return false;
  return true;
}

using Table = Expected<std::map<std::int64_t, NamedLabel>>;

/// The table that has the name of a label map, "labels.ctbl" of "labels.nii.gz". One that cannot be
/// read is noted, unless it may be any text.
Table tableBeside(LabelMap& map, fs::path path) {
  if (lowered(path.extension().string()) == ".gz") path.replace_extension();
  for (const std::string ending : {".ctbl", ".label", ".txt"}) {
    std::error_code ignored;
    if (!fs::is_regular_file(path.replace_extension(ending), ignored)) continue;
    auto table = readLabelTable(path);
    if (table) return table;
    if (ending != ".txt") map.note({"labels-table-unused", {table.error().message}});
  }
  return {};
}

/// Adds what a file of whole volumes marks.
Expected<void> addVolumes(LabelMap& map, const fs::path& path, const haptics::Volume& scan,
                          const LabelReading& reading, const ReadProgress& progress) {
  const auto survey = datasets::survey(path, progress.part(0.0, 0.02), true);
  if (!survey) return tl::unexpected(survey.error());
  const auto segments = segmentsOf(path);
  if (!segments) return tl::unexpected(segments.error());
  const auto table = !reading.table.empty() ? readLabelTable(reading.table)
                     : segments->empty()    ? tableBeside(map, path)
                                            : Table();
  if (!table) return tl::unexpected(table.error());
  // the segments of each layer, by label
  std::map<std::int64_t, std::map<std::int64_t, std::uint8_t>> named;
  for (std::size_t n = 0; n < segments->size(); ++n) {
    const Segment& segment = (*segments)[n];
    Structure structure = segment.structure;
    if (!segment.coloured) structure.colour = colourFarFromOthers(n);
    if (segment.layer >= std::int64_t(survey->series.size()))
      return wrongField(path, "Segment" + std::to_string(n) + "_Layer");
    named[segment.layer][segment.label] = map.add(std::move(structure));
  }
  const auto layers = double(survey->series.size());
  bool any = false;
  for (std::size_t layer = 0; layer < survey->series.size(); ++layer) {
    const ReadProgress of_layer = progress.part(0.02 + 0.98 * double(layer) / layers,
                                                0.02 + 0.98 * double(layer + 1) / layers);
    const auto labels = readVolume(survey->series[layer], {}, of_layer.part(0.0, 0.7));
    if (!labels) return tl::unexpected(labels.error());
    if (!(labels->orientation_known && scan.orientation_known) && !isSame(labels->grid, scan.grid))
      return unsupported("orientation-unknown", {"labels-orientation", {quoted(path)}});
    auto there = labelsIn(*labels, path);
    if (!there) return tl::unexpected(there.error());
    any = any || !there->empty();
    auto numbers = named[std::int64_t(layer)];
    // a number that no segment has is a structure with the name of the table, or without one
    for (const std::int64_t label : *there) {
      if (numbers.contains(label)) continue;
      if (map.structures().size() == kMostStructures)
        return unsupported("labels-too-many", {"labels-too-many", {quoted(path)}});
      Structure structure{.colour = colourFarFromOthers(map.structures().size())};
      if (const auto known = table->find(label); known != table->end()) {
        structure.name = known->second.name;
        structure.colour = known->second.colour;
      }
      numbers[label] = map.add(std::move(structure));
    }
    if (auto added = map.add(*labels, numbers, of_layer.part(0.7, 1.0)); !added)
      return tl::unexpected(added.error());
  }
  if (!any) return unsupported("labels-none", {"labels-none", {quoted(path)}});
  return {};
}

/// Adds what a DICOM object marks.
Expected<void> addDicom(LabelMap& map, const Beginning& beginning, const LabelReading& reading,
                        const ReadProgress& progress) {
  const CLocale numbers_with_points;
  const auto parsed = ParsedDicom::of(beginning);
  if (!parsed) return tl::unexpected(parsed.error());
  const DicomFile file = describedBy(beginning.path, **parsed);
  if (!holdsStructures(file))
    return unsupported("not-labels", {"labels-unknown-format", {quoted(beginning.path)}});
  ScanIdentity identity = identityOf((*parsed)->meta());
  if (holdsContours(file)) identity.frames_of_reference.merge(framesOfContours((*parsed)->meta()));
  if (!reading.agreed)
    if (auto belongs = checkBelongs(beginning.path, identity, reading.of); !belongs) return belongs;
  return holdsContours(file) ? addDicomContours(map, beginning.path, **parsed, progress)
                             : addDicomSegments(map, beginning.path, **parsed, progress);
}

/// Says how much of what a file marks lies outside the scan. Scans are cut soundly, so it is no
/// fault; and of a structure a hundred voxels across a hundredth is lost where the borders of two
/// grids differ by less than a voxel, so that much is not worth a word.
void noteOutside(LabelMap& map, const fs::path& path) {
  double marked = 0.0, outside = 0.0;
  for (const Structure& structure : map.structures()) {
    marked += double(structure.marked);
    outside += double(structure.outside);
  }
  const double percent = marked > 0.0 ? std::round(100.0 * outside / marked) : 0.0;
  if (percent > 1.0) map.note({"labels-outside", {quoted(path), std::to_string(int(percent))}});
}

Expected<LabelMap> readAny(const fs::path& path, const haptics::Volume& scan,
                           const ReadProgress& progress, const LabelReading& reading) {
  const Beginning beginning = fs::is_regular_file(path) ? Beginning(path) : Beginning();
  const bool is_surface = isSurfaceFile(path);
  const bool is_dicom = !isVolumeFile(path) && beginning.is_open && looksLikeDicom(beginning);
  // a series of slices or a folder is a scan, or several
  if (fs::exists(path) && !isVolumeFile(path) && !is_dicom && !is_surface)
    return unsupported("not-labels", {"labels-unknown-format", {quoted(path)}});
  if ((is_dicom || is_surface) && !scan.orientation_known)
    return unsupported("orientation-unknown", {"labels-orientation", {quoted(path)}});
  auto map = LabelMap::over(scan.grid);
  if (!map) return map;
  const auto added = is_surface ? addSurface(*map, path, reading.space, progress)
                     : is_dicom ? addDicom(*map, beginning, reading, progress)
                                : addVolumes(*map, path, scan, reading, progress);
  if (!added) return tl::unexpected(added.error());
  if (std::ranges::all_of(map->structures(), [](const Structure& s) { return s.voxels == 0; }))
    return unsupported("labels-elsewhere", {"labels-elsewhere", {quoted(path)}});
  noteOutside(*map, path);
  return map;
}

}  // namespace

bool isStructures(const fs::path& path) {
  std::error_code ignored;
  if (!fs::is_regular_file(path, ignored)) return false;
  const Beginning beginning(path);
  if (holdsSegments(beginning)) return true;
  if (!beginning.is_open || !looksLikeDicom(beginning)) return false;
  try {
    const CLocale numbers_with_points;
    const auto parsed = ParsedDicom::of(beginning);
    return parsed && holdsStructures(describedBy(path, **parsed));
  } catch (const std::exception&) {
    return false;  // a reader says why
  }
}

Expected<LabelMap> readLabels(const fs::path& path, const haptics::Volume& scan,
                              const ReadProgress& progress, const LabelReading& reading) {
  try {
    return readAny(path, scan, progress, reading);
  } catch (const std::bad_alloc&) {
    return unsupported("too-large", {"memory-too-small", {quoted(path)}});
  } catch (const std::exception&) {
    return malformed("unreadable", {"file-unreadable", {quoted(path)}});
  }
}

}  // namespace datasets
