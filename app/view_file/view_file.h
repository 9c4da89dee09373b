// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/recording/scene_words.h"
#include "datasets/edits/edit.h"
#include "haptics/core/error.h"
#include "haptics/core/geometry.h"
#include "haptics/core/volume.h"
#include "ui/overlays/measure.h"
#include "ui/props/view_look.h"

namespace app {

/// What the user did with a scan and how it was looked at: a file that ends in .palpate-view. It
/// has no voxel, no name of a person and no date. What the user wrote in notes is in it as it was
/// written.
struct ViewFile {
  haptics::Grid grid = {};  ///< of the scan
  haptics::ScalarType type = haptics::ScalarType::Int16;
  std::optional<VolumeHash> hash = {};  ///< of the scan without edits
  /// Where the scan lies, relative to the file's folder, UTF-8; empty: not to be told.
  std::string place = {};
  std::vector<datasets::Edit> edits = {};  ///< in force, oldest first
  double isovalue = 0.0;
  std::string tool = {};  ///< one of the named tools; empty: another
  /// The file of another tool, by its keyed hash, and the unit of that file.
  std::optional<VolumeHash> tool_file = {};
  std::string tool_unit = {};
  std::optional<haptics::Pose> X_WP = {};  ///< where the tool is, m
  std::vector<ui::Measure> marks = {};
  ui::ViewLook look = {};
};

inline constexpr std::size_t kMostViewBytes = 64'000'000;
inline constexpr std::size_t kMostMarks = 10'000;
inline constexpr std::size_t kMostEdits = 1'000;
inline constexpr const char* kViewEnding = ".palpate-view";

/// 80 hexadecimal digits, and back; none for other text.
std::string hexOf(const VolumeHash& hash);
std::optional<VolumeHash> hashFromHex(std::string_view hex);

/// JSON, one object. Lengths are in metres of W, and numbers so that reading gives the same double.
std::string textOf(const ViewFile& view);

/// Reads strictly: refuses text that textOf() cannot have written, names the field, and takes
/// nothing from it. Reasons: "too-large", "damaged", and "earlier" or "later" for another version.
/// `name`: how the file is called in the error.
haptics::Expected<ViewFile> viewFileFrom(std::string_view text, const std::string& name);

/// The same from a file. Refuses a file that cannot be read, reason "unreadable".
haptics::Expected<ViewFile> readViewFile(const std::filesystem::path& path);

/// Writes it whole or not at all. Refuses what is larger than kMostViewBytes, reason "too-large".
haptics::Expected<void> writeViewFile(const std::filesystem::path& path, const ViewFile& view);

}  // namespace app
