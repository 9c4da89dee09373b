// SPDX-License-Identifier: BSD-3-Clause
#include "ui/props/structures.h"

#include <QStringList>
#include <algorithm>
#include <array>
#include <bitset>
#include <cmath>
#include <optional>

namespace ui {
namespace {

constexpr double kFill = 0.45;  // of an opaque structure's fill: the anatomy is seen through it
constexpr qsizetype kMostNames = 3, kLongestShown = 40;  // under the pointer

/// The place of a voxel in memory; none: it lies beyond the grid.
std::optional<std::size_t> voxelAt(const haptics::Grid& grid, const Eigen::Vector3d& index) {
  std::size_t place = 0;
  for (const Eigen::Index a : {2, 1, 0}) {
    const auto dim = grid.dims[static_cast<std::size_t>(a)];
    const double nearest = std::floor(index[a] + 0.5);
    if (!(nearest >= 0.0 && nearest < static_cast<double>(dim))) return {};
    place = place * static_cast<std::size_t>(dim) + static_cast<std::size_t>(nearest);
  }
  return place;
}

}  // namespace

std::uint8_t StructureMap::codeAt(const Eigen::Vector3d& p_W_mm) const {
  const auto voxel = voxelAt(grid, grid.indexOf(p_W_mm / kMmPerM));
  return voxel ? codes[static_cast<std::ptrdiff_t>(*voxel)] : std::uint8_t{0};
}

QString Structures::namesAt(const Eigen::Vector3d& p_W_mm) const {
  return map ? namesOf(map->codeAt(p_W_mm)) : QString{};
}

QString Structures::namesOf(std::uint8_t code) const {
  QStringList names;
  for (const std::uint8_t number : map->sets[code]) {
    const QString& name = looks[number].name;
    names << (name.size() > kLongestShown ? name.first(kLongestShown) + QChar(0x2026) : name);
  }
  if (names.size() > kMostNames) names = names.first(kMostNames) << QStringLiteral("…");
  return names.join(QStringLiteral(", "));
}

bool Structures::isShown(std::uint8_t code) const {
  return std::ranges::any_of(map->sets[code],
                             [&](std::uint8_t number) { return looks[number].visible; });
}

void StructureCut::cut(const StructureMap& map, const PlaneAxes& axes,
                       const Eigen::Vector3d& centre_W_mm, QSize size, double mm_per_pixel) {
  size_ = size;
  const int w = size.width(), h = size.height();
  codes_.assign(static_cast<std::size_t>(w) * static_cast<std::size_t>(h), 0);
  const haptics::Grid& grid = map.grid;
  const Eigen::Vector3d step = (grid.direction.transpose() * axes.right * (mm_per_pixel / kMmPerM))
                                   .cwiseQuotient(grid.spacing);
  std::uint8_t* code = codes_.data();
  for (int y = 0; y < h; ++y) {
    const Eigen::Vector3d first =
        grid.indexOf((centre_W_mm + (axes.up * (0.5 * (h - 1) - y) - axes.right * (0.5 * (w - 1))) *
                                        mm_per_pixel) /
                     kMmPerM);
    for (int x = 0; x < w; ++x, ++code)
      if (const auto voxel = voxelAt(grid, first + step * x))
        *code = map.codes[static_cast<std::ptrdiff_t>(*voxel)];
  }
}

QImage StructureCut::picture(const Structures& shown, int line) const {
  QImage image(size_, QImage::Format_ARGB32_Premultiplied);
  image.fill(Qt::transparent);
  // of each code: which of its structures are shown, the last of them above the others
  std::vector<std::bitset<256>> shown_in(shown.map->sets.size());
  std::vector<QRgb> fills(shown_in.size(), 0);
  for (std::size_t code = 0; code < shown_in.size(); ++code)
    for (const std::uint8_t number : shown.map->sets[code]) {
      const StructureLook& look = shown.looks[number];
      if (!look.visible) continue;
      shown_in[code].set(number);
      QColor colour = look.colour;
      colour.setAlphaF(static_cast<float>(kFill * look.opacity));
      if (shown.filled) fills[code] = qPremultiply(colour.rgba());
    }
  const int w = size_.width(), h = size_.height();
  const auto at = [&](int x, int y) {
    return codes_[static_cast<std::size_t>(std::clamp(y, 0, h - 1)) * static_cast<std::size_t>(w) +
                  static_cast<std::size_t>(std::clamp(x, 0, w - 1))];
  };
  for (int y = 0; y < h; ++y) {
    auto* out = reinterpret_cast<QRgb*>(image.scanLine(y));
    for (int x = 0; x < w; ++x) {
      const std::uint8_t code = at(x, y);
      if (shown_in[code].none()) continue;
      out[x] = fills[code];
      // what ends within the width of the line has its outline here
      std::bitset<256> ends;
      for (int by = 1; by <= line; ++by)
        for (const std::uint8_t beside :
             {at(x - by, y), at(x + by, y), at(x, y - by), at(x, y + by)})
          if (beside != code) ends |= shown_in[code] & ~shown_in[beside];
      if (ends.none()) continue;
      for (const std::uint8_t number : shown.map->sets[code])
        if (ends.test(number)) out[x] = shown.looks[number].colour.rgb();
    }
  }
  return image;
}

}  // namespace ui
