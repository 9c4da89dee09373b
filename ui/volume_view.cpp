// SPDX-License-Identifier: BSD-3-Clause
#include "ui/volume_view.h"

#include <vtkActor.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkVolume.h>

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "ui/props/held_pass.h"
#include "ui/props/veil_pass.h"
#include "ui/style/scene_colours.h"

namespace ui {
namespace {

// of a surface in motion, on software graphics
constexpr std::int64_t kMovingTriangles = 80'000;
constexpr int kStillMs = 400;            // no movement for this long is rest
constexpr double kHandTurn = 0.008;      // rad of hand for a pixel
constexpr double kHandStep = 0.002;      // m of depth for a notch of the wheel
constexpr double kViewZoomNotch = 1.1;   // nearer for a notch of the wheel
constexpr double kZoomPixel = 1.006;     // nearer for a pixel of a drag
constexpr double kBeside_deg = 40.0;     // between the device and the eye, about the patient's axis
constexpr double kTurnKey = 1.0 / 36.0;  // of the view, as a drag: 5 degrees
constexpr double kShiftKey = 24.0;       // px
constexpr double kGrab = 8.0;            // px about the tool that count as on it
constexpr double kVeil = 0.38;           // opacity of the second surface
constexpr double kBehindTool_mm = 120.0;                 // of the eye, looking along the tool
constexpr double kLetterSide = 28.0, kLetterEnd = 20.0;  // px, at the edges, where letters stand
constexpr double kContactMark = 5.0;                     // px, radius
constexpr double kArrowOfHeight = 0.25;                  // of the view's height, for kArrowForce
constexpr double kArrowForce = 5.0;                      // N
constexpr double kLeastForce = 0.02;                     // N: less is not shown
using style::kViewGround;

double fromSegment(QPointF p, QPointF a, QPointF b) {
  const QPointF along = b - a;
  const double length = QPointF::dotProduct(along, along);
  const double share =
      length > 0.0 ? std::clamp(QPointF::dotProduct(p - a, along) / length, 0.0, 1.0) : 0.0;
  return std::hypot(p.x() - a.x() - share * along.x(), p.y() - a.y() - share * along.y());
}

/// Whether a point lies in a triangle, whichever way round its corners go.
bool isWithin(QPointF p, QPointF a, QPointF b, QPointF c) {
  const auto side = [](QPointF u, QPointF v, QPointF w) {
    return (v.x() - u.x()) * (w.y() - u.y()) - (v.y() - u.y()) * (w.x() - u.x());
  };
  const double x = side(a, b, p), y = side(b, c, p), z = side(c, a, p);
  return (x >= 0.0 && y >= 0.0 && z >= 0.0) || (x <= 0.0 && y <= 0.0 && z <= 0.0);
}

}  // namespace

/// What overlays know of the 3-D view.
class VolumeView::Geometry : public ViewGeometry {
 public:
  explicit Geometry(const VolumeView& view) : view_(view) {}

  bool isSlice() const override { return false; }
  QPointF projected(const Eigen::Vector3d& p_W_mm) const override {
    return view_.camera_.projected(p_W_mm);
  }
  Eigen::Matrix3d axes() const override { return view_.viewAxes(); }
  std::optional<Eigen::Vector3d> placeUnder(QPointF at) const override {
    const auto met = view_.surfaceUnder(at);
    if (!met) return {};
    return met->p_W * kMmPerM;
  }
  Eigen::Vector3d placeBeside(QPointF at, const Eigen::Vector3d& p_W_mm) const override {
    return view_.camera_.placeBeside(at, p_W_mm);
  }
  void sight(QPointF at, Eigen::Vector3d& from_W_mm, Eigen::Vector3d& along_W) const override {
    view_.camera_.sight(at, from_W_mm, along_W);
  }
  double mmPerPixel(const Eigen::Vector3d& p_W_mm) const override {
    return view_.camera_.mmPerPixel(p_W_mm);
  }
  double offset_mm(const Eigen::Vector3d&) const override { return 0.0; }
  const QWidget& widget() const override { return view_; }
  QRectF room() const override {
    return QRectF(view_.rect()).adjusted(kLetterSide, kLetterEnd, -kLetterSide, -kLetterEnd);
  }

