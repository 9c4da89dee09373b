// SPDX-License-Identifier: BSD-3-Clause
#include "app/export/channels.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "app/export/facts.h"
#include "app/export/text.h"

namespace app::exporting {

using haptics::Step;
using haptics::Vec3;
using nlohmann::ordered_json;

void append(std::string& line, double number) {
  if (std::isfinite(number))
    appendNumber(line, number);
  else
    line += kMissing;
}
void append(std::string& line, float number) {
  if (std::isfinite(number))
    appendNumber(line, number);
  else
    line += kMissing;
}
void append(std::string& line, std::int64_t number) { appendNumber(line, number); }

/// Seconds with all nine decimals: as exact as the ns.
void appendSeconds(std::string& line, std::int64_t ns) {
  constexpr std::int64_t kSecond = 1'000'000'000;
  if (ns < 0) line += '-';
  const std::int64_t size = std::abs(ns);
  appendNumber(line, size / kSecond);
  line += '.';
  line += std::to_string(kSecond + size % kSecond).substr(1);
}

namespace {

std::vector<Channel> poseChannels(const std::string& point, const std::string& where,
                                  PoseNumbers RecordedStep::*numbers) {
  constexpr const char* kComponents[] = {"x", "y", "z", "quat_w", "quat_x", "quat_y", "quat_z"};
  std::vector<Channel> channels;
  for (std::size_t i = 0; i < 7; ++i) {
    const bool place = i < 3;
    channels.push_back(
        {point + "_" + kComponents[i], kComponents[i], place ? "POS" : "ORNT", point,
         place ? "m" : kMissing, kFrame,
         (place ? "Position of the tool's origin, " : "Orientation, a unit quaternion, ") + where,
         [numbers, i](std::string& line, const RecordedStep& row, std::int64_t) {
           append(line, (row.*numbers)[i]);
         }});
  }
  return channels;
}

template <class Of>
std::vector<Channel> vectorChannels(const std::string& name, const char* unit,
                                    const std::string& description, Of of) {
  constexpr const char* kAxes[] = {"x", "y", "z"};
  std::vector<Channel> channels;
  for (int axis = 0; axis < 3; ++axis)
    channels.push_back({name + "_" + kAxes[axis], kAxes[axis], "MISC", "device", unit, kFrame,
                        description,
                        [of, axis](std::string& line, const RecordedStep& row, std::int64_t) {
                          append(line, of(row.step)[axis]);
                        }});
  return channels;
}

/// With a capital first letter.
std::string sentence(std::string words) {
  words.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(words.front())));
  return words;
}

Channel single(const char* name, const std::string& unit, std::string description,
               std::function<void(std::string&, const RecordedStep&)> append) {
  return {name,
          kMissing,
          "MISC",
          kMissing,
          unit.empty() || unit == "1" ? kMissing : unit,
          kMissing,
          std::move(description),
          [append = std::move(append)](std::string& line, const RecordedStep& row, std::int64_t) {
            append(line, row);
          }};
}

/// What the numbers in the channel of scenes stand for: in words without quotes, which readers of
/// tables take in different ways.
std::string scenesOf(const Recording& recording) {
  std::string words = "Number of the scene; 0: none";
  for (const RecordedScene& scene : recording.scenes()) {
    words += "; " + std::to_string(scene.id) + ":";
    const ordered_json facts = factsOf(scene);
    for (const auto& [name, value] : facts.items())
      words +=
          " " + name + " " + (value.is_string() ? value.get<std::string>() : value.dump()) + ",";
    words.pop_back();
  }
  std::erase(words, '"');
  return words;
}

}  // namespace

float NearnessColumn::of(const Step& step) const {
  for (const haptics::Nearness& one : step.near)
    if (one.structure == structure) return one.*distance;
  return std::numeric_limits<float>::quiet_NaN();
}

std::vector<NearnessColumn> nearnessColumns(const Recording& recording) {
  std::vector<NearnessColumn> columns;
  for (const std::uint8_t structure : recording.structures()) {
    const std::string number = std::to_string(structure + 1);
    const std::string to = " to the surface of structure " + number +
                           " of the label map; negative inside, and where it is far the greatest "
                           "distance that is told";
    columns.push_back({structure, &haptics::Nearness::tip, "tip_to_" + number,
                       "structures/" + number + "/tip", "distance of the tool's tip" + to});
    columns.push_back({structure, &haptics::Nearness::nearest, "nearest_to_" + number,
                       "structures/" + number + "/nearest",
                       "distance of the tool's nearest point" + to});
  }
  return columns;
}

