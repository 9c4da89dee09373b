// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/study/accuracy/carving.h"
#include "app/study/comparison/measures.h"
#include "app/study/comparison/scenes.h"
#include "app/study/reference/evaluator.h"
#include "datasets/phantoms/making.h"
#include "haptics/servo/servo_tick.h"
#include "haptics/servo/step.h"

namespace study::accuracy {
namespace {

using haptics::ScalarType;
using haptics::Vec3;

constexpr double kPressedVoxel = 0.4e-3, kBurrRadius = 2e-3, kPressedSurface = 6e-3;  // m
constexpr double kSpeed = 6283.0, kShare = 0.3, kEnergy = 1e9;  // rad/s, 1, J/m3
constexpr double kTaken = 10e-9;                                // m3: of each press
constexpr double kPressStiffness = 5000.0;                      // N/m
constexpr double kMostOff = 2.0;                                // per cent
constexpr double kMostOffByDepth = 3.5;                         // per cent
constexpr std::int64_t kTopSlice = 40;                          // slice at the surface

double isovalueOf(ScalarType type) { return type == ScalarType::UInt8 ? 110.0 : 88.0; }

/// A half-space below kPressedSurface, whose values ramp over three voxels.
haptics::Volume halfSpace(ScalarType type) {
  haptics::Grid grid;
  grid.dims = {40, 40, 50};
  grid.spacing = Vec3::Constant(kPressedVoxel);
  grid.origin = Vec3{-19.5 * kPressedVoxel, -19.5 * kPressedVoxel,
                     kPressedSurface - double(kTopSlice) * kPressedVoxel};
  const bool bytes = type == ScalarType::UInt8;
  const double least = bytes ? 0.0 : -1024.0, solid = bytes ? 220.0 : 1200.0;
  return datasets::filled(grid, type, [&](auto, auto, std::int64_t k) {
    const double above = double(k - kTopSlice) / 3.0 + 0.5;
    return solid + (least - solid) * std::clamp(above, 0.0, 1.0);
  });
}

struct Pressed {
  double volume = 0.0;       ///< m3 removed
  double depth = 0.0;        ///< m: of the hole, by the evaluator
  double radius = 0.0;       ///< m: of the ball that was cut
  std::vector<double> cost;  ///< us of CPU: of each tick
};

/// Presses the burr by a device that stays as far before the proxy as the force wants.
Pressed press(const haptics::CutLaw& law, ScalarType type, double force, int hz, double seconds) {
  const double s = isovalueOf(type), period = 1.0 / hz;
  const auto scene = haptics::makeScene(std::make_shared<const haptics::Volume>(halfSpace(type)),
                                        comparison::toolOf(datasets::ballPoints(600, kBurrRadius)))
                         .value();
  haptics::Cutting cutting{haptics::CarvedScene::of(*scene).value(), law};
  haptics::Pose X_WD = datasets::at(0.0, 0.0, kPressedSurface + kBurrRadius + 0.2e-3);
  haptics::Proxy proxy{*cutting.scene(), X_WD};
  haptics::Safety safety{{}};
  haptics::Settings settings;
  settings.isovalue = s;
  settings.stiffness = kPressStiffness;
  Pressed pressed;
  Vec3 last_W = Vec3::Zero();
  for (int n = 0; n < int(std::lround(seconds * hz)); ++n) {
    X_WD.translation() = proxy.X_WP.translation() - force / kPressStiffness * Vec3::UnitZ();
    haptics::Budget budget = haptics::Budget::counted(haptics::kTickWork);
    const std::int64_t begun = haptics::Budget::threadTime();
    haptics::servoTick({X_WD, settings, haptics::StepFlags::kArmed | haptics::StepFlags::kCut,
                        nullptr, nullptr, nullptr, &cutting},
                       cutting.scene().get(), &proxy, safety, period, budget);
    pressed.cost.push_back(1e-3 * double(haptics::Budget::threadTime() - begun));
    if (cutting.begun()) last_W = cutting.begun()->to_W;
  }
  pressed.volume = cutting.removed().volume;
  pressed.radius = kBurrRadius + cutting.scene()->lengths.epsilon;
  // under the last cut, between what is free and what is not
  const haptics::Volume& left = *cutting.scene()->volume;
  const auto isFree = [&](double z) {
    return evaluator::fieldAt(left, {last_W.x(), last_W.y(), z}) < s;
  };
  double full = kPressedSurface;
  while (isFree(full) && full > -kPressedSurface) full -= 0.05 * kPressedVoxel;
  double free = full + 0.05 * kPressedVoxel;
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (free + full);
    (isFree(middle) ? free : full) = middle;
  }
  pressed.depth = kPressedSurface - full;
  return pressed;
}

}  // namespace

