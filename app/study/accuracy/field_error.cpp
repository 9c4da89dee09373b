// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/accuracy/field_error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "app/study/accuracy/work_precision.h"
#include "app/study/comparison/measures.h"
#include "datasets/phantoms/sampling.h"
#include "haptics/core/budget.h"

namespace study::accuracy {
namespace {

using datasets::Random;
using haptics::FieldKind;
using haptics::ScalarField;
using haptics::Vec3;
using haptics::Volume;

constexpr double h = 1e-3;       // m: the voxel
constexpr double kTop = 1000.0;  // inside; 0 outside
constexpr double kHalf = 500.0;
constexpr Interpolation kInterpolations[] = {Interpolation::Trilinear,
                                             Interpolation::SplineApproximating,
                                             Interpolation::SplineInterpolating};

// Bounds: what is argued, and a fifth to a third more.
constexpr double kPosition = 0.035;        // voxels
constexpr double kPositionInNoise = 0.05;  // voxels
constexpr double kNormal = 0.4;            // degrees
constexpr double kNormalInNoise = 2.5;     // degrees
constexpr const char* kWhyPosition =
    "A smoothing spline moves a surface by a sixth of the sum of its curvatures, at most 0.03 "
    "voxel "
    "on these shapes; trilinear interpolation by an eighth of it at most. The bound is a fifth "
    "more.";
constexpr const char* kWhyNormal =
    "Measured: 0.28 degrees at most, on the gyroid. The bound is that and two fifths.";
constexpr const char* kWhyInNoise =
    "Noise of 2 % of an edge three voxels wide is 0.06 voxel at a voxel; interpolation leaves 0.54 "
    "of it: 0.033 voxel of position, 0.045 with what there is without noise, and 1.9 degrees of a "
    "central difference. The bound is a tenth and a third more.";

// level over slope: a distance near the surface, to first order
double gyroid(const Vec3& p) {
  const double k = 2.0 * std::numbers::pi / 24.0;
  const Vec3 a = k / h * p, s = a.array().sin(), c = a.array().cos();
  const double level = s.x() * c.y() + s.y() * c.z() + s.z() * c.x();
  const Vec3 slope{c.x() * c.y() - s.z() * s.x(), c.y() * c.z() - s.x() * s.y(),
                   c.z() * c.x() - s.y() * s.z()};
  return level / (k * slope.norm());
}

/// A plate of this thickness [voxels] through the middle, each voxel the share of it that the plate
/// fills.
Volume plate(const Vec3& n, double thickness) {
  return datasets::sampledFloat(datasets::centredGrid(33, h), [&](const Vec3& p) {
    constexpr int kParts = 8;
    int filled = 0;
    for (int i = 0; i < kParts * kParts * kParts; ++i) {
      const Vec3 part{double(i % kParts), double(i / kParts % kParts), double(i / kParts / kParts)};
      const Vec3 q = p / h + (part + Vec3::Constant(0.5)) / kParts - Vec3::Constant(0.5);
      filled += std::abs(n.dot(q)) <= 0.5 * thickness;
    }
    return kTop * filled / (kParts * kParts * kParts);
  });
}

/// The coefficients whose spline passes through the voxels: the recursive filter of [Unser 1999],
/// with mirrored ends, once along each axis.
Volume prefiltered(const Volume& volume) {
  const auto& dims = volume.grid.dims;
  const auto* voxels = static_cast<const float*>(volume.voxels.get());
  std::vector<double> c(voxels, voxels + volume.grid.voxelCount());
  const double pole = std::sqrt(3.0) - 2.0;
  const std::int64_t stride[3] = {1, dims[0], dims[0] * dims[1]};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::int64_t n = dims[axis], s = stride[axis];
    for (std::int64_t first = 0; first < volume.grid.voxelCount(); ++first) {
      if (first / s % n != 0) continue;
      double* line = c.data() + first;
      double start = 0.0, power = 1.0;
      for (std::int64_t i = 0; i < n; ++i, power *= pole) start += power * line[i * s];
      line[0] = start;
      for (std::int64_t i = 1; i < n; ++i) line[i * s] += pole * line[(i - 1) * s];
      line[(n - 1) * s] =
          pole / (pole * pole - 1.0) * (line[(n - 1) * s] + pole * line[(n - 2) * s]);
      for (std::int64_t i = n - 2; i >= 0; --i)
        line[i * s] = pole * (line[(i + 1) * s] - line[i * s]);
      for (std::int64_t i = 0; i < n; ++i) line[i * s] *= 6.0;
    }
  }
  return datasets::filled(volume.grid, haptics::ScalarType::Float32, [&](auto i, auto j, auto k) {
    return c[static_cast<std::size_t>((k * dims[1] + j) * dims[0] + i)];
  });
}

Vec3 normalOf(const Shape& shape, const Vec3& p) {
  Vec3 n;
  for (int axis = 0; axis < 3; ++axis) {
    const Vec3 d = 1e-4 * h * Vec3::Unit(axis);
    n[axis] = shape.distance(p + d) - shape.distance(p - d);
  }
  return n.normalized();
}

/// Thread CPU of one call of f at each place, on the mean [ns].
template <class F>
double nanosecondsOf(const std::vector<Vec3>& places, F&& f) {
  double sum = 0.0;
  const std::int64_t begun = haptics::Budget::threadTime();
  for (const Vec3& u : places) sum += f(u);
  const std::int64_t ended = haptics::Budget::threadTime();
  // what is summed must be computed
  return double(ended - begun) / double(places.size()) + (std::isnan(sum) ? 1e9 : 0.0);
}

}  // namespace

