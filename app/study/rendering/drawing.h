// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>

#include "app/study/rendering/judge.h"
#include "app/study/rendering/sphere_image.h"
#include "datasets/phantoms/phantoms.h"

namespace study {

/// What draws a volume's isosurface.
enum class BackEnd {
  RayCast,        ///< what Palpate's window draws on a graphics card
  RayCastCoarse,  ///< the same, hits taken at the sample behind the surface, as VTK does
  ProcessorCast,  ///< vtkFixedPointVolumeRayCastMapper, with a step of opacity at the isovalue
  Mesh,           ///< what Palpate's window draws at rest on software graphics
  ReducedMesh,    ///< … and while something moves
};
const char* nameOf(BackEnd back_end);

/// How often a picture is drawn for the clock.
struct Frames {
  int least = 3, most = 7;
  double seconds = 0.5;  ///< beyond the least, no more are begun after these
};

/// A window that nobody sees, with a volume in it, drawn by ui::VolumeProp. Needs an X display
/// with GLX.
class Drawing {
 public:
  /// side x side pixels.
  Drawing(const datasets::Phantom& phantom, int side);
  ~Drawing();

  /// `sample_distance` in voxels, along the shortest edge of one; a mesh has none.
  Shot shoot(BackEnd back_end, double sample_distance, const Camera& camera,
             const Frames& frames = {1, 1, 0.0});
  Look look() const;
  /// What Palpate's ray caster takes by itself, voxels.
  double ownSampleDistance() const { return own_sample_distance_; }
  /// GL_RENDERER.
  std::string renderer() const;
  /// How long the fine mesh took to make, once for each isovalue, ms.
  double meshing_ms() const { return meshing_ms_; }
  int triangles() const { return triangles_; }

 private:
  struct Stage;
  std::unique_ptr<Stage> stage_;
  double own_sample_distance_ = 0.0, meshing_ms_ = 0.0;
  int triangles_ = 0;
};

}  // namespace study
