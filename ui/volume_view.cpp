// SPDX-License-Identifier: BSD-3-Clause
#include "ui/volume_view.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkMatrix4x4.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>
#include <vtkVolume.h>

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "ui/props/held_pass.h"

namespace ui {
namespace {

constexpr int kStillMs = 400;             // no movement for this long is rest
constexpr double kTurnPerWidget = 180.0;  // degrees of camera for a drag across the widget
constexpr double kHandTurn = 0.008;       // rad of hand for a pixel
constexpr double kHandStep = 0.002;       // m of depth for a notch of the wheel
constexpr double kViewAngle_deg = 30.0;
constexpr double kBeside_deg = 40.0;  // between the device and the eye, about the patient's axis

}  // namespace

/// What overlays know of the 3-D view.
class VolumeView::Geometry : public ViewGeometry {
 public:
  explicit Geometry(const VolumeView& view) : view_(view) {}

  bool isSlice() const override { return false; }
  QPointF projected(const Eigen::Vector3d& p_W_mm) const override {
    return view_.projected(p_W_mm / kMmPerM);
  }
  Eigen::Matrix3d axes() const override { return view_.viewAxes(); }
  std::optional<Eigen::Vector3d> placeUnder(QPointF at) const override {
    if (!view_.touched_.firstMet || view_.box_mm_.isEmpty()) return {};
    Eigen::Vector3d from_mm, along;
    sight(at, from_mm, along);
    const double far_mm =
        (view_.box_mm_.center() - from_mm).norm() + view_.box_mm_.diagonal().norm();
    const auto met = view_.touched_.firstMet(from_mm / kMmPerM,
                                             (from_mm + far_mm * along) / kMmPerM, view_.isovalue_);
    if (!met) return {};
    return met->p_W * kMmPerM;
  }
  Eigen::Vector3d placeBeside(QPointF at, const Eigen::Vector3d& p_W_mm) const override {
    Eigen::Vector3d from_mm, along;
    sight(at, from_mm, along);
    const Eigen::Vector3d towards = view_.viewAxes().col(2);
    return from_mm + along * (towards.dot(p_W_mm - from_mm) / towards.dot(along));
  }
  void sight(QPointF at, Eigen::Vector3d& from_W_mm, Eigen::Vector3d& along_W) const override {
    // where the pixel meets the plane through the focal point
    const Eigen::Matrix3d axes = view_.viewAxes();
    const Eigen::Vector3d focus{view_.camera_->GetFocalPoint()};
    const double mm = view_.metresPerPixel(focus / kMmPerM) * kMmPerM;
    const Eigen::Vector3d through = focus + axes.col(0) * ((at.x() - 0.5 * view_.width()) * mm) -
                                    axes.col(1) * ((at.y() - 0.5 * view_.height()) * mm);
    const Eigen::Vector3d eye{view_.camera_->GetPosition()};
    if (view_.camera_->GetParallelProjection()) {
      along_W = -axes.col(2);
      from_W_mm = through + axes.col(2) * (eye - focus).norm();
    } else {
      from_W_mm = eye;
      along_W = (through - eye).normalized();
    }
  }
  double mmPerPixel(const Eigen::Vector3d& p_W_mm) const override {
    return view_.metresPerPixel(p_W_mm / kMmPerM) * kMmPerM;
  }
  double offset_mm(const Eigen::Vector3d&) const override { return 0.0; }
  const QWidget& widget() const override { return view_; }

