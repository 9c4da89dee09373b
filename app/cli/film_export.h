// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "app/cli/commands.h"
#include "app/cli/sources.h"

namespace app::cli {

/// The options of a film of a recording.
struct FilmChoice {
  std::string recording;
  std::string out;
  VolumeChoice volume;  ///< neither path nor phantom: the film shows only the tool
  std::string size = "1280x720";
  int frames_per_second = 30;
  double speed = 1.0;
  double from = 0.0, to = 0.0;  ///< s of the session
  bool burn_in = false;
  std::string camera = "recorded";  ///< or "fixed": a view of surface and tool
  std::string surface = {};         ///< "raycast" or "mesh"; empty: chosen by the graphics
  bool slices = false;
  std::string view = {};  ///< a saved view: its marks, second surface, colours and grey window
};

/// Draws and writes the film, until it is complete or the user interrupts.
Outcome exportFilm(const FilmChoice& choice);

/// Adds --size, --fps, --speed, --burn-in, --camera,
/// --surface, --slices and --view.
void addFilmOptions(CLI::App& command, FilmChoice& choice);

}  // namespace app::cli
