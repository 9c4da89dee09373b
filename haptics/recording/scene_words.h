// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "haptics/core/error.h"
#include "haptics/scene/scene.h"
#include "haptics/servo/step.h"

namespace haptics {

/// A keyed hash of a volume: that two are the same can be told, which they are cannot. Eight bytes
/// that tell one key from another, then 32 of the hash.
using VolumeHash = std::array<std::uint8_t, 40>;

enum class SameVolume { Same, Another, Unknown };
/// Unknown where one is missing, and where they were made with different keys: by installations
/// that know nothing of each other.
SameVolume compared(const std::optional<VolumeHash>& one, const std::optional<VolumeHash>& other);

/// A scene as a recording holds it: everything but the voxels.
struct RecordedScene {
  std::uint32_t id = 0;
  Tool tool;             ///< named only if it is one of ours
  SceneOptions options;  ///< field, normals, plan and fineness
  Volume volume;         ///< without voxels
  std::optional<VolumeHash> hash = {};
};

/// The same as it is stored: JSON, and numbers compressed.
struct SceneWords {
  std::string settings, volume;
  std::vector<std::uint8_t> points, vertices, triangles;
};

SceneWords wordsOf(const Scene& scene);
/// Refuses what wordsOf did not write, reason "damaged".
Expected<RecordedScene> sceneFrom(const SceneWords& words);

/// A start as the text of its event.
std::string wordsOf(const ProxyStart& start);
Expected<ProxyStart> startFrom(const std::string& text);

}  // namespace haptics
