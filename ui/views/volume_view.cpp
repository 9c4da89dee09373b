// SPDX-License-Identifier: BSD-3-Clause
#include "ui/views/volume_view.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkVolume.h>
#include <QKeyEvent>
#include <QLocale>
#include <QMetaMethod>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "ui/controls/touched_words.h"
#include "ui/props/held_pass.h"
#include "ui/props/through_pass.h"
#include "ui/props/veil_pass.h"
#include "ui/style/scene_colours.h"
#include "ui/views/slice_readout.h"

namespace ui {
namespace {

// of a surface in motion, on software graphics
constexpr std::int64_t kMovingTriangles = 80'000;
constexpr double kOutline_px = 1.5;   // of structures that are seen through bone
constexpr int kStillMs = 400;         // no movement for this long is rest
constexpr int kPointedMs = 100;       // between two looks at what is under the pointer
constexpr double kBeside_deg = 40.0;  // between the device and the eye, about the patient's axis
constexpr double kBehindTool_mm = 120.0;  // of the eye, looking along the tool
// of a look at a structure
constexpr int kDirections = 60;
constexpr double kTurnCost_mm = 4.0;    // of solid, for a radian that the view turns
constexpr double kOutOfBody_mm = 30.0;  // of the eye
constexpr double kSteep = 0.9;          // beyond that the front is above in the picture
constexpr double kNearest_mm = 60.0, kFarthest_mm = 200.0;  // of the eye from a small structure
constexpr double kNearInSizes = 4.0, kFarInSizes = 20.0;    // and in sizes of a large one
constexpr double kLetterSide = 28.0, kLetterEnd = 20.0;     // px, at the edges, where letters stand

using style::kViewGround;

}  // namespace

/// What overlays know of the 3-D view.
class VolumeView::Geometry : public ViewGeometry {
 public:
  explicit Geometry(VolumeView& view) : view_(view) {}

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
  bool showsBody(const QRectF& box) const override { return view_.showsBody(box); }
  std::vector<QRectF> taken() const override {
    std::vector<QRectF> boxes = view_.wordBoxes();
    boxes.insert(boxes.end(), view_.covered_.begin(), view_.covered_.end());
    return boxes;
  }

