// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "app/film/camera.h"
#include "app/film/frame.h"
#include "app/film/overlays.h"
#include "app/recording/recording.h"
#include "haptics/core/error.h"
#include "ui/props/volume_prop.h"

namespace app {

/// Draws the frames of a film: the layers of the 3-D view, in an invisible window. Use it in one
/// thread; it has its own graphics context.
class FilmStage {
 public:
  /// Uses the ray caster if a graphics card draws, otherwise the mesh; `wish` as in chooseSurface.
  /// `look`: what is shown of the view beside the recording.
  /// Refusals: "no-display", "no-graphics" (no OpenGL 3.2).
  static haptics::Expected<std::unique_ptr<FilmStage>> open(int width, int height,
                                                            std::optional<ui::SurfaceMode> wish,
                                                            FilmLook look = {});
  ~FilmStage();
  FilmStage(const FilmStage&) = delete;
  FilmStage& operator=(const FilmStage&) = delete;

  /// Shows the tool's mesh, or its points if it has no mesh; null: no tool.
  void show(const haptics::Tool* tool);
  /// Shows the volume's surface; null: no surface.
  void show(const std::shared_ptr<const haptics::Volume>& volume);
  /// Shows these voxels, which are those of the volume on view and change from now on: carve() says
  /// where. Until the next volume.
  void showLive(const haptics::Volume& voxels);
  void carve(const haptics::VoxelBox& box);
  /// Shows a text in the lower left corner; empty: none.
  void write(const std::string& text);
  FilmCurve& curve();
  void look(const FilmCamera& camera);
  const FilmCamera& camera() const;
  /// Width over height of the 3-D picture.
  double aspect() const;
  /// Bounding box of the surface at an isovalue, in W [mm]; empty if there is no surface.
  Eigen::AlignedBox3d surfaceBox_mm(double isovalue);

  /// Draws tool and device at the poses of a step, and the surface at its isovalue. The frame is
  /// valid until the next call.
  const FilmFrame& draw(const haptics::Step& step);

  ui::SurfaceMode surfaceMode() const;

 private:
  struct Layers;
  explicit FilmStage(std::unique_ptr<Layers> layers);
  void placeSurface(double isovalue);
  void placeClippingPlanes(const haptics::Step& step);
  std::unique_ptr<Layers> layers_;
};

}  // namespace app
