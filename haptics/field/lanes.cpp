// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/field/lanes.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "haptics/field/lanes.cpp"
#include <hwy/foreach_target.h>  // compiles this file once for every target
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace haptics::lanes::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using D = hn::CappedTag<double, 8>;
using DI = hn::RebindToSigned<D>;
using DU = hn::RebindToUnsigned<D>;
using V = hn::Vec<D>;
using VU = hn::Vec<DU>;
using M = hn::Mask<D>;

/// Eight bytes of a voxel and its right neighbour as two doubles, exactly.
template <class T>
struct Pair;

/// An unsigned integer below 2^52 as a double: as the low bits of 2^52.
HWY_INLINE V exact(VU bits, double offset) {
  const D d;
  const DU du;
  const VU exponent = hn::Set(du, 0x4330000000000000ULL);
  return hn::Sub(hn::BitCast(d, hn::Or(bits, exponent)), hn::Set(d, 4503599627370496.0 + offset));
}
template <int kBits, bool kSigned>
HWY_INLINE void unpackIntegers(VU both, V& left, V& right) {
  const DU du;
  const VU mask = hn::Set(du, (1ULL << kBits) - 1);
  VU a = hn::And(both, mask), b = hn::And(hn::ShiftRight<kBits>(both), mask);
  if (kSigned) {
    // the sign bit turned over adds half the range
    const VU sign = hn::Set(du, 1ULL << (kBits - 1));
    a = hn::Xor(a, sign);
    b = hn::Xor(b, sign);
  }
  const double offset = kSigned ? double(1ULL << (kBits - 1)) : 0.0;
  left = exact(a, offset);
  right = exact(b, offset);
}
template <>
struct Pair<std::uint8_t> {
  static HWY_INLINE void unpack(VU v, V& a, V& b) { unpackIntegers<8, false>(v, a, b); }
};
template <>
struct Pair<std::int8_t> {
  static HWY_INLINE void unpack(VU v, V& a, V& b) { unpackIntegers<8, true>(v, a, b); }
};
template <>
struct Pair<std::uint16_t> {
  static HWY_INLINE void unpack(VU v, V& a, V& b) { unpackIntegers<16, false>(v, a, b); }
};
template <>
struct Pair<std::int16_t> {
  static HWY_INLINE void unpack(VU v, V& a, V& b) { unpackIntegers<16, true>(v, a, b); }
};
template <>
struct Pair<std::uint32_t> {
  static HWY_INLINE void unpack(VU v, V& a, V& b) { unpackIntegers<32, false>(v, a, b); }
};
template <>
struct Pair<std::int32_t> {
  static HWY_INLINE void unpack(VU v, V& a, V& b) { unpackIntegers<32, true>(v, a, b); }
};
template <>
struct Pair<float> {
  static HWY_INLINE void unpack(VU v, V& a, V& b) {
    const D d;
    const hn::Rebind<std::uint32_t, D> narrow;
    const hn::Rebind<float, D> single;
    a = hn::PromoteTo(d, hn::BitCast(single, hn::TruncateTo(narrow, v)));
    b = hn::PromoteTo(d, hn::BitCast(single, hn::TruncateTo(narrow, hn::ShiftRight<32>(v))));
  }
};

/// An integer below 2^51 that a double holds, as an integer.
HWY_INLINE hn::Vec<DI> integer(V x) {
  const D d;
  const DI di;
  const V magic = hn::Set(d, 6755399441055744.0);  // 1.5 · 2^52
  return hn::Sub(hn::BitCast(di, hn::Add(x, magic)), hn::BitCast(di, magic));
}

