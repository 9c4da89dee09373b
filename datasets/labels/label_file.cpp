// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/labels/label_file.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "datasets/labels/segments.h"
#include "datasets/readers/files/header_words.h"
#include "datasets/readers/files/refusal.h"
#include "datasets/readers/volume_header.h"
#include "datasets/readers/volume_reader.h"

namespace datasets {

namespace fs = std::filesystem;
using haptics::Expected;

namespace {

/// Colours far apart for neighbouring numbers: the hue goes on by the golden angle.
std::array<double, 3> colourOf(std::size_t number) {
  constexpr double kGolden = 0.618033988749895, kPale = 0.35, kBright = 0.95;
  const double hue = 6.0 * std::fmod(0.02 + kGolden * double(number), 1.0);
  const auto channel = [&](double of) {
    const double away = std::abs(std::remainder(hue - of, 6.0));
    return kBright * (kPale + (1.0 - kPale) * std::clamp(2.0 - away, 0.0, 1.0));
  };
  return {channel(0.0), channel(2.0), channel(4.0)};
}

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

}  // namespace

Expected<LabelMap> readLabels(const fs::path& path, const haptics::Volume& scan,
                              const ReadProgress& progress) {
  // a series of slices or a folder is a scan, or several; a mesh is none
  std::error_code ignored;
  if (fs::exists(path, ignored) && !isVolumeFile(path))
    return unsupported("not-labels", {"labels-unknown-format", {quoted(path)}});
  const auto survey = datasets::survey(path, progress.part(0.0, 0.02));
  if (!survey) return tl::unexpected(survey.error());
  const auto segments = segmentsOf(path);
  if (!segments) return tl::unexpected(segments.error());
  auto map = LabelMap::over(scan.grid);
  if (!map) return tl::unexpected(map.error());
  // the segments of each layer, by label
  std::map<std::int64_t, std::map<std::int64_t, std::uint8_t>> named;
  for (std::size_t n = 0; n < segments->size(); ++n) {
    const Segment& segment = (*segments)[n];
    Structure structure = segment.structure;
    if (!segment.coloured) structure.colour = colourOf(n);
    if (segment.layer >= std::int64_t(survey->series.size()))
      return wrongField(path, "Segment" + std::to_string(n) + "_Layer");
    named[segment.layer][segment.label] = map->add(std::move(structure));
  }
  const auto layers = double(survey->series.size());
  bool any = false;
  for (std::size_t layer = 0; layer < survey->series.size(); ++layer) {
    const auto labels = readVolume(survey->series[layer], {},
                                   progress.part(0.02 + 0.98 * double(layer) / layers,
                                                 0.02 + 0.98 * double(layer + 1) / layers));
    if (!labels) return tl::unexpected(labels.error());
    if (!(labels->orientation_known && scan.orientation_known) && !isSame(labels->grid, scan.grid))
      return unsupported("orientation-unknown", {"labels-orientation", {quoted(path)}});
    auto there = labelsIn(*labels, path);
    if (!there) return tl::unexpected(there.error());
    any = any || !there->empty();
    auto numbers = named[std::int64_t(layer)];
    // a number that no segment has is a structure without a name
    for (const std::int64_t label : *there) {
      if (numbers.contains(label)) continue;
      if (map->structures().size() == kMostStructures)
        return unsupported("labels-too-many", {"labels-too-many", {quoted(path)}});
      numbers[label] = map->add({.colour = colourOf(map->structures().size())});
    }
    if (auto added = map->add(*labels, numbers); !added) return tl::unexpected(added.error());
  }
  if (!any) return unsupported("labels-none", {"labels-none", {quoted(path)}});
  if (std::ranges::all_of(map->structures(), [](const Structure& s) { return s.voxels == 0; }))
    return unsupported("labels-elsewhere", {"labels-elsewhere", {quoted(path)}});
  return map;
}

}  // namespace datasets
