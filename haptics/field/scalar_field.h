// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <memory>

#include "haptics/core/budget.h"
#include "haptics/core/geometry.h"
#include "haptics/core/realtime.h"
#include "haptics/core/volume.h"
#include "haptics/field/field_kind.h"
#include "haptics/field/lanes.h"
#include "haptics/field/max_pyramid.h"

namespace haptics {

struct SplineCell;

/// The eight corner values of one cell, and its index. Inside it the field is trilinear.
struct Cell {
  /// Index of its lowest corner. One below the box that exists is the ring outside it, where F
  /// falls to the background.
  std::array<std::int64_t, 3> at{};
  std::array<double, 8> corner{};  ///< bit 0 set: i + 1, bit 1: j + 1, bit 2: k + 1

  double value(const Vec3& u) const HAPTICS_RT;   ///< at index coordinates u within the cell
  Vec3 gradient(const Vec3& u) const HAPTICS_RT;  ///< per index step
};

/// A field at a place.
struct FieldSample {
  double value = 0.0;
  Vec3 gradient_W = Vec3::Zero();  ///< gradient of the field itself, per metre
};

/// The field over the unmodified voxels: trilinear ([Chan 2011], 2.2), or the cubic B-spline
/// that has them as coefficients (haptics/README.md, "Fields"). Beyond the grid, or the box that it
/// is cropped to, it falls to the background (the least voxel) within one voxel, so that cut faces
/// are solid.
///
/// u are index coordinates: voxel (i, j, k) has its centre at u = (i, j, k).
class ScalarField {
 public:
  explicit ScalarField(std::shared_ptr<const Volume> volume, FieldKind kind = FieldKind::Trilinear);
  /// With an existing pyramid of this volume and kind.
  ScalarField(std::shared_ptr<const Volume> volume, FieldKind kind, MaxPyramid pyramid);

  FieldKind kind() const HAPTICS_RT { return kind_; }

  Vec3 indexOf(const Vec3& p_W) const HAPTICS_RT { return A_VW_ * p_W + b_V_; }
  /// A motion or direction in W as index steps.
  Vec3 indexStepOf(const Vec3& d_W) const HAPTICS_RT { return A_VW_ * d_W; }
  /// A gradient per index step as one per metre in W.
  Vec3 worldGradient(const Vec3& per_index) const HAPTICS_RT { return A_VW_t_ * per_index; }

  double value(const Vec3& u) const HAPTICS_RT;
  FieldSample sample(const Vec3& u) const HAPTICS_RT;
  /// The fraction of the segment a→b (index coordinates) at which the field first reaches `level`;
  /// 2 if it stays below. The result is never too late, and too early by at most `tolerance`.
  /// Exact: along a segment within a cell the field is a polynomial (cubic, or of degree 9), whose
  /// first root is isolated in Bernstein form.
  double firstReach(const Vec3& a, const Vec3& b, double level, double tolerance,
                    Budget& budget) const HAPTICS_RT;
  static constexpr int kSplineWork = 12;  ///< work of 64 voxels, their weights and sum
  /// Units of work of one value or sample, fetched alone (core/budget.h).
  int work() const HAPTICS_RT { return kind_ == FieldKind::Trilinear ? kCellWork : kSplineWork; }
  /// The same for a place, or a cell of a chord, among sixteen.
  struct LanesWork {
    int value, slopes, central_slopes, cell;
  };
  LanesWork lanesWork() const HAPTICS_RT {
    return kind_ == FieldKind::Trilinear ? LanesWork{1, 1, 3, 2} : LanesWork{2, 3, 8, 6};
  }

  /// The voxels of a cell, and their trilinear field whatever the kind.
  Cell cellAt(const std::array<std::int64_t, 3>& at) const HAPTICS_RT;
  Cell cellAround(const Vec3& u) const HAPTICS_RT;

  /// Central differences over one voxel, divided by 2 delta on each axis [per metre, W]:
  /// [Chan 2011], (1), with the division that the paper leaves out.
  Vec3 centralGradient(const Vec3& u) const HAPTICS_RT;
  /// Gradient of the cubic B-spline with the voxels as coefficients, whatever the kind
  /// [per metre, W]. It averages 64 voxels, so noise and facets have little weight.
  Vec3 splineGradient(const Vec3& u) const HAPTICS_RT;

  // Sixteen places at a time. The scalar code processes the lanes that these functions leave out
  // (haptics/MEASURED.md, "Lanes").

  /// Points of a tool at this pose, from the tool frame to index coordinates.
  lanes::Affine affine(const Pose& X_WP) const HAPTICS_RT;
  /// As lanes::clear.
  void clear(const lanes::Chords& chords, int n, lanes::Numbers& until,
             std::int64_t& cells) const HAPTICS_RT;
  /// F, its own gradient, and if asked for central differences, per metre in W.
  void slopes(const lanes::Places& u, int n, bool central, lanes::Slopes& found) const HAPTICS_RT;
  const lanes::Lattice& lattice() const HAPTICS_RT { return lattice_; }

  const MaxPyramid& pyramid() const HAPTICS_RT { return pyramid_; }
  /// For whoever lowers voxels of this field's volume (scene/carved_scene.h).
  MaxPyramid& pyramid() HAPTICS_RT { return pyramid_; }
  const Volume& volume() const HAPTICS_RT { return *volume_; }
  const VoxelBox& bounds() const HAPTICS_RT { return bounds_; }
  double voxel() const HAPTICS_RT { return voxel_; }  ///< m: the smallest voxel side
  /// The margin that legality keeps from the isovalue: a billionth of the usual range. The rounding
  /// of index coordinates (some 1e-13) changes a value by far less.
  double roundingMargin() const HAPTICS_RT { return rounding_margin_; }

 private:
  static constexpr int kCellWork = 4;            ///< work of 8 voxels, fetched alone
  static constexpr int kSplineSegmentWork = 36;  ///< work of the polynomial along a segment

  SplineCell splineCellAround(const Vec3& u) const HAPTICS_RT;

  std::shared_ptr<const Volume> volume_;
  VoxelBox bounds_;  ///< the voxels that exist
  FieldKind kind_;
  MaxPyramid pyramid_;
  lanes::Lattice lattice_;
  Mat3 A_VW_;
  Vec3 b_V_;
  double voxel_;
  double rounding_margin_;

 protected:
  Mat3 A_VW_t_;  ///< maps gradients to W; a test derives a field with a wrong one
};

}  // namespace haptics
