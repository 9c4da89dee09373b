// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/recording/block.h"
#include "app/recording/database.h"
#include "app/recording/scene_words.h"
#include "haptics/core/error.h"

namespace app {

/// Something that happened in a session.
struct RecordedEvent {
  std::uint64_t sequence = 0;  ///< sequence of the step at or before the event
  std::int64_t time_ns = 0;
  std::string kind;  ///< "isovalue", "stiffness", "mark", "gap", … (README.md lists all)
  std::optional<double> value = {};
  std::string text = {};
};

/// A finished recording, open for reading. Steps are read block by block; events, starts and scenes
/// are read when the file is opened. One thread at a time calls block() and forEach(), and not the
/// one of a window: a large file takes a while. All else may be asked meanwhile. All contents of
/// the file are checked, since it may come from anybody: its tables first, and what is read of it
/// is never more than the file holds.
class Recording {
 public:
  /// Refusals: "not-found", "no-recording", "unfinished" (use recover()), "beside" (a file lies
  /// beside it that SQLite would act on), "newer" (made by a later Palpate), "damaged", "empty";
  /// "cancelled" if meanwhile `cancel` is true, which may be null.
  static haptics::Expected<Recording> open(const std::filesystem::path& path,
                                           const std::atomic<bool>* cancel = nullptr);

  /// The program that recorded: Palpate's version and build, the machine, and its SIMD target.
  const std::string& version() const { return version_; }
  const std::string& build() const { return build_; }
  const std::string& machine() const { return machine_; }
  const std::string& vectors() const { return vectors_; }
  /// JSON: program, commit, and how a run was asked for; empty in recordings of earlier versions.
  const std::string& about() const { return about_; }

  std::int64_t stepCount() const { return step_count_; }
  std::int64_t lostCount() const { return lost_; }  ///< steps lost because the ring was full
  double begin() const;                             ///< s: time of the first step
  double end() const;                               ///< s: time of the last step
  const std::vector<RecordedEvent>& events() const { return events_; }
  const std::vector<haptics::ProxyStart>& starts() const { return starts_; }  ///< by sequence
  const std::vector<RecordedScene>& scenes() const { return scenes_; }
  const RecordedScene* scene(
      std::uint32_t id) const;  ///< null if there is no scene with this number

  /// The structures, from 0, to which distances were measured in some of its steps (Step::near).
  const std::vector<std::uint8_t>& structures() const { return structures_; }
  /// Whether a burr has cut in it.
  bool isCut() const { return has_cuts_; }

  std::size_t blockCount() const { return blocks_.size(); }
  /// The block with the last step at or before a time [s]; the first block for earlier times.
  std::size_t blockAt(double time) const;
  std::size_t stepsIn(std::size_t block) const { return std::size_t(blocks_[block].count); }
  double beginOf(std::size_t block) const;  ///< s: time of the block's first step
  haptics::Expected<std::vector<RecordedStep>> block(std::size_t index);

  /// Calls `each` with every step from `from` to `to` [s], both included, in order, until `each`
  /// returns false.
  haptics::Expected<void> forEach(double from, double to,
                                  const std::function<bool(const RecordedStep&)>& each);

 private:
  struct Entry {
    std::int64_t first, count, from_ns, to_ns;
  };
  Recording(Database database, std::int64_t bytes)
      : database_{std::move(database)}, bytes_{bytes} {}
  haptics::Expected<void> read();
  haptics::Expected<void> readBlocks();
  haptics::Expected<void> readStructures();
  haptics::Expected<void> readEvents();
  haptics::Expected<void> readScenes();

  Database database_;
  std::int64_t bytes_;  ///< of the file
  Layout layout_ = Layout::Exact;
  bool has_structures_ = false, has_cuts_ = false;
  std::vector<std::uint8_t> structures_;
  std::string version_, build_, machine_, vectors_, about_;
  std::int64_t step_count_ = 0, lost_ = 0;
  std::vector<Entry> blocks_;
  std::vector<RecordedEvent> events_;
  std::vector<haptics::ProxyStart> starts_;
  std::vector<RecordedScene> scenes_;
};

/// A recording as a line in a list of recordings.
struct RecordingSummary {
  std::int64_t steps = 0;
  double duration = 0.0;  ///< s
  std::string tool;       ///< tool of the first scene; empty: a tool from a file
  std::int64_t bytes = 0;
  std::optional<VolumeHash> scan = {};  ///< of the first scene
};

/// Does not read the steps. Refuses like Recording::open.
haptics::Expected<RecordingSummary> summaryOf(const std::filesystem::path& path,
                                              const std::atomic<bool>* cancel = nullptr);

/// Whether two volumes have the same number, type and positions of voxels.
bool liesLike(const haptics::Volume& one, const haptics::Volume& other);
/// Whether a scene was of this scan, as far as is known: it lies like it, and no hash says that it
/// is another.
bool isOf(const RecordedScene& scene, const haptics::Volume& scan,
          const std::optional<VolumeHash>& hash);

}  // namespace app
