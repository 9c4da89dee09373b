// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <optional>

#include "ui/props/colouring.h"

class QAction;
class QMenu;

namespace ui {

class TopBar;

class VolumeView;

/// The entries of the View menu about the 3-D view: sides, projection, colours, presets, the second
/// surface, contacts, and the mouse as a hand, which has a button too.
class ViewActions : public QObject {
  Q_OBJECT
 public:
  ViewActions(QMenu& menu, TopBar& bar, VolumeView& view);

  /// Another volume: presets and colours are its own.
  void show(const Picture& picture);

 signals:
  void isovalueWanted(double isovalue);
  void pictureWanted();      ///< a screenshot
  void pictureCopyWanted();  ///< to the clipboard

 private:
  void buildSides(QMenu& menu);
  void buildColours(QMenu& menu);
  void buildTool(QMenu& menu, TopBar& bar);
  void choose(Tissue tissue);

  VolumeView& view_;
  std::optional<Picture> picture_;
  QMenu* presets_ = nullptr;
  QMenu* colours_ = nullptr;
  QMenu* second_ = nullptr;
  QAction* no_second_ = nullptr;
  QAction* by_value_ = nullptr;
  QAction* ivory_ = nullptr;
};

}  // namespace ui
