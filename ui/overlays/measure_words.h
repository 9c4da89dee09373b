// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QString>
#include <functional>
#include <span>
#include <vector>

#include "haptics/core/volume.h"
#include "ui/overlays/measure.h"

namespace ui {

/// What measures are taken from.
struct MeasuredScan {
  haptics::Grid grid = {};
  QString unit = {};  ///< of the intensities: "HU" or empty
  /// The intensity at a place of W, mm; empty before the first scan.
  std::function<double(const Eigen::Vector3d& p_W_mm)> value = {};
};

/// The accuracy that the voxels allow, of a number that depends on places. `changes`: by how much
/// the number changes for each mm that a place moves, one vector in W for each place.
///
/// A place is known to half the diagonal of a cube that is as large as the voxel is along the
/// direction in which the place counts, and never worse than half the voxel's own diagonal. The
/// shares of the places are added as squares. With voxels of equal sides that is half a voxel
/// diagonal for each place; within a slice, a thick slice does not count.
double accuracyOf(const haptics::Grid& grid, std::span<const Eigen::Vector3d> changes);

/// A number with so many decimals, its digits not grouped.
QString numberWords(double number, int decimals);

/// A number and its accuracy: "12.3 mm ± 0.4 mm". Both end at the first digit of the accuracy, so a
/// distance ends at 0.1 mm with voxels of 0.3 mm, and at 1 mm with voxels of 1 mm.
QString rounded(double number, double accuracy, const QString& unit);

/// What a measure says: its number with unit (of lengths the one that the user chose) and accuracy;
/// empty for a note. An angle whose legs are shorter than their accuracy, and a value outside the
/// scan, are said to be unknown.
QString valueOf(const Measure& measure, const MeasuredScan& scan);

/// mm, from the first place to the second.
double distanceOf_mm(const Measure& measure);
/// Degrees at the second place; NaN if a leg has no length.
double angleOf_deg(const Measure& measure);
/// The arc of an angle: places of W between its legs, mm; empty: no arc.
std::vector<Eigen::Vector3d> arcOf(const Measure& measure);

/// "Distance", …
QString nameOf(MeasureKind kind);

/// `text` as one line of at most kLongestMeasureText characters, without control characters.
QString plainLine(const QString& text);

}  // namespace ui
