// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QString>
#include <array>
#include <utility>
#include <vector>

#include "ui/props/picture.h"
#include "ui/props/view_look.h"
#include "ui/style/scene_colours.h"

namespace ui {

using style::Rgb;

/// What a preset shows.
enum class Tissue { Bone, Skin, Airway, Vessels, Teeth };
inline constexpr std::array kTissues{Tissue::Bone, Tissue::Skin, Tissue::Airway, Tissue::Vessels,
                                     Tissue::Teeth};
QString nameOf(Tissue tissue);

/// A starting point for an isovalue, not a threshold for diagnosis. In HU where the volume is, else
/// a quantile of the histogram.
double isovalueOf(Tissue tissue, const Picture& picture);

/// Intensity to colour of the surface.
class Colouring {
 public:
  /// One colour: ivory.
  Colouring() = default;
  /// Airway, skin, soft tissue, bone and teeth, by their HU or by quantiles of the histogram.
  static Colouring byTissue(const Picture& picture);
  /// The same, with what lies about the isovalue of vessels with contrast in red.
  static Colouring withVessels(const Picture& picture);

  static Colouring of(SurfaceColours colours, const Picture& picture);

  Rgb at(double intensity) const;

 private:
  struct Stop {
    double intensity;
    Rgb colour;
  };
  explicit Colouring(std::vector<Stop> stops) : stops_(std::move(stops)) {}
  std::vector<Stop> stops_ = {{0.0, style::kIvory}};  ///< by intensity
};

}  // namespace ui
