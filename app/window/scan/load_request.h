// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QString>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "app/recording/scene_words.h"
#include "datasets/readers/scan.h"
#include "haptics/scene/scene.h"

namespace app {

struct Kept;

/// A tool: a named one, or a file.
struct ToolSource {
  std::string name = "probe";  ///< name of a named tool
  std::optional<std::filesystem::path> file = {};
  std::string unit = "mm";              ///< unit of the file: m, mm, cm, in
  std::optional<VolumeHash> hash = {};  ///< of the file, once it was read
};

/// An entry of a survey. It can be loaded without another survey.
struct ChosenSeries {
  datasets::SeriesVerdict series;
  bool among_others = false;         ///< the survey has more entries, so the title names this one
  std::filesystem::path place = {};  ///< as in Surveyed
};

/// A request to load. Of path, phantom and keep, the first that is set is used.
struct LoadRequest {
  std::optional<std::filesystem::path> path = {};
  QString name = {};               ///< of the path, for the user; empty: its own
  std::optional<int> series = {};  ///< index of the entry in the path's survey
  /// The grid of the scan that is wanted, where it is known, as of a view: where one entry alone
  /// can have it, that one is taken.
  std::optional<haptics::Grid> grid = {};
  /// The entry itself. If not set, the path is surveyed and the only sound entry is taken, unless
  /// another is larger or correctable.
  std::optional<ChosenSeries> chosen = {};
  datasets::Geometry geometry = datasets::Geometry::AsStored;
  bool largest_part = false;  ///< as in datasets::Reading
  datasets::Part part = {};
  std::optional<std::string> phantom = {};
  /// The volume already shown, with another tool or field; null: none.
  std::shared_ptr<const Kept> keep = {};
  std::optional<ToolSource> tool = {};  ///< none: the tool that fits the phantom, otherwise `probe`
  std::optional<double> isovalue = {};
  haptics::SceneOptions options = {};
  /// The scene whose field is reused if volume and kind are the same; may be null.
  std::shared_ptr<const haptics::Scene> previous = {};
};

}  // namespace app
