// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "app/cli/outcome.h"
#include "app/recording/recorder.h"
#include "haptics/simulation/closed_loop.h"

namespace app::cli {

/// The keyed hash of a volume; none without a key, as in a build without Qt.
std::optional<VolumeHash> hashHere(const haptics::Volume& volume);

/// SHA-256 of the voxels as they lie in memory, little-endian numbers of their type, i fastest, in
/// hexadecimal: what `sha256sum` says of them. None in a build without Qt.
std::optional<std::string> openHashOf(const haptics::Volume& volume);

/// Records a closed loop in the same way as a session. The loop waits if the ring is full, so no
/// step is lost.
class RecordedRun {
 public:
  /// `tool`: the name of a named tool, or empty. `about`: how the run was asked for. The loop must
  /// outlive the run.
  static haptics::Expected<std::unique_ptr<RecordedRun>> begin(const std::string& path,
                                                               haptics::ClosedLoop& loop,
                                                               std::string tool,
                                                               const nlohmann::ordered_json& about);
  void write(const haptics::TraceRow& row);
  /// Finishes the file and gives it its name. Returns a summary of its content.
  haptics::Expected<nlohmann::ordered_json> finish();

 private:
  RecordedRun(std::unique_ptr<Recorder> recorder, const haptics::ClosedLoop& loop)
      : recorder_{std::move(recorder)}, loop_{loop} {}
  std::unique_ptr<Recorder> recorder_;
  const haptics::ClosedLoop& loop_;
  std::int64_t ticks_ = 0;
};

}  // namespace app::cli
