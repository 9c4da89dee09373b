// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkSmartPointer.h>

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "ui/props/carved_part.h"
#include "ui/props/colouring.h"
#include "ui/props/picture.h"
#include "ui/props/surface_choice.h"

class vtkActor;
class vtkCamera;
class vtkOpenGLGPUVolumeRayCastMapper;
class vtkPolyDataMapper;
class vtkVolume;

namespace ui {

struct Graphics;

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
  /// Shows other voxels of the same grid; isovalue, mode and colours stay.
  void replace(const Picture& picture);
  const Picture& picture() const { return picture_; }
  void setMode(SurfaceMode mode);
  SurfaceMode mode() const { return mode_; }
  void setIsovalue(double isovalue);
  double isovalue() const { return isovalue_; }
  /// The colour of the surface follows from its isovalue.
  void setColouring(const Colouring& colouring);
  const Colouring& colouring() const { return colouring_; }
  Rgb colour() const { return colouring_.at(isovalue_); }
  /// Darkens what lies deep among other parts of the surface; ray-cast only, and costs 16 samples a
  /// pixel: for graphics cards.
  void setOcclusion(bool on);
  /// Shows a second surface, which is seen and not felt: a reduced mesh, for a veil; none: no
  /// second.
  void setSecond(std::optional<double> isovalue);
  std::optional<double> second() const { return second_value_; }
  /// Shows a reduced mesh in place of the fine one.
  void setMoving(bool moving);
  /// How many triangles a mesh that moves has, about, at most; none: as many as it comes with.
  void setBudget(std::optional<std::int64_t> triangles);
  /// Shows a mesh of L in full detail. Ignored if the isovalue has changed meanwhile.
  void showFine(vtkPolyData* mesh, double isovalue);
  /// Whether it is there, of the picture and the isovalue.
  bool hasFine() const { return fine_mesh_ != nullptr && !fine_is_old_; }
  /// Shows these voxels, which are those of the picture's volume and change from now on, as
  /// carved() is told. `scan`: what they were before any cut; boxes that hold what is cut already.
  /// Until the next show() or replace().
  void showLive(const haptics::Volume& voxels, std::shared_ptr<const haptics::Volume> scan,
                std::span<const haptics::VoxelBox> cut_before);
  /// The part that changes.
  CarvedPart& carved() { return carved_; }
  const CarvedPart& carved() const { return carved_; }
  /// The picture is this one now, whose voxels are those on view.
  void renew(const Picture& picture);
  /// Finds the ray's hit by bisection between samples (on) or takes the sample after it (off).
  void setHitRefinement(bool on);
  /// The box of W that the surface fills, mm; the volume's if there is no surface.
  Eigen::AlignedBox3d bounds_mm();
  /// Places between which nearly all of the surfaces lie [mm of W], whatever the direction: specks
  /// of noise do not count. The corners of the volume where there is no surface.
  std::vector<Eigen::Vector3d> outline_mm();
  /// Updates what is drawn; must be called before each drawing.
  void update();
  /// Leaves out faces that cannot be seen: back faces of a mesh that is closed and lies as a whole
  /// beyond the near plane of this camera.
  void cull(vtkCamera* camera);

  vtkVolume* rayCast() const;
  vtkActor* mesh() const;
  vtkActor* secondMesh() const;

 private:
  /// A reduced mesh, and what of it is drawn in motion; both null until they are needed.
  struct Reduced {
    vtkSmartPointer<vtkPolyData> whole, light;
  };
  vtkPolyData* reducedMesh();
  vtkPolyData* secondReduced();
  vtkPolyData* lightOf(Reduced& mesh) const;
  void extendOutline(std::vector<Eigen::Vector3d>& outline, vtkPolyData& mesh) const;
  void crop();
  void colourAll();
  void tellShader();
  vtkSmartPointer<vtkVolume> volume_;
  vtkSmartPointer<vtkOpenGLGPUVolumeRayCastMapper> caster_;
  vtkSmartPointer<vtkActor> mesh_;
  vtkSmartPointer<vtkPolyDataMapper> mesh_mapper_;
  Reduced reduced_;
  vtkSmartPointer<vtkPolyData> fine_mesh_;
  bool fine_is_old_ = false;  ///< it is of the picture before
  vtkSmartPointer<vtkActor> second_;
  vtkSmartPointer<vtkPolyDataMapper> second_mapper_;
  Reduced second_reduced_;
  CarvedPart carved_;
  std::optional<std::int64_t> budget_;
  std::optional<double> second_value_;
  Colouring colouring_;
  std::array<float, 3> crop_least_{}, crop_greatest_{};  ///< texture coordinates
  bool refined_ = true;
  bool occluded_ = false;
  Picture picture_;
  SurfaceMode mode_ = SurfaceMode::Mesh;
  double isovalue_ = 0.0;
  bool moving_ = false;
};

}  // namespace ui
