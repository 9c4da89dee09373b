// SPDX-License-Identifier: BSD-3-Clause
// The shape of Motion-BIDS, Brain Imaging Data Structure 1.11.0, "Motion" and "Events".
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "app/export/channels.h"
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

std::string channelsTable(const std::vector<Channel>& channels) {
  std::string table = "name\tcomponent\ttype\ttracked_point\tunits\treference_frame\tdescription\n";
  for (const Channel& c : channels)
    table += c.name + "\t" + c.component + "\t" + c.type + "\t" + c.point + "\t" + c.unit + "\t" +
             c.frame + "\t" + c.description + "\n";
  return table;
}

/// What the rows came to, known at the end.
struct Rows {
  std::int64_t count = 0, first_ns = 0, last_ns = 0;
  double duration() const { return double(last_ns - first_ns) * 1e-9; }
};

ordered_json framesOf(const Recording& recording) {
  return {{"reference_frame", {{"Levels", {{kFrame, frameOf(recording)}}}}}};
}

// BIDS knows every key of _motion.json and has a place for what it does not: in words.

/// What made the recording.
std::string softwareOf(const Recording& recording) {
  std::string words = "Palpate " + plain(recording.version()) + ", build " +
                      plain(recording.build()) + ", vectors " + plain(recording.vectors()) +
                      ", on " + plain(recording.machine());
  const ordered_json facts = factsOf(recording);
  for (const auto& [name, value] : facts.items())
    if (name == "program" || name == "commit" || name.starts_with("run_") ||
        name == "began_unix_ns" || name == "voxels_sha256" || name == "export_version")
      words += ", " + name + " " + (value.is_string() ? value.get<std::string>() : value.dump());
  return words;
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
  const ordered_json levels = kindsOfEvents();
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

haptics::Expected<Exported> exportMotionBids(Recording& recording,
                                             const std::filesystem::path& prefix,
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
