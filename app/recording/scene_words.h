// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "datasets/edits/edit.h"
#include "datasets/edits/walls.h"
#include "haptics/core/error.h"
#include "haptics/scene/scene.h"
#include "haptics/servo/step.h"

namespace app {

/// A keyed hash of a volume. It shows that two volumes match without identifying either. Eight
/// bytes identify the key; the other 32 are the hash.
using VolumeHash = std::array<std::uint8_t, 40>;

enum class SameVolume { Same, Another, Unknown };
/// Unknown if a hash is missing, or if the hashes were made with different keys, that is by
/// different installations.
SameVolume compared(const std::optional<VolumeHash>& one, const std::optional<VolumeHash>& other);

/// A scene as a recording stores it: without voxels.
struct RecordedScene {
  std::uint32_t id = 0;
  haptics::Tool tool;                      ///< has a name only if it is one of the named tools
  haptics::SceneOptions options;           ///< field, normals, plan and fineness
  haptics::Volume volume;                  ///< of the scan, without voxels
  std::optional<VolumeHash> hash = {};     ///< of the scan
  std::vector<datasets::Edit> edits = {};  ///< of the scan that were in force
  std::uint64_t edits_digest = 0;          ///< Edited::digest; 0 without edits
  std::vector<datasets::Walled::Wall> walls = {};  ///< structures that were solid or not there
  double walls_isovalue = 0.0;                     ///< Walled::isovalue
  std::uint64_t walls_digest = 0;                  ///< Walled::digest_of_walls
};

/// The words by which files and the command line name these choices.
const char* nameOf(haptics::FieldKind kind);
const char* nameOf(haptics::NormalKind kind);
/// The choices of these names, which must exist.
haptics::FieldKind fieldNamed(const std::string& name);
haptics::NormalKind normalNamed(const std::string& name);

/// RecordedScene in its stored form: JSON, and compressed numbers.
struct SceneWords {
  std::string settings, volume;
  std::vector<std::uint8_t> points, vertices, triangles;
};

SceneWords wordsOf(const haptics::Scene& scene);
/// Refuses text that wordsOf() did not write, reason "damaged".
haptics::Expected<RecordedScene> sceneFrom(const SceneWords& words);

/// ProxyStart as the text of its event.
std::string wordsOf(const haptics::ProxyStart& start);
haptics::Expected<haptics::ProxyStart> startFrom(const std::string& text);

}  // namespace app