 private:
  const VolumeView& view_;
};

VolumeView::VolumeView(QWidget* parent)
    : Viewport(parent),
      surface_layer_(vtkSmartPointer<vtkRenderer>::New()),
      proxy_layer_(vtkSmartPointer<vtkRenderer>::New()),
      veil_layer_(vtkSmartPointer<vtkRenderer>::New()),
      overlay_layer_(vtkSmartPointer<vtkRenderer>::New()),
      held_(vtkSmartPointer<HeldPass>::New()),
      veil_(vtkSmartPointer<VeilPass>::New()),
      geometry_(std::make_unique<Geometry>(*this)) {
  offerSpoken();
  setMouseTracking(true);
  setAccessibleName(tr("3-D view"));
  surface_layer_->SetBackground(kViewGround.redF(), kViewGround.greenF(), kViewGround.blueF());
  renderWindow()->SetNumberOfLayers(4);
  int layer = 0;
  for (const auto& renderer : {surface_layer_, proxy_layer_, veil_layer_, overlay_layer_}) {
    renderer->SetLayer(layer++);
    renderer->SetActiveCamera(camera_.vtk());
    renderWindow()->AddRenderer(renderer);
  }
  // surface and veil hide the proxy behind them; the device is never hidden
  proxy_layer_->PreserveDepthBufferOn();
  veil_layer_->PreserveDepthBufferOn();
  veil_layer_->SetPass(veil_);
  veil_->setOpacity(kVeil);
  surface_layer_->AddVolume(surface_.rayCast());
  surface_layer_->AddActor(surface_.mesh());
  veil_layer_->AddActor(surface_.secondMesh());
  veil_layer_->DrawOff();
  overlay_layer_->AddActor(tool_.device());
  tool_.showDeviceOnlyApart();
  still_.setSingleShot(true);
  still_.setInterval(kStillMs);
  connect(&still_, &QTimer::timeout, this, &VolumeView::settle);
  connect(this, &Viewport::graphicsKnown, this, [this] { chooseMode(); });
  whenKeysChange(*this, [this] { emit hintChanged(hint()); });
}

VolumeView::~VolumeView() = default;

void VolumeView::show(const Picture& picture, double isovalue) {
  grid_ = picture.volume->grid;
  box_mm_ = boxOf_mm(*picture.volume);
  isovalue_ = isovalue;
  surface_.show(picture);
  surface_.setIsovalue(isovalue);
  orientation_known_ = picture.volume->orientation_known;
  setSecondSurface({});
  hand_target_.reset();
  displayed_ = false;
  chooseMode();
  resetCamera();
}

void VolumeView::replace(const Picture& picture) {
  box_mm_ = boxOf_mm(*picture.volume);
  surface_.replace(picture);
  still_.start();
  redrawSurface();
}

void VolumeView::show(const haptics::TriangleMesh& tool) {
  tool_radius_ = 0.0;
  for (const haptics::Vec3& v : tool.vertices) tool_radius_ = std::max(tool_radius_, v.norm());
  tool_.show(tool);
  tool_mesh_ = tool;
  redraw();
}

void VolumeView::setIsovalue(double isovalue) {
  isovalue_ = isovalue;
  surface_.setIsovalue(isovalue);
  still_.start();
  redrawSurface();
}

void VolumeView::setColouring(const Colouring& colouring) {
  surface_.setColouring(colouring);
  redrawSurface();
}

void VolumeView::setSecondSurface(std::optional<double> isovalue) {
  surface_.setSecond(isovalue);
  veil_layer_->SetDraw(isovalue.has_value());
  redrawSurface();
}

void VolumeView::showContacts(bool on) {
  contacts_shown_ = on;
  update();
}

QString VolumeView::spokenName() const {
  const auto& volume = picture().volume;
  if (volume == nullptr) return tr("%1: nothing is open").arg(accessibleName());
  QString isovalue = QString::number(isovalue_, 'g', 6);
  if (!volume->unit.empty()) isovalue += ' ' + QString::fromStdString(volume->unit);
  return tr("%1: surface at %2").arg(accessibleName(), isovalue);
}

void VolumeView::setSurfaceWish(std::optional<SurfaceMode> wish) {
  wish_ = wish;
  chooseMode();
}

void VolumeView::display(const haptics::Snapshot& snapshot) {
  const double change = (snapshot.felt_W.force - last_.felt_W.force).norm();
  const bool touched = snapshot.contacts > 0 || last_.contacts > 0;
  if (displayed_ && contacts_shown_ && touched && change < kLeastForce &&
      snapshot.contacts == last_.contacts) {
    // the arrow stays as it is until the force differs visibly
    const haptics::Wrench felt = last_.felt_W;
    last_ = snapshot;
    last_.felt_W = felt;
  } else {
    last_ = snapshot;
    if (contacts_shown_ && touched) update();
  }
  displayed_ = true;
  if (tool_.move(snapshot.X_WP, snapshot.X_WD)) redraw();
}

void VolumeView::setMouseHand(bool on) {
  const bool begins = on && !mouse_hand_;
  mouse_hand_ = on;
  hand_target_.reset();
  displayed_ = false;  // the next hand starts elsewhere
  if (!on) setMouseMode(MouseMode::Look);
  emit mouseHandChanged(on);
  if (begins) setMouseMode(mouse_.at_first);
  emit hintChanged(hint());
}

void VolumeView::setMouse(const MouseChoices& mouse) {
  const bool other = mouse.at_first != mouse_.at_first;
  mouse_ = mouse;
  if (other) setMouseMode(mouse.at_first);
}

void VolumeView::placeHand(const haptics::Pose& X_WH) { hand_target_ = X_WH; }

void VolumeView::setMouseMode(MouseMode mode) {
  if (mode == MouseMode::Hand && !mouse_hand_) mode = MouseMode::Look;
  if (mode == mode_) return;
  mode_ = mode;
  grasp_.reset();
  chooseCursor(last_mouse_);
  emit mouseModeChanged(mode);
  emit hintChanged(hint());
}

void VolumeView::showFine(vtkPolyData* mesh, double isovalue) {
  surface_.showFine(mesh, isovalue);
  redrawSurface();
}

void VolumeView::chooseMode() {
  if (!graphics() || box_mm_.isEmpty()) return;
  const SurfaceChoice choice = chooseSurface(wish_, *graphics(), grid_);
  surface_.setMode(choice.mode);
  surface_.setOcclusion(!graphics()->software());
  if (graphics()->software()) surface_.setBudget(kMovingTriangles);
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
  veil_->forget();
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
  fitClippingRange();
  surface_.cull(camera_.vtk());
}

void VolumeView::fitClippingRange() {
  if (box_mm_.isEmpty()) return;
  vtkCamera* camera = camera_.vtk();
  Eigen::AlignedBox3d box = box_mm_;
  const Eigen::Vector3d room = Eigen::Vector3d::Constant(tool_radius_ * kMmPerM + 1.0);
  if (displayed_)
    for (const haptics::Pose* X : {&last_.X_WP, &last_.X_WD}) {
      const Eigen::Vector3d p_mm = X->translation() * kMmPerM;
      box.extend(p_mm - room);
      box.extend(p_mm + room);
    }
  const Eigen::Vector3d eye{camera->GetPosition()};
  const Eigen::Vector3d away = -viewAxes().col(2);
  const double reach = 0.55 * box.diagonal().norm();
  const double middle = away.dot(box.center() - eye);
  const double far_mm = std::max(middle + reach, 1.0);
  // a device that flies off must not move the planes that the kept surface was drawn between
  const double grain = std::pow(2.0, std::ceil(2.0 * std::log2(far_mm)) / 2.0);
  const double near_mm = std::max(middle - reach, grain * 0.002);
  double* range = camera->GetClippingRange();
  const bool enough = range[0] <= near_mm && range[0] > 0.2 * near_mm && range[1] >= far_mm &&
                      range[1] < 3.0 * far_mm;
  if (enough) return;
  camera->SetClippingRange(std::max(0.5 * near_mm, grain * 0.002), 1.5 * far_mm);
  held_->forget();
  veil_->forget();
}

void VolumeView::lookFrom(Side side) { frameSurface(directionOf(side), upOf(side)); }

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
  frameSurface(from.normalized(), Eigen::Vector3d::UnitZ());
}

