// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <optional>

#include "ui/props/colouring.h"
#include "ui/props/view_look.h"

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

  /// The entry that shows the unedited scan beside what is left of it.
  QAction& beforeAfter() const { return *before_after_; }
  /// Another volume: presets and colours are its own.
  void show(const Picture& picture);
  SurfaceColours colours() const { return colouring_; }
  /// Takes colours and second surface of `look`.
  void look(const ViewLook& look);

 signals:
  void isovalueWanted(double isovalue);
  void pictureWanted();      ///< a screenshot
  void pictureCopyWanted();  ///< to the clipboard

 private:
  void buildSides(QMenu& menu);
  void buildColours(QMenu& menu);
  void markSecond();
  void buildTool(QMenu& menu, TopBar& bar);
  void choose(Tissue tissue);
  void setColours(SurfaceColours colours);

  VolumeView& view_;
  std::optional<Picture> picture_;
  QMenu* presets_ = nullptr;
  QMenu* colours_ = nullptr;
  QMenu* second_ = nullptr;
  SurfaceColours colouring_ = SurfaceColours::Ivory;
  QAction* before_after_ = nullptr;
  QAction* no_second_ = nullptr;
  QAction* by_value_ = nullptr;
  QAction* ivory_ = nullptr;
};

}  // namespace ui
