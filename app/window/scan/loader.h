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
#include "app/window/scan/load_request.h"
#include "datasets/labels/belonging.h"
#include "datasets/readers/scan.h"
#include "haptics/core/error.h"
#include "haptics/scene/scene.h"
#include "ui/props/picture.h"
#include "ui/views/grey_presets.h"

namespace datasets {
struct Phantom;
}

namespace app {

/// The label of a tool for the user: its name, or its file's name.
QString labelOf(const ToolSource& tool);
/// What the window calls a phantom.
QString phantomTitle(const std::string& name);

/// A volume that stays on view, with its place.
struct Kept {
  std::shared_ptr<const haptics::Volume> volume;
  ui::Picture picture;  ///< as in Loaded
  QString title;
  std::filesystem::path place = {};        ///< as in Loaded
  std::vector<ui::GreyPreset> greys = {};  ///< likewise
  datasets::ScanIdentity identity = {};    ///< likewise
};

/// The name of what is read, for the user; empty if nothing is.
QString nameOf(const LoadRequest& request);

/// The series found at a path.
struct Surveyed {
  std::filesystem::path path;
  /// The place to remember: the path itself if it is a folder, an archive or a volume; for a slice,
  /// its folder.
  std::filesystem::path place;
  QString name;  ///< as in LoadRequest
  datasets::Survey survey;
};

/// A volume and a tool, ready for view and touch.
struct Loaded {
  /// The scene over the volume on view; the touch may have walls of structures that it lacks.
  const std::shared_ptr<const haptics::Scene>& seenScene() const { return seen ? seen : scene; }
  /// The volume on view.
  const std::shared_ptr<const haptics::Volume>& volume() const { return seenScene()->volume; }

  /// Of the volume, or, until that is ready, of the same scan before its last edits.
  ui::Picture picture;
  std::shared_ptr<const haptics::Scene> scene;      ///< that is touched
  std::shared_ptr<const haptics::Scene> seen = {};  ///< without walls; null: `scene` has none
  ToolSource tool;
  double isovalue = 0.0;
  haptics::Pose start = haptics::Pose::Identity();  ///< a legal pose in front of the surface, W
  std::vector<ui::GreyPreset> greys = {};           ///< the grey windows that the file states
  QString title;
  QString note;  ///< a sentence for the user although loading succeeded; or empty
  /// The path from which it was read; empty for a phantom, which shows no person.
  std::filesystem::path place = {};
  /// To tell whether structures belong to it; never shown.
  datasets::ScanIdentity identity = {};
};

/// Reasons of Loader::failed that need an answer of the user.
inline constexpr const char* kWhichSeries = "which-series";
inline constexpr const char* kTooLarge = "too-large";
inline constexpr const char* kMissingSlices = "missing-slices";
inline constexpr const char* kIdentifiersDiffer = "identifiers-differ";

/// Loads each request on its own thread. A new request cancels the one before. Signals arrive on
/// the thread that owns the loader, and only for the newest request. Only the destructor waits for
/// a thread.
class Loader : public QObject {
  Q_OBJECT
 public:
  /// `free_memory` returns the free memory in bytes; called on any thread.
  explicit Loader(std::function<double()> free_memory, QObject* parent = nullptr);

  void start(LoadRequest request);
  /// The request ends with failed(), even if it was loaded but not yet delivered.
  void cancel();

 signals:
  void progressed(double fraction);
  /// A path without a chosen entry was surveyed. loaded() or failed() follows.
  void surveyed(const app::Surveyed& surveyed);
  void loaded(const app::Loaded& loaded);
  /// `request` has the chosen entry, if the survey found one. The reason is kWhichSeries if an
  /// entry must be chosen, kTooLarge if it exceeds the memory, kMissingSlices if a part without a
  /// gap can be loaded.
  void failed(const app::LoadRequest& request, const haptics::Error& error);

 private:
  std::function<double()> free_memory_;
  background::Task<Loaded> task_;
  background::Task<bool> keeping_;
  bool cancelled_ = false;  ///< the newest request

  void keep(const datasets::Phantom& phantom);
};

}  // namespace app
