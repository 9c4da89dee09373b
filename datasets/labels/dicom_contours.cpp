// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/labels/dicom_contours.h"

#include <vtkDICOMDictionary.h>
#include <vtkDICOMItem.h>
#include <vtkDICOMMetaData.h>
#include <vtkDICOMValue.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "datasets/labels/segments.h"
#include "datasets/readers/dicom/elements.h"
#include "datasets/readers/dicom/file.h"
#include "datasets/readers/dicom/numbers.h"
#include "datasets/readers/files/c_locale.h"
#include "datasets/readers/files/header_words.h"
#include "datasets/readers/files/refusal.h"

namespace datasets {

namespace fs = std::filesystem;
using haptics::Expected;
using haptics::Vec3;

namespace {

using Contour = std::vector<Vec3>;  ///< corners, mm, LPS

/// A region of interest.
struct Region {
  Structure structure;
  std::vector<Contour> contours;
};

constexpr double kSamePlane_mm = 1e-2;  // places are rounded
constexpr double kOffPlane_mm = 0.1;

/// Twice the area, along the normal about which the corners turn.
Vec3 areaOf(const Contour& contour) {
  Vec3 area = Vec3::Zero();
  for (std::size_t n = 0; n < contour.size(); ++n)
    area += (contour[n] - contour[0]).cross(contour[(n + 1) % contour.size()] - contour[0]);
  return area;
}

/// The closed contours of an item of the contour sequence, which has them of one region; `others`
/// counts those that are left out.
Expected<std::vector<Contour>> contoursIn(const fs::path& path, const vtkDICOMItem& region,
                                          std::int64_t& others) {
  constexpr double kFar_mm = 1e5;
  std::vector<Contour> contours;
  const vtkDICOMValue& all = region.Get(DC::ContourSequence);
  for (int n = 0; const vtkDICOMItem* item = itemOf(all, n); ++n) {
    const std::string type = trimmedValue(item->Get(DC::ContourGeometricType));
    const auto numbers = numbersIn(item->Get(DC::ContourData));
    const auto bad = [&] { return wrongField(path, "Contour Data"); };
    if (!numbers || numbers->size() % 3 != 0) return bad();
    const vtkDICOMValue& stated = item->Get(DC::NumberOfContourPoints);
    if (stated.IsValid() && integerString(trimmedValue(stated)) != int(numbers->size() / 3))
      return bad();
    const bool is_closed = type == "CLOSED_PLANAR" || type == "CLOSEDPLANAR_XOR";
    if (!is_closed || numbers->size() < 9) {
      ++others;
      continue;
    }
    Contour contour;
    for (std::size_t at = 0; at < numbers->size(); at += 3) {
      contour.push_back(Vec3::Map(numbers->data() + at));
      if (contour.back().cwiseAbs().maxCoeff() > kFar_mm) return bad();
    }
    contours.push_back(std::move(contour));
  }
  return contours;
}

/// All regions that have a closed contour, in the order of the file.
Expected<std::vector<Region>> regionsIn(const fs::path& path, vtkDICOMMetaData* meta,
                                        std::int64_t& others) {
  std::vector<Region> regions;
  std::map<int, std::size_t> by_number;
  const vtkDICOMValue& named = meta->Get(DC::StructureSetROISequence);
  for (int n = 0; const vtkDICOMItem* item = itemOf(named, n); ++n) {
    const auto number = integerString(trimmedValue(item->Get(DC::ROINumber)));
    if (!number || !by_number.try_emplace(*number, regions.size()).second)
      return wrongField(path, "ROI Number");
    regions.push_back({{.name = shownName(item->Get(DC::ROIName).AsUTF8String()),
                        .colour = colourFarFromOthers(regions.size())},
                       {}});
  }
  if (regions.empty()) return missingField(path, "Structure Set ROI Sequence");
  const vtkDICOMValue& drawn = meta->Get(DC::ROIContourSequence);
  for (int n = 0; const vtkDICOMItem* item = itemOf(drawn, n); ++n) {
    const auto number = integerString(trimmedValue(item->Get(DC::ReferencedROINumber)));
    const auto known = number ? by_number.find(*number) : by_number.end();
    if (known == by_number.end()) return wrongField(path, "Referenced ROI Number");
    Region& region = regions[known->second];
    const auto colour = numbersIn(item->Get(DC::ROIDisplayColor));
    if (colour && colour->size() == 3)
      for (std::size_t c = 0; c < 3; ++c)
        region.structure.colour[c] = std::clamp((*colour)[c] / 255.0, 0.0, 1.0);
    auto contours = contoursIn(path, *item, others);
    if (!contours) return tl::unexpected(contours.error());
    std::ranges::move(*contours, std::back_inserter(region.contours));
  }
  std::erase_if(regions, [](const Region& region) { return region.contours.empty(); });
  if (regions.size() > kMostStructures)
    return unsupported("labels-too-many", {"labels-too-many", {quoted(path)}});
  return regions;
}

/// Contours of one region that lie on one plane.
struct ContourPlane {
  double height_mm = 0.0;             ///< along the normal
  double from_mm = 0.0, to_mm = 0.0;  ///< the heights that count as the plane's: to is beyond them
  std::vector<const Contour*> contours;
};

struct ContourPlanes {
  Vec3 normal = Vec3::UnitZ();
  std::vector<ContourPlane> planes;  ///< upwards
};

/// The planes of a region's contours, with a normal of the largest; those of others are counted.
ContourPlanes planesOf(const Region& region, std::int64_t& others) {
  ContourPlanes all;
  double largest = 0.0;
  for (const Contour& contour : region.contours)
    if (const Vec3 area = areaOf(contour); area.norm() > largest) {
      largest = area.norm();
      all.normal = area / largest;
    }
  std::vector<std::pair<double, const Contour*>> by_height;
  for (const Contour& contour : region.contours) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Vec3& corner : contour) {
      low = std::min(low, all.normal.dot(corner));
      high = std::max(high, all.normal.dot(corner));
    }
    if (high - low > 2.0 * kOffPlane_mm)
      ++others;
    else
      by_height.emplace_back(0.5 * (low + high), &contour);
  }
  std::ranges::sort(by_height);
  for (const auto& [height_mm, contour] : by_height) {
    if (all.planes.empty() || height_mm - all.planes.back().height_mm > kSamePlane_mm)
      all.planes.push_back({height_mm, 0.0, 0.0, {}});
    all.planes.back().contours.push_back(contour);
  }
  return all;
}

