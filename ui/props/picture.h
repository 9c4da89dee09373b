// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <Eigen/Geometry>
#include <atomic>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "haptics/core/geometry.h"
#include "haptics/core/volume.h"

class vtkMatrix4x4;
class vtkPolyData;

namespace ui {

inline constexpr double kMmPerM = 1000.0;

/// Counts of intensities.
struct Histogram {
  double least = 0.0;     ///< lower edge of the first bin, in the volume's unit
  double greatest = 0.0;  ///< upper edge of the last bin
  std::vector<double> counts = {};
};

/// A volume prepared for the window. It is made on another thread and not changed afterwards.
///
/// Images are in the grid's own frame L: voxel (0, 0, 0) at the origin, axes along i, j, k,
/// millimetres. X_WL_mm takes L to W and may mirror, because a file's axes may be left-handed.
struct Picture {
  std::shared_ptr<const haptics::Volume> volume;
  /// The volume's own voxels, not a copy: also those beyond its crop, which do not exist. Who draws
  /// it must leave them out (Volume::bounds).
  vtkSmartPointer<vtkImageData> image;
  vtkSmartPointer<vtkImageData> reduced;  ///< averaged over blocks, with a rim of background
  Eigen::Affine3d X_WL_mm = Eigen::Affine3d::Identity();
  Histogram histogram;
  /// What is neither air nor apart from the body, in W, mm; the volume where the unit tells no air.
  Eigen::AlignedBox3d body_mm;

  bool mirrored() const { return X_WL_mm.linear().determinant() < 0.0; }
};

/// If `cancel` becomes true meanwhile, the result is incomplete and must not be used.
Picture pictureOf(std::shared_ptr<const haptics::Volume> volume,
                  const std::atomic<bool>* cancel = nullptr);
/// The same picture, made from that of a volume which differs from this one in `changed` alone:
/// boxes that hold every voxel that differs.
Picture pictureOf(std::shared_ptr<const haptics::Volume> volume, const Picture& before,
                  std::span<const haptics::VoxelBox> changed);

/// All of the volume's voxels as an image of L, without a copy; the image keeps them alive. A crop
/// is not applied, since rows of a box do not follow one another.
vtkSmartPointer<vtkImageData> imageOf(const haptics::Volume& volume);

/// The voxels that exist (Volume::bounds) at index coordinates, which are moved among them:
/// trilinear.
double fieldAt(const haptics::Volume& volume, const Eigen::Vector3d& index);

/// VTK's number of a type.
int vtkTypeOf(haptics::ScalarType type);

/// The voxels that exist (Volume::bounds), averaged over the smallest cubes that leave at most
/// `most_voxels`, with a rim of background so that cut faces are closed. If `cancel` becomes true
/// meanwhile, the result is incomplete.
vtkSmartPointer<vtkImageData> reducedImageOf(const haptics::Volume& volume,
                                             std::int64_t most_voxels,
                                             const std::atomic<bool>* cancel = nullptr);

/// Made from the voxels that exist, or from evenly spaced rows of them: a few million voxels.
Histogram histogramOf(const haptics::Volume& volume, int bins);

/// The isosurface of an image of L as triangles with normals, in L. Any thread. If X_WL
/// mirrors, the triangles are reversed so that they face outwards in W.
vtkSmartPointer<vtkPolyData> isosurfaceMesh(vtkImageData* image, double isovalue, bool mirrored);

/// The same surface with about `most_triangles` at most: what lies within a bin becomes one corner.
/// A closed mesh stays closed, and a wall thinner than a bin becomes a wall without a thickness.
/// The mesh itself if it is small enough. Any thread.
vtkSmartPointer<vtkPolyData> lightMesh(vtkPolyData* mesh, std::int64_t most_triangles);

vtkSmartPointer<vtkMatrix4x4> matrixOf(const Eigen::Affine3d& X);
/// The pose as a matrix, with its translation converted from metres to millimetres.
vtkSmartPointer<vtkMatrix4x4> matrixOf(const haptics::Pose& X);

/// The least intensity of what counts as the body, and not as air or background.
double bodyFrom(const haptics::Volume& volume);

/// The box of W that the grid's voxel centres fill, mm.
Eigen::AlignedBox3d boxOf_mm(const haptics::Grid& grid);
/// The same of the voxels that exist.
Eigen::AlignedBox3d boxOf_mm(const haptics::Volume& volume);

}  // namespace ui
