// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <utility>

#include "app/cli/commands.h"
#include "app/cli/interrupts.h"
#include "app/cli/sources.h"
#include "datasets/labels/label_file.h"
#include "datasets/labels/phantom_labels.h"
#include "datasets/readers/volume_reader.h"
#include "resources/messages/messages.h"

namespace app::cli {
namespace {

using nlohmann::ordered_json;

const char* verdictOf(const datasets::SeriesVerdict& series) {
  switch (series.verdict) {
    case datasets::Verdict::Sound:
      return "sound";
    case datasets::Verdict::Correctable:
      return "correctable";
    case datasets::Verdict::Refused:
      break;
  }
  return "refused";
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
  json["message"] = resources::sentence(series.message);
  if (const auto& part = series.unbroken_part)
    json["largest_part"] = {{"slices", part->slices},
                            {"of", part->of},
                            {"from_mm", part->from_mm},
                            {"to_mm", part->to_mm}};
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
  json["padded"] = volume.padded;
  json["beyond_bits"] = volume.beyond_bits;
  json["verdict"] = volume.slices_left_out > 0 ? "part" : volume.resampled ? "corrected" : "sound";
  std::vector<std::string> reasons =
      series != nullptr ? series->reasons : std::vector<std::string>{};
  json["reasons"] = reasons;
  std::string message = series != nullptr ? resources::sentence(series->message) : "";
  if (volume.replaced > 0)
    message += " " + std::to_string(volume.replaced) +
               " voxels that are not numbers were made background.";
  if (volume.resampled) message += " This was done.";
  if (volume.slices_left_out > 0) message += " Only this part was read.";
  if (volume.padded > 0)
    message += " " + std::to_string(volume.padded) +
               " voxels are padding, where nothing was measured, and count as air.";
  if (volume.beyond_bits > 0)
    message += " " + std::to_string(volume.beyond_bits) +
               " voxels have bits beyond those that the files state as stored; their values may be "
               "wrong.";
  json["message"] = message;
}

struct InfoOptions {
  VolumeChoice volume;
  std::vector<std::string> labels;
  datasets::LabelReading reading;
  bool names = false;
};

/// Where the voxels of a structure lie in the scan, by index.
struct Extent {
  std::array<std::int64_t, 3> first, end;
  haptics::Vec3 sum = haptics::Vec3::Zero();  ///< of the indices