std::vector<Channel> motionChannels(const Recording& recording) {
  std::vector<Channel> all;
  const auto add = [&](std::vector<Channel> channels) {
    std::move(channels.begin(), channels.end(), std::back_inserter(all));
  };
  all.push_back({"latency", kMissing, "LATENCY", kMissing, "s", kMissing,
                 "Time since the first row, exact to the nanosecond",
                 [](std::string& line, const RecordedStep& row, std::int64_t first_ns) {
                   appendSeconds(line, row.step.time_ns - first_ns);
                 }});
  add(poseChannels("device", "where the hand holds the tool", &RecordedStep::device));
  add(poseChannels("proxy", "where the surface lets the tool be, after the tick",
                   &RecordedStep::proxy));
  add(vectorChannels("force", "N", "Force sent to the hand",
                     [](const Step& step) -> const Vec3& { return step.sent_W.force; }));
  add(vectorChannels("torque", "N.m", "Torque sent to the hand, about the device's origin",
                     [](const Step& step) -> const Vec3& { return step.sent_W.torque; }));
  add(vectorChannels("friction_force", "N", sentence(kFrictionMeaning), frictionOf));
  for (const StepColumn& column : stepColumns())
    if (column.path != nullptr)
      all.push_back(single(
          column.name, column.unit,
          column.name == std::string_view{"scene"} ? scenesOf(recording) : sentence(column.meaning),
          [&column](std::string& line, const RecordedStep& row) {
            withValue(column, row, [&](auto value) {
              if constexpr (std::is_floating_point_v<decltype(value)>)
                append(line, value);
              else
                append(line, static_cast<std::int64_t>(value));
            });
          }));
  for (const NearnessColumn& column : nearnessColumns(recording))
    all.push_back(single(column.name.c_str(), "m", sentence(column.meaning),
                         [column](std::string& line, const RecordedStep& row) {
                           append(line, column.of(row.step));
                         }));
  if (recording.isCut())
    all.push_back(
        single("removed_volume", "m3", sentence(kRemovedMeaning),
               [](std::string& line, const RecordedStep& row) { append(line, row.step.removed); }));
  add({single("step", "", "Number of the tick since the recording began",
              [](std::string& line, const RecordedStep& row) {
                append(line, static_cast<std::int64_t>(row.step.sequence));
              }),
       single("time", "ns", "Since the recording began",
              [](std::string& line, const RecordedStep& row) { append(line, row.step.time_ns); })});
  return all;
}

ordered_json frameOf(const Recording& recording) {
  bool known = true;
  for (const RecordedScene& scene : recording.scenes())
    known = known && scene.volume.orientation_known;
  ordered_json frame;
  if (known) frame["SpatialAxes"] = "LPS";
  frame["RotationRule"] = "right-hand";
  std::string words = known ? "The scan's patient coordinates (DICOM): left, posterior, superior"
                            : "The scan's own axes; it does not say how the patient lay in them";
  words += ".";
  const ordered_json meant = conventions();
  for (const auto& [name, sentence] : meant.items()) words += " " + sentence.get<std::string>();
  frame["Description"] = words;
  return frame;
}

ordered_json kindsOfEvents() {
  return {
      {"isovalue", "The isovalue moved, to value"},
      {"stiffness", "The stiffness moved, to value [N/m]"},
      {"angular_stiffness", "The angular stiffness moved, to value [N.m/rad]"},
      {"friction", "The friction moved, to value"},
      {"scene", "Another scene, of number value"},
      {"force_scale", "The force scale moved, to value"},
      {"position_scale", "The position scale moved, to value"},
      {"force", "The force became value: " + std::string{columnNamed("force_state").meaning}},
      {"device", "Of the device, value is: " + std::string{columnNamed("flags").meaning}},
      {"clutch", "The tool stays while the hand moves: value 1; again with it: 0"},
      {"gap", "So many steps as value before this were not recorded"},
      {"late", "So many ticks as value began late until now"},
      {"missed", "So many ticks as value were left out until now"},
      {"hand", "Another hand holds the device"},
      {"mark", "The user set a mark, with a note"},
      {"edit", "A part of the scan was taken away or brought back: the command is in the note"},
      {"structures", "Structures are felt otherwise: the note lists them; 1: from the beginning"},
      {"cut_law", "How the tool's burr cuts in the scene of number value, in SI"},
      {"carved", "The note is a digest of the voxels that cuts have changed"},
      {"camera", "The view moved"}};
}

}  // namespace app::exporting
