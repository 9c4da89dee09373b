// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "app/cli/commands.h"
#include "app/cli/sources.h"

namespace app::cli {

/// A film of a recording, as it is asked for.
struct FilmChoice {
  std::string recording;
  std::string out;
  VolumeChoice volume;  ///< neither path nor phantom: the tool alone
  std::string size = "1280x720";
  int frames_per_second = 30;
  double speed = 1.0;
  double from = 0.0, to = 0.0;  ///< s of the session
  bool burn_in = false;
  std::string camera = "recorded";  ///< or "fixed": one that sees surface and tool
  std::string surface = {};         ///< "raycast", "mesh"; empty: what the graphics suggest
};

/// Draws and writes it, until it is whole or the user interrupts.
Outcome exportFilm(const FilmChoice& choice);

/// Adds --volume, --phantom and how they are read, --size, --fps, --speed, --burn-in, --camera and
/// --surface.
void addFilmOptions(CLI::App& command, FilmChoice& choice);

}  // namespace app::cli
