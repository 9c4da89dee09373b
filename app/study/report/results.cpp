// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/report/results.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace study {
namespace {

constexpr int kSchema = 2;

/// JSON has no numbers that are not finite: null stands for them.
Json number(double value) { return std::isfinite(value) ? Json(value) : Json(); }
double number(const Json& json) {
  return json.is_null() ? std::numeric_limits<double>::quiet_NaN() : json.get<double>();
}

const char* nameOf(Depth depth) { return depth == Depth::Quick ? "quick" : "full"; }
const char* nameOf(Scale scale) { return scale == Scale::Log ? "log" : "linear"; }
const char* nameOf(Case::Sense sense) {
  return sense == Case::Sense::AtMost ? "at most" : "at least";
}

Json jsonOf(const Case& c) {
  return {{"name", c.name}, {"bound", number(c.bound)}, {"value", number(c.value)},
          {"unit", c.unit}, {"pass", c.pass()},         {"sense", nameOf(c.sense)},
          {"note", c.note}};
}
Case caseOf(const Json& json) {
  return {
      json.at("name"),
      number(json.at("value")),
      number(json.at("bound")),
      json.at("unit"),
      json.at("sense") == nameOf(Case::Sense::AtMost) ? Case::Sense::AtMost : Case::Sense::AtLeast,
      json.at("note")};
}

Json jsonOf(const Axis& axis) { return {{"label", axis.label}, {"scale", nameOf(axis.scale)}}; }
Axis axisOf(const Json& json) {
  return {json.at("label"), json.at("scale") == "log" ? Scale::Log : Scale::Linear};
}

Json jsonOf(const Plot& plot) {
  Json json{{"title", plot.title},    {"description", plot.description},
            {"x", jsonOf(plot.x)},    {"y", jsonOf(plot.y)},
            {"bound", Json()},        {"bound_name", plot.bound_name},
            {"series", Json::array()}};
  if (plot.bound) json["bound"] = number(*plot.bound);
  for (const Series& series : plot.series) {
    Json points = Json::array();
    for (const PlotPoint& p : series.points)
      points.push_back(Json::array(
          {number(p.x), number(p.y), number(p.low), number(p.high), p.in_line, p.setting}));
    json["series"].push_back(
        {{"name", series.name}, {"joined", series.joined}, {"points", points}});
  }
  return json;
}
Plot plotOf(const Json& json) {
  Plot plot{json.at("title"), json.at("description"), axisOf(json.at("x")), axisOf(json.at("y"))};
  if (!json.at("bound").is_null()) plot.bound = number(json.at("bound"));
  plot.bound_name = json.at("bound_name");
  for (const Json& s : json.at("series")) {
    Series series{s.at("name"), {}, s.at("joined")};
    for (const Json& p : s.at("points"))
      series.points.push_back(
          {number(p.at(0)), number(p.at(1)), number(p.at(2)), number(p.at(3)), p.at(4), p.at(5)});
    plot.series.push_back(std::move(series));
  }
  return plot;
}

Json jsonOf(const Outcome& outcome) {
  Json json{{"cases", Json::array()},
            {"plots", Json::array()},
            {"tables", Json::array()},
            {"remarks", outcome.remarks}};
  for (const Case& c : outcome.cases) json["cases"].push_back(jsonOf(c));
  for (const Plot& plot : outcome.plots) json["plots"].push_back(jsonOf(plot));
  for (const Table& t : outcome.tables)
    json["tables"].push_back({{"caption", t.caption}, {"head", t.head}, {"rows", t.rows}});
  return json;
}
Outcome outcomeOf(const Json& json) {
  Outcome outcome;
  for (const Json& c : json.at("cases")) outcome.cases.push_back(caseOf(c));
  for (const Json& p : json.at("plots")) outcome.plots.push_back(plotOf(p));
  for (const Json& t : json.at("tables"))
    outcome.tables.push_back({t.at("caption"), t.at("head"), t.at("rows")});
  outcome.remarks = json.at("remarks");
  return outcome;
}

Json jsonOf(const Identity& identity) {
  return {
      {"schema", kSchema},       {"study", identity.study},         {"version", identity.version},
      {"build", identity.build}, {"depth", nameOf(identity.depth)}, {"seed", identity.seed}};
}

haptics::Error unreadable(const std::string& file) {
  return {haptics::Error::Kind::Malformed,
          file + " is not a job of a study of this version; remove it and run the study again.",
          "malformed"};
}

/// A field of a CSV: in quotes where it must be.
std::string field(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"') out += '"';
    out += c;
  }
  return out + "\"";
}
std::string field(double value) {
  if (!std::isfinite(value)) return {};
  char out[32];
  std::snprintf(out, sizeof out, "%.9g", value);
  return out;
}

}  // namespace

