// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QColor>
#include <QImage>
#include <QString>
#include <cstdint>
#include <memory>
#include <vector>

#include "haptics/core/volume.h"
#include "ui/props/slice.h"

namespace ui {

/// Which structures each voxel of a scan belongs to: a code for each voxel, and for each code the
/// numbers of its structures, in ascending order; code 0 stands for none.
struct StructureMap {
  haptics::Grid grid;
  std::shared_ptr<const std::uint8_t[]> codes;  ///< i fastest
  std::vector<std::vector<std::uint8_t>> sets;

  /// The code at a place; 0 beyond the voxels.
  std::uint8_t codeAt(const Eigen::Vector3d& p_W_mm) const;
};

/// How a structure is felt, beside the surface of the scan.
struct StructureFeel {
  enum class Kind { AsScan, Softer, Guarded, Solid, NotThere };
  Kind kind = Kind::AsScan;
  double stiffness = 300.0;  ///< Softer: N/m
  double margin_mm = 2.0;    ///< Guarded: from where on a force keeps the tool away
  double most = 2.0;         ///< Guarded: N, at the structure and within

  bool operator==(const StructureFeel&) const = default;
};
inline constexpr double kLeastFeelStiffness = 10.0, kMostFeelStiffness = 5000.0;
inline constexpr double kLeastMargin_mm = 0.5, kMostMargin_mm = 15.0;
inline constexpr double kLeastGuard = 0.1, kMostGuard = 10.0;

/// What it takes to cut a structure.
struct StructureCutting {
  enum class Kind { ByValue, Never, Energy };
  Kind kind = Kind::ByValue;
  double energy_J_mm3 = 0.2;  ///< Energy

  bool operator==(const StructureCutting&) const = default;
};

/// How a structure is seen, felt and cut. Its name is plain text, for the screen alone.
struct StructureLook {
  QString name = {};
  QColor colour = {};
  bool visible = true;
  double opacity = 1.0;     ///< in 3-D, and of the fill in slices; kLeastStructure to 1
  bool watched = false;     ///< its distance is told while the tool moves
  StructureFeel feel = {};  ///< what is felt otherwise is watched
  StructureCutting cutting = {};
  std::int64_t distance_bytes =
      0;                  ///< of memory, that its distances take; 0: nothing of it is there
  bool own_name = false;  ///< not one of a file: reports may have it

  bool operator==(const StructureLook&) const = default;
};
inline constexpr double kLeastStructure = 0.1;

/// The structures of the scan on view, and how all of them are drawn.
struct Structures {
  std::shared_ptr<const StructureMap> map = {};  ///< null: none
  std::vector<StructureLook> looks = {};         ///< by number
  bool through = true;                           ///< in 3-D also seen where bone hides them
  bool filled = false;                           ///< in slices, else outlined

  /// The names of those at a place, whether they are shown or not; empty: none is there.
  QString namesAt(const Eigen::Vector3d& p_W_mm) const;
  QString namesOf(std::uint8_t code) const;
  /// Whether one that is shown has this code.
  bool isShown(std::uint8_t code) const;
};

/// The structures in a plane.
class StructureCut {
 public:
  /// Cuts the same pixels as Slice::cut().
  void cut(const StructureMap& map, const PlaneAxes& axes, const Eigen::Vector3d& centre_W_mm,
           QSize size, double mm_per_pixel);
  /// The outlines of what is shown, so many pixels wide and within the structure, filled if wished.
  QImage picture(const Structures& shown, int line) const;

 private:
  QSize size_;
  std::vector<std::uint8_t> codes_;  ///< upper rows first
};

}  // namespace ui
