// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QString>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "app/background/task.h"
#include "app/window/scan/shared_state.h"
#include "datasets/edits/edit.h"
#include "haptics/proxy/cutting.h"
#include "ui/panels/cut_panel.h"
#include "ui/window/main_window.h"

namespace app {

/// Lets a burr cut the scan: the panel "Cut". What cuts is made in the background for each scene
/// whose tool has a burr, and handed to the session. Each cut that the servo thread begins is
/// carried out once more in voxels that the views show. When the key is let go, the cuts become a
/// stroke, which is an edit like any other.
class CutController : public QObject {
  Q_OBJECT
 public:
  CutController(ui::MainWindow& window, SharedState& shared);
  ~CutController() override;

  /// Call it when another scene is on view, or the same with its strokes. `edits`: those in force.
  void showScene(const std::vector<datasets::Edit>& edits);
  void setSteps(bool undo, bool redo) { panel_->setSteps(undo, redo); }
  /// Call it at display rate, with a snapshot that is as new as can be.
  void refresh();
  /// Shows the voxels that are cut: a picture has taken their place.
  void showLive();
  /// Says again how a burr cuts in the present scene, if one can.
  void tellLaw();
  /// During a replay nothing is cut.
  void setReplaying(bool replaying);
  /// Calls `then` when nothing was cut in the scene, if need be in a new one: a recording knows a
  /// scene as it is when it is described.
  void whenUncut(std::function<void()> then);

 signals:
  /// The user wants a tool, by its name.
  void toolWanted(const QString& name);
  /// A stroke has ended that was felt in the scene with this id.
  void strokeMade(const datasets::Stroke& stroke, quint64 scene);
  /// The present volume is wanted as a new scene.
  void freshWanted();
  void undoWanted();
  void redoWanted();
  /// A burr will cut so in the scene with this id.
  void lawChosen(const QString& words, double scene);

 private:
  struct Made {
    std::unique_ptr<haptics::Cutting> cutting;
    haptics::Volume live;          ///< voxels of the window's own, like those of the scene
    std::shared_ptr<void> voxels;  ///< of `live`
  };
  /// What is cut, for the eye.
  struct Live {
    std::shared_ptr<const haptics::Volume> uncut;  ///< as it was in the scene before the first cut
    haptics::Volume volume;
    std::shared_ptr<void> voxels;
  };

  std::optional<haptics::CutLaw> law() const;
  void prepare();
  void deliver(std::uint64_t scene, haptics::Expected<Made> made);
  void takeCuts();
  void endStroke();
  void changeLaw();
  void showState();
  void showRemoved();
  void callWaiting();

  ui::MainWindow& window_;
  SharedState& shared_;
  ui::CutPanel* panel_;
  background::Task<Made> maker_;
  std::uint64_t scene_ = 0;   ///< that is cut, or is prepared for it; 0: none
  QString law_;               ///< of what cuts; empty: nothing does
  std::optional<Live> live_;  ///< none: not yet, or nothing cuts
  bool cut_ = false;          ///< something was cut in the scene
  bool key_ = false;          ///< of the burr is down
  bool replaying_ = false;
  std::vector<haptics::BurrCut> stroke_;  ///< under way
  QElapsedTimer since_cut_;               ///< the last
  double removed_ = 0.0;                  ///< m3, by it
  bool lowered_ = false;                  ///< any voxel, by it
  std::vector<double> removed_by_;        ///< m3: strokes in force, and those that were taken back
  std::size_t strokes_ = 0;               ///< in force
  std::function<void()> waiting_;         ///< of whenUncut()
};

}  // namespace app
