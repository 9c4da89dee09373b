// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "app/recording/scene_words.h"
#include "haptics/core/error.h"
#include "haptics/scene/scene.h"
#include "haptics/servo/step_ring.h"

namespace app {

/// The program and machine that made a recording. No host, user or date.
struct RecordingFacts {
  std::string version;     ///< of Palpate
  std::string build;       ///< one word; programs with the same build give the same numbers
  std::string machine;     ///< processor, cores, memory
  std::string about = {};  ///< JSON: program, commit, and how a run was asked for
};

/// Progress of a recording.
struct RecorderStatus {
  std::int64_t steps = 0;     ///< in the file
  std::int64_t lost = 0;      ///< steps lost because the ring was full
  double duration = 0.0;      ///< s, until the last step in the file
  std::int64_t bytes = 0;     ///< of the file and its log
  double longest_wait = 0.0;  ///< s between two commits
  haptics::Message failure =
      {};  ///< why the recording ended by itself, a sentence; empty: it goes on
};

/// Writes the steps from its ring into one SQLite file. Its own thread commits every quarter of a
/// second, so a crash of the process or the machine, or a full disk, loses few steps. The file is
/// called `NAME.part` until finish().
class Recorder {
 public:
  struct Options {
    std::chrono::milliseconds commit_every{250};
    const char* vfs = nullptr;     ///< as in Database::open
    haptics::ServoRate rate = {};  ///< of the servo loop as the recording begins
  };
  /// Refuses if the file cannot be made. If `NAME.part` exists, which is the unfinished file of
  /// another recording, refuses with reason "unfinished".
  static haptics::Expected<std::unique_ptr<Recorder>> create(const std::filesystem::path& target,
                                                             const RecordingFacts& facts,
                                                             const Options& options);
  static haptics::Expected<std::unique_ptr<Recorder>> create(const std::filesystem::path& target,
                                                             const RecordingFacts& facts) {
    return create(target, facts, Options{});
  }
  /// If finish() was not called, writes the steps received so far and keeps `NAME.part`. A file
  /// without a step is deleted.
  ~Recorder();

  /// The ring for the servo thread's steps.
  haptics::StepRing& ring();

  // For any thread except the servo thread; none of these calls waits for the disk.

  /// Describes a scene. Call it before the first step of that scene. `tool`: the name of a named
  /// tool; empty for a tool from a file, since a recording contains no file name.
  void describe(std::shared_ptr<const haptics::Scene> scene, std::string tool);
  /// Adds the hash of the volume of a described scene, once it is known.
  void identify(std::uint64_t scene, const VolumeHash& hash);
  /// States which voxels are touched: openHashOfVoxels().
  void stateVoxels(const std::string& sha256);
  /// Records an event of this moment: "mark" with a note, "camera",
  /// "device", kFeltEvent.
  void note(std::string kind, std::string text, std::optional<double> value = {});
  RecorderStatus status() const;
  /// Writes at once. For a thread that fills the ring and can wait when it is full; not for a servo
  /// thread.
  void hurry();

  /// Writes the remaining steps, checks the file, gives it its name and returns the name. The servo
  /// thread must have left the ring. Waits for the disk. On failure the committed steps stay in
  /// `NAME.part`. If there are none (reason "empty"), no file remains.
  haptics::Expected<std::filesystem::path> finish();

 private:
  class Writer;
  explicit Recorder(std::unique_ptr<Writer> writer);
  std::unique_ptr<Writer> writer_;
};

}  // namespace app
