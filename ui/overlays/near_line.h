// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "ui/overlays/overlay.h"

namespace ui {

/// The way from the tool's tip to the nearest structure that is watched, with its length, over the
/// 3-D view: a structure behind bone is where the line ends.
class NearLine : public Overlay {
  Q_OBJECT
 public:
  struct Way {
    Eigen::Vector3d tip_mm, structure_mm;  ///< its ends, W
    QString words;                         ///< how long it is
  };
  using Overlay::Overlay;

  /// None: no structure is watched, or none is near.
  void show(const std::optional<Way>& way);
  const std::optional<Way>& way() const { return way_; }
  void paint(QPainter& painter, const ViewGeometry& view) const override;

 private:
  std::optional<Way> way_;
};

}  // namespace ui
