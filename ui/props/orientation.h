// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <QPolygonF>
#include <QRectF>
#include <QString>
#include <array>
#include <optional>
#include <vector>

class QColor;
class QFont;
class QPainter;

namespace ui {

/// A side of the patient, in the order of the keys of the standard views.
enum class Side { Anterior, Posterior, Left, Right, Superior, Inferior };
inline constexpr std::array kSides{Side::Anterior, Side::Posterior, Side::Left,
                                   Side::Right,    Side::Superior,  Side::Inferior};

/// The direction of a side in W (patient LPS).
Eigen::Vector3d directionOf(Side side);
/// What is up where this side faces the viewer: the head, or the front where the head does not do.
Eigen::Vector3d upOf(Side side);
QString letterOf(Side side);

/// The letters of a direction of W, the strongest first: "L", or "LA" from 45 degrees beside the
/// axis on.
QString lettersTowards(const Eigen::Vector3d& direction_W);

/// The letters at the left, right, upper and lower edge of a picture with these axes (columns:
/// right, up, towards the viewer).
std::array<QString, 4> edgeLettersOf(const Eigen::Matrix3d& axes);

/// Words on a plate in the colour of the view's ground, so that nothing shines through them.
struct PlatedWords {
  QString text;
  QRectF plate;
};
void paintPlated(QPainter& painter, const PlatedWords& words, const QFont& font,
                 const QColor& colour);
/// The room that a plate needs.
QSizeF plateSize(const QFont& font, const QString& text);

QFont edgeLetterFont();
/// The edge letters, a little off the edges of `area`: each in the middle of its edge, or as near
/// to that as what is `covered` leaves it room.
std::array<PlatedWords, 4> edgeLettersIn(const QRectF& area, const Eigen::Matrix3d& axes,
                                         const std::vector<QRectF>& covered);

/// A cube that turns with the patient, with a letter on each side.
class OrientationCube {
 public:
  static constexpr double kSize = 84.0;  ///< px, of the square that it fills

  /// Where it is in a view: the upper right corner.
  static QRectF placeIn(const QSizeF& view);
  /// Writes "?" in place of the letters if the orientation is not known.
  static void paint(QPainter& painter, const QRectF& place, const Eigen::Matrix3d& axes,
                    bool known);
  /// The side whose face is at a place of the view.
  static std::optional<Side> sideAt(QPointF at, const QRectF& place, const Eigen::Matrix3d& axes);

 private:
  struct Face {
    Side side;
    QPolygonF outline;  ///< from the letter's upper left corner, clockwise as read
    double facing;      ///< share of it that is seen
  };
  static std::vector<Face> facesTowardsViewer(const QRectF& place, const Eigen::Matrix3d& axes);
};

}  // namespace ui
