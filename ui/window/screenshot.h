// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QImage>
#include <optional>

class QWidget;

namespace ui {

class SliceView;
class Views;

/// What a picture shows, and how large it is.
struct ScreenshotWish {
  bool whole_window = false;   ///< false: one view alone
  SliceView* slice = nullptr;  ///< this one; null: the 3-D view, with the one beside it
  int scale = 1;               ///< pixels of the picture for one of the screen, 1 to 4
};

/// Asks for it: the window, or a view that is in it. The choice begins with `first`; null: with the
/// 3-D view. None: the user cancelled.
std::optional<ScreenshotWish> askForScreenshot(QWidget& window, Views& views,
                                               const SliceView* first);

/// The least scale at which a picture has at least the pixels that the screen shows.
int screenScaleOf(const QWidget& widget);

/// The picture, without any text beside it. Null if the graphics cannot draw it so large.
QImage screenshotOf(QWidget& window, Views& views, const ScreenshotWish& wish);

}  // namespace ui
