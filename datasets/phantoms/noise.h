// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstdint>

/// Noise that is a function of place alone: the same on every machine, in any order.
namespace datasets::noise {

/// 64 well-mixed bits of a key: two rounds of multiply and fold.
constexpr std::uint64_t hashed(std::uint64_t key) {
  key = (key ^ (key >> 31)) * 0xd6e8feb86659fd93u;
  key = (key ^ (key >> 32)) * 0xa0761d6478bd642fu;
  return key ^ (key >> 29);
}

constexpr std::uint64_t hashed(std::int64_t i, std::int64_t j, std::int64_t k, std::uint64_t seed) {
  return hashed(static_cast<std::uint64_t>(i) * 0x9e3779b97f4a7c15u +
                static_cast<std::uint64_t>(j) * 0xc2b2ae3d27d4eb4fu +
                static_cast<std::uint64_t>(k) * 0x165667b19e3779f9u + seed);
}

/// In [0, 1), from the upper bits.
constexpr float uniform(std::uint64_t bits) { return static_cast<float>(bits >> 40) * 0x1p-24f; }

/// Mean 0, deviation 1, bounded by 3.5: four uniform quarters of the bits, added.
constexpr float gaussian(std::uint64_t bits) {
  const auto quarter = [bits](int shift) { return static_cast<int>((bits >> shift) & 0xffff); };
  const int sum = quarter(0) + quarter(16) + quarter(32) + quarter(48) - 2 * 65535;
  return static_cast<float>(sum) * (1.7320508f / 65536.0f);
}

/// Smooth in space, in [-1, 1], with features of about one unit.
inline float smooth(float x, float y, float z, std::uint64_t seed) {
  const float fx = std::floor(x), fy = std::floor(y), fz = std::floor(z);
  const auto eased = [](float t) { return t * t * (3.0f - 2.0f * t); };
  const float u = eased(x - fx), v = eased(y - fy), w = eased(z - fz);
  const auto i = static_cast<std::int64_t>(fx), j = static_cast<std::int64_t>(fy),
             k = static_cast<std::int64_t>(fz);
  const auto at = [&](int a, int b, int c) { return uniform(hashed(i + a, j + b, k + c, seed)); };
  const auto mixed = [](float a, float b, float t) { return a + t * (b - a); };
  const float low =
      mixed(mixed(at(0, 0, 0), at(1, 0, 0), u), mixed(at(0, 1, 0), at(1, 1, 0), u), v);
  const float high =
      mixed(mixed(at(0, 0, 1), at(1, 0, 1), u), mixed(at(0, 1, 1), at(1, 1, 1), u), v);
  return 2.0f * mixed(low, high, w) - 1.0f;
}

}  // namespace datasets::noise
