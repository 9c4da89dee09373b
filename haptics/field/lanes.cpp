// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/field/lanes.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "haptics/field/lanes.cpp"
#include <hwy/foreach_target.h>  // compiles this file once for every target
#include <hwy/highway.h>

#include "haptics/field/lanes_inl.h"

HWY_BEFORE_NAMESPACE();
namespace haptics::lanes::HWY_NAMESPACE {

/// Eight bytes of a voxel and its right neighbour as two doubles, exactly.
template <class T>
struct Pair;

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
  static HWY_INLINE void unpack(VU v, V& a, V& b) { unpackFloats(v, a, b); }
};

/// The corner values of the cells at (i, j, k), which must be within the grid. A lane's gather may
/// look at eight bytes where fewer belong to it: the padding is read, not used.
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

template <class T>
HWY_INLINE void surveyOf(const Lattice& lattice, const Places& u, int n, double ceiling,
                         Survey& found) {
  const D d;
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

    V greatest, lipschitz;
    boundsAt(lattice, i, j, k, greatest, lipschitz);
    const M empty = hn::Lt(greatest, hn::Set(d, ceiling));

    const V radius = hn::Set(d, lattice.finest_radius);
    V value = zero, free = radius;
    if (!hn::AllTrue(d, hn::Or(empty, hn::Not(interior)))) {
      V corner[8];
      fetch<T>(lattice, i, j, k, corner);
      value = valueIn(corner, hn::Sub(x, i), hn::Sub(y, j), hn::Sub(z, k));
      free = hn::IfThenElse(empty, radius, freeAround(value, ceiling, radius, lipschitz));
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
  walk(lattice, chords, n, 0.0, until, cells, [&](const Segments& s) HWY_ATTR {
    const D d;
    const V third = hn::Set(d, 3.0);
    V c[8];
    fetch<T>(lattice, s.i, s.j, s.k, c);
    // the blossom: F at the mixed corners of the segment's box
    V f[2][2][2];
    const V x[2] = {s.begin[0], s.end[0]}, y[2] = {s.begin[1], s.end[1]},
            z[2] = {s.begin[2], s.end[2]};
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
    return hn::Ge(greatest, s.level);
  });
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
