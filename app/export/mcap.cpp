// SPDX-License-Identifier: BSD-3-Clause
// Written from the MCAP format specification, mcap.dev/spec, major version 0.
#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>

#include "app/export/export.h"
#include "app/export/facts.h"
#include "app/export/selection.h"
#include "app/export/text.h"
#include "haptics/process/output_file.h"

namespace app::exporting {

using haptics::OutputFile;
using haptics::Step;
using haptics::Vec3;

namespace {

static_assert(std::endian::native == std::endian::little, "MCAP is little endian");

constexpr std::string_view kMagic{"\x89MCAP0\r\n", 8};
constexpr std::size_t kChunkBytes = 1 << 20;

enum class Op : std::uint8_t {
  Header = 1,
  Footer = 2,
  Schema = 3,
  Channel = 4,
  Message = 5,
  Chunk = 6,
  MessageIndex = 7,
  ChunkIndex = 8,
  Statistics = 11,
  Metadata = 12,
  MetadataIndex = 13,
  SummaryOffset = 14,
  DataEnd = 15
};

template <class Integer>
void put(std::string& to, Integer value) {
  char bytes[sizeof value];
  std::memcpy(bytes, &value, sizeof value);
  to.append(bytes, sizeof value);
}
/// With its length before it: a string, an array, a map, or bytes.
void putText(std::string& to, std::string_view text) {
  put(to, static_cast<std::uint32_t>(text.size()));
  to += text;
}
std::string record(Op op, std::string_view content) {
  std::string bytes;
  put(bytes, static_cast<std::uint8_t>(op));
  put(bytes, static_cast<std::uint64_t>(content.size()));
  return bytes.append(content);
}
std::uint32_t crcOf(std::string_view bytes, std::uint32_t before = 0) {
  return static_cast<std::uint32_t>(
      crc32_z(before, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

/// One of the streams of messages, with the schema of the same number.
struct Topic {
  std::string name, schema;
  std::string properties;  ///< of the JSON schema
};
enum TopicNumber : std::uint16_t {
  Device,
  Proxy,
  Wrench,
  Contacts,
  Tick,
  Settings,
  Event,
  Structures
};
constexpr const char* kPoseProperties =
    R"("timestamp":{"type":"object","title":"time","properties":{"sec":{"type":"integer"},"nsec":{"type":"integer"}}},"frame_id":{"type":"string"},"pose":{"type":"object","properties":{"position":{"type":"object","properties":{"x":{"type":"number"},"y":{"type":"number"},"z":{"type":"number"}}},"orientation":{"type":"object","properties":{"x":{"type":"number"},"y":{"type":"number"},"z":{"type":"number"},"w":{"type":"number"}}}}})";

/// What a column is called in a message: "tick/cpu" in ns is "cpu_ns".
std::string keyOf(const StepColumn& column) {
  const std::string_view path = column.path;
  const std::string key{path.substr(path.find('/') + 1)};
  return column.unit == std::string_view{"ns"} ? key + "_ns" : key;
}

/// The columns of /settings, which change seldom, or of /tick.
std::vector<const StepColumn*> columnsOf(TopicNumber topic) {
  std::vector<const StepColumn*> columns;
  for (const StepColumn& column : stepColumns())
    if (column.path != nullptr && column.steady == (topic == Settings)) columns.push_back(&column);
  return columns;
}

std::string propertiesOf(TopicNumber topic) {
  std::string properties;
  for (const StepColumn* column : columnsOf(topic)) {
    const std::string_view unit = column->unit;
    const bool named = !unit.empty() && unit != "1";
    const nlohmann::ordered_json property{
        {"type", column->type == ColumnType::Float64 ? "number" : "integer"},
        {"description", column->meaning + (named ? " [" + std::string{unit} + "]" : "")}};
    properties += (properties.empty() ? "\"" : ",\"") + keyOf(*column) + "\":" + property.dump();
  }
  return properties;
}

const std::vector<Topic>& topics() {
  static const std::vector<Topic> kTopics{
      {"/device", "foxglove.PoseInFrame", kPoseProperties},
      {"/proxy", "foxglove.PoseInFrame", kPoseProperties},
      {"/wrench", "palpate.Wrench",
       R"("force":{"type":"object","description":"N","properties":{"x":{"type":"number"},"y":{"type":"number"},"z":{"type":"number"}}},"torque":{"type":"object","description":"N.m, about the device's origin","properties":{"x":{"type":"number"},"y":{"type":"number"},"z":{"type":"number"}}},"friction_force":{"type":"object","description":"N, )" +
           std::string{kFrictionMeaning} +
           R"(","properties":{"x":{"type":"number"},"y":{"type":"number"},"z":{"type":"number"}}})"},
      {"/contacts", "palpate.Contacts",
       R"("contacts":{"type":"array","items":{"type":"object","properties":{"arm":{"type":"object","description":"m, the point about the tool's origin","properties":{"x":{"type":"number"},"y":{"type":"number"},"z":{"type":"number"}}},"normal":{"type":"object","description":"unit, out of the solid","properties":{"x":{"type":"number"},"y":{"type":"number"},"z":{"type":"number"}}},"push":{"type":"number","description":"N"}}}})"},
      {"/tick", "palpate.Tick", R"("step":{"type":"integer"},)" + propertiesOf(Tick)},
      {"/settings", "palpate.Settings", propertiesOf(Settings)},
      {"/event", "palpate.Event",
       R"("step":{"type":"integer"},"kind":{"type":"string"},"value":{"type":["number","null"]},"note":{"type":"string"})"},
      {"/structures", "palpate.Structures",
       R"("structures":{"type":"array","items":{"type":"object","properties":{"number":{"type":"integer","description":"in the label map, from 1"},"tip":{"type":"number","description":"m, distance of the tool's tip; negative inside"},"nearest":{"type":"number","description":"m, of its nearest point"}}}})"}};
  return kTopics;
}

std::string schemaRecord(std::uint16_t id) {
  const Topic& topic = topics()[id];
  std::string content;
  put(content, static_cast<std::uint16_t>(id + 1));  // 0 would be no schema
  putText(content, topic.schema);
  putText(content, "jsonschema");
  putText(content, std::string{R"({"type":"object","properties":{)"} + topic.properties + "}}");
  return record(Op::Schema, content);
}
std::string channelRecord(std::uint16_t id) {
  std::string content;
  put(content, id);
  put(content, static_cast<std::uint16_t>(id + 1));
  putText(content, topics()[id].name);
  putText(content, "json");
  putText(content, {});
  return record(Op::Channel, content);
}

/// Chunks with their indexes, and at the end what finds them again.
class Writer {
 public:
  explicit Writer(OutputFile& file) : file_{file} {
    emit(kMagic);
    std::string header;
    putText(header, "");
    putText(header, "palpate");
    emit(record(Op::Header, header));
    for (std::uint16_t id = 0; id < topics().size(); ++id)
      chunk_ += schemaRecord(id) + channelRecord(id);
  }

  void metadata(const std::string& name, const nlohmann::ordered_json& facts) {
    std::string map, content;
    for (const auto& [key, fact] : facts.items()) {
      putText(map, key);
      putText(map, fact.is_string() ? fact.get<std::string>() : fact.dump());
    }
    putText(content, name);
    putText(content, map);
    const std::string bytes = record(Op::Metadata, content);
    std::string index;
    put(index, file_.size());
    put(index, static_cast<std::uint64_t>(bytes.size()));
    putText(index, name);
    metadata_index_ += record(Op::MetadataIndex, index);
    ++metadata_count_;
    emit(bytes);
  }

  /// False once nothing more can be written.
  bool message(TopicNumber channel, std::int64_t time_ns, std::string_view json) {
    // a damaged recording may have an event before its beginning
    const auto time = static_cast<std::uint64_t>(std::max<std::int64_t>(time_ns, 0));
    std::string& index = chunk_indexes_[channel];
    put(index, time);
    put(index, static_cast<std::uint64_t>(chunk_.size()));
    put(chunk_, static_cast<std::uint8_t>(Op::Message));
    put(chunk_, static_cast<std::uint64_t>(22 + json.size()));
    put(chunk_, static_cast<std::uint16_t>(channel));
    put(chunk_, static_cast<std::uint32_t>(counts_[channel]++));
    put(chunk_, time);
    put(chunk_, time);
    chunk_ += json;
    chunk_times_.add(time);
    times_.add(time);
    return chunk_.size() < kChunkBytes || finishChunk();
  }

  void finish() {
    if (!chunk_indexes_.empty()) finishChunk();
    std::string end;
    put(end, crc_);
    emit(record(Op::DataEnd, end));

    const std::uint64_t summary = file_.size();
    crc_ = 0;
    std::string offsets;
    const auto group = [&](Op op, const std::string& records) {
      if (records.empty()) return;
      std::string offset;
      put(offset, static_cast<std::uint8_t>(op));
      put(offset, file_.size());
      put(offset, static_cast<std::uint64_t>(records.size()));
      offsets += record(Op::SummaryOffset, offset);
      emit(records);
    };
    std::string schemas, channels;
    for (std::uint16_t id = 0; id < topics().size(); ++id) {
      schemas += schemaRecord(id);
      channels += channelRecord(id);
    }
    group(Op::Schema, schemas);
    group(Op::Channel, channels);
    group(Op::Statistics, statistics());
    group(Op::ChunkIndex, chunk_index_);
    group(Op::MetadataIndex, metadata_index_);

    const std::uint64_t summary_offsets = file_.size();
    emit(offsets);
    std::string footer;
    put(footer, summary);
    put(footer, summary_offsets);
    // its sum takes in the footer up to itself
    std::string opening = record(Op::Footer, footer + std::string(4, '\0'));
    opening.resize(opening.size() - 4);
    emit(opening);
    std::string closing;
    put(closing, crc_);
    emit(closing);
    emit(kMagic);
  }

 private:
  struct Times {
    std::uint64_t first = 0, last = 0;
    bool any = false;
    void add(std::uint64_t time) {
      first = any ? std::min(first, time) : time;
      last = any ? std::max(last, time) : time;
      any = true;
    }
  };

  bool emit(std::string_view bytes) {
    crc_ = crcOf(bytes, crc_);
    return file_.write(bytes);
  }

  bool finishChunk() {
    std::string content;
    put(content, chunk_times_.first);
    put(content, chunk_times_.last);
    put(content, static_cast<std::uint64_t>(chunk_.size()));
    put(content, crcOf(chunk_));
    putText(content, "");
    put(content, static_cast<std::uint64_t>(chunk_.size()));
    content += chunk_;
    const std::uint64_t start = file_.size();
    emit(record(Op::Chunk, content));

    const std::uint64_t indexes = file_.size();
    std::string places;
    for (const auto& [channel, entries] : chunk_indexes_) {
      put(places, channel);
      put(places, file_.size());
      std::string index;
      put(index, channel);
      putText(index, entries);
      emit(record(Op::MessageIndex, index));
    }
    std::string index;
    put(index, chunk_times_.first);
    put(index, chunk_times_.last);
    put(index, start);
    put(index, indexes - start);
    putText(index, places);
    put(index, file_.size() - indexes);
    putText(index, "");
    put(index, static_cast<std::uint64_t>(chunk_.size()));
    put(index, static_cast<std::uint64_t>(chunk_.size()));
    chunk_index_ += record(Op::ChunkIndex, index);
    ++chunk_count_;
    chunk_.clear();
    chunk_indexes_.clear();
    chunk_times_ = {};
    return file_.write({});
  }

  std::string statistics() const {
    std::uint64_t messages = 0;
    std::string counts;
    for (const auto& [channel, count] : counts_) {
      messages += count;
      put(counts, channel);
      put(counts, count);
    }
    std::string content;
    put(content, messages);
    put(content, static_cast<std::uint16_t>(topics().size()));
    put(content, static_cast<std::uint32_t>(topics().size()));
    put(content, std::uint32_t{0});  // attachments
    put(content, metadata_count_);
    put(content, chunk_count_);
    put(content, times_.first);
    put(content, times_.last);
    putText(content, counts);
    return record(Op::Statistics, content);
  }

  OutputFile& file_;
  std::uint32_t crc_ = 0;  ///< of the file, then of its summary
  std::string chunk_;
  std::map<std::uint16_t, std::string> chunk_indexes_;
  Times chunk_times_, times_;
  std::string chunk_index_, metadata_index_;
  std::map<std::uint16_t, std::uint64_t> counts_;
  std::uint32_t chunk_count_ = 0, metadata_count_ = 0;
};

/// A JSON text as it grows.
class Json {
 public:
  const std::string& text() const { return text_; }
  void clear() { text_.clear(); }
  Json& raw(std::string_view words) {
    text_ += words;
    return *this;
  }
  Json& number(std::int64_t value) {
    appendNumber(text_, value);
    return *this;
  }
  /// With a point or an exponent, so that -0 stays one; null where it is not finite.
  template <std::floating_point Number>
  Json& number(Number value) {
    if (!std::isfinite(value)) return raw("null");
    const std::size_t start = text_.size();
    appendNumber(text_, value);
    if (text_.find_first_of(".e", start) == std::string::npos) text_ += ".0";
    return *this;
  }
  Json& vector(double x, double y, double z) {
    return raw(R"({"x":)").number(x).raw(R"(,"y":)").number(y).raw(R"(,"z":)").number(z).raw("}");
  }
  Json& vector(const Vec3& v) { return vector(v.x(), v.y(), v.z()); }
  Json& words(const std::string& text) { return raw(nlohmann::json(plain(text)).dump()); }

 private:
  std::string text_;
};

void writePose(Json& json, std::int64_t time_ns, const PoseNumbers& n) {
  json.raw(R"({"timestamp":{"sec":)").number(time_ns / 1'000'000'000);
  json.raw(R"(,"nsec":)").number(time_ns % 1'000'000'000);
  json.raw(R"(},"frame_id":"scan","pose":{"position":)").vector(n[0], n[1], n[2]);
  json.raw(R"(,"orientation":{"x":)").number(n[4]).raw(R"(,"y":)").number(n[5]);
  json.raw(R"(,"z":)").number(n[6]).raw(R"(,"w":)").number(n[3]).raw("}}}");
}
void writeWrench(Json& json, const Step& step) {
  const haptics::Wrench& wrench = step.sent_W;
  json.raw(R"({"force":)").vector(wrench.force).raw(R"(,"torque":)").vector(wrench.torque);
  json.raw(R"(,"friction_force":)").vector(frictionOf(step));
  json.raw("}");
}
void writeContacts(Json& json, const Step& step) {
  json.raw(R"({"contacts":[)");
  for (std::size_t i = 0; i < step.contacts.size(); ++i) {
    const haptics::BearingContact& contact = step.contacts[i];
    json.raw(i == 0 ? "" : ",").raw(R"({"arm":)").vector(contact.r_W);
    json.raw(R"(,"normal":)").vector(contact.n_W);
    json.raw(R"(,"push":)").number(contact.push).raw("}");
  }
  json.raw("]}");
}
void writeStructures(Json& json, const Step& step) {
  json.raw(R"({"structures":[)");
  for (std::size_t i = 0; i < step.near.size(); ++i) {
    const haptics::Nearness& near = step.near[i];
    json.raw(i == 0 ? "" : ",").raw(R"({"number":)").number(std::int64_t{near.structure} + 1);
    json.raw(R"(,"tip":)").number(near.tip).raw(R"(,"nearest":)").number(near.nearest).raw("}");
  }
  json.raw("]}");
}
void writeColumns(Json& json, const std::vector<const StepColumn*>& columns,
                  const RecordedStep& row, const char* separator) {
  for (const StepColumn* column : columns) {
    json.raw(separator).raw("\"").raw(keyOf(*column)).raw("\":");
    withValue(*column, row, [&](auto value) {
      if constexpr (std::is_floating_point_v<decltype(value)>)
        json.number(value);
      else
        json.number(static_cast<std::int64_t>(value));
    });
    separator = ",";
  }
}
void writeTick(Json& json, const RecordedStep& row) {
  static const std::vector<const StepColumn*> kColumns = columnsOf(Tick);
  json.raw(R"({"step":)").number(static_cast<std::int64_t>(row.step.sequence));
  writeColumns(json, kColumns, row, ",");
  json.raw("}");
}
void writeSettings(Json& json, const RecordedStep& row) {
  static const std::vector<const StepColumn*> kColumns = columnsOf(Settings);
  json.raw("{");
  writeColumns(json, kColumns, row, "");
  json.raw("}");
}
void writeEvent(Json& json, const RecordedEvent& event) {
  json.raw(R"({"step":)").number(static_cast<std::int64_t>(event.sequence));
  json.raw(R"(,"kind":)").words(event.kind);
  json.raw(R"(,"value":)").number(event.value.value_or(std::nan("")));
  json.raw(R"(,"note":)").words(event.text).raw("}");
}

}  // namespace

haptics::Expected<Exported> exportMcap(Recording& recording, const std::filesystem::path& out,
                                       const ExportOptions& options) {
  auto file = OutputFile::open(out);
  if (!file) return tl::unexpected(file.error());
  Exported exported;
  exported.files = {out.string()};
  Writer writer{*file};
  writer.metadata("recording", factsOf(recording));
  for (const RecordedScene& scene : recording.scenes())
    writer.metadata("scene " + std::to_string(scene.id), factsOf(scene));

  Json json;
  const auto send = [&](TopicNumber channel, std::int64_t time, auto&& write) {
    json.clear();
    write(json);
    return writer.message(channel, time, json.text());
  };
  auto events = eventsChosen(recording, options);
  exported.events = static_cast<std::int64_t>(events.size());
  const auto sendEventsUntil = [&](std::int64_t time) {
    bool going = true;
    for (; going && !events.empty() && events.front().time_ns <= time; events = events.subspan(1))
      going =
          send(Event, events.front().time_ns, [&](Json& to) { writeEvent(to, events.front()); });
    return going;
  };

  std::optional<std::string> settings;
  const auto done = forEachChosen(recording, options, [&](const RecordedStep& row) {
    const Step& step = row.step;
    const std::int64_t time = step.time_ns;
    ++exported.steps;
    // settings when they are first known, and when they change
    Json now;
    writeSettings(now, row);
    bool going = sendEventsUntil(time);
    if (settings != now.text()) {
      settings = now.text();
      going = going && writer.message(Settings, time, *settings);
    }
    going = going && send(Device, time, [&](Json& to) { writePose(to, time, row.device); }) &&
            send(Proxy, time, [&](Json& to) { writePose(to, time, row.proxy); }) &&
            send(Wrench, time, [&](Json& to) { writeWrench(to, step); }) &&
            send(Tick, time, [&](Json& to) { writeTick(to, row); });
    if (!step.near.empty())
      going = going && send(Structures, time, [&](Json& to) { writeStructures(to, step); });
    if (options.contacts)
      going = going && send(Contacts, time, [&](Json& to) { writeContacts(to, step); });
    return going;
  });
  if (!done) return tl::unexpected(done.error());
  sendEventsUntil(std::numeric_limits<std::int64_t>::max());
  writer.finish();
  if (auto closed = file->close(); !closed) return tl::unexpected(closed.error());
  auto bytes = file->finish();
  if (!bytes) return tl::unexpected(bytes.error());
  exported.bytes = *bytes;
  return exported;
}

}  // namespace app::exporting
