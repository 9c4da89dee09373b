// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "datasets/edits/operators.h"
#include "haptics/carving/wall.h"

namespace datasets {
namespace {

/// The half-space to which a plane's normal points, in index coordinates.
class PlaneOperator final : public haptics::RowCutter {
 public:
  PlaneOperator(const haptics::Volume& volume, const PlaneCut& cut)
      : wall_{volume.least, volume.greatest, cut.isovalue} {
    box = volume.bounds();
    const haptics::Grid& grid = volume.grid;
    const haptics::Vec3 normal_V =
        grid.spacing.cwiseProduct(grid.direction.transpose() * cut.normal_W);
    normal_V_ = normal_V.normalized();
    at_ = normal_V_.dot(grid.indexOf(cut.point_W));
  }
  void cutRow(std::int64_t j, std::int64_t k, haptics::RowCut& cut) const override {
    const double at_row =
        at_ - normal_V_.y() * static_cast<double>(j) - normal_V_.z() * static_cast<double>(k);
    wall_.cutLinear(box.first[0], box.end[0], at_row, -normal_V_.x(), cut);
  }

 private:
  haptics::WallProfile wall_;
  haptics::Vec3 normal_V_ = haptics::Vec3::Zero();  // unit, in index steps
  double at_ = 0.0;
};

}  // namespace

MadeOperator planeOperator(const haptics::Volume& volume, const PlaneCut& cut) {
  return std::make_unique<PlaneOperator>(volume, cut);
}

}  // namespace datasets
