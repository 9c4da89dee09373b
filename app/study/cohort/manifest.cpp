// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/cohort/manifest.h"

#include <strings.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <map>
#include <set>
#include <sstream>

#include "haptics/process/input_file.h"
#include "haptics/process/output_file.h"
#include "haptics/settings.h"
#include "resources/named_tools.h"

namespace cohort {
namespace {

namespace fs = std::filesystem;
using haptics::Error;
using haptics::Expected;

constexpr std::uintmax_t kLargestManifest = 64 << 20;  // bytes
constexpr std::size_t kLongestLine = 64 << 10;         // bytes
constexpr int kMostRepetitions = 10'000;
constexpr double kLongest = 3600.0;  // s of a touch
constexpr std::size_t kLongestLabel = 64;

/// HU at which a tissue begins, seen from the air; as the window's presets.
const std::map<std::string, double>& rules() {
  static const std::map<std::string, double> kRules{{"bone", 300.0}, {"skin", -300.0}};
  return kRules;
}

tl::unexpected<Error> refused(std::string sentence, const char* reason = "manifest") {
  return tl::unexpected(Error{Error::Kind::Malformed, std::move(sentence), reason});
}

/// The whole text as a number; none where anything is left over.
template <class Number>
std::optional<Number> numberIn(const std::string& text) {
  Number value{};
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || stop != end) return {};
  return value;
}

std::vector<std::string> partsOf(const std::string& text, char between) {
  std::vector<std::string> parts;
  std::string part;
  std::istringstream stream(text);
  while (std::getline(stream, part, between)) parts.push_back(part);
  if (text.empty() || text.back() == between) parts.emplace_back();
  return parts;
}

bool isLabel(const std::string& text) {
  return !text.empty() && text.size() <= kLongestLabel && std::ranges::all_of(text, [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
           c == '_';
  });
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

/// Takes a cell of this column into the line; a sentence without its beginning where it cannot.
std::optional<std::string> take(const std::string& column, const std::string& cell, Line& line) {
  Touching& touching = line.touching;
  const auto number = [&](double least, double most, double& to) -> std::optional<std::string> {
    const auto value = numberIn<double>(cell);
    if (!value || !(*value >= least && *value <= most)) {
      std::ostringstream words;
      words << "is no number from " << least << " to " << most << ", with a point as decimal mark";
      return words.str();
    }
    to = *value;
    return {};
  };
  if (column == "label") {
    if (!isLabel(cell)) return "is no label: up to 64 letters, digits, - and _";
    line.label = cell;
  } else if (column == "series") {
    const auto series = numberIn<int>(cell);
    if (!series || *series < 0) return "is no number of a series";
    line.series = series;
  } else if (column == "isovalue") {
    const auto value = numberIn<double>(cell);
    if (!rules().contains(cell) && !(value && std::isfinite(*value)))
      return "is neither a number nor a rule: bone, skin";
    touching.isovalue = cell;
  } else if (column == "tool") {
    touching.tools = partsOf(cell, ',');
    for (const std::string& tool : touching.tools)
      if (resources::findNamedTool(tool) == nullptr &&
          !(tool == kOwnMesh && !touching.mesh.empty()))
        return "names no tool of " + resources::namesOfTools();
  } else if (column == "hand") {
    touching.hands = partsOf(cell, ',');
    for (const std::string& hand : touching.hands)
      if (std::ranges::find(handNames(), hand) == handNames().end())
        return "names no hand of " + joined(handNames());
  } else if (column == "repetitions") {
    const auto count = numberIn<int>(cell);
    if (!count || *count < 1 || *count > kMostRepetitions)
      return "is no whole number from 1 to " + std::to_string(kMostRepetitions);
    touching.repetitions = *count;
  } else if (column == "seconds") {
    return number(0.001, kLongest, touching.seconds);
  } else if (column == "stiffness") {
    return number(haptics::kStiffnessRange.least, haptics::kStiffnessRange.most,
                  touching.stiffness);
  }
  return {};
}

const std::vector<std::string>& columns() {
  static const std::vector<std::string> kColumns{"path",      "label",    "series",      "isovalue",
                                                 "tool",      "hand",     "repetitions", "seconds",
                                                 "stiffness", "recording"};
  return kColumns;
}

/// What is asked for, in words that hold no path.
std::string wordsOf(const Line& line) {
  const Touching& t = line.touching;
  std::ostringstream words;
  words.precision(17);
  words << line.label << '\t' << line.series.value_or(-1) << '\t' << t.isovalue << '\t'
        << joined(t.tools) << '\t' << joined(t.hands) << '\t' << t.repetitions << '\t' << t.seconds
        << '\t' << t.stiffness << '\t' << !line.recording.empty() << '\n';
  // what was not asked for leaves the identity as it was before it could be
  const Touching usual;
  const auto add = [&](const char* name, const auto& value, const auto& before) {
    if (value != before) words << name << '\t' << value << '\n';
  };
  add("angular_stiffness", t.angular_stiffness, usual.angular_stiffness);
  add("friction", t.friction, usual.friction);
  add("field", t.field, usual.field);
  add("normals", t.normals, usual.normals);
  add("epsilon", t.fineness.epsilon, usual.fineness.epsilon);
  add("sub_steps", t.fineness.sub_steps, usual.fineness.sub_steps);
  add("rate", t.rate.hz, usual.rate.hz);
  add("budget", t.budget_us, usual.budget_us);
  add("seed", t.seed, usual.seed);
  add("mesh", t.mesh_hash, usual.mesh_hash);
  return words.str();
}

Manifest manifestOf(std::vector<Line> lines) {
  std::uint64_t hash = 14695981039346656037ULL;  // FNV-1a
  for (const Line& line : lines)
    for (const char c : wordsOf(line))
      hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
  return {std::move(lines), text};
}

Expected<Manifest> readTable(const fs::path& path, const Touching& otherwise) {
  haptics::keepInput(path);
  auto file = haptics::openInput(path, kLargestManifest);
  if (!file) return tl::unexpected(std::move(file.error()));
  std::vector<std::string> heads;
  std::vector<Line> lines;
  std::set<std::string> labels;
  std::string text;
  using haptics::LineRead;
  LineRead read = LineRead::Whole;
  for (int n = 1; (read = haptics::takeLine(*file, text, kLongestLine)) != LineRead::End; ++n) {
    if (read == LineRead::TooLong)
      return refused("Line " + std::to_string(n) +
                     " of the manifest is longer than 64 kB; check that it is a manifest.");
    if (text.empty()) continue;
    const std::vector<std::string> cells = partsOf(text, '\t');
    if (heads.empty()) {
      heads = cells;
      for (const std::string& head : heads)
        if (std::ranges::find(columns(), head) == columns().end() ||
            std::ranges::count(heads, head) > 1)
          return refused("The manifest has a column \"" + head +
                         "\", which is unknown or there twice; the columns are " +
                         joined(columns()) + ", parted by tabs.");
      if (std::ranges::find(heads, "path") == heads.end())
        return refused("The manifest has no column \"path\".");
      continue;
    }
    const std::string where = "Line " + std::to_string(n) + " of the manifest";
    if (cells.size() != heads.size())
      return refused(where + " has " + std::to_string(cells.size()) + " cells and not " +
                     std::to_string(heads.size()) +
                     ", as its first line; cells are parted by tabs.");
    Line line;
    line.touching = otherwise;
    for (std::size_t c = 0; c < heads.size(); ++c) {
      if (cells[c].empty() || cells[c] == "n/a") continue;
      if (heads[c] == "path")
        line.path = path.parent_path() / cells[c];
      else if (heads[c] == "recording")
        line.recording = path.parent_path() / cells[c];
      else if (const auto wrong = take(heads[c], cells[c], line))
        return refused(where + ": \"" + cells[c] + "\" in column " + heads[c] + " " + *wrong + ".");
    }
    if (line.path.empty()) return refused(where + " has no path.");
    if (line.label.empty()) {
      char label[16];
      std::snprintf(label, sizeof label, "scan-%04zu", lines.size() + 1);
      line.label = label;
    }
    if (!labels.insert(line.label).second)
      return refused(where + ": the label \"" + line.label +
                     "\" is there twice; each line needs its own.");
    lines.push_back(std::move(line));
  }
  if (lines.empty()) return refused("The manifest names no scan.");
  return manifestOf(std::move(lines));
}

/// "sub-01_ses-02_run-1_ct.nii.gz": sub-01_ses-02_run-1, without what is no label.
std::string labelOf(const fs::path& file) {
  std::string label;
  for (const std::string& part : partsOf(file.filename().string(), '_'))
    if (part.starts_with("sub-") || part.starts_with("ses-") || part.starts_with("run-") ||
        part.starts_with("acq-"))
      label += (label.empty() ? "" : "_") + part;
  return label;
}

/// In whichever letters.
bool endsIn(const std::string& name, const std::string& ending) {
  return name.size() >= ending.size() &&
         strcasecmp(name.c_str() + name.size() - ending.size(), ending.c_str()) == 0;
}

Expected<Manifest> readDataset(const fs::path& folder, const Touching& otherwise) {
  std::vector<Line> lines;
  std::error_code failed;
  fs::recursive_directory_iterator entry(folder, failed);
  for (; !failed && entry != fs::recursive_directory_iterator{}; entry.increment(failed)) {
    const std::string name = entry->path().filename().string();
    // below the dataset itself, only its subjects hold scans
    if (entry.depth() == 0 && !name.starts_with("sub-")) {
      entry.disable_recursion_pending();
      continue;
    }
    if (!entry->is_regular_file(failed) || !name.starts_with("sub-")) continue;
    if (!endsIn(name, ".nii.gz") && !endsIn(name, ".nii") && !endsIn(name, ".nrrd")) continue;
    Line line;
    line.touching = otherwise;
    line.path = entry->path();
    line.label = labelOf(line.path);
    if (!isLabel(line.label))
      return refused("\"" + name + "\" gives no label; its parts may hold letters, digits and -.");
    lines.push_back(std::move(line));
  }
  if (failed)
    return tl::unexpected(Error{Error::Kind::NotFound,
                                folder.string() + " cannot be read; check who may read it.",
                                "not-readable"});
  std::ranges::sort(lines, {}, [](const Line& line) { return line.path; });
  for (std::size_t n = 1; n < lines.size(); ++n)
    if (lines[n].label == lines[n - 1].label)
      return refused("Two volumes are called \"" + lines[n].label +
                     "\"; name them by ses-, acq- or run-, or write a manifest.");
  if (lines.empty())
    return refused(
        "The folder holds no volume below sub-*; a BIDS dataset or a manifest is needed.");
  return manifestOf(std::move(lines));
}

}  // namespace

const std::vector<std::string>& handNames() {
  static const std::vector<std::string> kNames{"tap",  "slide", "wedge", "pry",
                                               "hook", "jerk",  "twist"};
  return kNames;
}

std::size_t Line::rows() const {
  return recording.empty() ? touching.tools.size() * touching.hands.size() *
                                 static_cast<std::size_t>(touching.repetitions)
                           : 1;
}

std::optional<double> isovalueOf(const Touching& touching, const std::string& unit) {
  const auto rule = rules().find(touching.isovalue);
  if (rule == rules().end()) return numberIn<double>(touching.isovalue);
  if (unit != "HU") return {};
  return rule->second;
}

Expected<Manifest> readManifest(const fs::path& path, const Touching& otherwise) {
  std::error_code failed;
  return fs::is_directory(path, failed) ? readDataset(path, otherwise) : readTable(path, otherwise);
}

}  // namespace cohort