void VolumeView::tell(ViewLook& look) const {
  look.eye_mm = Eigen::Vector3d{camera_.vtk()->GetPosition()};
  look.focus_mm = Eigen::Vector3d{camera_.vtk()->GetFocalPoint()};
  look.up = Eigen::Vector3d{camera_.vtk()->GetViewUp()};
  look.parallel = camera_.vtk()->GetParallelProjection() != 0;
  look.half_height_mm = camera_.vtk()->GetParallelScale();
}

void VolumeView::look(const ViewLook& look) {
  camera_.vtk()->SetPosition(look.eye_mm.x(), look.eye_mm.y(), look.eye_mm.z());
  camera_.vtk()->SetFocalPoint(look.focus_mm.x(), look.focus_mm.y(), look.focus_mm.z());
  camera_.vtk()->SetViewUp(look.up.x(), look.up.y(), look.up.z());
  camera_.vtk()->SetParallelProjection(look.parallel);
  camera_.vtk()->SetParallelScale(look.half_height_mm);
  camera_.keep();
  cameraMoved();
  emit parallelChanged(look.parallel);
}

void VolumeView::lookAlongTool() {
  if (!displayed_ || box_mm_.isEmpty()) return;
  const haptics::Pose& X = last_.X_WP;
  const Eigen::Vector3d back = X.linear().col(2);
  Eigen::Vector3d up = back.cross(Eigen::Vector3d::UnitZ()).cross(back);
  if (up.norm() < 0.1) up = -Eigen::Vector3d::UnitY();
  Eigen::Vector3d tip = X.translation();
  for (const haptics::Vec3& v : tool_mesh_.vertices)
    if (back.dot(X * v - tip) < 0.0)
      tip = X.translation() + back * back.dot(X * v - X.translation());
  camera_.lookAt(tip * kMmPerM, back, up, kBehindTool_mm + tool_radius_ * kMmPerM, box_mm_);
  cameraMoved();
}

