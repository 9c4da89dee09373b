// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QColor>
#include <QImage>
#include <QWidget>
#include <functional>
#include <memory>
#include <stdexcept>

#include "haptics/core/triangle_mesh.h"
#include "haptics/core/volume.h"
#include "ui/dialogs/export_question.h"
#include "ui/views/slice_view.h"
#include "ui/views/volume_view.h"

namespace window {

/// A volume whose voxels follow a formula of their place in W.
std::shared_ptr<const haptics::Volume> volumeOf(
    const haptics::Grid& grid, haptics::ScalarType type,
    const std::function<double(const haptics::Vec3& p_W)>& intensity,
    haptics::VolumeFacts facts = {});

/// A grid of n^3 voxels of 1 mm whose middle is the origin, with these axes.
haptics::Grid cubeGrid(int n, const haptics::Mat3& direction = haptics::Mat3::Identity());

/// 100 inside a ball about `centre_W`, falling to 0 over 3 mm at its surface (50 there); m.
std::function<double(const haptics::Vec3&)> ball(const haptics::Vec3& centre_W, double radius);

/// An octahedron with corners this far from its middle, m.
haptics::TriangleMesh octahedron(double size);

/// The panel of this class in a window.
template <class Panel>
Panel& panelOf(QWidget& window) {
  auto* found = window.findChild<Panel*>();
  if (found == nullptr) throw std::logic_error("the window has no such panel");
  return *found;
}

/// Handles events until `done`; whether it is done. It gives up after far more than anything takes
/// on a machine that is busy.
bool waitFor(const std::function<bool()>& done, double seconds = 120.0);

/// Shows the widget and waits until it has been drawn.
void showAndWait(QWidget& widget, QSize size);
/// Waits until nothing more is drawn, and takes the widget's picture: a pixel for each of the
/// widget's, whatever the scale of the screen.
QImage pictureOf(QWidget& widget);
/// Draws a view anew whose vtkCamera was moved: the view does not notice that by itself.
void showCamera(ui::VolumeView& view);
/// Makes the view's time of rest pass, and waits for what is drawn at rest: the finer mesh of a 3-D
/// view, the fine contour of a slice.
void rest(ui::VolumeView& view);
void rest(ui::SliceView& view);
/// The same of a 3-D view at rest.
QImage pictureAtRest(ui::VolumeView& view);
/// Keeps a picture in the tests' folder, so that it can be looked at.
void keep(const QImage& image, const char* name);

/// The share of pixels that differ by more than `tolerance` in some channel.
double differing(const QImage& a, const QImage& b, int tolerance = 24);
/// Mean place of the pixels that `wanted` picks; {-1, -1} if fewer than `least`.
QPointF centroid(const QImage& image, const std::function<bool(QColor)>& wanted, int least = 4);
/// How many pairs of pixels that lie within one pixel of half the resolution differ.
int neighboursApart(const QImage& image, const QRect& where);
int count(const QImage& image, const std::function<bool(QColor)>& wanted);

/// Nothing in a panel reaches beyond the width that is seen of it. Returns how much was looked at.
int expectNothingBeside(const QWidget& panel, const char* where);
/// No word of what is seen in `parent` is cut off.
void expectNothingCut(const QWidget& parent, const char* where);

bool proxyColoured(QColor colour);
bool deviceColoured(QColor colour);
bool surfaceColoured(QColor colour);
/// Whether it is that of faces that a burr has cut.
bool cutColoured(QColor colour);

/// Formats as an export dialog is given them.
inline std::vector<ui::ExportFormat> exportFormats() {
  return {{"CSV", "Tables."}, {"HDF5", "Arrays."}, {"MCAP", "Messages."}};
}

}  // namespace window