std::vector<std::string> Results::missing() const {
  std::vector<std::string> names;
  for (const std::string& job : jobs)
    if (std::ranges::none_of(finished, [&](const Finished& f) { return f.job == job; }))
      names.push_back(job);
  return names;
}

std::vector<Case> Results::cases() const {
  std::vector<Case> all;
  for (const Finished& one : finished)
    all.insert(all.end(), one.outcome.cases.begin(), one.outcome.cases.end());
  return all;
}

std::string commandOf(const Identity& identity) {
  return "palpate-cli study " + identity.study +
         (identity.depth == Depth::Quick ? " --quick" : "") + " --seed " +
         std::to_string(identity.seed) + " --out DIR";
}

Json jsonOf(const Identity& identity, const Finished& finished) {
  Json json = jsonOf(identity);
  json["job"] = finished.job;
  json["section"] = finished.section;
  json["seconds"] = finished.seconds;
  json["machine"] = finished.machine;
  json["outcome"] = jsonOf(finished.outcome);
  return json;
}

haptics::Expected<Identity> identityOf(const Json& json, const std::string& file) {
  try {
    if (json.at("schema") != kSchema) return tl::unexpected(unreadable(file));
    return Identity{json.at("study"), json.at("version"), json.at("build"),
                    json.at("depth") == nameOf(Depth::Quick) ? Depth::Quick : Depth::Full,
                    json.at("seed")};
  } catch (const Json::exception&) {
    return tl::unexpected(unreadable(file));
  }
}

haptics::Expected<Finished> finishedOf(const Json& json, const std::string& file) {
  try {
    return Finished{json.at("job"), json.at("section"), json.at("seconds"), json.at("machine"),
                    outcomeOf(json.at("outcome"))};
  } catch (const Json::exception&) {
    return tl::unexpected(unreadable(file));
  }
}

Json jsonOf(const Results& results) {
  Json json = jsonOf(results.identity);
  json["title"] = results.title;
  json["command"] = commandOf(results.identity);
  Json machines = Json::array(), jobs = Json::array(), cases = Json::array();
  for (const Finished& one : results.finished) {
    auto at = std::find(machines.begin(), machines.end(), one.machine);
    const auto machine = at - machines.begin();
    if (at == machines.end()) machines.push_back(one.machine);
    Json job{
        {"job", one.job}, {"section", one.section}, {"seconds", one.seconds}, {"machine", machine}};
    Json outcome = jsonOf(one.outcome);
    for (Json& c : outcome["cases"]) {
      c["job"] = one.job;
      cases.push_back(c);
    }
    for (const char* part : {"plots", "tables", "remarks"}) job[part] = outcome[part];
    jobs.push_back(std::move(job));
  }
  json["machines"] = machines;
  json["cases"] = cases;
  json["jobs"] = jobs;
  json["missing"] = results.missing();
  return json;
}

std::string csvOf(const Results& results) {
  std::string csv = "kind,section,job,name,series,setting,x,value,low,high,bound,unit,pass\n";
  const auto row = [&](std::initializer_list<std::string> fields) {
    bool first = true;
    for (const std::string& one : fields) {
      if (!first) csv += ',';
      first = false;
      csv += one;
    }
    csv += '\n';
  };
  for (const Finished& one : results.finished) {
    for (const Case& c : one.outcome.cases)
      row({"case", field(one.section), field(one.job), field(c.name), "", "", "", field(c.value),
           "", "", field(c.bound), field(c.unit), c.pass() ? "yes" : "no"});
    for (const Plot& plot : one.outcome.plots)
      for (const Series& series : plot.series)
        for (const PlotPoint& p : series.points)
          row({"point", field(one.section), field(one.job), field(plot.title), field(series.name),
               field(p.setting), field(p.x), field(p.y), field(p.low), field(p.high),
               plot.bound ? field(*plot.bound) : "", field(plot.y.label), ""});
  }
  return csv;
}

}  // namespace study
