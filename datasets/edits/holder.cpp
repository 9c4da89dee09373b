// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "datasets/edits/pieces.h"

namespace datasets {
namespace {

// README.md, "Table and holder", tells the rule
constexpr double kTissue = -300.0;       // HU: skin and all that is denser
constexpr double kCell = 2e-3;           // m: about the side of a cell, at least
constexpr double kMostCells = 1.5e6;     // of a scan; a larger one has larger cells
constexpr double kThin = 5e-3;           // m: what is nowhere farther than this from its surface
constexpr double kFull = 0.5;            // of a body's cells that lie deeper: it can be cut
constexpr double kOtherBody = 0.2;       // of the largest part's cells: a part as large stays
constexpr double kLongestPart = 80e-3;   // m: of the patient: an ear, a nose
constexpr double kFarthestPart = 40e-3;  // m from the body
constexpr double kLeastHolder = 5e-7;    // m^3: less is noise

/// Cells of some voxels each, one behind the other, i fastest.
struct Cells {
  std::array<std::int64_t, 3> count{};
  std::array<std::int64_t, 3> voxels{};        ///< of a cell along each axis
  haptics::Vec3 side = haptics::Vec3::Zero();  ///< m

  std::size_t size() const { return static_cast<std::size_t>(count[0] * count[1] * count[2]); }
  std::size_t at(std::int64_t i, std::int64_t j, std::int64_t k) const {
    return static_cast<std::size_t>((k * count[1] + j) * count[0] + i);
  }
  /// Calls each(neighbour) for those across the six faces.
  template <class F>
  void eachBeside(std::size_t cell, F&& each) const {
    const std::size_t step[3] = {1, static_cast<std::size_t>(count[0]),
                                 static_cast<std::size_t>(count[0] * count[1])};
    const std::array<std::int64_t, 3> place = placeOf(cell);
    for (std::size_t a = 0; a < 3; ++a) {
      if (place[a] > 0) each(cell - step[a]);
      if (place[a] + 1 < count[a]) each(cell + step[a]);
    }
  }
  std::array<std::int64_t, 3> placeOf(std::size_t cell) const {
    const auto n = static_cast<std::int64_t>(cell);
    return {n % count[0], n / count[0] % count[1], n / (count[0] * count[1])};
  }
};

using Mask = std::vector<std::uint8_t>;

Cells cellsOf(const haptics::Volume& volume, const haptics::VoxelBox& box) {
  Cells cells;
  double all = volume.grid.spacing.prod();
  for (std::size_t a = 0; a < 3; ++a) all *= static_cast<double>(box.end[a] - box.first[a]);
  const double side = std::max(kCell, std::cbrt(all / kMostCells));
  for (std::size_t a = 0; a < 3; ++a) {
    const double spacing = volume.grid.spacing[static_cast<int>(a)];
    cells.voxels[a] = std::max<std::int64_t>(1, std::llround(std::min(1e6, side / spacing)));
    cells.count[a] = (box.end[a] - box.first[a] + cells.voxels[a] - 1) / cells.voxels[a];
    cells.side[static_cast<int>(a)] = static_cast<double>(cells.voxels[a]) * spacing;
  }
  return cells;
}

/// The value between the two classes of a histogram that differ most (Otsu).
double betweenAirAndMatter(const haptics::Volume& volume, const haptics::VoxelBox& box) {
  constexpr std::size_t kBins = 256;
  std::array<double, kBins> bins{};
  const double width = (volume.greatest - volume.least) / kBins;
  if (!(width > 0.0)) return volume.greatest;
  visitVoxels(volume.type, volume.voxels.get(), [&](const auto* values) {
    const auto& dims = volume.grid.dims;
    for (std::int64_t k = box.first[2]; k < box.end[2]; k += 2)
      for (std::int64_t j = box.first[1]; j < box.end[1]; j += 2)
        for (std::int64_t i = box.first[0]; i < box.end[0]; i += 2) {
          const auto value = static_cast<double>(values[(k * dims[1] + j) * dims[0] + i]);
          bins[std::min(kBins - 1, static_cast<std::size_t>((value - volume.least) / width))] += 1;
        }
  });
  double count = 0.0, sum = 0.0;
  for (std::size_t n = 0; n < kBins; ++n) {
    count += bins[n];
    sum += bins[n] * static_cast<double>(n);
  }
  double below = 0.0, sum_below = 0.0, most = -1.0;
  std::size_t best = 0;
  for (std::size_t n = 0; n + 1 < kBins; ++n) {
    below += bins[n];
    sum_below += bins[n] * static_cast<double>(n);
    if (below == 0.0 || below == count) continue;
    const double apart = sum_below / below - (sum - sum_below) / (count - below);
    const double between = below * (count - below) * apart * apart;
    if (between <= most) continue;
    most = between;
    best = n;
  }
  return volume.least + width * static_cast<double>(best + 1);
}

/// Cells of which at least half is at the value or above.
Mask solidCells(const Cells& cells, const VoxelBits& solid, const haptics::VoxelBox& box) {
  std::vector<std::int32_t> filled(cells.size());
  for (std::int64_t k = box.first[2]; k < box.end[2]; ++k)
    for (std::int64_t j = box.first[1]; j < box.end[1]; ++j) {
      const std::size_t row =
          cells.at(0, (j - box.first[1]) / cells.voxels[1], (k - box.first[2]) / cells.voxels[2]);
      eachRun(solid.row(j, k), solid.wordsInRow(), [&](std::int64_t first, std::int64_t end) {
        for (std::int64_t i = first - box.first[0]; i < end - box.first[0];) {
          const std::int64_t cell = i / cells.voxels[0];
          const std::int64_t until = std::min(end - box.first[0], (cell + 1) * cells.voxels[0]);
          filled[row + static_cast<std::size_t>(cell)] += static_cast<std::int32_t>(until - i);
          i = until;
        }
      });
    }
  const std::int64_t whole = cells.voxels[0] * cells.voxels[1] * cells.voxels[2];
  Mask mask(cells.size());
  for (std::size_t n = 0; n < mask.size(); ++n) mask[n] = 2 * filled[n] >= whole;
  return mask;
}

/// What cannot be reached from the cells at the edge through cells that are not solid is inside.
Mask withCavities(const Cells& cells, const Mask& solid) {
  Mask filled(cells.size(), 1);
  std::vector<std::size_t> open;
  const auto enter = [&](std::size_t cell) {
    if (solid[cell] != 0 || filled[cell] == 0) return;
    filled[cell] = 0;
    open.push_back(cell);
  };
  for (std::size_t n = 0; n < cells.size(); ++n) {
    const auto place = cells.placeOf(n);
    for (std::size_t a = 0; a < 3; ++a)
      if (place[a] == 0 || place[a] + 1 == cells.count[a]) enter(n);
  }
  while (!open.empty()) {
    const std::size_t cell = open.back();
    open.pop_back();
    cells.eachBeside(cell, enter);
  }
  return filled;
}

/// The square of the distance of each cell to the nearest that is marked [m^2], axis by axis
/// (Felzenszwalb and Huttenlocher).
std::vector<double> squaredDistanceTo(const Cells& cells, const Mask& marked) {
  constexpr double kNone = 1e12;
  std::vector<double> squared(cells.size());
  for (std::size_t n = 0; n < squared.size(); ++n) squared[n] = marked[n] != 0 ? 0.0 : kNone;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto length = static_cast<std::size_t>(cells.count[axis]);
    const double side = cells.side[static_cast<int>(axis)];
    const std::size_t step =
        axis == 0 ? 1 : static_cast<std::size_t>(cells.count[0] * (axis == 1 ? 1 : cells.count[1]));
    std::vector<double> line(length), border(length + 1);
    std::vector<std::size_t> parabola(length);
    for (std::size_t start = 0; start < squared.size(); ++start) {
      if (cells.placeOf(start)[axis] != 0) continue;
      for (std::size_t n = 0; n < length; ++n) line[n] = squared[start + n * step];
      // the parabolas that are lowest somewhere
      const auto place = [&](std::size_t n) { return static_cast<double>(n) * side; };
      const auto crossing = [&](std::size_t p, std::size_t q) {
        return (line[q] + place(q) * place(q) - line[p] - place(p) * place(p)) /
               (2.0 * (place(q) - place(p)));
      };
      std::size_t last = 0;
      parabola[0] = 0;
      border[0] = -std::numeric_limits<double>::infinity();
      for (std::size_t n = 1; n < length; ++n) {
        double at = crossing(parabola[last], n);
        while (last > 0 && at <= border[last]) at = crossing(parabola[--last], n);
        parabola[++last] = n;
        border[last] = at;
      }
      std::size_t now = 0;
      for (std::size_t n = 0; n < length; ++n) {
        while (now < last && border[now + 1] < place(n)) ++now;
        const double away = place(n) - place(parabola[now]);
        squared[start + n * step] = away * away + line[parabola[now]];
      }
    }
  }
  return squared;
}

/// The connected parts of a mask, each as its cells.
std::vector<std::vector<std::size_t>> partsOf(const Cells& cells, const Mask& mask) {
  std::vector<std::vector<std::size_t>> parts;
  Mask left = mask;
  for (std::size_t first = 0; first < left.size(); ++first) {
    if (left[first] == 0) continue;
    std::vector<std::size_t> part{first};
    left[first] = 0;
    for (std::size_t n = 0; n < part.size(); ++n)
      cells.eachBeside(part[n], [&](std::size_t cell) {
        if (left[cell] == 0) return;
        left[cell] = 0;
        part.push_back(cell);
      });
    parts.push_back(std::move(part));
  }
  return parts;
}

/// What lies within the convex hull of the mask in each slice across an axis.
Mask sliceHulls(const Cells& cells, const Mask& mask, std::size_t axis) {
  using Point = std::array<std::int64_t, 2>;
  const std::size_t u = axis == 0 ? 1 : 0, v = axis == 2 ? 1 : 2;
  const auto turn = [](const Point& a, const Point& b, const Point& c) {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
  };
  Mask hulls(mask.size());
  for (std::int64_t slice = 0; slice < cells.count[axis]; ++slice) {
    const auto cellAt = [&](std::int64_t x, std::int64_t y) {
      std::array<std::int64_t, 3> place{};
      place[axis] = slice;
      place[u] = x;
      place[v] = y;
      return cells.at(place[0], place[1], place[2]);
    };
    // by x, then y: the first and the last of each column are enough
    std::vector<Point> points;
    for (std::int64_t x = 0; x < cells.count[u]; ++x) {
      std::int64_t first = -1, last = -1;
      for (std::int64_t y = 0; y < cells.count[v]; ++y) {
        if (mask[cellAt(x, y)] == 0) continue;
        if (first < 0) first = y;
        last = y;
      }
      if (first >= 0) points.push_back({x, first});
      if (last > first) points.push_back({x, last});
    }
    // the hull's lower and upper chain (Andrew)
    std::vector<Point> hull;
    for (int half = 0; half < 2; ++half) {
      const std::size_t start = hull.size();
      for (const Point& point : points) {
        while (hull.size() >= start + 2 && turn(hull[hull.size() - 2], hull.back(), point) <= 0)
          hull.pop_back();
        hull.push_back(point);
      }
      if (!hull.empty()) hull.pop_back();
      std::reverse(points.begin(), points.end());
    }
    if (hull.size() < 3) continue;
    for (std::int64_t x = 0; x < cells.count[u]; ++x)
      for (std::int64_t y = 0; y < cells.count[v]; ++y) {
        bool inside = true;
        for (std::size_t n = 0; inside && n < hull.size(); ++n)
          inside = turn(hull[n], hull[(n + 1) % hull.size()], {x, y}) >= 0;
        if (inside) hulls[cellAt(x, y)] = 1;
      }
  }
  return hulls;
}

/// The cells of parts that are as large as `share` of the largest.
Mask largeParts(const Cells& cells, const Mask& mask, double share) {
  const auto parts = partsOf(cells, mask);
  std::size_t largest = 0;
  for (const auto& part : parts) largest = std::max(largest, part.size());
  Mask large(mask.size());
  for (const auto& part : parts)
    if (static_cast<double>(part.size()) >= share * static_cast<double>(largest))
      for (const std::size_t cell : part) large[cell] = 1;
  return large;
}

std::int64_t countOf(const Mask& mask) {
  return std::accumulate(mask.begin(), mask.end(), std::int64_t{0});
}

/// A full body without what hangs on it by a bridge that is thinner than twice kThin. A hollow one,
/// as a skull without a brain, has walls as thin as a holder's, and stays as it is.
Mask withoutThinParts(const Cells& cells, const Mask& body) {
  const Mask filled = withCavities(cells, body);
  Mask outside(filled.size());
  for (std::size_t n = 0; n < filled.size(); ++n) outside[n] = filled[n] == 0;
  const std::vector<double> depth = squaredDistanceTo(cells, outside);
  Mask deep(filled.size());
  for (std::size_t n = 0; n < deep.size(); ++n) deep[n] = depth[n] > kThin * kThin;
  const Mask core = largeParts(cells, deep, kOtherBody);
  if (static_cast<double>(countOf(core)) < kFull * static_cast<double>(countOf(filled)))
    return filled;
  // grown back
  const double grown = kThin + cells.side.maxCoeff();
  const std::vector<double> from_core = squaredDistanceTo(cells, core);
  Mask opened(filled.size());
  for (std::size_t n = 0; n < opened.size(); ++n)
    opened[n] = filled[n] != 0 && from_core[n] <= grown * grown;
  return opened;
}

/// The cells of the patient, and those around: what is solid elsewhere goes. `axis`: the one that
/// runs most along the patient.
Mask patientCells(const Cells& cells, const Mask& solid, std::size_t axis) {
  const Mask body = withoutThinParts(cells, largeParts(cells, solid, 1.0));
  // of the rest, what lies mostly within the outline of the body in the slices, and small parts on
  // the body
  const Mask hulls = sliceHulls(cells, body, axis);
  const std::vector<double> from_body = squaredDistanceTo(cells, body);
  Mask rest(body.size()), patient = body, goes(body.size());
  for (std::size_t n = 0; n < body.size(); ++n) rest[n] = solid[n] != 0 && body[n] == 0;
  for (const auto& part : partsOf(cells, rest)) {
    std::array<std::int64_t, 3> low = cells.count, high{};
    bool touches = false;
    double farthest = 0.0;
    std::size_t within = 0;
    for (const std::size_t cell : part) {
      const auto place = cells.placeOf(cell);
      for (std::size_t a = 0; a < 3; ++a) {
        low[a] = std::min(low[a], place[a]);
        high[a] = std::max(high[a], place[a] + 1);
      }
      cells.eachBeside(cell, [&](std::size_t beside) { touches = touches || body[beside] != 0; });
      farthest = std::max(farthest, from_body[cell]);
      within += hulls[cell];
    }
    double longest = 0.0;
    for (std::size_t a = 0; a < 3; ++a)
      longest = std::max(longest,
                         static_cast<double>(high[a] - low[a]) * cells.side[static_cast<int>(a)]);
    const bool small =
        touches && longest <= kLongestPart && farthest <= kFarthestPart * kFarthestPart;
    const bool stays = small || 2 * within > part.size();
    for (const std::size_t cell : part) (stays ? patient : goes)[cell] = 1;
  }
  // the skin: what is about the patient and no part of what goes
  const std::vector<double> from_patient = squaredDistanceTo(cells, patient);
  const double skin = 1.01 * cells.side.maxCoeff();
  for (std::size_t n = 0; n < patient.size(); ++n)
    if (goes[n] == 0 && from_patient[n] <= skin * skin) patient[n] = 1;
  // a thin wall of bone within the body is in no cell that is mostly solid
  for (std::size_t n = 0; n < patient.size(); ++n)
    if (goes[n] == 0 && hulls[n] != 0) patient[n] = 1;
  return patient;
}

tl::unexpected<haptics::Error> noHolder() {
  return tl::unexpected(
      haptics::Error{haptics::Error::Kind::Unsupported, {"edit-no-holder", {}}, "nothing"});
}

}  // namespace

