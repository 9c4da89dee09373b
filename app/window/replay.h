// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <atomic>
#include <filesystem>
#include <memory>
#include <vector>

#include "app/background/task.h"
#include "app/window/force_curve.h"
#include "haptics/recording/recording.h"
#include "haptics/snapshot.h"
#include "ui/panels/force_plot.h"
#include "ui/panels/replay_timeline.h"

namespace app {

/// An open recording with a present position. GUI thread; another thread reads the curve of the
/// force.
class Replay : public QObject {
  Q_OBJECT
 public:
  /// A recording with the steps of its first block.
  struct Beginning {
    haptics::Recording recording;
    std::vector<haptics::RecordedStep> steps;
  };
  /// Not on the GUI thread: the file may be large, and anybody's. Refuses like Recording::open.
  static haptics::Expected<std::unique_ptr<Beginning>> read(const std::filesystem::path& path,
                                                            const std::atomic<bool>& cancel);
  Replay(Beginning beginning, std::filesystem::path path);

  haptics::Recording& recording() { return recording_; }
  const std::filesystem::path& path() const { return path_; }
  /// Length and events; the force's curve comes with trackRead().
  const ui::ReplayTrack& track() const { return track_; }
  /// The last step at or before the present time.
  const haptics::RecordedStep& step() const { return steps_[at_]; }
  /// The forces after `from` and until `to` [s], one point per tick, at most the newest ten
  /// seconds.
  std::vector<haptics::ForceSample> forces(double from, double to);

  void play(bool play);
  void setSpeed(double factor);
  /// Goes to a time of the recording [s].
  void seek(double time);
  /// Goes forward by `ticks`, or back if negative.
  void stepBy(int ticks);

 signals:
  /// The present step has changed. `time` [s] is its time or, while playing, a little later.
  void moved(double time);
  void playing(bool plays);
  void trackRead();
  /// A part of the file cannot be read; playing stops. `why`: a sentence.
  void failed(const QString& why);

 private:
  bool load(std::size_t block);
  void advance();

  haptics::Recording recording_;
  std::filesystem::path path_;
  ui::ReplayTrack track_;
  std::size_t block_ = 0;
  std::vector<haptics::RecordedStep> steps_;  ///< steps of that block
  std::size_t at_ = 0;                        ///< index of the present step in steps_
  double time_ = 0.0, speed_ = 1.0;
  QTimer timer_;
  QElapsedTimer since_;
  background::Task<ForceCurve> reader_;
};

}  // namespace app