void VolumeView::setParallel(bool parallel) {
  if (parallel == camera_.isParallel()) return;
  camera_.setParallel(parallel, box_mm_);
  cameraMoved();
  emit parallelChanged(parallel);
}

void VolumeView::frameSurface(const Eigen::Vector3d& from, const Eigen::Vector3d& up) {
  if (box_mm_.isEmpty()) return;
  // the surface rather than the volume, which may be mostly air
  Eigen::AlignedBox3d shown = surface_.bounds_mm();
  if (surface_.second()) shown.extend(surface_.secondBounds_mm());
  camera_.frame(shown, from, up);
  cameraMoved();
}

std::optional<SurfacePlace> VolumeView::surfaceUnder(QPointF at) const {
  if (!touched_.firstMet || box_mm_.isEmpty()) return {};
  Eigen::Vector3d from_mm, along;
  camera_.sight(at, from_mm, along);
  const double far_mm = (box_mm_.center() - from_mm).norm() + box_mm_.diagonal().norm();
  return touched_.firstMet(from_mm / kMmPerM, (from_mm + far_mm * along) / kMmPerM, isovalue_);
}

Eigen::Vector3d VolumeView::aimUnder(QPointF at) const {
  if (const auto met = surfaceUnder(at)) return met->p_W * kMmPerM;
  return camera_.placeBeside(at, Eigen::Vector3d{camera()->GetFocalPoint()});
}

