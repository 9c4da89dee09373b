// SPDX-License-Identifier: BSD-3-Clause
#include "ui/panels/status_line.h"

#include "ui/panels/force_words.h"

namespace ui {
namespace {

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
  setObjectName("statusLine");
  // a long line must not make the window wider than the screen
  setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
}

void StatusLine::display(const haptics::Snapshot& snapshot) {
  // no loop runs: what is shown is of another time
  if (snapshot.policy == haptics::SchedulingPolicy::NotStarted) {
    servo_ = tr("Replay: %1 contacts · %2 N")
                 .arg(snapshot.contacts)
                 .arg(snapshot.felt_W.force.norm(), 0, 'f', 2);
    return compose();
  }
  servo_ = tr("Force %1, %2 N · %3 contacts · servo %4 Hz (%5), tick p99 %6 µs, late %7, missed %8")
               .arg(nameOf(snapshot.force_state).toLower())
               .arg(snapshot.felt_W.force.norm(), 0, 'f', 2)
               .arg(snapshot.contacts)
               .arg(snapshot.servo_rate, 0, 'f', 0)
               .arg(wordsFor(snapshot.policy))
               .arg(snapshot.tick_p99 * 1e6, 0, 'f', 0)
               .arg(snapshot.late_ticks)
               .arg(snapshot.missed_ticks);
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

void StatusLine::compose() {
  QStringList parts;
  for (const QString& part : {servo_, hand_, surface_})
    if (!part.isEmpty()) parts << part;
  setText(parts.join(" · "));
  setToolTip(text());
}

}  // namespace ui
