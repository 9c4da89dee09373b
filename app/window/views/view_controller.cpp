// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/views/view_controller.h"

#include <QBuffer>
#include <QClipboard>
#include <QDateTime>
#include <QFileDialog>
#include <QFileInfo>
#include <QGuiApplication>
#include <QStatusBar>
#include <algorithm>
#include <array>
#include <limits>

#include "app/film/face.h"
#include "app/window/scan/tool_place.h"
#include "haptics/core/budget.h"
#include "haptics/process/output_file.h"
#include "haptics/scene/legal_pose.h"
#include "ui/dialogs/save_dialog.h"
#include "ui/views/slice_readout.h"
#include "ui/views/volume_view.h"

namespace app {
namespace {

constexpr int kPictureSaidMs = 6000;
constexpr std::array kLifts{0.02, 0.04, 0.08, 0.16};  // m
constexpr double kRestForce = 0.3;        // N, of a tool that was brought to the surface
constexpr double kLeastStiffness = 50.0;  // N/m: a softer spring is not pressed farther

/// What is in a picture and when it was taken, never of whom.
QString pictureName(const ui::ScreenshotWish& wish) {
  QString what = ViewController::tr("3-D view");
  if (wish.slice) what = wish.slice->readout().name;
  if (wish.whole_window) what = ViewController::tr("window");
  return "palpate " + what + " " + QDateTime::currentDateTime().toString("yyyy-MM-dd hh.mm") +
         ".png";
}

}  // namespace

ViewController::ViewController(ui::MainWindow& window, SharedState& shared)
    : window_(window), views_(window.views()), messages_(window.messages()), shared_(shared) {
  connect(&window.views(), &ui::Views::toolWanted, this, &ViewController::bringTool);
  connect(&window.views(), &ui::Views::toolToCrossWanted, this, &ViewController::bringToCross);
  connect(&window.views(), &ui::Views::crossToToolWanted, this, &ViewController::moveCrossToTool);
  connect(&window.views(), &ui::Views::pictureWanted, this, &ViewController::savePicture);
  connect(&window.views(), &ui::Views::pictureCopyWanted, this, &ViewController::copyPicture);
}

bool ViewController::mayBring() {
  if (!shared_.shown) return false;
  if (!shared_.replaying) return true;
  messages_.showBriefly(tr("The tool shows a recording; close the replay to move it."),
                        kPictureSaidMs);
  return false;
}

void ViewController::bringTool(const haptics::Vec3& p_W, const haptics::Vec3& normal_W) {
  if (!mayBring()) return;
  const haptics::Scene& scene = *shared_.shown->scene;
  const double isovalue = shared_.settings.isovalue;
  std::optional<ui::SurfacePlace> place = ui::SurfacePlace{p_W, normal_W};
  if (normal_W.isZero()) place = nearestSurface(scene, isovalue, p_W);
  if (!place)
    return messages_.showBriefly(
        tr("There is no surface within 30 mm of this place; lower the isovalue, or choose another "
           "place."),
        kPictureSaidMs);
  const auto X_WT = poseAt(scene, isovalue, *place, shared_.snapshot.X_WP);
  if (!X_WT)
    return messages_.showBriefly(
        tr("The tool does not fit there: it stays where it is. Choose a smaller tool, or a place "
           "with more room."),
        kPictureSaidMs);
  // the mouse goes on until the tip bears on the surface
  const double press = kRestForce / std::max(shared_.settings.stiffness, kLeastStiffness);
  haptics::Pose X_WH = *X_WT;
  X_WH.translation() += place->p_W - press * place->normal_W - *X_WT * scene.tool.shell.tip;
  emit toolPlaced(*X_WT, X_WH);
  views_.setCross(place->p_W * ui::kMmPerM);
}

void ViewController::bringBack(const haptics::Pose& X_WP) {
  if (!mayBring()) return;
  const auto X_WT = haptics::legalPoseNear(*shared_.shown->scene, shared_.settings.isovalue, X_WP);
  if (X_WT) return emit toolPlaced(*X_WT, *X_WT);
  messages_.showBriefly(tr("The tool does not fit where it was: it stays where it is."),
                        kPictureSaidMs);
}

void ViewController::bringToCross() {
  if (!mayBring()) return;
  const haptics::Scene& scene = *shared_.shown->scene;
  const double isovalue = shared_.settings.isovalue;
  const haptics::Vec3 cross_W = views_.cross_mm() / ui::kMmPerM;
  // in the open the tip goes to the very place, and the tool keeps its direction
  haptics::Pose X_WT = shared_.snapshot.X_WP;
  X_WT.translation() = cross_W - X_WT.linear() * scene.tool.shell.tip;
  const haptics::Isosurface solid{scene.field, isovalue};
  haptics::Budget unlimited = haptics::Budget::counted(std::numeric_limits<std::int64_t>::max());
  if (haptics::legal(solid, scene.tool.shell, X_WT, unlimited)) return emit toolPlaced(X_WT, X_WT);
  bringTool(cross_W, haptics::Vec3::Zero());
}

void ViewController::liftTool() {
  if (!mayBring()) return;
  const haptics::Scene& scene = *shared_.shown->scene;
  const haptics::Isosurface solid{scene.field, shared_.settings.isovalue};
  for (const double by : kLifts) {
    haptics::Pose X_WT = shared_.snapshot.X_WP;
    X_WT.translation() += X_WT.linear().col(2) * by;  // towards the handle
    haptics::Budget unlimited = haptics::Budget::counted(std::numeric_limits<std::int64_t>::max());
    if (haptics::legal(solid, scene.tool.shell, X_WT, unlimited)) return emit toolLifted(X_WT);
  }
  emit toolLifted(shared_.shown->start);
}

void ViewController::moveCrossToTool() {
  if (!shared_.shown || shared_.snapshot.scene != shared_.shown->scene->id) return;
  const haptics::Vec3 tip_W = shared_.snapshot.X_WP * shared_.shown->scene->tool.shell.tip;
  views_.setCross(tip_W * ui::kMmPerM);
}

bool ViewController::mayLeave(bool with_slices) {
  const std::optional<Loaded>& shown = shared_.shown;
  if (!shown || shown->place.empty()) return true;
  const double isovalue = shared_.settings.isovalue;
  double least = std::min(isovalue, views_.volume().surface().second().value_or(isovalue));
  // a slice shows the skin whatever the isovalue, and may be a profile
  if (with_slices) least = shown->volume()->least;
  return !mayShowAFace(*shown->volume(), least) ||
         messages_.askWhether(
             tr("This picture may show a face."),
             with_slices ? tr("Slices show the skin, and a profile can be recognised. Take "
                              "a picture of the 3-D view alone at the isovalue of bone, or "
                              "give this one only to people with permission to see it.")
                         : tr("At its isovalues skin may be drawn, and a face can be recognised. "
                              "Choose isovalues of bone, for a second surface too, or give the "
                              "picture only to people with permission to see it."),
             tr("Take the picture"));
}

void ViewController::savePicture(const ui::SliceView* first) {
  const auto wish = ui::askForScreenshot(window_, views_, first);
  if (!wish || !mayLeave(wish->slice || (wish->whole_window && views_.showsSlices()))) return;
  // before the next dialog lies over the window
  const QImage picture = ui::screenshotOf(window_, views_, *wish);
  if (picture.isNull())
    return messages_.showMessage(
        tr("The graphics cannot draw a picture of this size; choose a smaller one."));
  QFileDialog dialog(&window_, tr("Save picture as"));
  ui::askForOutput(dialog, tr("Picture (*.png)"), "png");
  dialog.selectFile(pictureName(*wish));
  if (dialog.exec() != QDialog::Accepted) return;
  const QString path = dialog.selectedFiles().value(0);
  // pixels alone: nothing that names anybody is put beside them
  QBuffer bytes;
  const bool drawn = picture.save(&bytes, "PNG");
  if (!drawn || !haptics::writeFile(path.toStdString(),
                                    {bytes.data().constData(), std::size_t(bytes.data().size())}))
    return messages_.showMessage(
        tr("'%1' was not written; choose a folder with room that you may write to.").arg(path));
  const QFileInfo file(path);
  messages_.showDone(tr("The picture was saved as \"%1\".").arg(file.fileName()),
                     file.absolutePath());
}

void ViewController::copyPicture() {
  if (!mayLeave(false)) return;
  const QImage picture = ui::screenshotOf(window_, views_, {.scale = ui::screenScaleOf(window_)});
  if (picture.isNull()) return;
  QGuiApplication::clipboard()->setImage(picture);
  messages_.showBriefly(tr("The picture of the 3-D view was copied."), kPictureSaidMs);
}

}  // namespace app
