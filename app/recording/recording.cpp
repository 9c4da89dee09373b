// SPDX-License-Identifier: BSD-3-Clause
#include "app/recording/recording.h"

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "app/recording/schema.h"
#include "app/recording/unfinished.h"
#include "haptics/process/input_file.h"

namespace app {

namespace fs = std::filesystem;

namespace {

constexpr std::int64_t kMostBlocks = 10'000'000;
constexpr std::size_t kMostEvents = 10'000'000;

tl::unexpected<haptics::Error> damagedRecording() {
  return tl::unexpected(
      haptics::Error{haptics::Error::Kind::Malformed, {"recording-damaged", {}}, "damaged"});
}

tl::unexpected<haptics::Error> empty(const fs::path& path) {
  return tl::unexpected(haptics::Error{
      haptics::Error::Kind::Malformed, {"recording-no-step", {path.string()}}, "empty"});
}

/// A finished recording that this Palpate can read.
haptics::Expected<Database> opened(const fs::path& path, const std::atomic<bool>* cancel) {
  const auto refused = [](haptics::Error::Kind kind, haptics::Message message, const char* reason) {
    return tl::unexpected(haptics::Error{kind, std::move(message), reason});
  };
  std::error_code error;
  if (!fs::is_regular_file(path, error))
    return refused(haptics::Error::Kind::NotFound, {"input-unreadable", {path.string()}},
                   "not-found");
  if (path.extension() == ".part" || fs::exists(path.string() + "-wal", error))
    return refused(haptics::Error::Kind::Unsupported, {"recording-unfinished", {path.string()}},
                   "unfinished");
  if (const auto beside = foreignBeside(path)) return tl::unexpected(*beside);
  auto database = Database::open(path, Database::Mode::Read, cancel);
  if (!database)
    return refused(haptics::Error::Kind::NotFound, {"input-unreadable", {path.string()}},
                   "not-found");
  if (database->integer("PRAGMA application_id") != kApplicationId)
    return refused(haptics::Error::Kind::Unsupported,
                   {"recording-of-another-program", {path.string()}}, "no-recording");
  const std::int64_t format = database->integer("PRAGMA user_version");
  if (format > kHighestFormat)
    return refused(haptics::Error::Kind::Unsupported, {"file-of-later-palpate", {path.string()}},
                   "newer");
  if (format < kFormatOfScans || !database->hasSchema(tablesOf(format).c_str()))
    return refused(haptics::Error::Kind::Malformed,
                   {"recording-of-another-program", {path.string()}}, "damaged");
  return database;
}

tl::unexpected<haptics::Error> cancelledReading() {
  return tl::unexpected(
      haptics::Error{haptics::Error::Kind::Cancelled, {"work-cancelled", {}}, "cancelled"});
}

std::int64_t bytesInFile(const fs::path& path) {
  std::error_code error;
  const auto size = fs::file_size(path, error);
  return error ? 0 : static_cast<std::int64_t>(size);
}

/// The structures of a block of distances, from 0: of a list of at most kMostWatched numbers from
/// 1, each of them once.
std::optional<std::vector<std::uint8_t>> structuresFrom(const std::string& words) {
  const nlohmann::json list = haptics::isNestedDeeper(words, 1)
                                  ? nlohmann::json{}
                                  : nlohmann::json::parse(words, nullptr, false);
  if (!list.is_array() || list.empty() || list.size() > haptics::kMostWatched) return {};
  std::vector<std::uint8_t> structures;
  for (const nlohmann::json& number : list) {
    if (!number.is_number_integer() || number < 1 || number > 255) return {};
    const auto structure = static_cast<std::uint8_t>(number.get<int>() - 1);
    if (std::ranges::find(structures, structure) != structures.end()) return {};
    structures.push_back(structure);
  }
  return structures;
}

std::optional<VolumeHash> hashIn(Statement& row, int column) {
  VolumeHash hash;
  const auto bytes = row.blob(column);
  if (bytes.size() != hash.size()) return {};
  std::ranges::copy(bytes, hash.begin());
  return hash;
}

}  // namespace

haptics::Expected<Recording> Recording::open(const fs::path& path,
                                             const std::atomic<bool>* cancel) {
  auto database = opened(path, cancel);
  if (!database)
    return cancel != nullptr && *cancel ? cancelledReading() : tl::unexpected(database.error());
  Recording recording{std::move(*database), bytesInFile(path)};
  const auto read = recording.read();
  if (cancel != nullptr && *cancel) return cancelledReading();
  if (!read) return tl::unexpected(read.error());
  recording.database_.forgetCancel();
  if (recording.blocks_.empty()) return empty(path);
  return recording;
}

haptics::Expected<void> Recording::read() {
  const std::int64_t format = database_.integer("PRAGMA user_version");
  if (isRounded(format)) layout_ = Layout::Rounded;
  has_structures_ = hasStructures(format);
  has_cuts_ = hasCuts(format);
  Statement meta = database_.prepare("SELECT key, value FROM meta LIMIT 100");
  Statement::Step at;
  for (at = meta.step(); at == Statement::Step::Row; at = meta.step()) {
    const std::string key = meta.text(0);
    if (key == "palpate") version_ = meta.text(1);
    if (key == "build") build_ = meta.text(1);
    if (key == "machine") machine_ = meta.text(1);
    if (key == "vectors") vectors_ = meta.text(1);
    if (key == "about") about_ = meta.text(1);
  }
  if (at == Statement::Step::Failed) return damagedRecording();
  if (auto read = readBlocks(); !read) return read;
  if (auto read = readStructures(); !read) return read;
  if (auto read = readEvents(); !read) return read;
  return readScenes();
}

haptics::Expected<void> Recording::readBlocks() {
  Statement rows =
      database_.prepare("SELECT first, count, from_ns, to_ns FROM step ORDER BY first");
  Statement::Step at;
  for (at = rows.step(); at == Statement::Step::Row; at = rows.step()) {
    const Entry entry{rows.integer(0), rows.integer(1), rows.integer(2), rows.integer(3)};
    const std::int64_t next = blocks_.empty() ? 0 : blocks_.back().first + blocks_.back().count;
    const std::int64_t earliest = blocks_.empty() ? 0 : blocks_.back().to_ns;
    if (entry.count < 1 || entry.count > kMostStepsInBlock || entry.first < next ||
        entry.first > std::numeric_limits<std::int64_t>::max() - kMostStepsInBlock ||
        entry.from_ns < earliest || entry.to_ns < entry.from_ns ||
        static_cast<std::int64_t>(blocks_.size()) == kMostBlocks)
      return damagedRecording();
    lost_ += entry.first - next;
    step_count_ += entry.count;
    blocks_.push_back(entry);
  }
  if (at == Statement::Step::Failed) return damagedRecording();
  return {};
}

haptics::Expected<void> Recording::readStructures() {
  if (!has_structures_) return {};
  std::set<std::uint8_t> all;
  Statement rows = database_.prepare("SELECT DISTINCT structures FROM nearness");
  Statement::Step at;
  for (at = rows.step(); at == Statement::Step::Row; at = rows.step()) {
    const auto structures = structuresFrom(rows.text(0));
    if (!structures) return damagedRecording();
    all.insert(structures->begin(), structures->end());
  }
  if (at == Statement::Step::Failed) return damagedRecording();
  structures_.assign(all.begin(), all.end());
  return {};
}

haptics::Expected<void> Recording::readEvents() {
  Statement rows =
      database_.prepare("SELECT sequence, time_ns, kind, value, text, id FROM event ORDER BY id");
  Statement::Step at;
  std::optional<std::int64_t> before;
  std::int64_t bytes = 0;
  for (at = rows.step(); at == Statement::Step::Row; at = rows.step()) {
    RecordedEvent event{static_cast<std::uint64_t>(rows.integer(0)), rows.integer(1), rows.text(2)};
    if (!rows.isNull(3)) event.value = rows.real(3);
    event.text = rows.text(4);
    // pages that are there twice show their rows twice
    bytes += static_cast<std::int64_t>(event.kind.size() + event.text.size());
    if (bytes > bytes_ || (before && *before >= rows.integer(5))) return damagedRecording();
    before = rows.integer(5);
    if (event.kind == "start") {
      auto start = startFrom(event.text);
      if (!start) return tl::unexpected(start.error());
      start->sequence = event.sequence;
      starts_.push_back(*start);
      continue;
    }
    if (events_.size() == kMostEvents) return damagedRecording();
    events_.push_back(std::move(event));
  }
  if (at == Statement::Step::Failed) return damagedRecording();
  std::ranges::stable_sort(events_, {}, &RecordedEvent::time_ns);
  // what was lost at the end no later step shows
  const std::int64_t behind = blocks_.empty() ? 0 : blocks_.back().first + blocks_.back().count;
  for (const RecordedEvent& event : events_)
    if (event.kind == "gap" && event.value && *event.value >= 1.0 && *event.value < 1e12 &&
        event.sequence >= static_cast<std::uint64_t>(behind))
      lost_ += static_cast<std::int64_t>(*event.value);
  std::stable_sort(starts_.begin(), starts_.end(),
                   [](const haptics::ProxyStart& a, const haptics::ProxyStart& b) {
                     return a.sequence < b.sequence;
                   });
  return {};
}

haptics::Expected<void> Recording::readScenes() {
  constexpr std::size_t kMostScenes = 10'000;
  constexpr double kMostBytes = 1e9;  // of all tools together
  double bytes = 0.0;
  std::int64_t stored = 0;
  Statement rows = database_.prepare(
      "SELECT id, tool, settings, volume, volume_hash, points, vertices, triangles FROM scene "
      "ORDER BY id");
  Statement::Step at;
  for (at = rows.step(); at == Statement::Step::Row; at = rows.step()) {
    const SceneWords words{rows.text(2), rows.text(3), rows.blob(5), rows.blob(6), rows.blob(7)};
    stored += static_cast<std::int64_t>(words.settings.size() + words.volume.size() +
                                        words.points.size() + words.vertices.size() +
                                        words.triangles.size());
    if (stored > bytes_) return damagedRecording();
    auto scene = sceneFrom(words);
    if (!scene) return tl::unexpected(scene.error());
    bytes += double(scene->tool.shell.points.size() + scene->tool.mesh.vertices.size()) *
                 sizeof(haptics::Vec3) +
             double(scene->tool.mesh.triangles.size()) * 3.0 * sizeof(std::uint32_t);
    if (scenes_.size() == kMostScenes || bytes > kMostBytes) return damagedRecording();
    scene->id = static_cast<std::uint32_t>(rows.integer(0));
    scene->tool.name = rows.text(1);
    scene->hash = hashIn(rows, 4);
    scenes_.push_back(std::move(*scene));
  }
  if (at == Statement::Step::Failed) return damagedRecording();
  return {};
}

double Recording::begin() const { return double(blocks_.front().from_ns) * 1e-9; }
double Recording::beginOf(std::size_t block) const { return double(blocks_[block].from_ns) * 1e-9; }
double Recording::end() const { return double(blocks_.back().to_ns) * 1e-9; }

const RecordedScene* Recording::scene(std::uint32_t id) const {
  for (const RecordedScene& scene : scenes_)
    if (scene.id == id) return &scene;
  return nullptr;
}

std::size_t Recording::blockAt(double time) const {
  const auto after = std::upper_bound(
      blocks_.begin(), blocks_.end(), time,
      [](double t, const Entry& entry) { return t < double(entry.from_ns) * 1e-9; });
  return after == blocks_.begin() ? 0 : static_cast<std::size_t>(after - blocks_.begin()) - 1;
}

haptics::Expected<std::vector<RecordedStep>> Recording::block(std::size_t index) {
  const Entry& entry = blocks_[index];
  Block block{.first = static_cast<std::uint64_t>(entry.first),
              .count = entry.count,
              .from_ns = entry.from_ns,
              .to_ns = entry.to_ns};
  Statement steps = database_.prepare("SELECT data FROM step WHERE first = ?");
  if (steps.bind(1, entry.first).step() != Statement::Step::Row) return damagedRecording();
  block.steps = steps.blob(0);
  Statement contacts = database_.prepare("SELECT count, data FROM contact WHERE first = ?");
  const Statement::Step found = contacts.bind(1, entry.first).step();
  if (found == Statement::Step::Failed) return damagedRecording();
  if (found == Statement::Step::Row) {
    block.contact_count = contacts.integer(0);
    block.contacts = contacts.blob(1);
  }
  if (has_structures_) {
    Statement nearness = database_.prepare("SELECT structures, data FROM nearness WHERE first = ?");
    const Statement::Step near = nearness.bind(1, entry.first).step();
    if (near == Statement::Step::Failed) return damagedRecording();
    if (near == Statement::Step::Row) {
      const auto structures = structuresFrom(nearness.text(0));
      if (!structures) return damagedRecording();
      block.structures = *structures;
      block.nearness = nearness.blob(1);
    }
  }
  if (has_cuts_) {
    Statement cuts = database_.prepare("SELECT count, data FROM cut WHERE first = ?");
    const Statement::Step cut = cuts.bind(1, entry.first).step();
    if (cut == Statement::Step::Failed) return damagedRecording();
    if (cut == Statement::Step::Row) {
      block.cut_count = cuts.integer(0);
      block.cuts = cuts.blob(1);
    }
  }
  return decoded(block, layout_);
}

haptics::Expected<void> Recording::forEach(double from, double to,
                                           const std::function<bool(const RecordedStep&)>& each) {
  for (std::size_t b = blockAt(from); b < blockCount(); ++b) {
    auto steps = block(b);
    if (!steps) return tl::unexpected(steps.error());
    for (const RecordedStep& step : *steps) {
      const double time = double(step.step.time_ns) * 1e-9;
      if (time < from) continue;
      if (time > to || !each(step)) return {};
    }
  }
  return {};
}

haptics::Expected<RecordingSummary> summaryOf(const fs::path& path,
                                              const std::atomic<bool>* cancel) {
  auto database = opened(path, cancel);
  if (!database) return tl::unexpected(database.error());
  RecordingSummary summary;
  Statement steps = database->prepare("SELECT sum(count), min(from_ns), max(to_ns) FROM step");
  if (steps.step() != Statement::Step::Row) return damagedRecording();
  if (steps.isNull(0)) return empty(path);
  summary.steps = steps.integer(0);
  summary.duration = (steps.real(2) - steps.real(1)) * 1e-9;
  Statement scene = database->prepare("SELECT tool, volume_hash FROM scene ORDER BY id LIMIT 1");
  if (scene.step() == Statement::Step::Row) {
    summary.tool = scene.text(0);
    summary.scan = hashIn(scene, 1);
  }
  summary.bytes = bytesInFile(path);
  return summary;
}

bool liesLike(const haptics::Volume& one, const haptics::Volume& other) {
  return one.grid.dims == other.grid.dims && one.type == other.type &&
         one.grid.spacing == other.grid.spacing && one.grid.origin == other.grid.origin &&
         one.grid.direction == other.grid.direction;
}

bool isOf(const RecordedScene& scene, const haptics::Volume& scan,
          const std::optional<VolumeHash>& hash) {
  return liesLike(scene.volume, scan) && compared(scene.hash, hash) != SameVolume::Another;
}

}  // namespace app
