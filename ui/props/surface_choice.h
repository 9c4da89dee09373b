// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QString>

namespace ui {

enum class SurfaceMode { RayCast, Mesh };

/// How the isosurface is drawn, and why, in words for the status bar.
struct SurfaceChoice {
  SurfaceMode mode = SurfaceMode::Mesh;
  QString reason;
};

}  // namespace ui
