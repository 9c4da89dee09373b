// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <QString>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "app/background/task.h"
#include "datasets/readers/volume_reader.h"
#include "haptics/core/error.h"
#include "haptics/scene/scene.h"
#include "ui/props/picture.h"

namespace app {

/// Which tool: one of ours, or a file.
struct ToolSource {
  std::string name = "probe";  ///< of a named tool
  std::optional<std::filesystem::path> file = {};
  std::string unit = "mm";  ///< of the file: m, mm, cm, in
};

/// What the user reads for a tool: its name, or its file's.
QString labelOf(const ToolSource& tool);

/// An entry of a survey, which need not be made again to load it.
struct ChosenSeries {
  datasets::SeriesVerdict series;
  bool among_others = false;         ///< the survey has more entries: the title says which this is
  std::filesystem::path place = {};  ///< as in Surveyed
};

/// A volume that stays on view, and where it comes from.
struct Kept {
  ui::Picture picture;
  QString title;
  std::filesystem::path place = {};  ///< as in Loaded
};

/// What to load. Of path, phantom and keep, the first that is set counts.
struct LoadRequest {
  std::optional<std::filesystem::path> path = {};
  std::optional<int> series = {};  ///< which entry of the path's survey
  /// The entry itself; none: the path is surveyed, and the only sound one taken, unless another is
  /// larger or could be corrected.
  std::optional<ChosenSeries> chosen = {};
  datasets::Geometry geometry = datasets::Geometry::AsStored;
  bool largest_part = false;  ///< as in datasets::Reading
  datasets::Part part = {};
  std::optional<std::string> phantom = {};
  std::optional<Kept> keep = {};        ///< the volume already shown, with another tool or field
  std::optional<ToolSource> tool = {};  ///< none: the one that fits a phantom, else `probe`
  std::optional<double> isovalue = {};
  haptics::SceneOptions options = {};
  /// The scene whose field is taken over where volume and kind are the same; or none.
  std::shared_ptr<const haptics::Scene> previous = {};
};

/// What was found at a path.
struct Surveyed {
  std::filesystem::path path;
  /// What to remember of it: the path itself if it is a folder, an archive or a volume, and the
  /// folder of a slice.
  std::filesystem::path place;
  datasets::Survey survey;
};

/// A volume and a tool, ready to be seen and touched.
struct Loaded {
  ui::Picture picture;
  std::shared_ptr<const haptics::Scene> scene;
  ToolSource tool;
  double isovalue = 0.0;
  haptics::Pose start = haptics::Pose::Identity();  ///< a legal pose in front of the surface, W
  QString title;
  QString note;  ///< a sentence worth saying although it was loaded, or empty
  /// Where it was read; empty: made by formula, so that it is nobody's.
  std::filesystem::path place = {};
};

/// Reasons of Loader::failed that ask for an answer of the user's.
inline constexpr const char* kWhichSeries = "which-series";
inline constexpr const char* kTooLarge = "too-large";
inline constexpr const char* kMissingSlices = "missing-slices";

/// Reads and prepares on a thread of its own for each request; a new one cancels the last.
/// Signals arrive on the thread that owns the loader, and only for the newest request. No call
/// waits for a thread, except the destructor.
class Loader : public QObject {
  Q_OBJECT
 public:
  /// `free_memory` tells the bytes that may be filled; any thread.
  explicit Loader(std::function<double()> free_memory, QObject* parent = nullptr);

  void start(LoadRequest request);
  void cancel() { task_.cancel(); }

 signals:
  void progressed(double fraction);
  /// A path without a chosen entry was surveyed; it is then loaded, or it fails.
  void surveyed(const app::Surveyed& surveyed);
  void loaded(const app::Loaded& loaded);
  /// The request holds the chosen entry, if the survey came as far as that. The reason is
  /// kWhichSeries where one must be chosen, kTooLarge where the memory does not hold it,
  /// kMissingSlices where a part may be had without a gap.
  void failed(const app::LoadRequest& request, const haptics::Error& error);

 private:
  std::function<double()> free_memory_;
  background::Task<Loaded> task_;
};

}  // namespace app
