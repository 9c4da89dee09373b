// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/surface/surface.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "datasets/edits/pieces.h"
#include "datasets/surface/cell_triangles.h"
#include "haptics/core/geometry.h"

namespace datasets {
namespace {

using haptics::Vec3;

/// No corner is nearer to a voxel's centre than this, in voxels. Around a voxel that has the
/// isovalue itself corners would fall together, and triangles would have no area.
constexpr double kLeastFraction = 1e-3;
constexpr double kOuterFace = 0.5;  ///< voxels from a centre

/// One layer of voxels at a time, with a rim of voxels that are not solid.
class Walk {
 public:
  Walk(const haptics::Volume& volume, double isovalue, const VoxelBits* part, SurfaceFrame frame,
       SurfaceReceiver& receiver)
      : volume_{volume}, isovalue_{isovalue}, part_{part}, receiver_{receiver} {
    const haptics::VoxelBox box = volume.bounds();
    first_ = box.first;
    for (std::size_t a = 0; a < 3; ++a) size_[a] = box.end[a] - box.first[a] + 2;
    const auto places = static_cast<std::size_t>(size_[0] * size_[1]);
    for (Layer& layer : layers_) {
      layer.value.resize(places);
      layer.solid.resize(places);
      layer.some.resize(static_cast<std::size_t>(size_[1]));
      layer.along_i.resize(places);
      layer.along_j.resize(places);
    }
    along_k_.resize(places);
    outside_ = std::min(volume.least, isovalue - 1.0);
    const double mm = 1e3;
    const haptics::Grid& grid = volume.grid;
    linear_ = grid.direction * grid.spacing.asDiagonal() * mm;
    origin_ = grid.origin * mm;
    if (frame == SurfaceFrame::Ras) {
      linear_.topRows<2>() *= -1.0;
      origin_.head<2>() *= -1.0;
    }
    mirrored_ = linear_.determinant() < 0.0;
  }

  bool go(const EditWatch& watch) {
    for (std::int64_t s = 0; s < size_[2]; ++s) {
      if (watch.cancel != nullptr && watch.cancel->load()) return false;
      if (watch.advanced) watch.advanced(static_cast<double>(s) / static_cast<double>(size_[2]));
      Layer& below = layers_[0];
      Layer& here = layers_[1];
      std::swap(below, here);
      load(s, here);
      // corners of the layer below are needed once more, those before it never again
      recent_.erase(recent_.begin(), recent_.begin() + (layer_begin_ - recent_begin_));
      recent_begin_ = layer_begin_;
      layer_begin_ = cornerCount();
      cross(s, here);
      const std::int64_t layer_end = cornerCount();
      if (s > 0) {
        cross(s, below, here);
        for (std::int64_t y = 0; y + 1 < size_[1]; ++y) cells(y, below, here);
      }
      receiver_.layer(layer_begin_, layer_end);
    }
    return true;
  }

 private:
  struct Layer {
    std::vector<double> value;
    std::vector<std::uint8_t> solid;
    std::vector<std::uint8_t> some;  ///< of each row: whether a voxel is solid; its rim is not
    std::vector<std::uint32_t> along_i, along_j;  ///< corners on edges, low bits of their number
    bool any = false;
  };

  std::size_t at(std::int64_t x, std::int64_t y) const {
    return static_cast<std::size_t>(y * size_[0] + x);
  }
  std::int64_t cornerCount() const {
    return recent_begin_ + static_cast<std::int64_t>(recent_.size());
  }

  void load(std::int64_t s, Layer& layer) {
    std::ranges::fill(layer.value, outside_);
    std::ranges::fill(layer.solid, std::uint8_t{0});
    std::ranges::fill(layer.some, std::uint8_t{0});
    layer.any = false;
    if (s == 0 || s + 1 == size_[2]) return;
    const auto& dims = volume_.grid.dims;
    const std::int64_t k = first_[2] + s - 1;
    visitVoxels(volume_.type, volume_.voxels.get(), [&](const auto* voxels) {
      for (std::int64_t y = 1; y + 1 < size_[1]; ++y) {
        const std::int64_t j = first_[1] + y - 1;
        const auto* row = voxels + (k * dims[1] + j) * dims[0] + first_[0];
        double* value = layer.value.data() + at(1, y);
        std::uint8_t* solid = layer.solid.data() + at(1, y);
        std::uint8_t any = 0;
        for (std::int64_t x = 0; x < size_[0] - 2; ++x) {
          value[x] = static_cast<double>(row[x]);
          solid[x] = value[x] >= isovalue_;
          any |= solid[x];
        }
        if (any != 0 && part_ != nullptr)
          for (std::int64_t x = 0; x < size_[0] - 2; ++x)
            solid[x] = solid[x] & static_cast<std::uint8_t>(part_->at(first_[0] + x, j, k));
        layer.some[static_cast<std::size_t>(y)] = any;
        layer.any = layer.any || any != 0;
      }
    });
  }

