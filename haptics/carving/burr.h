// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>

#include "haptics/carving/burr_lanes.h"
#include "haptics/carving/material.h"
#include "haptics/carving/tissues.h"
#include "haptics/carving/wall.h"
#include "haptics/core/geometry.h"
#include "haptics/core/realtime.h"
#include "haptics/core/volume.h"

namespace haptics {

/// A ball that cuts on its way from one place to another, and the isovalue at which the wall stands
/// that it leaves.
struct BurrCut {
  Vec3 from_W = Vec3::Zero(), to_W = Vec3::Zero();  ///< m, W: of the ball's centre
  double radius = 0.0;                              ///< m, above 0
  double isovalue = 0.0;

  bool operator==(const BurrCut&) const = default;
};

inline constexpr double kSmallestBurr = 1e-4, kLargestBurr = 0.02;  ///< m: radius
/// Teeth of a burr; cutting burrs have some 6 to 12.
inline constexpr int kBurrTeeth = 8;
/// Whether a burr makes such a cut: finite, in reach of a scan, of a burr that there is, on a way
/// shorter than its radius. A cut that was read from a file may be another.
bool isPossible(const BurrCut& cut);

/// How much of a voxel is solid, by its value: from 0 to 1 along the line of the wall's profile, so
/// that a wall counts where it lies. Straight about one half and rounded to both sides: a sum over
/// the voxels of a lattice is then nearly the volume, wherever the ball lies between them.
struct PartOfVoxel {
  static constexpr double kStraight = 0.1875;  ///< voxels from the wall
  static constexpr double kRounded = 0.625;    ///< voxels beyond, to 0 or 1

  /// Around a cut with such a burr.
  PartOfVoxel(const Volume& volume, const BurrCut& cut) HAPTICS_RT;
  double operator()(double value) const {
    const double beyond = at_wall + (value - isovalue) * per_value, size = std::abs(beyond);
    const double round = std::clamp(size - kStraight, 0.0, kRounded);
    const double part = std::min(size, kStraight) + round - round * round / (2.0 * kRounded);
    return 0.5 + std::copysign(part, beyond);
  }

  double isovalue, per_value;
  double at_wall;  ///< voxels: by which the wall lies farther out for the count
};

/// What a cut took away.
struct Removed {
  /// m3 within the isosurface. A voxel counts in part by its value, so that a wall counts where it
  /// lies and not where voxels are.
  double volume = 0.0;
  double energy = 0.0;      ///< J that it takes to remove it
  std::int64_t voxels = 0;  ///< that were lowered

  void add(const Removed& more) HAPTICS_RT {
    volume += more.volume;
    energy += more.energy;
    voxels += more.voxels;
  }
};

/// Carries out a cut: no voxel that may be cut stays above the profile of the wall at its distance
/// to the burr (README.md, "The burr"). An absolute value and no decrement, so neither order nor
/// repetition of cuts matters. It goes row by row, and may be left between two of them.
class BurrCarving {
 public:
  BurrCarving() = default;
  /// `volume`: its grid, type, background and greatest value count, its voxels do not. The cut must
  /// be possible.
  BurrCarving(const Volume& volume, const BurrCut& cut) HAPTICS_RT;

  /// The voxels that the cut may lower, clipped to those that exist; empty if it lies beside them.
  const VoxelBox& box() const HAPTICS_RT { return box_; }
  /// An upper bound of the difference between two neighbours along an axis, both of which the cut
  /// lowers [value].
  double steepest() const HAPTICS_RT { return steepest_; }
  /// m: beyond it from the ball no voxel is lowered.
  double reach() const HAPTICS_RT { return reach_ - radius_; }

  bool isDone() const HAPTICS_RT { return next_ >= rows_; }
  std::int64_t voxelsInRow() const HAPTICS_RT { return box_.end[0] - box_.first[0]; }
  /// Lowers the next row, but for voxels that may not be cut (Volume::tissues). `voxels` and `scan`
  /// have the grid and the type of the volume; where the volume's tissues do not say which material
  /// it is, the scan's value does.
  Removed lowerRow(void* voxels, const void* scan, const Material& material) HAPTICS_RT;
  /// Lowers all rows that are left. Without a material: nobody asks for the energy.
  Removed lowerAll(void* voxels, const void* scan);

 private:
  template <class T>
  Removed lowerTyped(T* row, const T* scan, double y, double z, std::span<const Tissues::Run> runs,
                     const Material& material) const HAPTICS_RT;
  template <class Real>
  lanes::BallAtRow<Real> ball(const WallProfile& profile, const PartOfVoxel& part) const HAPTICS_RT;

  std::array<std::int64_t, 3> dims_{};
  ScalarType type_ = ScalarType::Int16;
  const Tissues* tissues_ = nullptr;  ///< the volume's, which lives longer
  VoxelBox box_;
  Vec3 spacing_ = Vec3::Ones();
  // m, along the grid's axes from its voxel (0, 0, 0)
  Vec3 a_ = Vec3::Zero(), way_ = Vec3::Zero();
  Vec3 middle_ = Vec3::Zero();
  double around_square_ = 0.0;         ///< m2: of the ball around all that can be lowered
  double radius_ = 0.0, reach_ = 0.0;  ///< m
  double isovalue_ = 0.0, background_ = 0.0;
  double steepest_ = 0.0;
  // the ball at a row, but for x, y and z; whichever the type of the voxels needs
  lanes::BallAtRow<float> in_float_{};
  lanes::BallAtRow<double> in_double_{};
  std::int64_t rows_ = 0, next_ = 0;
};

}  // namespace haptics
