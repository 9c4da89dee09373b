// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/comparison/feel.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "haptics/simulation/hand.h"

namespace comparison {
namespace {

/// The mean of a row of values weighted by a Gaussian about each; deviation in rows.
template <class T>
std::vector<T> smoothed(const std::vector<T>& values, double deviation) {
  const auto reach = static_cast<std::ptrdiff_t>(std::ceil(3.0 * deviation));
  const auto size = static_cast<std::ptrdiff_t>(values.size());
  std::vector<T> out;
  for (std::ptrdiff_t n = 0; n < size; ++n) {
    T sum = 0.0 * values[0];
    double weights = 0.0;
    for (std::ptrdiff_t m = std::max<std::ptrdiff_t>(0, n - reach);
         m <= std::min(size - 1, n + reach); ++m) {
      const double x = double(m - n) / deviation;
      const double weight = std::exp(-0.5 * x * x);
      sum += weight * values[static_cast<std::size_t>(m)];
      weights += weight;
    }
    out.push_back(sum / weights);
  }
  return out;
}

double square(double x) { return x * x; }
double square(const Vec3& x) { return x.squaredNorm(); }

/// rms of the values less their Gaussian mean, without so many at either edge; not a number if
/// nothing is left.
template <class T>
double rmsOfFine(const std::vector<T>& values, double deviation, std::size_t edge) {
  const std::vector<T> slow = smoothed(values, deviation);
  double squares = 0.0, count = 0.0;
  for (std::size_t n = edge; n + edge < values.size(); ++n) {
    squares += square(values[n] - slow[n]);
    ++count;
  }
  return std::sqrt(squares / count);
}

/// Largest change from one value to the next, without so many at either edge.
double largestStep(const std::vector<Vec3>& values, std::size_t edge) {
  double largest = 0.0;
  for (std::size_t n = edge; n + edge < values.size(); ++n)
    largest = std::max(largest, (values[n] - values[n - 1]).norm());
  return largest;
}

/// The forces of a proxy that is always at its nearest legal pose (FeelSummary::ideal_step_N).
std::vector<Vec3> idealForces(std::shared_ptr<const haptics::Scene> built, double isovalue,
                              const std::vector<Pose>& device) {
  constexpr int kParts = 20, kMostRests = 50;
  // a tick of a second: no limit of the speed at which it falls
  const auto unhurried = ours(std::move(built), isovalue, {0, 1'000'000'000, {1}});
  unhurried->start(device.front());
  std::vector<Vec3> forces;
  for (std::size_t n = 0; n < device.size(); ++n) {
    const Pose& X_from = device[n == 0 ? 0 : n - 1];
    Tick tick;
    for (int part = 1; part <= kParts; ++part)
      tick = unhurried->tick(part < kParts ? between(X_from, device[n], double(part) / kParts)
                                           : device[n]);
    for (int rest = 0; rest < kMostRests; ++rest) {
      const Pose X_WP = tick.X_WP;
      tick = unhurried->tick(device[n]);
      if ((tick.X_WP.translation() - X_WP.translation()).norm() < 1e-9) break;
    }
    forces.push_back(tick.force);
  }
  return forces;
}

/// A row of places along which the ball would just touch.
struct Path {
  std::vector<double> height;    ///< m along `in` from the first touch, one for each step
  double unevenness = INFINITY;  ///< m: greatest difference of heights
  Vec3 along = Vec3::Zero();
};

constexpr double kStep = 0.0002;  // m along the surface

/// How far the ball goes along `in` from p before a point is inside: by half voxels, then finely.
double touchFrom(const Judge& judge, const Vec3& p_W, const Vec3& in, double voxel, double most) {
  const auto free = [&](double d) {
    return judge.legal(haptics::poseOf(p_W + d * in, haptics::Quat::Identity()));
  };
  double outside = 0.0;
  while (outside < most && free(outside + 0.5 * voxel)) outside += 0.5 * voxel;
  double inside = outside + 0.5 * voxel;
  for (int n = 0; n < 12; ++n) {
    const double middle = 0.5 * (outside + inside);
    (free(middle) ? outside : inside) = middle;
  }
  return outside;
}

}  // namespace

std::vector<FeelSummary> compareFeel(const Touched& scene, const haptics::Scene& similar,
                                     const FreeBlocks& blocks, const SlidePlan& plan, Limit limit,
                                     unsigned seed) {
  const auto built = haptics::makeScene(scene.volume, ballTool(600, plan.radius),
                                        {haptics::FieldKind::Trilinear, similar.normal}, &similar);
  if (!built) return {};
  const haptics::PointShell& shell = (*built)->tool.shell;
  const auto hand =
      haptics::Hand::aimed(haptics::HandMotion::Slide, **built, scene.isovalue, 0.0, seed);
  if (!hand) return {};
  const Judge judge{scene, shell, blocks};
  const double voxel = scene.volume->grid.spacing.minCoeff();
  const Vec3 touch_W = hand->at(0.5).translation();
  const Vec3 in = (touch_W - hand->at(0.4).translation()).normalized();
  const Vec3 side = in.unitOrthogonal(), other = in.cross(side);

  // the most even of eight directions
  const auto steps = static_cast<int>(std::lround(plan.length / kStep));
  Path best;
  for (int n = 0; n < 8; ++n) {
    const double angle = 2.0 * std::numbers::pi * n / 8.0;
    Path path;
    path.along = std::cos(angle) * side + std::sin(angle) * other;
    double above = -0.0015, highest = -INFINITY, lowest = INFINITY;  // m
    for (int k = 0; k < steps; ++k) {
      const Vec3 from_W = touch_W + k * kStep * path.along + above * in;
      const double height = above + touchFrom(judge, from_W, in, voxel, 0.004);
      path.height.push_back(height);
      highest = std::max(highest, height);
      lowest = std::min(lowest, height);
      above = height - 0.0015;
    }
    path.unevenness = highest - lowest;
    if (path.unevenness < best.unevenness) best = path;
  }
  if (!(best.unevenness < 0.6 * plan.length)) return {};
  const std::vector<double> even = smoothed(best.height, 0.002 / kStep);

  // down onto it in 200 ms, then along it
  std::vector<Pose> device;
  const auto placeAt = [&](double way, double depth) {
    const double k = std::min(way / kStep, double(even.size() - 1));
    const auto low = std::min(static_cast<std::size_t>(k), even.size() - 2);
    const double height = even[low] + (k - double(low)) * (even[low + 1] - even[low]);
    Pose X = Pose::Identity();
    X.translation() = touch_W + way * best.along + (height + depth) * in;
    return X;
  };
  constexpr int kDown = 200;  // ticks
  for (int n = 0; n < kDown; ++n)
    device.push_back(placeAt(0.0, -0.003 + (plan.depth + 0.003) * n / kDown));
  const auto slide = static_cast<int>(1e3 * plan.length / plan.speed);
  for (int n = 0; n < slide; ++n) device.push_back(placeAt(1e-3 * n * plan.speed, plan.depth));
  if (!judge.legal(device.front())) return {};

  // from a tenth of a second after the ball set off
  constexpr std::size_t kFirst = kDown + 100;
  const double deviation = 0.5 * voxel / (1e-3 * plan.speed);
  const auto edge = static_cast<std::size_t>(std::ceil(3.0 * deviation));
  std::vector<double> height;
  std::vector<Vec3> lowered;  // N: what a ball at that height makes felt, but for a constant
  for (std::size_t n = kFirst; n < device.size(); ++n) {
    const double above = plan.depth + 0.0015;
    height.push_back(touchFrom(judge, device[n].translation() - above * in, in, voxel, 0.004));
    // along the path of the device, which rises and falls with the smoothed surface
    lowered.push_back(kStiffness * height.back() * in);
  }
  const double surface = rmsOfFine(height, deviation, edge);
  if (std::isnan(surface)) return {};

  std::vector<Vec3> ideal = idealForces(*built, scene.isovalue, device);
  ideal.erase(ideal.begin(), ideal.begin() + kFirst);

  auto methods = allMethods(scene, *built, limit);
  const std::vector<Track> tracks = follow(methods, {{"slide", device, false}});
  std::vector<FeelSummary> summaries;
  for (const Track& track : tracks) {
    std::vector<Vec3> force;
    for (std::size_t n = kFirst; n < device.size(); ++n)
      force.push_back(track.ticks.front()[n].force);
    FeelSummary summary{track.method};
    for (std::size_t n = edge; n + edge < force.size(); ++n)
      summary.mean_force_N += force[n].norm() / double(force.size() - 2 * edge);
    summary.largest_step_N = largestStep(force, edge);
    summary.surface_step_N = largestStep(lowered, edge);
    summary.ideal_step_N = largestStep(ideal, edge);
    summary.fine_noise_N = rmsOfFine(force, deviation, edge);
    summary.surface_fine_mm = 1e3 * surface;
    summaries.push_back(summary);
  }
  return summaries;
}

}  // namespace comparison
