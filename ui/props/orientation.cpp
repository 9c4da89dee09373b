// SPDX-License-Identifier: BSD-3-Clause
#include "ui/props/orientation.h"

#include <QApplication>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/style/scene_colours.h"

namespace ui {
namespace {

// of a direction along an axis, for its letter to be enough: within 45 degrees
constexpr double kEnough = 0.7072;
constexpr double kCubeEdge = 0.46;     // of the square that the cube fills
constexpr double kCubeDistance = 5.0;  // half edges, from its middle to the eye
constexpr double kCubeMargin = 10.0;   // px
constexpr double kEdgeMargin = 8.0;    // px
using style::kCubeDark, style::kCubeLight;

}  // namespace

void paintPlated(QPainter& painter, const PlatedWords& words, const QFont& font,
                 const QColor& colour) {
  painter.setPen(Qt::NoPen);
  painter.setBrush(style::kViewGround);
  painter.drawRoundedRect(words.plate, 3.0, 3.0);
  painter.setFont(font);
  painter.setPen(colour);
  painter.drawText(words.plate, Qt::AlignCenter | Qt::TextDontClip, words.text);
}

QSizeF plateSize(const QFont& font, const QString& text) {
  const QFontMetricsF metrics(font);
  return {std::ceil(metrics.horizontalAdvance(text)) + 6.0, std::ceil(metrics.ascent()) + 2.0};
}

Eigen::Vector3d directionOf(Side side) {
  switch (side) {
    case Side::Anterior:
      return -Eigen::Vector3d::UnitY();
    case Side::Posterior:
      return Eigen::Vector3d::UnitY();
    case Side::Left:
      return Eigen::Vector3d::UnitX();
    case Side::Right:
      return -Eigen::Vector3d::UnitX();
    case Side::Superior:
      return Eigen::Vector3d::UnitZ();
    case Side::Inferior:
      break;
  }
  return -Eigen::Vector3d::UnitZ();
}

Eigen::Vector3d upOf(Side side) {
  const bool along_the_head = side == Side::Superior || side == Side::Inferior;
  return along_the_head ? directionOf(Side::Anterior) : Eigen::Vector3d::UnitZ();
}

QString letterOf(Side side) {
  constexpr char kLetters[] = "APLRSI";
  return QString(QLatin1Char(kLetters[static_cast<int>(side)]));
}

QString lettersTowards(const Eigen::Vector3d& direction_W) {
  const Eigen::Vector3d d = direction_W.normalized();
  std::array<std::pair<double, Side>, 3> parts{
      {{d.x(), d.x() > 0.0 ? Side::Left : Side::Right},
       {d.y(), d.y() > 0.0 ? Side::Posterior : Side::Anterior},
       {d.z(), d.z() > 0.0 ? Side::Superior : Side::Inferior}}};
  std::ranges::stable_sort(
      parts, [](const auto& a, const auto& b) { return std::abs(a.first) > std::abs(b.first); });
  const QString first = letterOf(parts[0].second);
  return std::abs(parts[0].first) < kEnough ? first + letterOf(parts[1].second) : first;
}

std::array<QString, 4> edgeLettersOf(const Eigen::Matrix3d& axes) {
  return {lettersTowards(-axes.col(0)), lettersTowards(axes.col(0)), lettersTowards(axes.col(1)),
          lettersTowards(-axes.col(1))};
}

QFont edgeLetterFont() {
  QFont font = QApplication::font();
  font.setBold(true);
  font.setPixelSize(17);
  return font;
}

std::array<PlatedWords, 4> edgeLettersIn(const QRectF& area, const Eigen::Matrix3d& axes,
                                         const std::vector<QRectF>& covered) {
  constexpr double kStep = 4.0;  // px
  const QFont font = edgeLetterFont();
  const std::array<QString, 4> letters = edgeLettersOf(axes);
  const QRectF room = area.adjusted(kEdgeMargin, kEdgeMargin, -kEdgeMargin, -kEdgeMargin);
  const std::array<QPointF, 4> inward{{{1.0, 0.0}, {-1.0, 0.0}, {0.0, 1.0}, {0.0, -1.0}}};
  std::array<PlatedWords, 4> placed;
  for (std::size_t n = 0; n < letters.size(); ++n) {
    const QSizeF size = plateSize(font, letters[n]);
    QRectF first(QPointF{}, size);
    first.moveCenter(room.center());
    if (n == 0) first.moveLeft(room.left());
    if (n == 1) first.moveRight(room.right());
    if (n == 2) first.moveTop(room.top());
    if (n == 3) first.moveBottom(room.bottom());
    placed[n] = {letters[n], first};
    const QPointF in = inward[n], along{in.y(), in.x()};
    const auto isFree = [&](const QRectF& plate) {
      return room.contains(plate) && std::ranges::none_of(covered, [&](const QRectF& part) {
               return part.intersects(plate);
             });
    };
    // along its edge as far as it goes, then away from it, towards the body
    const double reach = std::max(room.width(), room.height());
    bool found = isFree(first);
    for (double away = 0.0; !found && away < 0.5 * reach; away += kStep)
      for (double aside = 0.0; !found && aside < reach; aside += kStep)
        for (const double way : {1.0, -1.0}) {
          const QRectF plate = first.translated(in * away + along * (way * aside));
          if (found || !isFree(plate)) continue;
          found = true;
          placed[n].plate = plate;
        }
  }
  return placed;
}

QRectF OrientationCube::placeIn(const QSizeF& view) {
  return {view.width() - kCubeMargin - kSize, kCubeMargin, kSize, kSize};
}

std::vector<OrientationCube::Face> OrientationCube::facesTowardsViewer(
    const QRectF& place, const Eigen::Matrix3d& axes) {
  std::vector<Face> faces;
  const double half = 0.5 * kCubeEdge * place.width();
  // in half edges: x right, y up, z towards the viewer
  const auto seen = [&](const Eigen::Vector3d& p_W) {
    const Eigen::Vector3d p = axes.transpose() * p_W;
    const double scale = half * kCubeDistance / (kCubeDistance - p.z());
    return QPointF{place.center().x() + p.x() * scale, place.center().y() - p.y() * scale};
  };
  for (const Side side : kSides) {
    const Eigen::Vector3d out = directionOf(side), up = upOf(side), right = up.cross(out);
    const Eigen::Vector3d to_eye = (kCubeDistance * axes.col(2) - out).normalized();
    const double facing = out.dot(to_eye);
    if (facing <= 0.0) continue;
    Face face{.side = side, .outline = {}, .facing = facing};
    for (const auto& [across, along] :
         {std::pair{-1.0, 1.0}, std::pair{1.0, 1.0}, std::pair{1.0, -1.0}, std::pair{-1.0, -1.0}})
      face.outline << seen(out + across * right + along * up);
    faces.push_back(std::move(face));
  }
  return faces;
}

void OrientationCube::paint(QPainter& painter, const QRectF& place, const Eigen::Matrix3d& axes,
                            bool known) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  QFont font = QApplication::font();
  font.setBold(true);
  font.setPixelSize(64);
  for (const Face& face : facesTowardsViewer(place, axes)) {
    const auto mixed = [&](int dark, int light) {
      return dark + static_cast<int>((light - dark) * face.facing);
    };
    painter.setPen(QPen(style::kCubeLine, 1.0));
    painter.setBrush(QColor(mixed(kCubeDark.red(), kCubeLight.red()),
                            mixed(kCubeDark.green(), kCubeLight.green()),
                            mixed(kCubeDark.blue(), kCubeLight.blue())));
    painter.drawPolygon(face.outline);
    // the letter lies on the face, so it is never mirrored and turns with the patient
    constexpr double kPage = 100.0;
    const QPolygonF page({{0.0, 0.0}, {kPage, 0.0}, {kPage, kPage}, {0.0, kPage}});
    QTransform onto;
    if (!QTransform::quadToQuad(page, face.outline, onto)) continue;
    painter.save();
    painter.setTransform(onto, true);
    QPainterPath path;
    const QString letter = known ? letterOf(face.side) : QStringLiteral("?");
    const QFontMetricsF metrics(font);
    path.addText(
        {0.5 * (kPage - metrics.horizontalAdvance(letter)), 0.5 * (kPage + metrics.capHeight())},
        font, letter);
    painter.fillPath(path, style::kCubeLetter);
    painter.restore();
  }
  painter.restore();
}

std::optional<Side> OrientationCube::sideAt(QPointF at, const QRectF& place,
                                            const Eigen::Matrix3d& axes) {
  for (const Face& face : facesTowardsViewer(place, axes))
    if (face.outline.containsPoint(at, Qt::OddEvenFill)) return face.side;
  return {};
}

}  // namespace ui
