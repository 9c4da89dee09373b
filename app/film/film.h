// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/film/camera.h"
#include "app/film/overlays.h"
#include "app/recording/recording.h"
#include "haptics/core/error.h"
#include "haptics/core/volume.h"
#include "ui/props/volume_prop.h"

namespace app {

struct FilmOptions {
  // s of the session; times outside the recording are left out
  double from = -std::numeric_limits<double>::infinity();
  double to = std::numeric_limits<double>::infinity();
  int width = 1280, height = 720;  ///< pixels, even, 64 to 7680
  int frames_per_second = 30;      ///< 1 to 240
  double speed = 1.0;              ///< session time in one second of film; 0.001 to 1000
  bool burn_in = false;            ///< time and force in figures, and the force's curve
  FilmLook look = {};
  /// Use the recorded cameras. If false, or if the recording has none, use `camera`; if that is not
  /// set, a view of surface and tool.
  bool recorded_camera = true;
  std::optional<FilmCamera> camera = {};
  std::optional<ui::SurfaceMode> surface = {};  ///< preferred surface, as in ui::chooseSurface
  /// The ffmpeg program, searched in PATH if it has no slash. If empty or missing, an MP4 is
  /// refused.
  std::string ffmpeg = "ffmpeg";
  /// Called with the completed fraction. Returning false ends the film, reason "cancelled".
  std::function<bool(double)> goes_on = {};
};

struct FilmResult {
  std::filesystem::path film;   ///< NAME.mp4, or NAME.ogv
  std::filesystem::path times;  ///< NAME.frames.csv: the step of each frame
  std::int64_t frames = 0;
  double seconds = 0.0;  ///< length of the film
  std::string codec;     ///< "h264" or "theora"
  ui::SurfaceMode surface = ui::SurfaceMode::Mesh;
};

/// The files that makeFilm may write for `out`: the table, and the possible names of the film.
std::vector<std::filesystem::path> filesOfFilm(const std::filesystem::path& out);

/// The volume of a scene of the recording; null: only the tool is drawn.
using VolumeOfScene = std::function<std::shared_ptr<const haptics::Volume>(std::uint32_t scene)>;

/// Draws a recording and writes it as a film: frame i shows the last step at or before from + i
/// speed / frames_per_second. `out` may end in .mp4, .ogv or neither; the film has the ending of
/// its format: that of `out`; without one .mp4, or .ogv where there is no ffmpeg, which then
/// replaces no file. Files get their names when they are complete. After a refusal or cancellation
/// no file remains.
///
/// Any thread: it has its own graphics context, and waits for the drawing. Refusals: "options" (a
/// number out of range), "nothing" (no step between `from` and `to`), "no-display", "no-graphics",
/// "unwritable", "encoder", "cancelled", and those of reading the recording.
haptics::Expected<FilmResult> makeFilm(Recording& recording, const VolumeOfScene& volume,
                                       const std::filesystem::path& out,
                                       const FilmOptions& options);

}  // namespace app