/// The usual step between planes; none of a single plane.
std::optional<double> usualStep_mm(const std::vector<ContourPlane>& planes) {
  std::vector<double> gaps_mm;
  for (std::size_t n = 1; n < planes.size(); ++n)
    gaps_mm.push_back(planes[n].height_mm - planes[n - 1].height_mm);
  if (gaps_mm.empty()) return {};
  const auto middle = gaps_mm.begin() + std::ptrdiff_t(gaps_mm.size() / 2);
  std::ranges::nth_element(gaps_mm, middle);
  return *middle;
}

/// Half a step to each side, and never beyond the middle of two planes.
void giveHeights(std::vector<ContourPlane>& planes, double step_mm) {
  for (std::size_t n = 0; n < planes.size(); ++n) {
    planes[n].from_mm = planes[n].height_mm - 0.5 * step_mm;
    planes[n].to_mm = planes[n].height_mm + 0.5 * step_mm;
    if (n == 0) continue;
    const double middle_mm = 0.5 * (planes[n - 1].height_mm + planes[n].height_mm);
    planes[n].from_mm = std::max(planes[n].from_mm, middle_mm);
    planes[n - 1].to_mm = std::min(planes[n - 1].to_mm, middle_mm);
  }
}

/// Fills the contours of a plane, along the axis of the scan that rises least from it.
class PlaneFilling {
 public:
  PlaneFilling(LabelMap& map, const Vec3& normal, std::uint8_t number)
      : map_(map), normal_(normal), number_(number) {
    const haptics::Grid& grid = map.grid();
    steps_mm_ = 1e3 * grid.direction * grid.spacing.asDiagonal();
    (grid.direction.transpose() * normal).cwiseAbs().minCoeff(&along_);
  }

  Expected<void> fill(const ContourPlane& plane) {
    std::vector<Vec3> places;
    for (const Contour* contour : plane.contours)
      for (const Vec3& corner : *contour)
        for (const double height_mm : {plane.from_mm, plane.to_mm})
          places.push_back(1e-3 * (corner + (height_mm - normal_.dot(corner)) * normal_));
    const haptics::VoxelBox box = map_.boxAround(places);
    const auto across = std::size_t((along_ + 1) % 3), deep = std::size_t((along_ + 2) % 3);
    std::array<std::int64_t, 3> index{};
    for (index[deep] = box.first[deep]; index[deep] < box.end[deep]; ++index[deep])
      for (index[across] = box.first[across]; index[across] < box.end[across]; ++index[across])
        if (auto filled = fillLine(plane, box, index); !filled) return filled;
    return {};
  }

