// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/accuracy/carving.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <numbers>

#include "app/study/accuracy/work_precision.h"
#include "app/study/comparison/measures.h"
#include "app/study/reference/solid.h"
#include "datasets/phantoms/making.h"
#include "datasets/phantoms/sampling.h"
#include "haptics/core/budget.h"

namespace study::accuracy {
namespace {

using datasets::Random;
using haptics::BurrCut;
using haptics::ScalarType;
using haptics::Vec3;
using haptics::Volume;

constexpr double kBlockVoxel = 1e-3;  // m: the voxel

/// A solid that fills its grid, but for a voxel of background.
struct Matter {
  const char* name;
  ScalarType type;
  double solid, isovalue, background;
};
constexpr Matter kMatters[] = {{"int16, 1200 at 300", ScalarType::Int16, 1200.0, 300.0, -1024.0},
                               {"int16, 700 at 300", ScalarType::Int16, 700.0, 300.0, -1024.0},
                               {"uint8, 200 at 90", ScalarType::UInt8, 200.0, 90.0, 0.0},
                               {"float, 1200 at 300", ScalarType::Float32, 1200.0, 300.0, -1024.0}};

constexpr double kLargeBurr = 3.0;  // voxels: a radius from which the finer bounds hold
constexpr double kBias = 0.165;     // voxels, times the radius in voxels: haptics/carving/burr.cpp
constexpr double kOtherPlace = 0.015;  // voxels: of a wall at another isovalue, but for the bias

/// Bounds of what the burr leaves. Those of a ball are what was asked. A groove and a cavity have
/// less curved walls, which need less than the biases of a ball, and edges between them, at which
/// central differences meet two curvatures; both grow with the curvature. Measured, and a fifth
/// more.
struct CarvedBounds {
  double place, normal, volume;  ///< voxels, degrees, per cent
};
CarvedBounds boundsOf(const std::string& shape, double radius) {
  const bool large = radius >= kLargeBurr, ball = shape == "ball", groove = shape == "groove";
  return {(large ? 0.02 : 0.04) + (ball     ? 0.0
                                   : groove ? 0.025
                                            : 0.04) /
                                      radius,
          ball     ? (large ? 1.3 : 2.5)
          : groove ? 7.5 / radius
                   : 9.5 / radius,
          ball ? 1.0 : 11.5 / (radius * radius)};
}

/// All points within a radius of a rectangle, which may be a segment or a point.
struct Swept {
  Vec3 centre = Vec3::Zero(), u = Vec3::UnitX(), v = Vec3::UnitY();
  double a = 0.0, b = 0.0;  ///< m: half of its sides along u and v

  Vec3 nearest(const Vec3& p) const {
    return centre + std::clamp(u.dot(p - centre), -a, a) * u +
           std::clamp(v.dot(p - centre), -b, b) * v;
  }
  /// m3, by Steiner's formula.
  double volume(double radius) const {
    return 8.0 * a * b * radius + 2.0 * std::numbers::pi * radius * radius * (a + b) +
           4.0 / 3.0 * std::numbers::pi * radius * radius * radius;
  }
  /// In lines a quarter of a voxel apart, each in steps of half a radius.
  std::vector<BurrCut> cuts(double radius, double isovalue) const {
    const int lines = int(std::ceil(2.0 * b / (0.25 * kBlockVoxel))) + 1;
    const int steps = std::max(1, int(std::ceil(2.0 * a / (0.5 * radius))));
    std::vector<BurrCut> all;
    for (int line = 0; line < lines; ++line) {
      const Vec3 middle = centre + (lines > 1 ? 2.0 * b * line / (lines - 1) - b : 0.0) * v;
      const auto at = [&](int step) { return middle + (2.0 * a * step / steps - a) * u; };
      for (int step = 0; step < steps; ++step)
        all.push_back({at(step), at(step + 1), radius, isovalue});
    }
    return all;
  }
};

/// At a random place between the voxels, lying at random. Radius [m].
Swept sweptAtRandom(const std::string& shape, double radius, Random& random) {
  const haptics::Mat3 R = random.rotation().toRotationMatrix();
  return {.centre = random.box(0.5 * kBlockVoxel),
          .u = R.col(0),
          .v = R.col(1),
          .a = shape == "ball" ? 0.0 : radius,
          .b = shape == "cavity" ? radius : 0.0};
}

/// A volume to cut, and a copy of its voxels for the cuts.
struct Block {
  Block(const Matter& matter, double reach)
      : before{datasets::filled(
            datasets::centredGrid(2 * std::int64_t(std::ceil(reach / kBlockVoxel)) + 13,
                                  kBlockVoxel),
            matter.type,
            [&](auto i, auto j, auto k) {
              return i + j + k == 0 ? matter.background : matter.solid;
            })},
        voxels{haptics::allocateVoxels(before.grid.voxelCount(), matter.type).value()} {
    std::memcpy(voxels.get(), before.voxels.get(),
                std::size_t(before.grid.voxelCount()) * haptics::sizeOf(matter.type));
    after = before;
    after.voxels = voxels;
  }
  Volume before;
  std::shared_ptr<void> voxels;
  Volume after;
};

/// Errors of a wall.
struct WallErrors {
  std::vector<double> place;   ///< voxels, outwards
  std::vector<double> normal;  ///< degrees

