// SPDX-License-Identifier: BSD-3-Clause

// What the lanes of both fields share, compiled once for every kind of vector: to be included by a
// file that hwy/foreach_target.h compiles again and again.

#if defined(HAPTICS_FIELD_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef HAPTICS_FIELD_LANES_INL_H
#undef HAPTICS_FIELD_LANES_INL_H
#else
#define HAPTICS_FIELD_LANES_INL_H
#endif

#include <hwy/highway.h>

#include "haptics/field/lanes.h"

HWY_BEFORE_NAMESPACE();
namespace haptics::lanes::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using D = hn::CappedTag<double, 8>;
using DI = hn::RebindToSigned<D>;
using DU = hn::RebindToUnsigned<D>;
using V = hn::Vec<D>;
using VU = hn::Vec<DU>;
using M = hn::Mask<D>;

/// An unsigned integer below 2^52 as a double: as the low bits of 2^52.
HWY_INLINE V exact(VU bits, double offset) {
  const D d;
  const DU du;
  const VU exponent = hn::Set(du, 0x4330000000000000ULL);
  return hn::Sub(hn::BitCast(d, hn::Or(bits, exponent)), hn::Set(d, 4503599627370496.0 + offset));
}
/// An integer below 2^51 that a double holds, as an integer.
HWY_INLINE hn::Vec<DI> integer(V x) {
  const D d;
  const DI di;
  const V magic = hn::Set(d, 6755399441055744.0);  // 1.5 · 2^52
  return hn::Sub(hn::BitCast(di, hn::Add(x, magic)), hn::BitCast(di, magic));
}

/// Two floats as two doubles, exactly.
HWY_INLINE void unpackFloats(VU both, V& a, V& b) {
  const D d;
  const hn::Rebind<std::uint32_t, D> narrow;
  const hn::Rebind<float, D> single;
  a = hn::PromoteTo(d, hn::BitCast(single, hn::TruncateTo(narrow, both)));
  b = hn::PromoteTo(d, hn::BitCast(single, hn::TruncateTo(narrow, hn::ShiftRight<32>(both))));
}

/// Whether the cells at (i, j, k) lie in the box, with `margin` cells on each side.
HWY_INLINE M within(const Lattice& lattice, V i, V j, V k, double margin) {
  const D d;
  const auto onAxis = [&](V at, int axis) HWY_ATTR {
    return hn::And(hn::Ge(at, hn::Set(d, lattice.first[axis] + margin)),
                   hn::Lt(at, hn::Set(d, lattice.end[axis] - 1.0 - margin)));
  };
  return hn::And(onAxis(i, 0), hn::And(onAxis(j, 1), onAxis(k, 2)));
}

HWY_INLINE std::uint32_t bitsOf(M mask) {
  alignas(8) std::uint8_t bits[8] = {};
  const D d;
  hn::StoreMaskBits(d, mask, bits);
  return bits[0];
}

/// The bounds of the finest blocks that hold the cells at (i, j, k), which must be within the grid.
HWY_INLINE void boundsAt(const Lattice& lattice, V i, V j, V k, V& greatest, V& lipschitz) {
  const D d;
  const DI di;
  const DU du;
  // the block of four cells, counted from cell -1
  const V quarter = hn::Set(d, 0.25), one = hn::Set(d, 1.0);
  const V bi = hn::Floor(hn::Mul(hn::Add(i, one), quarter));
  const V bj = hn::Floor(hn::Mul(hn::Add(j, one), quarter));
  const V bk = hn::Floor(hn::Mul(hn::Add(k, one), quarter));
  const V block = hn::Add(bi, hn::Mul(hn::Add(bj, hn::Mul(bk, hn::Set(d, lattice.block_counts[1]))),
                                      hn::Set(d, lattice.block_counts[0])));
  const auto bound = hn::BitCast(
      du,
      hn::GatherIndex(di, reinterpret_cast<const std::int64_t*>(lattice.blocks), integer(block)));
  unpackFloats(bound, greatest, lipschitz);
}

/// Metres within which F is proven below the ceiling. Changes a Lipschitz constant of zero.
HWY_INLINE V freeAround(V value, double ceiling, V radius, V& lipschitz) {
  const D d;
  // a plateau at or above the ceiling has no slope, but is not empty
  lipschitz = hn::Max(lipschitz, hn::Set(d, 2.2250738585072014e-308));
  const V ahead = hn::Div(hn::Sub(hn::Set(d, ceiling), value), lipschitz);
  return hn::Min(hn::Max(ahead, hn::Zero(d)), radius);
}

/// Some segments of chords, each within a cell of the box, and where in it they begin and end.
struct Segments {
  M looked;            ///< the lanes that have one
  V i, j, k;           ///< the cells; 0 in the other lanes
  V begin[3], end[3];  ///< in the cell's own coordinates
  V level;
};

