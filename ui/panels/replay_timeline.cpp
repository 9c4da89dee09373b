// SPDX-License-Identifier: BSD-3-Clause
#include "ui/panels/replay_timeline.h"

#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>
#include <array>
#include <cmath>

#include "ui/controls/bindings.h"
#include "ui/controls/time_words.h"
#include "ui/panels/force_words.h"
#include "ui/style/look.h"
#include "ui/style/style.h"

namespace ui {
namespace {

constexpr double kLeft = 44.0;  // pixels left of the track, for the axis of the force
constexpr double kRight = 7.0;
constexpr double kLane = 15.0;   // height of the ticks' heads
constexpr double kFoot = 16.0;   // height of the axis of time
constexpr double kLate = 5.0;    // height of a late tick's line
constexpr double kTimes = 80.0;  // least way between two times on their axis
constexpr double kHead = 4.0;    // half a head's width
constexpr double kReach = 4.0;   // how near the mouse must come to a tick
constexpr int kMostLines = 8;    // of ticks in one tool tip
constexpr int kLongestMark = 160;

/// Ticks that look alike.
enum class Look { Note, Setting, Scene, Force, Loss, Late };
constexpr std::array<Look, 5> kLooks{Look::Setting, Look::Scene, Look::Force, Look::Loss,
                                     Look::Note};  // without what lies below the curve

struct KindWords {
  const char* kind;
  const char* words;
  Look look;
  const char* unit;
};
constexpr std::array<KindWords, 15> kKinds{{
    {"mark", QT_TRANSLATE_NOOP("ui::ReplayTimeline", "Mark"), Look::Note, ""},
    {"isovalue", QT_TRANSLATE_NOOP("ui::ReplayTimeline", "Isovalue"), Look::Setting, ""},
    {"stiffness", QT_TRANSLATE_NOOP("ui::ReplayTimeline", "Stiffness"), Look::Setting, " N/m"},
    {"angular_stiffness", QT_TRANSLATE_NOOP("ui::ReplayTimeline", "Angular stiffness"),
     Look::Setting, " N·m/rad"},
    {"friction", QT_TRANSLATE_NOOP("ui::ReplayTimeline", "Friction"), Look::Setting, ""},
    {"force_scale", QT_TRANSLATE_NOOP("ui::ReplayTimeline", "Force scale"), Look::Setting, ""},
    {"position_scale", QT_TRANSLATE_NOOP("ui::ReplayTimeline", "Position scale"), Look::Setting,
     ""},
    {"clutch", QT_TRANSLATE_NOOP("ui::ReplayTimeline", "Clutch"), Look::Force, ""},
    {"scene", QT_TRANSLATE_NOOP("ui::ReplayTimeline", "Scene"), Look::Scene, ""},
    {"camera", QT_TRANSLATE_NOOP("ui::ReplayTimeline", "Camera"), Look::Scene, ""},
    {"force", QT_TRANSLATE_NOOP("ui::ReplayTimeline", "Force"), Look::Force, ""},
    {"device", QT_TRANSLATE_NOOP("ui::ReplayTimeline", "Device"), Look::Force, ""},
    {"gap", QT_TRANSLATE_NOOP("ui::ReplayTimeline", "Gap: samples lost"), Look::Loss, ""},
    {"late", QT_TRANSLATE_NOOP("ui::ReplayTimeline", "Ticks that began late"), Look::Late, ""},
    {"missed", QT_TRANSLATE_NOOP("ui::ReplayTimeline", "Ticks that were missed"), Look::Late, ""},
}};

const KindWords* kindNamed(const QString& kind) {
  const auto* found = std::find_if(kKinds.begin(), kKinds.end(), [&](const KindWords& words) {
    return kind == QLatin1String(words.kind);
  });
  return found == kKinds.end() ? nullptr : found;
}

Look lookOf(const QString& kind) {
  const KindWords* words = kindNamed(kind);
  return words == nullptr ? Look::Scene : words->look;
}

QColor colourOf(Look look) {
  const style::Colours& c = style::colours();
  switch (look) {
    case Look::Note:
      return c.note;
    case Look::Setting:
      return c.setting;
    case Look::Scene:
      return c.scene;
    case Look::Force:
      return c.attention;
    case Look::Late:
      return c.dim;
    case Look::Loss:
      break;
  }
  return c.stop;
}

QString legend() {
  return ReplayTimeline::tr(
      "▼ mark  ◆ setting  ■ scene, camera  ● force, device  × samples lost  | ticks late");
}

QString wordsOf(const ReplayMark& mark) {
  const KindWords* words = kindNamed(mark.kind);
  QString text = ReplayTimeline::tr("%1  %2").arg(
      clockTime(mark.time, 3), words == nullptr ? mark.kind : ReplayTimeline::tr(words->words));
  if (mark.kind == QLatin1String("force") && mark.value) {
    const double state = *mark.value;
    if (state >= 0.0 && state <= static_cast<double>(haptics::ForceState::Fault))
      return text + QStringLiteral(": ") + nameOf(static_cast<haptics::ForceState>(state));
  }
  if (mark.value)
    text += QStringLiteral(" %L1").arg(*mark.value, 0, 'g', 6) +
            (words == nullptr ? QString{} : QString::fromUtf8(words->unit));
  if (!mark.note.isEmpty())
    text += QStringLiteral(": ") + (mark.note.size() > kLongestMark
                                        ? mark.note.left(kLongestMark) + QStringLiteral("…")
                                        : mark.note);
  return text;
}

void drawHead(QPainter& painter, Look look, QPointF at) {
  painter.setPen(Qt::NoPen);
  painter.setBrush(colourOf(look));
  const auto corner = [&](double x, double y) { return at + QPointF{x, y} * kHead; };
  switch (look) {
    case Look::Note:
      painter.drawPolygon(QPolygonF{{corner(-1.3, -1.3), corner(1.3, -1.3), corner(0, 1.3)}});
      break;
    case Look::Setting:
      painter.drawPolygon(
          QPolygonF{{corner(0, -1.2), corner(1.2, 0), corner(0, 1.2), corner(-1.2, 0)}});
      break;
    case Look::Scene:
      painter.drawRect(QRectF{corner(-0.9, -0.9), corner(0.9, 0.9)});
      break;
    case Look::Force:
      painter.drawEllipse(at, kHead, kHead);
      break;
    case Look::Loss:
      painter.setPen(QPen(colourOf(look), 2.0));
      painter.drawLine(corner(-1, -1), corner(1, 1));
      painter.drawLine(corner(-1, 1), corner(1, -1));
      break;
    case Look::Late:
      break;
  }
}

// the least of 1, 2, 5, 10, … times a power of ten that is not below it
double roundedUp(double value) {
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (value <= factor * power * (1.0 + 1e-9)) return factor * power;
  return 10.0 * power;
}

// s between two times of the axis: seconds as roundedUp() has them, then what a clock has
double timeStep(double least) {
  if (least <= 10.0) return roundedUp(std::max(0.1, least));
  for (const double step : {15.0, 30.0, 60.0, 120.0, 300.0, 600.0, 900.0, 1800.0})
    if (least <= step) return step;
  return 3600.0 * std::ceil(least / 3600.0);
}

}  // namespace

ReplayTimeline::ReplayTimeline(QWidget* parent) : QWidget(parent) {
  offerSpoken();
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(tr("Time in the recording"));
  setToolTip(tr("Click or drag to choose the time; point at an event for its name"));
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

QString ReplayTimeline::spokenName() const { return tr("%1 in seconds").arg(accessibleName()); }

QString ReplayTimeline::spokenValue() const { return clockTime(time_, 3); }

std::optional<SpokenNumber> ReplayTimeline::spokenNumber() const {
  return SpokenNumber{.now = time_, .least = track_.begin, .most = track_.end, .step = 0.001};
}

void ReplayTimeline::show(ReplayTrack track) {
  track_ = std::move(track);
  std::stable_sort(track_.marks.begin(), track_.marks.end(),
                   [](const ReplayMark& a, const ReplayMark& b) { return a.time < b.time; });
  held_.reset();
  ground_ = {};
  setTime(track_.begin);
  update();
}

void ReplayTimeline::setTime(double time) {
  time_ = time;
  setAccessibleDescription(tr("%1 of %2").arg(clockTime(time_, 1), clockTime(track_.end, 1)));
  update();
}

double ReplayTimeline::xOf(double time) const {
  const double length = track_.end - track_.begin;
  const double share = length > 0.0 ? std::clamp((time - track_.begin) / length, 0.0, 1.0) : 0.0;
  return kLeft + share * std::max(1.0, width() - kLeft - kRight);
}

double ReplayTimeline::timeAt(double x) const {
  const double share = std::clamp((x - kLeft) / std::max(1.0, width() - kLeft - kRight), 0.0, 1.0);
  return track_.begin + share * std::max(0.0, track_.end - track_.begin);
}

QRectF ReplayTimeline::curveArea() const {
  return {kLeft, kLane, width() - kLeft - kRight, height() - kLane - kFoot};
}

QString ReplayTimeline::wordsAt(double x) const {
  QStringList lines;
  int more = 0;
  for (const ReplayMark& mark : track_.marks) {
    if (std::abs(xOf(mark.time) - x) > kReach) continue;
    if (lines.size() < kMostLines)
      lines << wordsOf(mark);
    else
      ++more;
  }
  if (more > 0) lines << tr("and %n more", nullptr, more);
  return lines.join('\n');
}

bool ReplayTimeline::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  const QString words = wordsAt(help->pos().x());
  // a note may look like markup: it is shown as it was typed
  QString shown = (words.isEmpty() ? legend() : words).toHtmlEscaped();
  shown.replace('\n', QStringLiteral("<br>"));
  QToolTip::showText(help->globalPos(), QStringLiteral("<qt>%1</qt>").arg(shown), this);
  return true;
}

void ReplayTimeline::drawForce(QPainter& painter) const {
  const std::size_t bins = std::min(track_.force_least.size(), track_.force_most.size());
  float greatest = 0.0F;
  for (std::size_t i = 0; i < bins; ++i)
    if (std::isfinite(track_.force_most[i])) greatest = std::max(greatest, track_.force_most[i]);
  const QRectF area = curveArea();
  painter.setFont(style::font(style::Type::Small));
  painter.setPen(QPen(style::colours().dim, 1.0));
  const QRectF beside(0.0, area.top() - 8.0, kLeft - 4.0, area.height() + 16.0);
  painter.drawText(beside, Qt::AlignRight | Qt::AlignBottom, tr("0"));
  painter.setPen(QPen(palette().color(QPalette::Mid), 1.0));
  painter.drawLine(area.bottomLeft(), area.bottomRight());
  painter.drawLine(area.topLeft(), area.bottomLeft());
  if (!(greatest > 0.0F) || area.width() < 1.0) return;

  const double top = roundedUp(greatest);
  painter.drawLine(area.topLeft(), area.topRight());
  painter.setPen(QPen(style::colours().dim, 1.0));
  painter.drawText(beside, Qt::AlignRight | Qt::AlignTop, tr("%L1 N").arg(top));

  // a column holds all parts that touch it, so that the shortest peak is seen
  const auto y = [&](float force) {
    return area.bottom() - static_cast<double>(force) / top * area.height();
  };
  const int columns = static_cast<int>(area.width());
  const auto per_column = static_cast<double>(bins) / columns;
  painter.setPen(QPen(style::colours().solid, 1.0));
  for (int c = 0; c < columns; ++c) {
    const auto first = static_cast<std::size_t>(c * per_column);
    const auto end = std::min(
        bins, std::max(first + 1, static_cast<std::size_t>(std::ceil((c + 1) * per_column))));
    float least = greatest, most = -1.0F;
    for (std::size_t i = first; i < end; ++i)
      if (std::isfinite(track_.force_least[i]) && std::isfinite(track_.force_most[i])) {
        least = std::min(least, track_.force_least[i]);
        most = std::max(most, track_.force_most[i]);
      }
    if (most < 0.0F) continue;
    const double x = area.left() + c + 0.5;
    painter.drawLine(QPointF{x, y(std::max(0.0F, least)) + 0.5}, QPointF{x, y(most) - 0.5});
  }
  // on a ground of its own: the curve goes on below it
  const QString scale = tr("greatest force %L1 N").arg(static_cast<double>(greatest), 0, 'f', 2);
  const QRectF place = painter.boundingRect(area.adjusted(3.0, 0.0, -3.0, 0.0),
                                            Qt::AlignRight | Qt::AlignTop, scale);
  QColor ground = palette().color(QPalette::Base);
  ground.setAlpha(210);
  painter.fillRect(place.adjusted(-2.0, 0.0, 2.0, 0.0), ground);
  painter.setPen(palette().color(QPalette::Text));
  painter.drawText(place, Qt::AlignCenter, scale);
}

void ReplayTimeline::drawTimes(QPainter& painter) const {
  const QRectF area = curveArea();
  const double length = track_.end - track_.begin;
  const auto words = [](double time, double step) { return clockTime(time, step < 1.0 ? 1 : 0); };
  painter.setFont(style::font(style::Type::Small));
  painter.setPen(QPen(style::colours().dim, 1.0));
  const auto draw = [&](double time, double step) {
    const double x = xOf(time);
    painter.drawLine(QPointF{x, area.bottom()}, QPointF{x, area.bottom() + 3.0});
    const QRectF place(std::min(x - 0.5 * kTimes, width() - kTimes), area.bottom() + 2.0, kTimes,
                       kFoot - 2.0);
    painter.drawText(
        place, place.center().x() < x - 0.5 ? Qt::AlignRight | Qt::AlignVCenter : Qt::AlignCenter,
        words(time, step));
  };
  if (!(length > 0.0)) return draw(track_.begin, 1.0);
  const double step = timeStep(kTimes * length / std::max(1.0, area.width()));
  for (double n = std::ceil(track_.begin / step - 1e-9); n * step <= track_.end + 1e-9; ++n)
    draw(n * step, step);
}

/// Short lines at the foot alone: there may be thousands.
void ReplayTimeline::drawLate(QPainter& painter) const {
  double last = -1.0;
  for (const ReplayMark& mark : track_.marks) {
    const double x = std::floor(xOf(mark.time));
    if (lookOf(mark.kind) != Look::Late || x == last) continue;
    last = x;
    painter.fillRect(QRectF(x, curveArea().bottom() - kLate, 1.0, kLate), colourOf(Look::Late));
  }
}

void ReplayTimeline::drawMarks(QPainter& painter) const {
  // one look after the other: the user's own marks lie on top, and at one place each look but once
  for (const Look look : kLooks) {
    double last = -1.0;
    for (const ReplayMark& mark : track_.marks) {
      const double x = xOf(mark.time);
      if (lookOf(mark.kind) != look || (last >= 0.0 && x - last < 0.5)) continue;
      last = x;
      QColor line = colourOf(look);
      if (look != Look::Note) line.setAlpha(130);
      painter.setPen(QPen(line, 1.0));
      painter.drawLine(QPointF{x, kLane / 2.0}, curveArea().bottomLeft() + QPointF{x - kLeft, 0.0});
      drawHead(painter, look, {x, kLane / 2.0});
    }
  }
}

void ReplayTimeline::drawGround() {
  const qreal scale = devicePixelRatioF();
  ground_ = QPixmap(size() * scale);
  ground_.setDevicePixelRatio(scale);
  ground_.fill(palette().color(QPalette::Base));
  QPainter painter(&ground_);
  painter.setFont(font());
  drawLate(painter);  // it hides no force
  drawForce(painter);
  drawTimes(painter);
  painter.setRenderHint(QPainter::Antialiasing);
  drawMarks(painter);
}

void ReplayTimeline::paintEvent(QPaintEvent*) {
  if (ground_.isNull() || ground_.devicePixelRatio() != devicePixelRatioF()) drawGround();
  QPainter painter(this);
  painter.drawPixmap(0, 0, ground_);
  painter.setRenderHint(QPainter::Antialiasing);
  if (hasFocus()) {
    painter.setPen(QPen(style::colours().accent, 2.0));
    painter.drawRect(QRectF(rect()).adjusted(1.0, 1.0, -1.0, -1.0));
  }
  painter.setPen(QPen(palette().color(QPalette::Text), 2.0));
  const double x = xOf(held_.value_or(time_));
  painter.drawLine(QPointF{x, 0.0}, QPointF{x, height() + 0.0});
}

void ReplayTimeline::wish(double x) {
  held_ = timeAt(x);
  update();
  emit timeWanted(*held_);
}

void ReplayTimeline::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) wish(event->position().x());
}

void ReplayTimeline::mouseMoveEvent(QMouseEvent* event) {
  if (held_) wish(event->position().x());
}

void ReplayTimeline::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  held_.reset();
  update();
}

void ReplayTimeline::keyPressEvent(QKeyEvent* event) {
  const Binding* meaning = meaningOf(Where::ReplayBar, *event);
  switch (meaning == nullptr ? Action::Elsewhere : meaning->action) {
    case Action::PlayPause:
      if (!event->isAutoRepeat()) emit playToggled();
      break;
    case Action::TickBack:
      emit stepWanted(-1);
      break;
    case Action::TickForward:
      emit stepWanted(1);
      break;
    case Action::ToBegin:
      emit timeWanted(track_.begin);
      break;
    case Action::ToEnd:
      emit timeWanted(track_.end);
      break;
    default:
      QWidget::keyPressEvent(event);
  }
}

void ReplayTimeline::resizeEvent(QResizeEvent*) { ground_ = {}; }

void ReplayTimeline::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) ground_ = {};
  QWidget::changeEvent(event);
}

}  // namespace ui
