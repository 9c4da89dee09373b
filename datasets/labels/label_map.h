// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "datasets/readers/scan.h"
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
  /// Voxels of the file that belong to it, and those of them whose centres lie outside the scan.
  /// Not counted of contours, surfaces, and files that do not reach beyond the scan.
  std::int64_t marked = 0, outside = 0;
};

/// A colour for a structure that has none, far from those of its neighbours in the list: the hue
/// goes on by the golden angle.
std::array<double, 3> colourFarFromOthers(std::size_t number);

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
  /// Sentences about parts of the file that are not in the map.
  const std::vector<haptics::Message>& notes() const { return notes_; }

  /// Adds the structures of a volume of labels, which may lie on another grid: each voxel of the
  /// scan gets what the volume has at the nearest of its voxels, and nothing beyond them.
  /// `numbers`: which of `structures()` each label is; other labels are nothing. Refuses
  /// ("labels-too-many") more than 255 sets of structures that overlap.
  haptics::Expected<void> add(const haptics::Volume& labels,
                              const std::map<std::int64_t, std::uint8_t>& numbers,
                              const ReadProgress& progress = {});
  /// Adds a structure of which no voxel is known yet, and returns its number. There must be fewer
  /// than kMostStructures.
  std::uint8_t add(Structure structure);
  /// Makes a voxel, by its place in codes(), one of a structure's. Refuses as above.
  haptics::Expected<void> mark(std::int64_t voxel, std::uint8_t number);
  /// Counts a voxel that a file marks as a structure's.
  void count(const haptics::Vec3& centre_W, std::uint8_t number);
  void note(haptics::Message sentence) { notes_.push_back(std::move(sentence)); }
  /// The voxels among which those at these places lie, and at most one more on each side.
  haptics::VoxelBox boxAround(std::span<const haptics::Vec3> places_W) const;

 private:
  LabelMap() = default;
  haptics::Expected<std::uint8_t> with(std::uint8_t code, std::uint8_t number);

  haptics::Grid grid_;
  std::shared_ptr<std::uint8_t[]> codes_;
  std::vector<std::vector<std::uint8_t>> sets_{{}};
  /// The code of a set with one structure more, by code and number; below 0: not known yet.
  std::vector<std::int16_t> joined_ = std::vector<std::int16_t>(256 * 256, -1);
  std::vector<Structure> structures_;
  std::vector<haptics::Message> notes_;
};

}  // namespace datasets
