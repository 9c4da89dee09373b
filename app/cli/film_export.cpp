// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/film_export.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <memory>
#include <numbers>
#include <optional>
#include <utility>

#include "app/cli/interrupts.h"
#include "app/cli/recorded_run.h"
#include "app/cli/terminal.h"
#include "app/film/face.h"
#include "app/film/film.h"
#include "app/recording/recording.h"
#include "app/recording/replay.h"
#include "app/view_file/view_file.h"
#include "haptics/field/scalar_field.h"

namespace app::cli {
namespace {

/// "1280x720" as two numbers.
bool readSize(const std::string& text, FilmOptions& options) {
  const char* const end = text.data() + text.size();
  const auto width = std::from_chars(text.data(), end, options.width);
  if (width.ec != std::errc{} || width.ptr == end || *width.ptr != 'x') return false;
  const auto height = std::from_chars(width.ptr + 1, end, options.height);
  return height.ec == std::errc{} && height.ptr == end && options.width > 0 && options.height > 0;
}

std::vector<FilmMark> marksOf(const ViewFile& view,
                              const std::shared_ptr<const haptics::Volume>& volume) {
  const auto field = std::make_shared<const haptics::ScalarField>(volume);
  return filmMarks(view.marks, {.grid = volume->grid,
                                .unit = QString::fromStdString(volume->unit),
                                .value = [field](const haptics::Vec3& p_W_mm) {
                                  return field->value(field->indexOf(p_W_mm / ui::kMmPerM));
                                }});
}

/// The camera of a view; of a parallel one, from where perspective shows the middle as large.
FilmCamera cameraOf(const ui::ViewLook& look) {
  FilmCamera camera{.position_mm = look.eye_mm, .focus_mm = look.focus_mm, .up = look.up};
  if (look.parallel)
    camera.position_mm =
        look.focus_mm +
        (look.eye_mm - look.focus_mm).normalized() *
            (look.half_height_mm / std::tan(0.5 * camera.angle_deg * std::numbers::pi / 180.0));
  return camera;
}

Outcome refusedFilm(const haptics::Error& error) {
  Outcome outcome = refused(error);
  if (error.reason == "options" || error.reason == "nothing") {
    outcome.code = Exit::Usage;
  } else if (error.reason == "encoder" || error.reason == "no-display" ||
             error.reason == "no-graphics") {
    outcome.code = Exit::Failed;
  }
  return outcome;
}

}  // namespace

Outcome exportFilm(const FilmChoice& choice) {
  FilmOptions options;
  readSize(choice.size, options);  // checked when it was given
  options.frames_per_second = choice.frames_per_second;
  options.speed = choice.speed;
  options.from = choice.from;
  options.to = choice.to;
  options.burn_in = choice.burn_in;
  options.recorded_camera = choice.camera == "recorded";
  if (choice.surface == "mesh") options.surface = ui::SurfaceMode::Mesh;
  if (choice.surface == "raycast") options.surface = ui::SurfaceMode::RayCast;
  options.goes_on = [](double) { return !interrupted(); };
  const bool noVolume = choice.volume.path.empty() && choice.volume.phantom.empty();

  if (choice.slices && noVolume) return usage("--slices needs --volume or --phantom.");
  if (!choice.view.empty() && noVolume) return usage("--view needs --volume or --phantom.");

  std::vector<Target> targets;
  for (const std::filesystem::path& file : filesOfFilm(choice.out))
    targets.push_back({"--out", file.string()});
  std::vector<std::string> inputs{choice.recording};
  if (!choice.view.empty()) inputs.push_back(choice.view);
  if (const auto wrong = overwritten(targets, choice.volume, inputs)) return usage(*wrong);
  auto recording = Recording::open(choice.recording);
  if (!recording) return refused(recording.error());
  std::shared_ptr<const haptics::Volume> volume;
  std::optional<VolumeHash> hash;
  std::map<std::uint32_t, std::shared_ptr<const haptics::Volume>> touched;  // of each scene
  bool face = false;
  if (!noVolume) {
    auto loaded = loadVolume(choice.volume);
    if (!loaded) return refused(loaded.error());
    volume = *loaded;
    hash = hashHere(*volume);
    auto edited = editedAsRecorded(volume, hash, *recording);
    if (!edited) return refused(edited.error());
    touched = std::move(*edited);
    if (touched.empty())
      return refused(
          {haptics::Error::Kind::Unsupported, {"film-other-volume", {}}, "another-volume"});
    double least = leastIsovalue(*recording);
    if (!choice.view.empty()) {
      const auto view = viewOver(choice.view, *volume, hash);
      if (!view) return refused(view.error());
      options.look = lookOf(view->look, marksOf(*view, volume));
      options.camera = cameraOf(view->look);
      least = std::min(least, view->look.second.value_or(least));
    }
    // a slice shows the skin whatever the isovalue, and may be a profile
    if (choice.slices) least = volume->least;
    face = choice.volume.phantom.empty() && mayShowAFace(*volume, least);
  }
  options.look.slices = choice.slices;
  if (face)
    tell(
        "Skin may be drawn, and a face or a profile can tell who the patient is: look at the film "
        "before you pass it on.");
  if (!options.look.marks.empty())
    tell("Notes are shown as they were written: look whether they name somebody.");

  const auto volumeOf = [&](std::uint32_t id) {
    const auto found = touched.find(id);
    return found == touched.end() ? nullptr : found->second;
  };
  const auto film = makeFilm(*recording, volumeOf, choice.out, options);
  if (!film) return refusedFilm(film.error());
  Outcome outcome;
  outcome.json["film"] = film->film.string();
  outcome.json["steps"] = film->times.string();
  outcome.json["frames"] = film->frames;
  outcome.json["seconds"] = film->seconds;
  outcome.json["codec"] = film->codec;
  outcome.json["surface"] = volume == nullptr                        ? "none"
                            : film->surface == ui::SurfaceMode::Mesh ? "mesh"
                                                                     : "raycast";
  outcome.json["may_show_a_face"] = face;
  return outcome;
}

void addFilmOptions(CLI::App& command, FilmChoice& choice) {
  command.add_option("--size", choice.size, "Width and height in pixels, as 1280x720")
      ->check(CLI::Validator{[](std::string& text) {
                               FilmOptions read;
                               return readSize(text, read) ? std::string{}
                                                           : "\"" + text +
                                                                 "\" is no size; write it as "
                                                                 "1280x720";
                             },
                             "SIZE"});
  command.add_option("--fps", choice.frames_per_second, "Frames per second")
      ->check(wholeNumber(1, 240));
  command.add_option("--speed", choice.speed, "Session time in one second of film [s]")
      ->check(finiteNumber() & CLI::Range(0.001, 1000.0));
  command.add_flag("--burn-in", choice.burn_in, "Show time, force and its curve in the picture");
  command.add_option("--camera", choice.camera, "recorded, or fixed: a view of surface and tool")
      ->check(CLI::IsMember({"recorded", "fixed"}));
  command.add_option("--surface", choice.surface, "How the surface is drawn")
      ->check(CLI::IsMember({"raycast", "mesh"}));
  command.add_flag("--slices", choice.slices, "Show the three slices through the tool beside it");
  command
      .add_option("--view", choice.view,
                  "Show marks, second surface and colours of this saved view, "
                  "NAME.palpate-view; with --camera fixed, from where it looks")
      ->check(notEmpty());
}

}  // namespace app::cli
