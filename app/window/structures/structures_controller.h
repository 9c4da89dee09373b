// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <QStringList>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "app/background/task.h"
#include "app/window/scan/shared_state.h"
#include "datasets/labels/label_file.h"
#include "datasets/labels/label_map.h"
#include "haptics/scene/watch.h"
#include "haptics/structures/distance_map.h"
#include "ui/panels/nearness_lines.h"
#include "ui/props/structure_shape.h"
#include "ui/window/loading.h"
#include "ui/window/menus.h"
#include "ui/window/messages.h"
#include "ui/window/side_panel.h"
#include "ui/window/views.h"

namespace ui {
class StructuresPanel;
}

namespace app {

/// The phantom with which structures are tried.
inline constexpr const char* kPhantomOfStructures = "mastoid";

/// Panel "Structures": which structures lie in the scan on view, read from a file beside it, and
/// how they are seen. They go with their scan. Their names go to the screen alone.
class StructuresController : public QObject {
  Q_OBJECT
 public:
  StructuresController(ui::Views& views, ui::Messages& messages, ui::Loading& loading,
                       ui::Menus& menus, ui::SidePanel& panels, SharedState& shared);

  /// Reads the structures of the scan on view, in the background. What was there before stays until
  /// they are known, and if the file is refused.
  void open(const std::filesystem::path& path);
  /// Opens the structures of this phantom once it is on view: the next scene.
  void awaitPhantom(std::string phantom) { awaited_ = std::move(phantom); }
  /// What was dropped on the window: structures of the scan on view are opened; for all else,
  /// scanWanted() comes, at once or after a look at the file.
  void sort(const QStringList& paths);
  /// Call it when a scene is on view.
  void showScene();
  /// Call it when `shared.snapshot` is due in words.
  void showNear(const haptics::Snapshot& snapshot);
  const ui::Structures& shown() const { return shown_; }

 signals:
  /// What the session watches now, and how it is felt; null: nothing.
  void watchGiven(const std::shared_ptr<const haptics::Watch>& watch);
  void scanWanted(const QStringList& paths);
  /// Structures are on view, in 3-D too.
  void opened();
  /// How near the tool is to the structures that are watched; none: none is.
  void nearChanged(const std::vector<ui::StructureNear>& near, const ui::NearLimits& limits);
  /// A file was refused, and why, for the user.
  void refused(const QString& sentence);

 private:
  /// What is read and made of a file.
  struct Read {
    std::vector<datasets::Structure> structures;
    std::shared_ptr<const ui::StructureMap> map;
    std::vector<haptics::VoxelBox> boxes;
    std::shared_ptr<const datasets::LabelMap> labels;
  };

  void connectPanel();
  /// Reads structures by `reading`, in the background. `answer`: whether an error was asked about.
  void read(std::function<haptics::Expected<datasets::LabelMap>(const background::Watch&)> reading,
            std::function<bool(const haptics::Error&)> answer = {});
  void read(const std::filesystem::path& path, const datasets::LabelReading& reading);
  /// Asks for what the file does not say, or says otherwise than the scan, and reads it again.
  /// False: the error is none of these.
  bool ask(const std::filesystem::path& path, datasets::LabelReading reading,
           const haptics::Error& error);
  void take(Read read);
  void close();
  void makeShapes(std::vector<haptics::VoxelBox> boxes);
  void goTo(int number);
  void watch(int number, bool watched);
  /// Makes the distances of the next structure that is watched and has none yet.
  void makeDistances();
  /// Gives the session what is watched and known.
  void giveWatch();
  /// Changes how a structure is seen, and shows it.
  template <class Change>
  void change(int number, Change&& change);
  void show();

  ui::Views& views_;
  ui::Messages& messages_;
  ui::Loading& loading_;
  ui::SidePanel& panels_;
  SharedState& shared_;
  ui::StructuresPanel* panel_;
  std::weak_ptr<const haptics::Volume> scan_;  ///< on view
  std::string awaited_;                        ///< phantom whose structures are wanted; empty: none
  bool ours_ = false;                          ///< what is read is a phantom's, whose names we know
  ui::Structures shown_;
  std::vector<std::vector<Eigen::Vector3d>>
      places_mm_;  ///< of each structure; empty: not yet known
  background::Task<Read> reader_;
  background::Task<bool> maker_;                      ///< of shapes
  std::shared_ptr<const datasets::LabelMap> labels_;  ///< null: none
  std::map<int, haptics::DistanceMap> distances_;     ///< of structures that were watched
  background::Task<haptics::DistanceMap> measurer_;   ///< of distances
  ui::NearLimits limits_;
  background::Task<ui::OpenedAs> sorter_;
};

}  // namespace app
