// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/rendering/rendering.h"

namespace study {

Outcome drawScene(const std::string& scene, Depth) {
  return notDrawn(scene, "Not measured: this build has no VTK (PALPATE_DESKTOP is off).");
}

}  // namespace study
