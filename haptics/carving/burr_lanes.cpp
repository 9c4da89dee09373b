// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/carving/burr_lanes.h"

#include <cstdint>
#include <cstring>
#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "haptics/carving/burr_lanes.cpp"
#include <hwy/foreach_target.h>  // compiles this file once for every target
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace haptics::lanes::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// A bit for each lane.
template <class D, class M>
HWY_INLINE std::uint64_t bitsOf(D d, M mask) {
  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(d, mask, bits);
  std::uint64_t all;
  std::memcpy(&all, bits, sizeof(all));
  return all;
}

template <class Real>
void Lower(const BallAtRow<Real>& ball, int count, RowOfVoxels<Real>& row) {
  const hn::CappedTag<Real, kRowChunk> d;
  using V = hn::Vec<decltype(d)>;
  const auto all = [&](Real value) { return hn::Set(d, value); };
  const auto sum = [](V a, V b, V c) { return hn::Add(hn::Add(a, b), c); };
  const auto square = [&](V a, V b, V c) {
    return sum(hn::Mul(a, a), hn::Mul(b, b), hn::Mul(c, c));
  };
  const V zero = hn::Zero(d), one = all(1), tiny = all(std::numeric_limits<Real>::min());
  const V y = all(ball.y), z = all(ball.z);
  const V sx = all(ball.spacing[0]), sy = all(ball.spacing[1]), sz = all(ball.spacing[2]);
  const V wx = all(ball.way[0]), wy = all(ball.way[1]), wz = all(ball.way[2]);
  const V of_y = hn::Mul(y, wy), of_z = hn::Mul(z, wz), per_way = all(ball.per_way);
  const V per_voxel = all(Real{1} / ball.spacing[0]);
  const V offset = all(ball.bias * ball.spacing[0]);
  const V background = all(ball.background);
  const V s = all(ball.isovalue), per_value = all(ball.per_value), at_wall = all(ball.at_wall);
  const V straight = all(ball.part_straight), rounded = all(ball.part_rounded);
  const V half = all(Real(0.5)), per_rounded = all(Real(0.5) / ball.part_rounded);
  const auto partOf = [&](V value) {
    const V beyond = hn::Add(at_wall, hn::Mul(hn::Sub(value, s), per_value));
    const V size = hn::Abs(beyond);
    const V round = hn::Min(hn::Max(hn::Sub(size, straight), zero), rounded);
    const V part = hn::Sub(hn::Add(hn::Min(size, straight), round),
                           hn::Mul(hn::Mul(round, round), per_rounded));
    return hn::Add(half, hn::CopySign(part, beyond));
  };
  row.changed = 0;
  row.parts = 0;
  for (int n = 0; n < count; n += static_cast<int>(hn::Lanes(d))) {
    const V before = hn::Load(d, row.before + n);
    hn::Store(before, d, row.after + n);
    if (hn::AllTrue(d, hn::Le(before, background))) continue;
    const V x = hn::Add(all(ball.x), hn::Mul(hn::Iota(d, static_cast<Real>(n)), sx));
    const V t = hn::Min(hn::Max(hn::Mul(sum(hn::Mul(x, wx), of_y, of_z), per_way), zero), one);
    const V dx = hn::Sub(x, hn::Mul(t, wx)), dy = hn::Sub(y, hn::Mul(t, wy)),
            dz = hn::Sub(z, hn::Mul(t, wz));
    const V squared = hn::Max(square(dx, dy, dz), tiny);
    const V beyond = hn::Sub(hn::Sqrt(squared), all(ball.radius));
    V distance;
    if (ball.cubes) {
      distance = hn::Sub(hn::Mul(beyond, per_voxel), offset);
    } else {
      // the length of a voxel along the normal
      const V part = hn::Div(square(hn::Mul(dx, sx), hn::Mul(dy, sy), hn::Mul(dz, sz)), squared);
      const V side = hn::Max(hn::Sqrt(part), tiny);
      distance = hn::Sub(hn::Div(beyond, side), hn::Mul(all(ball.bias), side));
    }
    const V steep = hn::Mul(all(ball.rise), hn::Max(zero, hn::Sub(distance, all(ball.straight))));
    const V line = sum(s, hn::Mul(all(ball.slope), distance), steep);
    V most =
        hn::IfThenElse(hn::Lt(distance, all(ball.back)), background, hn::Max(background, line));
    if (ball.whole) most = hn::Floor(hn::Add(most, all(Real(0.5))));
    const auto lower = hn::Lt(most, before);
    const auto count_here = static_cast<int>(hn::CountTrue(d, lower));
    if (count_here == 0) continue;
    row.changed += count_here;
    const V after = hn::IfThenElse(lower, most, before);
    hn::Store(after, d, row.after + n);
    const V part = hn::Sub(partOf(before), partOf(after));
    hn::Store(part, d, row.part + n);
    row.parts |= bitsOf(d, hn::Gt(part, zero)) << n;
  }
}

void LowerFloat(const BallAtRow<float>& ball, int count, RowOfVoxels<float>& row) {
  Lower(ball, count, row);
}
void LowerDouble(const BallAtRow<double>& ball, int count, RowOfVoxels<double>& row) {
  Lower(ball, count, row);
}

}  // namespace haptics::lanes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace haptics::lanes {

HWY_EXPORT(LowerFloat);
HWY_EXPORT(LowerDouble);

void lower(const BallAtRow<float>& ball, int count, RowOfVoxels<float>& row) HAPTICS_RT {
  HWY_DYNAMIC_DISPATCH(LowerFloat)(ball, count, row);
}
void lower(const BallAtRow<double>& ball, int count, RowOfVoxels<double>& row) HAPTICS_RT {
  HWY_DYNAMIC_DISPATCH(LowerDouble)(ball, count, row);
}

}  // namespace haptics::lanes
#endif  // HWY_ONCE