  void take(const std::array<std::int64_t, 3>& index, std::int64_t before) {
    for (std::size_t a = 0; a < 3; ++a) {
      first[a] = before == 0 ? index[a] : std::min(first[a], index[a]);
      end[a] = before == 0 ? index[a] + 1 : std::max(end[a], index[a] + 1);
      sum[Eigen::Index(a)] += double(index[a]);
    }
  }
};

std::vector<Extent> extentsOf(const datasets::LabelMap& labels) {
  const auto& dims = labels.grid().dims;
  std::vector<Extent> extents(labels.structures().size());
  std::vector<std::int64_t> seen(extents.size(), 0);
  const std::uint8_t* code = labels.codes();
  std::array<std::int64_t, 3> index{};
  for (index[2] = 0; index[2] < dims[2]; ++index[2])
    for (index[1] = 0; index[1] < dims[1]; ++index[1])
      for (index[0] = 0; index[0] < dims[0]; ++index[0], ++code)
        if (*code != 0)
          for (const std::uint8_t number : labels.structuresOf(*code))
            extents[number].take(index, seen[number]++);
  return extents;
}

/// The structures of a label map. Names only where they are asked for: a file's can be patient
/// text.
ordered_json listed(const datasets::LabelMap& labels, bool names) {
  const double voxel_mm3 = 1e9 * labels.grid().spacing.prod();
  const std::vector<Extent> extents = extentsOf(labels);
  ordered_json all = ordered_json::array();
  for (const datasets::Structure& structure : labels.structures()) {
    const Extent& extent = extents[all.size()];
    ordered_json one{{"number", all.size() + 1}};
    if (names) one["name"] = structure.name;
    one["colour"] = structure.colour;
    one["voxels"] = structure.voxels;
    one["volume_mm3"] = double(structure.voxels) * voxel_mm3;
    if (structure.outside > 0)
      one["outside"] = double(structure.outside) / double(structure.marked);
    if (structure.voxels > 0) {
      one["box"] = {{"first", extent.first}, {"end", extent.end}};
      one["centre_mm"] =
          asJson(inMillimetres(labels.grid().worldOf(extent.sum / double(structure.voxels))));
    }
    all.push_back(std::move(one));
  }
  return all;
}

/// The same as a table for people: the numbers of a column end below each other.
std::string tableOf(const ordered_json& structures) {
  const auto numbers = [](const char* format, auto... values) {
    char text[96];
    std::snprintf(text, sizeof text, format, values...);
    return std::string(text);
  };
  std::vector<std::vector<std::string>> rows{
      {"number", "voxels", "volume [mm^3]", "centre x y z [mm]", "outside", "  name"}};
  for (const ordered_json& one : structures) {
    const ordered_json centre = one.value("centre_mm", ordered_json::array());
    rows.push_back({one["number"].dump(), one["voxels"].dump(),
                    numbers("%.1f", one["volume_mm3"].get<double>()),
                    centre.empty() ? "-"
                                   : numbers("%.1f %.1f %.1f", centre[0].get<double>(),
                                             centre[1].get<double>(), centre[2].get<double>()),
                    numbers("%.0f %%", 100.0 * one.value("outside", 0.0)),
                    "  " + one.value("name", "")});
  }
  std::string table;
  for (const std::vector<std::string>& row : rows) {
    std::string line;
    for (std::size_t column = 0; column + 1 < row.size(); ++column) {
      std::size_t width = 0;
      for (const auto& other : rows) width = std::max(width, other[column].size());
      line += std::string(width + 2 - row[column].size(), ' ') + row[column];
    }
    line += row.back();
    table += line.substr(0, line.find_last_not_of(' ') + 1) + '\n';
  }
  return table;
}

/// What is known of a scan and its structures, for people.
std::string textOf(ordered_json json, const ordered_json& structures) {
  const ordered_json labels = json.value("labels", ordered_json::array());
  json.erase("labels");
  if (!structures.empty()) json.erase("structures");
  std::string text = linesOf(json);
  if (!structures.empty()) text += "structures:\n" + tableOf(structures);
  for (const ordered_json& one : labels) {
    text += "labels:\n" + tableOf(one["structures"]);
    for (const ordered_json& note : one.value("notes", ordered_json::array()))
      text += "note: " + note.get<std::string>() + '\n';
  }
  return text;
}

/// Adds the structures of the files that are named.
Outcome withLabels(const InfoOptions& all, const haptics::Volume& volume,
                   const datasets::ScanIdentity& scan, ordered_json json,
                   const ordered_json& structures = {}) {
  datasets::LabelReading reading = all.reading;
  reading.of = scan;
  for (const std::string& path : all.labels) {
    const auto labels = datasets::readLabels(path, volume, {.cancel = &interruption()}, reading);
    if (!labels) return refused(labels.error());
    ordered_json one{{"structures", listed(*labels, all.names)}};
    for (const haptics::Message& note : labels->notes())
      one["notes"].push_back(resources::sentence(note));
    json["labels"].push_back(std::move(one));
  }
  return {Exit::Done, json, textOf(json, structures), {}};
}

Outcome infoOfPhantom(const InfoOptions& all) {
  const auto volume = loadVolume(all.volume);
  if (!volume) return refused(volume.error());
  ordered_json json;
  describe(**volume, nullptr, json);
  const auto labels = datasets::phantomLabels(all.volume.phantom, (*volume)->grid, &interruption());
  if (!labels) return refused(labels.error());
  const ordered_json structures = listed(*labels, true);
  if (!structures.empty()) json["structures"] = structures;
  return withLabels(all, **volume, {}, std::move(json), structures);
}

Outcome info(const InfoOptions& all) {
  const VolumeChoice& options = all.volume;
  if (options.path.empty() == options.phantom.empty())
    return usage("info needs a volume: a path, or --phantom NAME.");
  if (!options.phantom.empty()) return infoOfPhantom(all);
  if (std::filesystem::path(options.path).extension() == ".palpate")
    return refused(
        {haptics::Error::Kind::Unsupported, {"info-recording", {options.path}}, "unreadable"});
  const datasets::ReadProgress progress{.cancel = &interruption()};
  auto survey = datasets::survey(options.path, progress);
  if (!survey) return refused(survey.error());
  const auto loads = [&](const datasets::SeriesVerdict& series) {
    return series.verdict == datasets::Verdict::Sound ||
           (options.correct && series.verdict == datasets::Verdict::Correctable) ||
           (options.largest_part && series.unbroken_part);
  };
  ordered_json json;
  const datasets::SeriesVerdict* only = nullptr;
  const auto loading = std::ranges::count_if(survey->series, loads);
  for (const datasets::SeriesVerdict& series : survey->series)
    if (options.series ? series.index == *options.series : loads(series)) only = &series;
  if (options.series && only == nullptr)
    return usage("There is no series " + std::to_string(*options.series) + " in \"" + options.path +
                 "\".");
  if (survey->several) {
    json["series"] = ordered_json::array();
    for (const datasets::SeriesVerdict& series : survey->series)
      json["series"].push_back(listed(series));
  }
  for (const datasets::StructuresFound& found : survey->structures) {
    const bool drawn = found.kind == datasets::StructuresFound::Kind::Contours;
    json["structures"].push_back({{"file", found.name}, {"kind", drawn ? "contours" : "segments"}});
  }
  if (only == nullptr || !loads(*only)) {
    // nothing here can be loaded: what was asked for, or could be corrected, or the first
    const auto correctable = std::ranges::find(survey->series, datasets::Verdict::Correctable,
                                               &datasets::SeriesVerdict::verdict);
    const datasets::SeriesVerdict* shown = only;
    if (shown == nullptr && correctable != survey->series.end()) shown = &*correctable;
    if (shown == nullptr && !survey->series.empty()) shown = &survey->series.front();
    json["verdict"] = shown != nullptr ? verdictOf(*shown) : "refused";
    json["reasons"] = shown != nullptr ? shown->reasons : std::vector<std::string>{"no-pixels"};
    std::string sentence = shown != nullptr ? resources::sentence(shown->message)
                                            : "\"" + options.path + "\" holds no series.";
    if (shown != nullptr && shown->verdict == datasets::Verdict::Correctable)
      sentence += " Add --correct for that.";
    if (shown != nullptr && shown->unbroken_part)
      sentence += " Add --largest-part to read that alone.";
    json["message"] = sentence;
    return {Exit::Refused, json, {}, sentence};
  }
  if (!options.series && loading > 1) return {Exit::Done, json, {}, {}};
  auto volume = datasets::readVolume(*only, readingOf(options), progress);
  if (!volume) {
    json["message"] = resources::sentence(volume.error());
    return refused(volume.error(), json);
  }
  describe(*volume, only, json);
  return withLabels(all, *volume, datasets::identityOf(*only), std::move(json));
}

}  // namespace

void addInfo(CLI::App& program, Chosen& chosen) {
  auto options = std::make_shared<InfoOptions>();
  CLI::App* command =
      program.add_subcommand("info", "Describe a scan, and whether its geometry can be trusted");
  command
      ->add_option("path", options->volume.path,
                   "Folder, archive, or file (DICOM, NRRD, MetaImage, NIfTI)")
      ->check(notEmpty());
  command->add_option("--phantom", options->volume.phantom, "A named phantom instead of PATH")
      ->check(notEmpty());
  addReading(*command, options->volume);
  command
      ->add_option("--labels", options->labels,
                   "Structures of the scan: a label map (.seg.nrrd, NRRD, MetaImage, NIfTI), a "
                   "DICOM segmentation or structure set, or a surface (STL, OBJ, PLY); repeat it "
                   "for more than one")
      ->allow_extra_args(false)
      ->check(notEmpty());
  command
      ->add_option("--table", options->reading.table,
                   "What names the numbers of the label maps (3D Slicer's .ctbl, ITK-SNAP, "
                   "FreeSurfer)")
      ->check(notEmpty());
  command
      ->add_option_function<std::string>(
          "--space",
          [options](const std::string& name) {
            options->reading.space = datasets::surfaceSpaceNamed(name);
          },
          "Of surfaces that do not state theirs: LPS (x points to the left), or RAS")
      ->check(CLI::IsMember({"LPS", "RAS"}, CLI::ignore_case))
      ->type_name("NAME");
  command->add_flag("--belongs", options->reading.agreed,
                    "Open structures although they are of another frame of reference or patient "
                    "than the scan");
  command->add_flag("--names", options->names,
                    "Print the names of structures too; they can say who the patient is");
  command->callback([options, &chosen] { chosen = [options] { return info(*options); }; });
}

}  // namespace app::cli
