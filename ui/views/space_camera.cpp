// SPDX-License-Identifier: BSD-3-Clause
#include "ui/views/space_camera.h"

#include <vtkCamera.h>
#include <vtkMatrix4x4.h>

#include <QWidget>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace ui {
namespace {

constexpr double kTurnPerWidget = 180.0;  // degrees for a drag across the widget
constexpr double kViewAngle_deg = 30.0;
constexpr double kMargin = 1.08, kLetterMargin = 1.04;  // of what is framed, and beside letters
// px, at the edges, where letters stand: two beside each other, or one line
constexpr double kSideOfLetters = 48.0, kEndOfLetters = 30.0;
const double kHalf = std::tan(0.5 * kViewAngle_deg * std::numbers::pi / 180.0);
constexpr double kSeenAtLeast = 0.6;  // of the most that is seen of a box from anywhere

}  // namespace

Eigen::Vector3d firstDirection(const Eigen::Vector3d& sizes) {
  const Eigen::Vector3d from = Eigen::Vector3d{0.45, -0.8, 0.4}.normalized();
  // how much of a box is seen from a direction: its sides, each by how much it faces there
  const Eigen::Vector3d sides{sizes.y() * sizes.z(), sizes.z() * sizes.x(), sizes.x() * sizes.y()};
  if (sides.dot(from.cwiseAbs()) >= kSeenAtLeast * sides.norm()) return from;
  return (from + 2.0 * sides.normalized().cwiseProduct(from.cwiseSign())).normalized();
}

SpaceCamera::SpaceCamera(const QWidget& view)
    : view_(view), camera_(vtkSmartPointer<vtkCamera>::New()) {
  camera_->SetViewAngle(kViewAngle_deg);
  camera_->SetViewUp(0.0, 0.0, 1.0);
}

vtkCamera* SpaceCamera::vtk() const { return camera_; }
bool SpaceCamera::isParallel() const { return camera_->GetParallelProjection() != 0; }

QPointF SpaceCamera::projected(const Eigen::Vector3d& p_mm) const {
  const double aspect = static_cast<double>(view_.width()) / std::max(1, view_.height());
  vtkMatrix4x4* view = camera_->GetCompositeProjectionTransformMatrix(aspect, -1.0, 1.0);
  const double in[4] = {p_mm.x(), p_mm.y(), p_mm.z(), 1.0};
  double out[4];
  view->MultiplyPoint(in, out);
  return {(out[0] / out[3] + 1.0) * 0.5 * view_.width(),
          (1.0 - out[1] / out[3]) * 0.5 * view_.height()};
}

Eigen::Matrix3d SpaceCamera::axes() const {
  const Eigen::Vector3d towards =
      (Eigen::Vector3d{camera_->GetPosition()} - Eigen::Vector3d{camera_->GetFocalPoint()})
          .normalized();
  const Eigen::Vector3d right = Eigen::Vector3d{camera_->GetViewUp()}.cross(towards).normalized();
  Eigen::Matrix3d axes;
  axes << right, towards.cross(right), towards;
  return axes;
}

double SpaceCamera::mmPerPixel(const Eigen::Vector3d& p_mm) const {
  const int height = std::max(1, view_.height());
  if (isParallel()) return 2.0 * camera_->GetParallelScale() / height;
  const Eigen::Vector3d eye{camera_->GetPosition()};
  const double depth_mm = std::max(1.0, -axes().col(2).dot(p_mm - eye));
  return 2.0 * depth_mm * kHalf / height;
}

void SpaceCamera::sight(QPointF at, Eigen::Vector3d& from_mm, Eigen::Vector3d& along) const {
  // where the pixel meets the plane through the focal point
  const Eigen::Matrix3d axes = this->axes();
  const Eigen::Vector3d focus{camera_->GetFocalPoint()}, eye{camera_->GetPosition()};
  const double mm = mmPerPixel(focus);
  const Eigen::Vector3d through = focus + axes.col(0) * ((at.x() - 0.5 * view_.width()) * mm) -
                                  axes.col(1) * ((at.y() - 0.5 * view_.height()) * mm);
  if (isParallel()) {
    along = -axes.col(2);
    from_mm = through + axes.col(2) * (eye - focus).norm();
  } else {
    from_mm = eye;
    along = (through - eye).normalized();
  }
}

Eigen::Vector3d SpaceCamera::placeBeside(QPointF at, const Eigen::Vector3d& p_mm) const {
  Eigen::Vector3d from_mm, along;
  sight(at, from_mm, along);
  const Eigen::Vector3d towards = axes().col(2);
  return from_mm + along * (towards.dot(p_mm - from_mm) / towards.dot(along));
}

void SpaceCamera::set(const Eigen::Vector3d& eye_mm, const Eigen::Vector3d& focus_mm) {
  camera_->SetFocalPoint(focus_mm.x(), focus_mm.y(), focus_mm.z());
  camera_->SetPosition(eye_mm.x(), eye_mm.y(), eye_mm.z());
}

void SpaceCamera::rotate(QPointF by) {
  camera_->Azimuth(-by.x() / std::max(1, view_.width()) * kTurnPerWidget);
  camera_->Elevation(by.y() / std::max(1, view_.height()) * kTurnPerWidget);
  camera_->OrthogonalizeViewUp();
}

