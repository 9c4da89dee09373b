// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QAction>
#include <QObject>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "app/background/task.h"
#include "app/window/edits/edit_queue.h"
#include "app/window/scan/shared_state.h"
#include "datasets/edits/edit_history.h"
#include "ui/overlays/clip_plane.h"
#include "ui/overlays/crop_box.h"
#include "ui/overlays/lasso.h"
#include "ui/overlays/removal_shade.h"
#include "ui/panels/edit_panel.h"
#include "ui/window/banner.h"
#include "ui/window/loading.h"
#include "ui/window/main_window.h"
#include "ui/window/menus.h"
#include "ui/window/messages.h"
#include "ui/window/side_panel.h"
#include "ui/window/top_bar.h"
#include "ui/window/views.h"

class QPushButton;

namespace app {

/// Takes parts of the scan away: the panel "Edit", its menu, and what it draws over the views. The
/// edits are carried out by EditQueue.
class EditController : public QObject {
  Q_OBJECT
 public:
  EditController(ui::MainWindow& window, SharedState& shared);

  /// Says whether a burr cuts, or has cut what is in no stroke yet. Before anything is edited.
  void setCutting(std::function<bool()> cuts) { jobs_.setCutting(std::move(cuts)); }
  /// Call it when another scene is on view.
  void showScene();
  /// Call it at display rate, with a snapshot that is as new as can be.
  void refresh() { jobs_.refresh(); }
  /// Whether a real device holds the tool: only the hand at it lifts it.
  void setDeviceHeld(bool held) { device_held_ = held; }
  /// During a replay nothing can be edited.
  void setReplaying(bool replaying);

  /// Puts away what an edit would take. Call it when the isovalue changed, too.
  void endPreview();

  /// The edits of the volume on view, oldest first.
  std::vector<datasets::Edit> edits() const;
  /// Applies these edits to the present scan, instead of its edits. They cannot be undone beyond
  /// the first of them. On an error the present ones stay.
  void restore(std::vector<datasets::Edit> edits);
  /// A stroke that was made in the scene with this id, and is felt already where that is the
  /// present one.
  void addStroke(const datasets::Stroke& stroke, std::uint64_t scene);
  /// Whether one of them is not on view yet.
  bool hasStrokes() const { return jobs_.hasStrokes(); }
  /// What it takes to cut structures.
  void setTissues(const datasets::TissueTable& table) {
    if (replaying_) return emit failed();
    want({EditQueue::Step::Apply, {table}});
  }
  /// Takes the last edit back, or makes it again.
  void undo() { want({EditQueue::Step::Undo}); }
  void redo() { want({EditQueue::Step::Redo}); }
  /// Makes a new scene of the present volume.
  void renew() { want({EditQueue::Step::Renew}); }
  /// Whether an edit is under way or waits, or its picture is not there yet.
  bool isBusy() const { return jobs_.isBusy(); }
  /// Whether an edited volume is being written.
  bool isSaving() const { return saver_.isRunning(); }
  void stopSaving() { saver_.cancel(); }

 signals:
  /// A new volume and scene of the same scan. The receiver puts it into `shared.shown`. Its picture
  /// is still that from before.
  void edited(const app::Loaded& loaded);
  /// The same scene with a stroke that it has already. The receiver puts it into `shared.shown`.
  void renewed(const app::Loaded& loaded);
  /// The picture of the newest volume. `seen`: its voxels are on view already.
  void pictured(const ui::Picture& picture, bool seen);
  /// An edit, or a new scene, could not be made; the window has said why.
  void failed();
  /// Whether there is something to take back, or to make again.
  void stepsChanged(bool undo, bool redo);
  /// An edited volume was written, or not. `what`: why not, for the user; empty: cancelled.
  void saved(bool well, const QString& what);
  /// What was done, for a recording: the edit as text (of long ones their kind), or "undo", "redo",
  /// …
  void noted(const QString& text);
  /// The tool shall leave the surface, since an edit waits for it.
  void liftWanted();

 private:
  struct Preview {
    double volume = 0.0;  ///< m^3
    std::shared_ptr<const ui::MarkedVoxels> voxels;
  };

  static haptics::Expected<Preview> previewOf(const datasets::Edit& edit,
                                              const haptics::Volume& volume, double isovalue,
                                              const background::Watch& watch);
  void buildMenu();
  void connectJobs();
  void connectPanel();
  void connectOverlays();
  void addTool(const QString& text, ui::EditTool tool);

  void want(EditQueue::Job job);
  void showSteps();
  void changeTool(ui::EditTool tool);
  /// Returns whether a tool was on, or something was waited for.
  bool endTool();
  void apply(datasets::Edit edit);
  void showCrop();
  void moveCropFace(int axis, bool high, double mm);
  void cropToView();
  void applyCrop();
  void showPlane();
  void placePlane(ui::Plane plane);
  void turnPlane(double position_mm, double towards_deg, double raised_deg);
  void cutPlane();
  void showCut();
  void preview(datasets::Edit edit, ui::EditConfirm confirm, const QString& words);
  void confirmPiece(bool keep);
  void offerHolder();
  void offerLift();
  void showWait(const QString& words);
  void lookForHolder();
  void save(const QString& path);

  ui::MainWindow& window_;
  ui::Views& views_;
  ui::Messages& messages_;
  ui::Loading& loading_;
  ui::Menus& menus_;
  ui::SidePanel& panels_;
  ui::TopBar& bar_;
  SharedState& shared_;
  ui::EditPanel* panel_;
  ui::CropBox crop_;
  ui::ClipPlane plane_;
  ui::Lasso lasso_;
  ui::PlacePick pick_;
  ui::RemovalShade shade_;
  QAction *undo_ = nullptr, *redo_ = nullptr, *reset_ = nullptr;
  std::vector<QAction*> tools_;
  bool replaying_ = false;

  std::shared_ptr<const haptics::Volume> scan_;  ///< of the volume on view
  std::optional<datasets::Edit> previewed_;
  std::shared_ptr<const ui::MarkedVoxels> marked_;  ///< of it
  std::optional<ui::DrawnOutline> drawn_;           ///< of the cut that is previewed
  EditQueue jobs_;
  background::Task<Preview> previewer_;
  ui::Banner* waits_;  ///< says that an edit waits for the tool
  QPushButton* lift_ = nullptr;
  bool device_held_ = false;
  ui::Banner* found_;  ///< offers to remove table and holder of a scan that has come
  background::Task<Preview> looker_;
  /// Table and holder that found_ tells of.
  struct Found {
    datasets::Edit edit;
    Preview preview;
  };
  std::optional<Found> holder_;
  background::Task<QString> saver_;  ///< the name of the written file
};

}  // namespace app
