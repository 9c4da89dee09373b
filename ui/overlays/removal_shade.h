// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QImage>
#include <cstdint>
#include <memory>
#include <vector>

#include "ui/overlays/projection.h"

namespace ui {

/// A set of voxels to be shown over the views. Filled and finished on any thread, then not changed.
class MarkedVoxels {
 public:
  explicit MarkedVoxels(const haptics::Grid& grid);

  /// Marks `count` voxels along i; several times at most once each.
  void add(std::int64_t i, std::int64_t j, std::int64_t k, std::int64_t count);
  /// Finds the points of its surface. Must be called once, after the last add().
  void finish();

  const haptics::Grid& grid() const { return grid_; }
  bool has(std::int64_t i, std::int64_t j, std::int64_t k) const {
    const auto n = static_cast<std::size_t>((k * grid_.dims[1] + j) * grid_.dims[0] + i);
    return ((bits_[n >> 6] >> (n & 63)) & 1U) != 0;
  }
  /// Points of the surface of the set, for a picture: mm of W.
  const std::vector<Eigen::Vector3f>& surface() const { return surface_; }
  double cell_mm() const { return cell_mm_; }  ///< the surface's points are this far apart

 private:
  haptics::Grid grid_;
  std::vector<std::uint64_t> bits_;
  std::int64_t factor_ = 1;  ///< voxels along a cell
  std::array<std::int64_t, 3> cells_{};
  std::vector<std::uint32_t> filled_;  ///< voxels of each cell
  std::vector<Eigen::Vector3f> surface_;
  double cell_mm_ = 1.0;
};

/// What is to happen to a set of voxels.
enum class Fate {
  Chosen,  ///< nothing yet: outlined
  Goes,    ///< outlined and hatched
  Stays    ///< outlined, and hatched is all that lies beside it
};

/// Shows a set of voxels over slices and the 3-D view. The anatomy is seen through it.
class RemovalShade : public Overlay {
  Q_OBJECT
 public:
  using Overlay::Overlay;

  /// Null: nothing.
  void show(std::shared_ptr<const MarkedVoxels> voxels, Fate fate = Fate::Goes);
  Fate fate() const { return fate_; }
  bool isShown() const { return voxels_ != nullptr; }
  void paint(QPainter& painter, const ViewGeometry& view) const override;

 private:
  // the pixels of the set, 2, and those beside it that are of the volume, 1
  QImage sliceOf(const Projection& camera, QSize size) const;
  QImage bodyOf(const Projection& camera, QSize size) const;
  QImage shaded(const QImage& parts) const;

  std::shared_ptr<const MarkedVoxels> voxels_;
  Fate fate_ = Fate::Goes;
  mutable QImage body_;  ///< the last picture of the body, and its camera
  mutable Projection body_camera_;
};

}  // namespace ui
