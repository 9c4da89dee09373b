// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "app/background/task.h"
#include "app/window/scan/shared_state.h"
#include "datasets/edits/edit_history.h"
#include "ui/window/loading.h"
#include "ui/window/messages.h"

namespace app {

/// Edits of the scan on view, carried out on another thread, one at a time, in the order in which
/// they were wanted.
///
/// The touch goes on with the old volume, and edited() hands over the new one. What may put
/// material back (undo, redo, reset, a wider crop) waits until the tool is out of contact.
class EditQueue : public QObject {
  Q_OBJECT
 public:
  enum class Step {
    Apply,
    Undo,
    Redo,
    Reset,
    Restore,
    Renew  ///< the present volume as a new scene
  };
  struct Job {
    Step step = Step::Apply;
    std::vector<datasets::Edit> edits = {};
    std::uint64_t felt_in = 0;  ///< of a stroke: id of the scene that has its cuts; 0: none has
    bool puts_back = false;     ///< of Renew: the touch has what the volume has not
  };

  EditQueue(ui::Messages& messages, ui::Loading& loading, SharedState& shared);

  /// Says whether a burr cuts, or has cut what is in no job yet. Before anything is wanted.
  void setCutting(std::function<bool()> cuts) { cuts_ = std::move(cuts); }
  /// Another scan is on view: what was meant for the one before is dropped.
  void begin(std::shared_ptr<const haptics::Volume> scan);
  void want(Job job);
  /// Call it at display rate, with a snapshot that is as new as can be.
  void refresh();
  /// Whether a job waits for the tool.
  bool isWaiting() const { return held_.has_value() || (!running_ && !queue_.empty()); }
  /// Drops the job that waits for the tool, but for a stroke: what is cut is cut.
  void cancelWait();
  /// The same, and ends the one that is under way.
  void cancel();

  /// Whether an edit is under way or waits, or its picture is not there yet.
  bool isBusy() const {
    return running_.has_value() || held_.has_value() || !queue_.empty() || painter_.isRunning();
  }
  /// Whether a stroke of a burr is not in `shared.shown` yet.
  bool hasStrokes() const;
  /// Whether jobs wait for their turn.
  bool hasMore() const { return !queue_.empty(); }
  /// The history of the scan; null: there was no edit yet, or the thread of a job has it.
  const datasets::EditHistory* historyAtRest() const { return running_ ? nullptr : history_.get(); }

 signals:
  /// A new volume and scene of the same scan. The receiver puts it into `shared.shown`. Its picture
  /// is still that from before.
  void edited(const app::Loaded& loaded);
  /// The same scene with a stroke that it has already. The receiver puts it into `shared.shown`.
  void renewed(const app::Loaded& loaded);
  /// The picture of the newest volume. `seen`: its voxels are on view already.
  void pictured(const ui::Picture& picture, bool seen);
  /// What was done: the edit as text (of long ones their kind), or "undo", "redo", …
  void noted(const QString& text);
  /// What waits for the tool, as a sentence; empty: nothing does.
  void waitChanged(const QString& words);
  /// A job ended without a new volume; the window has said why.
  void failed();

 private:
  /// A job's result, ready for the touch.
  struct Made {
    std::shared_ptr<datasets::EditHistory> history;
    std::shared_ptr<const haptics::Scene> scene;
    std::shared_ptr<const haptics::Scene> base;  ///< whose tool and options it has
    haptics::Pose start = haptics::Pose::Identity();
  };
  using Watch = background::Watch;

  void startNext();
  void start(const Job& job);
  void deliver(haptics::Expected<Made> made);
  void adopt();
  void paint(bool seen);
  /// The options of the scene that a job ends with.
  haptics::SceneOptions optionsOf(const Job& job) const;
  /// Takes a step of the history back that is not on view.
  static void rollBack(datasets::EditHistory& history, Step step);
  bool raises(const Job& job) const;
  /// Whether the touch already is what comes of the job.
  bool isFelt(const Job& job) const { return job.felt_in == shared_.shown->scene->id; }
  /// Whether what comes of the job may put back what is cut in the touch.
  bool putsBack(const Job& job) const;
  /// Whether the touch must not stay what it is, or its cuts must become an edit.
  static bool isOwed(const Job& job) { return job.puts_back || job.felt_in != 0; }
  bool touches() const;
  bool isClear() const;
  void showWait(Step step);
  void endWait();
  static haptics::Expected<Made> worked(std::shared_ptr<datasets::EditHistory> history,
                                        const Job& job, const Loaded& shown,
                                        haptics::SceneOptions options, double isovalue,
                                        const Watch& watch);
  static haptics::Expected<void> built(Made& made, const Loaded& shown,
                                       haptics::SceneOptions options, double isovalue,
                                       const Watch& watch);

  ui::Messages& messages_;
  ui::Loading& loading_;
  SharedState& shared_;
  std::function<bool()> cuts_;
  std::shared_ptr<const haptics::Volume> scan_;     ///< of the volume on view
  std::shared_ptr<datasets::EditHistory> history_;  ///< of scan_; null: no edit yet
  std::deque<Job> queue_;
  std::optional<Job> running_;
  std::optional<Made> held_;  ///< done, and waits until the tool is out of contact
  QString wait_shown_;        ///< empty: nothing waits
  QElapsedTimer untouched_;   ///< since the tool was last in contact
  background::Task<Made> task_;
  background::Task<ui::Picture> painter_;  ///< of the volume that is touched
  bool painting_seen_ = false;             ///< that picture shows what is on view
};

}  // namespace app
