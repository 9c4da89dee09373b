// SPDX-License-Identifier: BSD-3-Clause
#include "ui/panels/status_line.h"

#include <QPainter>
#include <QStyle>
#include <algorithm>
#include <cmath>

namespace ui {
namespace {

constexpr int kFirstLoopMs = 5'000, kLongestLoopMs = 40'000;

// a hundredth of the rate, a quarter of a tick, a tenth more ticks that came late or never
bool isNews(const haptics::Snapshot& now, const haptics::Snapshot& shown) {
  const auto differs = [](std::uint64_t count, std::uint64_t before) {
    return count < before || count > before + before / 10;
  };
  return std::abs(now.servo_rate - shown.servo_rate) > 0.01 * shown.servo_rate ||
         std::abs(now.tick_p99 - shown.tick_p99) > 0.25 * shown.tick_p99 ||
         differs(now.late_ticks, shown.late_ticks) || differs(now.missed_ticks, shown.missed_ticks);
}

QString wordsFor(haptics::SchedulingPolicy policy) {
  switch (policy) {
    case haptics::SchedulingPolicy::NotStarted:
    case haptics::SchedulingPolicy::Ordinary:
      return StatusLine::tr("ordinary priority");
    case haptics::SchedulingPolicy::RealTime:
      break;
  }
  return StatusLine::tr("real-time priority");
}

}  // namespace

StatusLine::StatusLine(QWidget* parent) : QLabel(parent) {
  offerSpoken();
  setObjectName("statusLine");
  setTextFormat(Qt::PlainText);
  // a label without a name of its own tells each of its texts
  setAccessibleName(tr("Status line"));
  // a long line must not make the window wider than the screen
  setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
}

void StatusLine::display(const haptics::Snapshot& snapshot) {
  touch_ =
      tr("%L1 N · %2 contacts").arg(snapshot.felt_W.force.norm(), 0, 'f', 2).arg(snapshot.contacts);
  // no loop runs: what is shown is of another time
  if (snapshot.policy == haptics::SchedulingPolicy::NotStarted)
    loop_.clear();
  else
    displayLoop(snapshot);
  compose();
}

void StatusLine::displayLoop(const haptics::Snapshot& snapshot) {
  const bool same_loop = !loop_.isEmpty() && snapshot.policy == loop_shown_.policy;
  if (same_loop && (since_loop_.elapsed() < loop_ms_ || !isNews(snapshot, loop_shown_))) return;
  loop_ms_ = same_loop ? std::min(2 * loop_ms_, kLongestLoopMs) : kFirstLoopMs;
  loop_shown_ = snapshot;
  since_loop_.start();
  loop_ = tr("servo %1 Hz (%2), tick p99 %3 µs, late %4, missed %5")
              .arg(snapshot.servo_rate, 0, 'f', 0)
              .arg(wordsFor(snapshot.policy))
              .arg(snapshot.tick_p99 * 1e6, 0, 'f', 0)
              .arg(snapshot.late_ticks)
              .arg(snapshot.missed_ticks);
}

void StatusLine::showNear(const std::vector<StructureNear>& near, const NearLimits& limits) {
  const auto nearest = std::ranges::min_element(near, {}, &StructureNear::distance_mm);
  near_ = nearest == near.end()
              ? QString{}
              : tr("Nearest: %1, %2").arg(nearest->name, nearWords(*nearest, limits));
  compose();
}

void StatusLine::setHand(const QString& hand) {
  hand_ = tr("Hand: %1").arg(hand);
  compose();
}

void StatusLine::setSurface(const SurfaceChoice& choice) {
  const QString means = choice.mode == SurfaceMode::RayCast ? tr("ray casting") : tr("mesh");
  surface_ = tr("Surface: %1 (%2)").arg(means, choice.reason);
  compose();
}

ScanLine::ScanLine(QWidget* parent) : QLabel(parent) {
  setObjectName("scanLine");
  setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
}

void ScanLine::setScan(const QString& name, const QString& size) {
  name_ = name;
  size_ = QStringLiteral(" · ") + size;
  setText(name_ + size_);
  setToolTip(text().toHtmlEscaped());
}

QString ScanLine::seen() const {
  constexpr int kLeastName = 8;  // characters, of which one is left beside a size
  const QFontMetrics metrics = fontMetrics();
  const int room = contentsRect().width() - metrics.horizontalAdvance(size_);
  const bool both =
      room >= std::min(metrics.horizontalAdvance(name_), kLeastName * metrics.averageCharWidth());
  return metrics.elidedText(name_, Qt::ElideMiddle, both ? room : contentsRect().width()) +
         (both ? size_ : QString());
}

void ScanLine::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  style()->drawItemText(&painter, contentsRect(), Qt::AlignLeft | Qt::AlignVCenter, palette(),
                        isEnabled(), seen(), foregroundRole());
}

void StatusLine::compose() {
  QStringList parts;
  for (const QString& part : {touch_, near_, loop_, hand_, surface_})
    if (!part.isEmpty()) parts << part;
  const QString line = parts.join(" · ");
  if (line == text()) return;
  setText(line);
  // names of structures are plain text
  setToolTip(QStringLiteral("<qt>%1</qt>").arg(line.toHtmlEscaped()));
}

void StatusLine::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  style()->drawItemText(
      &painter, contentsRect(), static_cast<int>(alignment()), palette(), isEnabled(),
      fontMetrics().elidedText(text(), Qt::ElideRight, contentsRect().width()), foregroundRole());
}

}  // namespace ui
