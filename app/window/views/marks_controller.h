// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QPointer>
#include <QWidget>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "app/window/scan/shared_state.h"
#include "app/window/scan/tool_way.h"
#include "ui/overlays/measures.h"
#include "ui/window/escape_filter.h"
#include "ui/window/menus.h"
#include "ui/window/side_panel.h"
#include "ui/window/top_bar.h"
#include "ui/window/views.h"

class QMenu;

namespace ui {
class MarksPanel;
}

namespace app {

/// Panel "Marks": measures, marks and notes of the scan on view, and the way of the tool. The marks
/// of a scan come back when the same place is opened again while the program runs.
class MarksController : public QObject {
  Q_OBJECT
 public:
  MarksController(ui::Views& views, ui::Menus& menus, ui::SidePanel& panels, ui::TopBar& bar,
                  ui::EscapeFilter& escape, SharedState& shared);

  ui::Measures& measures() { return measures_; }
  /// Call it when a scene is on view.
  void showScene();
  /// These marks of the scan on view are in a file.
  void setSaved(std::vector<ui::Measure> marks);
  /// Whether the scan on view has marks that are in no file.
  bool areUnsaved() const;
  /// How many scans that were on view before have such marks.
  int scansUnsaved() const;
  /// Call it sixty times a second. It shows the way of the tool at most ten times a second, and
  /// nothing while the tool rests.
  void refresh();

 private:
  /// A scan, and the marks that it had when it went from view.
  struct Marked {
    std::filesystem::path place;
    QString title;
    haptics::Volume facts;  ///< of the scan, without voxels
    std::weak_ptr<const haptics::Volume> scan;
    std::vector<ui::Measure> measures = {};
    std::vector<ui::Measure> saved = {};  ///< as they are in a file
  };

  void connectPanel();
  void buildMenu(QMenu& menu);
  void showList();
  void goTo(int index);
  void measureWay(bool measure);
  void showWay();

  ui::Views& views_;
  ui::SidePanel& panels_;
  SharedState& shared_;
  ui::Measures measures_;
  ui::MarksPanel* panel_;
  QPointer<QWidget> noted_in_;    ///< the view of a note whose words are typed
  std::optional<Marked> marked_;  ///< what the marks belong to
  std::vector<Marked> kept_;
  std::pair<int, std::size_t> gone_to_{-1, 0};  ///< measure and place under the crosshair
  std::optional<ToolWay> way_;
  std::uint64_t way_scene_ = 0, way_tick_ = 0;  ///< of the last snapshot that was added
  haptics::Vec3 way_shown_ = haptics::Vec3::Zero();
  double length_shown_ = -1.0;
  QElapsedTimer since_shown_;
};

}  // namespace app
