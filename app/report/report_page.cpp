// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "app/page/page.h"
#include "app/page/text.h"
#include "app/report/report.h"

namespace app::report {
namespace {

using page::Page;
using page::Plot;
using page::Table;

constexpr std::size_t kMostRows = 100;  // of injuries

std::string titleOf(const Structure& structure) {
  return "Structure " + std::to_string(structure.number) +
         (structure.name.empty() ? "" : ": " + structure.name);
}

std::string sessionAt(std::size_t n) { return "session " + std::to_string(n + 1); }

/// The columns of a table of figures.
std::vector<std::string> headOf(const Report& report) {
  std::vector<std::string> head{"figure", "unit"};
  for (std::size_t n = 0; n < report.sessions.size(); ++n) head.push_back(sessionAt(n));
  return head;
}

std::string cellOf(Moment moment) {
  return page::shortly(moment.value) +
         (std::isfinite(moment.at) ? page::text(" at %.3f s", moment.at) : "");
}

/// A row of a figure, with a cell for each session.
template <class Cell>
std::vector<std::string> rowOf(const Report& report, const std::string& title,
                               const std::string& unit, const Cell& cell) {
  std::vector<std::string> row{title, unit};
  for (const Session& session : report.sessions) row.push_back(cell(session));
  return row;
}

Table ofSessions(const Report& report) {
  Table table{{}, headOf(report), {}};
  table.rows.push_back(rowOf(report, "Tools", "", [](const Session& session) {
    std::string tools;
    for (const std::string& tool : session.tools)
      tools += (tools.empty() ? "" : ", ") + (tool.empty() ? "from a file" : tool);
    return tools;
  }));
  table.rows.push_back(rowOf(report, "Ticks in a second", "Hz",
                             [](const Session& session) { return page::shortly(session.rate); }));
  for (const FigureOfSession& figure : figuresOfSessions())
    table.rows.push_back(
        rowOf(report, figure.definition.title, figure.definition.unit,
              [&](const Session& session) { return cellOf(figure.of(session.figures)); }));
  return table;
}

Table ofStructure(const Report& report, std::size_t n) {
  const Structure& structure = report.structures[n];
  Table table{{}, headOf(report), {}};
  table.rows.push_back(rowOf(report, "Guarded", "", [&](const Session& session) {
    return session.guarded[n] ? "yes" : "no";
  }));
  for (const FigureOfStructure& figure : figuresOfStructures())
    table.rows.push_back(
        rowOf(report, figure.definition.title, figure.definition.unit, [&](const Session& session) {
          const Moment moment = figure.of(session.figures.structures[n]);
          const bool distance = std::string{figure.definition.unit} == "mm";
          if (!distance) return cellOf(moment);
          if (!std::isfinite(moment.at)) return page::shortly(moment.value) + " or more";
          return page::shortly(moment.value) + " ± " +
                 page::shortly(errorOf_mm(structure, moment.value)) +
                 page::text(" at %.3f s", moment.at);
        }));
  for (std::size_t m = 0; m < structure.margins.size(); ++m)
    table.rows.push_back(rowOf(report,
                               "Time within " + page::shortly(1e3 * structure.margins[m]) + " mm",
                               "s", [&](const Session& session) {
                                 return page::shortly(session.figures.structures[n].within[m]);
                               }));
  return table;
}

/// Of each part of the time the least or the largest.
page::Series seriesOf(std::size_t session, const Curve& curve, Moment Curve::Part::*of,
                      double unit) {
  page::Series series{.name = sessionAt(session), .points = {}, .marked = false};
  for (const Curve::Part& part : curve.parts())
    series.points.push_back({.x = part.from, .y = (part.*of).value / unit});
  return series;
}

Plot forcePlot(const Report& report) {
  Plot plot{.title = "Force over time",
            .description = page::text("The largest force on the hand in each 1/%zu of a session.",
                                      Curve::kParts),
            .x = {"time since the recording began [s]"},
            .y = {"force [N]"}};
  for (std::size_t n = 0; n < report.sessions.size(); ++n)
    plot.series.push_back(seriesOf(n, report.sessions[n].force, &Curve::Part::most, 1.0));
  return plot;
}

Plot distancePlot(const Report& report, std::size_t n) {
  const Structure& structure = report.structures[n];
  Plot plot{.title = "Distance to structure " + std::to_string(structure.number) + " over time",
            .description = page::text(
                "The least distance of the nearest point of the tool in each 1/%zu of a session, "
                "below 0 inside; %g mm stands for that and more. Straight lines: the margins.",
                Curve::kParts, 1e3 * structure.told),
            .x = {"time since the recording began [s]"},
            .y = {"distance [mm]"}};
  double begin = INFINITY, end = -INFINITY;
  for (std::size_t s = 0; s < report.sessions.size(); ++s) {
    const Curve& curve = report.sessions[s].nearest[n];
    plot.series.push_back(seriesOf(s, curve, &Curve::Part::least, 1e-3));
    begin = std::min(begin, curve.parts().front().from);
    end = std::max(end, curve.parts().back().from);
  }
  for (const double margin : structure.margins)
    plot.series.push_back(
        {.name = page::shortly(1e3 * margin) + " mm",
         .points = {{.x = begin, .y = 1e3 * margin}, {.x = end, .y = 1e3 * margin}},
         .marked = false});
  return plot;
}

void tellInjuries(const Report& report, Page& page) {
  page.heading("Injuries");
  bool any_guarded = false;
  Table table{
      {}, {"session", "structure", "from [s]", "to [s]", "nearest [mm]", "force [N]", "burr"}, {}};
  std::int64_t count = 0;
  for (std::size_t s = 0; s < report.sessions.size(); ++s)
    for (std::size_t n = 0; n < report.structures.size(); ++n) {
      const Session& session = report.sessions[s];
      if (!session.guarded[n]) continue;
      any_guarded = true;
      count += session.figures.structures[n].injury_count;
      for (const Encounter& one : session.figures.structures[n].encounters)
        if (one.guarded && table.rows.size() < kMostRows)
          table.rows.push_back({std::to_string(s + 1), std::to_string(report.structures[n].number),
                                page::text("%.3f", one.from), page::text("%.3f", one.to),
                                page::shortly(1e3 * one.nearest), page::shortly(one.push),
                                one.cut ? "turned" : ""});
    }
  if (!any_guarded)
    page.paragraph("No structure was guarded, so no contact counts as an injury.");
  else if (count == 0)
    page.paragraph("The tool came into contact with no structure while it was guarded.");
  else
    page.paragraph("Contacts with structures while they were guarded: " + std::to_string(count) +
                   (std::size_t(count) > table.rows.size()
                        ? "; these are the first " + std::to_string(table.rows.size()) + "."
                        : "."));
  if (!table.rows.empty()) page.table(table);
}

void tellDefinitions(Page& page) {
  page.heading("Definitions");
  Table table{{}, {"figure", "what it is", "source"}, {}};
  const auto add = [&](const Definition& of) {
    table.rows.push_back({of.title, of.means, *of.sources ? of.sources : "Palpate"});
  };
  for (const FigureOfSession& figure : figuresOfSessions()) add(figure.definition);
  for (const FigureOfStructure& figure : figuresOfStructures()) add(figure.definition);
  add(withinMargin());
  page.table(table);
  page.paragraph(
      "A tick lasts until the next one. A time is counted in seconds since the recording began, as "
      "in exports and in a replay. The sources measure the same or a similar quantity; where a "
      "limit is needed it stands in the definition.");
  page.heading("Sources");
  page.list(sources());
}

}  // namespace

std::string htmlOf(const Report& report) {
  Page page{"Rehearsal report"};
  for (const std::string& remark : remarks()) page.paragraph(remark);
  for (std::size_t n = 0; n < report.sessions.size(); ++n)
    if (report.sessions[n].differing > 0)
      page.paragraph("The distances that " + sessionAt(n) +
                     " recorded are others than those to these structures: the label map is "
                     "another one. All figures here are of the label map that was given.");
  page.heading(report.sessions.size() > 1 ? "Sessions" : "Session");
  page.table(ofSessions(report));
  page.plot(forcePlot(report));
  tellInjuries(report, page);
  for (std::size_t n = 0; n < report.structures.size(); ++n) {
    page.heading(titleOf(report.structures[n]));
    page.table(ofStructure(report, n));
    page.plot(distancePlot(report, n));
  }
  tellDefinitions(page);
  return page.html();
}

}  // namespace app::report
