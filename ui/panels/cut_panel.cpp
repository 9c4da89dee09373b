// SPDX-License-Identifier: BSD-3-Clause
#include "ui/panels/cut_panel.h"

#include <QButtonGroup>
#include <QCheckBox>
#include <QFormLayout>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QLocale>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "ui/controls/bindings.h"
#include "ui/controls/hint_label.h"
#include "ui/controls/number_box.h"

namespace ui {
namespace {

constexpr double kForceStep = 0.1;  // N
constexpr int kInRow = 4;           // burrs
constexpr int kMostBands = 3;
constexpr int kRows = 4;    // strokes in view
constexpr int kLeast = 40;  // px: four stand in the narrowest panel

/// So many that a hundredth of the range is told.
int decimalsBetween(double least, double greatest) {
  const double range = greatest - least;
  return range >= 100.0 ? 0 : range >= 1.0 ? 2 : 4;
}

QString shown(double mm3) { return QLocale().toString(mm3, 'f', mm3 < 100.0 ? 1 : 0); }

}  // namespace

CutPanel::CutPanel(QWidget* parent)
    : QWidget(parent),
      burrs_(new QButtonGroup(this)),
      burr_rows_(new QGridLayout),
      state_(hintLabel()),
      removed_(hintLabel()),
      tissues_(hintLabel()),
      strokes_(new QListWidget),
      speed_(numberBox({.name = "burrSpeed",
                        .accessible = tr("Speed of the burr"),
                        .least = 1'000.0,
                        .most = 100'000.0,
                        .step = 1'000.0,
                        .suffix = tr(" /min")})),
      energy_(cutEnergyBox("burrEnergy")),
      add_band_(new QPushButton(tr("Add a material"))),
      undo_(new QPushButton(tr("Undo"))),
      redo_(new QPushButton(tr("Redo"))),
      vibration_(new QCheckBox(tr("Vibration"))),
      sound_(new QCheckBox(tr("Sound of the burr"))),
      tint_(new QCheckBox(tr("Colour what was cut"))),
      before_after_(new QCheckBox(tr("Before and after"))) {
  state_->setObjectName("cutState");
  removed_->setObjectName("cutRemoved");
  tissues_->setObjectName("cutTissues");
  strokes_->setObjectName("cutStrokes");
  strokes_->setAccessibleName(tr("Strokes"));
  strokes_->setToolTip(tr("What each stroke has removed; Undo takes the first of the list back"));
  strokes_->setSelectionMode(QAbstractItemView::NoSelection);
  speed_->setValue(BurrNumbers{}.speed_rpm);
  energy_->setValue(BurrNumbers{}.energy_J_mm3);
  burr_rows_->setSpacing(4);
  burrs_->setExclusive(false);
  undo_->setObjectName("undoStroke");
  redo_->setObjectName("redoStroke");
  vibration_->setObjectName("cutVibration");
  vibration_->setToolTip(tr("The burr's teeth are felt, by at most half a newton"));
  tint_->setObjectName("cutTint");
  tint_->setChecked(true);
  tint_->setToolTip(tr("Faces that a burr has cut stand out"));
  before_after_->setObjectName("cutBeforeAfter");
  speed_->setToolTip(tr("Turns in a minute: a faster burr removes more with the same force"));
  sound_->setObjectName("burrSound");
  setSoundPossible(true);
  energy_->setToolTip(tr("What it takes to remove a cubic millimetre: the more, the slower"));
  whenKeysChange(*this, [this] {
    undo_->setToolTip(withKey(tr("Takes the last stroke or edit back"), Action::Undo));
    redo_->setToolTip(withKey(tr("Makes the stroke or edit again"), Action::Redo));
    before_after_->setToolTip(
        withKey(tr("The unedited scan beside what is left of it, seen from the same place"),
                Action::BeforeAfter));
    shown_force_ = -1.0;
    showState(shown_);
  });
  auto* form = new QFormLayout;
  form->addRow(tr("Speed"), speed_);
  form->addRow(tr("Material"), energy_);
  auto* steps = new QHBoxLayout;
  steps->setSpacing(4);
  steps->addWidget(undo_);
  steps->addWidget(redo_);
  steps->addStretch(1);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addLayout(burr_rows_);
  column->addWidget(state_);
  column->addLayout(form);
  column->addWidget(buildBands());
  column->addWidget(tissues_);
  column->addWidget(removed_);
  column->addWidget(strokes_);
  column->addLayout(steps);
  column->addWidget(vibration_);
  column->addWidget(sound_);
  column->addWidget(tint_);
  column->addWidget(before_after_);
  for (NumberBox* number : {speed_, energy_})
    connect(number, &NumberBox::valueChanged, this, &CutPanel::numbersChanged);
  connect(undo_, &QPushButton::clicked, this, &CutPanel::undoWanted);
  connect(redo_, &QPushButton::clicked, this, &CutPanel::redoWanted);
  connect(vibration_, &QCheckBox::toggled, this, &CutPanel::numbersChanged);
  connect(tint_, &QCheckBox::toggled, this, &CutPanel::tintChosen);
  connect(sound_, &QCheckBox::toggled, this, &CutPanel::soundChosen);
  connect(before_after_, &QCheckBox::toggled, this, &CutPanel::beforeAfterChosen);
  setSteps(false, false);
  show(CutTold{});
  showTissues(0, 0);
  setBeforeAfter(false, false);
}

QWidget* CutPanel::buildBands() {
  add_band_->setObjectName("addBand");
  add_band_->setToolTip(
      tr("From a value of the scan on another energy: denser bone takes longer to cut"));
  connect(add_band_, &QPushButton::clicked, this, [this] {
    addBand();
    emit numbersChanged();
  });
  auto* part = new QWidget;
  band_rows_ = new QVBoxLayout(part);
  band_rows_->setContentsMargins(0, 0, 0, 0);
  band_rows_->setSpacing(4);
  band_rows_->addWidget(add_band_, 0, Qt::AlignLeft);
  return part;
}

void CutPanel::addBand() {
  auto* row = new QWidget;
  auto* from = numberBox({.name = "bandFrom",
                          .accessible = tr("From this value of the scan on"),
                          .least = least_,
                          .most = greatest_,
                          .step = 0.02 * (greatest_ - least_),
                          .decimals = decimalsBetween(least_, greatest_),
                          .suffix = unit_});
  auto* energy = cutEnergyBox("bandEnergy");
  auto* remove = new QToolButton;
  remove->setObjectName("removeBand");
  remove->setText(QStringLiteral("×"));
  remove->setToolTip(tr("Removes this material"));
  remove->setAccessibleName(tr("Remove this material"));
  from->setToolTip(tr("Where the scan has this value or more"));
  from->setValue(0.5 * (least_ + greatest_));
  energy->setValue(energy_->value());
  auto* line = new QHBoxLayout(row);
  line->setContentsMargins(0, 0, 0, 0);
  line->setSpacing(4);
  line->addWidget(new QLabel(tr("From")));
  line->addWidget(from, 1);
  line->addWidget(energy, 1);
  line->addWidget(remove);
  for (NumberBox* box : {from, energy}) {
    box->setKeyboardTracking(false);
    connect(box, &NumberBox::valueChanged, this, &CutPanel::numbersChanged);
  }
  connect(remove, &QToolButton::clicked, this, [this, row] {
    bands_.removeIf([row](const BandRow& band) { return band.row == row; });
    row->deleteLater();
    add_band_->setEnabled(true);
    emit numbersChanged();
  });
  band_rows_->insertWidget(static_cast<int>(bands_.size()), row);
  bands_.append({row, from, energy});
  add_band_->setEnabled(bands_.size() < kMostBands);
}

void CutPanel::setValues(double least, double greatest, const QString& unit) {
  least_ = least;
  greatest_ = greatest;
  unit_ = unit.isEmpty() ? QString{} : QStringLiteral(" ") + unit;
  for (const BandRow& band : bands_) {
    const QSignalBlocker quiet(band.from);
    band.from->setDecimals(decimalsBetween(least_, greatest_));
    band.from->setRange(least_, greatest_);
    band.from->setSuffix(unit_);
  }
}

void CutPanel::showTissues(int never, int own) {
  QStringList words;
  if (never > 0) words.append(tr("Structures that may not be cut: %1.").arg(never));
  if (own > 0) words.append(tr("Structures with an energy of their own: %1.").arg(own));
  tissues_->setText(words.join(QStringLiteral(" ")));
  tissues_->setVisible(!words.isEmpty());
}

void CutPanel::setBurrs(const QList<BurrChoice>& burrs) {
  int count = 0;
  for (const BurrChoice& burr : burrs) {
    auto* button = new QToolButton;
    button->setObjectName(QStringLiteral("cut_") + burr.id);
    button->setText(burr.label);
    button->setToolTip(burr.tip);
    button->setAccessibleName(burr.tip);
    button->setCheckable(true);
    button->setMinimumWidth(kLeast);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    burrs_->addButton(button);
    burr_rows_->addWidget(button, count / kInRow, count % kInRow);
    ++count;
    connect(button, &QToolButton::clicked, this, [this, button, id = burr.id] {
      button->setChecked(!button->isChecked());  // it is down when the tool is there
      emit burrChosen(id);
    });
  }
}

void CutPanel::showTool(const QString& id) {
  for (QAbstractButton* button : burrs_->buttons())
    button->setChecked(button->objectName() == QStringLiteral("cut_") + id);
}

BurrNumbers CutPanel::numbers() const {
  BurrNumbers numbers{speed_->value(), energy_->value(), vibration_->isChecked(), {}};
  for (const BandRow& band : bands_)
    numbers.bands.append({band.from->value(), band.energy->value()});
  return numbers;
}

void CutPanel::showState(State state, double force) {
  if (state == shown_ && std::abs(force - shown_force_) < kForceStep) return;
  shown_ = state;
  shown_force_ = force;
  const QString words = [&] {
    switch (state) {
      case State::NoBurr:
        return tr("Choose a burr to cut. The file never changes.");
      case State::Preparing:
        return tr("The burr is being prepared.");
      case State::Solid:
        return tr(
            "A structure is solid for the touch, and would be cut. Let it be felt in another "
            "way to cut.");
      case State::Ready:
        return tr("Hold %1 in the 3-D view to cut.").arg(keyOf(Action::Cut));
      case State::Turning:
        break;
    }
    return tr("The burr turns: %L1 N").arg(force, 0, 'f', 1);
  }();
  state_->setText(words);
}

void CutPanel::show(const CutTold& told) {
  const auto count = static_cast<int>(told.strokes_mm3.size());
  removed_->setText(count == 0 ? tr("Nothing was cut yet.")
                               : tr("Removed: %1 mm³. Strokes: %2.")
                                     .arg(shown(std::accumulate(told.strokes_mm3.begin(),
                                                                told.strokes_mm3.end(), 0.0)))
                                     .arg(count));
  // the newest first, as they are taken back
  while (strokes_->count() > count) delete strokes_->takeItem(0);
  while (strokes_->count() < count) strokes_->insertItem(0, QString{});
  for (int n = 0; n < count; ++n)
    strokes_->item(count - 1 - n)
        ->setText(tr("Stroke %1: %2 mm³").arg(n + 1).arg(shown(told.strokes_mm3[n])));
  strokes_->setVisible(count > 0);
  if (count > 0)
    strokes_->setFixedHeight(std::min(count, kRows) * strokes_->sizeHintForRow(0) +
                             2 * strokes_->frameWidth());
}

void CutPanel::setSteps(bool undo, bool redo) {
  undo_->setEnabled(undo);
  redo_->setEnabled(redo);
}

void CutPanel::setBeforeAfter(bool on, bool possible) {
  before_after_->setChecked(on);
  before_after_->setEnabled(possible);
}

bool CutPanel::tint() const { return tint_->isChecked(); }

void CutPanel::setSoundPossible(bool possible) {
  sound_->setEnabled(possible);
  sound_->setToolTip(possible ? tr("A faster burr is heard higher; under load it slows down a "
                                   "little, and gets louder and rougher")
                              : tr("There is no program that plays a sound as it is made: install "
                                   "the utilities of PulseAudio or ALSA"));
}

}  // namespace ui