/// The corner values of the cells at (i, j, k), which must be within the grid.
template <class T>
HWY_INLINE void fetch(const Lattice& lattice, V i, V j, V k, V* corner) {
  const D d;
  const DI di;
  const double row = lattice.dims[0], slice = lattice.dims[0] * lattice.dims[1];
  const V at = hn::Add(hn::Add(i, hn::Mul(j, hn::Set(d, row))), hn::Mul(k, hn::Set(d, slice)));
  const auto offset = integer(hn::Mul(at, hn::Set(d, double(sizeof(T)))));
  const auto* base = static_cast<const std::int64_t*>(lattice.voxels);
  const auto next_row = hn::Set(di, static_cast<std::int64_t>(row) * std::int64_t{sizeof(T)});
  const auto next_slice = hn::Set(di, static_cast<std::int64_t>(slice) * std::int64_t{sizeof(T)});
  const DU du;
  const auto pair = [&](hn::Vec<DI> from, V& a, V& b) HWY_ATTR {
    Pair<T>::unpack(hn::BitCast(du, hn::GatherOffset(di, base, from)), a, b);
  };
  pair(offset, corner[0], corner[1]);
  pair(hn::Add(offset, next_row), corner[2], corner[3]);
  const auto above = hn::Add(offset, next_slice);
  pair(above, corner[4], corner[5]);
  pair(hn::Add(above, next_row), corner[6], corner[7]);
}

HWY_INLINE V lerp(V t, V a, V b) { return hn::Add(a, hn::Mul(t, hn::Sub(b, a))); }

