// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "app/study/reference/choices.h"

namespace reference {

/// A volume and an isovalue, seen as a solid ([Chan 2011], 2.2). Keeps the volume's voxels alive.
///
/// One thread at a time: every look-up of F and every gradient is counted.
class Solid {
 public:
  Solid(const haptics::Volume& volume, double isovalue, const Choices& choices);

  /// F at p, trilinear from eight voxels. A voxel beyond the grid counts as the least one, so
  /// that F reaches the background within one voxel outside.
  double value(const Vec3& p_W) const;
  /// grad F at p, per metre, in W: the central difference (1) over one voxel along each axis of
  /// the grid, divided by 2 delta.
  Vec3 gradient(const Vec3& p_W) const;
  /// -grad F / |grad F|, out of the solid, unit, in W; undivided as in (1) if the choices say so.
  /// Zero where the gradient vanishes.
  Vec3 normal(const Vec3& p_W) const;
  bool inside(const Vec3& p_W) const { return isInside(value(p_W)); }
  bool isInside(double F) const;
  /// The distance to the surface to first order, (s - F) / |grad F|, in m: positive outside.
  /// Infinite, with the sign of s - F, where the gradient vanishes.
  double gap(const Vec3& p_W) const;
  /// True if (s - F) cannot be within `reach` metres of the surface by `gap`, whatever the
  /// gradient: |grad F| is at most the volume's range over two voxels along each axis. Saves the
  /// gradient and never changes an answer.
  bool farOutside(double F, double reach) const { return isovalue_ - F > reach * steepest_; }

  const haptics::Volume& volume() const { return volume_; }
  double isovalue() const { return isovalue_; }
  const Choices& choices() const { return choices_; }
  // since construction
  std::int64_t samples() const { return samples_; }      ///< look-ups of F, those of gradients too
  std::int64_t gradients() const { return gradients_; }  ///< central differences: six look-ups each

 private:
  Vec3 differences(const Vec3& p_W) const;

  haptics::Volume volume_;
  double isovalue_;
  Choices choices_;
  double steepest_;  ///< per metre
  mutable std::int64_t samples_ = 0, gradients_ = 0;
};

}  // namespace reference
