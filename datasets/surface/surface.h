// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>

#include "datasets/edits/bits.h"
#include "datasets/edits/edit_history.h"
#include "haptics/core/error.h"
#include "haptics/core/volume.h"

namespace datasets {

/// Axes of a file of a surface. Both are right-handed; they differ in the signs of x and y.
enum class SurfaceFrame {
  Lps,  ///< towards left, posterior and superior: W
  Ras   ///< towards right, anterior and superior
};

/// A corner of a surface as it is written, mm.
using SurfacePoint = std::array<float, 3>;

/// Gets a surface piece by piece, in an order that is always the same.
class SurfaceReceiver {
 public:
  virtual ~SurfaceReceiver() = default;
  /// The next corner; corners count from 0.
  virtual void corner(const SurfacePoint&) {}
  /// Three corners that were given before, anticlockwise as seen from outside.
  virtual void triangle(const std::array<std::int64_t, 3>& /*corners*/,
                        const std::array<SurfacePoint, 3>& /*points*/) {}
  /// One more layer of cells is done. Only the corners first <= n < end of it are also in the next.
  virtual void layer(std::int64_t /*first*/, std::int64_t /*end*/) {}
};

/// The watch of a part of some work. The watch of the whole must outlive it.
EditWatch partOf(const EditWatch& watch, double from, double until);

/// The isosurface of the trilinear field between the voxels that exist (Volume::bounds), as
/// triangles. Where the solid meets their border, the surface is closed by a plane: the outer faces
/// of the outermost voxels. Solid parts are connected by the rule of Pieces.
class Surface {
 public:
  /// `largest`: only the largest connected part of the solid, with its cavities. Refuses an
  /// isovalue at which there is no surface or all is solid, reason "nothing". Any thread; takes up
  /// to some seconds. Its memory does not grow with the surface.
  static haptics::Expected<Surface> of(std::shared_ptr<const haptics::Volume> volume,
                                       double isovalue, bool largest, const EditWatch& watch = {});

  const haptics::Volume& volume() const { return *volume_; }
  double isovalue() const { return isovalue_; }
  std::int64_t corners() const { return corners_; }
  std::int64_t triangles() const { return triangles_; }
  /// How long the three numbers of a corner are as text, on average of some of them.
  double cornerLetters() const { return corner_letters_; }

  /// Gives all corners and triangles to the receiver, their places in `frame`. False: cancelled.
  bool walk(SurfaceFrame frame, SurfaceReceiver& receiver, const EditWatch& watch = {}) const;

 private:
  std::shared_ptr<const haptics::Volume> volume_;
  double isovalue_ = 0.0;
  std::optional<VoxelBits> part_;  ///< the solid voxels of the largest part; none: all parts
  std::int64_t corners_ = 0, triangles_ = 0;
  double corner_letters_ = 0.0;
};

}  // namespace datasets
