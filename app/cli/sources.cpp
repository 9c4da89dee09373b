// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/sources.h"

#include <strings.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string_view>

#include "app/cli/interrupts.h"
#include "app/cli/options.h"
#include "app/cli/terminal.h"
#include "app/recording/recording.h"
#include "datasets/phantoms/phantoms.h"
#include "haptics/process/input_file.h"
#include "haptics/process/output_file.h"
#include "resources/named_tools.h"
#ifdef PALPATE_READERS
#include "datasets/readers/meshes/tool_mesh.h"
#include "resources/messages/messages.h"
#endif

namespace app::cli {
namespace {

using haptics::Error;

tl::unexpected<Error> malformed(haptics::Message message) {
  return tl::unexpected(Error{Error::Kind::Malformed, std::move(message)});
}

constexpr std::uint64_t kMostIndex = 1'000'000'000;
constexpr std::uintmax_t kLargestTable = std::uintmax_t{4} << 30;  // bytes: hours of a hand
constexpr std::size_t kLongestLine = 64 << 10;                     // bytes
constexpr double kLongest = 0.5;  // m, a tool above this is probably in another unit

bool isPointFile(const ToolChoice& choice) {
  return strcasecmp(std::filesystem::path(choice.name).extension().c_str(), ".csv") == 0;
}

/// The numbers at the begin of a line of a CSV, up to a field that is anything else.
std::vector<double> numbersIn(std::string_view line) {
  std::vector<double> row;
  const char *at = line.data(), *end = line.data() + line.size();
  while (at < end) {
    while (at < end && (*at == ' ' || *at == '\t')) ++at;
    double value = 0.0;
    const auto [stop, error] = std::from_chars(at, end, value);
    if (error != std::errc{}) break;
    at = stop;
    while (at < end && (*at == ' ' || *at == '\t')) ++at;
    if (at < end && *at != ',') break;
    row.push_back(value);
    ++at;
  }
  return row;
}

/// How many fields a line of a CSV has; a comma in quotes ends none.
std::size_t fieldsIn(std::string_view line) {
  std::size_t fields = 1;
  bool quoted = false;
  for (const char c : line) {
    if (c == '"') quoted = !quoted;
    if (c == ',' && !quoted) ++fields;
  }
  return fields;
}

/// The names in the first line of a CSV, without blanks around them and quotes.
std::vector<std::string> namesIn(std::string_view line) {
  constexpr std::string_view kAround = " \t\r\"";
  std::vector<std::string> names;
  for (std::size_t at = 0; at <= line.size();) {
    const std::size_t end = std::min(line.find(',', at), line.size());
    std::string_view name = line.substr(at, end - at);
    name.remove_prefix(std::min(name.find_first_not_of(kAround), name.size()));
    name = name.substr(0, name.find_last_not_of(kAround) + 1);
    names.emplace_back(name);
    at = end + 1;
  }
  return names;
}

haptics::Expected<LoadedTool> toolFromPoints(const ToolChoice& choice) {
  auto rows = readNumbers(choice.name, 3);
  if (!rows) return tl::unexpected(rows.error());
  std::vector<haptics::Vec3> points;
  for (const std::vector<double>& row : rows->rows) points.emplace_back(row[0], row[1], row[2]);
  auto shell = haptics::makeShell(std::move(points));
  if (!shell) return tl::unexpected(shell.error());
  LoadedTool loaded{{"points", {}, std::move(*shell)}, {}};
  const double length = 2.0 * loaded.tool.shell.radius;
  if (length > kLongest)
    loaded.warnings.push_back(
        {"tool-points-length-unusual", {std::to_string(std::lround(length * 1e3))}});
  return loaded;
}

}  // namespace

void addReading(CLI::App& command, VolumeChoice& choice) {
  command
      .add_option("--series", choice.series,
                  "Number of a series of a folder, or of a volume of a file")
      ->check(wholeNumber(0, kMostIndex));
  command.add_flag("--correct", choice.correct,
                   "Resample slices that are tilted or unevenly spaced");
  command.add_flag("--largest-part", choice.largest_part,
                   "If slices are missing, read the largest part without a gap");
  command.add_option("--every", choice.every, "Read only every N-th voxel along each axis")
      ->check(wholeNumber(1, 1000));
  command
      .add_option("--box", choice.box,
                  "Read a box of voxels: first index and the one after the last, along i, j and k")
      ->expected(6)
      ->check(wholeNumber(0, kMostIndex));
}

#ifdef PALPATE_READERS
datasets::Reading readingOf(const VolumeChoice& choice) {
  datasets::Reading reading{
      .series = choice.series, .largest_part = choice.largest_part, .part = {.step = choice.every}};
  if (choice.correct) reading.geometry = datasets::Geometry::Corrected;
  if (choice.box.size() == 6)
    reading.part.box = {.first = {choice.box[0], choice.box[2], choice.box[4]},
                        .end = {choice.box[1], choice.box[3], choice.box[5]}};
  return reading;
}
#endif

#ifdef PALPATE_READERS
namespace {

bool holds(const haptics::Message& message, const std::string& id) {
  return message.id == id ||
         std::ranges::any_of(message.arguments,
                             [&](const haptics::Message& part) { return holds(part, id); });
}

/// Says it if the voxels of a file were rounded, which the volume itself does not know.
void tellRounding(const std::string& path, const haptics::Volume& volume) {
  std::error_code ignored;
  if (volume.type != haptics::ScalarType::Float32 ||
      !std::filesystem::is_regular_file(path, ignored))
    return;
  const auto survey = datasets::survey(path, {.cancel = &interruption()});
  if (survey && std::ranges::any_of(survey->series, [](const datasets::SeriesVerdict& series) {
        return holds(series.message, "volume-doubles-rounded");
      }))
    tell(resources::sentence(haptics::Message{"volume-doubles-rounded", {}}));
}

}  // namespace
#endif

haptics::Expected<std::shared_ptr<const haptics::Volume>> loadVolume(const VolumeChoice& choice) {
  if (!choice.phantom.empty()) {
    auto phantom = datasets::makePhantom(choice.phantom);
    if (!phantom) return tl::unexpected(phantom.error());
    return std::make_shared<const haptics::Volume>(std::move(phantom->volume));
  }
#ifdef PALPATE_READERS
  haptics::keepInput(choice.path);
  auto volume = datasets::readVolume(choice.path, readingOf(choice), {.cancel = &interruption()});
  if (!volume) return tl::unexpected(volume.error());
  tellRounding(choice.path, *volume);
  return std::make_shared<const haptics::Volume>(std::move(*volume));
#else
  return tl::unexpected(Error{Error::Kind::Unsupported, {"build-without-readers", {}}});
#endif
}

haptics::Expected<LoadedTool> loadTool(const ToolChoice& choice) {
  if (resources::findNamedTool(choice.name) != nullptr) {
    auto mesh = resources::namedToolMesh(choice.name);
    if (!mesh) return tl::unexpected(mesh.error());
    auto tool = haptics::makeTool(choice.name, std::move(*mesh), choice.points);
    if (!tool) return tl::unexpected(tool.error());
    return LoadedTool{std::move(*tool), {}};
  }
  if (isPointFile(choice)) return toolFromPoints(choice);
  if (!std::filesystem::path(choice.name).has_extension() && !std::filesystem::exists(choice.name))
    return tl::unexpected(Error{Error::Kind::NotFound,
                                {"name-or-file-unknown", {choice.name, resources::namesOfTools()}},
                                "unknown-name"});
#ifdef PALPATE_READERS
  const std::string named_unit = choice.unit.value_or("mm");
  const auto unit = datasets::meshUnitNamed(named_unit);
  if (!unit)
    return tl::unexpected(
        Error{Error::Kind::Unsupported, {"name-unknown", {named_unit, "m, mm, cm, in"}}});
  haptics::keepInput(choice.name);
  auto read = datasets::readToolMesh(choice.name, *unit);
  if (!read) return tl::unexpected(read.error());
  auto tool = haptics::makeTool("file", std::move(read->mesh), choice.points);
  if (!tool) return tl::unexpected(tool.error());
  return LoadedTool{std::move(*tool), std::move(read->warnings)};
#else
  return tl::unexpected(Error{Error::Kind::Unsupported, {"build-without-readers", {}}});
#endif
}

std::optional<std::string> contradictionIn(const ToolChoice& choice) {
  if (!isPointFile(choice) || (choice.points == 0 && !choice.unit)) return {};
  return "A CSV holds the tool's points in metres, and no mesh: leave out " +
         std::string(choice.unit ? "--tool-unit" : "--points") + ".";
}

std::optional<std::string> overwritten(const std::vector<Target>& targets,
                                       const VolumeChoice& volume,
                                       const std::vector<std::string>& inputs) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  std::optional<std::vector<fs::path>> read;  // sought only where something could be lost
  for (std::size_t n = 0; n < targets.size(); ++n) {
    const Target& target = targets[n];
    const fs::path whole = fs::weakly_canonical(target.path, ignored);
    for (std::size_t m = 0; m < n; ++m)
      if (whole == fs::weakly_canonical(targets[m].path, ignored) ||
          (fs::is_regular_file(target.path, ignored) &&
           fs::equivalent(target.path, targets[m].path, ignored)))
        return target.option + " and " + targets[m].option + " name the same file, \"" +
               target.path + "\"; give each its own.";
    if (!fs::is_regular_file(target.path, ignored)) continue;
    if (!read) {
      read.emplace(inputs.begin(), inputs.end());
#ifdef PALPATE_READERS
      if (!volume.path.empty())
        std::ranges::move(datasets::filesReadFor(volume.path, {.cancel = &interruption()}),
                          std::back_inserter(*read));
#else
      (void)volume;
#endif
    }
    // by device and number, so that no link hides it
    if (std::ranges::any_of(*read, [&](const fs::path& input) {
          return fs::equivalent(target.path, input, ignored);
        }))
      return target.option + " \"" + target.path +
             "\" is a file that is read here, and would be lost; name another.";
  }
  return {};
}

