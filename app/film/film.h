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
#include "haptics/core/error.h"
#include "haptics/core/volume.h"
#include "haptics/recording/recording.h"
#include "ui/props/volume_prop.h"

namespace app {

struct FilmOptions {
  // s of the session, as its steps count them; what lies outside the recording is left out
  double from = -std::numeric_limits<double>::infinity();
  double to = std::numeric_limits<double>::infinity();
  int width = 1280, height = 720;  ///< pixels, even, 64 to 7680
  int frames_per_second = 30;      ///< 1 to 240
  double speed = 1.0;              ///< s of the session in a second of the film; 0.001 to 1000
  bool burn_in = false;            ///< time and force in the lower left corner
  /// The cameras that the recording holds, each until the next. Without them, or where it holds
  /// none, `camera`; without that one, one that sees surface and tool.
  bool recorded_camera = true;
  std::optional<FilmCamera> camera = {};
  std::optional<ui::SurfaceMode> surface = {};  ///< a wish, as in ui::chooseSurface
  /// The program; looked for in PATH where it has no slash. Empty or not there: Ogg Theora.
  std::string ffmpeg = "ffmpeg";
  /// Told the fraction that is done; false ends it, reason "cancelled".
  std::function<bool(double)> goes_on = {};
};

struct FilmResult {
  std::filesystem::path film;   ///< NAME.mp4, or NAME.ogv
  std::filesystem::path times;  ///< NAME.frames.csv: which step each frame shows
  std::int64_t frames = 0;
  double seconds = 0.0;  ///< of film
  std::string codec;     ///< "h264" or "theora"
  ui::SurfaceMode surface = ui::SurfaceMode::Mesh;
};

/// What makeFilm may write for an `out`: the film as it may be called, and its table.
std::vector<std::filesystem::path> filesOfFilm(const std::filesystem::path& out);

/// The volume of a scene of the recording; null: only the tool is drawn.
using VolumeOfScene = std::function<std::shared_ptr<const haptics::Volume>(std::uint32_t scene)>;

/// Draws a recording and writes it as a film: frame i shows the last step at or before
/// from + i speed / frames_per_second. `out` may end in .mp4 or .ogv, or neither: the ending is
/// that of what was written. Files get their names when they are whole; what was refused or
/// cancelled leaves none.
///
/// Any thread: it has a graphics context of its own, and waits for the drawing. Refusals: "options"
/// (a number out of range), "nothing" (no step between `from` and `to`), "no-display",
/// "no-graphics", "unwritable", "encoder", "cancelled", and those of reading the recording.
haptics::Expected<FilmResult> makeFilm(haptics::Recording& recording, const VolumeOfScene& volume,
                                       const std::filesystem::path& out,
                                       const FilmOptions& options);

}  // namespace app
