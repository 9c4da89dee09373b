// SPDX-License-Identifier: BSD-3-Clause
#include "ui/panels/performance_words.h"

#include <QLocale>

#include "ui/panels/performance_panel.h"

namespace ui {
namespace {

QString millimetres(double metres) { return QLocale().toString(metres * 1e3, 'g', 2); }

QString missesOf(std::int64_t missed) {
  if (missed == 0) return PerformancePanel::tr("no misses");
  return missed == 1 ? PerformancePanel::tr("1 miss")
                     : PerformancePanel::tr("%1 misses").arg(counted(missed));
}

}  // namespace

QString counted(std::int64_t number) {
  QLocale locale;
  locale.setNumberOptions(QLocale::DefaultNumberOptions);
  return locale.toString(static_cast<qlonglong>(number));
}

QString milliseconds(double seconds) {
  const double ms = seconds * 1e3;
  return QLocale().toString(ms, 'f', ms < 0.0995 ? 3 : 2);
}

QString headlineOf(const Performance& p) {
  const QString present =
      PerformancePanel::tr("%1 points: longest tick %2 ms, %3")
          .arg(counted(p.present.points), milliseconds(p.present.longest), missesOf(p.missed));
  if (p.tried.empty()) return PerformancePanel::tr("%1.").arg(present);
  if (p.most == 0)
    return PerformancePanel::tr("%1; not even %2 points, spread evenly, on this machine.")
        .arg(present, counted(p.tried.front().points));
  if (!p.too_many)
    return PerformancePanel::tr("%1; %2 points and more on this machine.")
        .arg(present, counted(p.most));
  return PerformancePanel::tr("%1; up to %2 points on this machine.").arg(present, counted(p.most));
}

QString detailsOf(const Performance& p) {
  QStringList sentences;
  sentences << PerformancePanel::tr(
                   "Half of the ticks took at most %1 ms, 99 in 100 at most %2 ms of CPU.")
                   .arg(milliseconds(p.present.median), milliseconds(p.present.p99));
  if (p.cut == 0)
    sentences << PerformancePanel::tr("None of %1 was cut by the budget of %2 ms.")
                     .arg(counted(p.ticks), milliseconds(p.budget));
  else
    sentences << PerformancePanel::tr(
                     "%1 of %2 were cut by the budget of %3 ms, which kept the tool %4 mm farther "
                     "from the hand on average.")
                     .arg(counted(p.cut), counted(p.ticks), milliseconds(p.budget),
                          p.lag < 1e-6 ? PerformancePanel::tr("less than 0.001")
                                       : QLocale().toString(p.lag * 1e3, 'f', 3));
  if (!p.present.carried)
    sentences << PerformancePanel::tr("That is more than this machine carries.");
  if (p.live_ticks > 0)
    sentences << PerformancePanel::tr(
                     "Meanwhile, by the clock on the wall, the live loop began %1 of %2 ticks late "
                     "and missed %3.")
                     .arg(counted(static_cast<std::int64_t>(p.live_late)),
                          counted(static_cast<std::int64_t>(p.live_ticks)),
                          counted(static_cast<std::int64_t>(p.live_missed)));
  sentences << p.conditions;
  return sentences.join(' ');
}

QString suggestionOf(const Performance& p) {
  if (p.most == 0) return {};
  const QString voxel = millimetres(p.voxel);
  if (p.suggested == p.dense) {
    if (p.present.points >= p.dense && p.present.carried)
      return PerformancePanel::
          tr("Suggested: the tool as it is. %1 points, spread evenly, would be no farther apart "
             "than the voxels (%2 mm).")
              .arg(counted(p.dense), voxel);
    return PerformancePanel::tr(
               "Suggested: %1 points, spread evenly. They are %2 mm apart, as the voxels are.")
        .arg(counted(p.suggested), voxel);
  }
  return PerformancePanel::
      tr("Suggested: %1 points, spread evenly, %2 mm apart: the most that was carried. To be no "
         "farther apart than the voxels (%3 mm), the tool would need %4.")
          .arg(counted(p.suggested), millimetres(p.suggested_spacing), voxel, counted(p.dense));
}

}  // namespace ui
