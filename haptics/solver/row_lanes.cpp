// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/solver/row_lanes.h"

#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "haptics/solver/row_lanes.cpp"
#include <hwy/foreach_target.h>  // compiles this file once for every target
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace haptics::row_lanes::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using D = hn::CappedTag<double, kWidest>;
using V = hn::Vec<D>;
using M = hn::Mask<D>;

/// x·y in the order in which Eigen sums three products.
HWY_INLINE V three(const double* x, const V* y) {
  const D d;
  return hn::Add(hn::Add(hn::Mul(hn::Set(d, x[0]), y[0]), hn::Mul(hn::Set(d, x[1]), y[1])),
                 hn::Mul(hn::Set(d, x[2]), y[2]));
}
/// The sum of six in the order in which Eigen sums them, by pairs.
HWY_INLINE V six(const V* x) {
  return hn::Add(hn::Add(x[0], hn::Add(x[2], x[4])), hn::Add(x[1], hn::Add(x[3], x[5])));
}

double Whiten(const RowMap& map, Rows& rows) {
  const D d;
  const int width = static_cast<int>(hn::Lanes(d));
  const V zero = hn::Zero(d), never = hn::Set(d, -std::numeric_limits<double>::infinity());
  V greatest = zero;
  for (int i = 0; i < rows.count; i += width) {
    V a[6], r[3];
    for (int c = 0; c < 3; ++c) {
      a[c] = hn::Load(d, rows.a[c] + i);
      r[c] = hn::Load(d, rows.a[3 + c] + i);
    }
    const V moment[3] = {hn::Sub(hn::Mul(r[1], a[2]), hn::Mul(r[2], a[1])),
                         hn::Sub(hn::Mul(r[2], a[0]), hn::Mul(r[0], a[2])),
                         hn::Sub(hn::Mul(r[0], a[1]), hn::Mul(r[1], a[0]))};
    V turned[3];
    for (int c = 0; c < 3; ++c) turned[c] = three(map.turn[c], moment);
    for (int c = 0; c < 3; ++c) a[3 + c] = three(map.shape[c], turned);

    V squares[6];
    for (int c = 0; c < 6; ++c) squares[c] = hn::Mul(a[c], a[c]);
    const V size = hn::Sqrt(six(squares));
    const M directed = hn::Gt(size, zero);
    for (int c = 0; c < 6; ++c)
      hn::Store(hn::IfThenElseZero(directed, hn::Div(a[c], size)), d, rows.a[c] + i);
    const V b = hn::Div(hn::Neg(hn::Load(d, rows.b + i)), size), far = hn::Abs(b);
    greatest = hn::IfThenElse(hn::And(directed, hn::Gt(far, greatest)), far, greatest);
    hn::Store(hn::IfThenElse(directed, b, never), d, rows.b + i);
    hn::Store(size, d, rows.size + i);
  }
  alignas(64) double each[kWidest];
  hn::Store(greatest, d, each);
  double most = 0.0;
  for (int l = 0; l < width; ++l) most = each[l] > most ? each[l] : most;
  return most;
}

int MostViolated(const Rows& rows, const double* b, const double* y, double tolerance) {
  const D d;
  const int width = static_cast<int>(hn::Lanes(d));
  V along[6];
  for (int c = 0; c < 6; ++c) along[c] = hn::Set(d, y[c]);
  V least = hn::Set(d, -tolerance), at = hn::Set(d, -1.0), here = hn::Iota(d, 0.0);
  const V next = hn::Set(d, double(width));
  for (int i = 0; i < rows.count; i += width) {
    V x[6];
    for (int c = 0; c < 6; ++c) x[c] = hn::Mul(hn::Load(d, rows.a[c] + i), along[c]);
    const V slack = hn::Sub(six(x), hn::Load(d, b + i));
    const M less = hn::Lt(slack, least);
    least = hn::IfThenElse(less, slack, least);
    at = hn::IfThenElse(less, here, at);
    here = hn::Add(here, next);
  }
  alignas(64) double slacks[kWidest], found[kWidest];
  hn::Store(least, d, slacks);
  hn::Store(at, d, found);
  int best = -1;
  double violation = 0.0;
  for (int l = 0; l < width; ++l) {
    const int row = static_cast<int>(found[l]);
    if (row < 0) continue;
    if (best < 0 || slacks[l] < violation || (slacks[l] == violation && row < best)) {
      best = row;
      violation = slacks[l];
    }
  }
  return best;
}

}  // namespace haptics::row_lanes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace haptics::row_lanes {

HWY_EXPORT(Whiten);
HWY_EXPORT(MostViolated);

double whiten(const RowMap& map, Rows& rows) HAPTICS_RT {
  return HWY_DYNAMIC_DISPATCH(Whiten)(map, rows);
}
int mostViolated(const Rows& rows, const double* b, const double* y, double tolerance) HAPTICS_RT {
  return HWY_DYNAMIC_DISPATCH(MostViolated)(rows, b, y, tolerance);
}

}  // namespace haptics::row_lanes
#endif  // HWY_ONCE