  /// The corner between two neighbours, `along` an axis, of which one is solid.
  std::uint32_t cornerAt(std::int64_t x, std::int64_t y, std::int64_t s, int along, double a,
                         double b) {
    Vec3 index{static_cast<double>(first_[0] + x - 1), static_cast<double>(first_[1] + y - 1),
               static_cast<double>(first_[2] + s - 1)};
    const std::int64_t place = along == 0 ? x : along == 1 ? y : s;
    const bool at_border = place == 0 || place + 2 == size_[static_cast<std::size_t>(along)];
    index[along] +=
        at_border ? kOuterFace
                  : std::clamp((isovalue_ - a) / (b - a), kLeastFraction, 1.0 - kLeastFraction);
    return add(index);
  }

  std::uint32_t add(const Vec3& index) {
    const auto number = static_cast<std::uint32_t>(cornerCount());
    const Vec3 p = origin_ + linear_ * index;
    recent_.push_back(
        {index, {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())}});
    receiver_.corner(recent_.back().point);
    return number;
  }

  /// The corners within a layer.
  void cross(std::int64_t s, Layer& here) {
    if (!here.any) return;
    for (std::int64_t y = 0; y < size_[1]; ++y) {
      const auto row = static_cast<std::size_t>(y);
      const bool some = here.some[row] != 0;
      if (some)
        for (std::int64_t x = 0; x + 1 < size_[0]; ++x)
          if (const std::size_t n = at(x, y); here.solid[n] != here.solid[n + 1])
            here.along_i[n] = cornerAt(x, y, s, 0, here.value[n], here.value[n + 1]);
      if (y + 1 == size_[1] || (!some && here.some[row + 1] == 0)) continue;
      const auto width = static_cast<std::size_t>(size_[0]);
      for (std::int64_t x = 0; x < size_[0]; ++x)
        if (const std::size_t n = at(x, y); here.solid[n] != here.solid[n + width])
          here.along_j[n] = cornerAt(x, y, s, 1, here.value[n], here.value[n + width]);
    }
  }

  /// The corners between two layers.
  void cross(std::int64_t s, const Layer& below, const Layer& here) {
    if (!below.any && !here.any) return;
    for (std::int64_t y = 0; y < size_[1]; ++y) {
      if (below.some[static_cast<std::size_t>(y)] == 0 &&
          here.some[static_cast<std::size_t>(y)] == 0)
        continue;
      for (std::int64_t x = 0; x < size_[0]; ++x)
        if (const std::size_t n = at(x, y); below.solid[n] != here.solid[n])
          along_k_[n] = cornerAt(x, y, s - 1, 2, below.value[n], here.value[n]);
    }
  }

  void cells(std::int64_t y, const Layer& below, const Layer& here) {
    const auto row = static_cast<std::size_t>(y);
    if (below.some[row] + below.some[row + 1] + here.some[row] + here.some[row + 1] == 0) return;
    const auto width = static_cast<std::size_t>(size_[0]);
    // the corners of a cell with x = 1, at bits 1, 3, 5 and 7
    const auto rightSide = [&](std::size_t n) {
      return static_cast<unsigned>(below.solid[n] << 1 | below.solid[n + width] << 3 |
                                   here.solid[n] << 5 | here.solid[n + width] << 7);
    };
    unsigned left = 0;  // the rim
    for (std::int64_t x = 0; x + 1 < size_[0]; ++x) {
      const std::size_t n = at(x, y);
      const unsigned right = rightSide(n + 1);
      const unsigned solid = left >> 1 | right;
      left = right;
      if (solid != 0 && solid != 255) cell(n, solid, below, here);
    }
  }

  void cell(std::size_t n, unsigned solid, const Layer& below, const Layer& here) {
    const auto width = static_cast<std::size_t>(size_[0]);
    const auto over = [&](int c) {
      const Layer& layer = (c & 4) != 0 ? here : below;
      return layer.value[n + (c & 1) + ((c & 2) != 0 ? width : 0)] - isovalue_;
    };
    unsigned joined = 0;
    for (std::size_t f = 0; f < kCellFaces.size(); ++f) {
      const auto& c = kCellFaces[f];
      const auto isSolid = [&](int m) { return (solid >> c[m] & 1) != 0; };
      if (isSolid(0) != isSolid(2) || isSolid(1) != isSolid(3) || isSolid(0) == isSolid(1))
        continue;
      const int one = isSolid(0) ? 0 : 1;
      // the saddle of the field on the face is solid, as in Pieces
      if (over(c[one]) * over(c[one + 2]) >= over(c[1 - one]) * over(c[3 - one])) joined |= 1U << f;
    }
    const CellTriangles& cell = cases_.of(solid, joined);
    std::array<std::uint32_t, 16> corner{};
    for (std::size_t e = 0; e < 12; ++e) {
      const std::size_t from = static_cast<std::size_t>(kCellEdges[e].from);
      const std::size_t place = n + (from & 1) + ((from & 2) != 0 ? width : 0);
      const Layer& layer = (from & 4) != 0 ? here : below;
      corner[e] = e < 4 ? layer.along_i[place] : e < 8 ? layer.along_j[place] : along_k_[place];
    }
    for (std::size_t m = 0; m < cell.middles.size(); ++m) {
      Vec3 middle = Vec3::Zero();
      for (const std::uint8_t e : cell.middles[m]) middle += recentOf(corner[e]).index;
      corner[12 + m] = add(middle / static_cast<double>(cell.middles[m].size()));
    }
    for (const auto& triangle : cell.triangles) {
      std::array<std::uint32_t, 3> c{corner[triangle[0]], corner[triangle[1]], corner[triangle[2]]};
      if (mirrored_) std::swap(c[1], c[2]);
      receiver_.triangle({numberOf(c[0]), numberOf(c[1]), numberOf(c[2])},
                         {recentOf(c[0]).point, recentOf(c[1]).point, recentOf(c[2]).point});
    }
  }