const char* nameOf(Interpolation kind) {
  return kind == Interpolation::Trilinear             ? "trilinear"
         : kind == Interpolation::SplineApproximating ? "spline, approximating"
                                                      : "spline, interpolating";
}

ScalarField fieldOf(Interpolation kind, const Volume& volume) {
  if (kind == Interpolation::Trilinear) return ScalarField{std::make_shared<const Volume>(volume)};
  return ScalarField{std::make_shared<const Volume>(
                         kind == Interpolation::SplineInterpolating ? prefiltered(volume) : volume),
                     FieldKind::CubicSpline};
}

const std::vector<Shape>& shapes() {
  static const std::vector<Shape> kShapes{
      {"ball", [](const Vec3& p) { return p.norm() / h - 12.0; }},
      {"ring",
       [](const Vec3& p) {
         return std::hypot(std::hypot(p.x(), p.y()) / h - 22.0, p.z() / h) - 7.0;
       }},
      {"gyroid", gyroid}};
  return kShapes;
}

Volume blurred(const Shape& shape, double noise) {
  auto grain = datasets::grains(41);
  return datasets::sampledFloat(datasets::centredGrid(64, h), [&](const Vec3& p) {
    const double edge = std::clamp(0.5 - shape.distance(p) / 3.0, 0.0, 1.0);
    return kTop * edge + (noise > 0.0 ? kTop * noise * grain() : 0.0);
  });
}

SurfaceErrors surfaceErrors(const ScalarField& field, const Shape& shape, int places,
                            Random& random) {
  SurfaceErrors errors;
  std::vector<Vec3> found;
  while (static_cast<int>(found.size()) < places) {
    // a place on the surface, and its normal, from the formula
    Vec3 p = random.box(26.0 * h);
    for (int i = 0; i < 20; ++i) p -= h * shape.distance(p) * normalOf(shape, p);
    if (std::abs(shape.distance(p)) > 1e-6 || p.cwiseAbs().maxCoeff() > 26.0 * h) continue;
    const Vec3 n = normalOf(shape, p);
    // where the field has its surface on that normal
    double inside = -1.2, outside = 1.2;
    const auto value = [&](double t) { return field.value(field.indexOf(p + t * h * n)); };
    if (value(inside) < kHalf || value(outside) >= kHalf) continue;
    for (int i = 0; i < 40; ++i) {
      const double middle = 0.5 * (inside + outside);
      (value(middle) >= kHalf ? inside : outside) = middle;
    }
    errors.position.push_back(std::abs(inside));
    const Vec3 u = field.indexOf(p + inside * h * n);
    const auto off = [&](const Vec3& gradient) {
      return std::acos(std::clamp(-n.dot(gradient.normalized()), -1.0, 1.0)) * 180.0 /
             std::numbers::pi;
    };
    errors.cell.push_back(off(field.sample(u).gradient_W));
    errors.central.push_back(off(field.centralGradient(u)));
    errors.spline.push_back(off(field.splineGradient(u)));
    found.push_back(u);
  }
  errors.value_ns = nanosecondsOf(found, [&](const Vec3& u) { return field.value(u); });
  errors.cell_ns =
      nanosecondsOf(found, [&](const Vec3& u) { return field.sample(u).gradient_W.x(); });
  errors.central_ns =
      nanosecondsOf(found, [&](const Vec3& u) { return field.centralGradient(u).x(); });
  errors.spline_ns =
      nanosecondsOf(found, [&](const Vec3& u) { return field.splineGradient(u).x(); });
  return errors;
}

