// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/commands.h"
#include "app/cli/interrupts.h"
#include "app/cli/recorded_run.h"
#include "app/cli/sources.h"
#include "app/cli/terminal.h"
#include "app/cli/watching.h"
#include "app/export/text.h"
#include "app/report/report.h"
#include "haptics/process/output_file.h"

namespace app::cli {
namespace {

namespace fs = std::filesystem;

constexpr double kMargins_mm[] = {1.0, 2.0, 5.0};
constexpr std::size_t kMostMargins = 5;  // that a picture tells apart beside two sessions
constexpr std::size_t kLongestName = 128;

struct ReportOptions {
  std::vector<std::string> files = {};
  VolumeChoice volume = {};
  WatchChoice watch = {};
  std::vector<std::string> margins = {}, names = {};
  std::string out = {};
};

/// "3=text" as the number and the text.
std::optional<std::pair<int, std::string>> numbered(const std::string& text) {
  const std::size_t equals = text.find('=');
  int number = 0;
  if (equals == std::string::npos) return {};
  const auto read = std::from_chars(text.data(), text.data() + equals, number);
  if (read.ec != std::errc{} || read.ptr != text.data() + equals) return {};
  return std::pair{number, text.substr(equals + 1)};
}

/// Millimetres, more than 0; none for anything else.
std::optional<double> millimetresIn(const std::string& text) {
  double mm = 0.0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), mm);
  if (read.ec != std::errc{} || read.ptr != text.data() + text.size() || !(mm > 0.0)) return {};
  return mm;
}

/// The structures of the watch with the margins and names of the options; an outcome if these make
/// no sense.
std::optional<Outcome> describe(const ReportOptions& options, const haptics::Watch& watch,
                                std::vector<report::Structure>& structures) {
  for (const haptics::Watch::Watched& watched : watch.structures)
    structures.push_back({.number = numberOf(watched),
                          .error = watched.distances.error,
                          .told = watched.distances.told()});
  const auto structureOf = [&](int number) {
    return std::ranges::find(structures, number, &report::Structure::number);
  };
  for (const std::string& text : options.margins) {
    const auto said = numbered(text);
    const auto mm = said ? millimetresIn(said->second) : std::nullopt;
    if (!mm) return usage("\"" + text + "\" is no margin; write N=MM, such as 2=1.5.");
    const auto structure = structureOf(said->first);
    if (structure == structures.end())
      return usage("--margin " + text + ": structure " + std::to_string(said->first) +
                   " is not in the report; see info --labels, and --watch.");
    if (*mm * 1e-3 >= double(float(structure->told)))
      return usage("--margin " + text + ": distances are known up to " +
                   exporting::numberOf(structure->told * 1e3) + " mm; choose a smaller margin.");
    if (structure->margins.size() == kMostMargins)
      return usage("--margin " + text + ": a structure has at most " +
                   std::to_string(kMostMargins) + " margins.");
    structure->margins.push_back(*mm * 1e-3);
  }
  for (report::Structure& structure : structures) {
    if (structure.margins.empty())
      for (const double mm : kMargins_mm) structure.margins.push_back(mm * 1e-3);
    std::ranges::sort(structure.margins);
    const auto same = std::ranges::unique(structure.margins);
    structure.margins.erase(same.begin(), same.end());
  }
  for (const std::string& text : options.names) {
    const auto said = numbered(text);
    if (!said || said->second.empty() || said->second.size() > kLongestName)
      return usage("\"" + text + "\" is no name; write N=TEXT, such as \"2=facial nerve\".");
    const auto structure = structureOf(said->first);
    if (structure == structures.end())
      return usage("--name " + text + ": structure " + std::to_string(said->first) +
                   " is not in the report; see info --labels, and --watch.");
    structure->name = exporting::plain(said->second);
  }
  return {};
}

struct ReportFile {
  const char* ending;
  std::string (*text)(const report::Report&);
};
constexpr ReportFile kReportFiles[] = {
    {".html", report::htmlOf},
    {".json", [](const report::Report& all) { return report::jsonOf(all).dump(2) + "\n"; }},
    {".csv", report::csvOf}};

/// Where each of them is written; empty: not.
std::map<std::string, std::string> placesIn(const std::string& out) {
  std::map<std::string, std::string> places;
  for (const ReportFile& file : kReportFiles)
    if (out.ends_with(file.ending)) return {{file.ending, out}};
  for (const ReportFile& file : kReportFiles)
    places[file.ending] = (fs::path{out} / (std::string{"report"} + file.ending)).string();
  return places;
}

Outcome anotherScan(std::string sentence) {
  Outcome outcome = failed(std::move(sentence));
  outcome.json["reasons"] = {"another-volume"};
  return outcome;
}