  /// A wall that was not found counts as all wrong.
  void add(double off, double turned) {
    place.push_back(off);
    normal.push_back(turned);
  }
};

std::vector<double> sizesOf(std::vector<double> values) {
  for (double& v : values) v = std::abs(v);
  return values;
}

/// Looks for the wall at `isovalue` along rays through the ideal one, by the reference's field and
/// central differences. The place counts from so far outside of the ideal wall [voxels].
void addErrors(const Volume& volume, double isovalue, const Swept& swept, double radius, int rays,
               double outside, Random& random, WallErrors& errors) {
  const reference::Solid solid{volume, isovalue,
                               reference::choicesFor(volume.grid, reference::Variant::Literal)};
  constexpr double kFrom = -2.0, kUntil = 2.0, kStep = 0.05;  // voxels
  for (int n = 0; n < rays; ++n) {
    const Vec3 within = swept.centre + random.in(-1.0, 1.0) * swept.a * swept.u +
                        random.in(-1.0, 1.0) * swept.b * swept.v;
    const Vec3 far = within + 4.0 * radius * random.direction();
    const Vec3 core = swept.nearest(far), way = (far - core).normalized();
    const auto at = [&](double t) { return core + (radius + (outside + t) * kBlockVoxel) * way; };
    double t = kFrom;
    while (t < kUntil && !solid.inside(at(t))) t += kStep;
    if (t == kFrom || t >= kUntil) {
      errors.add(INFINITY, 180.0);
      continue;
    }
    double free = t - kStep, full = t;
    for (int i = 0; i < 40; ++i) {
      const double middle = 0.5 * (free + full);
      (solid.inside(at(middle)) ? full : free) = middle;
    }
    const double along = solid.gradient(at(full)).normalized().dot(way);
    errors.add(full, std::acos(std::clamp(along, -1.0, 1.0)) * 180.0 / std::numbers::pi);
  }
}

/// What a carver left of one shape at several places.
struct Carved {
  WallErrors errors;
  double removed = 0.0, ideal = 0.0;  ///< m3
  std::vector<double> cost;           ///< us of CPU: of each cut

