// SPDX-License-Identifier: BSD-3-Clause
#include "ui/slice_view.h"

#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

namespace ui {
namespace {

QString nameOf(Plane plane) {
  switch (plane) {
    case Plane::Axial:
      return SliceView::tr("Axial");
    case Plane::Coronal:
      return SliceView::tr("Coronal");
    case Plane::Sagittal:
      break;
  }
  return SliceView::tr("Sagittal");
}

}  // namespace

/// What overlays know of a slice.
class SliceView::Geometry : public ViewGeometry {
 public:
  explicit Geometry(const SliceView& view) : view_(view) {}

  bool isSlice() const override { return true; }
  QPointF projected(const Eigen::Vector3d& p_W_mm) const override {
    return view_.projected(p_W_mm);
  }
  Eigen::Matrix3d axes() const override {
    Eigen::Matrix3d axes;
    axes << view_.axes_.right, view_.axes_.up, view_.axes_.right.cross(view_.axes_.up);
    return axes;
  }
  std::optional<Eigen::Vector3d> placeUnder(QPointF at) const override {
    return view_.placeUnder(at);
  }
  Eigen::Vector3d placeBeside(QPointF at, const Eigen::Vector3d& p_W_mm) const override {
    const Eigen::Vector3d p = view_.placeUnder(at);
    return p + view_.axes_.normal * view_.axes_.normal.dot(p_W_mm - p);
  }
  void sight(QPointF at, Eigen::Vector3d& from_W_mm, Eigen::Vector3d& along_W) const override {
    from_W_mm = view_.placeUnder(at);
    along_W = view_.axes_.up.cross(view_.axes_.right);
  }
  double mmPerPixel(const Eigen::Vector3d&) const override { return view_.mmPerPixel(); }
  double offset_mm(const Eigen::Vector3d& p_W_mm) const override {
    return view_.axes_.right.cross(view_.axes_.up).dot(p_W_mm - view_.cross_mm_);
  }
  const QWidget& widget() const override { return view_; }

 private:
  const SliceView& view_;
};

SliceView::SliceView(Plane plane, QWidget* parent)
    : QWidget(parent),
      plane_(plane),
      axes_(axesOf(plane)),
      geometry_(std::make_unique<Geometry>(*this)) {
  setMouseTracking(true);
  setMinimumSize(120, 100);
  setFocusPolicy(Qt::ClickFocus);
  setAccessibleName(nameOf(plane));
  setAttribute(Qt::WA_OpaquePaintEvent);
}

SliceView::~SliceView() = default;

void SliceView::show(const Picture& picture) {
  slice_.show(picture);
  box_mm_ = boxOf_mm(picture.volume->grid);
  step_mm_ = picture.volume->grid.spacing.minCoeff() * kMmPerM;
  full_width_ = std::max(picture.volume->greatest - picture.volume->least, 1e-6);
  letters_ = picture.volume->orientation_known;
  proxy_mm_.reset();
  stale_ = true;
  update();
}

void SliceView::replace(const Picture& picture) {
  slice_.show(picture);
  stale_ = true;
  update();
}

void SliceView::setCross(const Eigen::Vector3d& cross_W_mm) {
  // a move within the slice leaves its picture as it is
  stale_ = stale_ || std::abs(axes_.normal.dot(cross_W_mm - cross_mm_)) > 1e-6;
  cross_mm_ = cross_W_mm;
  update();
}

void SliceView::setGrey(const GreyWindow& grey) {
  grey_ = grey;
  stale_ = true;
  update();
}

void SliceView::setProxy(const Eigen::Vector3d& proxy_W_mm) {
  if (proxy_mm_ && (*proxy_mm_ - proxy_W_mm).norm() < 0.2 * mmPerPixel()) return;
  proxy_mm_ = proxy_W_mm;
  update();
}

double SliceView::mmPerPixel() const {
  if (box_mm_.isEmpty()) return 1.0;
  const Eigen::Vector3d size = box_mm_.sizes();
  const double across = std::abs(axes_.right.dot(size)) * 1.08;
  const double upward = std::abs(axes_.up.dot(size)) * 1.08;
  return std::max({across / std::max(1, width()), upward / std::max(1, height()), 1e-3});
}

QPointF SliceView::projected(const Eigen::Vector3d& p_W_mm) const {
  const Eigen::Vector3d p = p_W_mm - box_mm_.center();
  const double scale = 1.0 / mmPerPixel();
  return {0.5 * width() + axes_.right.dot(p) * scale, 0.5 * height() - axes_.up.dot(p) * scale};
}

void SliceView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), Qt::black);
  if (slice_.empty()) return;
  if (stale_) {
    const double scale = devicePixelRatioF();
    Eigen::Vector3d centre = box_mm_.center();
    centre += axes_.normal * axes_.normal.dot(cross_mm_ - centre);
    const QSize pixels{qRound(width() * scale), qRound(height() * scale)};
    image_ = slice_.cut(plane_, centre, pixels, mmPerPixel() / scale, grey_);
    image_.setDevicePixelRatio(scale);
    stale_ = false;
  }
  painter.drawImage(0, 0, image_);

  painter.setRenderHint(QPainter::Antialiasing);
  const QPointF cross = projected(cross_mm_);
  painter.setPen(QPen(QColor(90, 200, 120, 200), 1.0));
  painter.drawLine(QPointF{0.0, cross.y()}, QPointF{width() + 0.0, cross.y()});
  painter.drawLine(QPointF{cross.x(), 0.0}, QPointF{cross.x(), height() + 0.0});
  if (proxy_mm_) {
    const bool here = std::abs(axes_.normal.dot(*proxy_mm_ - cross_mm_)) <= step_mm_;
    painter.setPen(QPen(QColor(60, 180, 255), 1.5));
    painter.setBrush(here ? QBrush(QColor(60, 180, 255)) : QBrush(Qt::NoBrush));
    painter.drawEllipse(projected(*proxy_mm_), 4.0, 4.0);
  }
  drawLetters(painter);
  overlays_.paint(painter, *geometry_);
}

