// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkActor.h>
#include <vtkSmartPointer.h>
#include <vtkVolume.h>

#include <QString>
#include <optional>

#include "ui/props/picture.h"
#include "ui/viewport.h"

class vtkOpenGLGPUVolumeRayCastMapper;
class vtkPolyDataMapper;

namespace ui {

enum class SurfaceMode { RayCast, Mesh };

/// How the isosurface is drawn, and why, in words for the status bar.
struct SurfaceChoice {
  SurfaceMode mode = SurfaceMode::Mesh;
  QString reason;
};

/// Chooses the ray caster if the GPU has OpenGL 3.2 and textures as large as the volume, otherwise
/// the mesh. `wish` overrides reasons that only affect the speed.
SurfaceChoice chooseSurface(std::optional<SurfaceMode> wish, const Graphics& graphics,
                            const haptics::Grid& grid);

/// The volume's isosurface: ray-cast on the GPU from the voxels, or drawn as a mesh, which is
/// reduced while something moves and fine at rest.
class VolumeProp {
 public:
  VolumeProp();
  ~VolumeProp();

  void show(const Picture& picture);
  void setMode(SurfaceMode mode);
  SurfaceMode mode() const { return mode_; }
  void setIsovalue(double isovalue);
  /// Hides the fine mesh behind the reduced one.
  void setMoving(bool moving);
  /// Shows a mesh of L in full detail. Ignored if the isovalue has changed meanwhile.
  void showFine(vtkPolyData* mesh, double isovalue);
  /// Finds the ray's hit by bisection between samples (on) or takes the sample after it (off).
  void setHitRefinement(bool on);
  /// The box of W that the surface fills, mm; the volume's if there is no surface.
  Eigen::AlignedBox3d bounds_mm();
  /// Updates what is drawn; must be called before each drawing.
  void update();

  vtkVolume* rayCast() const { return volume_; }
  vtkActor* mesh() const { return mesh_; }

 private:
  vtkPolyData* reducedMesh();
  vtkSmartPointer<vtkVolume> volume_;
  vtkSmartPointer<vtkOpenGLGPUVolumeRayCastMapper> caster_;
  vtkSmartPointer<vtkActor> mesh_;
  vtkSmartPointer<vtkPolyDataMapper> mesh_mapper_;
  vtkSmartPointer<vtkPolyData> reduced_mesh_;
  vtkSmartPointer<vtkPolyData> fine_mesh_;
  Picture picture_;
  SurfaceMode mode_ = SurfaceMode::Mesh;
  double isovalue_ = 0.0;
  bool moving_ = false;
};

}  // namespace ui
