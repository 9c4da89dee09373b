// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "haptics/core/error.h"
#include "haptics/core/geometry.h"

namespace haptics {

enum class ScalarType { UInt8, Int8, UInt16, Int16, UInt32, Int32, Float32 };

/// "uint8", "int16", …: the names of the command line.
const char* nameOf(ScalarType type);
std::size_t sizeOf(ScalarType type);  ///< bytes of one voxel

/// Where the voxels lie. Index (i, j, k) has its centre at
/// origin + direction · (i spacing.x, j spacing.y, k spacing.z).
struct Grid {
  std::array<std::int64_t, 3> dims{};  ///< voxels along i (fastest), j, k; each at least 1
  Vec3 spacing = Vec3::Ones();         ///< m, positive
  Vec3 origin = Vec3::Zero();          ///< m, W (patient LPS): the centre of voxel (0, 0, 0)
  /// Columns are the unit directions of i, j, k in W: orthogonal, left- or right-handed as in the
  /// file.
  Mat3 direction = Mat3::Identity();

  std::int64_t voxelCount() const { return dims[0] * dims[1] * dims[2]; }
  Vec3 worldOf(const Vec3& index) const { return origin + direction * index.cwiseProduct(spacing); }
  Vec3 indexOf(const Vec3& p_W) const {
    return (direction.transpose() * (p_W - origin)).cwiseQuotient(spacing);
  }
};

/// A box of voxels: those with first <= index < end on each axis.
struct VoxelBox {
  std::array<std::int64_t, 3> first{}, end{};
  bool operator==(const VoxelBox&) const = default;
};
inline bool isEmpty(const VoxelBox& box) { return box.end[0] <= box.first[0]; }
inline std::int64_t voxelsIn(const VoxelBox& box) {
  std::int64_t count = isEmpty(box) ? 0 : 1;
  for (std::size_t a = 0; a < 3; ++a) count *= box.end[a] - box.first[a];
  return count;
}
/// The least box that holds two boxes, each of which may be empty.
VoxelBox joined(const VoxelBox& one, const VoxelBox& other);
/// Adds a box to those of a way through a volume: it joins the last one as long as that has no side
/// of more than 64 voxels. An empty box adds nothing.
void add(const VoxelBox& box, std::vector<VoxelBox>& way);

class Tissues;      // carving/tissues.h
class VoxelMemory;  // core/voxel_memory.h
struct Derivation;

/// A scan: one evenly spaced, right-angled, single-component stack of voxels. Immutable once
/// made, shared by picture, slices and touch; there is one copy of the voxels.
struct Volume {
  Grid grid;
  ScalarType type = ScalarType::Int16;
  /// dims[0]·dims[1]·dims[2] voxels, i fastest, followed by kVoxelPadding readable bytes.
  std::shared_ptr<const void> voxels;
  double least = 0.0;             ///< smallest finite voxel: the background beyond the grid
  double greatest = 0.0;          ///< greatest finite voxel
  std::string unit = {};          ///< "HU" or empty
  std::string modality = {};      ///< "CT", "MR", … or empty
  bool orientation_known = true;  ///< false: left and right must not be shown
  std::int64_t replaced = 0;      ///< non-finite voxels that became background
  std::int64_t padded = 0;        ///< voxels stored as padding, where nothing was measured; now air
  /// Voxels whose words say more than the bits that the file states as stored, which alone count.
  std::int64_t beyond_bits = 0;
  bool resampled = false;  ///< from slices that were tilted or unevenly spaced
  /// Number of slices of the series that are not in this volume. It is above 0 if the series lacks
  /// slices and this is its largest part without a gap.
  std::int64_t slices_left_out = 0;
  /// The voxels that exist, a box within the grid; none: all of them. Beyond it F falls to the
  /// background within one voxel, as it does beyond the grid.
  std::optional<VoxelBox> crop = {};
  /// What it takes to cut some structures; null: what the values say.
  std::shared_ptr<const Tissues> tissues = {};
  /// The memory object that `voxels` is a view of; null: they cannot be edited.
  std::shared_ptr<const VoxelMemory> memory = {};
  /// How it came about from a scan; null: it is the scan.
  std::shared_ptr<const Derivation> derivation = {};

  VoxelBox bounds() const { return crop ? *crop : VoxelBox{{}, grid.dims}; }
};

/// How a volume came about from a scan. That of an edited volume is a datasets::Edited.
struct Derivation {
  virtual ~Derivation() = default;
  std::shared_ptr<const Volume> scan;
  /// Another volume of the same scan, mostly one step away, and boxes that hold every voxel and
  /// every face of the crop that differs from it. For what was built over that volume and is
  /// renewed only where it changed.
  std::weak_ptr<const Volume> neighbour;
  std::vector<VoxelBox> changed;
};

/// How one of the volumes differs from the other; null if they are not known to be neighbours.
inline const Derivation* derivationBetween(const std::shared_ptr<const Volume>& one,
                                           const std::shared_ptr<const Volume>& other) {
  if (one->derivation && one->derivation->neighbour.lock() == other) return one->derivation.get();
  if (other->derivation && other->derivation->neighbour.lock() == one)
    return other->derivation.get();
  return nullptr;
}

inline constexpr std::size_t kVoxelPadding = 64;  ///< bytes

/// Room for `voxel_count` voxels and the padding (zeroed), in a memory object of its own, or an
/// error naming the size.
Expected<std::shared_ptr<void>> allocateVoxels(std::int64_t voxel_count, ScalarType type);

/// What a reader or a phantom knows in addition to the voxels.
struct VolumeFacts {
  std::string unit = {};
  std::string modality = {};
  bool orientation_known = true;
  std::int64_t padded = 0;
  std::int64_t beyond_bits = 0;
  bool resampled = false;
};

/// Finishes a volume: checks the grid (dims, finite positive spacing, right angles to 1e-4),
/// makes non-finite voxels background and counts them, and finds the range. Refuses a volume
/// without a finite voxel. `voxels` must be followed by the padding, as allocateVoxels makes it,
/// and not be written afterwards. Their memory object, if they have one, becomes the volume's.
/// `goes_on` gets the fraction that is done, every few milliseconds; if it returns false, the
/// result is Error::Kind::Cancelled.
Expected<Volume> makeVolume(const Grid& grid, ScalarType type, std::shared_ptr<void> voxels,
                            VolumeFacts facts = {},
                            const std::function<bool(double)>& goes_on = {});

/// Calls f with a typed pointer to the first voxel.
template <class F>
decltype(auto) visitVoxels(ScalarType type, const void* voxels, F&& f) {
  switch (type) {
    case ScalarType::UInt8:
      return f(static_cast<const std::uint8_t*>(voxels));
    case ScalarType::Int8:
      return f(static_cast<const std::int8_t*>(voxels));
    case ScalarType::UInt16:
      return f(static_cast<const std::uint16_t*>(voxels));
    case ScalarType::Int16:
      return f(static_cast<const std::int16_t*>(voxels));
    case ScalarType::UInt32:
      return f(static_cast<const std::uint32_t*>(voxels));
    case ScalarType::Int32:
      return f(static_cast<const std::int32_t*>(voxels));
    case ScalarType::Float32:
      break;
  }
  return f(static_cast<const float*>(voxels));
}

}  // namespace haptics