  struct Corner {
    Vec3 index;
    SurfacePoint point;
  };
  std::uint32_t placeOf(std::uint32_t low) const {
    return low - static_cast<std::uint32_t>(recent_begin_);
  }
  const Corner& recentOf(std::uint32_t low) const { return recent_[placeOf(low)]; }
  std::int64_t numberOf(std::uint32_t low) const { return recent_begin_ + placeOf(low); }

  const haptics::Volume& volume_;
  double isovalue_;
  const VoxelBits* part_;
  SurfaceReceiver& receiver_;
  std::array<std::int64_t, 3> first_{}, size_{};  ///< size with the rim
  double outside_ = 0.0;
  haptics::Mat3 linear_;  ///< index to mm of the frame
  Vec3 origin_;
  bool mirrored_ = false;
  std::array<Layer, 2> layers_;
  std::vector<std::uint32_t> along_k_;
  std::vector<Corner> recent_;  ///< corners of this layer and the one below
  std::int64_t recent_begin_ = 0, layer_begin_ = 0;
  CellCases cases_;
};

struct Count : SurfaceReceiver {
  static constexpr std::int64_t kSample = 61;
  void corner(const SurfacePoint& point) override {
    if (corners++ % kSample != 0) return;
    ++sampled;
    std::array<char, 32> number{};
    for (const float x : point)
      letters += std::to_chars(number.data(), number.data() + number.size(), x).ptr - number.data();
  }
  void triangle(const std::array<std::int64_t, 3>&, const std::array<SurfacePoint, 3>&) override {
    ++triangles;
  }
  std::int64_t corners = 0, triangles = 0;
  std::int64_t sampled = 0, letters = 0;  ///< corners, and the length of their numbers as text
};

/// The voxels of the largest connected part; none: cancelled.
std::optional<VoxelBits> largestPart(const haptics::Volume& volume, double isovalue,
                                     const EditWatch& watch) {
  const auto solid = solidOf(volume, volume.bounds(), isovalue, {watch, 0.0, 0.1});
  if (!solid) return {};
  const auto pieces = Pieces::of(volume, *solid, isovalue, true, {watch, 0.1, 0.6});
  if (!pieces) return {};
  std::vector<bool> chosen(pieces->count(), false);
  std::uint32_t largest = 0;
  for (std::uint32_t n = 1; n < pieces->count(); ++n)
    if (pieces->voxelsOf(n) > pieces->voxelsOf(largest)) largest = n;
  if (!chosen.empty()) chosen[largest] = true;
  VoxelBits part{volume.grid.dims};
  pieces->mark(chosen, part);
  return part;
}

std::string shown(double value) {
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::general, 6);
  return {text, end.ptr};
}

}  // namespace

EditWatch partOf(const EditWatch& watch, double from, double until) {
  if (!watch.advanced) return watch;
  return {watch.cancel,
          [&watch, from, until](double done) { watch.advanced(from + (until - from) * done); }};
}

haptics::Expected<Surface> Surface::of(std::shared_ptr<const haptics::Volume> volume,
                                       double isovalue, bool largest, const EditWatch& watch) {
  const std::string least = shown(volume->least), greatest = shown(volume->greatest);
  const auto refusal = [](haptics::Message message) {
    return tl::unexpected(
        haptics::Error{haptics::Error::Kind::Unsupported, std::move(message), "nothing"});
  };
  if (isovalue <= volume->least)
    return refusal({"surface-all-solid", {shown(isovalue), least, greatest}});
  Surface surface;
  surface.volume_ = volume;
  surface.isovalue_ = isovalue;
  if (largest) {
    surface.part_ = largestPart(*surface.volume_, isovalue, watch);
    if (!surface.part_) return tl::unexpected(editCancelled());
  }
  Count count;
  if (!surface.walk(SurfaceFrame::Lps, count, partOf(watch, largest ? 0.6 : 0.0, 1.0)))
    return tl::unexpected(editCancelled());
  surface.corners_ = count.corners;
  surface.triangles_ = count.triangles;
  if (count.triangles == 0) return refusal({"surface-none", {shown(isovalue), least, greatest}});
  surface.corner_letters_ = double(count.letters) / double(count.sampled);
  return surface;
}

bool Surface::walk(SurfaceFrame frame, SurfaceReceiver& receiver, const EditWatch& watch) const {
  return Walk{*volume_, isovalue_, part_ ? &*part_ : nullptr, frame, receiver}.go(watch);
}

}  // namespace datasets
