// SPDX-License-Identifier: BSD-3-Clause
#include "ui/panels/load_plot.h"

#include <QLocale>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "ui/panels/performance_words.h"
#include "ui/style/look.h"
#include "ui/style/style.h"

namespace ui {
namespace {

constexpr double kMark = 4.0;

/// Whole decades around what is shown.
struct Decades {
  int from = 0, to = 1;

  Decades(double least, double greatest)
      : from(static_cast<int>(std::floor(std::log10(least)))),
        to(std::max(from + 1, static_cast<int>(std::ceil(std::log10(greatest))))) {}
  double share(double value) const { return (std::log10(value) - from) / (to - from); }
};

/// 0.01, 0.1, 1, 10: a decade of milliseconds, written out.
QString plainDecade(int exponent) {
  return QLocale().toString(std::pow(10.0, exponent), 'f', std::max(0, -exponent));
}

}  // namespace

LoadPlot::LoadPlot(QWidget* parent) : QWidget(parent) {
  offerSpoken();
  setAccessibleName(tr("Tick time over number of points"));
}

void LoadPlot::show(const TickTimes& present, std::vector<TickTimes> tried, double budget) {
  present_ = present;
  tried_ = std::move(tried);
  budget_ = budget;
  QStringList figures{tr("budget %1 ms").arg(milliseconds(budget))};
  const auto add = [&](const TickTimes& t) {
    figures << tr("%1 points: median %2, 99 % within %3, longest %4 ms")
                   .arg(counted(t.points), milliseconds(t.median), milliseconds(t.p99),
                        milliseconds(t.longest));
  };
  add(present_);
  for (const TickTimes& t : tried_) add(t);
  setAccessibleDescription(figures.join("; "));
  setToolTip(figures.join('\n'));
  update();
}

void LoadPlot::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(rect(), palette().color(QPalette::Base));
  if (present_.points == 0) return;
  const QFont font = style::font(style::Type::Small);
  painter.setFont(font);
  const QFontMetrics metrics(font);

  double fewest = present_.points, most = present_.points;
  double quickest = present_.median, slowest = std::max(present_.longest, budget_);
  for (const TickTimes& t : tried_) {
    fewest = std::min<double>(fewest, t.points);
    most = std::max<double>(most, t.points);
    quickest = std::min(quickest, t.median);
    slowest = std::max(slowest, t.longest);
  }
  // in ms; no finer than the clock
  const Decades along(fewest, most), up(std::max(1e-3, quickest * 1e3), slowest * 1e3);
  const int label = metrics.horizontalAdvance(plainDecade(up.from)) + 6;
  const QRectF area = QRectF(rect()).adjusted(label, 2.0 * metrics.height() + 4.0, -14.0,
                                              -2.0 * metrics.height() - 6.0);
  const auto x = [&](double points) { return area.left() + along.share(points) * area.width(); };
  const auto y = [&](double seconds) {
    return area.bottom() - std::max(0.0, up.share(std::max(1e-7, seconds * 1e3))) * area.height();
  };

  // the grid and what its lines are
  const QColor text = palette().color(QPalette::Text);
  const QPen grid(palette().color(QPalette::Mid), 1.0, Qt::DotLine);
  for (int e = up.from; e <= up.to; ++e) {
    const double at = y(std::pow(10.0, e) * 1e-3);
    painter.setPen(grid);
    painter.drawLine(QPointF{area.left(), at}, QPointF{area.right(), at});
    painter.setPen(text);
    painter.drawText(QRectF{0.0, at - metrics.height() / 2.0, label - 4.0, 1.0 * metrics.height()},
                     Qt::AlignRight | Qt::AlignVCenter, plainDecade(e));
  }
  for (int e = along.from; e <= along.to; ++e) {
    const double at = x(std::pow(10.0, e));
    painter.setPen(grid);
    painter.drawLine(QPointF{at, area.top()}, QPointF{at, area.bottom()});
    painter.setPen(text);
    // the outer ones stay within the picture
    const QString number = counted(static_cast<int>(std::lround(std::pow(10.0, e))));
    const double half = metrics.horizontalAdvance(number) / 2.0 + 1.0;
    const double middle = std::clamp(at, half, width() - half);
    painter.drawText(QRectF{middle - half, area.bottom() + 6.0, 2.0 * half, 1.0 * metrics.height()},
                     Qt::AlignCenter, number);
  }
  painter.drawText(
      QRectF{0.0, height() - metrics.height() - 1.0, 1.0 * width(), 1.0 * metrics.height()},
      Qt::AlignCenter, tr("points"));

  const QColor &present_colour = style::colours().attention,
               &tried_colour = style::colours().accent;
  // the budget, named at the free end
  painter.setPen(QPen(text, 1.2, Qt::DashLine));
  painter.drawLine(QPointF{area.left(), y(budget_)}, QPointF{area.right(), y(budget_)});
  painter.setPen(text);
  painter.drawText(QPointF{area.left() + 4.0, y(budget_) - 3.0},
                   tr("budget %1 ms").arg(milliseconds(budget_)));

  const auto bar = [&](const TickTimes& t, const QColor& colour) {
    painter.setPen(QPen(colour, 1.0));
    painter.drawLine(QPointF{x(t.points), y(t.median)}, QPointF{x(t.points), y(t.longest)});
  };
  painter.setPen(QPen(tried_colour, 1.5));
  for (std::size_t i = 1; i < tried_.size(); ++i)
    painter.drawLine(QPointF{x(tried_[i - 1].points), y(tried_[i - 1].p99)},
                     QPointF{x(tried_[i].points), y(tried_[i].p99)});
  for (const TickTimes& t : tried_) {
    bar(t, tried_colour);
    const QPointF at{x(t.points), y(t.p99)};
    if (t.carried) {
      painter.setPen(Qt::NoPen);
      painter.setBrush(tried_colour);
      painter.drawEllipse(at, kMark, kMark);
    } else {
      painter.setPen(QPen(tried_colour, 2.0));
      painter.drawLine(at + QPointF{-kMark, -kMark}, at + QPointF{kMark, kMark});
      painter.drawLine(at + QPointF{-kMark, kMark}, at + QPointF{kMark, -kMark});
    }
  }
  bar(present_, present_colour);
  painter.setPen(Qt::NoPen);
  painter.setBrush(present_colour);
  const QPointF at{x(present_.points), y(present_.p99)};
  painter.drawPolygon(QPolygonF{{at + QPointF{0.0, -kMark - 1.0}, at + QPointF{kMark + 1.0, 0.0},
                                 at + QPointF{0.0, kMark + 1.0}, at + QPointF{-kMark - 1.0, 0.0}}});

  // what is what, above
  painter.setPen(text);
  painter.drawText(QRectF{4.0, 1.0, width() - 8.0, 1.0 * metrics.height()},
                   Qt::AlignLeft | Qt::AlignTop, tr("Tick, ms: 99 %, and median to longest"));
  const double row = 1.0 + metrics.height();
  const QRectF legend{4.0, row, width() - 8.0, 1.0 * metrics.height()};
  painter.setPen(present_colour);
  painter.drawText(legend, Qt::AlignLeft | Qt::AlignTop, tr("◆ present tool"));
  painter.setPen(tried_colour);
  painter.drawText(legend, Qt::AlignRight | Qt::AlignTop, tr("● carried  × too many"));
}

}  // namespace ui
