// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "app/page/page.h"
#include "app/study/report/results.h"

namespace study {
namespace {

/// What all jobs of a section say, put together.
struct Section {
  std::string title;
  std::vector<Case> cases;
  std::vector<Plot> plots;
  std::vector<Table> tables;
  std::vector<std::string> remarks;
};

void join(Plot plot, std::vector<Plot>& plots) {
  const auto same =
      std::ranges::find_if(plots, [&](const Plot& p) { return p.title == plot.title; });
  if (same == plots.end()) {
    plots.push_back(std::move(plot));
    return;
  }
  for (Series& series : plot.series) {
    const auto old =
        std::ranges::find_if(same->series, [&](const Series& s) { return s.name == series.name; });
    if (old == same->series.end()) {
      same->series.push_back(std::move(series));
      continue;
    }
    old->points.insert(old->points.end(), series.points.begin(), series.points.end());
    std::ranges::stable_sort(old->points, {}, &PlotPoint::x);
  }
}

void join(const Table& table, std::vector<Table>& tables) {
  const auto same =
      std::ranges::find_if(tables, [&](const Table& t) { return t.caption == table.caption; });
  if (same == tables.end() || table.caption.empty())
    tables.push_back(table);
  else
    same->rows.insert(same->rows.end(), table.rows.begin(), table.rows.end());
}

std::vector<Section> sectionsOf(const Results& results) {
  std::vector<Section> sections;
  for (const Finished& one : results.finished) {
    auto at =
        std::ranges::find_if(sections, [&](const Section& s) { return s.title == one.section; });
    if (at == sections.end()) at = sections.insert(at, Section{one.section, {}, {}, {}, {}});
    at->cases.insert(at->cases.end(), one.outcome.cases.begin(), one.outcome.cases.end());
    for (const Plot& plot : one.outcome.plots) join(plot, at->plots);
    for (const Table& table : one.outcome.tables) join(table, at->tables);
    for (const std::string& remark : one.outcome.remarks)
      if (std::ranges::find(at->remarks, remark) == at->remarks.end())
        at->remarks.push_back(remark);
  }
  return sections;
}

Table tableOf(const std::vector<Case>& cases) {
  Table table{{}, {"case", "value", "is to be", "bound", "unit", "holds", "note"}, {}};
  for (const Case& c : cases)
    table.rows.push_back({c.name, shortly(c.value), c.sense == Case::Sense::AtMost ? "≤" : "≥",
                          shortly(c.bound), c.unit, c.pass() ? "yes" : "NO", c.note});
  return table;
}

/// "112 of 115 cases hold."
std::string verdictOf(const std::vector<Case>& cases) {
  const auto held = std::ranges::count_if(cases, &Case::pass);
  const auto all = std::to_string(cases.size());
  if (cases.empty()) return "No case has been run.";
  if (held == std::ssize(cases)) return "All " + all + " cases hold.";
  return std::to_string(held) + " of " + all +
         " cases hold. Below the diagrams are those that do not.";
}

/// The text with each `mark` replaced.
std::string with(std::string text, const std::string& mark, const std::string& by) {
  for (auto at = text.find(mark); at != std::string::npos; at = text.find(mark, at + by.size()))
    text.replace(at, mark.size(), by);
  return text;
}

std::vector<std::string> sentencesOf(const std::vector<Claim>& claims,
                                     const std::vector<Case>& cases) {
  std::vector<std::string> sentences;
  for (const Claim& claim : claims) {
    int count = 0;
    const Case* worst = nullptr;
    for (const Case& c : cases) {
      if (!c.name.ends_with(claim.cases)) continue;
      ++count;
      const bool at_most = c.sense == Case::Sense::AtMost;
      const bool is_worse = worst != nullptr && !std::isnan(worst->value) &&
                            !(at_most ? c.value <= worst->value : c.value >= worst->value);
      if (worst == nullptr || is_worse) worst = &c;
    }
    if (worst == nullptr) continue;
    const std::string unit = worst->unit.empty() ? "" : " " + worst->unit;
    sentences.push_back(with(with(claim.words, "{count}", std::to_string(count)), "{worst}",
                             shortly(worst->value) + unit));
  }
  return sentences;
}

std::vector<Plot> plotsOf(const std::vector<std::string>& titles,
                          const std::vector<Section>& sections) {
  std::vector<Plot> plots;
  for (const std::string& title : titles)
    for (const Section& section : sections)
      std::ranges::copy_if(section.plots, std::back_inserter(plots),
                           [&](const Plot& plot) { return plot.title == title && !isZero(plot); });
  if (plots.size() > 3) plots.resize(3);
  return plots;
}

}  // namespace

std::string htmlOf(const Results& results) {
  Page page{results.title};
  const std::vector<Case> cases = results.cases();
  const std::vector<Section> sections = sectionsOf(results);
  page.paragraph(verdictOf(cases));
  page.list(sentencesOf(results.front.claims, cases));
  page.overview(plotsOf(results.front.plots, sections));
  std::vector<Case> failing;
  std::ranges::copy_if(cases, std::back_inserter(failing), [](const Case& c) { return !c.pass(); });
  if (!failing.empty()) page.table(tableOf(failing));
  const std::vector<std::string> missing = results.missing();
  if (!missing.empty()) {
    std::string names;
    for (const std::string& name : missing) names += (names.empty() ? "" : ", ") + name;
    page.paragraph(std::to_string(missing.size()) + " of " + std::to_string(results.jobs.size()) +
                   " jobs have not been run, and nothing is said of them: " + names + ".");
  }

  page.heading("How it was measured");
  for (const std::string& paragraph : results.introduction) page.paragraph(paragraph);
  for (const Section& section : sections) {
    page.heading(section.title);
    for (const std::string& remark : section.remarks) page.paragraph(remark);
    for (const Plot& plot : section.plots) page.plot(plot);
    for (const Table& table : section.tables) page.table(table);
    if (!section.cases.empty()) page.table(tableOf(section.cases));
  }

  page.heading("To repeat it");
  page.command(commandOf(results.identity));
  Table made{{}, {"what", "which"}, {}};
  made.rows.push_back({"version", results.identity.version});
  made.rows.push_back({"build", results.identity.build});
  made.rows.push_back({"seed", std::to_string(results.identity.seed)});
  std::vector<Json> machines;
  for (const Finished& one : results.finished) {
    if (std::ranges::find(machines, one.machine) != machines.end()) continue;
    machines.push_back(one.machine);
    for (const auto& [name, value] : one.machine.items())
      made.rows.push_back({name, value.is_string() ? value.get<std::string>() : value.dump()});
  }
  page.table(made);
  if (machines.size() > 1)
    page.paragraph("The jobs ran on " + std::to_string(machines.size()) +
                   " kinds of machine: compare times within a job only.");
  return page.html();
}

}  // namespace study
