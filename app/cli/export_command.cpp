// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <utility>

#include "app/cli/commands.h"
#include "app/cli/interrupts.h"
#include "app/cli/recorded_run.h"
#include "app/cli/sources.h"
#include "app/cli/terminal.h"
#include "app/export/export.h"
#include "app/recording/replay.h"
#ifdef PALPATE_FILM
#include "app/cli/film_export.h"
#endif

namespace app::cli {
namespace {

struct ExportCommand {
  std::string file, format, out, idle;
  exporting::ExportOptions options;
  VolumeChoice volume;
#ifdef PALPATE_FILM
  FilmChoice film;
#endif
};

std::vector<std::string> formatNames() {
  std::vector<std::string> names;
  for (const exporting::Format& format : exporting::kFormats) names.emplace_back(format.name);
  names.emplace_back("video");
  return names;
}

#ifndef PALPATE_FILM
constexpr const char* kNoFilms =
    "Films are made by palpate-draw, which is not installed; install the package palpate, or build "
    "Palpate with its window.";
#endif

// Options of tables, and those of the volume, which films and HDF5 have; the others but kOfAll are
// of films.
constexpr std::array kOfTables{"--rate", "--no-contacts"};
constexpr std::array kOfVolume{"--volume",       "--phantom", "--series", "--correct",
                               "--largest-part", "--every",   "--box"};
constexpr std::array kOfAll{"file", "--format", "--out", "--from", "--to", "--json"};

/// The option that was given and says nothing about the format; empty: none.
std::string idleOption(const CLI::App& command, const std::string& format) {
  const bool film = format == "video", volume = film || format == "hdf5";
  for (const CLI::Option* option : command.get_options()) {
    const std::string name = option->get_name();
    const auto isOne = [&](const auto& of) { return std::ranges::count(of, name) > 0; };
    if (option->count() == 0 || isOne(kOfAll)) continue;
    const bool fits = isOne(kOfTables) ? !film : isOne(kOfVolume) ? volume : film;
    if (!fits) return name;
  }
  return {};
}

/// The volumes of the recording's scenes before their first cut.
haptics::Expected<std::map<std::uint32_t, std::shared_ptr<const haptics::Volume>>> volumesOf(
    const Recording& recording, const VolumeChoice& choice) {
  const auto scan = loadVolume(choice);
  if (!scan) return tl::unexpected(scan.error());
  auto volumes = editedAsRecorded(*scan, hashHere(**scan), recording);
  if (volumes && volumes->empty())
    return tl::unexpected(haptics::Error{
        haptics::Error::Kind::Unsupported, {"film-other-volume", {}}, "another-volume"});
  return volumes;
}

Outcome run(ExportCommand command) {
  if (!command.idle.empty())
    return usage(command.idle + " does not go with --format " + command.format + ".");
  if (command.options.from > command.options.to) return usage("--from must not be after --to.");
#ifdef PALPATE_FILM
  if (command.format == "video") {
    command.film.recording = command.file;
    command.film.out = command.out;
    command.film.from = command.options.from;
    command.film.to = command.options.to;
    command.film.volume = command.volume;
    return exportFilm(command.film);
  }
#else
  if (command.format == "video") return failed(kNoFilms);
#endif
  const exporting::Format& format = *std::ranges::find_if(
      exporting::kFormats, [&](const auto& one) { return one.name == command.format; });
  if (!command.out.ends_with(format.ending))
    return usage("\"" + command.out + "\" must end in " + format.ending + ".");
  std::vector<Target> targets;
  if (format.files.empty()) targets.push_back({"--out", command.out});
  if (format.beside != nullptr) {
    std::filesystem::path beside = command.out;
    targets.push_back({"the dictionary of --out", beside.replace_extension(format.beside)});
  }
  for (const char* ending : format.files) targets.push_back({"--out", command.out + ending});
  if (const auto wrong = overwritten(targets, command.volume, {command.file})) return usage(*wrong);
  auto recording = Recording::open(command.file);
  if (!recording) return refused(recording.error());
  command.options.goes_on = [](double) { return !interrupted(); };
  if (!command.volume.path.empty() || !command.volume.phantom.empty()) {
    auto volumes = volumesOf(*recording, command.volume);
    if (!volumes) return refused(volumes.error());
    command.options.volume = [volumes = std::move(*volumes)](std::uint32_t scene) {
      const auto found = volumes.find(scene);
      return found == volumes.end() ? nullptr : found->second;
    };
  }
  const auto exported = format.write(*recording, command.out, command.options);
  if (!exported) return refused(exported.error());
  Outcome outcome;
  outcome.json["format"] = format.name;
  outcome.json["steps"] = exported->steps;
  outcome.json["events"] = exported->events;
  outcome.json["bytes"] = exported->bytes;
  outcome.json["files"] = exported->files;
  if (exported->removed_voxels) outcome.json["removed_voxels"] = *exported->removed_voxels;
  if (exported->cuts_without_voxels > 0)
    tell(
        "The voxels that the cuts removed are left out: they need the volume that was touched, by "
        "--volume or --phantom.");
  outcome.aside = isStandardOutput(command.out);
  return outcome;
}

}  // namespace

void addExport(CLI::App& program, Chosen& chosen) {
  auto options = std::make_shared<ExportCommand>();
  CLI::App* command =
      program.add_subcommand("export", "Write a recording in a format that other programs read");
  command->add_option("file", options->file, "A recording, NAME.palpate")
      ->required()
      ->check(notEmpty());
  command->add_option("--format", options->format, "csv, motion-bids, hdf5, mcap, or video")
      ->required()
      ->check(CLI::IsMember(formatNames()));
  command
      ->add_option(
          "--out", options->out,
          "File to write; beside an OUT.csv OUT.columns.json explains it; for motion-bids the "
          "beginning of the files' names: OUT_motion.tsv and so on; a video is an .mp4 or .ogv")
      ->required()
      ->check(notEmpty());
  command->add_option("--from", options->options.from, "Leave out everything before this time [s]")
      ->check(finiteNumber());
  command->add_option("--to", options->options.to, "Leave out everything after this time [s]")
      ->check(finiteNumber());
  command
      ->add_option("--rate", options->options.rate, "Steps per second [Hz]; by default all steps")
      ->check(finiteNumber() & CLI::Range(0.001, 1e6));
  command->add_flag_callback(
      "--no-contacts", [options] { options->options.contacts = false; }, "Leave out the contacts");
  auto* path =
      command->add_option("--volume", options->volume.path,
                          "The scan that was touched: for a film, which shows only the "
                          "tool without it, and for the voxels that cuts removed, in hdf5");
  path->check(notEmpty());
  command->add_option("--phantom", options->volume.phantom, "The phantom that was touched")
      ->excludes(path)
      ->check(notEmpty());
  addReading(*command, options->volume);
#ifdef PALPATE_FILM
  addFilmOptions(*command, options->film);
#endif
  command->callback([options, command, &chosen] {
    options->idle = idleOption(*command, options->format);
    chosen = [options] { return run(*options); };
  });
}

}  // namespace app::cli
