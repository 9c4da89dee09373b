// SPDX-License-Identifier: BSD-3-Clause
// The shape of Motion-BIDS, Brain Imaging Data Structure 1.11.0, "Motion" and "Events".
#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>

#include "app/export/export.h"
#include "app/export/facts.h"
#include "app/export/selection.h"
#include "app/export/text.h"
#include "haptics/process/output_file.h"

namespace app::exporting {

using haptics::OutputFile;
using haptics::Step;
using haptics::Vec3;
using nlohmann::ordered_json;

namespace {

constexpr const char* kMissing = "n/a";
constexpr const char* kFrame = "scan";

void append(std::string& line, double number) {
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

/// A column of _motion.tsv, a row of _channels.tsv.
struct Channel {
  std::string name, component, type, point, unit, frame, description;
  /// `first_ns`: time of the first row.
  std::function<void(std::string&, const RecordedStep&, std::int64_t first_ns)> append;
};

std::vector<Channel> poseChannels(const std::string& point, PoseNumbers RecordedStep::*numbers) {
  constexpr const char* kComponents[] = {"x", "y", "z", "quat_w", "quat_x", "quat_y", "quat_z"};
  std::vector<Channel> channels;
  for (std::size_t i = 0; i < 7; ++i) {
    const bool place = i < 3;
    channels.push_back({point + "_" + kComponents[i], kComponents[i], place ? "POS" : "ORNT", point,
                        place ? "m" : kMissing, kFrame,
                        place ? "Position of the tool's origin" : "Orientation, a unit quaternion",
                        [numbers, i](std::string& line, const RecordedStep& row, std::int64_t) {
                          append(line, (row.*numbers)[i]);
                        }});
  }
  return channels;
}

template <class Of>
std::vector<Channel> vectorChannels(const std::string& name, const char* unit,
                                    const char* description, Of of) {
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
  add(poseChannels("device", &RecordedStep::device));
  add(poseChannels("proxy", &RecordedStep::proxy));
  add(vectorChannels("force", "N", "Force sent to the hand",
                     [](const Step& step) -> const Vec3& { return step.sent_W.force; }));
  add(vectorChannels("torque", "N.m", "Torque sent to the hand, about the device's origin",
                     [](const Step& step) -> const Vec3& { return step.sent_W.torque; }));
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
  add({single("step", "", "Number of the tick since the recording began",
              [](std::string& line, const RecordedStep& row) {
                append(line, static_cast<std::int64_t>(row.step.sequence));
              }),
       single("time", "ns", "Since the recording began",
              [](std::string& line, const RecordedStep& row) { append(line, row.step.time_ns); })});
  return all;
}

std::string channelsTable(const std::vector<Channel>& channels) {
  std::string table = "name\tcomponent\ttype\ttracked_point\tunits\treference_frame\tdescription\n";
  for (const Channel& c : channels)
    table += c.name + "\t" + c.component + "\t" + c.type + "\t" + c.point + "\t" + c.unit + "\t" +
             c.frame + "\t" + c.description + "\n";
  return table;
}

ordered_json framesOf(const Recording& recording) {
  bool known = true;
  for (const RecordedScene& scene : recording.scenes())
    known = known && scene.volume.orientation_known;
  ordered_json frame;
  if (known) frame["SpatialAxes"] = "LPS";
  frame["RotationRule"] = "right-hand";
  frame["Description"] = known ? "The scan's patient coordinates (DICOM): left, posterior, superior"
                               : "The scan's own axes; it does not say how the patient lay in them";
  return {{"reference_frame", {{"Levels", {{kFrame, frame}}}}}};
}

/// What the rows came to, known at the end.
struct Rows {
  std::int64_t count = 0, first_ns = 0, last_ns = 0;
  double duration() const { return double(last_ns - first_ns) * 1e-9; }
};

// BIDS knows every key of _motion.json and has a place for what it does not: in words.

/// What made the recording.
std::string softwareOf(const Recording& recording) {
  return "Palpate " + plain(recording.version()) + ", build " + plain(recording.build()) +
         ", vectors " + plain(recording.vectors()) + ", on " + plain(recording.machine());
}

/// Hz, nominal: the highest at which the servo loop ran.
double servoRateOf(const Recording& recording) {
  double highest = haptics::ServoRate{}.hz;
  for (const haptics::ProxyStart& start : recording.starts())
    highest = std::max(highest, double(start.rate.hz));
  return highest;
}

ordered_json motionFacts(const Recording& recording, const std::vector<Channel>& channels,
                         const Rows& rows, double rate) {
  const double most = servoRateOf(recording);
  ordered_json facts;
  facts["TaskName"] = "touch";
  facts["TaskDescription"] = "A tool is led by hand over a surface of a scan, which is felt.";
  facts["SamplingFrequency"] = rate > 0.0 ? std::min(rate, most) : most;
  if (rows.duration() > 0.0)
    facts["SamplingFrequencyEffective"] = double(rows.count - 1) / rows.duration();
  facts["RecordingDuration"] = rows.duration();
  facts["TrackingSystemName"] = "palpate";
  std::set<std::string> points;
  for (const Channel& c : channels)
    if (c.point != kMissing) points.insert(c.point);
  facts["TrackedPointsCount"] = points.size();
  facts["MotionChannelCount"] = channels.size();
  for (const char* type : {"POS", "ORNT", "LATENCY", "MISC"})
    facts[type + std::string{"ChannelCount"}] = std::count_if(
        channels.begin(), channels.end(), [&](const Channel& c) { return c.type == type; });
  facts["MissingValues"] = kMissing;
  facts["SoftwareVersions"] = softwareOf(recording);
  return facts;
}

std::string eventLine(const RecordedEvent& event, std::int64_t first_ns) {
  std::string line;
  appendSeconds(line, event.time_ns - first_ns);
  line += "\t0\t" + plain(event.kind) + "\t";
  append(line, event.value.value_or(std::nan("")));
  return line + "\t" + (event.text.empty() ? kMissing : plain(event.text)) + "\n";
}

ordered_json eventFacts() {
  const ordered_json levels = {
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
      {"camera", "The view moved"}};
  return {{"onset", {{"Description", "Time since the first row of the motion"}, {"Units", "s"}}},
          {"duration", {{"Description", "0: events have none"}, {"Units", "s"}}},
          {"trial_type", {{"Description", "What happened"}, {"Levels", levels}}},
          {"value", {{"Description", "Its number, as trial_type tells"}}},
          {"note", {{"Description", "Its words"}}}};
}

void appendContacts(std::string& lines, const Step& step, std::int64_t sample) {
  for (const haptics::BearingContact& contact : step.contacts) {
    append(lines, sample);
    for (const Vec3& v : {contact.r_W, contact.n_W})
      for (int axis = 0; axis < 3; ++axis) {
        lines += '\t';
        append(lines, v[axis]);
      }
    lines += '\t';
    append(lines, contact.push);
    lines += '\n';
  }
}

}  // namespace

haptics::Expected<Exported> exportCsv(Recording& recording, const std::filesystem::path& prefix,
                                      const ExportOptions& options) {
  if (!prefix.has_filename())
    return tl::unexpected(haptics::Error{haptics::Error::Kind::Unsupported,
                                         {"export-names-folder", {prefix.string()}},
                                         "unwritable"});
  Exported exported;
  std::vector<OutputFile> files;
  files.reserve(7);
  const auto open = [&](const char* ending) -> haptics::Expected<OutputFile*> {
    exported.files.push_back(prefix.string() + ending);
    auto file = OutputFile::open(exported.files.back());
    if (!file) return tl::unexpected(file.error());
    return &files.emplace_back(std::move(*file));
  };
  const std::vector<Channel> channels = motionChannels(recording);
  auto motion = open("_motion.tsv");
  if (!motion) return tl::unexpected(motion.error());
  OutputFile* contacts = nullptr;
  if (options.contacts) {
    auto opened = open("_contacts.tsv");
    if (!opened) return tl::unexpected(opened.error());
    contacts = *opened;
    contacts->write("sample\tarm_x\tarm_y\tarm_z\tnormal_x\tnormal_y\tnormal_z\tpush\n");
  }

  Rows rows;
  std::string text;
  const auto done = forEachChosen(recording, options, [&](const RecordedStep& row) {
    if (rows.count == 0) rows.first_ns = row.step.time_ns;
    rows.last_ns = row.step.time_ns;
    text.clear();
    for (const Channel& channel : channels) {
      if (!text.empty()) text += '\t';
      channel.append(text, row, rows.first_ns);
    }
    text += '\n';
    bool going = (*motion)->write(text);
    if (contacts != nullptr) {
      text.clear();
      appendContacts(text, row.step, rows.count);
      going = contacts->write(text) && going;
    }
    ++rows.count;
    return going;
  });
  if (!done) return tl::unexpected(done.error());

  auto events = open("_events.tsv");
  if (!events) return tl::unexpected(events.error());
  (*events)->write("onset\tduration\ttrial_type\tvalue\tnote\n");
  for (const RecordedEvent& event : eventsChosen(recording, options)) {
    (*events)->write(eventLine(event, rows.first_ns));
    ++exported.events;
  }
  const std::pair<const char*, std::string> words[] = {
      {"_channels.tsv", channelsTable(channels)},
      {"_channels.json", framesOf(recording).dump(2) + "\n"},
      {"_motion.json", motionFacts(recording, channels, rows, options.rate).dump(2) + "\n"},
      {"_events.json", eventFacts().dump(2) + "\n"}};
  for (const auto& [ending, content] : words) {
    auto file = open(ending);
    if (!file) return tl::unexpected(file.error());
    (*file)->write(content);
  }
  // all are whole before the first has its name
  for (OutputFile& file : files)
    if (auto closed = file.close(); !closed) return tl::unexpected(closed.error());
  for (OutputFile& file : files) {
    auto bytes = file.finish();
    if (!bytes) return tl::unexpected(bytes.error());
    exported.bytes += *bytes;
  }
  exported.steps = rows.count;
  return exported;
}

}  // namespace app::exporting
