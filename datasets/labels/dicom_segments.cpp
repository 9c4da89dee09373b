// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/labels/dicom_segments.h"

#include <vtkDICOMDictionary.h>
#include <vtkDICOMItem.h>
#include <vtkDICOMMetaData.h>
#include <vtkDICOMValue.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "datasets/labels/segments.h"
#include "datasets/readers/dicom/elements.h"
#include "datasets/readers/dicom/file.h"
#include "datasets/readers/dicom/frames.h"
#include "datasets/readers/dicom/numbers.h"
#include "datasets/readers/dicom/stack.h"
#include "datasets/readers/files/c_locale.h"
#include "datasets/readers/files/header_words.h"
#include "datasets/readers/files/refusal.h"

namespace datasets {

namespace fs = std::filesystem;
using haptics::Expected;
using haptics::Mat3;
using haptics::Vec3;

namespace {

/// A number above 0, or none.
std::optional<double> positiveIn(const vtkDICOMValue& value) {
  const auto numbers = numbersIn(value);
  if (!numbers || numbers->size() != 1 || !(std::abs(numbers->front()) > 0.0)) return {};
  return std::abs(numbers->front());
}

/// A whole number from 0 to 65535, or none.
std::optional<int> shortIn(const vtkDICOMValue& value) {
  const auto numbers = numbersIn(value);
  if (!numbers || numbers->size() != 1) return {};
  const double number = numbers->front();
  if (number != std::floor(number) || number < 0.0 || number > 65535.0) return {};
  return int(number);
}

enum class Kind { Binary, Fractional, LabelMap };

std::optional<Kind> kindOf(vtkDICOMMetaData* meta) {
  const std::string stated = textOf(meta, DC::SegmentationType);
  if (stated == "BINARY") return Kind::Binary;
  if (stated == "FRACTIONAL") return Kind::Fractional;
  if (stated == "LABELMAP") return Kind::LabelMap;
  return {};
}

/// Adds the structures that the object describes: by their numbers in it.
Expected<std::map<int, std::uint8_t>> addDescribed(LabelMap& map, const fs::path& path,
                                                   vtkDICOMMetaData* meta) {
  std::map<int, std::uint8_t> numbers;
  const vtkDICOMValue& segments = meta->Get(DC::SegmentSequence);
  for (int n = 0; const vtkDICOMItem* segment = itemOf(segments, n); ++n) {
    const auto number = shortIn(segment->Get(DC::SegmentNumber));
    if (!number || numbers.contains(*number)) return wrongField(path, "Segment Number");
    if (*number == 0) continue;  // the background of a label map
    if (map.structures().size() == kMostStructures)
      return unsupported("labels-too-many", {"labels-too-many", {quoted(path)}});
    Structure structure{.name = shownName(segment->Get(DC::SegmentLabel).AsUTF8String()),
                        .colour = colourFarFromOthers(map.structures().size())};
    const auto stated = numbersIn(segment->Get(DC::RecommendedDisplayCIELabValue));
    if (stated && stated->size() == 3)
      structure.colour = colourOfCieLab({(*stated)[0], (*stated)[1], (*stated)[2]});
    numbers[*number] = map.add(std::move(structure));
  }
  if (numbers.empty()) return missingField(path, "Segment Sequence");
  return numbers;
}

/// Parallel planes at even steps: where each frame lies.
struct Planes {
  Mat3 direction;  ///< columns: along rows, along columns, normal
  double lowest_mm = 0.0, step_mm = 1.0;
  std::vector<SlicePlane> of_frame;
  std::vector<std::int64_t> number;  ///< of each frame's plane, counted from the lowest
};

/// The numbers of heights on even planes, if they lie on such about `step_mm` apart, which becomes
/// the mean.
std::optional<std::vector<std::int64_t>> numbersAt(const std::vector<double>& heights_mm,
                                                   double& step_mm) {
  constexpr double kMost = 100'000.0;  // planes
  std::vector<std::int64_t> numbers{0};
  for (std::size_t n = 1; n < heights_mm.size(); ++n) {
    const double steps = std::round((heights_mm[n] - heights_mm[n - 1]) / step_mm);
    if (!(steps >= 1.0 && steps <= kMost)) return {};
    numbers.push_back(numbers.back() + std::int64_t(steps));
  }
  if (numbers.size() > 1)
    step_mm = (heights_mm.back() - heights_mm.front()) / double(numbers.back());
  for (std::size_t n = 0; n < numbers.size(); ++n) {
    const double off_mm = heights_mm[n] - heights_mm.front() - double(numbers[n]) * step_mm;
    if (std::abs(off_mm) > 0.05 * step_mm) return {};
  }
  return numbers;
}

Expected<Planes> planesOf(const DicomFile& object, vtkDICOMMetaData* meta) {
  Planes planes;
  DicomFile file = object;
  for (file.frame = 0; file.frame < file.frame_count; ++file.frame) {
    if (auto fault = placeSlice(meta, file)) return tl::unexpected(std::move(*fault));
    planes.of_frame.push_back(file.plane);
  }
  const auto direction = directionOf(planes.of_frame.front());
  const SlicePlane& any = planes.of_frame.front();
  constexpr double kFar_mm = 1e5;
  const bool near = std::ranges::all_of(planes.of_frame, [](const SlicePlane& plane) {
    return plane.position_mm.cwiseAbs().maxCoeff() < kFar_mm;
  });
  if (!direction || !near || !(any.column_step_mm > 0.0) || !(any.row_step_mm > 0.0))
    return wrongField(file.path, "Pixel Measures Sequence");
  if (!std::ranges::all_of(planes.of_frame,
                           [&](const SlicePlane& plane) { return isAlike(any, plane); }))
    return unsupported("mixed-orientation", {"labels-frames-turned", {quoted(file.path)}});
  planes.direction = *direction;
  const auto height_mm = [&](const SlicePlane& plane) {
    return planes.direction.col(2).dot(plane.position_mm);
  };
  std::vector<double> heights_mm;
  for (const SlicePlane& plane : planes.of_frame) heights_mm.push_back(height_mm(plane));
  std::ranges::sort(heights_mm);
  constexpr double kSame_mm = 1e-2;  // places are rounded
  heights_mm.erase(std::unique(heights_mm.begin(), heights_mm.end(),
                               [](double low, double high) { return high - low < kSame_mm; }),
                   heights_mm.end());
  // frames without a marked pixel are mostly left out, so the smallest gap may be several steps
  std::vector<double> candidates;
  if (const auto stated =
          positiveIn(ofFrame(meta, 0, DC::PixelMeasuresSequence, DC::SpacingBetweenSlices)))
    candidates.push_back(*stated);
  double least_mm = std::numeric_limits<double>::infinity();
  for (std::size_t n = 1; n < heights_mm.size(); ++n)
    least_mm = std::min(least_mm, heights_mm[n] - heights_mm[n - 1]);
  if (heights_mm.size() > 1)
    candidates.push_back(least_mm);
  else if (any.thickness_mm > 0.0)
    candidates.push_back(any.thickness_mm);
  if (candidates.empty()) return missingField(file.path, "Spacing Between Slices");
  for (double step_mm : candidates)
    if (const auto numbers = numbersAt(heights_mm, step_mm)) {
      planes.lowest_mm = heights_mm.front();
      planes.step_mm = step_mm;
      for (const SlicePlane& plane : planes.of_frame)
        planes.number.push_back(
            std::int64_t(std::round((height_mm(plane) - planes.lowest_mm) / step_mm)));
      return planes;
    }
  return unsupported("uneven-spacing", {"labels-frames-uneven", {quoted(file.path)}});
}

/// Marks the voxels of the scan that lie nearest to the pixels of a frame. `structureOf` tells
/// which structure a stored value belongs to: a number, or below 0 for none.
template <class StructureOf>
Expected<void> markFrame(LabelMap& map, const Planes& planes, std::size_t frame,
                         const Pixels& pixels, const StructureOf& structureOf) {
  const SlicePlane& plane = planes.of_frame[frame];
  const haptics::Grid& grid = map.grid();
  return haptics::visitVoxels(pixels.type, pixels.first, [&](const auto* values) -> Expected<void> {
    const auto at = [&](std::int64_t column, std::int64_t row) {
      return structureOf(std::int64_t(values[row * plane.columns + column]));
    };
    const Vec3 steps_mm(plane.column_step_mm, plane.row_step_mm, planes.step_mm);
    // what is marked: columns and rows
    Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;
    for (std::int64_t row = 0; row < plane.rows; ++row)
      for (std::int64_t column = 0; column < plane.columns; ++column)
        if (const int structure = at(column, row); structure >= 0) {
          const Vec3 pixel(double(column), double(row), 0.0);
          map.count(1e-3 * (plane.position_mm + planes.direction * steps_mm.cwiseProduct(pixel)),
                    std::uint8_t(structure));
          low = low.cwiseMin(pixel);
          high = high.cwiseMax(pixel);
        }
    if (low.x() > high.x()) return {};
    std::vector<Vec3> corners;
    for (const double i : {low.x() - 0.5, high.x() + 0.5})
      for (const double j : {low.y() - 0.5, high.y() + 0.5})
        for (const double k : {-0.5, 0.5})
          corners.push_back(
              1e-3 * (plane.position_mm + planes.direction * steps_mm.cwiseProduct(Vec3{i, j, k})));
    const haptics::VoxelBox box = map.boxAround(corners);
    // an index of the scan as column, row and plane; planes count from the lowest of all
    const Mat3 to_steps = steps_mm.cwiseInverse().asDiagonal() * planes.direction.transpose();
    const Mat3 turn = 1e3 * to_steps * grid.direction * grid.spacing.asDiagonal();
    Vec3 origin = to_steps * (1e3 * grid.origin - plane.position_mm);
    origin.z() = (planes.direction.col(2).dot(1e3 * grid.origin) - planes.lowest_mm) / steps_mm.z();
    for (std::int64_t k = box.first[2]; k < box.end[2]; ++k)
      for (std::int64_t j = box.first[1]; j < box.end[1]; ++j) {
        const Vec3 line = origin + turn * Vec3{0.0, double(j), double(k)};
        for (std::int64_t i = box.first[0]; i < box.end[0]; ++i) {
          const Vec3 nearest = (line + turn.col(0) * double(i)).array().round();
          if (nearest.z() != double(planes.number[frame]) || nearest.x() < low.x() ||
              nearest.x() > high.x() || nearest.y() < low.y() || nearest.y() > high.y())
            continue;
          const int structure = at(std::int64_t(nearest.x()), std::int64_t(nearest.y()));
          if (structure < 0) continue;
          if (auto marked =
                  map.mark((k * grid.dims[1] + j) * grid.dims[0] + i, std::uint8_t(structure));
              !marked)
            return marked;
        }
      }
    return {};
  });
}

}  // namespace

Expected<void> addDicomSegments(LabelMap& map, const fs::path& path, const ParsedDicom& parsed,
                                const ReadProgress& progress) {
  const CLocale numbers_with_points;
  vtkDICOMMetaData* meta = parsed.meta();
  DicomFile file = describedBy(path, parsed);
  if (file.fault) return tl::unexpected(*file.fault);
  const auto kind = kindOf(meta);
  if (!kind || file.is_signed || file.bits_allocated > 16)
    return wrongField(path, "Segmentation Type");
  const auto greatest = shortIn(meta->Get(DC::MaximumFractionalValue));
  if (*kind == Kind::Fractional && !(greatest && *greatest > 0))
    return wrongField(path, "Maximum Fractional Value");
  const auto numbers = addDescribed(map, path, meta);
  if (!numbers) return tl::unexpected(numbers.error());
  const auto planes = planesOf(file, meta);
  if (!planes) return tl::unexpected(planes.error());

  Decoders decoders = decodersFor({&file, 1});
  const std::unique_ptr<FileFrames> frames = framesOf(file, decoders);
  std::set<std::pair<int, std::int64_t>> taken;  // segment and plane
  for (file.frame = 0; file.frame < file.frame_count; ++file.frame) {
    if (progress.isCancelled()) return cancelled();
    progress.advanced(double(file.frame) / double(file.frame_count));
    const auto frame = std::size_t(file.frame);
    int segment = 0;  // a label map has all in one frame
    if (*kind != Kind::LabelMap) {
      const auto stated = shortIn(ofFrame(meta, file.frame, DC::SegmentIdentificationSequence,
                                          DC::ReferencedSegmentNumber));
      if (!stated || !numbers->contains(*stated))
        return wrongField(path, "Referenced Segment Number");
      segment = *stated;
    }
    if (!taken.insert({segment, planes->number[frame]}).second)
      return unsupported("duplicate", {"labels-frame-twice", {quoted(path)}});
    const auto pixels = frames->pixelsOf(file, progress);
    if (!pixels) return tl::unexpected(pixels.error());
    std::optional<std::int64_t> unknown;
    const auto structureOf = [&](std::int64_t value) {
      if (value == 0) return -1;
      if (*kind == Kind::LabelMap) {
        const auto known = numbers->find(int(value));
        if (known == numbers->end()) unknown = value;
        return known == numbers->end() ? -1 : int(known->second);
      }
      return *kind == Kind::Binary || 2 * value >= *greatest ? int(numbers->at(segment)) : -1;
    };
    if (auto marked = markFrame(map, *planes, frame, *pixels, structureOf); !marked) return marked;
    if (unknown) return wrongField(path, "Segment Number");
  }
  return {};
}

std::array<double, 3> colourOfCieLab(const std::array<double, 3>& stated) {
  const double light = 100.0 * stated[0] / 65535.0;
  const double a = 255.0 * stated[1] / 65535.0 - 128.0, b = 255.0 * stated[2] / 65535.0 - 128.0;
  const auto share = [](double f) {
    const double cube = f * f * f;
    return cube > 216.0 / 24389.0 ? cube : (f - 16.0 / 116.0) * 108.0 / 841.0;
  };
  const double fy = (light + 16.0) / 116.0;
  const double x = 0.950456 * share(fy + a / 500.0), y = share(fy),
               z = 1.088754 * share(fy - b / 200.0);
  const auto shown = [](double linear) {
    const double coded =
        linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
    return std::clamp(coded, 0.0, 1.0);
  };
  return {shown(3.2404542 * x - 1.5371385 * y - 0.4985314 * z),
          shown(-0.9692660 * x + 1.8760108 * y + 0.0415560 * z),
          shown(0.0556434 * x - 0.2040259 * y + 1.0572252 * z)};
}

}  // namespace datasets
