// SPDX-License-Identifier: BSD-3-Clause
// One table that spreadsheets, R and pandas read as it is, and beside it what its columns mean.
#include <string_view>

#include "app/export/channels.h"
#include "app/export/export.h"
#include "app/export/facts.h"
#include "app/export/selection.h"
#include "app/export/text.h"
#include "haptics/process/output_file.h"

namespace app::exporting {

using haptics::OutputFile;
using nlohmann::ordered_json;

namespace {

constexpr const char* kEvents = "events";

/// The columns: the time first, and without what only Motion-BIDS asks for.
std::vector<Channel> columnsOf(const Recording& recording) {
  std::vector<Channel> columns{{"time_s", "", "", "", "s", "",
                                "Time since the recording began, exact to the nanosecond",
                                [](std::string& line, const RecordedStep& row, std::int64_t) {
                                  appendSeconds(line, row.step.time_ns);
                                }}};
  for (Channel& channel : motionChannels(recording))
    if (channel.name != "latency" && channel.name != "time") columns.push_back(std::move(channel));
  return columns;
}

/// A field of text in quotes.
std::string inQuotes(const std::string& text) {
  std::string field = "\"";
  for (const char c : text) field += c == '"' ? std::string{"\"\""} : std::string{c};
  return field + '"';
}

/// "mark: a note", "isovalue 300".
std::string wordsOf(const RecordedEvent& event) {
  std::string words = plain(event.kind);
  if (event.value) words += " " + numberOf(*event.value);
  if (!event.text.empty()) words += ": " + plain(event.text);
  return words;
}

std::string dictionaryOf(const Recording& recording, const std::vector<Channel>& columns) {
  ordered_json dictionary;
  dictionary["table"] = "One row for each step of the servo loop; an empty field has no value";
  dictionary["frame"] = frameOf(recording)["Description"];
  dictionary["scenes"] = ordered_json::object();
  for (const RecordedScene& scene : recording.scenes())
    dictionary["scenes"][std::to_string(scene.id)] = factsOf(scene);
  ordered_json& described = dictionary["columns"];
  for (const Channel& column : columns) {
    ordered_json& one = described[column.name];
    one["meaning"] = column.description;
    if (column.unit != kMissing) one["unit"] = column.unit;
  }
  described[kEvents]["meaning"] =
      "What happened since the row before, apart from movements of the view: kind, value, and the "
      "note behind a colon; several are parted by |";
  described[kEvents]["kinds"] = kindsOfEvents();
  described[kEvents]["kinds"].erase("camera");
  dictionary["recording"] = factsOf(recording);
  return dictionary.dump(2) + "\n";
}

}  // namespace

haptics::Expected<Exported> exportCsv(Recording& recording, const std::filesystem::path& out,
                                      const ExportOptions& options) {
  std::filesystem::path beside = out;
  beside.replace_extension(kCsvDictionary);
  Exported exported{.files = {out.string(), beside.string()}};
  auto table = OutputFile::open(out);
  if (!table) return tl::unexpected(table.error());
  const std::vector<Channel> columns = columnsOf(recording);
  for (const Channel& column : columns) table->write(column.name + ",");
  table->write(std::string{kEvents} + "\n");

  const auto events = eventsChosen(recording, options);
  auto event = events.begin();
  // ends a row with the events until a time
  const auto endRow = [&](std::string& row, std::int64_t until_ns) {
    std::string words;
    for (; event != events.end() && event->time_ns <= until_ns; ++event) {
      if (event->kind == "camera") continue;
      words += (words.empty() ? "" : " | ") + wordsOf(*event);
      ++exported.events;
    }
    row += words.empty() ? "\n" : inQuotes(words) + "\n";
  };
  std::string row, field;
  std::int64_t time_ns = 0;
  const auto done = forEachChosen(recording, options, [&](const RecordedStep& step) {
    bool going = true;
    if (exported.steps++ > 0) {
      endRow(row, time_ns);
      going = table->write(row);
    }
    row.clear();
    time_ns = step.step.time_ns;
    for (const Channel& column : columns) {
      field.clear();
      column.append(field, step, 0);
      if (field != kMissing) row += field;
      row += ',';
    }
    return going;
  });
  if (!done) return tl::unexpected(done.error());
  endRow(row, std::numeric_limits<std::int64_t>::max());
  table->write(row);

  auto dictionary = OutputFile::open(beside);
  if (!dictionary) return tl::unexpected(dictionary.error());
  dictionary->write(dictionaryOf(recording, columns));
  // both are whole before the first has its name
  for (OutputFile* file : {&*table, &*dictionary})
    if (auto closed = file->close(); !closed) return tl::unexpected(closed.error());
  for (OutputFile* file : {&*table, &*dictionary}) {
    const auto bytes = file->finish();
    if (!bytes) return tl::unexpected(bytes.error());
    exported.bytes += *bytes;
  }
  return exported;
}

}  // namespace app::exporting
