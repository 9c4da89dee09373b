// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QElapsedTimer>
#include <QImage>
#include <QList>
#include <QObject>
#include <QRect>
#include <QString>
#include <span>
#include <vector>

#include "haptics/core/triangle_mesh.h"
#include "haptics/snapshot.h"
#include "ui/props/view_look.h"
#include "ui/props/volume_prop.h"
#include "ui/views/slice_set.h"

class QAction;
class QMenu;

namespace ui {

class BeforeView;
class ForcePanel;
class Overlay;
class TopBar;
class ViewActions;
class ViewFrame;
class ViewLayout;
class VolumeView;

/// The 3-D view and the slices, which look at the same scan, and how they share the window. GUI
/// thread.
class Views : public QObject {
  Q_OBJECT
 public:
  explicit Views(QWidget* window);

  VolumeView& volume() { return *volume_; }
  SliceSet& slices() { return *slices_; }
  SliceView& slice(Plane plane) { return slices_->slice(plane); }
  /// All of them, as they stand in the window.
  ViewLayout& layout() { return *layout_; }
  /// Adds the entries about the 3-D view to the menu and the bar.
  void addActions(QMenu& menu, TopBar& bar);

  /// Shows another volume instead of the present one. `stated`: the grey windows that its file
  /// states.
  void show(const Picture& picture, double isovalue, const std::vector<GreyPreset>& stated = {});
  void show(const haptics::TriangleMesh& tool);
  /// Shows other voxels of the same grid; camera, crosshair and grey window stay.
  void replace(const Picture& picture);
  /// Shows these voxels, which are those of the volume on view and change from now on: carve() says
  /// where. `scan`: what they were before any cut; boxes that hold what is cut already. Until the
  /// next show() or replace().
  void showLive(const haptics::Volume& voxels, std::shared_ptr<const haptics::Volume> scan,
                std::span<const haptics::VoxelBox> cut_before);
  void carve(const haptics::VoxelBox& box);
  /// The volume on view is this one now, whose voxels are on view already.
  void renew(const Picture& picture);
  /// The isovalue of surface and contour, without asking for it to be touched.
  void setIsovalue(double isovalue);
  /// The surface that is touched; given with every scene.
  void setTouched(const TouchedSurface& touched);
  /// Which structures lie in the scan, and how they look; their shapes in 3-D follow.
  void show(const Structures& structures);
  /// Poses of the tool, at display rate.
  void display(const haptics::Snapshot& snapshot);
  /// Draws this above all views, and asks it first for mouse and keys.
  void addOverlay(Overlay& overlay);
  /// Its key works while a view has the focus.
  void addAction(QAction& action);
  /// Shows the force in a corner of the 3-D view that the tool leaves free.
  void setForceCard(ForcePanel& card);
  /// Where sentences lie over the 3-D view, in its coordinates.
  void setSentences(const QList<QRect>& parts);
  /// Shows the unedited scan beside the 3-D view, until hideBefore(). The two have one camera.
  void showBefore(const Picture& scan);
  void hideBefore();
  /// Null: it is not shown.
  BeforeView* before() const { return before_; }
  /// The entry with which the user wants it.
  QAction& beforeAfter() const;
  /// How large the 3-D view is, with the one beside it.
  QSize spaceSize() const;
  /// The picture of both, or of the 3-D view alone, as VolumeView::picture().
  QImage spacePicture(double scale);
  /// What the mouse does in all views.
  void setMouse(const MouseChoices& mouse);

  /// How the views look at the scan, and the same again.
  ViewLook look() const;
  void setLook(const ViewLook& look);
  /// The linked crosshair of the slices.
  const Eigen::Vector3d& cross_mm() const { return slices_->cross_mm(); }
  void setCross(const Eigen::Vector3d& cross_W_mm) { slices_->moveCross(cross_W_mm); }
  /// The slice that had the focus last; null: the 3-D view had it.
  SliceView* activeSlice() const;
  /// Whether a slice is in view, and so in a picture of the window.
  bool showsSlices() const;
  /// How the views are laid out, in a word for the preferences; one that is not known is left out.
  QString state() const;
  void restore(const QString& state);
  /// As at the first start.
  void reset();

 signals:
  /// The tool is to come to a place [m]. `normal_W`: unit, out of the solid there; zero if it is
  /// not known, as in a slice.
  void toolWanted(const haptics::Vec3& p_W, const haptics::Vec3& normal_W);
  void toolToCrossWanted();
  void crossToToolWanted();
  /// The user wants a picture in a file, at first of this slice, or of the 3-D view (null); or one
  /// in the clipboard.
  void pictureWanted(ui::SliceView* first);
  void pictureCopyWanted();
  /// The user chose a preset in the View menu.
  void isovalueWanted(double isovalue);
  /// The user wants no hints, in any view.
  void hintsUnwanted();
  /// The user folded the card of the force, or unfolded it.
  void cardFoldedChanged();

 private:
  ViewFrame& volumeFrame() const;

  VolumeView* volume_;
  SliceSet* slices_;
  ViewLayout* layout_;
  ViewActions* actions_ = nullptr;
  BeforeView* before_ = nullptr;
  QElapsedTimer card_placed_;
};

}  // namespace ui
