// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QImage>
#include <optional>

class QWidget;

namespace ui {

class VolumeView;

/// What a picture shows, and how large it is.
struct ScreenshotWish {
  bool whole_window = false;  ///< false: the 3-D view alone
  int scale = 1;              ///< pixels of the picture for one of the screen, 1 to 4
};

/// Asks for it. None: the user cancelled.
std::optional<ScreenshotWish> askForScreenshot(QWidget* parent, const VolumeView& view,
                                               const QWidget& window);

/// The least scale at which a picture has at least the pixels that the screen shows.
int screenScaleOf(const QWidget& widget);

/// The picture, without any text beside it. Null if the graphics cannot draw it so large.
QImage screenshotOf(QWidget& window, VolumeView& view, const ScreenshotWish& wish);

}  // namespace ui
