// SPDX-License-Identifier: BSD-3-Clause
#include "ui/overlays/measure_words.h"

#include <QCoreApplication>
#include <QLocale>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "ui/controls/lengths.h"
#include "ui/props/picture.h"

namespace ui {
namespace {

constexpr double kDegPerRad = 180.0 / std::numbers::pi;

QString measureTr(const char* words) { return QCoreApplication::translate("ui::Measure", words); }

/// How far the voxel reaches along `change`, as accuracyOf() says.
double shareOf(const haptics::Grid& grid, const Eigen::Vector3d& change) {
  const Eigen::Vector3d size_mm = grid.spacing * kMmPerM;
  const double along = size_mm.cwiseProduct(grid.direction.transpose() * change).norm();
  return std::min(0.5 * std::numbers::sqrt3 * along, 0.5 * size_mm.norm() * change.norm());
}

/// By how much the angle [rad] changes for each mm of its three places.
std::array<Eigen::Vector3d, 3> changesOfAngle(const Measure& measure, double angle) {
  const Eigen::Vector3d to_first = measure.places_mm[0] - measure.places_mm[1];
  const Eigen::Vector3d to_last = measure.places_mm[2] - measure.places_mm[1];
  const Eigen::Vector3d a = to_first.normalized(), b = to_last.normalized();
  const double sine = std::sin(angle);
  // where the legs lie in one line, any direction across them counts alike
  const Eigen::Vector3d across = a.unitOrthogonal();
  const bool straight = sine < 1e-6;
  const Eigen::Vector3d first =
      straight ? across : Eigen::Vector3d{(a * std::cos(angle) - b) / sine};
  const Eigen::Vector3d last =
      straight ? across : Eigen::Vector3d{(b * std::cos(angle) - a) / sine};
  const Eigen::Vector3d by_first = first / to_first.norm(), by_last = last / to_last.norm();
  // legs that coincide turn alike as the corner moves across them
  const bool folded = straight && angle < 1.0;
  return {by_first, by_first + (folded ? -1.0 : 1.0) * by_last, by_last};
}

QString valueWords(double value, const QString& unit) {
  // three digits or a whole number: more would be noise
  const double size = std::abs(value);
  int decimals = 0;
  if (unit != "HU" && size < 100.0 && size != std::round(size))
    decimals = std::clamp(2 - static_cast<int>(std::floor(std::log10(size))), 0, 9);
  const QString number = numberWords(value, decimals);
  return unit.isEmpty() ? number : number + QChar(QChar::Nbsp) + unit;
}

bool inScan(const haptics::Grid& grid, const Eigen::Vector3d& p_W_mm) {
  const haptics::Vec3 index = grid.indexOf(p_W_mm / kMmPerM);
  constexpr double kRoom = 0.5 + 1e-6;  // voxels
  for (int a = 0; a < 3; ++a)
    if (!(index[a] >= -kRoom &&
          index[a] <= static_cast<double>(grid.dims[std::size_t(a)]) - 1.0 + kRoom))
      return false;
  return true;
}

}  // namespace

double accuracyOf(const haptics::Grid& grid, std::span<const Eigen::Vector3d> changes) {
  double squares = 0.0;
  for (const Eigen::Vector3d& change : changes) squares += std::pow(shareOf(grid, change), 2);
  return std::sqrt(squares);
}

QString numberWords(double number, int decimals) {
  QLocale locale;
  locale.setNumberOptions(locale.numberOptions() | QLocale::OmitGroupSeparator);
  return locale.toString(number, 'f', decimals);
}

QString rounded(double number, double accuracy, const QString& unit) {
  if (!std::isfinite(number) || !(accuracy > 0.0)) return measureTr("unknown");
  const auto magnitude = [](double size) { return static_cast<int>(std::floor(std::log10(size))); };
  // 0.96 is shown as 1, not as 1.0
  int digit = magnitude(accuracy);
  if (std::round(accuracy / std::pow(10.0, digit)) >= 10.0) ++digit;
  const double step = std::pow(10.0, digit);
  const int decimals = std::max(0, -digit);
  const auto words = [&](double size) {
    const double whole = std::round(size / step) * step;
    return numberWords(whole == 0.0 ? 0.0 : whole, decimals);
  };
  const QString room = unit == QStringLiteral("°") ? QString{} : QString(QChar(QChar::Nbsp));
  return QStringLiteral("%1%2%3 ± %4%2%3")
      .arg(words(number), room, unit, words(accuracy))
      .replace(QStringLiteral(" ± "), QString(QChar(QChar::Nbsp)) + "±" + QChar(QChar::Nbsp));
}

double distanceOf_mm(const Measure& measure) {
  return (measure.places_mm[1] - measure.places_mm[0]).norm();
}

double angleOf_deg(const Measure& measure) {
  const Eigen::Vector3d a = measure.places_mm[0] - measure.places_mm[1];
  const Eigen::Vector3d b = measure.places_mm[2] - measure.places_mm[1];
  if (!(a.norm() > 0.0) || !(b.norm() > 0.0)) return std::numeric_limits<double>::quiet_NaN();
  // exact near 0 and 180 degrees too
  return std::atan2(a.cross(b).norm(), a.dot(b)) * kDegPerRad;
}

std::vector<Eigen::Vector3d> arcOf(const Measure& measure) {
  constexpr int kSteps = 16;
  if (measure.kind != MeasureKind::Angle || measure.places_mm.size() != 3) return {};
  const Eigen::Vector3d corner = measure.places_mm[1];
  const Eigen::Vector3d a = measure.places_mm[0] - corner, b = measure.places_mm[2] - corner;
  const Eigen::Vector3d about = a.cross(b);
  if (!(about.norm() > 1e-9)) return {};
  const double radius = 0.3 * std::min(a.norm(), b.norm());
  const double angle = std::atan2(about.norm(), a.dot(b));
  std::vector<Eigen::Vector3d> arc;
  for (int s = 0; s <= kSteps; ++s)
    arc.push_back(corner + Eigen::AngleAxisd(angle * s / kSteps, about.normalized()) *
                               (a.normalized() * radius));
  return arc;
}

QString valueOf(const Measure& measure, const MeasuredScan& scan) {
  if (measure.places_mm.size() != placesOf(measure.kind)) return {};
  switch (measure.kind) {
    case MeasureKind::Distance: {
      const double length = distanceOf_mm(measure);
      const Eigen::Vector3d between = measure.places_mm[1] - measure.places_mm[0];
      const Eigen::Vector3d along =
          length > 0.0 ? Eigen::Vector3d{between / length} : Eigen::Vector3d::UnitX();
      const double accuracy = accuracyOf(scan.grid, std::array{along, along});
      return rounded(length / mmPerLengthUnit(), accuracy / mmPerLengthUnit(), lengthUnitName());
    }
    case MeasureKind::Angle: {
      const double angle = angleOf_deg(measure);
      if (!std::isfinite(angle)) return measureTr("unknown");
      const double accuracy =
          accuracyOf(scan.grid, changesOfAngle(measure, angle / kDegPerRad)) * kDegPerRad;
      if (accuracy > 90.0) return measureTr("unknown: the legs are too short");
      return rounded(angle, accuracy, QStringLiteral("°"));
    }
    case MeasureKind::Point:
      if (!scan.value || !inScan(scan.grid, measure.places_mm[0]))
        return measureTr("outside the scan");
      return valueWords(scan.value(measure.places_mm[0]), scan.unit);
    case MeasureKind::Note:
      break;
  }
  return {};
}

QString nameOf(MeasureKind kind) {
  switch (kind) {
    case MeasureKind::Distance:
      return measureTr("Distance");
    case MeasureKind::Angle:
      return measureTr("Angle");
    case MeasureKind::Point:
      return measureTr("Point");
    case MeasureKind::Note:
      break;
  }
  return measureTr("Note");
}

QString plainLine(const QString& text) {
  QString line;
  for (const QChar c : text.left(kLongestMeasureText))
    line += c.category() == QChar::Other_Control || c == QChar::LineSeparator ||
                    c == QChar::ParagraphSeparator
                ? QChar(QChar::Space)
                : c;
  return line.trimmed();
}

}  // namespace ui
