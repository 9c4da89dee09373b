// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/field/spline_lanes.h"

#include <bit>
#include <cstdint>
#include <type_traits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "haptics/field/spline_lanes.cpp"
#include <hwy/foreach_target.h>  // compiles this file once for every target
#include <hwy/highway.h>

#include "haptics/field/lanes_inl.h"

HWY_BEFORE_NAMESPACE();
namespace haptics::lanes::spline::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using namespace haptics::lanes::HWY_NAMESPACE;  // of this target

using D4 = hn::CappedTag<double, 4>;
using V4 = hn::Vec<D4>;
constexpr std::size_t kPart = hn::MaxLanes(D4{}), kParts = 4 / kPart;

/// Four numbers, one for each tap along i, in as many vectors as that takes.
struct Four {
  V4 part[kParts];
};

/// Four voxels as doubles, exactly.
template <class T>
HWY_INLINE Four rowAt(const T* voxels) {
  const D4 d;
  Four row;
  for (std::size_t p = 0; p < kParts; ++p) {
    const auto some = hn::LoadU(hn::Rebind<T, D4>{}, voxels + p * kPart);
    if constexpr (sizeof(T) < 4) {
      row.part[p] = hn::PromoteTo(d, hn::PromoteTo(hn::Rebind<std::int32_t, D4>{}, some));
    } else if constexpr (std::is_same_v<T, std::uint32_t>) {
      // as the low bits of 2^52
      const hn::RebindToUnsigned<D4> du;
      const auto bits = hn::Or(hn::PromoteTo(du, some), hn::Set(du, 0x4330000000000000ULL));
      row.part[p] = hn::Sub(hn::BitCast(d, bits), hn::Set(d, 4503599627370496.0));
    } else {
      row.part[p] = hn::PromoteTo(d, some);
    }
  }
  return row;
}

/// The weights of one axis for a row, a plane or all of them, the same for each tap along i.
struct Weights {
  V4 w[4];
};
HWY_INLINE Weights broadcast(const double (*w)[kLanes], int lane) {
  const D4 d;
  return {{hn::Set(d, w[0][lane]), hn::Set(d, w[1][lane]), hn::Set(d, w[2][lane]),
           hn::Set(d, w[3][lane])}};
}

/// In this order: ((a + b) + c) + d.
HWY_INLINE Four weighted(const Weights& w, const Four* of) {
  Four sum;
  for (std::size_t p = 0; p < kParts; ++p)
    sum.part[p] = hn::Add(hn::Add(hn::Add(hn::Mul(w.w[0], of[0].part[p]),  //
                                          hn::Mul(w.w[1], of[1].part[p])),
                                  hn::Mul(w.w[2], of[2].part[p])),
                          hn::Mul(w.w[3], of[3].part[p]));
  return sum;
}
HWY_INLINE V weighted(const V* w, const V* of) {
  return hn::Add(hn::Add(hn::Add(hn::Mul(w[0], of[0]), hn::Mul(w[1], of[1])), hn::Mul(w[2], of[2])),
                 hn::Mul(w[3], of[3]));
}

/// As weights() and slopes() of SplineCell.
HWY_INLINE void weightsAt(V x, V* w) {
  const D d;
  const V one = hn::Set(d, 1.0), half = hn::Set(d, 0.5);
  const V sixth = hn::Set(d, 1.0 / 6.0), two_thirds = hn::Set(d, 4.0 / 6.0);
  const V y = hn::Sub(one, x), xx = hn::Mul(x, x), yy = hn::Mul(y, y);
  w[0] = hn::Mul(hn::Mul(yy, y), sixth);
  w[1] = hn::Sub(two_thirds, hn::Mul(xx, hn::Sub(one, hn::Mul(half, x))));
  w[2] = hn::Sub(two_thirds, hn::Mul(yy, hn::Sub(one, hn::Mul(half, y))));
  w[3] = hn::Mul(hn::Mul(xx, x), sixth);
}
HWY_INLINE void slopesAt(V x, V* w) {
  const D d;
  const V one = hn::Set(d, 1.0), half = hn::Set(d, 0.5), two = hn::Set(d, 2.0),
          three_halves = hn::Set(d, 1.5);
  const V y = hn::Sub(one, x);
  w[0] = hn::Neg(hn::Mul(half, hn::Mul(y, y)));
  w[1] = hn::Mul(x, hn::Sub(hn::Mul(three_halves, x), two));
  w[2] = hn::Mul(y, hn::Sub(two, hn::Mul(three_halves, y)));
  w[3] = hn::Mul(half, hn::Mul(x, x));
}

/// Weights of each axis and tap, for each lane.
struct Taps {
  alignas(64) double w[3][4][kLanes];