/// Walks along chords, cell by cell, until `reaches(segments)` is true of a lane: of a segment that
/// may reach its level. Cells with less than `margin` cells of the box about them end the walk,
/// too.
template <class Reaches>
HWY_INLINE void walk(const Lattice& lattice, const Chords& chords, int n, double margin,
                     Numbers& until, std::int64_t& cells, Reaches&& reaches) {
  const D d;
  const int width = static_cast<int>(hn::Lanes(d));
  const V zero = hn::Zero(d), one = hn::Set(d, 1.0);
  const V never = hn::Set(d, 1e300);
  constexpr int kMostCells = 24;
  for (int l = 0; l < n; l += width) {
    const V a[3] = {hn::Load(d, chords.a.x.lane + l), hn::Load(d, chords.a.y.lane + l),
                    hn::Load(d, chords.a.z.lane + l)};
    const V b[3] = {hn::Load(d, chords.b.x.lane + l), hn::Load(d, chords.b.y.lane + l),
                    hn::Load(d, chords.b.z.lane + l)};
    Segments segments;
    segments.level = hn::Load(d, chords.level.lane + l);
    V from = hn::Load(d, chords.from.lane + l);
    V way[3], cell[3], next[3], stride[3], step[3];
    for (int axis = 0; axis < 3; ++axis) {
      way[axis] = hn::Sub(b[axis], a[axis]);
      const V start = hn::Add(a[axis], hn::Mul(from, way[axis]));
      cell[axis] = hn::Floor(start);
      const M forth = hn::Gt(way[axis], zero), still = hn::Eq(way[axis], zero);
      step[axis] = hn::IfThenElse(forth, one, hn::Neg(one));
      const V safe = hn::IfThenElse(still, one, hn::Abs(way[axis]));
      stride[axis] = hn::IfThenElse(still, never, hn::Div(one, safe));
      const V room = hn::IfThenElse(forth, hn::Sub(hn::Add(cell[axis], one), a[axis]),
                                    hn::Sub(a[axis], cell[axis]));
      next[axis] = hn::IfThenElse(still, never, hn::Mul(room, stride[axis]));
    }
    V stop = hn::Set(d, 2.0);
    M active = hn::And(hn::Lt(from, one), hn::Lt(hn::Iota(d, 0.0), hn::Set(d, double(n - l))));
    for (int step_count = 0; step_count < kMostCells && !hn::AllFalse(d, active); ++step_count) {
      const V nearest = hn::Min(hn::Min(next[0], next[1]), next[2]);
      const V to = hn::Min(one, nearest);
      const M interior = within(lattice, cell[0], cell[1], cell[2], margin);
      const M entered = hn::And(active, hn::Gt(to, from));
      // what lies beyond the box is left to the scalar code
      const M outside = hn::AndNot(interior, entered);
      stop = hn::IfThenElse(outside, from, stop);
      active = hn::AndNot(outside, active);
      const M looked = hn::And(entered, interior);
      if (!hn::AllFalse(d, looked)) {
        cells += static_cast<std::int64_t>(hn::CountTrue(d, looked));
        segments.looked = looked;
        segments.i = hn::IfThenElseZero(looked, cell[0]);
        segments.j = hn::IfThenElseZero(looked, cell[1]);
        segments.k = hn::IfThenElseZero(looked, cell[2]);
        const V corner[3] = {segments.i, segments.j, segments.k};
        for (int axis = 0; axis < 3; ++axis) {
          segments.begin[axis] = hn::Sub(hn::Add(a[axis], hn::Mul(from, way[axis])), corner[axis]);
          segments.end[axis] = hn::Sub(hn::Add(a[axis], hn::Mul(to, way[axis])), corner[axis]);
        }
        const M reached = hn::And(looked, reaches(segments));
        stop = hn::IfThenElse(reached, from, stop);
        active = hn::AndNot(reached, active);
      }
      from = hn::IfThenElse(entered, to, from);
      active = hn::And(active, hn::Lt(nearest, one));
      // on to the cell behind the nearest face
      const M first = hn::And(hn::Le(next[0], next[1]), hn::Le(next[0], next[2]));
      const M second = hn::AndNot(first, hn::Le(next[1], next[2]));
      const M last = hn::AndNot(first, hn::Gt(next[1], next[2]));
      const M moves[3] = {first, second, last};
      for (int axis = 0; axis < 3; ++axis) {
        cell[axis] = hn::IfThenElse(moves[axis], hn::Add(cell[axis], step[axis]), cell[axis]);
        next[axis] = hn::IfThenElse(moves[axis], hn::Add(next[axis], stride[axis]), next[axis]);
      }
    }
    stop = hn::IfThenElse(active, from, stop);
    hn::Store(stop, d, until.lane + l);
  }
}

#define HAPTICS_LANES_BY_TYPE(type, call) \
  switch (type) {                         \
    case ScalarType::UInt8:               \
      return call(std::uint8_t);          \
    case ScalarType::Int8:                \
      return call(std::int8_t);           \
    case ScalarType::UInt16:              \
      return call(std::uint16_t);         \
    case ScalarType::Int16:               \
      return call(std::int16_t);          \
    case ScalarType::UInt32:              \
      return call(std::uint32_t);         \
    case ScalarType::Int32:               \
      return call(std::int32_t);          \
    case ScalarType::Float32:             \
      return call(float);                 \
  }

}  // namespace haptics::lanes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // HAPTICS_FIELD_LANES_INL_H
