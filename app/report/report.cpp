// SPDX-License-Identifier: BSD-3-Clause
#include "app/report/report.h"

#include <charconv>
#include <cmath>
#include <cstdint>

namespace app::report {
namespace {

using nlohmann::ordered_json;

constexpr int kSchema = 1;

Moment asIs(double value) { return {value, kNone}; }
Moment inMm(Moment moment) { return {moment.value * 1e3, moment.at}; }

ordered_json numberOf(double value) {
  return std::isfinite(value) ? ordered_json(value) : ordered_json(nullptr);
}

/// The value, and where the figure has one the time of its moment.
template <class Figure, class Values>
void tell(ordered_json& json, const Figure& figure, const Values& values) {
  const Moment moment = figure.of(values);
  const bool count = *figure.definition.unit == 0 && moment.value == std::floor(moment.value);
  json[figure.definition.key] =
      count ? ordered_json(std::int64_t(moment.value)) : numberOf(moment.value);
  if (std::isfinite(moment.at)) json[std::string{figure.definition.key} + "_at_s"] = moment.at;
}

ordered_json wordsOf(const Definition& definition) {
  return {{"figure", definition.key},
          {"title", definition.title},
          {"unit", definition.unit},
          {"means", definition.means},
          {"sources", definition.sources}};
}

/// The shortest digits of the same number; nothing for what is not finite.
std::string digitsOf(double value) {
  if (!std::isfinite(value)) return {};
  char digits[32];
  return {digits, std::to_chars(digits, digits + sizeof digits, value).ptr};
}

}  // namespace

std::vector<FigureOfSession> figuresOfSessions() {
  return {
      {{"time_s", "Time", "s", "From the first tick of the recording to the last.", "1, 2, 3"},
       [](const Figures& f) { return asIs(f.time); }},
      {{"unknown_s", "Time that is not known", "s",
        "Of that time: gaps of more than 5 ms between two ticks, and ticks without this scan. No "
        "other figure counts it.",
        ""},
       [](const Figures& f) { return asIs(f.unknown); }},
      {{"path_mm", "Path of the tip", "mm",
        "Length of the way of the tool's tip, in straight pieces of 20 ms, so that the noise of a "
        "sensor does not add up from tick to tick.",
        "3, 4"},
       [](const Figures& f) { return asIs(1e3 * f.path); }},
      {{"economy", "Economy of volume", "",
        "Cube root of the volume of the box around the ends of these pieces, along the axes of the "
        "scan, divided by the path. In the same box a shorter path gives more.",
        "4"},
       [](const Figures& f) { return asIs(f.economy); }},
      {{"idle_s", "Idle time", "s",
        "Pieces of 20 ms without contact in which the tip moved slower than 5 mm/s. The limits are "
        "Palpate's.",
        "3"},
       [](const Figures& f) { return asIs(f.idle); }},
      {{"contacts", "Contacts", "",
        "How often the tool came to bear on the surface. A pause shorter than 0.1 s parts no two "
        "contacts; the limit is Palpate's.",
        ""},
       [](const Figures& f) { return asIs(double(f.contacts)); }},
      {{"contact_s", "Time in contact", "s", "Ticks in which a contact bears on the tool.", "1"},
       [](const Figures& f) { return asIs(f.contact_time); }},
      {{"contact_share", "Share of the time in contact", "",
        "Time in contact, divided by the time that is known.", "1"},
       [](const Figures& f) { return asIs(f.contact_share); }},
      {{"force_mean_N", "Mean force", "N",
        "Mean size of the force on the hand over the time in contact, as it was sent to the "
        "device, after its limits.",
        "5, 6"},
       [](const Figures& f) { return asIs(f.mean_force); }},
      {{"force_largest_N", "Largest force", "N", "Largest size of that force in any tick.", "5, 6"},
       [](const Figures& f) { return f.largest_force; }},
      {{"strokes", "Strokes of the burr", "",
        "How often the burr began to turn. A pause shorter than 0.1 s parts no two strokes.", ""},
       [](const Figures& f) { return asIs(double(f.strokes)); }},
      {{"cut_s", "Time of cutting", "s", "Ticks in which the burr turns.", ""},
       [](const Figures& f) { return asIs(f.cut_time); }},
      {{"cut_force_mean_N", "Mean force while cutting", "N",
        "Mean size of the force on the hand over that time.", "5, 6"},
       [](const Figures& f) { return asIs(f.mean_cut_force); }},
      {{"cut_speed_mean_mm_s", "Mean speed while cutting", "mm/s",
        "Way of the tip over the time, of the pieces of 20 ms that begin while the burr turns.",
        "6"},
       [](const Figures& f) { return asIs(1e3 * f.mean_cut_speed); }},
      {{"removed_mm3", "Volume removed", "mm3",
        "Of the solid within the isosurface, by all cuts; a voxel counts in part by its value. "
        "What was taken back counts as well.",
        "6"},
       [](const Figures& f) { return asIs(1e9 * f.removed); }}};
}

std::vector<FigureOfStructure> figuresOfStructures() {
  return {{{"nearest_mm", "Nearest distance", "mm",
            "Least distance of any point of the tool to the structure; below 0 inside it.", "1, 6"},
           [](const FiguresOf& f) { return inMm(f.nearest); }},
          {{"nearest_of_tip_mm", "Nearest distance of the tip", "mm", "The same of the tool's tip.",
            "1, 6"},
           [](const FiguresOf& f) { return inMm(f.nearest_of_tip); }},
          {{"touch_s", "Time of touch", "s",
            "Ticks in which a contact bears on a voxel of the structure: on the one half a voxel "
            "behind the surface, along the normal.",
            "6"},
           [](const FiguresOf& f) { return asIs(f.touch_time); }},
          {{"touch_mean_N", "Mean force on it", "N",
            "Mean over that time of the sum of the pushes of these contacts, along their normals, "
            "before the limits of the device.",
            "5, 6"},
           [](const FiguresOf& f) { return asIs(f.mean_push); }},
          {{"touch_largest_N", "Largest force on it", "N", "Largest of these sums.", "5, 6"},
           [](const FiguresOf& f) { return f.largest_push; }},
          {{"encounters", "Contacts with it", "",
            "How often the tool touched the structure or a point of it was inside. A pause shorter "
            "than 0.1 s parts no two, but the begin and the end of a guard do.",
            "2, 6"},
           [](const FiguresOf& f) { return asIs(double(f.encounter_count)); }},
          {{"injuries", "Injuries", "", "Those of these contacts while the structure was guarded.",
            "2, 6"},
           [](const FiguresOf& f) { return asIs(double(f.injury_count)); }},
          {{"burr_injuries", "Injuries by the burr", "",
            "Those of the injuries in which the burr turned.", "6"},
           [](const FiguresOf& f) { return asIs(double(f.burr_injury_count)); }},
          {{"removed_mm3", "Volume removed of it", "mm3",
            "By all cuts, of its voxels; each counts in part by its value. Not known without the "
            "scan.",
            "6"},
           [](const FiguresOf& f) { return asIs(1e9 * f.removed); }},
          {{"exposed_mm2", "Area exposed", "mm2",
            "Of its surface: where the voxel beside it was solid before the first cut and is not "
            "after the last. A face of a voxel counts by its part across the normal. Not known "
            "without the scan.",
            "6"},
           [](const FiguresOf& f) { return asIs(1e6 * f.exposed); }},
          {{"encounters_s", "Time of contacts with it", "s",
            "Ticks in which the tool touched the structure or a point of it was inside.", "2, 6"},
           [](const FiguresOf& f) { return asIs(f.encounter_time); }}};
}

Definition withinMargin() {
  return {"within_s", "Time within a margin", "s",
          "Ticks in which the distance of the nearest point of the tool was at most the margin.",
          "6"};
}

std::vector<std::string> sources() {
  return {
      "Sewell C, Morris D, Blevins NH, et al. Providing metrics and performance feedback in a "
      "surgical simulator. Computer Aided Surgery 2008; 13: 63-81. Metrics of a simulated "
      "mastoidectomy.",
      "Linke R, Leichtle A, Sheikh F, et al. Assessment of skills using a virtual reality temporal "
      "bone surgery simulator. Acta Otorhinolaryngologica Italica 2013; 33: 273-281. Time, and "
      "injury of structures of the middle ear.",
      "Oropesa I, Chmarra MK, Sánchez-González P, et al. Relevance of motion-related assessment "
      "metrics in laparoscopic surgery. Surgical Innovation 2013; 20: 299-312. Time, path length, "
      "idle time.",
      "Oropesa I, Sánchez-González P, Chmarra MK, et al. EVA: laparoscopic instrument tracking "
      "based on endoscopic video analysis for psychomotor skills assessment. Surgical Endoscopy "
      "2013; 27: 1029-1039. Path length, economy of volume.",
      "Trejos AL, Patel RV, Malthaner RA, Schlachta CM. Development of force-based metrics for "
      "skills assessment in minimally invasive surgery. Surgical Endoscopy 2014; 28: 2106-2119.",
      "Real-time automated performance metrics for virtual temporal bone drilling. Thesis, Western "
      "University, ir.lib.uwo.ca/etd/8262. Excessive force, nearness to critical structures, and "
      "their injury.",
      "Wiet GJ, Stredney D, Kerwin T, et al. Virtual temporal bone dissection system: OSU virtual "
      "temporal bone system: development and testing. Laryngoscope 2012; 122 (Suppl 1): S1-S12.",
      "Zhao YC, Kennedy G, Yukawa K, Pyman B, O'Leary S. Can virtual reality simulator be used as "
      "a training aid to improve cadaver temporal bone dissection? Results of a randomized blinded "
      "control trial. Laryngoscope 2011; 121: 831-837."};
}

std::vector<std::string> remarks() {
  return {
      "Not for treatment. These figures describe a session with a scan; they are no grade. Trials "
      "of temporal-bone simulators judged dissections by blinded raters [7, 8], and no such trial "
      "was made of these figures.",
      "A structure is as exact as its voxels: between two of them nothing says where its surface "
      "lies. Each distance outside a structure is wrong by at most the error that stands beside "
      "it; inside, in the middle, by twice that. The segmentation itself may be wrong by more.",
      "Structures lie where the scan had them, also where it was edited."};
}

double errorOf_mm(const Structure& structure, double distance_mm) {
  return 1e3 * structure.error * (distance_mm < 0.0 ? 2.0 : 1.0);
}

ordered_json jsonOf(const Report& report) {
  ordered_json json{{"schema", kSchema}, {"remarks", remarks()}};
  json["structures"] = ordered_json::array();
  for (const Structure& structure : report.structures) {
    ordered_json one{{"number", structure.number}};
    if (!structure.name.empty()) one["name"] = structure.name;
    one["error_mm"] = errorOf_mm(structure, 1.0);
    one["error_inside_mm"] = errorOf_mm(structure, -1.0);
    one["told_up_to_mm"] = 1e3 * structure.told;
    json["structures"].push_back(std::move(one));
  }
  json["sessions"] = ordered_json::array();
  for (const Session& session : report.sessions) {
    ordered_json one{{"ticks", session.figures.ticks}, {"rate_Hz", session.rate}};
    one["tools"] = ordered_json::array();
    for (const std::string& tool : session.tools)
      one["tools"].push_back(tool.empty() ? "file" : tool);
    for (const FigureOfSession& figure : figuresOfSessions()) tell(one, figure, session.figures);
    one["recorded_distances"] = {{"compared", session.compared}, {"differing", session.differing}};
    one["structures"] = ordered_json::array();
    for (std::size_t n = 0; n < report.structures.size(); ++n) {
      const FiguresOf& figures = session.figures.structures[n];
      ordered_json of{{"number", report.structures[n].number},
                      {"guarded", bool(session.guarded[n])}};
      for (const FigureOfStructure& figure : figuresOfStructures()) tell(of, figure, figures);
      of["within"] = ordered_json::array();
      for (std::size_t m = 0; m < figures.within.size(); ++m)
        of["within"].push_back({{"margin_mm", 1e3 * report.structures[n].margins[m]},
                                {withinMargin().key, figures.within[m]}});
      of["moments"] = ordered_json::array();
      for (const Encounter& encounter : figures.encounters)
        of["moments"].push_back({{"from_s", encounter.from},
                                 {"to_s", encounter.to},
                                 {"nearest_mm", 1e3 * encounter.nearest},
                                 {"largest_N", encounter.push},
                                 {"guarded", encounter.guarded},
                                 {"burr", encounter.cut}});
      one["structures"].push_back(std::move(of));
    }
    json["sessions"].push_back(std::move(one));
  }
  json["definitions"] = ordered_json::array();
  for (const FigureOfSession& figure : figuresOfSessions())
    json["definitions"].push_back(wordsOf(figure.definition));
  for (const FigureOfStructure& figure : figuresOfStructures())
    json["definitions"].push_back(wordsOf(figure.definition));
  json["definitions"].push_back(wordsOf(withinMargin()));
  json["sources"] = sources();
  return json;
}

std::string csvOf(const Report& report) {
  std::string csv = "session,structure,figure,margin_mm,value,unit,at_s,error_mm\n";
  for (std::size_t s = 0; s < report.sessions.size(); ++s) {
    const Session& session = report.sessions[s];
    const std::string first = std::to_string(s + 1) + ",";
    const auto row = [&](const Definition& of, const Structure* structure, double margin,
                         Moment moment) {
      const bool distance = structure != nullptr && std::string{of.unit} == "mm";
      csv += first + (structure ? std::to_string(structure->number) : "") + "," + of.key + "," +
             digitsOf(1e3 * margin) + "," + digitsOf(moment.value) + "," + of.unit + "," +
             digitsOf(moment.at) + "," +
             digitsOf(distance ? errorOf_mm(*structure, moment.value) : kNone) + "\n";
    };
    for (const FigureOfSession& figure : figuresOfSessions())
      row(figure.definition, nullptr, kNone, figure.of(session.figures));
    for (std::size_t n = 0; n < report.structures.size(); ++n) {
      const Structure& structure = report.structures[n];
      const FiguresOf& figures = session.figures.structures[n];
      for (const FigureOfStructure& figure : figuresOfStructures())
        row(figure.definition, &structure, kNone, figure.of(figures));
      for (std::size_t m = 0; m < figures.within.size(); ++m)
        row(withinMargin(), &structure, structure.margins[m], asIs(figures.within[m]));
    }
  }
  return csv;
}

}  // namespace app::report
