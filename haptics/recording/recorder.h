// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

#include "haptics/core/error.h"
#include "haptics/recording/scene_words.h"
#include "haptics/scene/scene.h"
#include "haptics/servo/step_ring.h"

namespace haptics {

/// What a recording says of the program and machine that made it. No host, user or date.
struct RecordingFacts {
  std::string version;  ///< of Palpate
  std::string build;    ///< one word: programs with the same give the same numbers
  std::string machine;  ///< processor, cores, memory
};

/// How a recording comes along.
struct RecorderStatus {
  std::int64_t steps = 0;     ///< in the file
  std::int64_t lost = 0;      ///< for which the ring had no room
  double duration = 0.0;      ///< s, to the last step in the file
  std::int64_t bytes = 0;     ///< of the file and its log
  double longest_wait = 0.0;  ///< s between two commits
  Message failure = {};       ///< why it stopped by itself, a sentence; empty: it goes on
};

/// Writes what comes through its ring into one SQLite file, from a thread of its own, every
/// quarter of a second: so little is lost with the process, the machine or the disk. The file is
/// called `NAME.part` until finish().
class Recorder {
 public:
  struct Options {
    std::chrono::milliseconds commit_every{250};
    const char* vfs = nullptr;  ///< as in Database::open
  };
  /// Refused where the file cannot be made, and where `NAME.part` is there: it holds what another
  /// recording left, reason "unfinished".
  static Expected<std::unique_ptr<Recorder>> create(const std::filesystem::path& target,
                                                    const RecordingFacts& facts,
                                                    const Options& options);
  static Expected<std::unique_ptr<Recorder>> create(const std::filesystem::path& target,
                                                    const RecordingFacts& facts) {
    return create(target, facts, Options{});
  }
  /// Unless finished, what came until now is written, and stays `NAME.part`; without a step it
  /// goes.
  ~Recorder();

  /// Where the servo thread puts its steps.
  StepRing& ring();

  // Any thread but the servo's; none waits for the disk.

  /// A scene that steps will name, before the first of them does. `tool` is a named tool's name,
  /// or empty: a file's name is nobody's business.
  void describe(std::shared_ptr<const Scene> scene, std::string tool);
  /// The hash of the volume of a scene that was described, once it is known.
  void identify(std::uint64_t scene, const VolumeHash& hash);
  /// Something that happened now: "mark" with a note, "camera", "device".
  void note(std::string kind, std::string text);
  RecorderStatus status() const;
  /// The ring is full and its thread can wait: write now. Not for a servo thread.
  void hurry();

  /// Writes what is left, checks the whole and gives the file its name; returns it. The servo
  /// thread must have left the ring. Waits for the disk. On failure all that was committed stays in
  /// `NAME.part`; where nothing was, reason "empty", nothing is left.
  Expected<std::filesystem::path> finish();

 private:
  class Writer;
  explicit Recorder(std::unique_ptr<Writer> writer);
  std::unique_ptr<Writer> writer_;
};

/// The name of a recording while it is written.
std::filesystem::path partOf(const std::filesystem::path& target);

/// Whether somebody is writing `NAME.part`, or recovering it.
bool isInUse(const std::filesystem::path& part);

/// What is in an unfinished recording becomes a finished one: `NAME.part` is checked and gets its
/// name, or NAME-2 where that is taken. Refuses one that is being written, reason "in-use", and
/// what holds no step, reason "empty".
Expected<std::filesystem::path> recover(const std::filesystem::path& part);

}  // namespace haptics
