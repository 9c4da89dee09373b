// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "haptics/core/error.h"
#include "haptics/core/volume.h"

namespace datasets {

inline constexpr std::size_t kMostStructures = 255;

/// A part of the body that a label map marks. Its name is plain text in UTF-8 of at most
/// kLongestName bytes, for the screen of the person who opened the file alone: it can say who the
/// patient is.
struct Structure {
  static constexpr std::size_t kLongestName = 128;

  std::string name = {};                        ///< empty: the file states none
  std::array<double, 3> colour{1.0, 1.0, 1.0};  ///< red, green, blue, 0 to 1
  std::int64_t voxels = 0;                      ///< of the scan that belong to it
};

/// Which structures each voxel of a scan belongs to: one byte a voxel, also where structures
/// overlap. The byte is a code, and each code stands for a set of structures; 0 stands for none.
class LabelMap {
 public:
  /// One byte for each voxel of a scan, none of which belongs to a structure. Refuses ("too-large")
  /// what the free memory does not hold.
  static haptics::Expected<LabelMap> over(const haptics::Grid& scan);

  const haptics::Grid& grid() const { return grid_; }
  /// The codes, i fastest.
  const std::uint8_t* codes() const { return codes_.get(); }
  std::shared_ptr<const std::uint8_t[]> sharedCodes() const { return codes_; }
  /// How many codes are in use.
  int codeCount() const { return static_cast<int>(sets_.size()); }
  /// Which structures a code stands for, by their numbers, in ascending order.
  const std::vector<std::uint8_t>& structuresOf(std::uint8_t code) const { return sets_[code]; }
  const std::vector<Structure>& structures() const { return structures_; }

  /// Adds the structures of a volume of labels, which may lie on another grid: each voxel of the
  /// scan gets what the volume has at the nearest of its voxels, and nothing beyond them.
  /// `numbers`: which of `structures()` each label is; other labels are nothing. Refuses
  /// ("labels-too-many") more than 255 sets of structures that overlap.
  haptics::Expected<void> add(const haptics::Volume& labels,
                              const std::map<std::int64_t, std::uint8_t>& numbers);
  /// Adds a structure of which no voxel is known yet, and returns its number. There must be fewer
  /// than kMostStructures.
  std::uint8_t add(Structure structure);

 private:
  LabelMap() = default;
  haptics::Expected<std::uint8_t> with(std::uint8_t code, std::uint8_t number);

  haptics::Grid grid_;
  std::shared_ptr<std::uint8_t[]> codes_;
  std::vector<std::vector<std::uint8_t>> sets_{{}};
  std::map<std::pair<std::uint8_t, std::uint8_t>, std::uint8_t> joined_;  ///< code and number
  std::vector<Structure> structures_;
};

}  // namespace datasets
