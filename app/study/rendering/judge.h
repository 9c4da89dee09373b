// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "app/study/rendering/image.h"
#include "app/study/rendering/sphere_image.h"
#include "app/study/report/outcome.h"

namespace study {

/// One picture, and what it took to draw it again and again.
struct Shot {
  Image image;
  std::vector<double> frames_ms;  ///< by the clock, until the picture was complete
};

/// What a back-end made of a scene with one setting.
struct Drawn {
  std::string back_end;
  double sample_distance = 0.0;  ///< voxels; 0 for a mesh, which has none
  std::vector<Shot> views = {};  ///< in the order of the references
};

/// What pictures are held against: one for each view.
struct Reference {
  std::string name;
  std::vector<Image> views = {};
};

/// Two diagrams, root mean square error and 1 - SSIM against frame time; and that every back-end
/// shows the object, and that no shorter sample distance draws worse. Settings of one back-end
/// stand from the longest sample distance to the shortest.
Outcome judged(const std::string& scene, const Reference& reference,
               const std::vector<Drawn>& drawn);

/// That what the refinement of a hit corrects is of the first order in the sample distance. The two
/// back-ends take the same samples along the same rays; `coarse` leaves out the refinement. So
/// both meet or miss a thin edge alike, and what such edges come to is not in their difference.
Outcome convergence(const std::string& scene, const std::string& refined, const std::string& coarse,
                    const std::vector<Drawn>& drawn);

/// What is asked of every back-end's picture of a sphere, with the formula's.
struct SphereScene {
  Sphere sphere;
  std::vector<Camera> cameras = {};
  double voxel_mm = 1.0;
};

/// That silhouettes are the sphere's, and where it is: neither mirrored nor shifted.
Outcome silhouettes(const SphereScene& scene, const std::vector<Drawn>& drawn);

/// That a sphere's two references, which share no code, agree.
Outcome agreement(const Reference& formula, const Reference& finest);

}  // namespace study