  HWY_INLINE void put(int axis, int l, const V* from) {
    for (int tap = 0; tap < 4; ++tap) hn::Store(from[tap], D{}, w[axis][tap] + l);
  }
  HWY_INLINE void along(int axis, int l, V* to) const {
    for (int tap = 0; tap < 4; ++tap) to[tap] = hn::Load(D{}, w[axis][tap] + l);
  }
};

/// Four numbers of each lane, on their way from the lanes one by one to the lanes together.
struct Fours {
  alignas(64) double of[kLanes][4];

  HWY_INLINE void put(int lane, const Four& four) {
    for (std::size_t p = 0; p < kParts; ++p) hn::StoreU(four.part[p], D4{}, of[lane] + p * kPart);
  }
  HWY_INLINE void take(int l, V* four) const {
    hn::LoadInterleaved4(D{}, of[l], four[0], four[1], four[2], four[3]);
  }
};

/// The voxels about the cells of each lane.
template <class T>
struct Voxels {
  std::int64_t row, slice;
  const T* first;
  alignas(64) std::int64_t at[kLanes];

  explicit Voxels(const Lattice& lattice)
      : row{static_cast<std::int64_t>(lattice.dims[0])},
        slice{static_cast<std::int64_t>(lattice.dims[0] * lattice.dims[1])},
        first{static_cast<const T*>(lattice.voxels)} {}
  HWY_INLINE void put(int l, V i, V j, V k) {
    const D d;
    const V one = hn::Set(d, 1.0);
    const V place =
        hn::Add(hn::Add(hn::Sub(i, one), hn::Mul(hn::Sub(j, one), hn::Set(d, double(row)))),
                hn::Mul(hn::Sub(k, one), hn::Set(d, double(slice))));
    hn::Store(integer(place), DI{}, at + l);
  }
  /// Of the lane's 4^3 voxels the first.
  const T* corner(int lane) const { return first + at[lane]; }
  /// The rows of a plane of four.
  HWY_INLINE void plane(const T* corner, Four* rows) const {
    for (int j = 0; j < 4; ++j) rows[j] = rowAt(corner + j * row);
  }
  /// All but the weights along i.
  HWY_INLINE Four summed(const T* corner, const Weights& y, const Weights& z) const {
    Four planes[4];
    for (int k = 0; k < 4; ++k) {
      Four rows[4];
      plane(corner + k * slice, rows);
      planes[k] = weighted(y, rows);
    }
    return weighted(z, planes);
  }
};

HWY_INLINE std::uint32_t firstOf(int n) { return (1U << n) - 1U; }

template <class T>
HWY_INLINE void surveyOf(const Lattice& lattice, const Places& u, int n, double ceiling,
                         Survey& found) {
  const D d;
  const int width = static_cast<int>(hn::Lanes(d));
  Voxels<T> voxels{lattice};
  Taps taps;
  found.edge = found.empty = 0;
  for (int l = 0; l < n; l += width) {
    const V p[3] = {hn::Load(d, u.x.lane + l), hn::Load(d, u.y.lane + l),
                    hn::Load(d, u.z.lane + l)};
    V at[3] = {hn::Floor(p[0]), hn::Floor(p[1]), hn::Floor(p[2])};
    const M interior = within(lattice, at[0], at[1], at[2], 1.0);
    for (int axis = 0; axis < 3; ++axis) {
      at[axis] = hn::IfThenElseZero(interior, at[axis]);
      V w[4];
      weightsAt(hn::Sub(p[axis], at[axis]), w);
      taps.put(axis, l, w);
    }
    voxels.put(l, at[0], at[1], at[2]);
    V greatest, lipschitz;
    boundsAt(lattice, at[0], at[1], at[2], greatest, lipschitz);
    hn::Store(lipschitz, d, found.lipschitz.lane + l);
    found.edge |= bitsOf(hn::Not(interior)) << l;
    found.empty |= bitsOf(hn::And(hn::Lt(greatest, hn::Set(d, ceiling)), interior)) << l;
  }

  Fours sums;
  for (std::uint32_t left = firstOf(n) & ~(found.edge | found.empty); left != 0; left &= left - 1) {
    const int lane = std::countr_zero(left);
    sums.put(lane, voxels.summed(voxels.corner(lane), broadcast(taps.w[1], lane),
                                 broadcast(taps.w[2], lane)));
  }

  const V radius = hn::Set(d, lattice.finest_radius);
  for (int l = 0; l < n; l += width) {
    V x[4], sum[4];
    taps.along(0, l, x);
    sums.take(l, sum);
    const V value = weighted(x, sum);
    V lipschitz = hn::Load(d, found.lipschitz.lane + l);
    const V free = freeAround(value, ceiling, radius, lipschitz);
    hn::Store(value, d, found.value.lane + l);
    hn::Store(lipschitz, d, found.lipschitz.lane + l);
    hn::Store(free, d, found.free.lane + l);
  }
}

