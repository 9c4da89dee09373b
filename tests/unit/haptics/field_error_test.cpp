// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <functional>
#include <iomanip>
#include <iostream>

#include "haptics/field/scalar_field.h"
#include "tests/unit/haptics/made.h"

/// How far each field is from what was scanned: the figures of haptics/README.md, "Fields".
namespace {

using haptics::FieldKind;
using haptics::Grid;
using haptics::ScalarField;
using haptics::Vec3;
using haptics::Volume;
using made::Random;

constexpr double h = 1e-3;       // m: the voxel
constexpr double kTop = 1000.0;  // inside; 0 outside
constexpr double kHalf = 500.0;

using Distance = std::function<double(const Vec3&)>;  // in voxels, negative inside

const Distance kSphere = [](const Vec3& p) { return p.norm() / h - 12.0; };
const Distance kTorus = [](const Vec3& p) {
  const double ring = std::hypot(p.x(), p.y()) / h - 22.0;
  return std::hypot(ring, p.z() / h) - 7.0;
};
// level over slope: a distance near the surface, to first order
const Distance kGyroid = [](const Vec3& p) {
  const double k = 2.0 * M_PI / 24.0;
  const Vec3 a = k / h * p;
  const double level = std::sin(a.x()) * std::cos(a.y()) + std::sin(a.y()) * std::cos(a.z()) +
                       std::sin(a.z()) * std::cos(a.x());
  const Vec3 slope{std::cos(a.x()) * std::cos(a.y()) - std::sin(a.z()) * std::sin(a.x()),
                   std::cos(a.y()) * std::cos(a.z()) - std::sin(a.x()) * std::sin(a.y()),
                   std::cos(a.z()) * std::cos(a.x()) - std::sin(a.y()) * std::sin(a.z())};
  return level / (k * slope.norm());
};

/// A solid whose edge is blurred over three voxels, and noise of so much of the step.
Volume blurred(const Distance& distance, double noise) {
  std::mt19937 engine{41};
  std::normal_distribution<double> grain{0.0, kTop * noise};
  return made::sampled(made::centred(64, h), [&](const Vec3& p) {
    const double edge = std::clamp(0.5 - distance(p) / 3.0, 0.0, 1.0);
    return kTop * edge + (noise > 0.0 ? grain(engine) : 0.0);
  });
}

/// A plate of this thickness [voxels] through the middle, each voxel the share of it that the plate
/// fills.
Volume plate(const Vec3& n, double thickness) {
  return made::sampled(made::centred(33, h), [&](const Vec3& p) {
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
  return made::filled(volume.grid, haptics::ScalarType::Float32, [&](auto i, auto j, auto k) {
    return c[static_cast<std::size_t>((k * dims[1] + j) * dims[0] + i)];
  });
}

enum class Way { Trilinear, Approximating, Interpolating };
constexpr Way kWays[] = {Way::Trilinear, Way::Approximating, Way::Interpolating};
const char* nameOf(Way way) {
  return way == Way::Trilinear       ? "trilinear"
         : way == Way::Approximating ? "spline, approximating"
                                     : "spline, interpolating";
}
ScalarField fieldOf(Way way, const Volume& volume) {
  if (way == Way::Trilinear) return ScalarField{made::shared(volume)};
  return ScalarField{made::shared(way == Way::Interpolating ? prefiltered(volume) : volume),
                     FieldKind::CubicSpline};
}

Vec3 normalOf(const Distance& distance, const Vec3& p) {
  Vec3 n;
  for (int axis = 0; axis < 3; ++axis) {
    const Vec3 d = 1e-4 * h * Vec3::Unit(axis);
    n[axis] = distance(p + d) - distance(p - d);
  }
  return n.normalized();
}

struct Error {
  double position = 0.0;                          // rms, voxels
  double own = 0.0, central = 0.0, spline = 0.0;  // rms of the normals, degrees
};

Error errorOf(const ScalarField& field, const Distance& distance, int places, Random& random) {
  Error sum;
  int found = 0;
  while (found < places) {
    // a place on the surface, and its normal, from the formula
    Vec3 p = random.box(26.0 * h);
    for (int i = 0; i < 20; ++i) p -= h * distance(p) * normalOf(distance, p);
    if (std::abs(distance(p)) > 1e-6 || p.cwiseAbs().maxCoeff() > 26.0 * h) continue;
    const Vec3 n = normalOf(distance, p);
    // where the field has its surface on that normal
    double inside = -1.2, outside = 1.2;
    const auto value = [&](double t) { return field.value(field.indexOf(p + t * h * n)); };
    if (value(inside) < kHalf || value(outside) >= kHalf) continue;
    for (int i = 0; i < 40; ++i) {
      const double middle = 0.5 * (inside + outside);
      (value(middle) >= kHalf ? inside : outside) = middle;
    }
    ++found;
    sum.position += inside * inside;
    const Vec3 u = field.indexOf(p + inside * h * n);
    const auto off = [&](const Vec3& gradient) {
      const double angle =
          std::acos(std::clamp(-n.dot(gradient.normalized()), -1.0, 1.0)) * 180.0 / M_PI;
      return angle * angle;
    };
    sum.own += off(field.sample(u).gradient_W);
    sum.central += off(field.centralGradient(u));
    sum.spline += off(field.splineGradient(u));
  }
  const auto rms = [&](double& x) { x = std::sqrt(x / places); };
  rms(sum.position);
  rms(sum.own);
  rms(sum.central);
  rms(sum.spline);
  return sum;
}

TEST(Fields, LieNearWhatWasScannedAsTheReadmeSays) {
  Random random{42};
  std::cout << std::fixed << std::setprecision(3);
  for (const double noise : {0.0, 0.02})
    for (const Way way : kWays) {
      std::cout << nameOf(way) << ", noise " << noise << ":";
      for (const Distance& distance : {kSphere, kTorus, kGyroid}) {
        const Error e = errorOf(fieldOf(way, blurred(distance, noise)), distance, 2000, random);
        std::cout << "  " << e.position << " voxel, " << e.own << " / " << e.central << " / "
                  << e.spline << " deg";
        // no field is farther off than a smoothing spline on the tightest curve
        EXPECT_LT(e.position, 0.09);
        EXPECT_LT(std::min(e.own, e.central), noise > 0.0 ? 4.0 : 1.6);
      }
      std::cout << "\n";
    }
}

TEST(Fields, KeepOfAThinPlateWhatTheReadmeSays) {
  Random random{43};
  std::cout << std::fixed << std::setprecision(2);
  constexpr double kThicknesses[] = {0.6, 0.7, 0.8, 0.9, 1.1};
  double kept[3][5] = {};
  constexpr int kPlates = 6, kPlaces = 400;
  for (int t = 0; t < 5; ++t)
    for (int k = 0; k < kPlates; ++k) {
      const Vec3 n = random.direction();
      const Volume volume = plate(n, kThicknesses[t]);
      for (int w = 0; w < 3; ++w) {
        const ScalarField field = fieldOf(kWays[w], volume);
        for (int i = 0; i < kPlaces; ++i) {
          Vec3 p = random.box(9.0 * h);
          p -= n.dot(p) * n;
          double top = 0.0;
          for (double d = -1.0; d <= 1.0; d += 0.05)
            top = std::max(top, field.value(field.indexOf(p + d * h * n)));
          kept[w][t] += (top >= kHalf) / double(kPlates * kPlaces);
        }
      }
    }
  for (int w = 0; w < 3; ++w) {
    std::cout << nameOf(kWays[w]) << ":";
    for (int t = 0; t < 5; ++t) std::cout << "  " << kThicknesses[t] << " voxel " << kept[w][t];
    std::cout << "\n";
  }
  // what the smoothing spline loses is what the user is told of it
  EXPECT_GT(kept[0][2], kept[1][2] + 0.5);
  for (int w = 0; w < 3; ++w) EXPECT_GT(kept[w][4], 0.95);
}

}  // namespace
