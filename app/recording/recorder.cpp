// SPDX-License-Identifier: BSD-3-Clause
#include "app/recording/recorder.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <condition_variable>
#include <ctime>
#include <exception>
#include <map>
#include <mutex>
#include <optional>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "app/recording/block.h"
#include "app/recording/carved_copy.h"
#include "app/recording/cut_words.h"
#include "app/recording/database.h"
#include "app/recording/scene_words.h"
#include "app/recording/schema.h"
#include "app/recording/unfinished.h"
#include "haptics/core/clock.h"
#include "haptics/field/lanes.h"

namespace app {

namespace fs = std::filesystem;

namespace {

constexpr int kPageBytes = 16384;  // a block fits into a few
haptics::Message complaintOf(const Database& database) {
  return database.isFull() ? haptics::Message{"disk-full", {}}
                           : haptics::Message{database.complaint()};
}

/// Above 1 kHz the steps are so many that they are stored with less.
Layout layoutAt(haptics::ServoRate rate) {
  return rate.hz > haptics::ServoRate{}.hz ? Layout::Rounded : Layout::Exact;
}

std::int64_t bytesOf(const fs::path& path) {
  std::error_code error;
  const auto size = fs::file_size(path, error);
  return error ? 0 : static_cast<std::int64_t>(size);
}

}  // namespace

/// The thread that writes, and what others tell it.
class Recorder::Writer {
 public:
  Writer(fs::path target, Database database, const Options& options)
      : target_{std::move(target)},
        database_{std::move(database)},
        options_{options},
        layout_{layoutAt(options.rate)},
        ring{haptics::monotonicNs(), options.rate} {
    steps_.reserve(ring.capacity());
    thread_ = std::thread{[this] { run(); }};
  }
  ~Writer() {
    end();
    if (database_ && written_ == 0) discard();
  }

  void end() {
    {
      const std::scoped_lock lock(mutex_);
      ending_ = true;
    }
    news_.notify_one();
    if (thread_.joinable()) thread_.join();
  }

  struct Event {
    std::int64_t time_ns = 0;
    std::string kind, text = {};
    std::optional<double> value = {};
    std::optional<std::uint64_t> sequence = {};
  };
  struct Described {
    std::shared_ptr<const haptics::Scene> scene;
    std::string tool;
  };

  void tell(Event event) {
    const std::scoped_lock lock(mutex_);
    told_.push_back(std::move(event));
  }
  void tell(Described described) {
    const std::scoped_lock lock(mutex_);
    described_.push_back(std::move(described));
  }
  void tell(std::uint64_t scene, const VolumeHash& hash) {
    const std::scoped_lock lock(mutex_);
    identified_.emplace_back(scene, hash);
  }
  void stateVoxels(const std::string& sha256) {
    const std::scoped_lock lock(mutex_);
    voxels_ = sha256;
  }
  void hurry() {
    {
      const std::scoped_lock lock(mutex_);
      hurried_ = true;
    }
    news_.notify_one();
  }
  RecorderStatus status() const {
    const std::scoped_lock lock(mutex_);
    return status_;
  }

  haptics::Expected<fs::path> finish() {
    end();
    if (const haptics::Message why = status().failure; !why.empty())
      return tl::unexpected(haptics::Error{haptics::Error::Kind::Unsupported, why, "unfinished"});
    if (written_ == 0) {
      discard();
      return tl::unexpected(
          haptics::Error{haptics::Error::Kind::NotFound, {"recording-empty-no-tick", {}}, "empty"});
    }
    return completed(database_, partOf(target_), target_);
  }

 private:
  void run();
  void countLostAtTheEnd();
  void discard();
  bool commit();
  bool writeSteps();
  bool addTables(bool cuts);
  bool writeNearness(const Block& block);
  bool writeCuts(const Block& block);
  bool writeScenes(const std::vector<Described>& scenes);
  void takeStarts();
  void carve(haptics::Step& step);
  void noteCarved();
  bool writeEvent(Statement& insert, const Event& event);
  void noteChanges(const haptics::Step& step);
  std::uint64_t sequenceAt(std::int64_t time_ns) const;
  void fail();
  void fail(const haptics::Message& why);

