// SPDX-License-Identifier: BSD-3-Clause
#include <memory>
#include <optional>

#include "app/build_info/build_info.h"
#include "app/cli/commands.h"
#include "app/cli/interrupts.h"
#include "app/cli/recorded_run.h"
#include "app/cli/sources.h"
#include "app/export/facts.h"
#include "app/recording/cut_words.h"
#include "app/recording/facts.h"
#include "app/recording/replay.h"
#include "app/recording/unfinished.h"
#ifdef PALPATE_READERS
#include "app/cli/watching.h"
#endif

namespace app::cli {
namespace {

struct ReplayOptions {
  std::string file = {};
  VolumeChoice volume;
#ifdef PALPATE_READERS
  WatchChoice watch;
#endif
};

/// Whether this installation made it: the programs of one have builds of their own, and a commit.
bool isOfThisBuild(const Recording& recording) {
  if (recording.build() == buildHere()) return true;
  const std::string commit = commitHere();
  return recording.version() == versionHere() && commit != "unknown" &&
         commit.find('-') == std::string::npos &&
         exporting::factsOf(recording).value("commit", "") == commit;
}

Outcome replay(const ReplayOptions& options) {
  if (options.volume.path.empty() == options.volume.phantom.empty())
    return usage("replay needs either --volume or --phantom: a recording holds no voxels.");
  auto recording = Recording::open(options.file);
  if (!recording) return refused(recording.error());
  const auto volume = loadVolume(options.volume);
  if (!volume) return refused(volume.error());

  const auto hash = hashHere(**volume);
  bool fits = false, known = true, same = true;
  for (const RecordedScene& scene : recording->scenes()) {
    if (!liesLike(scene.volume, **volume)) continue;
    fits = true;
    const SameVolume compared = app::compared(hash, scene.hash);
    known = known && compared == SameVolume::Same;
    same = same && compared != SameVolume::Another;
  }
  if (!fits) {
    Outcome outcome = failed(
        "The volume is not the one that was recorded: its voxels are others in number, place or "
        "type; give the one that was touched.");
    outcome.json["volume"] = "another";
    outcome.json["reasons"] = {"another-volume"};
    return outcome;
  }
  std::shared_ptr<const haptics::Watch> watch;
#ifdef PALPATE_READERS
  const auto labels = labelsOf(options.watch, **volume);
  if (!labels) return refused(labels.error());
  auto watched = watchOver(options.watch, *labels);
  if (!watched) return refused(watched.error());
  watch = *watched;
#endif
  std::optional<haptics::Error> failed;
  std::shared_ptr<const haptics::Scene> last;
  const auto sceneOf = [&](std::uint32_t id) -> std::shared_ptr<const haptics::Scene> {
    const RecordedScene* then = recording->scene(id);
    if (then == nullptr || !liesLike(then->volume, **volume)) return nullptr;
    const auto touched =
        touchedAsRecorded(*volume, *then, watch.get(), last ? last->volume : nullptr);
    if (!touched) {
      failed = touched.error();
      return nullptr;
    }
    auto made = haptics::makeScene(*touched, then->tool, then->options, last.get());
    if (!made) {
      failed = made.error();
      return nullptr;
    }
    return last = *made;
  };
  const auto difference = replay(
      *recording, sceneOf, [](double) { return !interrupted(); }, watch.get());
  if (!difference) return refused(difference.error());
  if (failed) return refused(*failed);

  Outcome outcome;
  outcome.json["steps"] = difference->steps;
  outcome.json["skipped"] = difference->skipped;
  outcome.json["differing"] = difference->differing;
  if (difference->first) outcome.json["first_differing"] = *difference->first;
  outcome.json["max_distance_mm"] = difference->distance * 1e3;
  outcome.json["max_angle_rad"] = difference->angle;
  outcome.json["max_force_N"] = difference->force;
  outcome.json["max_torque_Nm"] = difference->torque;
  if (watch) {
    outcome.json["distances"] = difference->distances;
    outcome.json["differing_distances"] = difference->differing_distances;
  }
  const bool carved_same = difference->differing_carved == 0;
  if (difference->carved) {
    outcome.json["cuts"] = difference->cuts;
    outcome.json["differing_cuts"] = difference->differing_cuts;
    outcome.json["carved"] = app::wordOf(*difference->carved);
    outcome.json["carved_as_recorded"] = difference->carved_said > 0
                                             ? nlohmann::ordered_json(carved_same)
                                             : nlohmann::ordered_json();
  }
  outcome.json["volume"] = !same ? "another" : known ? "same" : "unknown";
  outcome.json["recorded_by"] = recording->version();
  outcome.json["same_build"] = isOfThisBuild(*recording);
  outcome.json["recorded_vectors"] = recording->vectors();
  if (difference->steps == 0) {
    outcome.code = Exit::Refused;
    outcome.error = "Nothing could be replayed: no step was recorded in this volume.";
  } else if (!same) {
    outcome.code = Exit::Failed;
    outcome.error =
        std::string{"The volume is not the one that was recorded: its voxels have other values. "} +
        (difference->differing > 0 ? "The replay differs from the recording."
                                   : "No step that was recorded came across them.");
    outcome.json["reasons"] = {"another-volume"};
  } else if (difference->differing > 0 || difference->differing_distances > 0 ||
             difference->differing_cuts > 0 || !carved_same) {
    outcome.code = Exit::Failed;
    outcome.error = "The replay differs from the recording.";
  }
  return outcome;
}

Outcome recover(const std::string& file) {
  const auto recovered = app::recover(file);
  if (!recovered) return refused(recovered.error());
  auto recording = Recording::open(*recovered);
  if (!recording) return refused(recording.error());
  Outcome outcome;
  outcome.json["file"] = recovered->string();
  outcome.json["steps"] = recording->stepCount();
  outcome.json["lost"] = recording->lostCount();
  outcome.json["seconds"] = recording->end() - recording->begin();
  return outcome;
}

}  // namespace

void addReplay(CLI::App& program, Chosen& chosen) {
  auto options = std::make_shared<ReplayOptions>();
  CLI::App* command = program.add_subcommand(
      "replay", "Run the present algorithm along a recorded path, and compare");
  command->add_option("file", options->file, "A recording")->required()->check(notEmpty());
  auto* path = command->add_option(
      "--volume", options->volume.path,
      "The scan that was touched: DICOM folder or file, NRRD, MetaImage, NIfTI");
  path->check(notEmpty());
  command->add_option("--phantom", options->volume.phantom, "A named phantom")
      ->excludes(path)
      ->check(notEmpty());
  addReading(*command, options->volume);
#ifdef PALPATE_READERS
  addWatching(*command, options->watch, false);
#endif
  command->callback([options, &chosen] { chosen = [options] { return replay(*options); }; });
}

void addRecover(CLI::App& program, Chosen& chosen) {
  auto file = std::make_shared<std::string>();
  CLI::App* command = program.add_subcommand("recover", "Make a recording of an unfinished one");
  command->add_option("file", *file, "NAME.palpate.part")->required()->check(notEmpty());
  command->callback([file, &chosen] { chosen = [file] { return recover(*file); }; });
}

}  // namespace app::cli