 private:
  Expected<void> fillLine(const ContourPlane& plane, const haptics::VoxelBox& box,
                          std::array<std::int64_t, 3> index) {
    const auto axis = std::size_t(along_);
    index[axis] = 0;
    const Vec3 first_mm =
        1e3 * map_.grid().worldOf({double(index[0]), double(index[1]), double(index[2])});
    const Vec3 step_mm = steps_mm_.col(along_);
    const double height_mm = normal_.dot(first_mm), rise_mm = normal_.dot(step_mm);
    const auto heightAt = [&](std::int64_t n) { return height_mm + double(n) * rise_mm; };
    const auto [low, high] = std::minmax({heightAt(box.first[axis]), heightAt(box.end[axis] - 1)});
    if (high < plane.from_mm || low >= plane.to_mm) return {};
    crossings_.clear();
    const Vec3 along = step_mm - rise_mm * normal_, aside = normal_.cross(along);
    for (const Contour* contour : plane.contours) {
      Vec3 before = contour->back() - first_mm;
      double side_before = aside.dot(before);
      for (const Vec3& corner : *contour) {
        const Vec3 here = corner - first_mm;
        const double side = aside.dot(here);
        // a corner on the line counts as on one of its sides, so each contour is crossed in pairs
        if ((side > 0.0) != (side_before > 0.0))
          crossings_.push_back(
              along.dot(before + (here - before) * (side_before / (side_before - side))) /
              along.squaredNorm());
        before = here;
        side_before = side;
      }
    }
    std::ranges::sort(crossings_);
    for (std::size_t n = 0; n + 1 < crossings_.size(); n += 2) {
      const double end = std::min(std::ceil(crossings_[n + 1]), double(box.end[axis]));
      for (double at = std::max(std::ceil(crossings_[n]), double(box.first[axis])); at < end;
           ++at) {
        index[axis] = std::int64_t(at);
        if (const double h = heightAt(index[axis]); h < plane.from_mm || h >= plane.to_mm) continue;
        const auto& dims = map_.grid().dims;
        if (auto marked = map_.mark((index[2] * dims[1] + index[1]) * dims[0] + index[0], number_);
            !marked)
          return marked;
      }
    }
    return {};
  }

  LabelMap& map_;
  Vec3 normal_;
  haptics::Mat3 steps_mm_;
  int along_ = 0;
  std::uint8_t number_;
  std::vector<double> crossings_;
};

}  // namespace

Expected<void> addDicomContours(LabelMap& map, const fs::path& path, const ParsedDicom& parsed,
                                const ReadProgress& progress) {
  const CLocale numbers_with_points;
  if (const DicomFile file = describedBy(path, parsed); file.fault)
    return tl::unexpected(*file.fault);
  std::int64_t others = 0;
  const auto regions = regionsIn(path, parsed.meta(), others);
  if (!regions) return tl::unexpected(regions.error());
  std::vector<ContourPlanes> planes;
  for (const Region& region : *regions) planes.push_back(planesOf(region, others));
  if (others > 0) map.note({"labels-contours-left-out", {quoted(path), std::to_string(others)}});
  if (regions->empty()) return unsupported("labels-none", {"labels-no-contours", {quoted(path)}});

  for (std::size_t n = 0; n < regions->size(); ++n) {
    const std::uint8_t number = map.add((*regions)[n].structure);
    ContourPlanes& all = planes[n];
    // images are no thicker; planes farther apart are of several pieces
    constexpr double kThickest_mm = 10.0;
    auto step_mm = usualStep_mm(all.planes);
    if (!step_mm || *step_mm > kThickest_mm)
      step_mm = 1e3 * (map.grid().direction.transpose() * all.normal)
                          .cwiseAbs()
                          .cwiseProduct(map.grid().spacing)
                          .maxCoeff();
    giveHeights(all.planes, *step_mm);
    PlaneFilling filling(map, all.normal, number);
    for (std::size_t p = 0; p < all.planes.size(); ++p) {
      if (progress.isCancelled()) return cancelled();
      progress.advanced((double(n) + double(p) / double(all.planes.size())) /
                        double(regions->size()));
      if (auto filled = filling.fill(all.planes[p]); !filled) return filled;
    }
  }
  return {};
}

std::set<std::string> framesOfContours(vtkDICOMMetaData* meta) {
  std::set<std::string> frames;
  const vtkDICOMValue& named = meta->Get(DC::StructureSetROISequence);
  for (int n = 0; const vtkDICOMItem* item = itemOf(named, n); ++n)
    frames.insert(trimmedValue(item->Get(DC::ReferencedFrameOfReferenceUID)));
  frames.erase("");
  return frames;
}

}  // namespace datasets
