// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/cohort/pages.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <map>
#include <sstream>
#include <utility>

#include "app/build_info/build_info.h"
#include "app/measurement/quantile.h"
#include "app/page/page.h"
#include "app/study/cohort/touch.h"
#include "haptics/process/input_file.h"
#include "haptics/process/output_file.h"

namespace cohort {
namespace {

namespace fs = std::filesystem;
using haptics::Error;
using haptics::Expected;
using study::Json;
using study::Page;
using study::Table;

constexpr std::size_t kMostOutliers = 20, kMostChanges = 40;
constexpr double kOutlier = 3.5;  // robust deviations from the median: Iglewicz and Hoaglin (1993)

/// The columns whose distribution is shown, and whose outliers are sought.
const std::vector<std::pair<std::string, std::string>>& measures() {
  static const std::vector<std::pair<std::string, std::string>> kMeasures{
      {"force_max_N", "greatest force [N]"},
      {"coupling_mm", "mean coupling in contact [mm]"},
      {"frozen_share", "frozen share of the contact"},
      {"contact_share", "share of the time in contact"}};
  return kMeasures;
}

std::size_t placeOf(const Table& table, const std::string& column) {
  return static_cast<std::size_t>(std::ranges::find(table.head, column) - table.head.begin());
}
const std::string& cell(const Table& table, const std::vector<std::string>& row,
                        const std::string& column) {
  static const std::string kNone;
  const std::size_t place = placeOf(table, column);
  return place < row.size() ? row[place] : kNone;
}
std::optional<double> numberIn(const std::string& text) {
  double value = 0.0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || stop != text.data() + text.size()) return {};
  return value;
}

/// The rows of all lines, in the order of the manifest.
Table joined(const study::Results& results, const char* caption,
             const std::vector<Column>& columns) {
  Table all{caption, {}, {}};
  for (const Column& column : columns) all.head.push_back(column.name);
  for (const study::Finished& one : results.finished)
    for (const Table& table : one.outcome.tables)
      if (table.caption == caption && table.head == all.head)
        all.rows.insert(all.rows.end(), table.rows.begin(), table.rows.end());
  return all;
}

std::string tsvOf(const Table& table) {
  std::string text;
  const auto line = [&](const std::vector<std::string>& cells) {
    for (std::size_t c = 0; c < cells.size(); ++c) text += (c > 0 ? "\t" : "") + cells[c];
    text += '\n';
  };
  line(table.head);
  for (const auto& row : table.rows) line(row);
  return text;
}

std::string dictionaryOf(const std::vector<Column>& columns) {
  Json json;
  for (const Column& column : columns) {
    json[column.name]["Description"] = column.description;
    if (!column.unit.empty()) json[column.name]["Units"] = column.unit;
  }
  return json.dump(2) + "\n";
}

std::string datasetDescription() {
  return Json{{"Name", "Palpate cohort"},
              {"BIDSVersion", "1.9.0"},
              {"DatasetType", "derivative"},
              {"GeneratedBy", {{{"Name", "Palpate"}, {"Version", app::versionHere()}}}}}
             .dump(2) +
         "\n";
}

/// A touch in words: its tool, hand and repetition.
std::string touchOf(const Table& table, const std::vector<std::string>& row) {
  return cell(table, row, "tool") + ", " + cell(table, row, "hand") + ", " +
         cell(table, row, "repetition");
}

/// What a share of the touches does not exceed, hand by hand.
study::Plot distributionOf(const Table& touches, const std::string& column,
                           const std::string& words) {
  study::Plot plot{"Distribution: " + words,
                   "For each hand the sorted values of all touches, over the share of the touches "
                   "that do not exceed them.",
                   {"share of the touches"},
                   {words}};
  for (const std::string& hand : handNames()) {
    std::vector<double> values;
    for (const auto& row : touches.rows)
      if (cell(touches, row, "hand") == hand)
        if (const auto value = numberIn(cell(touches, row, column))) values.push_back(*value);
    if (values.empty()) continue;
    std::ranges::sort(values);
    study::Series series{hand, {}};
    // of many, two hundred places tell the curve
    const std::size_t places = std::min<std::size_t>(values.size(), 200);
    for (std::size_t n = 1; n <= places; ++n) {
      const double share = double(n) / double(places);
      series.points.push_back({share, measurement::quantile(values, share)});
    }
    plot.series.push_back(std::move(series));
  }
  return plot;
}

struct Outlier {
  std::string label, touch, why;
  double deviation = 0.0;
};

/// Touches that differ most from others of the same tool and hand; those that failed come first.
std::vector<Outlier> outliersOf(const Table& touches) {
  std::vector<Outlier> found;
  std::map<std::string, std::vector<const std::vector<std::string>*>> groups;
  for (const auto& row : touches.rows) {
    const std::string& status = cell(touches, row, "status");
    if (status == "entered" || status == "not-finite")
      found.push_back({cell(touches, row, "label"), touchOf(touches, row), status, INFINITY});
    else if (status == "ok")
      groups[cell(touches, row, "tool") + ", " + cell(touches, row, "hand")].push_back(&row);
  }
  for (const auto& [group, rows] : groups)
    for (const auto& [column, words] : measures()) {
      std::vector<double> sorted;
      for (const auto* row : rows)
        if (const auto value = numberIn(cell(touches, *row, column))) sorted.push_back(*value);
      if (sorted.size() < 5) continue;
      std::ranges::sort(sorted);
      const double middle = measurement::quantile(sorted, 0.5);
      std::vector<double> apart;
      for (const double value : sorted) apart.push_back(std::abs(value - middle));
      std::ranges::sort(apart);
      const double spread = measurement::quantile(apart, 0.5) / 0.6745;
      if (!(spread > 0.0)) continue;
      for (const auto* row : rows) {
        const auto value = numberIn(cell(touches, *row, column));
        if (!value || std::abs(*value - middle) < kOutlier * spread) continue;
        found.push_back(
            {cell(touches, *row, "label"), touchOf(touches, *row),
             words + " is " + study::shortly(*value) + "; the middle is " + study::shortly(middle),
             std::abs(*value - middle) / spread});
      }
    }
  std::ranges::stable_sort(found, std::greater{}, &Outlier::deviation);
  if (found.size() > kMostOutliers) found.resize(kMostOutliers);
  return found;
}

std::string pageOf(const std::string& label) { return "scans/" + label + ".html"; }

/// The touches of an earlier cohort.
Expected<Table> earlier(const fs::path& folder) {
  constexpr std::uintmax_t kLargest = 1 << 30;  // bytes
  constexpr std::size_t kLongestRow = 1 << 20;
  auto file = haptics::openInput(folder / "group_touches.tsv", kLargest);
  if (!file)
    return tl::unexpected(Error{Error::Kind::NotFound,
                                folder.string() + " holds no group_touches.tsv; name the folder of "
                                                  "an earlier cohort.",
                                "no-cohort"});
  Table table;
  for (std::string line; haptics::takeLine(*file, line, kLongestRow) == haptics::LineRead::Whole;) {
    std::istringstream stream(line);
    auto& cells = table.head.empty() ? table.head : table.rows.emplace_back();
    for (std::string one; std::getline(stream, one, '\t');) cells.push_back(one);
  }
  return table;
}

Expected<void> compare(const Table& touches, const fs::path& before, Page& page) {
  const auto then = earlier(before);
  if (!then) return tl::unexpected(then.error());
  const auto keyOf = [](const Table& table, const std::vector<std::string>& row) {
    return cell(table, row, "label") + ": " + touchOf(table, row);
  };
  std::map<std::string, const std::vector<std::string>*> rows;
  for (const auto& row : then->rows) rows[keyOf(*then, row)] = &row;
  Table changes{"Touches that changed", {"scan and touch", "column", "before", "now"}, {}};
  std::size_t compared = 0, changed = 0;
  for (const auto& row : touches.rows) {
    const std::string key = keyOf(touches, row);
    const auto found = rows.find(key);
    if (found == rows.end()) continue;
    ++compared;
    bool differs = false;
    for (const std::string& column : touches.head) {
      const std::string &old = cell(*then, *found->second, column),
                        &now = cell(touches, row, column);
      if (old == now || placeOf(*then, column) == then->head.size()) continue;
      differs = true;
      if (changes.rows.size() < kMostChanges) changes.rows.push_back({key, column, old, now});
    }
    changed += differs;
  }
  page.heading("Against the earlier cohort");
  page.paragraph(std::to_string(compared) + " touches are in both; " + std::to_string(changed) +
                 " of them differ, and " + std::to_string(touches.rows.size() - compared) +
                 " are new.");
  if (!changes.rows.empty()) page.table(changes);
  return {};
}

Expected<void> writePages(const study::Results& results, const Table& touches, const Table& costs,
                          const Table& replays, const Summary& summary, const fs::path& out,
                          const fs::path& before) {
  Page page("Cohort");
  page.paragraph(std::to_string(summary.lines) + " scans, " + std::to_string(summary.rows) +
                 " touches and replays. " + std::to_string(summary.refused) + " were refused, in " +
                 std::to_string(summary.failing) +
                 " the proxy entered the solid or a number was not finite, and " +
                 std::to_string(summary.differing) + " replays differ.");
  page.paragraph("Made by Palpate " + app::versionHere() +
                 ". The tables are group_touches.tsv, group_costs.tsv and group_replays.tsv; the "
                 ".json beside each says what its columns mean.");
  if (!summary.missing.empty()) {
    std::string labels;
    for (const std::string& label : summary.missing) labels += (labels.empty() ? "" : ", ") + label;
    page.paragraph("Not run yet: " + labels + ".");
  }
  if (!before.empty())
    if (auto compared = compare(touches, before, page); !compared) return compared;

  page.heading("To be opened first");
  const std::vector<Outlier> outliers = outliersOf(touches);
  if (outliers.empty()) page.paragraph("No touch stands out from those of its tool and hand.");
  Table first{"Touches that failed, or are far from others of the same tool and hand",
              {"scan", "touch", "what stands out", "deviations"},
              {}};
  for (const Outlier& one : outliers)
    first.rows.push_back({one.label, one.touch, one.why,
                          std::isfinite(one.deviation) ? study::shortly(one.deviation) : "failed"});
  if (!first.rows.empty()) page.table(first);

  Table refused{"Refused", {"scan", "touch", "reason"}, {}};
  for (const Table* table : {&touches, &replays})
    for (const auto& row : table->rows)
      if (cell(*table, row, "status") == "refused")
        refused.rows.push_back({cell(*table, row, "label"),
                                table == &touches ? touchOf(*table, row) : "replay",
                                cell(*table, row, "reason")});
  if (!refused.rows.empty()) page.table(refused);

  page.heading("Distributions");
  for (const auto& [column, words] : measures()) {
    const study::Plot plot = distributionOf(touches, column, words);
    if (!plot.series.empty()) page.plot(plot);
  }
  page.heading("Scans");
  std::vector<Page::Link> links;
  for (const study::Finished& one : results.finished) links.push_back({pageOf(one.job), one.job});
  page.links(links);
  if (auto written = haptics::writeFile(out / "index.html", page.html()); !written) return written;

  const auto rowsOf = [](const Table& table, const std::string& label) {
    Table rows{table.caption, table.head, {}};
    for (const auto& row : table.rows)
      if (cell(table, row, "label") == label) rows.rows.push_back(row);
    return rows;
  };
  for (const study::Finished& one : results.finished) {
    Page scan(one.job);
    scan.links({{"../index.html", "All scans"}});
    const Table own = rowsOf(touches, one.job);
    std::vector<Page::Picture> pictures;
    std::error_code failed;
    for (const char* plane : {"axial", "coronal", "sagittal"}) {
      const std::string file = "pictures/" + one.job + "_" + plane + ".bmp";
      if (!fs::exists(out / file, failed)) continue;
      Page::Picture picture{.file = "../" + file, .name = plane};
      if (!own.rows.empty() && cell(own, own.rows.front(), "orientation") == "known")
        std::ranges::copy(lettersOf(plane), picture.letters.begin());
      pictures.push_back(std::move(picture));
    }
    if (!pictures.empty()) {
      scan.pictures(pictures);
      scan.paragraph(
          "The slices go through the place of the greatest force of the first touch (cross). Red: "
          "the surface that is touched." +
          std::string(pictures.front().letters[0].empty()
                          ? " The file does not say where left and right are."
                          : ""));
    }
    for (const Table& table : {own, rowsOf(costs, one.job), rowsOf(replays, one.job)})
      if (!table.rows.empty()) scan.table(table);
    for (const std::string& remark : one.outcome.remarks) scan.paragraph(remark);
    if (auto written = haptics::writeFile(out / pageOf(one.job), scan.html()); !written)
      return written;
  }
  return {};
}

}  // namespace

