// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "app/film/camera.h"
#include "app/film/frame.h"
#include "haptics/core/error.h"
#include "haptics/recording/recording.h"
#include "ui/props/volume_prop.h"

namespace app {

/// Where the frames of a film are drawn: the layers of the 3-D view, in a window that nobody sees.
/// One thread, with a graphics context of its own.
class FilmStage {
 public:
  /// The ray caster where a graphics card draws, the mesh elsewhere; `wish` as in chooseSurface.
  /// Refusals: "no-display", "no-graphics" (no OpenGL 3.2).
  static haptics::Expected<std::unique_ptr<FilmStage>> open(int width, int height,
                                                            std::optional<ui::SurfaceMode> wish);
  ~FilmStage();
  FilmStage(const FilmStage&) = delete;
  FilmStage& operator=(const FilmStage&) = delete;

  /// Its mesh, or its points where it has none; null: no tool.
  void show(const haptics::Tool* tool);
  /// Null: no surface.
  void show(const std::shared_ptr<const haptics::Volume>& volume);
  /// Above the picture's lower left corner; empty: none.
  void write(const std::string& text);
  void look(const FilmCamera& camera);
  const FilmCamera& camera() const;
  /// The box of W that the surface fills at an isovalue; empty where there is none.
  Eigen::AlignedBox3d surfaceBox_mm(double isovalue);

  /// Tool and device where they were in a step, the surface at its isovalue. Valid until the next.
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
