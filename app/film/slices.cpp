// SPDX-License-Identifier: BSD-3-Clause
#include "app/film/slices.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkTextProperty.h>
#include <vtkTextRenderer.h>

#include <QCoreApplication>
#include <QImage>
#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <utility>

#include "ui/props/section.h"
#include "ui/style/scene_colours.h"
#include "ui/views/grey_presets.h"
#include "ui/views/plane_colours.h"
#include "ui/views/slice_readout.h"

namespace app {
namespace {

constexpr std::array kPanes{ui::Plane::Axial, ui::Plane::Coronal, ui::Plane::Sagittal};
constexpr int kTextOfPane = 16, kLeastText = 9;  // a pane's height in lines; px
constexpr double kRoomAroundBody = 1.04, kLongestBar = 0.3;
constexpr double kCrossGap = 0.5, kTipRing = 0.25;  // lines of text

QString nameOf(ui::Plane plane) {
  const char* const names[] = {"Axial", "Coronal", "Sagittal"};
  return QCoreApplication::translate("ui::SliceView", names[static_cast<int>(plane)]);
}

/// Text without Qt's fonts, which need a program with windows.
QImage imageOf(const QString& text, int pixels, const QColor& colour, bool bold) {
  vtkNew<vtkTextProperty> look;
  look->SetFontSize(pixels);
  look->SetBold(bold);
  look->SetColor(colour.redF(), colour.greenF(), colour.blueF());
  vtkNew<vtkImageData> drawn;
  constexpr int kDotsPerInch = 72;  // a point is a pixel
  int size[2] = {0, 0};
  auto* const renderer = vtkTextRenderer::GetInstance();
  if (renderer == nullptr ||
      !renderer->RenderString(look, text.toStdString(), drawn, size, kDotsPerInch))
    return {};
  QImage image(size[0], size[1], QImage::Format_RGBA8888);
  int extent[6];
  drawn->GetExtent(extent);
  const std::size_t row = 4 * static_cast<std::size_t>(size[0]);
  for (int y = 0; y < size[1]; ++y)
    std::memcpy(image.scanLine(size[1] - 1 - y),
                drawn->GetScalarPointer(extent[0], extent[2] + y, 0), row);
  return image;
}

/// Writes a text about a place: `share` of it lies to the left of the place.
void write(QPainter& painter, QPointF at, double share, const QString& text, int pixels,
           const QColor& colour, bool bold = false) {
  const QImage image = imageOf(text, pixels, colour, bold);
  painter.drawImage(QPointF{at.x() - share * image.width(), at.y() - 0.5 * image.height()}, image);
}

}  // namespace

FilmSlices::FilmSlices(int width, int height, std::optional<ui::GreyWindow> grey)
    : width_(std::min(width, height) / 6 * 2), height_(height), wish_(grey) {}

void FilmSlices::show(const ui::Picture& picture) {
  volume_ = picture.volume;
  if (!volume_) return;
  slice_.show(picture);
  box_mm_ = ui::boxOf_mm(volume_->grid);
  body_mm_ = picture.body_mm.isEmpty() ? box_mm_ : picture.body_mm;
  cross_mm_ = body_mm_.center();
  grey_ = wish_.value_or(ui::firstGrey(*volume_));
}

void FilmSlices::show(haptics::TriangleMesh tool) { tool_ = std::move(tool); }

void FilmSlices::draw(const haptics::Step& step, FilmFrame& frame) {
  QImage column(width_, height_, QImage::Format_RGB888);
  column.fill(ui::style::kSliceGround);
  const haptics::Pose* X_WP = nullptr;
  if (!tool_.vertices.empty() && step.X_WP.matrix().allFinite()) {
    X_WP = &step.X_WP;
    cross_mm_ = (*X_WP * ui::tipOf(tool_)) * ui::kMmPerM;
  }
  if (volume_) {
    QPainter painter(&column);
    const int side = height_ / static_cast<int>(kPanes.size());
    for (std::size_t n = 0; n < kPanes.size(); ++n)
      drawSlice(painter, kPanes[n], {0, static_cast<int>(n) * side, width_, side}, X_WP);
  }
  const std::size_t row = 3 * static_cast<std::size_t>(width_);
  for (int y = 0; y < height_; ++y)
    std::memcpy(frame.rgb.data() + 3 * (static_cast<std::size_t>(height_ - y) *
                                            static_cast<std::size_t>(frame.width) -
                                        static_cast<std::size_t>(width_)),
                column.constScanLine(y), row);
}

void FilmSlices::drawSlice(QPainter& painter, ui::Plane plane, const QRect& pane,
                           const haptics::Pose* X_WP) {
  const ui::PlaneAxes axes = ui::axesOf(plane);
  const int text = std::max(pane.height() / kTextOfPane, kLeastText);
  const int margin = text + text / 2;
  const QRect picture = pane.adjusted(margin, margin, -margin, -margin);
  if (picture.isEmpty()) return;
  const auto along = [](const Eigen::AlignedBox3d& box, const Eigen::Vector3d& axis) {
    return box.sizes().dot(axis.cwiseAbs());
  };
  const double mm_per_pixel = std::max({along(body_mm_, axes.right) / picture.width(),
                                        along(body_mm_, axes.up) / picture.height(), 1e-6}) *
                              kRoomAroundBody;
  const Eigen::Vector3d middle =
      body_mm_.center() + axes.normal * axes.normal.dot(cross_mm_ - body_mm_.center());
  slice_.cut(axes, middle, picture.size(), mm_per_pixel, {});
  painter.setClipRect(picture);
  painter.drawImage(picture.topLeft(), slice_.picture(grey_));

  painter.setRenderHint(QPainter::Antialiasing);
  const QPointF centre = QRectF(picture).center();
  const auto projected = [&](const Eigen::Vector3d& p_mm) {
    return QPointF{centre.x() + (p_mm - middle).dot(axes.right) / mm_per_pixel,
                   centre.y() - (p_mm - middle).dot(axes.up) / mm_per_pixel};
  };
  const QPointF cross = projected(cross_mm_);
  const double reach = picture.width() + picture.height(), gap = kCrossGap * text;
  for (const ui::Plane other : kPanes) {
    if (other == plane) continue;
    const bool upright = std::abs(ui::axesOf(other).normal.dot(axes.right)) > 0.5;
    const QPointF way = upright ? QPointF{0.0, 1.0} : QPointF{1.0, 0.0};
    painter.setPen(QPen(ui::colourOf(other), 1.0));
    for (const double side : {1.0, -1.0})
      painter.drawLine(cross + side * gap * way, cross + side * reach * way);
  }
  if (X_WP != nullptr) {
    painter.setPen(QPen(ui::style::kProxyLine, 1.5));
    painter.drawEllipse(cross, kTipRing * text, kTipRing * text);
    for (const QPolygonF& line : ui::sectionOf(tool_, *X_WP, axes, middle)) {
      QPolygonF outline;
      for (const QPointF& p : line)
        outline << centre + QPointF{p.x() / mm_per_pixel, -p.y() / mm_per_pixel};
      painter.drawPolyline(outline);
    }
  }
  painter.setClipping(false);
  painter.setRenderHint(QPainter::Antialiasing, false);

  const double above = pane.top() + 0.5 * margin, below = pane.bottom() + 1 - 0.5 * margin;
  const double left = pane.left() + 0.25 * text, right = pane.right() + 1 - 0.25 * text;
  write(painter, {left, above}, 0.0, nameOf(plane), text, ui::colourOf(plane), true);
  if (volume_->orientation_known) {
    const auto letters = ui::lettersOf(axes);
    const QColor& ink = ui::style::kLetter;
    write(painter, {pane.left() + 0.5 * margin, centre.y()}, 0.5, letters[0], text, ink, true);
    write(painter, {pane.right() + 1 - 0.5 * margin, centre.y()}, 0.5, letters[1], text, ink, true);
    write(painter, {centre.x(), above}, 0.5, letters[2], text, ink, true);
    write(painter, {centre.x(), below}, 0.5, letters[3], text, ink, true);
  } else {
    write(painter, {right, above}, 1.0,
          QCoreApplication::translate("ui::SliceView", "left/right unknown"), text,
          ui::style::kViewAttention);
  }
  const QColor& ink = ui::style::kReadout;
  const double mm = ui::rulerLength_mm(kLongestBar * picture.width() * mm_per_pixel);
  const double end = picture.left() + mm / mm_per_pixel, tick = 0.2 * text;
  // beside the picture's foot, so that the words below have the width
  painter.setPen(QPen(ink, 1.0));
  const double bar = pane.bottom() + 1 - margin + tick;
  painter.drawLine(QPointF(picture.left(), bar), QPointF(end, bar));
  for (const double x : {double(picture.left()), end})
    painter.drawLine(QPointF{x, bar - tick}, QPointF{x, bar + tick});
  const int small = std::max(text * 3 / 4, kLeastText);
  write(painter, {double(picture.left()), below + 0.2 * text}, 0.0, ui::rulerWords(mm), small, ink);
  const int digits = std::abs(grey_.width) < 10.0 ? 2 : 0;
  const auto number = [&](double value) {
    return ui::readoutLocale().toString(value, 'f', digits);
  };
  write(painter, {right, below}, 1.0,
        QCoreApplication::translate("ui::SliceView", "W %1  L %2")
            .arg(number(grey_.width), number(grey_.level)),
        small, ink);
}

}  // namespace app