Expected<Summary> writeAll(const study::Results& results, const Manifest& manifest,
                           const fs::path& out, const fs::path& before) {
  const Table touches = joined(results, kTouches, touchColumns());
  const Table costs = joined(results, kCosts, costColumns());
  const Table replays = joined(results, kReplays, replayColumns());
  Summary summary;
  summary.lines = manifest.lines.size();
  summary.rows = touches.rows.size() + replays.rows.size();
  summary.missing = results.missing();
  for (const Table* table : {&touches, &replays})
    for (const auto& row : table->rows) {
      const std::string& status = cell(*table, row, "status");
      summary.refused += status == "refused";
      summary.failing += status == "entered" || status == "not-finite";
      summary.differing += status == "differs";
    }
  std::error_code failed;
  fs::create_directories(out / "scans", failed);
  const std::pair<const char*, std::string> files[] = {
      {"group_touches.tsv", tsvOf(touches)},
      {"group_touches.json", dictionaryOf(touchColumns())},
      {"group_costs.tsv", tsvOf(costs)},
      {"group_costs.json", dictionaryOf(costColumns())},
      {"group_replays.tsv", tsvOf(replays)},
      {"group_replays.json", dictionaryOf(replayColumns())},
      {"dataset_description.json", datasetDescription()}};
  for (const auto& [name, text] : files)
    if (auto written = haptics::writeFile(out / name, text); !written)
      return tl::unexpected(written.error());
  if (auto pages = writePages(results, touches, costs, replays, summary, out, before); !pages)
    return tl::unexpected(pages.error());
  return summary;
}

}  // namespace cohort
