// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "haptics/core/error.h"
#include "haptics/recording/block.h"
#include "haptics/recording/database.h"
#include "haptics/recording/scene_words.h"

namespace haptics {

/// Something that happened in a session.
struct RecordedEvent {
  std::uint64_t sequence = 0;  ///< of the step at or before which it happened
  std::int64_t time_ns = 0;
  std::string kind;  ///< "isovalue", "stiffness", "mark", "gap", …: README.md has all
  std::optional<double> value = {};
  std::string text = {};
};

/// A finished recording, open to be read. Steps are read block by block; what describes them is
/// read when it is opened. One thread at a time. Nothing in the file is trusted.
class Recording {
 public:
  /// Refusals: "not-found", "no-recording", "unfinished" (recover() it), "newer" (by a later
  /// Palpate), "damaged", "empty".
  static Expected<Recording> open(const std::filesystem::path& path);

  /// What made it: Palpate's version and build, the machine, the vectors that it used.
  const std::string& version() const { return version_; }
  const std::string& build() const { return build_; }
  const std::string& machine() const { return machine_; }
  const std::string& vectors() const { return vectors_; }

  std::int64_t stepCount() const { return step_count_; }
  std::int64_t lostCount() const { return lost_; }  ///< steps that there was no room for
  double begin() const;                             ///< s: time of the first step
  double end() const;                               ///< s: of the last
  const std::vector<RecordedEvent>& events() const { return events_; }
  const std::vector<ProxyStart>& starts() const { return starts_; }  ///< by sequence
  const std::vector<RecordedScene>& scenes() const { return scenes_; }
  const RecordedScene* scene(std::uint32_t id) const;  ///< null: none of that number

  std::size_t blockCount() const { return blocks_.size(); }
  /// The block that holds the last step at or before a time [s]; the first for earlier ones.
  std::size_t blockAt(double time) const;
  Expected<std::vector<RecordedStep>> block(std::size_t index);

  /// Calls `each` with every step from `from` to `to` [s], in order, until it returns false.
  Expected<void> forEach(double from, double to,
                         const std::function<bool(const RecordedStep&)>& each);

 private:
  struct Entry {
    std::int64_t first, count, from_ns, to_ns;
  };
  explicit Recording(Database database) : database_{std::move(database)} {}
  Expected<void> readBlocks();
  Expected<void> readEvents();
  Expected<void> readScenes();

  Database database_;
  std::string version_, build_, machine_, vectors_;
  std::int64_t step_count_ = 0, lost_ = 0;
  std::vector<Entry> blocks_;
  std::vector<RecordedEvent> events_;
  std::vector<ProxyStart> starts_;
  std::vector<RecordedScene> scenes_;
};

/// What a list of recordings tells of one.
struct RecordingSummary {
  std::int64_t steps = 0;
  double duration = 0.0;  ///< s
  std::string tool;       ///< of the first scene; empty: a file's
  std::int64_t bytes = 0;
};

/// Without reading the steps; refuses as Recording::open does.
Expected<RecordingSummary> summaryOf(const std::filesystem::path& path);

/// Whether two volumes have as many voxels, of the same type, in the same places.
bool liesLike(const Volume& one, const Volume& other);

}  // namespace haptics