/// For people: what to look at first.
std::string wordsFor(const report::Report& all, const std::vector<std::string>& files) {
  std::string text;
  for (const std::string& file : files) text += printable(file) + "\n";
  for (std::size_t s = 0; s < all.sessions.size(); ++s) {
    const report::Session& session = all.sessions[s];
    for (std::size_t n = 0; n < all.structures.size(); ++n) {
      const report::FiguresOf& figures = session.figures.structures[n];
      const auto mm = exporting::numberOf(std::round(figures.nearest.value * 1e5) * 1e-2);
      text += "session " + std::to_string(s + 1) + ", structure " +
              std::to_string(all.structures[n].number) + ": " +
              (std::isfinite(figures.nearest.at)
                   ? "nearest " + mm + " mm at " + exporting::numberOf(figures.nearest.at) + " s"
                   : mm + " mm or more away") +
              ", contacts " + std::to_string(figures.encounter_count) +
              (session.guarded[n] ? ", injuries " + std::to_string(figures.injury_count) : "") +
              "\n";
    }
  }
  return text;
}

Outcome makeReport(const ReportOptions& options) {
  const auto places = placesIn(options.out);
  std::vector<Target> targets;
  for (const auto& [ending, place] : places) targets.push_back({"--out", place});
  std::vector<std::string> inputs = options.files;
  inputs.push_back(options.watch.labels);
  if (const auto wrong = overwritten(targets, options.volume, inputs)) return usage(*wrong);

  std::vector<Recording> recordings;
  for (const std::string& file : options.files) {
    auto recording = Recording::open(file);
    if (!recording) return refused(recording.error());
    recordings.push_back(std::move(*recording));
  }
  // without a volume the labels lie where the first recording says that its scan was
  auto given = std::make_shared<const haptics::Volume>(
      recordings.front().scenes().empty() ? haptics::Volume{}
                                          : recordings.front().scenes().front().volume);
  std::optional<VolumeHash> hash;
  if (!options.volume.path.empty() || !options.volume.phantom.empty()) {
    const auto volume = loadVolume(options.volume);
    if (!volume) return refused(volume.error());
    given = *volume;
    hash = hashHere(*given);
  }
  const haptics::Volume& scan = *given;
  for (std::size_t n = 0; n < recordings.size(); ++n)
    if (std::ranges::none_of(recordings[n].scenes(),
                             [&](const RecordedScene& scene) { return isOf(scene, scan, hash); }))
      return anotherScan("\"" + options.files[n] +
                         "\" was not recorded with this scan: its voxels are others, or lie "
                         "elsewhere; give recordings of one scan, and that scan or none.");
  const auto labels = labelsOf(options.watch, scan);
  if (!labels) return refused(labels.error());
  const auto watch = watchOver(options.watch, *labels);
  if (!watch) return refused(watch.error());

  report::Report all;
  if (auto wrong = describe(options, **watch, all.structures)) return *wrong;
  std::vector<std::vector<double>> margins;
  for (const report::Structure& structure : all.structures) margins.push_back(structure.margins);
  for (Recording& recording : recordings) {
    auto session = report::sessionOf(recording, **watch, given, hash, margins,
                                     [](double) { return !interrupted(); });
    if (!session) return refused(session.error());
    if (session->differing > 0)
      tell(
          "Distances in the recording are others than those to these labels; the report is of the "
          "labels that were given.");
    all.sessions.push_back(std::move(*session));
  }

  std::error_code ignored;
  if (places.size() > 1) fs::create_directories(options.out, ignored);
  std::vector<std::string> files;
  for (const ReportFile& file : kReportFiles) {
    const auto place = places.find(file.ending);
    if (place == places.end()) continue;
    if (auto written = haptics::writeFile(place->second, file.text(all)); !written)
      return refused(written.error());
    files.push_back(place->second);
  }
  Outcome outcome;
  outcome.json = report::jsonOf(all);
  outcome.json["files"] = files;
  outcome.text = wordsFor(all, files);
  return outcome;
}

}  // namespace

void addReport(CLI::App& program, Chosen& chosen) {
  auto options = std::make_shared<ReportOptions>();
  CLI::App* command = program.add_subcommand(
      "report", "Say what a session was: time, path, forces, and distances to structures");
  command->add_option("files", options->files, "A recording, or two to be beside each other")
      ->required()
      ->expected(1, 2)
      ->check(notEmpty());
  auto* path = command->add_option(
      "--volume", options->volume.path,
      "The scan that was touched; without it the labels are laid where the recording says it was");
  path->check(notEmpty());
  command->add_option("--phantom", options->volume.phantom, "A named phantom instead of the scan")
      ->excludes(path)
      ->check(notEmpty());
  addReading(*command, options->volume);
  addWatching(*command, options->watch, false);
  command->get_option("--labels")->required();
  command
      ->add_option("--margin", options->margins,
                   "N=MM: times within so many mm of structure N; repeat it for more than one; "
                   "without it 1, 2 and 5 mm")
      ->allow_extra_args(false);
  command
      ->add_option("--name", options->names,
                   "N=TEXT: your own name of structure N, for the report alone; repeat it for more "
                   "than one")
      ->allow_extra_args(false);
  command
      ->add_option("--out", options->out,
                   "Folder for report.html, report.json and report.csv, or one file that ends so")
      ->required()
      ->check(notEmpty());
  command->callback([options, &chosen] { chosen = [options] { return makeReport(*options); }; });
}

}  // namespace app::cli
