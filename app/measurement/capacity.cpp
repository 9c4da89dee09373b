// SPDX-License-Identifier: BSD-3-Clause
#include "app/measurement/capacity.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "haptics/simulation/hand.h"
#include "haptics/tool/point_shell.h"

namespace measurement {
namespace {

using haptics::Error;
using haptics::Expected;
using haptics::HandMotion;
using haptics::Pose;

constexpr HandMotion kHands[] = {HandMotion::Slide, HandMotion::Tap, HandMotion::Hook,
                                 HandMotion::Wedge};
constexpr std::uint64_t kSeed = 1;
constexpr double kDepth = 0.004;  // m that the device goes beyond the surface, as in a session
constexpr double kLeadIn = 0.5;   // s until a hand touches
constexpr int kFirst = 1'000, kFewest = 10;
constexpr double kApart = 4.0 / 3.0;  // between carried and not, when it is known well enough

tl::unexpected<Error> cancelled() {
  return tl::unexpected(Error{Error::Kind::Cancelled, {"measurement-cancelled", {}}, "cancelled"});
}

Expected<std::vector<Path>> aimedPaths(const CapacityRequest& request, std::stop_token stop) {
  const double period = request.allowance.rate.period();
  std::vector<Path> paths;
  for (const HandMotion motion : kHands) {
    if (stop.stop_requested()) return cancelled();
    const auto hand = haptics::Hand::aimed(motion, *request.scene, request.isovalue, kDepth, kSeed);
    if (!hand) return tl::unexpected(hand.error());
    Path path;
    path.lead_in = static_cast<std::size_t>(std::lround(kLeadIn / period));
    const auto ticks =
        path.lead_in + static_cast<std::size_t>(std::lround(request.touching / period));
    for (std::size_t n = 0; n < ticks; ++n) path.poses.push_back(hand->at(double(n) * period));
    paths.push_back(std::move(path));
  }
  return paths;
}

double areaOf(const haptics::TriangleMesh& mesh) {
  double area = 0.0;
  for (const auto& [a, b, c] : mesh.triangles)
    area += 0.5 *
            (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]).norm();
  return area;
}

/// Two significant digits, upwards: a number to read.
int rounded(double points) {
  const double unit = std::pow(10.0, std::max(0.0, std::floor(std::log10(points)) - 1.0));
  return static_cast<int>(std::ceil(points / unit) * unit);
}

const Load* fewestNotCarried(std::span<const Load> tried) {
  for (const Load& load : tried)
    if (!load.carried) return &load;
  return nullptr;
}

}  // namespace

double Capacity::spacing(int points) const { return std::sqrt(area / double(points)); }

std::optional<int> nextToTry(std::span<const Load> tried, int dense, int most_points) {
  if (tried.empty()) return std::min(kFirst, most_points);
  const Load* failed = fewestNotCarried(tried);
  int carried = 0;
  for (const Load& load : tried) {
    if (&load == failed) break;
    carried = load.points;
  }
  // what may be suggested comes first: the time may not last for more
  const bool known = std::any_of(tried.begin(), tried.end(),
                                 [&](const Load& load) { return load.points == dense; });
  if (!known && dense > 0 && dense < (failed ? failed->points : carried)) return dense;
  if (failed == nullptr && carried < most_points)
    return static_cast<int>(std::min<std::int64_t>(std::int64_t{10} * carried, most_points));
  // not even the fewest: fewer still
  if (carried == 0) {
    if (failed->points <= kFewest) return {};
    return std::max(kFewest, failed->points / 10);
  }
  if (failed == nullptr || failed->points <= kApart * carried) return {};
  const int between = rounded(std::sqrt(double(carried) * double(failed->points)));
  if (between <= carried || between >= failed->points) return {};
  return between;
}

std::vector<Path> pathsFor(const haptics::Tool& other, const haptics::Tool& tool,
                           std::vector<Path> paths) {
  const haptics::Vec3 apart = tool.mesh.vertices[0] - other.mesh.vertices[0];
  for (Path& path : paths)
    for (Pose& X : path.poses) X.translation() += X.linear() * apart;
  return paths;
}

void conclude(Capacity& capacity) {
  const Load* failed = fewestNotCarried(capacity.tried);
  capacity.too_many = failed ? std::optional{failed->points} : std::nullopt;
  capacity.most = 0;
  for (const Load& load : capacity.tried) {
    if (&load == failed) break;
    capacity.most = load.points;
  }
  capacity.suggested = std::min(capacity.dense, capacity.most);
}

Expected<Capacity> measureCapacity(const CapacityRequest& request, std::stop_token stop,
                                   const std::function<void(double fraction)>& advanced) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point begun = Clock::now();
  const auto elapsed = [&] { return std::chrono::duration<double>(Clock::now() - begun).count(); };
  const auto goOn = [&] {
    advanced(std::min(1.0, elapsed() / request.seconds));
    return !stop.stop_requested();
  };

  const haptics::Scene& scene = *request.scene;
  const auto paths = aimedPaths(request, stop);
  if (!paths) return tl::unexpected(paths.error());
  const auto present =
      loadOf(scene, request.isovalue, request.coupling, *paths, request.allowance, goOn);
  if (!present) return cancelled();
  Capacity capacity;
  capacity.present = *present;
  capacity.budget = 1e-9 * double(request.allowance.nanoseconds);
  capacity.voxel = scene.lengths.voxel;
  const haptics::TriangleMesh& mesh = scene.tool.mesh;
  capacity.area = areaOf(mesh);
  if (capacity.area > 0.0) {
    const double dense = capacity.area / (capacity.voxel * capacity.voxel);
    capacity.dense = rounded(std::clamp(dense, double(kFewest), 1e9));
  }

  while (capacity.area > 0.0 && elapsed() < request.seconds) {
    const auto points = nextToTry(capacity.tried, capacity.dense, request.most_points);
    if (!points) break;
    auto tool = haptics::makeTool(scene.tool.name, mesh, *points);
    if (!tool) return tl::unexpected(tool.error());
    const std::vector<Path> same = pathsFor(*tool, scene.tool, *paths);
    if (!goOn()) return cancelled();
    const auto other = haptics::makeScene(request.scene->volume, std::move(*tool),
                                          {scene.field.kind(), scene.normal}, &scene);
    if (!other) return tl::unexpected(other.error());
    const auto load =
        loadOf(**other, request.isovalue, request.coupling, same, request.allowance, goOn);
    if (!load) return cancelled();
    capacity.tried.insert(
        std::upper_bound(capacity.tried.begin(), capacity.tried.end(), load->points,
                         [](int points_, const Load& l) { return points_ < l.points; }),
        *load);
  }
  conclude(capacity);
  advanced(1.0);
  return capacity;
}

}  // namespace measurement