void VolumeView::zoom(double factor, QPointF at) {
  camera_.zoom(factor, aimUnder(at));
  cameraMoved();
}

QPointF VolumeView::projected(const haptics::Vec3& p_W) const {
  return camera_.projected(p_W * kMmPerM);
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
    const double m = camera_.mmPerPixel(X_WH.translation() * kMmPerM) / kMmPerM;
    X_WH.translation() += (by.x() * axes.col(0) - by.y() * axes.col(1)) * m;
  }
  emit handPulled(X_WH);
}

void VolumeView::pushHand(double notches) {
  haptics::Pose& X_WH = handTarget();
  X_WH.translation() -= viewAxes().col(2) * (notches * kHandStep);
  emit handPulled(X_WH);
}

bool VolumeView::isOnTool(QPointF at) const {
  if (!mouse_hand_ || !displayed_) return false;
  double nearest_mm = INFINITY;  // from the viewer
  const Eigen::Vector3d eye{camera()->GetPosition()}, away = -viewAxes().col(2);
  const auto look = [&](const haptics::Pose& X) {
    std::vector<QPointF> seen;
    std::vector<double> depth_mm;
    for (const haptics::Vec3& v : tool_mesh_.vertices) {
      const Eigen::Vector3d p_mm = (X * v) * kMmPerM;
      seen.push_back(camera_.projected(p_mm));
      depth_mm.push_back(away.dot(p_mm - eye));
    }
    for (const auto& [a, b, c] : tool_mesh_.triangles)
      if (isWithin(at, seen[a], seen[b], seen[c]) || fromSegment(at, seen[a], seen[b]) < kGrab ||
          fromSegment(at, seen[b], seen[c]) < kGrab || fromSegment(at, seen[c], seen[a]) < kGrab)
        nearest_mm = std::min(nearest_mm, std::min({depth_mm[a], depth_mm[b], depth_mm[c]}));
    if (tool_mesh_.triangles.empty())
      for (std::size_t i = 0; i < seen.size(); ++i)
        if (fromSegment(at, seen[i], seen[i]) < kGrab)
          nearest_mm = std::min(nearest_mm, depth_mm[i]);
  };
  // the wireframe is seen through everything
  if (tool_.deviceShown()) {
    look(last_.X_WD);
    if (std::isfinite(nearest_mm)) return true;
  }
  look(last_.X_WP);
  if (!std::isfinite(nearest_mm)) return false;
  const auto before = surfaceUnder(at);
  return !before || away.dot(before->p_W * kMmPerM - eye) > nearest_mm - 1.0;
}

void VolumeView::bringTool(QPointF at) {
  if (const auto met = surfaceUnder(at)) emit toolWanted(met->p_W, met->normal_W);
}

void VolumeView::paintGL() {
  Viewport::paintGL();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  paintOver(painter, size());
  if (!hasFocus()) return;
  // of the widget alone, and in no picture; as slices show it
  painter.setRenderHint(QPainter::Antialiasing, false);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(style::kViewFocus, 1.0, Qt::DotLine));
  painter.drawRect(rect().adjusted(1, 1, -2, -2));
}

void VolumeView::paintOver(QPainter& painter, const QSizeF& size) const {
  if (!box_mm_.isEmpty()) {
    if (contacts_shown_) paintContacts(painter);
    overlays_.paint(painter, *geometry_);
    const Eigen::Matrix3d axes = viewAxes();
    const QRectF cube = OrientationCube::placeIn(size);
    OrientationCube::paint(painter, cube, axes, orientation_known_);
    if (orientation_known_) {
      paintEdgeLetters(painter, {QPointF{}, size}, axes);
    } else {
      const QString text = tr("left/right unknown");
      const double wide = painter.fontMetrics().horizontalAdvance(text);
      paintOutlined(painter, {size.width() - wide - 10.0, cube.bottom() + 16.0}, painter.font(),
                    style::kContact, text);
    }
  } else {
    overlays_.paint(painter, *geometry_);
  }
}