std::array<double, 3> keptOfPlates(double thickness, int plates, int places, Random& random) {
  std::array<double, 3> kept{};
  for (int k = 0; k < plates; ++k) {
    const Vec3 n = random.direction();
    const Volume volume = plate(n, thickness);
    for (const Interpolation kind : kInterpolations) {
      const ScalarField field = fieldOf(kind, volume);
      for (int i = 0; i < places; ++i) {
        Vec3 p = random.box(9.0 * h);
        p -= n.dot(p) * n;
        double top = 0.0;
        for (double d = -1.0; d <= 1.0; d += 0.05)
          top = std::max(top, field.value(field.indexOf(p + d * h * n)));
        kept[static_cast<std::size_t>(kind)] += (top >= kHalf) / double(plates * places);
      }
    }
  }
  return kept;
}

Outcome fieldErrors(double noise, int places, unsigned seed, const FieldMade& made) {
  Outcome outcome;
  const std::string with = noise > 0.0 ? ", " + shortly(100.0 * noise) + " % noise" : ", no noise";
  for (const Shape& shape : shapes()) {
    WorkPrecision position{shape.name + with + ": position of the surface",
                           "Distance of the field's surface from the solid's along the normal, "
                           "against the time to look a value up.",
                           "CPU of a value [ns]", "error of position [voxel]"};
    WorkPrecision normal{shape.name + with + ": normal",
                         "Angle between the field's gradient and the solid's normal, against the "
                         "time of a gradient.",
                         "CPU of a gradient [ns]", "error of the normal [degrees]"};
    const Volume volume = blurred(shape, noise);
    for (const Interpolation kind : kInterpolations) {
      Random random{seed};
      const SurfaceErrors e = surfaceErrors(made(kind, volume), shape, places, random);
      position.points.push_back({nameOf(kind), "", {e.value_ns}, e.position});
      normal.points.push_back({nameOf(kind), "cell", {e.cell_ns}, e.cell});
      normal.points.push_back({nameOf(kind), "central", {e.central_ns}, e.central});
      normal.points.push_back({nameOf(kind), "spline", {e.spline_ns}, e.spline});
      if (kind == Interpolation::SplineInterpolating) continue;  // for comparison only
      const std::string what = std::string{nameOf(kind)} + " on the " + shape.name + with;
      outcome.cases.push_back({what + ": position, rms", rms(e.position),
                               noise > 0.0 ? kPositionInNoise : kPosition, "voxel",
                               Case::Sense::AtMost, noise > 0.0 ? kWhyInNoise : kWhyPosition});
      outcome.cases.push_back({what + ": better of cell and central normal, rms",
                               std::min(rms(e.cell), rms(e.central)),
                               noise > 0.0 ? kNormalInNoise : kNormal, "degrees",
                               Case::Sense::AtMost, noise > 0.0 ? kWhyInNoise : kWhyNormal});
    }
    addTo(outcome, position);
    addTo(outcome, normal);
  }
  return outcome;
}

Outcome plateErrors(int plates, int places, unsigned seed) {
  Outcome outcome;
  Plot plot{"Thin plates",
            "Share of a plate, lying at random, at which the field still has a surface half way "
            "up, against its thickness.",
            {"thickness [voxel]"},
            {"left of the plate"}};
  for (const Interpolation kind : kInterpolations) plot.series.push_back({nameOf(kind), {}});
  Random random{seed};
  for (const double thickness : {0.6, 0.7, 0.8, 0.9, 1.1}) {
    const std::array<double, 3> kept = keptOfPlates(thickness, plates, places, random);
    for (std::size_t k = 0; k < kept.size(); ++k) {
      plot.series[k].points.push_back({thickness, kept[k]});
      if (thickness > 1.0)
        outcome.cases.push_back({plot.series[k].name + ": left of a plate of 1.1 voxel", kept[k],
                                 0.95, "", Case::Sense::AtLeast});
    }
  }
  outcome.plots.push_back(std::move(plot));
  return outcome;
}

}  // namespace study::accuracy