HWY_INLINE V valueIn(const V* c, V x, V y, V z) {
  const V c0 = lerp(y, lerp(x, c[0], c[1]), lerp(x, c[2], c[3]));
  const V c1 = lerp(y, lerp(x, c[4], c[5]), lerp(x, c[6], c[7]));
  return lerp(z, c0, c1);
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

template <class T>
HWY_INLINE void surveyOf(const Lattice& lattice, const Places& u, int n, double ceiling,
                         Survey& found) {
  const D d;
  const DI di;
  const DU du;
  const int width = static_cast<int>(hn::Lanes(d));
  const V zero = hn::Zero(d);
  found.edge = found.empty = 0;
  for (int l = 0; l < n; l += width) {
    const V x = hn::Load(d, u.x.lane + l), y = hn::Load(d, u.y.lane + l),
            z = hn::Load(d, u.z.lane + l);
    V i = hn::Floor(x), j = hn::Floor(y), k = hn::Floor(z);
    const M interior = within(lattice, i, j, k, 0.0);
    i = hn::IfThenElseZero(interior, i);
    j = hn::IfThenElseZero(interior, j);
    k = hn::IfThenElseZero(interior, k);

    // the block of four cells, counted from cell -1
    const V quarter = hn::Set(d, 0.25), one = hn::Set(d, 1.0);
    const V bi = hn::Floor(hn::Mul(hn::Add(i, one), quarter));
    const V bj = hn::Floor(hn::Mul(hn::Add(j, one), quarter));
    const V bk = hn::Floor(hn::Mul(hn::Add(k, one), quarter));
    const V block =
        hn::Add(bi, hn::Mul(hn::Add(bj, hn::Mul(bk, hn::Set(d, lattice.block_counts[1]))),
                            hn::Set(d, lattice.block_counts[0])));
    const auto bound = hn::BitCast(
        du,
        hn::GatherIndex(di, reinterpret_cast<const std::int64_t*>(lattice.blocks), integer(block)));
    V greatest, lipschitz;
    Pair<float>::unpack(bound, greatest, lipschitz);
    const M empty = hn::Lt(greatest, hn::Set(d, ceiling));

    const V radius = hn::Set(d, lattice.finest_radius);
    V value = zero, free = radius;
    if (!hn::AllTrue(d, hn::Or(empty, hn::Not(interior)))) {
      V corner[8];
      fetch<T>(lattice, i, j, k, corner);
      value = valueIn(corner, hn::Sub(x, i), hn::Sub(y, j), hn::Sub(z, k));
      // a plateau at or above the ceiling has no slope, but is not empty
      lipschitz = hn::Max(lipschitz, hn::Set(d, 2.2250738585072014e-308));
      const V ahead = hn::Div(hn::Sub(hn::Set(d, ceiling), value), lipschitz);
      free = hn::IfThenElse(empty, radius, hn::Min(hn::Max(ahead, zero), radius));
    }
    hn::Store(value, d, found.value.lane + l);
    hn::Store(lipschitz, d, found.lipschitz.lane + l);
    hn::Store(free, d, found.free.lane + l);
    found.edge |= bitsOf(hn::Not(interior)) << l;
    found.empty |= bitsOf(hn::And(empty, interior)) << l;
  }
}

template <class T>
HWY_INLINE void clearOf(const Lattice& lattice, const Chords& chords, int n, Numbers& until,
                        std::int64_t& cells) {
  const D d;
  const int width = static_cast<int>(hn::Lanes(d));
  const V zero = hn::Zero(d), one = hn::Set(d, 1.0), third = hn::Set(d, 3.0);
  const V never = hn::Set(d, 1e300);
  constexpr int kMostCells = 24;
  for (int l = 0; l < n; l += width) {
    const V a[3] = {hn::Load(d, chords.a.x.lane + l), hn::Load(d, chords.a.y.lane + l),
                    hn::Load(d, chords.a.z.lane + l)};
    const V b[3] = {hn::Load(d, chords.b.x.lane + l), hn::Load(d, chords.b.y.lane + l),
                    hn::Load(d, chords.b.z.lane + l)};
    const V level = hn::Load(d, chords.level.lane + l);
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
      const M interior = within(lattice, cell[0], cell[1], cell[2], 0.0);
      const M entered = hn::And(active, hn::Gt(to, from));
      // what lies beyond the box is left to the scalar code
      const M outside = hn::AndNot(interior, entered);
      stop = hn::IfThenElse(outside, from, stop);
      active = hn::AndNot(outside, active);
      const M looked = hn::And(entered, interior);
      if (!hn::AllFalse(d, looked)) {
        cells += static_cast<std::int64_t>(hn::CountTrue(d, looked));
        const V i = hn::IfThenElseZero(looked, cell[0]), j = hn::IfThenElseZero(looked, cell[1]),
                k = hn::IfThenElseZero(looked, cell[2]);
        V c[8];
        fetch<T>(lattice, i, j, k, c);
        const V x0 = hn::Sub(hn::Add(a[0], hn::Mul(from, way[0])), i);
        const V y0 = hn::Sub(hn::Add(a[1], hn::Mul(from, way[1])), j);
        const V z0 = hn::Sub(hn::Add(a[2], hn::Mul(from, way[2])), k);
        const V x1 = hn::Sub(hn::Add(a[0], hn::Mul(to, way[0])), i);
        const V y1 = hn::Sub(hn::Add(a[1], hn::Mul(to, way[1])), j);
        const V z1 = hn::Sub(hn::Add(a[2], hn::Mul(to, way[2])), k);
        // the blossom: F at the mixed corners of the segment's box
        V f[2][2][2];
        const V x[2] = {x0, x1}, y[2] = {y0, y1}, z[2] = {z0, z1};
        for (int ix = 0; ix < 2; ++ix) {
          const V c00 = lerp(x[ix], c[0], c[1]), c10 = lerp(x[ix], c[2], c[3]);
          const V c01 = lerp(x[ix], c[4], c[5]), c11 = lerp(x[ix], c[6], c[7]);
          for (int iy = 0; iy < 2; ++iy) {
            const V d0 = lerp(y[iy], c00, c10), d1 = lerp(y[iy], c01, c11);
            for (int iz = 0; iz < 2; ++iz) f[ix][iy][iz] = lerp(z[iz], d0, d1);
          }
        }
        const V b1 = hn::Div(hn::Add(hn::Add(f[1][0][0], f[0][1][0]), f[0][0][1]), third);
        const V b2 = hn::Div(hn::Add(hn::Add(f[1][1][0], f[1][0][1]), f[0][1][1]), third);
        const V greatest = hn::Max(hn::Max(f[0][0][0], b1), hn::Max(b2, f[1][1][1]));
        const M reached = hn::And(looked, hn::Ge(greatest, level));
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

template <class T>
HWY_INLINE void slopesOf(const Lattice& lattice, const Places& u, int n, bool central,
                         Slopes& found) {
  const D d;
  const int width = static_cast<int>(hn::Lanes(d));
  const V one = hn::Set(d, 1.0), half = hn::Set(d, 0.5);
  found.edge = 0;
  for (int l = 0; l < n; l += width) {
    const V p[3] = {hn::Load(d, u.x.lane + l), hn::Load(d, u.y.lane + l),
                    hn::Load(d, u.z.lane + l)};
    V i = hn::Floor(p[0]), j = hn::Floor(p[1]), k = hn::Floor(p[2]);
    // one cell more on each side, for the differences
    const M inner = within(lattice, i, j, k, 1.0);
    i = hn::IfThenElse(inner, i, one);
    j = hn::IfThenElse(inner, j, one);
    k = hn::IfThenElse(inner, k, one);
    found.edge |= bitsOf(hn::Not(inner)) << l;
    if (hn::AllFalse(d, inner)) continue;

    V c[8];
    fetch<T>(lattice, i, j, k, c);
    const V x = hn::Sub(p[0], i), y = hn::Sub(p[1], j), z = hn::Sub(p[2], k);
    hn::Store(valueIn(c, x, y, z), d, found.value.lane + l);

    // as Cell::gradient
    const V dx00 = hn::Sub(c[1], c[0]), dx10 = hn::Sub(c[3], c[2]);
    const V dx01 = hn::Sub(c[5], c[4]), dx11 = hn::Sub(c[7], c[6]);
    const V c00 = hn::Add(c[0], hn::Mul(x, dx00)), c10 = hn::Add(c[2], hn::Mul(x, dx10));
    const V c01 = hn::Add(c[4], hn::Mul(x, dx01)), c11 = hn::Add(c[6], hn::Mul(x, dx11));
    hn::Store(lerp(z, lerp(y, dx00, dx10), lerp(y, dx01, dx11)), d, found.exact.x.lane + l);
    hn::Store(lerp(z, hn::Sub(c10, c00), hn::Sub(c11, c01)), d, found.exact.y.lane + l);
    hn::Store(hn::Sub(lerp(y, c01, c11), lerp(y, c00, c10)), d, found.exact.z.lane + l);

    if (!central) continue;
    // as ScalarField::centralGradient: each end falls into the cell that holds it
    double* const out[3] = {found.central.x.lane, found.central.y.lane, found.central.z.lane};
    for (int axis = 0; axis < 3; ++axis) {
      V side[2];
      for (int s = 0; s < 2; ++s) {
        V q[3] = {p[0], p[1], p[2]};
        q[axis] = s == 0 ? hn::Sub(q[axis], one) : hn::Add(q[axis], one);
        V at[3] = {i, j, k};
        // rounding may put an end on the far face of its cell, never beyond
        const V cell = hn::IfThenElse(inner, hn::Floor(q[axis]), one);
        at[axis] = hn::Min(hn::Max(cell, hn::Sub(at[axis], one)), hn::Add(at[axis], one));
        V corner[8];
        fetch<T>(lattice, at[0], at[1], at[2], corner);
        side[s] = valueIn(corner, hn::Sub(q[0], at[0]), hn::Sub(q[1], at[1]), hn::Sub(q[2], at[2]));
      }
      hn::Store(hn::Mul(half, hn::Sub(side[1], side[0])), d, out[axis] + l);
    }
  }
}

// a lane's gather may look at eight bytes where fewer belong to it: the padding is read, not used
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

void Place(const Affine& map, const double* px, const double* py, const double* pz, int n,
           Places& u) {
  const D d;
  const int width = static_cast<int>(hn::Lanes(d));
  double* const out[3] = {u.x.lane, u.y.lane, u.z.lane};
  for (int l = 0; l < n; l += width) {
    const V x = hn::LoadU(d, px + l), y = hn::LoadU(d, py + l), z = hn::LoadU(d, pz + l);
    for (int axis = 0; axis < 3; ++axis) {
      const double* row = map.A[axis];
      const V sum = hn::Add(hn::Add(hn::Mul(hn::Set(d, row[0]), x), hn::Mul(hn::Set(d, row[1]), y)),
                            hn::Mul(hn::Set(d, row[2]), z));
      hn::Store(hn::Add(sum, hn::Set(d, map.b[axis])), d, out[axis] + l);
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
#undef HAPTICS_LANES_BY_TYPE
const char* Name() { return hwy::TargetName(HWY_TARGET); }

}  // namespace haptics::lanes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace haptics::lanes {

HWY_EXPORT(Place);
HWY_EXPORT(SurveyAll);
HWY_EXPORT(ClearAll);
HWY_EXPORT(SlopesAll);
HWY_EXPORT(Name);

void place(const Affine& map, const double* px, const double* py, const double* pz, int n,
           Places& u) HAPTICS_RT {
  HWY_DYNAMIC_DISPATCH(Place)(map, px, py, pz, n, u);
}
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
const char* targetName() { return HWY_DYNAMIC_DISPATCH(Name)(); }

}  // namespace haptics::lanes
#endif  // HWY_ONCE
