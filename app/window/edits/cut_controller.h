// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <QString>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "app/background/task.h"
#include "app/recording/carved_copy.h"
#include "app/window/scan/shared_state.h"
#include "app/window/sound/burr_sound.h"
#include "datasets/edits/edit.h"
#include "haptics/proxy/cutting.h"
#include "ui/panels/cut_panel.h"
#include "ui/window/main_window.h"

namespace resources {
struct NamedTool;
}

namespace app {

/// Lets a burr cut the scan: the panel "Cut". A haptics::Cutting is made in the background for each
/// scene whose tool has a burr, and handed to the session. Each cut that the servo thread begins is
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
  /// Whether the burr rests, whatever is held: the stroke under way ends, and becomes an edit.
  /// Afterwards key or button must be released before it turns again.
  void rest(bool on);
  /// Whether something was cut that is in no stroke yet.
  bool hasCut();
  /// The same as far as refresh() knows, or whether the burr turns.
  bool isCutting() const { return shared_.snapshot.cuts || !stroke_.empty(); }
  /// During a replay nothing is cut.
  void setReplaying(bool replaying);
  /// Calls `then` when nothing was cut in the scene, if need be in a new one: a recording knows a
  /// scene as it is when it is described.
  void whenUncut(std::function<void()> then);
  /// No new scene comes: what waits for one is forgotten.
  void forgetWaiting() { waiting_ = {}; }

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
    CarvedCopy live;
  };

  /// The tool's burr, where the scene may be cut with it; null: none.
  const resources::NamedTool* burr() const;
  haptics::CutLaw lawOf(const resources::NamedTool& burr) const;
  void prepare();
  void deliver(std::uint64_t scene, haptics::Expected<Made> made);
  /// Has the burr rest until goOn(), and takes what it has cut. Returns whether that is all: of a
  /// loop that stands it is not known.
  bool stop();
  void goOn() { shared_.session.restCut(asks_); }
  void takeCuts();
  void endStroke();
  void changeLaw();
  void showState();
  void showTissues();
  void showRemoved();
  void callWaiting();
  void tellSound();

  ui::MainWindow& window_;
  SharedState& shared_;
  ui::CutPanel* panel_;
  background::Task<Made> maker_;
  std::uint64_t scene_ = 0;             ///< that is cut, or is prepared for it; 0: none
  QString law_;                         ///< of what cuts; empty: nothing does
  std::optional<CarvedCopy> live_;      ///< for the eye; none: not yet, or nothing cuts
  bool cut_ = false;                    ///< something was cut in the scene
  std::vector<haptics::VoxelBox> way_;  ///< hold all that was cut in it
  bool key_ = false;                    ///< of the burr is held
  bool asks_ = false;                   ///< rest()
  bool replaying_ = false;
  std::vector<haptics::BurrCut> stroke_;  ///< under way
  haptics::Removed removed_;              ///< by it
  ui::CutTold told_;                      ///< of the strokes in force
  std::function<void()> waiting_;         ///< of whenUncut()
  BurrSound sound_;
  std::uint64_t heard_ = 0;  ///< tick that was told to the sound last
};

}  // namespace app
