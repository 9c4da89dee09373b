// SPDX-License-Identifier: BSD-3-Clause
#include "ui/props/contour.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "ui/props/picture.h"

namespace ui {
namespace {

constexpr double kEndTolerance = 0.005;  // voxel
constexpr double kBendTolerance = 0.05;  // voxel
constexpr int kMostBends = 4;            // halvings of a piece
constexpr int kMostSplits = 3;           // halvings of a cell that is not understood

/// Marching squares over a patch.
class Marcher {
 public:
  Marcher(const std::function<double(const haptics::Vec3&)>& field, double level,
          const Patch& patch, const ContourFineness& fineness)
      : field_(field),
        level_(level),
        corner_(patch.corner_W_mm / kMmPerM),
        right_(patch.right / kMmPerM),
        up_(patch.up / kMmPerM),
        fineness_(fineness) {
    columns_ = std::max(1, static_cast<int>(std::ceil(patch.width_mm / fineness.step_mm)));
    rows_ = std::max(1, static_cast<int>(std::ceil(patch.height_mm / fineness.step_mm)));
  }

  std::vector<QLineF> pieces() {
    const double h = fineness_.step_mm;
    std::vector<double> below(static_cast<std::size_t>(columns_) + 1), above(below.size());
    // crossings of the edges along the lower and upper row of samples, found when first needed
    std::vector<double> lower(static_cast<std::size_t>(columns_), kUnknown), upper(lower.size());
    sampleRow(0, below);
    for (int j = 0; j < rows_; ++j) {
      sampleRow(j + 1, above);
      std::fill(upper.begin(), upper.end(), kUnknown);
      double left = kUnknown;
      for (int i = 0; i < columns_; ++i) {
        const auto n = static_cast<std::size_t>(i);
        const std::array<double, 4> f{below[n], below[n + 1], above[n + 1], above[n]};
        double right = kUnknown;
        if (crossed(f)) {
          std::array<double*, 4> edges{&lower[n], &right, &upper[n], &left};
          cell({i * h, j * h}, h, f, edges, 0);
        }
        left = right;
      }
      std::swap(below, above);
      std::swap(lower, upper);
    }
    return std::move(pieces_);
  }

 private:
  static constexpr double kUnknown = -1.0;

  double value(QPointF p) const { return field_(corner_ + right_ * p.x() + up_ * p.y()); }
  bool solid(double f) const { return f >= level_; }
  bool crossed(const std::array<double, 4>& f) const {
    const bool first = solid(f[0]);
    return solid(f[1]) != first || solid(f[2]) != first || solid(f[3]) != first;
  }

  void sampleRow(int j, std::vector<double>& row) const {
    const double h = fineness_.step_mm;
    const haptics::Vec3 first = corner_ + up_ * (j * h), step = right_ * h;
    for (int i = 0; i <= columns_; ++i) row[static_cast<std::size_t>(i)] = field_(first + step * i);
  }

  /// Where between a (0) and b (1) the field is at the level; the two lie on different sides.
  double crossing(QPointF a, QPointF b, double fa, double fb) const {
    const double length = std::hypot(b.x() - a.x(), b.y() - a.y());
    const double tolerance = kEndTolerance * fineness_.voxel_mm / length;
    double lo = 0.0, hi = 1.0;
    double flo = fa - level_, fhi = fb - level_;
    const bool rises = flo < 0.0;
    double t = 0.5;
    for (int n = 0; n < 24 && hi - lo > tolerance; ++n) {
      // the secant, and by turns the middle, so that both ends come in
      t = n % 3 == 2 ? 0.5 * (lo + hi) : lo + (hi - lo) * (flo / (flo - fhi));
      t = std::clamp(t, lo + 0.4 * tolerance, hi - 0.4 * tolerance);
      const double f = value(a + (b - a) * t) - level_;
      ((f < 0.0) == rises ? lo : hi) = t;
      ((f < 0.0) == rises ? flo : fhi) = f;
    }
    if (flo == fhi) return 0.5 * (lo + hi);
    return std::clamp(lo + (hi - lo) * (flo / (flo - fhi)), lo, hi);
  }

