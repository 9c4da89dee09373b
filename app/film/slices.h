// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QRect>
#include <memory>
#include <optional>

#include "app/film/frame.h"
#include "app/recording/recording.h"
#include "haptics/core/triangle_mesh.h"
#include "ui/props/slice.h"

class QPainter;

namespace app {

/// The three slices through the tool's tip, in a column at the right of a film's frames: each with
/// the body as large as it can be, letters, a scale bar, the grey window, the lines in which the
/// others meet it, and the tool's outline.
class FilmSlices {
 public:
  /// For frames of this size. `grey`: none: the window with which the volume is first shown.
  FilmSlices(int width, int height, std::optional<ui::GreyWindow> grey);
  /// Of the column, px.
  int width() const { return width_; }

  /// No volume: the column stays empty.
  void show(const ui::Picture& picture);
  void show(haptics::TriangleMesh tool);
  /// Cuts these voxels of the volume, which change from now on, as carve() says.
  void showLive(const haptics::Volume& voxels) { slice_.showLive(voxels); }
  void carve() { slice_.carve(); }
  /// Draws the column into a frame at the tool's pose of a step.
  void draw(const haptics::Step& step, FilmFrame& frame);

 private:
  void drawSlice(QPainter& painter, ui::Plane plane, const QRect& pane, const haptics::Pose* X_WP);

  int width_, height_;
  std::optional<ui::GreyWindow> wish_;
  ui::GreyWindow grey_;
  ui::Slice slice_;
  std::shared_ptr<const haptics::Volume> volume_;
  Eigen::AlignedBox3d box_mm_, body_mm_;
  Eigen::Vector3d cross_mm_ = Eigen::Vector3d::Zero();  ///< where the slices meet
  haptics::TriangleMesh tool_;
};

}  // namespace app
