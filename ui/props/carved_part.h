// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkSmartPointer.h>

#include <memory>
#include <optional>

#include "haptics/core/volume.h"
#include "ui/props/colouring.h"

class vtkActor;
class vtkOpenGLGPUVolumeRayCastMapper;
class vtkPolyData;
class vtkPolyDataMapper;

namespace ui {

/// The part of a volume that a burr has cut while it is on view. A texture gets the voxels that
/// have changed, and no others. A mesh is contoured anew in this part alone, from all its voxels,
/// and the rest of it stays what it was. All in the grid's frame L, mm.
class CarvedPart {
 public:
  CarvedPart();
  ~CarvedPart();

  /// The voxels that change from now on, and what they were in the scan: what was cut has a colour
  /// of its own.
  void begin(const haptics::Volume& voxels, std::shared_ptr<const haptics::Volume> scan);
  void end();
  bool isOn() const { return voxels_.has_value(); }
  /// Voxels in this box have changed.
  void add(const haptics::VoxelBox& box);
  /// Whether any have.
  bool isEmpty() const;
  void setTint(bool on);
  bool isTinted() const { return tinted_; }

  /// Brings the textures of a volume that was drawn up to date; the OpenGL context must be current.
  void upload(vtkOpenGLGPUVolumeRayCastMapper& caster);
  /// Brings the part's own mesh up to date.
  void contour(double isovalue, bool mirrored, const Rgb& colour);
  /// A mesh of the volume without the triangles within the part; valid until the next call.
  vtkPolyData* beside(vtkPolyData* mesh);
  /// Draws the part's own mesh.
  vtkActor* actor() const;

 private:
  haptics::VoxelBox part() const;

  std::optional<haptics::Volume> voxels_;
  std::shared_ptr<const haptics::Volume> scan_;
  haptics::VoxelBox carved_, waiting_;  ///< all of it, and what the textures do not have yet
  bool tinted_ = true;
  struct Contoured {
    double isovalue = 0.0;
    Rgb colour{};
    bool operator==(const Contoured&) const = default;
  };
  std::optional<Contoured> contoured_;  ///< none: the mesh is not up to date
  vtkSmartPointer<vtkActor> actor_;
  vtkSmartPointer<vtkPolyDataMapper> mapper_;
  vtkSmartPointer<vtkPolyData> mesh_, beside_;
  haptics::VoxelBox beside_of_;  ///< the part that `beside_` leaves out of `mesh_`
};

}  // namespace ui