  double volumeOff() const { return 100.0 * (removed / ideal - 1.0); }  ///< per cent
};

/// Radius in voxels. The places and the rays are the same for every carver.
Carved carved(const Carver& carver, const Matter& matter, const std::string& shape, double radius,
              const CarvingEffort& effort, unsigned seed) {
  Random random{seed};
  Carved found;
  const double R = radius * kBlockVoxel;
  for (int n = 0; n < effort.trials; ++n) {
    const Swept swept = sweptAtRandom(shape, R, random);
    const Block block{matter, R + std::hypot(swept.a, swept.b)};
    for (const BurrCut& cut : swept.cuts(R, matter.isovalue)) {
      const std::int64_t begun = haptics::Budget::threadTime();
      found.removed += carver.cut(block.before, block.voxels.get(), cut);
      found.cost.push_back(1e-3 * double(haptics::Budget::threadTime() - begun));
    }
    found.ideal += swept.volume(R);
    addErrors(block.after, matter.isovalue, swept, R, effort.rays, 0.0, random, found.errors);
  }
  return found;
}

/// Lowers each voxel around a cut to the background by the share that `full` leaves of it, by the
/// distance of its centre to the wall [voxels].
template <class Full>
double cutPlainly(const Volume& volume, void* voxels, const BurrCut& cut, Full&& full) {
  const haptics::VoxelBox box = haptics::BurrCarving{volume, cut}.box();
  const Vec3 way = cut.to_W - cut.from_W;
  double removed = 0.0;
  haptics::visitVoxels(volume.type, voxels, [&](const auto* first) {
    using T = std::remove_cvref_t<decltype(*first)>;
    T* const out = static_cast<T*>(voxels);
    for (std::int64_t k = box.first[2]; k < box.end[2]; ++k)
      for (std::int64_t j = box.first[1]; j < box.end[1]; ++j)
        for (std::int64_t i = box.first[0]; i < box.end[0]; ++i) {
          const Vec3 p = volume.grid.worldOf({double(i), double(j), double(k)});
          const double along =
              way.isZero(0.0) ? 0.0
                              : std::clamp(way.dot(p - cut.from_W) / way.squaredNorm(), 0.0, 1.0);
          const double d = ((p - cut.from_W - along * way).norm() - cut.radius) / kBlockVoxel;
          T& voxel = out[(k * volume.grid.dims[1] + j) * volume.grid.dims[0] + i];
          const double range = volume.greatest - volume.least;
          const double left = volume.least + range * full(d);
          if (!(left < double(voxel))) continue;
          removed += (double(voxel) - left) / range * kBlockVoxel * kBlockVoxel * kBlockVoxel;
          voxel = static_cast<T>(left);
        }
  });
  return removed;
}

}  // namespace

const std::vector<Carver>& carvers() {
  static const std::vector<Carver> kCarvers{
      {"ours",
       [](const Volume& volume, void* voxels, const BurrCut& cut) {
         return haptics::BurrCarving{volume, cut}.lowerAll(voxels, volume.voxels.get()).volume;
       }},
      {"edge of a voxel",
       [](const Volume& volume, void* voxels, const BurrCut& cut) {
         // through the isovalue at the wall
         const double share = (cut.isovalue - volume.least) / (volume.greatest - volume.least);
         return cutPlainly(volume, voxels, cut,
                           [=](double d) { return std::clamp(share + d, 0.0, 1.0); });
       }},
      {"whole voxels", [](const Volume& volume, void* voxels, const BurrCut& cut) {
         return cutPlainly(volume, voxels, cut, [](double d) { return d < 0.0 ? 0.0 : 1.0; });
       }}};
  return kCarvers;
}

const std::vector<std::string>& carvedShapes() {
  static const std::vector<std::string> kShapes{"ball", "groove", "cavity"};
  return kShapes;
}

Outcome carvings(const std::vector<Carver>& all, const std::string& shape,
                 const CarvingEffort& effort, unsigned seed) {
  Outcome outcome;
  const auto plotOf = [&](const char* what, const std::string& description, const char* error) {
    return Plot{"Carved " + shape + ": " + what + " of the wall",
                description,
                {"radius of the burr [voxel]", Scale::Log},
                {error, Scale::Log}};
  };
  Plot place = plotOf("place",
                      "Distance of the wall from the ideal " + shape +
                          ", root mean square over all directions and places, against the burr's "
                          "radius.",
                      "error of place, rms [voxel]");
  Plot normal =
      plotOf("normal", "Angle between the central difference at the wall and the ideal normal.",
             "error of the normal, rms [degrees]");
  WorkPrecision work{"Carved " + shape + ": place against time",
                     "Distance of the wall from the ideal " + shape +
                         ", against the time of a cut; one mark for each radius.",
                     "CPU of a cut [us]", "error of place [voxel]"};
  Table table{"Carved shapes",
              {"shape", "material", "method", "radius [voxel]", "place, rms [voxel]",
               "place, mean [voxel]", "normal, rms [degrees]", "normal, worst [degrees]",
               "volume off [%]", "CPU of a cut [us], median"},
              {}};
  for (const Carver& carver : all)
    for (const Matter& matter : kMatters) {
      const bool judged = &carver == &all.front();
      if (!judged && &matter != kMatters) continue;
      const std::string name = carver.method + ", " + matter.name;
      Series places{name, {}}, normals{name, {}};
      for (const double radius : effort.radii) {
        const Carved found = carved(carver, matter, shape, radius, effort, seed);
        const double off = rms(found.errors.place), turned = rms(found.errors.normal);
        places.points.push_back({radius, off});
        normals.points.push_back({radius, turned});
        table.rows.push_back({shape, matter.name, carver.method, shortly(radius), shortly(off),
                              shortly(comparison::mean(found.errors.place)), shortly(turned),
                              shortly(*std::ranges::max_element(found.errors.normal)),
                              shortly(found.volumeOff()), shortly(comparison::median(found.cost))});
        if (&matter == kMatters)
          work.points.push_back(
              {carver.method, "R = " + shortly(radius), found.cost, sizesOf(found.errors.place)});
        if (!judged) continue;
        const std::string what =
            "carved " + shape + " of " + shortly(radius) + " voxels in " + matter.name;
        const CarvedBounds bounds = boundsOf(shape, radius);
        const auto atMost = [&](const char* measure, double value, double bound, const char* unit) {
          outcome.cases.push_back({what + measure, value, bound, unit, Case::Sense::AtMost,
                                   "over " + std::to_string(effort.trials) + " places"});
        };
        atMost(": place of the wall, rms", off, bounds.place, "voxel");
        atMost(": normal of the wall, rms", turned, bounds.normal, "degrees");
        atMost(": volume removed, off the shape's", std::abs(found.volumeOff()), bounds.volume,
               "%");
      }
      place.series.push_back(std::move(places));
      normal.series.push_back(std::move(normals));
    }
  outcome.plots.push_back(std::move(place));
  outcome.plots.push_back(std::move(normal));
  addTo(outcome, work);
  outcome.tables.insert(outcome.tables.begin(), std::move(table));
  return outcome;
}

Outcome carvedAtOtherIsovalues(const Carver& carver, const CarvingEffort& effort, unsigned seed) {
  Outcome outcome;
  const Matter& matter = kMatters[0];
  // per voxel: a third of the way from the background to the isovalue (haptics/carving/README.md)
  const double slope = (matter.isovalue - matter.background) / 3.0;
  Plot plot{"Wall of a carved ball at another isovalue",
            "How far the wall lies outside of the ball that was cut, at each isovalue; cut at " +
                shortly(matter.isovalue) + ".",
            {"isovalue"},
            {"outside of the ball [voxel]"}};
  Table table{"Walls at another isovalue than that of the cut",
              {"radius [voxel]", "isovalue", "predicted [voxel]", "place, mean [voxel]",
               "place, rms about the mean [voxel]", "normal, rms [degrees]"},
              {}};
  Series predicted{"(s' - s) / slope", {}, true, false};
  for (const double radius : effort.radii) {
    if (radius < kLargeBurr) continue;
    Series series{"radius " + shortly(radius) + " voxels", {}};
    for (const double isovalue : {-300.0, -100.0, 100.0, 300.0, 500.0, 700.0}) {
      const double outside = (isovalue - matter.isovalue) / slope;
      Random random{seed};
      WallErrors errors;
      for (int n = 0; n < effort.trials; ++n) {
        const Swept swept = sweptAtRandom("ball", radius * kBlockVoxel, random);
        const Block block{matter, radius * kBlockVoxel};
        for (const BurrCut& cut : swept.cuts(radius * kBlockVoxel, matter.isovalue))
          carver.cut(block.before, block.voxels.get(), cut);
        addErrors(block.after, isovalue, swept, radius * kBlockVoxel, effort.rays, outside, random,
                  errors);
      }
      const double off = comparison::mean(errors.place);
      std::vector<double> about = errors.place;
      for (double& p : about) p -= off;
      series.points.push_back({isovalue, outside + off});
      if (predicted.points.size() < 6) predicted.points.push_back({isovalue, outside});
      table.rows.push_back({shortly(radius), shortly(isovalue), shortly(outside),
                            shortly(outside + off), shortly(rms(about)),
                            shortly(rms(errors.normal))});
      // a trilinear field lies inside a smaller ball by more, which was written for this one
      const double curved = kBias * std::abs(1.0 / (radius + outside) - 1.0 / radius);
      outcome.cases.push_back({"carved ball of " + shortly(radius) + " voxels at " +
                                   shortly(isovalue) + ": place of the wall, off",
                               std::abs(off), kOtherPlace + curved, "voxel", Case::Sense::AtMost,
                               "from where (s' - s) / slope puts it; " + shortly(curved) +
                                   " of the bound for the other curvature"});
    }
    plot.series.push_back(std::move(series));
  }
  plot.series.push_back(std::move(predicted));
  outcome.plots.push_back(std::move(plot));
  outcome.tables.push_back(std::move(table));
  return outcome;
}

}  // namespace study::accuracy
