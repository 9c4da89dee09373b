// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QAction>
#include <QElapsedTimer>
#include <QObject>
#include <deque>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "app/background/task.h"
#include "app/window/shared_state.h"
#include "haptics/edit/edit_history.h"
#include "ui/main_window.h"
#include "ui/overlays/clip_plane.h"
#include "ui/overlays/crop_box.h"
#include "ui/overlays/lasso.h"
#include "ui/overlays/removal_shade.h"
#include "ui/panels/edit_panel.h"

namespace app {

/// Takes parts of the scan away: the panel "Edit", its menu, and what it draws over the views.
///
/// Each edit runs on another thread, one at a time, in the order in which they were wanted. The
/// touch goes on with the old volume, and edited() hands over the new one. What may put material
/// back (undo, redo, reset, a wider crop) waits until the tool is out of contact.
class EditController : public QObject {
  Q_OBJECT
 public:
  EditController(ui::MainWindow& window, SharedState& shared);

  /// Call it when another scene is on view.
  void showScene();
  /// Call it at display rate, with a snapshot that is as new as can be.
  void refresh();
  /// During a replay nothing can be edited.
  void setReplaying(bool replaying);

  /// Puts away what an edit would take. Call it when the isovalue changed, too.
  void endPreview();

  /// The edits of the volume on view, oldest first.
  std::vector<haptics::Edit> edits() const;
  /// Applies these edits to the present scan, instead of its edits. They cannot be undone beyond
  /// the first of them. On an error the present ones stay.
  void restore(std::vector<haptics::Edit> edits);
  /// Whether an edit is under way or waits, or its picture is not there yet.
  bool isBusy() const {
    return running_.has_value() || held_.has_value() || !queue_.empty() || painter_.isRunning();
  }

 signals:
  /// A new volume and scene of the same scan. The receiver puts it into `shared.shown`. Its picture
  /// is still that from before.
  void edited(const app::Loaded& loaded);
  /// The picture of the newest volume.
  void pictured(const ui::Picture& picture);
  /// What was done, for a recording: the edit as text, or "undo", "redo", "reset", "restore".
  void noted(const QString& text);

 private:
  enum class Step { Apply, Undo, Redo, Reset, Restore };
  struct Job {
    Step step = Step::Apply;
    std::vector<haptics::Edit> edits = {};
  };
  /// A job's result, ready for the touch.
  struct Made {
    std::shared_ptr<haptics::EditHistory> history;
    std::shared_ptr<const haptics::Scene> scene;
    std::shared_ptr<const haptics::Scene> base;  ///< whose tool and options it has
    haptics::Pose start = haptics::Pose::Identity();
  };
  struct Preview {
    double volume = 0.0;  ///< m^3
    std::shared_ptr<const ui::MarkedVoxels> voxels;
  };
  using Watch = background::Watch;

  void buildMenu();
  void connectPanel();
  void connectOverlays();
  void addTool(const QString& text, ui::EditTool tool);

  void want(Job job);
  void startNext();
  void start(const Job& job);
  void deliver(haptics::Expected<Made> made);
  void adopt();
  void paint();
  void cancelWait();
  /// Takes a step of the history back that is not on view.
  static void rollBack(haptics::EditHistory& history, Step step);
  bool raises(const Job& job) const;
  bool touches() const;
  bool isClear() const;
  void showWait(Step step);
  void endWait();
  void showSteps();
  static haptics::Expected<Made> worked(std::shared_ptr<haptics::EditHistory> history,
                                        const Job& job, const Loaded& shown,
                                        haptics::SceneOptions options, double isovalue,
                                        const Watch& watch);
  static haptics::Expected<void> built(Made& made, const Loaded& shown,
                                       haptics::SceneOptions options, double isovalue,
                                       const Watch& watch);

  void changeTool(ui::EditTool tool);
  void endTool();
  void apply(haptics::Edit edit);
  void showCrop();
  void moveCropFace(int axis, bool high, double mm);
  void cropToView();
  void applyCrop();
  void showPlane();
  void placePlane(ui::Plane plane);
  void turnPlane(double position_mm, double towards_deg, double raised_deg);
  void cutPlane();
  void cutOutline(const ui::DrawnOutline& outline);
  void preview(haptics::Edit edit, ui::EditConfirm confirm, const QString& words);
  void confirmPiece(bool keep);
  void save(const QString& path);

  ui::MainWindow& window_;
  SharedState& shared_;
  ui::EditPanel* panel_;
  ui::CropBox crop_;
  ui::ClipPlane plane_;
  ui::Lasso lasso_;
  ui::PlacePick pick_;
  ui::RemovalShade shade_;
  QAction *undo_ = nullptr, *redo_ = nullptr, *reset_ = nullptr;
  bool replaying_ = false;

  std::shared_ptr<const haptics::Volume> scan_;    ///< of the volume on view
  std::shared_ptr<haptics::EditHistory> history_;  ///< of scan_; null: no edit yet
  haptics::VoxelBox crop_shown_{};                 ///< bounds that the box on view began with
  std::deque<Job> queue_;
  std::optional<Job> running_;
  std::optional<Made> held_;  ///< done, and waits until the tool is out of contact
  QString wait_shown_;        ///< empty: nothing waits
  QElapsedTimer untouched_;   ///< since the tool was last in contact
  std::optional<haptics::Edit> previewed_;
  background::Task<Made> task_;
  background::Task<ui::Picture> painter_;  ///< of the volume that is touched
  background::Task<Preview> previewer_;
  background::Task<QString> saver_;  ///< the name of the written file
};

}  // namespace app