MadeOperator holderOperator(const haptics::Volume& volume, const RemoveHolder& edit,
                            const EditWatch& watch) {
  const haptics::VoxelBox box = volume.bounds();
  const double tissue = volume.unit == "HU" ? kTissue : betweenAirAndMatter(volume, box);
  const auto matter = solidOf(volume, box, tissue, {watch, 0.0, 0.1});
  if (!matter) return tl::unexpected(editCancelled());
  const Cells cells = cellsOf(volume, box);
  int axis = 0;  // the one along the patient's head and feet
  volume.grid.direction.row(2).cwiseAbs().maxCoeff(&axis);
  const Mask patient =
      patientCells(cells, solidCells(cells, *matter, box), static_cast<std::size_t>(axis));
  // down to tissue, so that a table does not come back with the skin
  const double level = std::min(edit.isovalue, tissue);
  auto solid = solidOf(volume, box, level, {watch, 0.4, 0.5});
  if (!solid) return tl::unexpected(editCancelled());
  VoxelBits gone{volume.grid.dims};
  std::int64_t voxels = 0;
  for (std::int64_t k = box.first[2]; k < box.end[2]; ++k)
    for (std::int64_t j = box.first[1]; j < box.end[1]; ++j) {
      const std::size_t row =
          cells.at(0, (j - box.first[1]) / cells.voxels[1], (k - box.first[2]) / cells.voxels[2]);
      std::uint64_t* out = gone.row(j, k);
      eachRun(solid->row(j, k), solid->wordsInRow(), [&](std::int64_t first, std::int64_t end) {
        for (std::int64_t i = first; i < end;) {
          const std::int64_t cell = (i - box.first[0]) / cells.voxels[0];
          const std::int64_t until = std::min(end, box.first[0] + (cell + 1) * cells.voxels[0]);
          if (patient[row + static_cast<std::size_t>(cell)] == 0) {
            setBits(out, i, until);
            voxels += until - i;
          }
          i = until;
        }
      });
    }
  if (static_cast<double>(voxels) * volume.grid.spacing.prod() < kLeastHolder) return noHolder();
  for (std::size_t w = 0; w < gone.words().size(); ++w) solid->words()[w] &= ~gone.words()[w];
  return std::make_unique<PieceOperator>(std::move(gone), std::move(*solid), box, edit.isovalue);
}

}  // namespace datasets