/// The segments in which F may reach its level.
template <class T>
HWY_INLINE M reached(const Lattice& lattice, const Segments& s) {
  const D d;
  Voxels<T> voxels{lattice};
  voxels.put(0, s.i, s.j, s.k);
  Taps begin, end;
  V way[3];
  for (int axis = 0; axis < 3; ++axis) {
    V w[4];
    weightsAt(s.begin[axis], w);
    begin.put(axis, 0, w);
    weightsAt(s.end[axis], w);
    end.put(axis, 0, w);
    way[axis] = hn::Abs(hn::Sub(s.end[axis], s.begin[axis]));
  }
  Fours at_begin, at_end, least, greatest;
  for (std::uint32_t left = bitsOf(s.looked); left != 0; left &= left - 1) {
    const int lane = std::countr_zero(left);
    const Weights y[2] = {broadcast(begin.w[1], lane), broadcast(end.w[1], lane)};
    const T* const corner = voxels.corner(lane);
    Four planes[2][4], low, high;
    for (int k = 0; k < 4; ++k) {
      Four rows[4];
      voxels.plane(corner + k * voxels.slice, rows);
      if (k == 0) low = high = rows[0];
      for (std::size_t p = 0; p < kParts; ++p)
        for (const Four& row : rows) {
          low.part[p] = hn::Min(low.part[p], row.part[p]);
          high.part[p] = hn::Max(high.part[p], row.part[p]);
        }
      planes[0][k] = weighted(y[0], rows);
      planes[1][k] = weighted(y[1], rows);
    }
    at_begin.put(lane, weighted(broadcast(begin.w[2], lane), planes[0]));
    at_end.put(lane, weighted(broadcast(end.w[2], lane), planes[1]));
    least.put(lane, low);
    greatest.put(lane, high);
  }
  V x[4], sum[4];
  begin.along(0, 0, x);
  at_begin.take(0, sum);
  const V first = weighted(x, sum);
  end.along(0, 0, x);
  at_end.take(0, sum);
  const V last = weighted(x, sum);
  least.take(0, sum);
  const V low = hn::Min(hn::Min(sum[0], sum[1]), hn::Min(sum[2], sum[3]));
  greatest.take(0, sum);
  const V high = hn::Max(hn::Max(sum[0], sum[1]), hn::Max(sum[2], sum[3]));
  // What F can bend up between the ends: an eighth of the greatest |d²F/dt²|, which is at most
  //   R (2 (dx² + dy² + dz²) + 9/4 (|dx dy| + |dy dz| + |dz dx|)),  R the range of the 64 voxels.
  // On one axis it is a mean of a - 2 b + c, at most 2 R. A mixed one is a sum of voxels with
  // weights that add up to 0, the positive ones to at most 9/8: on each of two axes the sizes of
  // the cubics' slopes add up to at most 3/2, on the third the weights to 1.
  const V squares =
      hn::Add(hn::Add(hn::Mul(way[0], way[0]), hn::Mul(way[1], way[1])), hn::Mul(way[2], way[2]));
  const V mixed =
      hn::Add(hn::Add(hn::Mul(way[0], way[1]), hn::Mul(way[1], way[2])), hn::Mul(way[2], way[0]));
  const V bend =
      hn::Add(hn::Mul(hn::Set(d, 2.0 / 8.0), squares), hn::Mul(hn::Set(d, 2.25 / 8.0), mixed));
  const V most = hn::Add(hn::Max(first, last), hn::Mul(bend, hn::Sub(high, low)));
  return hn::And(hn::Ge(most, s.level), hn::Ge(high, s.level));
}

template <class T>
HWY_INLINE void clearOf(const Lattice& lattice, const Chords& chords, int n, Numbers& until,
                        std::int64_t& cells) {
  walk(lattice, chords, n, 1.0, until, cells,
       [&](const Segments& s) HWY_ATTR { return reached<T>(lattice, s); });
}

