// SPDX-License-Identifier: BSD-3-Clause
#include "ui/panels/nearness_lines.h"

#include <QGridLayout>
#include <QLabel>
#include <QLocale>
#include <algorithm>

#include "ui/controls/elided_label.h"
#include "ui/controls/figure.h"
#include "ui/style/style.h"

namespace ui {
namespace {

constexpr int kSwatch = 10;  // px

/// A sign, a word and a colour: none of them alone.
struct HowNear {
  const char16_t* sign;
  QString word;
  QColor colour;
};

HowNear howNear(double distance_mm, const NearLimits& limits) {
  if (distance_mm <= 0.0) return {u"\u2716", {}, style::kDark.stop_words};
  if (distance_mm <= limits.close_mm)
    return {u"\u25A0", NearnessLines::tr("close"), style::kDark.stop_words};
  if (distance_mm <= limits.near_mm)
    return {u"\u25B2", NearnessLines::tr("near"), style::kDark.attention};
  return {u"\u25CB", {}, style::kDark.text};
}

void setColour(QLabel& label, const QColor& colour) {
  QPalette palette = label.palette();
  if (palette.color(QPalette::WindowText) == colour) return;
  palette.setColor(QPalette::WindowText, colour);
  label.setPalette(palette);
}

void say(QLabel& label, const QString& words) {
  if (label.text() != words) label.setText(words);
}

}  // namespace

QString distanceWords(const StructureNear& near) {
  if (near.distance_mm <= 0.0) return NearnessLines::tr("inside");
  const QString mm = QLocale().toString(near.distance_mm, 'f', near.is_farther ? 0 : 1);
  return near.is_farther ? NearnessLines::tr("over %1 mm").arg(mm)
                         : NearnessLines::tr("%1 mm").arg(mm);
}

QString nearWords(const StructureNear& near, const NearLimits& limits) {
  const QString words = distanceWords(near), how = howNear(near.distance_mm, limits).word;
  return how.isEmpty() ? words : NearnessLines::tr("%1, %2").arg(words, how);
}

NearnessLines::NearnessLines(QWidget* parent) : QWidget(parent) {
  setObjectName("nearness");
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setSpacing(style::kStep);
  grid->setColumnStretch(1, 1);
  for (int n = 0; n < kLines; ++n) {
    Line& line = lines_[static_cast<std::size_t>(n)];
    line = {new QLabel, new ElidedLabel, new QLabel, new Figure(tr("Distance"))};
    line.mark->setFixedSize(kSwatch, kSwatch);
    line.mark->setAutoFillBackground(true);
    style::setType(*line.name, style::Type::Small);
    style::setType(*line.distance, style::Type::Figure);
    line.name->setObjectName(QStringLiteral("nearnessName%1").arg(n));
    line.distance->setObjectName(QStringLiteral("nearness%1").arg(n));
    grid->addWidget(line.mark, n, 0, Qt::AlignVCenter);
    grid->addWidget(line.name, n, 1);  // the name gives way to the distance
    grid->addWidget(line.sign, n, 2, Qt::AlignVCenter);
    grid->addWidget(line.distance, n, 3, Qt::AlignRight | Qt::AlignVCenter);
  }
  show({}, {});
}

void NearnessLines::show(std::vector<StructureNear> near, const NearLimits& limits) {
  std::ranges::stable_sort(near, {}, &StructureNear::distance_mm);
  for (std::size_t n = 0; n < lines_.size(); ++n) {
    const Line& line = lines_[n];
    const bool used = n < near.size();
    for (QLabel* part : {line.mark, line.name, line.sign, line.distance}) part->setVisible(used);
    if (!used) continue;
    const StructureNear& one = near[n];
    const HowNear how = howNear(one.distance_mm, limits);
    QPalette palette = line.mark->palette();
    palette.setColor(QPalette::Window, one.colour);
    line.mark->setPalette(palette);
    say(*line.name, one.name);
    say(*line.sign, QString::fromUtf16(how.sign));
    say(*line.distance, nearWords(one, limits));
    line.distance->setAccessibleName(tr("Distance to %1").arg(one.name));
    setColour(*line.sign, how.colour);
    setColour(*line.distance, how.colour);
  }
}

}  // namespace ui
