// SPDX-License-Identifier: BSD-3-Clause
#include "ui/props/colouring.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

#include "ui/style/scene_colours.h"

namespace ui {
namespace {

/// Where a tissue begins, seen from the air: in HU, and as the share of the voxels that are not
/// background and lie below it.
struct Threshold {
  double hu, quantile;
};
Threshold thresholdOf(Tissue tissue) {
  switch (tissue) {
    case Tissue::Airway:
      return {-500.0, 0.15};
    case Tissue::Skin:
      return {-300.0, 0.30};
    case Tissue::Vessels:
      return {180.0, 0.85};
    case Tissue::Bone:
      return {300.0, 0.93};
    case Tissue::Teeth:
      break;
  }
  return {1500.0, 0.99};
}

/// The intensity below which this share of the voxels lies, without those of the first bin: air,
/// padding, or what a reader filled.
double quantileOf(const Histogram& histogram, double share) {
  double all = 0.0;
  for (std::size_t i = 1; i < histogram.counts.size(); ++i) all += histogram.counts[i];
  const double width =
      (histogram.greatest - histogram.least) / static_cast<double>(histogram.counts.size());
  double below = 0.0;
  for (std::size_t i = 1; i < histogram.counts.size(); ++i) {
    const double count = histogram.counts[i];
    if (count > 0.0 && below + count >= share * all)
      return histogram.least + width * (static_cast<double>(i) + (share * all - below) / count);
    below += count;
  }
  return histogram.greatest;
}

double intensityAt(const Threshold& threshold, const Picture& picture) {
  if (picture.volume->unit == "HU") return threshold.hu;
  return quantileOf(picture.histogram, threshold.quantile);
}

}  // namespace

QString nameOf(Tissue tissue) {
  const auto words = [](const char* text) {
    return QCoreApplication::translate("ui::Colouring", text);
  };
  switch (tissue) {
    case Tissue::Bone:
      return words("Bone");
    case Tissue::Skin:
      return words("Skin");
    case Tissue::Airway:
      return words("Airway");
    case Tissue::Vessels:
      return words("Vessels with contrast");
    case Tissue::Teeth:
      break;
  }
  return words("Teeth");
}

double isovalueOf(Tissue tissue, const Picture& picture) {
  return intensityAt(thresholdOf(tissue), picture);
}

Colouring Colouring::byTissue(const Picture& picture) {
  const auto stop = [&](double hu, double quantile, const Rgb& colour) {
    return Stop{intensityAt({hu, quantile}, picture), colour};
  };
  return Colouring({stop(-900.0, 0.10, style::kAirway), stop(-500.0, 0.15, style::kAirway),
                    stop(-350.0, 0.25, style::kSkin), stop(-150.0, 0.40, style::kSkin),
                    stop(0.0, 0.60, style::kSoft), stop(100.0, 0.75, style::kSoft),
                    stop(250.0, 0.90, style::kIvory), stop(1200.0, 0.98, style::kIvory),
                    stop(1500.0, 0.99, style::kTooth)});
}

Colouring Colouring::withVessels(const Picture& picture) {
  const auto stop = [&](double hu, double quantile, const Rgb& colour) {
    return Stop{intensityAt({hu, quantile}, picture), colour};
  };
  return Colouring({stop(-350.0, 0.25, style::kSkin), stop(0.0, 0.60, style::kSoft),
                    stop(130.0, 0.80, style::kVessel), stop(350.0, 0.95, style::kVessel),
                    stop(600.0, 0.97, style::kIvory)});
}

Colouring Colouring::of(SurfaceColours colours, const Picture& picture) {
  return colours == SurfaceColours::Ivory    ? Colouring{}
         : colours == SurfaceColours::Tissue ? byTissue(picture)
                                             : withVessels(picture);
}

Rgb Colouring::at(double intensity) const {
  const auto above = std::ranges::upper_bound(stops_, intensity, {}, &Stop::intensity);
  if (above == stops_.begin()) return stops_.front().colour;
  if (above == stops_.end()) return stops_.back().colour;
  const Stop& low = *(above - 1);
  const double share = (intensity - low.intensity) / (above->intensity - low.intensity);
  Rgb colour{};
  for (std::size_t c = 0; c < 3; ++c)
    colour[c] = low.colour[c] + share * (above->colour[c] - low.colour[c]);
  return colour;
}

}  // namespace ui