  /// One cell, whose corners and edges go round: from the lower left, from the lower edge.
  void cell(QPointF at, double h, const std::array<double, 4>& f,
            const std::array<double*, 4>& known, int splits) {
    const std::array<QPointF, 4> corner{at, at + QPointF{h, 0}, at + QPointF{h, h},
                                        at + QPointF{0, h}};
    std::array<QPointF, 4> ends;
    int n = 0;
    for (int e = 0; e < 4; ++e) {
      const int next = (e + 1) % 4;
      if (solid(f[e]) == solid(f[next])) continue;
      // both cells of an edge take it the same way round, from left and from below
      const int from = e < 2 ? e : next, to = e < 2 ? next : e;
      if (*known[e] < 0.0) *known[e] = crossing(corner[from], corner[to], f[from], f[to]);
      ends[n] = corner[from] + (corner[to] - corner[from]) * *known[e];
      ++n;
    }
    if (n == 2) {
      if (fineness_.bent && bend(ends[0], ends[1], 0)) return;
      if (fineness_.bent && splits < kMostSplits) return split(at, h, f, splits);
      pieces_.emplace_back(ends[0], ends[1]);
      return;
    }
    // a saddle: the middle says which corners belong together
    const bool joined = solid(value(at + QPointF{0.5 * h, 0.5 * h})) == solid(f[0]);
    const std::array<int, 4> pairs = joined ? std::array<int, 4>{0, 1, 2, 3}   // corners 1, 3 alone
                                            : std::array<int, 4>{3, 0, 1, 2};  // corners 0, 2 alone
    for (const int p : {0, 2}) {
      const QPointF a = ends[pairs[p]], b = ends[pairs[p + 1]];
      if (!fineness_.bent || !bend(a, b, 0)) pieces_.emplace_back(a, b);
    }
  }

  /// The four quarters of a cell that holds more than its corners tell.
  void split(QPointF at, double h, const std::array<double, 4>& f, int splits) {
    const double half = 0.5 * h;
    const double low = value(at + QPointF{half, 0}), right = value(at + QPointF{h, half});
    const double top = value(at + QPointF{half, h}), left = value(at + QPointF{0, half});
    const double mid = value(at + QPointF{half, half});
    const auto quarter = [&](QPointF corner, const std::array<double, 4>& values) {
      if (!crossed(values)) return;
      std::array<double, 4> unknown{kUnknown, kUnknown, kUnknown, kUnknown};
      cell(corner, half, values, {&unknown[0], &unknown[1], &unknown[2], &unknown[3]}, splits + 1);
    };
    quarter(at, {f[0], low, mid, left});
    quarter(at + QPointF{half, 0}, {low, f[1], right, mid});
    quarter(at + QPointF{half, half}, {mid, right, f[2], top});
    quarter(at + QPointF{0, half}, {left, mid, top, f[3]});
  }

  /// Adds the piece from a to b, bent to where the field is at the level. False, with nothing
  /// added, if the level is not found beside its middle.
  bool bend(QPointF a, QPointF b, int bends) {
    const double length = std::hypot(b.x() - a.x(), b.y() - a.y());
    const double close = kBendTolerance * fineness_.voxel_mm;
    if (bends == kMostBends || length < 2.0 * close) {
      pieces_.emplace_back(a, b);
      return true;
    }
    const QPointF middle = 0.5 * (a + b);
    const QPointF beside{-(b.y() - a.y()) / length, (b.x() - a.x()) / length};
    const double f = value(middle);
    // the level lies within `close` on one of the two sides
    const double f_one = value(middle + beside * close), f_other = value(middle - beside * close);
    if (solid(f_one) != solid(f) || solid(f_other) != solid(f)) {
      pieces_.emplace_back(a, b);
      return true;
    }
    const bool to_one = solid(f) ? f_one < f_other : f_one > f_other;
    const QPointF away = to_one ? beside : -beside;
    double near = close, f_near = to_one ? f_one : f_other;
    for (double far = 2.0 * close; far < 0.75 * length; far += close) {
      const double f_far = value(middle + away * far);
      if (solid(f_far) == solid(f)) {
        near = far;
        f_near = f_far;
        continue;
      }
      const QPointF from = middle + away * near, to = middle + away * far;
      const QPointF met = from + (to - from) * crossing(from, to, f_near, f_far);
      const std::size_t kept = pieces_.size();
      if (bend(a, met, bends + 1) && bend(met, b, bends + 1)) return true;
      pieces_.resize(kept);
      return false;
    }
    return false;
  }

  const std::function<double(const haptics::Vec3&)>& field_;
  double level_;
  haptics::Vec3 corner_, right_, up_;  ///< m, and m for a mm
  ContourFineness fineness_;
  int columns_ = 0, rows_ = 0;
  std::vector<QLineF> pieces_;
};

}  // namespace

std::vector<QLineF> contourOf(const std::function<double(const haptics::Vec3& p_W)>& field,
                              double level, const Patch& patch, const ContourFineness& fineness) {
  if (!field || !(patch.width_mm > 0.0) || !(patch.height_mm > 0.0)) return {};
  return Marcher(field, level, patch, fineness).pieces();
}

}  // namespace ui