template <class T>
HWY_INLINE void slopesOf(const Lattice& lattice, const Places& u, int n, bool central,
                         Slopes& found) {
  const D d;
  const int width = static_cast<int>(hn::Lanes(d));
  Voxels<T> voxels{lattice};
  Taps taps, slopes;
  found.edge = 0;
  for (int l = 0; l < n; l += width) {
    const V p[3] = {hn::Load(d, u.x.lane + l), hn::Load(d, u.y.lane + l),
                    hn::Load(d, u.z.lane + l)};
    V at[3] = {hn::Floor(p[0]), hn::Floor(p[1]), hn::Floor(p[2])};
    const M inner = within(lattice, at[0], at[1], at[2], central ? 2.0 : 1.0);
    for (int axis = 0; axis < 3; ++axis) {
      at[axis] = hn::IfThenElseZero(inner, at[axis]);
      const V x = hn::Sub(p[axis], at[axis]);
      V w[4];
      weightsAt(x, w);
      taps.put(axis, l, w);
      slopesAt(x, w);
      slopes.put(axis, l, w);
    }
    voxels.put(l, at[0], at[1], at[2]);
    found.edge |= bitsOf(hn::Not(inner)) << l;
  }

  Fours sums, slopes_y, slopes_z, sides[3][2];
  for (std::uint32_t left = firstOf(n) & ~found.edge; left != 0; left &= left - 1) {
    const int lane = std::countr_zero(left);
    const T* const corner = voxels.corner(lane);
    const Weights y = broadcast(taps.w[1], lane), z = broadcast(taps.w[2], lane);
    const Weights dy = broadcast(slopes.w[1], lane), dz = broadcast(slopes.w[2], lane);
    Four planes[4], planes_y[4];
    for (int k = 0; k < 4; ++k) {
      Four rows[4];
      voxels.plane(corner + k * voxels.slice, rows);
      planes[k] = weighted(y, rows);
      planes_y[k] = weighted(dy, rows);
    }
    sums.put(lane, weighted(z, planes));
    slopes_y.put(lane, weighted(z, planes_y));
    slopes_z.put(lane, weighted(dz, planes));
    if (!central) continue;
    // the same weights, of the voxels beside
    const std::int64_t step[3] = {1, voxels.row, voxels.slice};
    for (int axis = 0; axis < 3; ++axis) {
      sides[axis][0].put(lane, voxels.summed(corner - step[axis], y, z));
      sides[axis][1].put(lane, voxels.summed(corner + step[axis], y, z));
    }
  }

  double* const out[3] = {found.central.x.lane, found.central.y.lane, found.central.z.lane};
  for (int l = 0; l < n; l += width) {
    V x[4], dx[4], sum[4];
    taps.along(0, l, x);
    slopes.along(0, l, dx);
    sums.take(l, sum);
    hn::Store(weighted(x, sum), d, found.value.lane + l);
    hn::Store(weighted(dx, sum), d, found.exact.x.lane + l);
    slopes_y.take(l, sum);
    hn::Store(weighted(x, sum), d, found.exact.y.lane + l);
    slopes_z.take(l, sum);
    hn::Store(weighted(x, sum), d, found.exact.z.lane + l);
    if (!central) continue;
    for (int axis = 0; axis < 3; ++axis) {
      V side[2];
      for (int s = 0; s < 2; ++s) {
        sides[axis][s].take(l, sum);
        side[s] = weighted(x, sum);
      }
      hn::Store(hn::Mul(hn::Set(d, 0.5), hn::Sub(side[1], side[0])), d, out[axis] + l);
    }
  }
}

void SurveyAll(const Lattice& lattice, const Places& u, int n, double ceiling, Survey& found) {
#define CALL(T) surveyOf<T>(lattice, u, n, ceiling, found)
  HAPTICS_LANES_BY_TYPE(lattice.type, CALL)
#undef CALL
}
void ClearAll(const Lattice& lattice, const Chords& chords, int n, Numbers& until,
              std::int64_t& cells) {
#define CALL(T) clearOf<T>(lattice, chords, n, until, cells)
  HAPTICS_LANES_BY_TYPE(lattice.type, CALL)
#undef CALL
}
void SlopesAll(const Lattice& lattice, const Places& u, int n, bool central, Slopes& found) {
#define CALL(T) slopesOf<T>(lattice, u, n, central, found)
  HAPTICS_LANES_BY_TYPE(lattice.type, CALL)
#undef CALL
}

}  // namespace haptics::lanes::spline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace haptics::lanes::spline {

HWY_EXPORT(SurveyAll);
HWY_EXPORT(ClearAll);
HWY_EXPORT(SlopesAll);

void survey(const Lattice& lattice, const Places& u, int n, double ceiling,
            Survey& found) HAPTICS_RT {
  HWY_DYNAMIC_DISPATCH(SurveyAll)(lattice, u, n, ceiling, found);
}
void clear(const Lattice& lattice, const Chords& chords, int n, Numbers& until,
           std::int64_t& cells) HAPTICS_RT {
  HWY_DYNAMIC_DISPATCH(ClearAll)(lattice, chords, n, until, cells);
}
void slopes(const Lattice& lattice, const Places& u, int n, bool central,
            Slopes& found) HAPTICS_RT {
  HWY_DYNAMIC_DISPATCH(SlopesAll)(lattice, u, n, central, found);
}

}  // namespace haptics::lanes::spline
#endif  // HWY_ONCE