 private:
  VolumeView& view_;
};

VolumeView::VolumeView(QWidget* parent)
    : Viewport(parent),
      surface_layer_(vtkSmartPointer<vtkRenderer>::New()),
      through_layer_(vtkSmartPointer<vtkRenderer>::New()),
      proxy_layer_(vtkSmartPointer<vtkRenderer>::New()),
      veil_layer_(vtkSmartPointer<vtkRenderer>::New()),
      overlay_layer_(vtkSmartPointer<vtkRenderer>::New()),
      held_(vtkSmartPointer<HeldPass>::New()),
      through_(vtkSmartPointer<ThroughPass>::New()),
      veil_(vtkSmartPointer<VeilPass>::New()),
      structures_(*surface_layer_, *through_layer_),
      geometry_(std::make_unique<Geometry>(*this)) {
  offerSpoken();
  setMouseTracking(true);
  setAccessibleName(tr("3-D view"));
  surface_layer_->SetBackground(kViewGround.redF(), kViewGround.greenF(), kViewGround.blueF());
  renderWindow()->SetNumberOfLayers(5);
  int layer = 0;
  for (const auto& renderer :
       {surface_layer_, through_layer_, proxy_layer_, veil_layer_, overlay_layer_}) {
    renderer->SetLayer(layer++);
    renderer->SetActiveCamera(camera_.vtk());
    renderWindow()->AddRenderer(renderer);
  }
  // surface and veil hide the proxy behind them; the device is never hidden
  through_layer_->PreserveDepthBufferOn();
  through_layer_->SetPass(through_);
  proxy_layer_->PreserveDepthBufferOn();
  veil_layer_->PreserveDepthBufferOn();
  veil_layer_->SetPass(veil_);
  veil_->setOpacity(kFirstOpacity);
  surface_layer_->AddVolume(surface_.rayCast());
  surface_layer_->AddActor(surface_.mesh());
  surface_layer_->AddActor(surface_.carved().actor());
  veil_layer_->AddActor(surface_.secondMesh());
  veil_layer_->DrawOff();
  overlay_layer_->AddActor(tool_.device());
  tool_.showDeviceOnlyApart();
  still_.setObjectName("still");
  still_.setSingleShot(true);
  still_.setInterval(kStillMs);
  connect(&still_, &QTimer::timeout, this, &VolumeView::settle);
  connect(this, &Viewport::graphicsKnown, this, [this] { chooseMode(); });
  whenKeysChange(*this, [this] { emit hintChanged(hint()); });
  pointed_.setSingleShot(true);
  pointed_.setInterval(kPointedMs);
  connect(&pointed_, &QTimer::timeout, this, &VolumeView::tellPointed);
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
  lookAtFirst();
}

void VolumeView::replace(const Picture& picture) {
  box_mm_ = boxOf_mm(*picture.volume);
  surface_.replace(picture);
  still_.start();
  redrawSurface();
}

void VolumeView::showLive(const haptics::Volume& voxels,
                          std::shared_ptr<const haptics::Volume> scan,
                          std::span<const haptics::VoxelBox> cut_before) {
  surface_.showLive(voxels, std::move(scan), cut_before);
  redrawSurface();
}

void VolumeView::carve(const haptics::VoxelBox& box) {
  surface_.carved().add(box);
  // without a graphics card the whole mesh is slow: a light one will do beside the bricks
  if (graphics() && graphics()->software()) return showMoved();
  redrawSurface();
}

void VolumeView::renew(const Picture& picture) {
  surface_.renew(picture);
  still_.start();
  redrawSurface();
}

void VolumeView::setTint(bool on) {
  surface_.carved().setTint(on);
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
  emit lookChanged();
}

void VolumeView::setColouring(const Colouring& colouring) {
  surface_.setColouring(colouring);
  redrawSurface();
  emit lookChanged();
}

void VolumeView::setSecondSurface(std::optional<double> isovalue) {
  surface_.setSecond(isovalue);
  veil_layer_->SetDraw(isovalue.has_value());
  redrawSurface();
  emit secondSurfaceChanged();
}

void VolumeView::setSecondOpacity(double opacity) {
  veil_->setOpacity(opacity);
  redraw();
  emit secondSurfaceChanged();
}

double VolumeView::secondOpacity() const { return veil_->opacity(); }

void VolumeView::show(const Structures& structures) {
  structures_.show(structures);
  redrawSurface();
}

void VolumeView::showShape(std::size_t number, vtkPolyData* mesh) {
  structures_.showShape(number, mesh);
  redrawSurface();
}

void VolumeView::showContacts(bool on) {
  contacts_shown_ = on;
  update();
}

QString VolumeView::spokenName() const {
  const auto& volume = picture().volume;
  if (volume == nullptr) return tr("%1: nothing is open").arg(accessibleName());
  QString isovalue = QLocale().toString(isovalue_, 'g', 6);
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
  const bool other_hint = snapshot.can_cut != last_.can_cut;
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
  if (other_hint) emit hintChanged(hint());
  if (tool_.setTurning(snapshot.cuts)) redraw();
  if (tool_.move(snapshot.X_WP, snapshot.X_WD)) redraw();
}

void VolumeView::showFine(vtkPolyData* mesh, double isovalue) {
  if (isovalue == isovalue_) fine_awaited_ = false;
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
  structures_.bringForward(*camera());
  forgetDrawn();
  redraw();
}

void VolumeView::forgetDrawn() {
  held_->forget();
  through_->forget();
  veil_->forget();
}

void VolumeView::cameraMoved() {
  showMoved();
  emit cameraChanged();
}

void VolumeView::showMoved() {
  surface_.setMoving(true);
  still_.start();
  redrawSurface();
}

void VolumeView::settle() {
  surface_.setMoving(false);
  redrawSurface();
  fine_awaited_ = false;
  if (surface_.mode() != SurfaceMode::Mesh || box_mm_.isEmpty() || surface_.hasFine()) return;
  fine_awaited_ = isSignalConnected(QMetaMethod::fromSignal(&VolumeView::fineMeshWanted));
  emit fineMeshWanted(isovalue_);
}

void VolumeView::aboutToDraw() {
  surface_.update();
  through_->setLine(std::max(1, qRound(kOutline_px * renderWindow()->GetSize()[1] / height())));
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
  forgetDrawn();
}

void VolumeView::lookAtFirst() {
  if (box_mm_.isEmpty()) return;
  Eigen::AlignedBox3d solid;
  for (const Eigen::Vector3d& p_mm : surface_.outline_mm()) solid.extend(p_mm);
  frameSurface(firstDirection(solid.sizes()), Eigen::Vector3d::UnitZ());
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

void VolumeView::lookAtPlaces(const std::vector<Eigen::Vector3d>& places_W_mm) {
  if (places_W_mm.empty() || box_mm_.isEmpty()) return;
  const Eigen::Vector3d& middle = places_W_mm.front();
  double size_mm = 0.0;
  for (const Eigen::Vector3d& p : places_W_mm) size_mm = std::max(size_mm, (p - middle).norm());
  const double reach_mm = box_mm_.diagonal().norm();
  const double step_mm = std::max(1.5, grid_.spacing.minCoeff() * kMmPerM);
  const auto solidBefore_mm = [&](const Eigen::Vector3d& from) {
    double solid = 0.0;
    for (const Eigen::Vector3d& p : places_W_mm)
      for (double away = step_mm; touched_.value && away < reach_mm; away += step_mm) {
        const Eigen::Vector3d there = p + away * from;
        if (!box_mm_.contains(there)) break;
        if (touched_.value(there / kMmPerM) > isovalue_) solid += step_mm;
      }
    return solid / static_cast<double>(places_W_mm.size());
  };
  // from all sides, evenly, and as it is
  const Eigen::Vector3d now = viewAxes().col(2);
  Eigen::Vector3d best = now;
  double least = solidBefore_mm(now);
  for (int n = 0; n < kDirections; ++n) {
    const double z = 1.0 - (2.0 * n + 1.0) / kDirections;
    const double turn = std::numbers::pi * (3.0 - std::sqrt(5.0)) * n;
    const double level = std::sqrt(1.0 - z * z);
    const Eigen::Vector3d from{level * std::cos(turn), level * std::sin(turn), z};
    const double cost =
        solidBefore_mm(from) + kTurnCost_mm * std::acos(std::clamp(from.dot(now), -1.0, 1.0));
    if (cost >= least) continue;
    least = cost;
    best = from;
  }
  // the eye is outside the body, which would be cut open before it
  const Eigen::AlignedBox3d body = surface_.bounds_mm();
  double outside_mm = 0.0;
  for (int n = 0; n < 8; ++n)
    outside_mm =
        std::max(outside_mm,
                 best.dot(body.corner(static_cast<Eigen::AlignedBox3d::CornerType>(n)) - middle));
  const double distance_mm =
      std::max(outside_mm + kOutOfBody_mm,
               std::clamp(camera()->GetDistance(), std::max(kNearest_mm, kNearInSizes * size_mm),
                          std::max(kFarthest_mm, kFarInSizes * size_mm)));
  const Eigen::Vector3d up = std::abs(best.z()) > kSteep
                                 ? Eigen::Vector3d{-Eigen::Vector3d::UnitY()}
                                 : Eigen::Vector3d{Eigen::Vector3d::UnitZ()};
  camera_.lookAt(middle, best, up, distance_mm, box_mm_);
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
  camera_.frame(surface_.outline_mm(), from, up);
  cameraMoved();
}

std::optional<SurfacePlace> VolumeView::surfaceUnder(QPointF at) const {
  if (!touched_.firstMet || box_mm_.isEmpty()) return {};
  Eigen::Vector3d from_mm, along;
  camera_.sight(at, from_mm, along);
  const double far_mm = (box_mm_.center() - from_mm).norm() + box_mm_.diagonal().norm();
  return touched_.firstMet(from_mm / kMmPerM, (from_mm + far_mm * along) / kMmPerM, isovalue_);
}

bool VolumeView::showsBody(const QRectF& box) {
  const Eigen::AlignedBox3d body = surface_.bounds_mm();
  if (body.isEmpty()) return false;
  // the outline of a convex body is apart from a box if a line along one of its edges is between
  BodyCorners& seen = body_corners_;
  if (seen.camera != camera()->GetMTime() || seen.size != size() ||
      !seen.body.isApprox(body, 0.0)) {
    seen = {camera()->GetMTime(), size(), body, {}};
    for (int n = 0; n < 8; ++n) {
      const auto of = static_cast<Eigen::AlignedBox3d::CornerType>(n);
      seen.corners[static_cast<std::size_t>(n)] = camera_.projected(body.corner(of));
    }
  }
  const std::array<QPointF, 8>& corners = seen.corners;
  const std::array<QPointF, 4> sides{box.topLeft(), box.topRight(), box.bottomLeft(),
                                     box.bottomRight()};
  const auto apartAlong = [&](QPointF way) {
    const auto span = [&](const auto& points) {
      double least = INFINITY, most = -INFINITY;
      for (const QPointF& p : points) {
        least = std::min(least, QPointF::dotProduct(way, p));
        most = std::max(most, QPointF::dotProduct(way, p));
      }
      return std::pair{least, most};
    };
    const auto [a, b] = span(corners);
    const auto [c, d] = span(sides);
    return a > d || c > b;
  };
  if (apartAlong({1.0, 0.0}) || apartAlong({0.0, 1.0})) return false;
  for (int n = 0; n < 8; ++n)
    for (const int bit : {1, 2, 4}) {
      const QPointF edge =
          corners[static_cast<std::size_t>(n ^ bit)] - corners[static_cast<std::size_t>(n)];
      if (apartAlong({-edge.y(), edge.x()})) return false;
    }
  return true;
}

Eigen::Vector3d VolumeView::aimUnder(QPointF at) const {
  if (const auto met = surfaceUnder(at)) return met->p_W * kMmPerM;
  return camera_.placeBeside(at, Eigen::Vector3d{camera()->GetFocalPoint()});
}

void VolumeView::zoom(double factor, QPointF at) {
  camera_.zoom(factor, aimUnder(at));
  cameraMoved();
}

void VolumeView::tellPointed() {
  QString words;
  const bool looks = pointer_in_ && !grasp_;
  const auto met = looks ? surfaceUnder(last_mouse_) : std::nullopt;
  const NamedPlace named = looks ? structuresUnder(last_mouse_, met) : NamedPlace{};
  // value, place and names are those of one place
  if ((met || named.p_W_mm) && touched_.behind && picture().volume != nullptr) {
    const haptics::Vec3 p_W = named.p_W_mm ? *named.p_W_mm / kMmPerM : met->p_W;
    words = touchedWords(named.p_W_mm ? touched_.value(p_W) : touched_.behind(p_W),
                         QString::fromStdString(picture().volume->unit)) +
            QStringLiteral("   ") + positionWords(p_W * kMmPerM, orientation_known_);
  }
  if (!named.names.isEmpty())
    words += (words.isEmpty() ? QString{} : QStringLiteral("   ")) + named.names;
  emit pointedChanged(words);
}

VolumeView::NamedPlace VolumeView::structuresUnder(QPointF at,
                                                   const std::optional<SurfacePlace>& met) const {
  const Structures& shown = structures_.shown();
  if (shown.map == nullptr || box_mm_.isEmpty()) return {};
  Eigen::Vector3d from_mm, along;
  camera_.sight(at, from_mm, along);
  const double step_mm = 0.5 * grid_.spacing.minCoeff() * kMmPerM;
  const double far_mm = (box_mm_.center() - from_mm).norm() + 0.5 * box_mm_.diagonal().norm();
  const double met_mm = met ? (met->p_W * kMmPerM - from_mm).norm() : far_mm;
  const auto firstShown = [&](double begin_mm, double end_mm) {
    for (double away = begin_mm; away < end_mm; away += step_mm)
      if (const Eigen::Vector3d p_mm = from_mm + away * along;
          shown.isShown(shown.map->codeAt(p_mm)))
        return NamedPlace{shown.namesAt(p_mm), p_mm};
    return NamedPlace{};
  };
  // before the surface; else what is touched there, half a voxel behind it; else seen through it
  NamedPlace named = firstShown(std::max(0.0, far_mm - box_mm_.diagonal().norm()), met_mm);
  if (named.names.isEmpty() && met)
    named.names = shown.namesAt(met->p_W * kMmPerM - met->normal_W * step_mm);
  if (named.names.isEmpty() && met && shown.through) named = firstShown(met_mm, far_mm);
  return named;
}

QPointF VolumeView::projected(const haptics::Vec3& p_W) const {
  return camera_.projected(p_W * kMmPerM);
}

bool VolumeView::isHandleIn(const QRect& part) const {
  return overlays_.hasHandleIn(*geometry_, part);
}

void VolumeView::setCovered(std::vector<QRectF> parts) {
  if (parts == covered_) return;
  covered_ = std::move(parts);
  update();
}

void VolumeView::addOverlay(Overlay& overlay) {
  overlays_.add(overlay);
  connect(&overlay, &Overlay::changed, this, [this] { emit hintChanged(hint()); });
}

}  // namespace ui
