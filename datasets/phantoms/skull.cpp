// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/phantoms/skull.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "datasets/phantoms/noise.h"
#include "datasets/phantoms/sampling.h"
#include "datasets/phantoms/skull_shape.h"
#include "haptics/core/parallel.h"

namespace datasets {
namespace {

using skull::Vec3f;

constexpr std::int64_t kDims[3] = {188, 232, 224};
constexpr double kSkullSpacing = 0.001;  // m
constexpr std::int64_t kBrick = 8;       // voxels: the head is planned by bricks of this side
constexpr float kMargin = 3.0f;          // mm: what is further off cannot show in a voxel
constexpr float kNoise = 16.0f;          // HU, standard deviation
constexpr float kPlate = 1.3f;           // mm, thickness of the orbits' walls towards the sinuses

// HU
constexpr float kAir = -1000, kSkin = 70, kFat = -95, kMuscle = 50, kBrain = 36, kFluid = 8,
                kVitreous = 14, kCortex = 1350, kMarrow = 80, kDentine = 1750, kEnamel = 2500;

float mixed(float a, float b, float t) { return a + t * (b - a); }

/// From 0 to 1 while x goes from a to b.
float eased(float a, float b, float x) {
  const float t = std::clamp((x - a) / (b - a), 0.0f, 1.0f);
  return t * t * (3.0f - 2.0f * t);
}

/// How much of a voxel a solid fills, with the scanner's blur of 0.7 voxel.
float share(float distance) { return eased(1.1f, -1.1f, distance); }

/// Cortex outside, a sponge of trabeculae within.
float boneValue(float depth, const Vec3f& p) {
  const float compact = eased(2.6f, 1.7f, depth);
  if (compact >= 1.0f) return kCortex;
  const float cells = noise::smooth(p.x() / 1.9f, p.y() / 1.9f, p.z() / 1.9f, 31) +
                      0.5f * noise::smooth(p.x() / 4.5f, p.y() / 4.5f, p.z() / 4.5f, 32);
  return mixed(mixed(kMarrow, 820.0f, eased(-0.8f, 0.7f, cells)), kCortex, compact);
}

/// Skin, a layer of fat, muscle.
float fleshValue(float depth, const Vec3f& p) {
  if (depth > 8.0f) return kMuscle;
  const float fat_ends = 5.0f + 1.5f * noise::smooth(p.x() / 14, p.y() / 14, p.z() / 14, 33);
  const float under_skin = mixed(kFat, kMuscle, eased(fat_ends - 0.8f, fat_ends + 0.8f, depth));
  return mixed(kSkin, under_skin, eased(1.6f, 2.6f, depth));
}

/// Brain with fluid at its rim and in its furrows.
float brainValue(float depth, const Vec3f& p) {
  const float furrow = std::abs(noise::smooth(p.x() / 11, p.y() / 11, p.z() / 11, 34));
  const float reach = 2.0f + 9.0f * eased(0.09f, 0.0f, furrow);
  return mixed(kFluid, kBrain, eased(reach - 1.0f, reach + 1.0f, depth));
}

/// The head without noise, HU, at p in the head's millimetres.
float tissue(const skull::Anatomy& head, const Vec3f& p) {
  const float cavity = skull::cavityDistance(p);
  if (cavity < -6.0f) return brainValue(-cavity, p);
  const float skin =
      std::max(skull::distanceTo(head.skin, p), -skull::distanceTo(head.skin_cuts, p));
  if (skin > 1.1f) return kAir;
  const float soft = skull::distanceTo(head.fat, p);
  // no air nearer than this to an orbit: what stays between them is a plate one to two voxels thin
  const float air = std::max(skull::distanceTo(head.air, p), kPlate - soft);
  const float septa = skull::distanceTo(head.septa, p);

  float value = skin < 0.0f ? fleshValue(-skin, p) : kSkin;
  if (soft < 1.1f) {
    const float eye = share(skull::distanceTo(head.eyes, p));
    value = mixed(value, mixed(kFat + 20.0f, kVitreous, eye), share(soft));
  }
  if (cavity < 1.1f) value = mixed(value, brainValue(-cavity, p), share(cavity));

  float bone = skull::distanceTo(head.bone, p);
  if (std::abs(bone) < 3.0f && cavity > 2.0f) bone += skull::relief(p);
  bone = std::max({bone, -cavity, -soft, -air});
  bone = std::min(bone, septa);
  // air is laid down first, so that a thin wall keeps its share of the voxel
  value = mixed(value, kAir, share(std::max(air, -septa)));
  if (bone < 1.1f) value = mixed(value, boneValue(-bone, p), share(bone));
  const float tooth = skull::distanceTo(head.teeth, p);
  if (tooth < 1.1f)
    value = mixed(value, mixed(kEnamel, kDentine, eased(0.8f, 1.8f, -tooth)), share(tooth));
  return mixed(kAir, value, share(skin));
}

/// Fills the layer of bricks whose voxels begin at layer k0.
void fill(const skull::Anatomy& whole, std::int64_t k0, std::int16_t* voxels) {
  const auto placed = [](std::int64_t i, std::int64_t j, std::int64_t k) {
    const auto along = [](std::int64_t n, int axis) {
      return static_cast<float>(n) - 0.5f * static_cast<float>(kDims[axis] - 1) +
             skull::kMiddle[axis];
    };
    return Vec3f{along(i, 0), along(j, 1), along(k, 2)};
  };
  const Vec3f half = Vec3f::Constant(0.5f * static_cast<float>(kBrick - 1));
  for (std::int64_t j = 0; j < kDims[1]; j += kBrick)
    for (std::int64_t i = 0; i < kDims[0]; i += kBrick) {
      const Vec3f middle = placed(i, j, k0) + half;
      const auto kept = [&](const skull::Solid& s) {
        return skull::near(s, middle, half, kMargin);
      };
      const skull::Anatomy head{kept(whole.bone), kept(whole.teeth),    kept(whole.septa),
                                kept(whole.fat),  kept(whole.air),      kept(whole.eyes),
                                kept(whole.skin), kept(whole.skin_cuts)};
      for (std::int64_t c = k0; c < std::min(k0 + kBrick, kDims[2]); ++c)
        for (std::int64_t b = j; b < std::min(j + kBrick, kDims[1]); ++b)
          for (std::int64_t a = i; a < std::min(i + kBrick, kDims[0]); ++a) {
            const float clean = head.skin.empty() ? kAir : tissue(head, placed(a, b, c));
            const float grain = kNoise * noise::gaussian(noise::hashed(a, b, c, 41));
            voxels[(c * kDims[1] + b) * kDims[0] + a] = static_cast<std::int16_t>(
                std::floor(std::clamp(clean + grain, -1024.0f, 3071.0f) + 0.5f));
          }
    }
}

}  // namespace

haptics::Expected<Phantom> skullPhantom(const std::atomic<bool>* cancel) {
  const haptics::Grid grid = centredGrid(kDims[0], kDims[1], kDims[2], kSkullSpacing);
  auto voxels = haptics::allocateVoxels(grid.voxelCount(), haptics::ScalarType::Int16);
  if (!voxels) return tl::unexpected(voxels.error());
  auto* first = static_cast<std::int16_t*>(voxels->get());
  const skull::Anatomy head = skull::anatomy();
  haptics::inParallel((kDims[2] + kBrick - 1) / kBrick, [&](std::int64_t layer) {
    if (cancel == nullptr || !*cancel) fill(head, layer * kBrick, first);
  });
  if (cancel != nullptr && *cancel)
    return tl::unexpected(haptics::Error{haptics::Error::Kind::Cancelled, {}, "cancelled"});
  return haptics::makeVolume(grid, haptics::ScalarType::Int16, std::move(*voxels),
                             {.unit = "HU", .modality = "CT"})
      .map([](haptics::Volume&& volume) {
        return Phantom{.volume = std::move(volume), .isovalue = 300.0, .tool = "drill"};
      });
}

}  // namespace datasets
