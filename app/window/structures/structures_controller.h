// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <QStringList>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/background/task.h"
#include "app/window/program/preferences_controller.h"
#include "app/window/scan/shared_state.h"
#include "app/window/structures/near_sound.h"
#include "datasets/edits/edit.h"
#include "datasets/labels/label_file.h"
#include "datasets/labels/label_map.h"
#include "haptics/scene/watch.h"
#include "haptics/structures/distance_map.h"
#include "ui/overlays/near_line.h"
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
namespace haptics {
struct Watch;
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
                       ui::Menus& menus, ui::SidePanel& panels, SharedState& shared,
                       PreferencesController& preferences, std::function<double()> free_memory);

  /// Reads the structures of the scan on view, in the background. What was there before stays until
  /// they are known, and if the file is refused.
  void open(const std::filesystem::path& path);
  /// The survey of the place of the scan that is opened next, or is on view.
  void know(const Surveyed& surveyed);
  /// The same as open(), of an entry of a survey.
  void openFound(const datasets::StructuresFound& found);
  /// Opens the structures of this phantom once it is on view: the next scene.
  void awaitPhantom(std::string phantom) { awaited_ = std::move(phantom); }
  /// What was opened by the menu, or dropped on the window: structures of the scan on view are
  /// opened; for all else, scanWanted() comes, at once or after a look at the file.
  void sort(const QStringList& paths);
  /// Call it when a scene is on view, or the same after an edit.
  void showScene();
  /// What the user chose of cutting structures becomes no edit.
  void forgetChoice();
  /// Call it at display rate: nothing is near once no hand holds the tool.
  void refresh();
  /// Call it when `shared.snapshot` is due in words.
  void showNear(const haptics::Snapshot& snapshot);
  const ui::Structures& shown() const { return shown_; }
  /// The structures on view; null: none.
  const std::shared_ptr<const datasets::LabelMap>& labels() const { return labels_; }
  /// The name of the solid structure at a place, or a voxel beside it; empty: none is there.
  QString solidAt(const Eigen::Vector3d& p_W_mm) const;
  /// Distances that are known, by number.
  const std::map<int, haptics::DistanceMap>& distances() const { return distances_; }
  const ui::NearLimits& limits() const { return limits_; }
  const ui::NearLine& nearLine() const { return near_line_; }
  /// How structures are felt now, as a recording stores it; empty: as the scan has them.
  const QString& felt() const { return felt_; }

 signals:
  /// The session watches these now, felt in their ways; null: none.
  void watchGiven(const std::shared_ptr<const haptics::Watch>& watch);
  void scanWanted(const QStringList& paths);
  /// Structures are on view, in 3-D too.
  void opened();
  /// The file of the structures on view; empty: they are closed, or of no file.
  void fileChanged(const std::filesystem::path& file);
  /// How near the tool is to the structures that are watched; none: none is.
  void nearChanged(const std::vector<ui::StructureNear>& near, const ui::NearLimits& limits);
  /// felt() is other from the next tick on.
  void feltChanged(const QString& felt);
  /// What it is to take to cut structures: an edit.
  void tissuesWanted(const datasets::TissueTable& table);
  /// A file was refused, and why, for the user.
  void refused(const QString& sentence);

 private:
  /// What is read and made of a file.
  struct Read {
    std::vector<datasets::Structure> structures;
    std::vector<haptics::Message> notes;
    std::shared_ptr<const ui::StructureMap> map;
    std::vector<haptics::VoxelBox> boxes;
    std::shared_ptr<const datasets::LabelMap> labels;
  };

  void connectPanel();
  /// Reads structures by `reading`, in the background. `answer`: whether an error was asked about.
  void read(std::function<haptics::Expected<datasets::LabelMap>(const background::Watch&)> reading,
            std::function<bool(const haptics::Error&)> answer = {});
  /// `kept`: lives until the file was read.
  void read(const std::filesystem::path& path, const datasets::LabelReading& reading,
            const std::shared_ptr<const void>& kept = {});
  /// Asks for what the file does not say, or says otherwise than the scan, and reads it again.
  /// False: the error is none of these.
  bool ask(const std::filesystem::path& path, datasets::LabelReading reading,
           const std::shared_ptr<const void>& kept, const haptics::Error& error);
  /// Refuses, in words for the user, what takes more memory than is free.
  bool mayTake(double bytes, const QString& what);
  void offerFound();
  void take(Read read);
  void close();
  void makeShapes(std::vector<haptics::VoxelBox> boxes);
  void goTo(int number);
  /// From the tool's tip to the nearest of the watched structures; none where it is inside or far.
  std::optional<ui::NearLine::Way> wayToNearest(const haptics::Snapshot& snapshot) const;
  void watch(int number, bool watched);
  void feel(int number, const ui::StructureFeel& feel);
  void chooseCutting(int number, const ui::StructureCutting& cutting);
  /// Shows what the edits of the scan on view say of cutting its structures.
  void showCutting();
  /// What it takes to cut them, or will; null: what the scan's values say.
  const datasets::TissueTable* tissues() const;
  /// Whether it is one of the structures at hand, as far as can be told.
  bool isListed(const datasets::TissueTable::Part& part) const;
  /// Whether one more may be watched; says so if not.
  bool mayWatch(int number);
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
  std::function<double()> free_memory_;
  ui::StructuresPanel* panel_;
  NearSound sound_;
  ui::NearLine near_line_;
  std::weak_ptr<const haptics::Volume> scan_;  ///< on view
  bool offered_ = false;                       ///< what was found with the scan on view
  std::filesystem::path found_at_;
  std::vector<datasets::StructuresFound> found_;
  std::string awaited_;         ///< phantom whose structures are wanted; empty: none
  std::filesystem::path file_;  ///< that is read; empty: a phantom's, whose names we know
  ui::Structures shown_;
  std::vector<bool> before_alone_;  ///< which were shown before one was shown alone; empty: none is
  std::vector<std::vector<Eigen::Vector3d>>
      places_mm_;  ///< of each structure; empty: not yet known
  background::Task<Read> reader_;
  background::Task<bool> maker_;                      ///< of shapes
  std::shared_ptr<const datasets::LabelMap> labels_;  ///< null: none
  std::map<int, haptics::DistanceMap> distances_;     ///< of structures that were watched
  background::Task<haptics::DistanceMap> measurer_;   ///< of distances
  std::shared_ptr<const haptics::Watch> watch_;       ///< the session's; null: nothing is watched
  QString felt_;
  bool near_shown_ = false;
  ui::NearLimits limits_;
  ui::StructureFeel feel_;  ///< with the numbers that were chosen last
  background::Task<datasets::TissueTable> tissue_maker_;
  std::optional<datasets::TissueTable> chosen_;  ///< by the user, and not in the volume yet
  background::Task<ui::OpenedAs> sorter_;
  QStringList sorted_;  ///< what the sorter is at; empty: nothing
};

}  // namespace app