haptics::CutLaw pressedLaw() {
  haptics::CutLaw law;
  law.burr = {Vec3::Zero(), kBurrRadius};
  law.speed = kSpeed;
  law.share = kShare;
  law.material.bands[0].energy = kEnergy;
  return law;
}

Outcome carvingRates(const haptics::CutLaw& law, const RateEffort& effort) {
  Outcome outcome;
  Plot plot{"Rate of removal",
            "Volume removed in a second by a burr that is pressed into a half-space, against the "
            "force, and what the law gives.",
            {"force [N]", Scale::Log},
            {"rate [mm3/s]", Scale::Log}};
  Table table{"Rate of removal against the law",
              {"voxels", "rate [Hz]", "force [N]", "the law's [mm3]", "removed [mm3]", "off [%]",
               "hole, by its depth [mm3]", "off [%]", "CPU of a tick [us], median", "99 %"},
              {}};
  for (const ScalarType type : {ScalarType::Int16, ScalarType::UInt8, ScalarType::Float32})
    for (const int hz : effort.rates) {
      Series series{std::string{haptics::nameOf(type)} + ", " + shortly(hz) + " Hz", {}};
      for (const double force : effort.forces) {
        const double law_rate = kShare * force * kSpeed * kBurrRadius / kEnergy;
        // whole ticks, also of the slowest rate
        const double seconds = std::round(kTaken / law_rate * 500.0) / 500.0;
        Pressed pressed = press(law, type, force, hz, seconds);
        const double expected = law_rate * seconds, depth = pressed.depth;
        const double cap = std::numbers::pi * depth * depth * (3.0 * pressed.radius - depth) / 3.0;
        const double off = 100.0 * (pressed.volume / expected - 1.0),
                     off_by_depth = 100.0 * (cap / expected - 1.0);
        series.points.push_back({force, 1e9 * pressed.volume / seconds});
        std::ranges::sort(pressed.cost);
        table.rows.push_back({haptics::nameOf(type), shortly(hz), shortly(force),
                              shortly(1e9 * expected), shortly(1e9 * pressed.volume), shortly(off),
                              shortly(1e9 * cap), shortly(off_by_depth),
                              shortly(comparison::quantile(pressed.cost, 0.5)),
                              shortly(comparison::quantile(pressed.cost, 0.99))});
        const std::string what = "burr pressed with " + shortly(force) + " N into " +
                                 haptics::nameOf(type) + " at " + shortly(hz) + " Hz: ";
        outcome.cases.push_back({what + "volume removed, off the law", std::abs(off), kMostOff, "%",
                                 Case::Sense::AtMost,
                                 shortly(1e9 * expected) + " mm3 by the law, with the force of the "
                                                           "device"});
        outcome.cases.push_back({what + "volume of the hole, off the law", std::abs(off_by_depth),
                                 kMostOffByDepth, "%", Case::Sense::AtMost,
                                 "by the depth of the hole, as the evaluator finds it; 1.5 of it "
                                 "for 0.03 voxel of depth"});
      }
      plot.series.push_back(std::move(series));
    }
  Series line{"the law", {}, true, false};
  for (const double force : effort.forces)
    line.points.push_back({force, 1e9 * kShare * force * kSpeed * kBurrRadius / kEnergy});
  plot.series.insert(plot.series.begin(), std::move(line));
  outcome.plots.push_back(std::move(plot));
  outcome.tables.push_back(std::move(table));
  return outcome;
}

}  // namespace study::accuracy
