// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/phantoms/analytic.h"

#include "datasets/phantoms/sampling.h"
#include "datasets/phantoms/shapes.h"

namespace datasets {
namespace {

constexpr double kSpacing = 0.001;       // m
constexpr double kHoleSpacing = 0.0003;  // m

/// uint8 has 256 steps: three voxels either side of the middle, 42 apart.
constexpr Ramp kByteRamp{.isovalue = 128.0, .slope = 42.0, .reach = 3.0};

template <class T, class Shape>
haptics::Expected<Phantom> phantomOf(const Shape& shape, const haptics::Grid& grid,
                                     const Ramp& ramp, const char* tool,
                                     const std::atomic<bool>* cancel,
                                     haptics::VolumeFacts facts = {}) {
  return sampled<T>(
             grid, ramp, [&](const haptics::Vec3& p_W) { return shape.distance(p_W); },
             std::move(facts), cancel)
      .map([&](haptics::Volume&& volume) {
        return Phantom{.volume = std::move(volume), .isovalue = ramp.isovalue, .tool = tool};
      });
}

template <class Shape>
haptics::Expected<Phantom> cube(const Shape& shape, std::int64_t side, const char* tool,
                                const std::atomic<bool>* cancel) {
  return phantomOf<std::int16_t>(shape, centredGrid(side, side, side, kSpacing), Ramp{}, tool,
                                 cancel);
}

}  // namespace

haptics::Expected<Phantom> spherePhantom(const std::atomic<bool>* cancel) {
  return cube(shapes::Sphere{}, 64, "probe", cancel);
}
haptics::Expected<Phantom> halfSpacePhantom(const std::atomic<bool>* cancel) {
  return cube(shapes::HalfSpace{}, 64, "probe", cancel);
}
haptics::Expected<Phantom> gyroidPhantom(const std::atomic<bool>* cancel) {
  return cube(shapes::Gyroid{}, 96, "sphere", cancel);
}
haptics::Expected<Phantom> cylinderPhantom(const std::atomic<bool>* cancel) {
  return cube(shapes::Cylinder{}, 64, "sphere", cancel);
}
haptics::Expected<Phantom> wedgePhantom(const std::atomic<bool>* cancel) {
  return cube(shapes::Wedge{}, 65, "sphere", cancel);
}
haptics::Expected<Phantom> slotPhantom(const std::atomic<bool>* cancel) {
  return cube(shapes::Slot{}, 65, "sphere", cancel);
}

haptics::Expected<Phantom> torusPhantom(const std::atomic<bool>* cancel) {
  return phantomOf<std::int16_t>(shapes::Torus{}, centredGrid(72, 72, 40, kSpacing), Ramp{}, "cane",
                                 cancel);
}

haptics::Expected<Phantom> holePhantom(const std::atomic<bool>* cancel) {
  return phantomOf<std::uint8_t>(shapes::Hole{}, centredGrid(256, 256, 256, kHoleSpacing),
                                 kByteRamp, "peg", cancel);
}

haptics::Expected<Phantom> markerPhantom(const std::atomic<bool>* cancel) {
  return phantomOf<std::int16_t>(shapes::Marker{}, centredGrid(65, 65, 65, kSpacing), Ramp{},
                                 "probe", cancel, {.modality = "CT"});
}

}  // namespace datasets