  fs::path target_;
  std::optional<Database> database_;
  Options options_;
  Layout layout_;

 public:
  haptics::StepRing ring;

 private:
  // what others tell, under the mutex
  mutable std::mutex mutex_;
  std::condition_variable news_;
  bool ending_ = false, hurried_ = false;
  std::vector<Event> told_;
  std::vector<Described> described_;
  std::vector<std::pair<std::uint64_t, VolumeHash>> identified_;
  std::string voxels_;
  RecorderStatus status_;

  // the writing thread's own
  std::vector<haptics::Step> steps_;
  std::vector<Event> events_;
  std::optional<haptics::Step> last_;  ///< the newest that was taken from the ring
  std::int64_t written_ = 0, lost_ = 0;
  std::uint64_t late_ = 0, missed_ = 0;  ///< since the last commit
  bool watches_ = false;                 ///< the file has the table of distances
  bool cuts_ = false;                    ///< and that of cuts
  /// What is touched in the scenes of steps that may yet come, by their ids.
  std::map<std::uint32_t, CarvedCopy> copies_;
  std::thread thread_;
};

void Recorder::Writer::run() {
  std::int64_t committed = haptics::monotonicNs();
  auto due = std::chrono::steady_clock::now() + options_.commit_every;
  for (bool ended = false; !ended;) {
    {
      std::unique_lock lock(mutex_);
      news_.wait_until(lock, due, [&] { return ending_ || hurried_; });
      ended = ending_;
      hurried_ = false;
    }
    due = std::chrono::steady_clock::now() + options_.commit_every;
    try {
      // at the end nothing may stay in the ring
      do {
        if (!commit()) return fail();
      } while (ended && !ring.empty());
      if (ended) {
        countLostAtTheEnd();
        noteCarved();
        if (!commit()) return fail();
      }
    } catch (const std::exception&) {
      // libraries may throw where memory ends
      return fail({"memory-exhausted", {}});
    }
    const std::int64_t now = haptics::monotonicNs();
    const std::int64_t bytes =
        bytesOf(partOf(target_)) + bytesOf(fs::path(partOf(target_).string() + "-wal"));
    const std::scoped_lock lock(mutex_);
    status_.steps = written_;
    status_.lost = lost_;
    status_.duration = last_ ? double(last_->time_ns) * 1e-9 : 0.0;
    status_.bytes = bytes;
    status_.longest_wait = std::max(status_.longest_wait, double(now - committed) * 1e-9);
    committed = now;
  }
}

/// Ticks after the last that was taken: no later one shows that they are missing.
void Recorder::Writer::countLostAtTheEnd() {
  const std::uint64_t known = last_ ? last_->sequence + 1 : 0;
  if (ring.numbered() <= known) return;
  lost_ += static_cast<std::int64_t>(ring.numbered() - known);
  events_.push_back({.time_ns = last_ ? last_->time_ns : 0,
                     .kind = "gap",
                     .value = double(ring.numbered() - known),
                     .sequence = known});
}

void Recorder::Writer::discard() {
  database_.reset();
  std::error_code ignored;
  fs::remove(partOf(target_), ignored);
  fs::remove(partOf(target_).string() + "-wal", ignored);
}

void Recorder::Writer::fail() { fail(complaintOf(*database_)); }

void Recorder::Writer::fail(const haptics::Message& why) {
  database_->run("ROLLBACK");
  database_->keepLog();
  const std::scoped_lock lock(mutex_);
  const std::string name = partOf(target_).filename().string();
  if (written_ == 0)
    status_.failure = {"recording-stopped-empty", {why}};
  else
    status_.failure = {"recording-stopped", {why, name}};
}

/// Everything that came since the last time, in one transaction.
bool Recorder::Writer::commit() {
  std::vector<Described> scenes;
  std::vector<std::pair<std::uint64_t, VolumeHash>> identified;
  std::vector<Event> told;
  std::string voxels;
  {
    const std::scoped_lock lock(mutex_);
    voxels.swap(voxels_);
    scenes.swap(described_);
    identified.swap(identified_);
    told.swap(told_);
  }
  if (!database_->run("BEGIN")) return false;
  for (const Described& described : scenes)
    copies_.insert_or_assign(static_cast<std::uint32_t>(described.scene->id),
                             CarvedCopy{described.scene->volume});
  takeStarts();
  if (!writeSteps()) return false;
  // of steps that came while they were taken, so that none is written without its start
  takeStarts();
  if (!writeScenes(scenes)) return false;
  if (std::ranges::find(told, "mark", &Event::kind) != told.end()) noteCarved();
  Statement insert = database_->prepare(
      "INSERT INTO event (sequence, time_ns, kind, value, text) VALUES (?, ?, ?, ?, ?)");
  for (const Event& event : events_)
    if (!writeEvent(insert, event)) return false;
  for (Event& event : told) {
    event.sequence = sequenceAt(event.time_ns);
    if (!writeEvent(insert, event)) return false;
  }
  Statement hash = database_->prepare("UPDATE scene SET volume_hash = ? WHERE id = ?");
  for (const auto& [id, value] : identified)
    if (!hash.bind(1, std::span{value}).bind(2, static_cast<std::int64_t>(id)).run()) return false;
  if (!voxels.empty() &&
      !database_
           ->prepare(
               "UPDATE meta SET value = json_set(value, '$.voxels_sha256', ?) WHERE key = 'about'")
           .bind(1, std::string_view{voxels})
           .run())
    return false;
  if (!database_->run("COMMIT")) return false;
  written_ += static_cast<std::int64_t>(steps_.size());
  events_.clear();
  return true;
}

bool Recorder::Writer::writeScenes(const std::vector<Described>& scenes) {
  Statement insert = database_->prepare(
      "INSERT OR REPLACE INTO scene (id, tool, settings, volume, volume_hash, points, vertices, "
      "triangles) VALUES (?, ?, ?, ?, NULL, ?, ?, ?)");
  for (const auto& [scene, tool] : scenes) {
    // who knows no edits would replay over the scan
    if (scene->volume->derivation && layout_ == Layout::Exact && !watches_ &&
        !database_->run(("PRAGMA user_version = " + std::to_string(kFormatOfEdits)).c_str()))
      return false;
    const SceneWords words = wordsOf(*scene);
    if (!insert.bind(1, static_cast<std::int64_t>(scene->id))
             .bind(2, tool)
             .bind(3, words.settings)
             .bind(4, words.volume)
             .bind(5, std::span{words.points})
             .bind(6, std::span{words.vertices})
             .bind(7, std::span{words.triangles})
             .run())
      return false;
  }
  return true;
}

/// Before the steps that follow them are taken.
void Recorder::Writer::takeStarts() {
  for (haptics::ProxyStart start; ring.take(start);)
    events_.push_back({.time_ns = last_ ? last_->time_ns : 0,
                       .kind = "start",
                       .text = wordsOf(start),
                       .sequence = start.sequence});
}

bool Recorder::Writer::writeSteps() {
  steps_.clear();
  for (haptics::Step step; steps_.size() < ring.capacity() && ring.take(step);) {
    noteChanges(step);
    carve(step);
    steps_.push_back(step);
    last_ = step;
  }
  Statement insert_steps = database_->prepare(
      "INSERT INTO step (first, count, from_ns, to_ns, data) VALUES (?, ?, ?, ?, ?)");
  Statement insert_contacts =
      database_->prepare("INSERT INTO contact (first, count, data) VALUES (?, ?, ?)");
  const std::span<const haptics::Step> all{steps_};
  for (std::size_t begin = 0; begin < all.size();) {
    std::size_t end = begin + 1;
    while (end < all.size() && end - begin < std::size_t{kMostStepsInBlock} &&
           isNext(all[end - 1], all[end]))
      ++end;
    const Block block = encoded(all.subspan(begin, end - begin), layout_);
    const auto first = static_cast<std::int64_t>(block.first);
    if (!insert_steps.bind(1, first)
             .bind(2, block.count)
             .bind(3, block.from_ns)
             .bind(4, block.to_ns)
             .bind(5, std::span{block.steps})
             .run())
      return false;
    if (block.contact_count > 0 && !insert_contacts.bind(1, first)
                                        .bind(2, block.contact_count)
                                        .bind(3, std::span{block.contacts})
                                        .run())
      return false;
    if (!block.structures.empty() && !writeNearness(block)) return false;
    if (block.cut_count > 0 && !writeCuts(block)) return false;
    begin = end;
  }
  // an event for each would be most of the file on a busy machine: the steps have them
  const auto addSum = [&](const char* kind, std::uint64_t& sum) {
    if (sum > 0)
      events_.push_back({.time_ns = last_->time_ns,
                         .kind = kind,
                         .value = double(sum),
                         .sequence = last_->sequence});
    sum = 0;
  };
  addSum("late", late_);
  addSum("missed", missed_);
  return true;
}

/// Gives the file the tables of distances, and those of cuts if `cuts`. Who knows no such table
/// would not take the file for a recording, so it says so by its format.
bool Recorder::Writer::addTables(bool cuts) {
  if (!watches_ && !database_->run(kNearnessTable)) return false;
  if (cuts && !cuts_ && !database_->run(kCutTable)) return false;
  watches_ = true;
  cuts_ = cuts_ || cuts;
  const bool exact = layout_ == Layout::Exact;
  const int format = cuts_ ? (exact ? kFormatOfCuts : kFormatOfRoundedCuts)
                           : (exact ? kFormatOfStructures : kFormatOfRoundedStructures);
  return database_->run(("PRAGMA user_version = " + std::to_string(format)).c_str());
}

bool Recorder::Writer::writeCuts(const Block& block) {
  if (!cuts_) {
    if (!addTables(true) || !database_->prepare("INSERT INTO meta (key, value) VALUES (?, ?)")
                                 .bind(1, std::string_view{"cut_layout"})
                                 .bind(2, cutLayout())
                                 .run())
      return false;
  }
  return database_->prepare("INSERT INTO cut (first, count, data) VALUES (?, ?, ?)")
      .bind(1, static_cast<std::int64_t>(block.first))
      .bind(2, block.cut_count)
      .bind(3, std::span{block.cuts})
      .run();
}

bool Recorder::Writer::writeNearness(const Block& block) {
  if (!watches_ && !addTables(false)) return false;
  std::string structures;
  for (const std::uint8_t structure : block.structures)
    structures += (structures.empty() ? "[" : ",") + std::to_string(structure + 1);
  return database_->prepare("INSERT INTO nearness (first, structures, data) VALUES (?, ?, ?)")
      .bind(1, static_cast<std::int64_t>(block.first))
      .bind(2, structures + "]")
      .bind(3, std::span{block.nearness})
      .run();
}

/// Carries out what was cut, in voxels of its own.
void Recorder::Writer::carve(haptics::Step& step) {
  if (step.scene != 0) copies_.erase(copies_.begin(), copies_.lower_bound(step.scene));
  const auto copy = copies_.find(step.scene);
  if (!step.cut || copy == copies_.end()) return;
  // where there is no memory the recording goes on, and says nothing of what was removed
  if (const auto done = copy->second.carve(*step.cut))
    step.removed = std::max(0.0, done->removed.volume);
  else
    copies_.erase(copy);
}

/// Says what the cuts have left until now.
void Recorder::Writer::noteCarved() {
  if (!last_) return;
  const auto copy = copies_.find(last_->scene);
  const std::uint64_t digest = copy == copies_.end() ? 0 : copy->second.digest();
  if (digest == 0) return;
  events_.push_back({.time_ns = last_->time_ns,
                     .kind = kCarvedEvent,
                     .text = wordOf(digest),
                     .sequence = last_->sequence});
}

/// What is worth an event of its own between two steps.
void Recorder::Writer::noteChanges(const haptics::Step& step) {
  const auto add = [&](const char* kind, double value) {
    events_.push_back(
        {.time_ns = step.time_ns, .kind = kind, .value = value, .sequence = step.sequence});
  };
  // of a new loop they count from zero again
  const auto grown = [](std::uint32_t before, std::uint32_t now) {
    return now >= before ? now - before : now;
  };
  late_ += grown(last_ ? last_->late_ticks : step.late_ticks, step.late_ticks);
  missed_ += grown(last_ ? last_->missed_ticks : step.missed_ticks, step.missed_ticks);
  const std::uint64_t expected = last_ ? last_->sequence + 1 : 0;
  if (step.sequence > expected) {
    lost_ += static_cast<std::int64_t>(step.sequence - expected);
    add("gap", double(step.sequence - expected));
  }
  const auto differs = [&](auto member) { return !last_ || (*last_).*member != step.*member; };
  const auto moved = [&](auto member) {
    return !last_ || last_->settings.*member != step.settings.*member;
  };
  if (moved(&haptics::Settings::isovalue)) add("isovalue", step.settings.isovalue);
  if (moved(&haptics::Settings::stiffness)) add("stiffness", step.settings.stiffness);
  if (moved(&haptics::Settings::angular_stiffness))
    add("angular_stiffness", step.settings.angular_stiffness);
  if (moved(&haptics::Settings::friction)) add("friction", step.settings.friction);
  if (differs(&haptics::Step::scene)) add("scene", double(step.scene));
  if (differs(&haptics::Step::force_state))
    add("force", double(static_cast<int>(step.force_state)));
  if (moved(&haptics::Settings::force_scale)) add("force_scale", step.settings.force_scale);
  if (moved(&haptics::Settings::position_scale))
    add("position_scale", step.settings.position_scale);
  const auto clutched = [](const haptics::Step& s) {
    return (s.flags & haptics::StepFlags::kClutched) != 0;
  };
  if (clutched(step) != (last_ && clutched(*last_))) add("clutch", clutched(step) ? 1.0 : 0.0);
  constexpr int kDevice = haptics::StepFlags::kLost | haptics::StepFlags::kSilent |
                          haptics::StepFlags::kNotReady | haptics::StepFlags::kGap |
                          haptics::StepFlags::kTooFast | haptics::StepFlags::kJumped |
                          haptics::StepFlags::kStalled;
  if (((last_ ? last_->flags : 0) & kDevice) != (step.flags & kDevice))
    add("device", double(step.flags & kDevice));
}

std::uint64_t Recorder::Writer::sequenceAt(std::int64_t time_ns) const {
  const auto after = std::upper_bound(
      steps_.begin(), steps_.end(), time_ns,
      [](std::int64_t time, const haptics::Step& step) { return time < step.time_ns; });
  if (after != steps_.begin()) return std::prev(after)->sequence;
  if (after != steps_.end()) return after->sequence;
  return last_ ? last_->sequence : 0;
}

bool Recorder::Writer::writeEvent(Statement& insert, const Event& event) {
  insert.bind(1, static_cast<std::int64_t>(event.sequence.value_or(0)))
      .bind(2, event.time_ns)
      .bind(3, event.kind);
  if (event.value)
    insert.bind(4, *event.value);
  else
    insert.bindNull(4);
  if (event.text.empty())
    insert.bindNull(5);
  else
    insert.bind(5, event.text);
  return insert.run();
}

haptics::Expected<std::unique_ptr<Recorder>> Recorder::create(const fs::path& target,
                                                              const RecordingFacts& facts,
                                                              const Options& options) {
  const fs::path part = partOf(target);
  std::error_code ignored;
  const auto unwritable = [&](const haptics::Message& why) {
    return tl::unexpected(haptics::Error{haptics::Error::Kind::Unsupported,
                                         {"output-unwritable", {target.string(), why}},
                                         "unwritable"});
  };
  if (options.vfs == nullptr)
    for (const char* log : {"-journal", "-wal", "-shm"})
      if (const fs::path left = part.string() + log; fs::exists(fs::symlink_status(left, ignored)))
        return tl::unexpected(haptics::Error{haptics::Error::Kind::Unsupported,
                                             {"recording-left-over", {left.string()}},
                                             "unfinished"});
  // made here, or not at all: what is there is somebody's
  const int made = options.vfs != nullptr
                       ? -1
                       : ::open(part.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0666);
  if (made >= 0) ::close(made);
  if (options.vfs == nullptr && made < 0 && errno != EEXIST)
    return unwritable(std::generic_category().message(errno));
  if (options.vfs == nullptr && made < 0)
    return tl::unexpected(haptics::Error{
        haptics::Error::Kind::Unsupported, {"recording-left-over", {part.string()}}, "unfinished"});
  auto opened = Database::open(part, Database::Mode::Create, nullptr, options.vfs);
  if (!opened) return unwritable(opened.error().message);
  std::optional<Database> database{std::move(*opened)};
  const Layout layout = layoutAt(options.rate);
  const int format = layout == Layout::Exact ? kFormatOfScans : kFormatOfRounding;
  const std::string setup =
      // the identity before there is a log, so that the file itself has it: see recover()
      "PRAGMA page_size = " + std::to_string(kPageBytes) +
      "; PRAGMA application_id = " + std::to_string(kApplicationId) +
      "; PRAGMA user_version = " + std::to_string(format) +
      "; PRAGMA journal_mode = WAL; PRAGMA synchronous = FULL; BEGIN;" + kSchema;
  const auto say = [&](const char* key, std::string_view value) {
    return database->prepare("INSERT INTO meta (key, value) VALUES (?, ?)")
        .bind(1, std::string_view{key})
        .bind(2, value)
        .run();
  };
  if (!database->run(setup.c_str()) || !say("palpate", facts.version) ||
      !say("build", facts.build) || !say("machine", facts.machine) || !say("about", facts.about) ||
      !say("vectors", haptics::lanes::targetName()) || !say("step_layout", stepLayout(layout)) ||
      !say("contact_layout", contactLayout(layout)) || !database->run("COMMIT")) {
    const haptics::Message why = complaintOf(*database);
    database.reset();
    std::error_code error;
    fs::remove(part, error);
    fs::remove(part.string() + "-wal", error);
    return unwritable(why);
  }
  syncFolderOf(part);
  return std::unique_ptr<Recorder>(
      new Recorder{std::make_unique<Writer>(target, std::move(*database), options)});
}

Recorder::Recorder(std::unique_ptr<Writer> writer) : writer_{std::move(writer)} {}
Recorder::~Recorder() = default;

haptics::StepRing& Recorder::ring() { return writer_->ring; }
void Recorder::describe(std::shared_ptr<const haptics::Scene> scene, std::string tool) {
  writer_->tell(Writer::Described{std::move(scene), std::move(tool)});
}
void Recorder::identify(std::uint64_t scene, const VolumeHash& hash) { writer_->tell(scene, hash); }
void Recorder::stateVoxels(const std::string& sha256) { writer_->stateVoxels(sha256); }
void Recorder::hurry() { writer_->hurry(); }
void Recorder::note(std::string kind, std::string text, std::optional<double> value) {
  writer_->tell(Writer::Event{.time_ns = haptics::monotonicNs() - writer_->ring.begun(),
                              .kind = std::move(kind),
                              .text = std::move(text),
                              .value = value});
}
RecorderStatus Recorder::status() const { return writer_->status(); }
haptics::Expected<fs::path> Recorder::finish() { return writer_->finish(); }

}  // namespace app
