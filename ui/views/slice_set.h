// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QMenu>
#include <QObject>
#include <QTimer>
#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "haptics/core/triangle_mesh.h"
#include "haptics/snapshot.h"
#include "ui/props/picture.h"
#include "ui/views/grey_presets.h"
#include "ui/views/slice_view.h"

class QAction;
class QActionGroup;

namespace ui {

/// The four slices and what they have in common: the crosshair, the grey window, how voxels become
/// a picture, the contour, the plane that goes with the tool. It holds the menu of these.
class SliceSet : public QObject {
  Q_OBJECT
 public:
  explicit SliceSet(QWidget* parent);

  SliceView& slice(Plane plane) { return *slices_[static_cast<std::size_t>(plane)]; }
  const std::array<SliceView*, 4>& slices() const { return slices_; }
  /// Shows the body in all of them, as large as it can be.
  void fitBody();
  /// The choices for all slices, as a menu. The View menu has it, and every slice.
  QMenu& menu() { return *menu_; }
  /// Opens it over a slice, which gets the focus.
  void openMenu(SliceView& over, QPoint at);

  /// `stated`: the grey windows that the file states. The slices begin with the first of them.
  void show(const Picture& picture, double isovalue, const std::vector<GreyPreset>& stated = {});
  /// Shows other voxels on the same grid; crosshair, zoom and grey stay.
  void replace(const Picture& picture);
  /// Shows these voxels of the same grid, which change from now on, as carve() says.
  void showLive(const haptics::Volume& voxels);
  void carve();
  /// The volume is this one now; its voxels are on view already.
  void renew(std::shared_ptr<const haptics::Volume> volume);
  void show(const haptics::TriangleMesh& tool);
  void setTouched(const TouchedSurface& touched);
  void addOverlay(Overlay& overlay);
  void show(const Structures& structures);
  void setIsovalue(double isovalue);
  void display(const haptics::Snapshot& snapshot);
  void moveCross(const Eigen::Vector3d& cross_W_mm);
  const Eigen::Vector3d& cross_mm() const { return cross_mm_; }
  void setGrey(const GreyWindow& grey);
  /// Whether the crosshair goes with the tool's tip while the tool moves.
  bool follows() const;
  void setFollowing(bool on);
  const GreyWindow& grey() const { return grey_; }
  /// Writes crosshair, grey window, voxels, the tool's plane and what is seen of each slice.
  void tell(ViewLook& look) const;
  /// Takes these of `look`.
  void look(const ViewLook& look);
  bool obliqueShown() const;
  void setObliqueShown(bool shown);

 signals:
  void crossMoved(const Eigen::Vector3d& cross_W_mm);
  void followingChanged(bool on);
  /// The user chose this grey window.
  void greyChosen(const ui::GreyWindow& grey);
  /// The view that goes with the tool shall be seen, or not.
  void obliqueShownChanged(bool shown);
  /// A place in a slice was clicked twice.
  void doubleClicked(const Eigen::Vector3d& p_W_mm);
  /// A picture of one slice is wanted.
  void pictureWanted();

 private:
  QAction* toggle(const QString& text, const char* name, bool on,
                  const std::function<void(bool)>& set);
  void buildMenu();
  void buildGreyMenu();
  void offerStated();
  void buildLookMenu();
  void setLook(const SliceLook& look);
  void showLook();
  void askThickness();
  void askGrey();
  void takeGrey(Action which);
  void chooseGrey(const GreyWindow& grey);
  /// The user moved the crosshair: it stays there until the tool has moved some way.
  void holdCross(const Eigen::Vector3d& cross_W_mm);
  Eigen::Vector3d tip_mm() const;
  void linkPlanes();
  void placeOblique();
  void followTool();

  std::array<SliceView*, 4> slices_{};
  QMenu* menu_;
  QMenu* grey_menu_ = nullptr;
  QList<QAction*> presets_;         ///< in HU
  QList<QAction*> stated_actions_;  ///< one for each of `stated_`
  std::vector<GreyPreset> stated_;  ///< by the file of the volume
  QActionGroup* interpolations_ = nullptr;
  QActionGroup* slabs_ = nullptr;
  QActionGroup* thicknesses_ = nullptr;
  QActionGroup* directions_ = nullptr;  ///< of the oblique plane
  QAction* oblique_ = nullptr;
  std::shared_ptr<const haptics::Volume> volume_;
  Eigen::AlignedBox3d box_mm_;
  Eigen::Vector3d cross_mm_ = Eigen::Vector3d::Zero();
  GreyWindow grey_;
  SliceLook look_;
  bool crosshair_ = true;
  QAction* follow_ = nullptr;
  std::optional<Eigen::Vector3d> followed_mm_;  ///< where the tip was when the crosshair went to it
  bool held_ = false;                           ///< the user moved the crosshair since
  std::uint64_t scene_ = 0;                     ///< of the last snapshot
  QTimer follow_pause_;                         ///< runs after the crosshair went with the tool
  bool along_ = false;     ///< the oblique plane holds the tool's axis, else it is normal to it
  double depth_mm_ = 0.0;  ///< of the oblique plane from the tip, along its normal
  haptics::Vec3 tip_T_ = haptics::Vec3::Zero();  ///< m, tool frame
  std::optional<haptics::Pose> X_WP_;
  std::optional<haptics::Pose> placed_;     ///< where the oblique plane was placed
  std::optional<Eigen::Vector3d> right_W_;  ///< of the oblique picture, as it was last
};

}  // namespace ui