void SliceView::drawLetters(QPainter& painter) const {
  QFont font = painter.font();
  font.setPointSizeF(9.0);
  painter.setFont(font);
  painter.setPen(QColor(200, 200, 200));
  painter.drawText(rect().adjusted(6, 4, -6, -4), Qt::AlignLeft | Qt::AlignTop, nameOf(plane_));
  if (!letters_) return;
  font.setPointSizeF(13.0);
  font.setBold(true);
  painter.setFont(font);
  painter.setPen(QColor(255, 217, 51));
  const std::array<QString, 4> letters = lettersOf(plane_);
  const std::array<int, 4> edges{Qt::AlignLeft | Qt::AlignVCenter,
                                 Qt::AlignRight | Qt::AlignVCenter, Qt::AlignHCenter | Qt::AlignTop,
                                 Qt::AlignHCenter | Qt::AlignBottom};
  for (std::size_t i = 0; i < letters.size(); ++i)
    painter.drawText(rect().adjusted(6, 4, -6, -4), edges[i], letters[i]);
}

void SliceView::resizeEvent(QResizeEvent*) { stale_ = true; }

Eigen::Vector3d SliceView::placeUnder(QPointF at) const {
  const double scale = mmPerPixel();
  const Eigen::Vector3d centre = box_mm_.isEmpty() ? cross_mm_ : Eigen::Vector3d{box_mm_.center()};
  const Eigen::Vector3d p = centre + axes_.right * ((at.x() - 0.5 * width()) * scale) -
                            axes_.up * ((at.y() - 0.5 * height()) * scale);
  return p + axes_.normal * axes_.normal.dot(cross_mm_ - centre);
}

void SliceView::moveCrossTo(QPointF at) {
  if (slice_.empty()) return;
  emit crossMoved(placeUnder(at).cwiseMax(box_mm_.min()).cwiseMin(box_mm_.max()));
}

void SliceView::mousePressEvent(QMouseEvent* event) {
  last_mouse_ = event->position();
  if (overlays_.press(*geometry_, *event)) return;
  if (event->button() == Qt::LeftButton) moveCrossTo(event->position());
}

void SliceView::mouseMoveEvent(QMouseEvent* event) {
  const QPointF by = event->position() - last_mouse_;
  last_mouse_ = event->position();
  if (overlays_.move(*geometry_, *event)) return;
  if (event->buttons() & Qt::LeftButton) {
    moveCrossTo(event->position());
  } else if (event->buttons() & Qt::RightButton) {
    GreyWindow grey = grey_;
    grey.width =
        std::clamp(grey.width * std::exp(by.x() * 0.01), 1e-4 * full_width_, 2.0 * full_width_);
    grey.level -= by.y() * 0.003 * grey.width;
    emit greyChanged(grey);
  }
}

void SliceView::mouseReleaseEvent(QMouseEvent* event) { overlays_.release(*geometry_, *event); }

void SliceView::mouseDoubleClickEvent(QMouseEvent* event) {
  if (!overlays_.doubleClick(*geometry_, *event)) mousePressEvent(event);
}

void SliceView::keyPressEvent(QKeyEvent* event) {
  if (!overlays_.key(*geometry_, *event)) QWidget::keyPressEvent(event);
}

void SliceView::wheelEvent(QWheelEvent* event) {
  const double notches = event->angleDelta().y() / 120.0;
  const Eigen::Vector3d p = cross_mm_ + axes_.normal * (notches * step_mm_);
  if (!slice_.empty()) emit crossMoved(p.cwiseMax(box_mm_.min()).cwiseMin(box_mm_.max()));
  event->accept();
}

}  // namespace ui