haptics::Expected<ViewFile> viewOver(const std::string& path, const haptics::Volume& scan,
                                     const std::optional<VolumeHash>& hash) {
  haptics::keepInput(path);
  auto view = readViewFile(path);
  if (!view) return view;
  haptics::Volume of_view;
  of_view.grid = view->grid;
  of_view.type = view->type;
  if (!liesLike(of_view, scan) || compared(view->hash, hash) == SameVolume::Another)
    return tl::unexpected(
        Error{Error::Kind::Unsupported, {"view-other-scan", {path}}, "another-volume"});
  return view;
}

haptics::Expected<NumberTable> readNumbers(const std::string& path, std::size_t columns) {
  haptics::keepInput(path);
  auto file = haptics::openInput(path, kLargestTable);
  if (!file) return tl::unexpected(std::move(file.error()));
  using haptics::LineRead;
  const auto tooLong = [&](std::size_t number) {
    return malformed({"table-line-long", {path, std::to_string(number)}});
  };
  std::string line;
  LineRead read = haptics::takeLine(*file, line, kLongestLine);
  if (read == LineRead::End) return malformed({"table-empty", {path}});
  if (read == LineRead::TooLong) return tooLong(1);
  NumberTable table{namesIn(line), {}, {}};
  if (numbersIn(line).size() == fieldsIn(line)) return malformed({"table-no-names", {path}});
  for (std::size_t number = 2;
       (read = haptics::takeLine(*file, line, kLongestLine)) != LineRead::End; ++number) {
    if (read == LineRead::TooLong) return tooLong(number);
    if (line.empty()) continue;
    std::vector<double> row = numbersIn(line);
    if (row.size() < columns)
      return malformed(
          {"table-row-short", {path, std::to_string(columns), std::to_string(number)}});
    // "0,5,1,5": decimal commas
    if (fieldsIn(line) > table.names.size())
      return malformed({"table-row-long", {path, std::to_string(number)}});
    for (std::size_t c = 0; c < columns; ++c)
      if (!std::isfinite(row[c]))
        return malformed({"table-not-finite", {path, table.names[c], std::to_string(number)}});
    table.rows.push_back(std::move(row));
    table.lines.push_back(number);
  }
  if (table.rows.empty()) return malformed({"table-empty", {path}});
  return table;
}

}  // namespace app::cli
