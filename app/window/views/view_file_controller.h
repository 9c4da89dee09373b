// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <QString>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/background/task.h"
#include "app/view_file/view_file.h"
#include "app/window/scan/shared_state.h"
#include "app/window/views/marks_controller.h"
#include "ui/window/loading.h"
#include "ui/window/menus.h"
#include "ui/window/messages.h"
#include "ui/window/views.h"

namespace app {

/// What goes: the window with all that it knows; the scan on view, whose marks come back when it is
/// opened again; or its edits alone.
enum class Leaving { Window, Scan, Edits };

/// Saves views and opens them again (view_file/). The hash of the scan is made in the background;
/// saving and opening wait for it, and the user can cancel.
///
/// A view is opened over the same scan only. On the installation that saved it the keyed hash
/// decides; on another one, or without a hash, the geometry must agree and the user is asked, or,
/// without `asks`, it is refused.
class ViewFileController : public QObject {
  Q_OBJECT
 public:
  ViewFileController(ui::Views& views, ui::Messages& messages, ui::Loading& loading,
                     ui::Menus& menus, SharedState& shared, MarksController& marks, bool asks);

  /// Where scans and files of tools are that were open before. Any function may be missing.
  struct Known {
    /// The place of the scan with this hash; empty: not known.
    std::function<std::filesystem::path(const VolumeHash& hash)> place = {};
    std::function<std::vector<std::filesystem::path>()> tools = {};
  };
  void setKnown(Known known) { known_ = std::move(known); }

  /// What a burr cuts: an edit that is not on view yet.
  struct Strokes {
    /// Ends the stroke under way, and lets no other begin; whether there is one, or one before that
    /// is no edit yet.
    std::function<bool()> end = [] { return false; };
    /// Others may begin again.
    std::function<void()> allow = [] {};
    /// Calls this when all are edits, at once or later.
    std::function<void(std::function<void()> then)> whenEdits = [](const auto& then) { then(); };
  };
  void setStrokes(Strokes strokes) { strokes_ = std::move(strokes); }

  /// Opens a file of a view. If the scan on view is not the one, the scan is opened first: from the
  /// place that the file tells, or from that where it was open before. If it is not found, the
  /// user can choose it.
  void open(const std::filesystem::path& path);
  /// Goes on with work on the scan on view that is in no file.
  void resume(ViewFile work);
  /// The view as it is now, without the hash and the place of its scan. A scan must be on view.
  ViewFile present() const;
  /// Saves to the file that the view of this scan was saved to or opened from; if there is none,
  /// asks for one. Returns false if the user does not choose one.
  bool saveOrAsk();
  bool askAndSave();
  enum class Leave { Now, Stay, AfterSaving };
  /// Asks about what is in no file and would be lost, if there is something; a stroke under way
  /// ends, and none begins until that is settled. If the user saves it first, `then` is called when
  /// that is done, with whether it was.
  Leave leave(Leaving what, std::function<void(bool saved)> then);
  Leave ask(Leaving what, bool strokes);
  /// Saves to this file; `with_place`: with the scan's place relative to it.
  void save(const std::filesystem::path& path, bool with_place);
  /// Call it when a scene is on view.
  void showScene(bool new_volume);
  /// Call it when a scan could not be opened.
  void drop();

 signals:
  /// The scan of a view that is being opened.
  void scanWanted(const std::filesystem::path& path, const haptics::Grid& grid);
  /// The edits of a view that is being opened, in place of the present ones. When the volume that
  /// results is on view, the rest of the view follows.
  void editsWanted(const std::vector<datasets::Edit>& edits);
  void toolWanted(const app::ToolSource& tool);
  /// Where the tool was.
  void poseWanted(const haptics::Pose& X_WP);
  /// An isovalue that the volume on view can have.
  void isovalueWanted(double isovalue);
  /// Why a view was not opened, as it is shown.
  void refused(const QString& sentence);
  /// The view of the scan on view is in a file.
  void saved();
  /// A view was opened whole, was saved, or could not be.
  void finished(bool done);

 private:
  enum class Step { Nothing, Scan, Hash, Edits };

  bool liesOnView() const;
  void compare();
  bool seekScan();
  bool openScan(const std::filesystem::path& scan);
  /// Lets the user choose the scan, in place of what `sentence` says.
  void offerChoice(const QString& sentence);
  void chooseScan(bool folder);
  QString openingName() const;
  void begin(ViewFile view, const std::filesystem::path& path);
  void restoreTool();
  void placeTool();
  /// Whether the volume on view has the edits of the view that is being opened.
  bool hasEdits() const;
  void restore();
  void restoreRest();
  void refuse(const QString& sentence);
  void refuseGeometry();
  void takeHash(const std::shared_ptr<const haptics::Volume>& scan);
  void write();
  void endSaving(bool saved);
  std::vector<std::string> editsOnView() const;

  ui::Views& views_;
  ui::Messages& messages_;
  ui::Loading& loading_;
  SharedState& shared_;
  MarksController& marks_;
  bool asks_;
  Step step_ = Step::Nothing;  ///< what the view that is being opened waits for
  ViewFile opening_;
  std::filesystem::path opening_path_;  ///< empty: work that is in no file
  bool place_tried_ = false;            ///< that the file tells
  bool known_tried_ = false;            ///< where the scan was open before
  bool placing_ = false;                ///< the tool goes to its place once it is there
  Known known_;
  Strokes strokes_;
  background::Task<std::filesystem::path> tool_seeker_;
  std::filesystem::path saved_as_;  ///< of the scan on view; empty: no file yet
  bool saved_with_place_ = false;
  std::optional<ViewFile> saving_;  ///< waits for its hash
  std::filesystem::path saving_path_;
  bool saving_with_place_ = false;
  std::shared_ptr<const haptics::Volume> saved_scan_;
  std::function<void(bool saved)> then_;    ///< waits for the file
  std::vector<std::string> edits_in_file_;  ///< of the scan on view, as texts
};

}  // namespace app