void VolumeView::paintContacts(QPainter& painter) const {
  if (!displayed_ || last_.contacts <= 0) return;
  painter.save();
  const auto count = std::min(static_cast<std::size_t>(last_.contacts), last_.places.size());
  haptics::Vec3 middle = haptics::Vec3::Zero();
  double pushed = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const haptics::ContactPlace& place = last_.places[i];
    const haptics::Vec3 p_W{place.p_W[0], place.p_W[1], place.p_W[2]};
    middle += (place.push + 1e-6) * p_W;
    pushed += place.push + 1e-6;
    painter.setPen(QPen(kViewGround, 3.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(projected(p_W), kContactMark, kContactMark);
    painter.setPen(QPen(style::kContact, 1.5));
    painter.drawEllipse(projected(p_W), kContactMark, kContactMark);
  }
  const haptics::Vec3& force = last_.felt_W.force;
  if (force.norm() > kLeastForce && pushed > 0.0) {
    middle /= pushed;
    const double height_m = camera_.mmPerPixel(middle * kMmPerM) * height() / kMmPerM;
    const double share = std::min(force.norm() / kArrowForce, 2.0) * kArrowOfHeight;
    const QPointF foot = projected(middle);
    const QPointF head = projected(middle + force.normalized() * (share * height_m));
    const double length = std::hypot(head.x() - foot.x(), head.y() - foot.y());
    QPainterPath arrow;
    arrow.moveTo(foot);
    arrow.lineTo(head);
    if (length > 1.0) {
      const QPointF along = (head - foot) / length, aside{-along.y(), along.x()};
      const double barb = std::min(10.0, 0.5 * length);
      arrow.moveTo(head - barb * along + 0.5 * barb * aside);
      arrow.lineTo(head);
      arrow.lineTo(head - barb * along - 0.5 * barb * aside);
    }
    for (const auto& [colour, width] :
         {std::pair{kViewGround, 5.0}, std::pair{style::kForceArrow, 2.5}}) {
      painter.setPen(QPen(colour, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
      painter.drawPath(arrow);
    }
    paintOutlined(painter, head + QPointF{8.0, -6.0}, painter.font(), style::kContact,
                  tr("%1 N").arg(force.norm(), 0, 'f', 1));
  }
  painter.restore();
}

void VolumeView::addOverlay(Overlay& overlay) {
  overlays_.add(overlay);
  connect(&overlay, &Overlay::changed, this, [this] { emit hintChanged(hint()); });
}

QString VolumeView::hint() const {
  const QString over = overlays_.hint();
  if (!over.isEmpty()) return over;
  if (mode_ == MouseMode::Hand)
    return tr("Drag: moves the tool. Shift: turns it. Wheel: pushes it. Right drag: turns the "
              "picture. %1: lets go.")
        .arg(keyOf(Action::TakeTool));
  if (mouse_hand_)
    return tr("Drag: turns. Wheel: nearer. To touch: drag the tool, or take it with %1. "
              "Double-click: brings it there. Middle drag: shifts.")
        .arg(keyOf(Action::TakeTool));
  return tr("Drag: turns. Wheel: nearer. Middle drag: shifts.");
}

void VolumeView::resizeEvent(QResizeEvent* event) {
  Viewport::resizeEvent(event);
  if (!box_mm_.isEmpty() && camera_.refit()) cameraMoved();
}

QImage VolumeView::picture(double scale) {
  // what VTK draws in pixels follows
  const float line = tool_.device()->GetProperty()->GetLineWidth();
  const auto ratio = static_cast<float>(scale / devicePixelRatioF());
  tool_.device()->GetProperty()->SetLineWidth(line * ratio);
  held_->forget();
  veil_->forget();
  QImage image = drawnAt((QSizeF(size()) * scale).toSize());
  tool_.device()->GetProperty()->SetLineWidth(line);
  redrawSurface();
  if (image.isNull()) return image;
  QPainter painter(&image);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.scale(scale, scale);
  painter.setFont(font());
  paintOver(painter, size());
  return image;
}

void VolumeView::mousePressEvent(QMouseEvent* event) {
  last_mouse_ = press_ = event->position();
  grasp_.reset();
  event->accept();
  if (overlays_.press(*geometry_, *event)) return;
  if (event->button() == Qt::LeftButton && !box_mm_.isEmpty()) {
    const QRectF cube = OrientationCube::placeIn(size());
    if (OrientationCube::sideAt(press_, cube, viewAxes())) return;  // the release looks from there
  }
  const bool on_tool = event->button() == Qt::LeftButton && isOnTool(press_);
  const auto action =
      actionOf(Where::Space, mode_, Gesture::Drag, event->button(), event->modifiers(), on_tool);
  if (!action) return;
  const bool hand = *action == Action::MoveTool || *action == Action::TurnTool;
  if (hand && !displayed_) return;  // the last pose was another hand's
  grasp_ = Grasp{*action, *action == Action::Zoom ? aimUnder(press_) : Eigen::Vector3d::Zero()};
  chooseCursor(press_);
}

void VolumeView::mouseReleaseEvent(QMouseEvent* event) {
  if (overlays_.release(*geometry_, *event)) return;
  const bool dragged = grasp_.has_value();
  if (event->buttons() == Qt::NoButton) grasp_.reset();
  chooseCursor(event->position());
  if (dragged || event->button() != Qt::LeftButton || box_mm_.isEmpty()) return;
  const QRectF cube = OrientationCube::placeIn(size());
  const auto pressed = OrientationCube::sideAt(press_, cube, viewAxes());
  if (pressed && pressed == OrientationCube::sideAt(event->position(), cube, viewAxes()))
    lookFrom(*pressed);
}

void VolumeView::mouseDoubleClickEvent(QMouseEvent* event) {
  if (overlays_.doubleClick(*geometry_, *event)) return;
  const QRectF cube = OrientationCube::placeIn(size());
  const bool on_cube =
      !box_mm_.isEmpty() && OrientationCube::sideAt(event->position(), cube, viewAxes());
  const auto action =
      actionOf(Where::Space, mode_, Gesture::DoubleClick, event->button(), event->modifiers());
  if (on_cube || action != Action::BringTool || isOnTool(event->position()))
    return mousePressEvent(event);
  bringTool(event->position());
}

void VolumeView::mouseMoveEvent(QMouseEvent* event) {
  const QPointF by = event->position() - last_mouse_;
  last_mouse_ = event->position();
  if (overlays_.move(*geometry_, *event)) return;
  if (grasp_)
    dragBy(by, event->modifiers());
  else if (event->buttons() == Qt::NoButton)
    chooseCursor(event->position());
}

void VolumeView::dragBy(QPointF by, Qt::KeyboardModifiers modifiers) {
  switch (grasp_->action) {
    case Action::MoveTool:
    case Action::TurnTool:
      // Shift may come and go while the tool is held
      moveHand(by, modifiers & Qt::ShiftModifier);
      break;
    case Action::Rotate:
      camera_.rotate(by);
      cameraMoved();
      break;
    case Action::Pan:
      camera_.pan(by);
      cameraMoved();
      break;
    case Action::Zoom:
      camera_.zoom(std::pow(kZoomPixel, -by.y()), grasp_->zoom_at_mm);
      cameraMoved();
      break;
    default:
      break;
  }
}

void VolumeView::chooseCursor(QPointF at) {
  const bool held =
      grasp_ && (grasp_->action == Action::MoveTool || grasp_->action == Action::TurnTool);
  const bool could = mode_ == MouseMode::Hand || (!grasp_ && isOnTool(at));
  const Qt::CursorShape shape = held    ? Qt::ClosedHandCursor
                                : could ? Qt::OpenHandCursor
                                        : Qt::ArrowCursor;
  if (cursor().shape() != shape) setCursor(shape);
}

void VolumeView::wheelEvent(QWheelEvent* event) {
  event->accept();
  const double notches = event->angleDelta().y() / 120.0;
  // while the tool is held it goes into the depth, in any mode
  const bool held =
      grasp_ && (grasp_->action == Action::MoveTool || grasp_->action == Action::TurnTool);
  const auto action =
      actionOf(Where::Space, held ? MouseMode::Hand : mode_, Gesture::Wheel, 0, event->modifiers());
  if (action == Action::PushTool && displayed_)
    pushHand(notches);
  else
    zoom(std::pow(kViewZoomNotch, mouse_.zoom_reversed ? -notches : notches), event->position());
}

bool VolumeView::perform(const Binding& meaning) {
  const Action action = meaning.action;
  const QPointF way = wayOf(meaning);
  const QPointF at = underMouse() ? last_mouse_ : QRectF(rect()).center();
  switch (action) {
    case Action::Rotate:
      camera_.rotate({way.x() * width() * kTurnKey, way.y() * height() * kTurnKey});
      cameraMoved();
      break;
    case Action::Pan:
      // as in slices: towards what lies there
      camera_.pan(way * -kShiftKey);
      cameraMoved();
      break;
    case Action::Nearer:
      zoom(kViewZoomNotch, at);
      break;
    case Action::Farther:
      zoom(1.0 / kViewZoomNotch, at);
      break;
    case Action::ForceOff:
      emit forceOffWanted();
      break;
    case Action::TakeTool:
      setMouseMode(mode_ == MouseMode::Hand ? MouseMode::Look : MouseMode::Hand);
      break;
    case Action::ToolToCross:
      emit toolToCrossWanted();
      break;
    case Action::CrossToTool:
      emit crossToToolWanted();
      break;
    case Action::LookAlongTool:
      lookAlongTool();
      break;
    case Action::LookFromTool:
      lookFromTool();
      break;
    case Action::ShowEverything:
      resetCamera();
      break;
    case Action::ViewAnterior:
    case Action::ViewPosterior:
    case Action::ViewLeft:
    case Action::ViewRight:
    case Action::ViewSuperior:
    case Action::ViewInferior:
      lookFrom(kSides.at(static_cast<std::size_t>(action) -
                         static_cast<std::size_t>(Action::ViewAnterior)));
      break;
    case Action::ParallelProjection:
      setParallel(!isParallel());
      break;
    default:
      return false;
  }
  return true;
}

void VolumeView::keyPressEvent(QKeyEvent* event) {
  if (event->key() != Qt::Key_Space && overlays_.key(*geometry_, *event, QRectF(rect()).center()))
    return;
  const Binding* held = meaningOf(Where::Space, *event, Gesture::HeldKey);
  const Binding* meaning = meaningOf(Where::Space, *event);
  if (held != nullptr && held->action == Action::Clutch)
    emit clutchHeld(true);
  else if (held != nullptr)
    emit forceHeld(true);
  else if (meaning == nullptr || !perform(*meaning))
    Viewport::keyPressEvent(event);
}

void VolumeView::keyReleaseEvent(QKeyEvent* event) {
  // a key that is held repeats itself as releases and presses
  if (event->isAutoRepeat()) return Viewport::keyReleaseEvent(event);
  // whatever else is held meanwhile
  const QKeyEvent alone(event->type(), event->key(), Qt::NoModifier);
  const Binding* held = meaningOf(Where::Space, alone, Gesture::HeldKey);
  if (held != nullptr && held->action == Action::Clutch)
    emit clutchHeld(false);
  else if (held != nullptr)
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
