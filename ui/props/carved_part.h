// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkSmartPointer.h>

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "haptics/core/volume.h"
#include "ui/props/colouring.h"

class vtkActor;
class vtkOpenGLGPUVolumeRayCastMapper;
class vtkPolyData;
class vtkPolyDataMapper;
class vtkVolume;

namespace ui {

class CutTint;

/// The part of a volume that a burr has cut. A texture gets the voxels that have changed, and no
/// others. A mesh is contoured anew in the bricks alone where something was cut, from all their
/// voxels, and the rest of it stays what it was. All in the grid's frame L, mm.
class CarvedPart {
 public:
  CarvedPart();
  ~CarvedPart();

  /// The voxels that change from now on, and what they were in the scan: what was cut has a colour
  /// of its own, also where it was cut before, in these boxes.
  void begin(const haptics::Volume& voxels, std::shared_ptr<const haptics::Volume> scan,
             std::span<const haptics::VoxelBox> cut_before);
  void end();
  bool isOn() const { return voxels_.has_value(); }
  /// Voxels in this box have changed.
  void add(const haptics::VoxelBox& box);
  /// Whether nothing was cut.
  bool isEmpty() const { return bricks_.empty(); }
  void setTint(bool on);
  bool isTinted() const { return tinted_; }

  /// Brings the textures of a volume that was drawn up to date; the OpenGL context must be current.
  void upload(vtkOpenGLGPUVolumeRayCastMapper& caster);
  /// Gives this volume, which is ray-cast, the colour where it was cut.
  void tint(vtkVolume& volume);
  /// Brings that up to date.
  void tintFor(double isovalue);
  /// Brings the bricks' own mesh up to date.
  void contour(double isovalue, bool mirrored, const Rgb& colour);
  /// A mesh of the volume without the triangles within the bricks, but for a rim in which nothing
  /// was cut; valid until the next call.
  vtkPolyData* beside(vtkPolyData* mesh);
  /// Draws the bricks' own mesh.
  vtkActor* actor() const;

 private:
  /// Counted from the grid's first voxel.
  using BrickIndex = std::array<std::int64_t, 3>;
  struct Brick {
    vtkSmartPointer<vtkPolyData> mesh;  ///< null: not up to date
  };
  /// The first and the last that the volume has.
  std::pair<BrickIndex, BrickIndex> range() const;
  /// Brings bricks into being, or out of date.
  void touch(const haptics::VoxelBox& box);
  vtkSmartPointer<vtkPolyData> meshOf(const BrickIndex& brick, double isovalue, bool mirrored,
                                      const Rgb& colour) const;

  std::optional<haptics::Volume> voxels_;
  std::shared_ptr<const haptics::Volume> scan_;
  std::map<BrickIndex, Brick> bricks_;
  std::vector<haptics::VoxelBox> waiting_;  ///< what the textures do not have yet
  bool tinted_ = true;
  struct Contoured {
    double isovalue = 0.0;
    Rgb colour{};
    bool operator==(const Contoured&) const = default;
  };
  std::optional<Contoured> contoured_;  ///< what the bricks' meshes show
  bool stale_ = false;                  ///< some of the bricks have no mesh
  vtkSmartPointer<vtkActor> actor_;
  vtkSmartPointer<vtkPolyDataMapper> mapper_;
  vtkSmartPointer<CutTint> tint_;
  haptics::VoxelBox tinted_box_;  ///< that the tint has
  vtkSmartPointer<vtkPolyData> mesh_, beside_;
  std::size_t beside_of_ = 0;  ///< the number of bricks that `beside_` leaves out of `mesh_`
};

}  // namespace ui
