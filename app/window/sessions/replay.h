// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <atomic>
#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "app/background/task.h"
#include "app/recording/recording.h"
#include "app/window/sessions/force_curve.h"
#include "haptics/snapshot.h"
#include "ui/panels/force_plot.h"
#include "ui/panels/replay_timeline.h"

namespace app {

/// An open recording with a present step. The steps around it are read in the background: the file
/// may be large, and anybody's. GUI thread.
class Replay : public QObject {
  Q_OBJECT
 public:
  /// A block that was read.
  struct Part {
    std::vector<RecordedStep> steps;  ///< empty: only the plot of the force needs it
    std::vector<haptics::ForceSample> forces;
  };
  using Parts = std::map<std::size_t, haptics::Expected<Part>>;  ///< by the block's number
  /// A recording with its first block, which could be read.
  struct Beginning {
    Recording recording;
    Parts parts;
  };
  /// Not on the GUI thread. Refuses like Recording::open.
  static haptics::Expected<std::unique_ptr<Beginning>> read(const std::filesystem::path& path,
                                                            const std::atomic<bool>& cancel);
  Replay(Beginning beginning, std::filesystem::path path);

  const Recording& recording() const { return recording_; }
  const std::filesystem::path& path() const { return path_; }
  /// Length and events; the force's curve comes with trackRead().
  const ui::ReplayTrack& track() const { return track_; }
  /// The last step at or before the present time.
  const RecordedStep& step() const;
  /// The forces after `from` and until `to` [s], one point per tick, at most the newest ten
  /// seconds before the present time.
  std::vector<haptics::ForceSample> forces(double from, double to) const;

  void play(bool play);
  void setSpeed(double factor);
  /// Goes to a time of the recording [s], as soon as its steps have been read.
  void seek(double time);
  /// Goes forward by `ticks`, or back if negative, as soon as the step has been read.
  void stepBy(int ticks);

 signals:
  /// The present step has changed. `time` [s] is its time or, while playing, a little later.
  void moved(double time);
  void playing(bool plays);
  void trackRead();
  /// A part of the file cannot be read; playing stops. `why`: a sentence.
  void failed(const QString& why);

 private:
  struct Place {
    std::size_t block = 0, step = 0;  ///< the step's index in its block
  };
  /// A range of blocks to be read, both ends included; before `steps_from` for their forces only.
  struct Range {
    std::size_t first = 0, steps_from = 0, last = 0;
  };
  /// Where to go: to a step, or to a time.
  struct Wish {
    std::size_t block = 0;
    std::optional<std::size_t> step;
    double time = 0.0;  ///< s; without a step
  };
  void goTo(Wish wish);
  /// Goes to the wish if its block has been read.
  void arrive();
  Range wanted() const;
  bool isRead(std::size_t block, const Range& range) const;
  /// Reads what is wanted and has not been read.
  void readAround();
  void keep(Parts parts);
  void advance();

  Recording recording_;  ///< its blocks are read by block_reader_'s thread alone
  std::filesystem::path path_;
  ui::ReplayTrack track_;
  Parts parts_;
  Place present_;  ///< its steps are kept
  std::optional<Wish> wish_;
  Range reading_;  ///< what block_reader_ reads
  double time_ = 0.0, speed_ = 1.0;
  QTimer timer_;
  QElapsedTimer since_;
  background::Task<Parts> block_reader_;
  background::Task<ForceCurve> curve_reader_;
};

}  // namespace app