void SpaceCamera::pan(QPointF by) {
  const Eigen::Vector3d focus{camera_->GetFocalPoint()}, eye{camera_->GetPosition()};
  const Eigen::Matrix3d axes = this->axes();
  const Eigen::Vector3d shift = (-by.x() * axes.col(0) + by.y() * axes.col(1)) * mmPerPixel(focus);
  set(eye + shift, focus + shift);
}

void SpaceCamera::zoom(double factor, const Eigen::Vector3d& at_mm) {
  const Eigen::Vector3d focus{camera_->GetFocalPoint()}, eye{camera_->GetPosition()};
  const Eigen::Vector3d aim = at_mm + (focus - at_mm) / factor;
  if (isParallel()) {
    // in depth nothing changes: the viewer stays in front of everything
    const Eigen::Vector3d towards = axes().col(2);
    const Eigen::Vector3d beside = aim - towards * towards.dot(aim - focus);
    camera_->SetParallelScale(camera_->GetParallelScale() / factor);
    set(beside + (eye - focus), beside);
  } else {
    set(at_mm + (eye - at_mm) / factor, aim);
  }
}

void SpaceCamera::frame(std::vector<Eigen::Vector3d> outline_mm, const Eigen::Vector3d& from,
                        const Eigen::Vector3d& up) {
  const Eigen::Vector3d right = up.cross(from).normalized();
  Eigen::Matrix3d axes;
  axes << right, from.cross(right), from;
  fit(std::move(outline_mm), axes);
  camera_->SetViewUp(up.x(), up.y(), up.z());
  camera_->OrthogonalizeViewUp();
}

bool SpaceCamera::refit() {
  const double before = half_mm();
  if (!fit_ || std::abs(before - fit_->half_mm) > 1e-6 * before) return false;
  fit(std::move(fit_->outline_mm), axes());
  return std::abs(half_mm() - before) > 1e-6 * before;
}

void SpaceCamera::fit(std::vector<Eigen::Vector3d> outline_mm, const Eigen::Matrix3d& axes) {
  // along right, up and towards the viewer
  Eigen::AlignedBox3d taken_mm;
  for (const Eigen::Vector3d& p_mm : outline_mm) taken_mm.extend(axes.transpose() * p_mm);
  const Eigen::Vector3d reach = 0.5 * taken_mm.sizes(), centre_mm = axes * taken_mm.center();
  const double width = std::max(1, view_.width()), height = std::max(1, view_.height());
  const double about =
      kMargin * (std::max(reach.y(), reach.x() * height / width) + 0.03 * taken_mm.sizes().norm());
  // beside the letters at the edges, but in a tiny view
  const double room_x = std::max(0.5 * width, width - 2.0 * kSideOfLetters);
  const double room_y = std::max(0.5 * height, height - 2.0 * kEndOfLetters);
  // the body reaches farther than the places of its outline, which lie in few directions
  const double half = std::max(
      about, kLetterMargin * std::max(reach.y() * height / room_y, reach.x() * height / room_x));
  // without perspective the middle is as large as the front is with it
  camera_->SetParallelScale(half);
  set(centre_mm + axes.col(2) * (half / kHalf + reach.z()), centre_mm);
  fit_ = Fit{std::move(outline_mm), half_mm()};
}

double SpaceCamera::half_mm() const {
  if (isParallel()) return camera_->GetParallelScale();
  return camera_->GetDistance() * kHalf;
}

void SpaceCamera::lookAt(const Eigen::Vector3d& p_mm, const Eigen::Vector3d& from,
                         const Eigen::Vector3d& up, double distance_mm,
                         const Eigen::AlignedBox3d& box_mm) {
  keep();
  const bool parallel = isParallel();
  camera_->SetParallelProjection(0);
  set(p_mm + from * distance_mm, p_mm);
  camera_->SetViewUp(up.x(), up.y(), up.z());
  camera_->OrthogonalizeViewUp();
  setParallel(parallel, box_mm);
}

void SpaceCamera::take(const SpaceCamera& other) {
  vtkCamera& of = *other.camera_;
  set(Eigen::Vector3d{of.GetPosition()}, Eigen::Vector3d{of.GetFocalPoint()});
  camera_->SetViewUp(of.GetViewUp());
  camera_->SetParallelProjection(of.GetParallelProjection());
  camera_->SetParallelScale(of.GetParallelScale());
}

double SpaceCamera::distance() const { return camera_->GetParallelScale() / kHalf; }

void SpaceCamera::setParallel(bool parallel, const Eigen::AlignedBox3d& box_mm) {
  if (parallel == isParallel()) return;
  const Eigen::Vector3d focus{camera_->GetFocalPoint()}, towards = axes().col(2);
  double away = distance();
  if (parallel) {
    away = (Eigen::Vector3d{camera_->GetPosition()} - focus).norm();
    camera_->SetParallelScale(away * kHalf);
    if (!box_mm.isEmpty())
      away = std::max(away, (box_mm.center() - focus).norm() + box_mm.diagonal().norm());
  }
  camera_->SetParallelProjection(parallel ? 1 : 0);
  set(focus + towards * away, focus);
}

}  // namespace ui
