// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <memory>

#include "app/cli/commands.h"
#include "datasets/readers/volume_reader.h"

namespace app::cli {
namespace {

using nlohmann::ordered_json;

struct InfoOptions {
  std::string path;
  std::optional<int> series = {};
};

const char* verdictOf(const datasets::SeriesVerdict& series) {
  return series.sound ? "sound" : "refused";
}

ordered_json asJson(const haptics::Vec3& v) { return {v.x(), v.y(), v.z()}; }

/// Metres as millimetres, to the picometre: what the change of unit rounds is not the file's.
haptics::Vec3 inMillimetres(const haptics::Vec3& metres) {
  return (metres * 1e12).array().round() / 1e9;
}

ordered_json listed(const datasets::SeriesVerdict& series) {
  ordered_json json;
  json["index"] = series.index;
  json["modality"] = series.modality;
  json["dims"] = series.dims;
  json["spacing_mm"] = asJson(series.spacing_mm);
  json["verdict"] = verdictOf(series);
  json["reasons"] = series.reasons;
  json["message"] = series.message;
  return json;
}

void describe(const haptics::Volume& volume, const datasets::SeriesVerdict* series,
              ordered_json& json) {
  const haptics::Grid& grid = volume.grid;
  json["dims"] = grid.dims;
  json["spacing_mm"] = asJson(inMillimetres(grid.spacing));
  json["origin_mm"] = asJson(inMillimetres(grid.origin));
  json["direction"] = ordered_json::array();
  for (int row = 0; row < 3; ++row) json["direction"].push_back(asJson(grid.direction.row(row)));
  json["scalar"] = haptics::nameOf(volume.type);
  json["range"] = {volume.least, volume.greatest};
  json["unit"] = volume.unit;
  json["modality"] = volume.modality;
  json["replaced"] = volume.replaced;
  json["verdict"] = "sound";
  std::vector<std::string> reasons =
      series != nullptr ? series->reasons : std::vector<std::string>{};
  json["reasons"] = reasons;
  std::string message = series != nullptr ? series->message : "";
  if (volume.replaced > 0)
    message += " " + std::to_string(volume.replaced) +
               " voxels that are not numbers were made background.";
  json["message"] = message;
}

Outcome info(const InfoOptions& options) {
  auto survey = datasets::survey(options.path);
  if (!survey) return refused(survey.error());
  ordered_json json;
  const datasets::SeriesVerdict* only = nullptr;
  int sound = 0;
  for (const datasets::SeriesVerdict& series : survey->series) {
    if (series.sound) ++sound;
    const bool wanted = options.series ? series.index == *options.series : series.sound;
    if (wanted) only = &series;
  }
  if (options.series && only == nullptr)
    return usage("There is no series " + std::to_string(*options.series) + " in \"" + options.path +
                 "\".");
  if (survey->folder) {
    json["series"] = ordered_json::array();
    for (const datasets::SeriesVerdict& series : survey->series)
      json["series"].push_back(listed(series));
  }
  if (only == nullptr || !only->sound) {
    // nothing here can be loaded: the sentence of what was asked for, or of the first
    const datasets::SeriesVerdict* shown = only != nullptr          ? only
                                           : survey->series.empty() ? nullptr
                                                                    : &survey->series.front();
    json["verdict"] = "refused";
    json["reasons"] = shown != nullptr ? shown->reasons : std::vector<std::string>{"no-pixels"};
    const std::string sentence =
        shown != nullptr ? shown->message : "\"" + options.path + "\" holds no series.";
    json["message"] = sentence;
    return {Exit::Refused, json, {}, sentence};
  }
  if (!options.series && sound > 1) return {Exit::Done, json, {}, {}};
  auto volume = datasets::readVolume(
      options.path, survey->folder ? std::optional<int>{only->index} : options.series);
  if (!volume) {
    json["message"] = volume.error().what;
    return refused(volume.error(), json);
  }
  describe(*volume, only, json);
  return {Exit::Done, json, {}, {}};
}

}  // namespace

void addInfo(CLI::App& program, Chosen& chosen) {
  auto options = std::make_shared<InfoOptions>();
  CLI::App* command =
      program.add_subcommand("info", "What a scan is, and whether it can be trusted");
  command->add_option("path", options->path, "DICOM folder or file, or NRRD")->required();
  command->add_option("--series", options->series, "Which series of a folder");
  command->callback([options, &chosen] { chosen = [options] { return info(*options); }; });
}

}  // namespace app::cli