 private:
  const VolumeView& view_;
};

VolumeView::VolumeView(QWidget* parent)
    : Viewport(parent),
      camera_(vtkSmartPointer<vtkCamera>::New()),
      surface_layer_(vtkSmartPointer<vtkRenderer>::New()),
      proxy_layer_(vtkSmartPointer<vtkRenderer>::New()),
      overlay_layer_(vtkSmartPointer<vtkRenderer>::New()),
      held_(vtkSmartPointer<HeldPass>::New()),
      geometry_(std::make_unique<Geometry>(*this)) {
  setMouseTracking(true);
  setAccessibleName(tr("3-D view"));
  camera_->SetViewAngle(kViewAngle_deg);
  camera_->SetViewUp(0.0, 0.0, 1.0);
  surface_layer_->SetBackground(0.07, 0.08, 0.10);
  renderWindow()->SetNumberOfLayers(3);
  int layer = 0;
  for (const auto& renderer : {surface_layer_, proxy_layer_, overlay_layer_}) {
    renderer->SetLayer(layer++);
    renderer->SetActiveCamera(camera_);
    renderWindow()->AddRenderer(renderer);
  }
  // the proxy is hidden by the surface in front of it; the device never is
  proxy_layer_->PreserveDepthBufferOn();
  surface_layer_->AddVolume(surface_.rayCast());
  surface_layer_->AddActor(surface_.mesh());
  overlay_layer_->AddActor(tool_.device());
  letters_ = std::make_unique<Letters>(overlay_layer_);
  still_.setSingleShot(true);
  still_.setInterval(kStillMs);
  connect(&still_, &QTimer::timeout, this, &VolumeView::settle);
  connect(this, &Viewport::graphicsKnown, this, [this] { chooseMode(); });
}

VolumeView::~VolumeView() = default;

void VolumeView::show(const Picture& picture, double isovalue) {
  grid_ = picture.volume->grid;
  box_mm_ = boxOf_mm(grid_);
  isovalue_ = isovalue;
  surface_.show(picture);
  surface_.setIsovalue(isovalue);
  letters_->setVisible(picture.volume->orientation_known);
  hand_target_.reset();
  displayed_ = false;
  chooseMode();
  resetCamera();
}

void VolumeView::show(const haptics::TriangleMesh& tool) {
  tool_radius_ = 0.0;
  for (const haptics::Vec3& v : tool.vertices) tool_radius_ = std::max(tool_radius_, v.norm());
  tool_.show(tool);
  redraw();
}

void VolumeView::setIsovalue(double isovalue) {
  isovalue_ = isovalue;
  surface_.setIsovalue(isovalue);
  still_.start();
  redrawSurface();
}

void VolumeView::setSurfaceWish(std::optional<SurfaceMode> wish) {
  wish_ = wish;
  chooseMode();
}

void VolumeView::display(const haptics::Snapshot& snapshot) {
  last_ = snapshot;
  displayed_ = true;
  if (tool_.move(snapshot.X_WP, snapshot.X_WD)) redraw();
}

void VolumeView::setMouseHand(bool on) {
  mouse_hand_ = on;
  hand_target_.reset();
  displayed_ = false;  // the next hand starts elsewhere
}

void VolumeView::showFine(vtkPolyData* mesh, double isovalue) {
  surface_.showFine(mesh, isovalue);
  redrawSurface();
}

void VolumeView::chooseMode() {
  if (!graphics() || box_mm_.isEmpty()) return;
  const SurfaceChoice choice = chooseSurface(wish_, *graphics(), grid_);
  surface_.setMode(choice.mode);
  // the ray caster writes no depth: the proxy must be there before it. A mesh is drawn once and
  // kept, so that the proxy may move over it at no cost.
  const bool cast = choice.mode == SurfaceMode::RayCast;
  surface_layer_->RemoveActor(tool_.proxy());
  proxy_layer_->RemoveActor(tool_.proxy());
  (cast ? surface_layer_ : proxy_layer_)->AddActor(tool_.proxy());
  surface_layer_->SetPass(cast ? nullptr : held_.Get());
  still_.start();
  redrawSurface();
  emit surfaceChosen(choice);
}

void VolumeView::redrawSurface() {
  held_->forget();
  redraw();
}

void VolumeView::cameraMoved() {
  surface_.setMoving(true);
  still_.start();
  redrawSurface();
}

void VolumeView::settle() {
  surface_.setMoving(false);
  redrawSurface();
  if (surface_.mode() == SurfaceMode::Mesh && !box_mm_.isEmpty()) emit fineMeshWanted(isovalue_);
}

void VolumeView::aboutToDraw() {
  surface_.update();
  letters_->face(viewAxes().col(2));
  fitClippingRange();
}

void VolumeView::fitClippingRange() {
  if (box_mm_.isEmpty()) return;
  Eigen::AlignedBox3d box = box_mm_;
  const Eigen::Vector3d room = Eigen::Vector3d::Constant(tool_radius_ * kMmPerM + 1.0);
  if (displayed_)
    for (const haptics::Pose* X : {&last_.X_WP, &last_.X_WD}) {
      const Eigen::Vector3d p_mm = X->translation() * kMmPerM;
      box.extend(p_mm - room);
      box.extend(p_mm + room);
    }
  const Eigen::Vector3d eye{camera_->GetPosition()};
  const Eigen::Vector3d away = -viewAxes().col(2);
  const double reach = 0.65 * box.diagonal().norm();  // letters stand a little outside
  const double middle = away.dot(box.center() - eye);
  const double far_mm = std::max(middle + reach, 1.0);
  // a device that flies off must not move the planes that the kept surface was drawn between
  const double grain = std::pow(2.0, std::ceil(2.0 * std::log2(far_mm)) / 2.0);
  const double near_mm = std::max(middle - reach, grain * 0.002);
  double* range = camera_->GetClippingRange();
  const bool enough = range[0] <= near_mm && range[0] > 0.2 * near_mm && range[1] >= far_mm &&
                      range[1] < 3.0 * far_mm;
  if (enough) return;
  camera_->SetClippingRange(std::max(0.5 * near_mm, grain * 0.002), 1.5 * far_mm);
  held_->forget();
}

void VolumeView::resetCamera() {
  // from the front, head up: the patient's left on the right
  frameSurface(-Eigen::Vector3d::UnitY());
}

void VolumeView::lookFromTool() {
  if (!displayed_ || box_mm_.isEmpty()) return;
  Eigen::Vector3d from = last_.X_WD.translation() * kMmPerM - surface_.bounds_mm().center();
  if (!(from.norm() > 1e-3)) return resetCamera();
  // a little from beside, so that tool and surface are seen against each other; never from
  // straight above, where the head has no up
  from = Eigen::AngleAxisd(kBeside_deg * std::numbers::pi / 180, Eigen::Vector3d::UnitZ()) * from;
  if (std::hypot(from.x(), from.y()) < 1e-3) from.y() = -std::abs(from.z());  // then from in front
  const double level = std::hypot(from.x(), from.y());
  from.z() = std::clamp(from.z(), -0.8 * level, 0.8 * level);
  frameSurface(from.normalized());
}

void VolumeView::tell(ViewLook& look) const {
  look.eye_mm = Eigen::Vector3d{camera_->GetPosition()};
  look.focus_mm = Eigen::Vector3d{camera_->GetFocalPoint()};
  look.up = Eigen::Vector3d{camera_->GetViewUp()};
  look.parallel = camera_->GetParallelProjection() != 0;
  look.half_height_mm = camera_->GetParallelScale();
}

void VolumeView::look(const ViewLook& look) {
  camera_->SetPosition(look.eye_mm.x(), look.eye_mm.y(), look.eye_mm.z());
  camera_->SetFocalPoint(look.focus_mm.x(), look.focus_mm.y(), look.focus_mm.z());
  camera_->SetViewUp(look.up.x(), look.up.y(), look.up.z());
  camera_->SetParallelProjection(look.parallel);
  camera_->SetParallelScale(look.half_height_mm);
  cameraMoved();
}

void VolumeView::frameSurface(const Eigen::Vector3d& from) {
  if (box_mm_.isEmpty()) return;
  // the surface rather than the volume, which may be mostly air
  const Eigen::AlignedBox3d shown = surface_.bounds_mm();
  letters_->place(shown);
  const Eigen::Vector3d size = shown.sizes();
  const double aspect = static_cast<double>(std::max(1, width())) / std::max(1, height());
  const Eigen::Vector3d right = from.cross(Eigen::Vector3d::UnitZ()).normalized().cwiseAbs();
  const double half = 0.5 * std::max(size.z(), right.dot(size) / aspect) + 0.06 * size.norm();
  const double distance = 1.15 * half / std::tan(0.5 * kViewAngle_deg * std::numbers::pi / 180) +
                          0.5 * from.cwiseAbs().dot(size);
  const Eigen::Vector3d centre = shown.center();
  const Eigen::Vector3d eye = centre + from * distance;
  camera_->SetFocalPoint(centre.x(), centre.y(), centre.z());
  camera_->SetPosition(eye.x(), eye.y(), eye.z());
  camera_->SetViewUp(0.0, 0.0, 1.0);
  cameraMoved();
}

QPointF VolumeView::projected(const haptics::Vec3& p_W) const {
  const double aspect = static_cast<double>(width()) / std::max(1, height());
  vtkMatrix4x4* view = camera_->GetCompositeProjectionTransformMatrix(aspect, -1.0, 1.0);
  const Eigen::Vector3d p_mm = p_W * kMmPerM;
  const double in[4] = {p_mm.x(), p_mm.y(), p_mm.z(), 1.0};
  double out[4];
  view->MultiplyPoint(in, out);
  return {(out[0] / out[3] + 1.0) * 0.5 * width(), (1.0 - out[1] / out[3]) * 0.5 * height()};
}

Eigen::Matrix3d VolumeView::viewAxes() const {
  const Eigen::Vector3d towards =
      (Eigen::Vector3d{camera_->GetPosition()} - Eigen::Vector3d{camera_->GetFocalPoint()})
          .normalized();
  const Eigen::Vector3d right = Eigen::Vector3d{camera_->GetViewUp()}.cross(towards).normalized();
  Eigen::Matrix3d axes;
  axes << right, towards.cross(right), towards;
  return axes;
}

double VolumeView::metresPerPixel(const haptics::Vec3& p_W) const {
  const Eigen::Vector3d eye{camera_->GetPosition()};
  const double depth_mm = std::max(1.0, -viewAxes().col(2).dot(p_W * kMmPerM - eye));
  if (camera_->GetParallelProjection())
    return 2.0 * camera_->GetParallelScale() / std::max(1, height()) / kMmPerM;
  const double half = std::tan(0.5 * kViewAngle_deg * std::numbers::pi / 180.0);
  return 2.0 * depth_mm * half / std::max(1, height()) / kMmPerM;
}

void VolumeView::rotateCamera(QPointF by) {
  camera_->Azimuth(-by.x() / std::max(1, width()) * kTurnPerWidget);
  camera_->Elevation(by.y() / std::max(1, height()) * kTurnPerWidget);
  camera_->OrthogonalizeViewUp();
  cameraMoved();
}

void VolumeView::panCamera(QPointF by) {
  const Eigen::Vector3d focus{camera_->GetFocalPoint()};
  const double mm = metresPerPixel(focus / kMmPerM) * kMmPerM;
  const Eigen::Matrix3d axes = viewAxes();
  const Eigen::Vector3d shift = (-by.x() * axes.col(0) + by.y() * axes.col(1)) * mm;
  const Eigen::Vector3d eye = Eigen::Vector3d{camera_->GetPosition()} + shift;
  const Eigen::Vector3d aim = focus + shift;
  camera_->SetPosition(eye.x(), eye.y(), eye.z());
  camera_->SetFocalPoint(aim.x(), aim.y(), aim.z());
  cameraMoved();
}

void VolumeView::zoomCamera(double factor) {
  camera_->Dolly(factor);
  cameraMoved();
}

haptics::Pose& VolumeView::handTarget() {
  if (!hand_target_) hand_target_ = last_.X_WD;
  return *hand_target_;
}

void VolumeView::moveHand(QPointF by, bool turn) {
  haptics::Pose& X_WH = handTarget();
  const Eigen::Matrix3d axes = viewAxes();
  if (turn) {
    const Eigen::Vector3d about = axes.col(0) * by.y() + axes.col(1) * by.x();
    const double angle = about.norm() * kHandTurn;
    if (angle > 0.0)
      X_WH.linear() = (Eigen::AngleAxisd(angle, about.normalized()) * haptics::rotationOf(X_WH))
                          .toRotationMatrix();
  } else {
    const double m = metresPerPixel(X_WH.translation());
    X_WH.translation() += (by.x() * axes.col(0) - by.y() * axes.col(1)) * m;
  }
  emit handPulled(X_WH);
}

void VolumeView::paintGL() {
  Viewport::paintGL();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  overlays_.paint(painter, *geometry_);
}

void VolumeView::mousePressEvent(QMouseEvent* event) {
  last_mouse_ = event->position();
  event->accept();
  overlays_.press(*geometry_, *event);
}

void VolumeView::mouseReleaseEvent(QMouseEvent* event) { overlays_.release(*geometry_, *event); }

void VolumeView::mouseDoubleClickEvent(QMouseEvent* event) {
  if (!overlays_.doubleClick(*geometry_, *event)) mousePressEvent(event);
}

void VolumeView::mouseMoveEvent(QMouseEvent* event) {
  const QPointF by = event->position() - last_mouse_;
  last_mouse_ = event->position();
  if (overlays_.move(*geometry_, *event)) return;
  if (event->buttons() & Qt::LeftButton) {
    if (mouse_hand_ && displayed_)
      moveHand(by, event->modifiers() & Qt::ShiftModifier);
    else
      rotateCamera(by);
  } else if (event->buttons() & Qt::RightButton) {
    rotateCamera(by);
  } else if (event->buttons() & Qt::MiddleButton) {
    panCamera(by);
  }
}

void VolumeView::wheelEvent(QWheelEvent* event) {
  const double notches = event->angleDelta().y() / 120.0;
  if (mouse_hand_ && displayed_ && !(event->modifiers() & Qt::ControlModifier)) {
    haptics::Pose& X_WH = handTarget();
    X_WH.translation() -= viewAxes().col(2) * (notches * kHandStep);
    emit handPulled(X_WH);
  } else {
    zoomCamera(std::pow(1.1, notches));
  }
  event->accept();
}

void VolumeView::keyPressEvent(QKeyEvent* event) {
  if (event->key() != Qt::Key_Space && overlays_.key(*geometry_, *event)) return;
  switch (event->key()) {
    case Qt::Key_Space:
      emit forceOffWanted();
      break;
    case Qt::Key_R:
      resetCamera();
      break;
    case Qt::Key_T:
      lookFromTool();
      break;
    case Qt::Key_C:
      emit clutchHeld(true);
      break;
    case Qt::Key_H:
      emit forceHeld(true);
      break;
    default:
      Viewport::keyPressEvent(event);
  }
}

void VolumeView::keyReleaseEvent(QKeyEvent* event) {
  // a key that is held repeats itself as releases and presses
  if (event->isAutoRepeat()) return Viewport::keyReleaseEvent(event);
  if (event->key() == Qt::Key_C)
    emit clutchHeld(false);
  else if (event->key() == Qt::Key_H)
    emit forceHeld(false);
  else
    Viewport::keyReleaseEvent(event);
}

void VolumeView::focusOutEvent(QFocusEvent* event) {
  // the release would go elsewhere
  emit clutchHeld(false);
  emit forceHeld(false);
  Viewport::focusOutEvent(event);
}

}  // namespace ui
