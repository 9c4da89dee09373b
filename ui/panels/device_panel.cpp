// SPDX-License-Identifier: BSD-3-Clause
#include "ui/panels/device_panel.h"

#include <QComboBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <array>
#include <cmath>
#include <utility>

#include "haptics/settings.h"
#include "ui/controls/number_box.h"
#include "ui/controls/spoken.h"
#include "ui/dialogs/unit_question.h"
#include "ui/panels/tool_list.h"
#include "ui/panels/tool_tiles.h"

namespace ui {
namespace {

constexpr haptics::Range kStiffness = haptics::kStiffnessRange;
constexpr int kSliderSteps = 400;  // by the logarithm, from 50 N/m
constexpr double kLeastShown = 50.0;

int stepOf(double stiffness) {
  return qRound(std::log(std::max(stiffness, kLeastShown) / kLeastShown) /
                std::log(kStiffness.most / kLeastShown) * kSliderSteps);
}

double stiffnessAt(int step) {
  return kLeastShown *
         std::pow(kStiffness.most / kLeastShown, static_cast<double>(step) / kSliderSteps);
}

/// Its steps are those of the logarithm; what is said of it are N/m.
class StiffnessSlider : public QSlider, public Spoken {
 public:
  explicit StiffnessSlider(NumberBox& typed) : QSlider(Qt::Horizontal), typed_(typed) {
    offerSpoken();
  }

  QAccessible::Role spokenRole() const override { return QAccessible::Slider; }
  QString spokenName() const override { return DevicePanel::tr("Stiffness in N/m"); }
  QString spokenValue() const override { return typed_.text(); }
  std::optional<SpokenNumber> spokenNumber() const override {
    return SpokenNumber{
        .now = typed_.value(), .least = kStiffness.least, .most = kStiffness.most, .step = 10.0};
  }
  void takeSpoken(double stiffness) override { typed_.setValue(stiffness); }

 private:
  NumberBox& typed_;
};

}  // namespace

DevicePanel::DevicePanel(QWidget* parent)
    : QWidget(parent),
      hands_(new QComboBox),
      tiles_(new ToolTiles),
      tools_(new ToolList),
      stiffness_typed_(new NumberBox),
      stiffness_(new StiffnessSlider(*stiffness_typed_)),
      friction_(new QComboBox),
      details_(new QWidget),
      fields_(new QComboBox),
      effect_(new QLabel) {
  hands_->setObjectName("hands");
  hands_->setToolTip(tr("The hand on the tool: the mouse, or a simulated hand"));
  tools_->setObjectName("tools");
  stiffness_->setObjectName("stiffness");
  stiffness_->setRange(0, kSliderSteps);
  stiffness_->setToolTip(tr("The spring between hand and tool: stiff is hard, soft is yielding"));
  stiffness_typed_->setObjectName("stiffnessTyped");
  stiffness_typed_->setAccessibleName(tr("Stiffness, typed"));
  stiffness_typed_->setToolTip(tr("The spring between hand and tool, as a number"));
  stiffness_typed_->setDecimals(0);
  stiffness_typed_->setRange(kStiffness.least, kStiffness.most);
  stiffness_typed_->setSingleStep(100);
  stiffness_typed_->setSuffix(tr(" N/m"));
  friction_->setObjectName("friction");
  friction_->setToolTip(tr("Friction of the surface on a tool that slides along it"));
  const std::array<std::pair<QString, double>, 5> frictions{{{tr("none"), 0.0},
                                                             {tr("slight"), 0.1},
                                                             {tr("some"), 0.3},
                                                             {tr("strong"), 0.6},
                                                             {tr("very strong"), 1.0}}};
  for (const auto& [words, coefficient] : frictions)
    friction_->addItem(
        coefficient > 0.0 ? tr("%1, %L2").arg(words).arg(coefficient, 0, 'f', 1) : words,
        coefficient);
  fields_->setObjectName("fields");
  fields_->setToolTip(tr("How the surface is made from the voxels"));
  effect_->setObjectName("fieldEffect");
  effect_->setWordWrap(true);
  effect_->hide();
  auto* stiff = new QHBoxLayout;
  stiff->addWidget(stiffness_, 1);
  stiff->addWidget(stiffness_typed_);
  auto* form = new QFormLayout(this);
  form->setContentsMargins(0, 0, 0, 0);
  form->addRow(tiles_);
  form->addRow(tools_);
  form->addRow(tr("Stiffness"), stiff);
  form->addRow(tr("Friction"), friction_);
  form->addRow(tr("Hand"), hands_);
  form->addRow(effect_);
  auto* rare = new QFormLayout(details_);
  rare->setContentsMargins(0, 0, 0, 0);
  rare->addRow(tr("Surface"), fields_);
  showStiffness(1000.0);

  connect(hands_, &QComboBox::activated, this,
          [this](int i) { emit handChosen(hands_->itemData(i).toString()); });
  connect(tools_, &ToolList::toolChosen, this, &DevicePanel::toolChosen);
  connect(tools_, &ToolList::fileWanted, this, &DevicePanel::chooseFile);
  connect(fields_, &QComboBox::activated, this,
          [this](int i) { emit fieldChosen(fields_->itemData(i).toString()); });
  connect(friction_, &QComboBox::activated, this,
          [this](int n) { emit frictionChanged(friction_->itemData(n).toDouble()); });
  connect(stiffness_, &QSlider::valueChanged, this, [this](int step) {
    const double stiffness = std::round(stiffnessAt(step) / 10.0) * 10.0;
    const QSignalBlocker quiet(stiffness_typed_);
    stiffness_typed_->setValue(qRound(stiffness));
    tellSpokenNumber(*stiffness_);
    emit stiffnessChanged(stiffness);
  });
  connect(stiffness_typed_, &NumberBox::valueChanged, this, [this](double stiffness) {
    const QSignalBlocker quiet(stiffness_);
    stiffness_->setValue(stepOf(stiffness));
    tellSpokenNumber(*stiffness_);
    emit stiffnessChanged(stiffness);
  });
}

void DevicePanel::setHands(const QList<Choice>& hands) {
  hands_->clear();
  for (const Choice& hand : hands) hands_->addItem(hand.label, hand.id);
}

void DevicePanel::setFields(const QList<Choice>& fields) {
  fields_->clear();
  for (const Choice& field : fields) fields_->addItem(field.label, field.id);
}

void DevicePanel::showField(const QString& id, const QString& effect) {
  fields_->setCurrentIndex(fields_->findData(id));
  effect_->setText(effect);
  effect_->setVisible(!effect.isEmpty());
}

void DevicePanel::showHand(const QString& id, const QString& label) {
  // a haptic device is not chosen here
  hands_->setPlaceholderText(label);
  hands_->setCurrentIndex(hands_->findData(id));
}

void DevicePanel::showStiffness(double newton_per_metre) {
  const QSignalBlocker quiet_slider(stiffness_), quiet_typed(stiffness_typed_);
  stiffness_->setValue(stepOf(newton_per_metre));
  stiffness_typed_->setValue(qRound(newton_per_metre));
  tellSpokenNumber(*stiffness_);
}

void DevicePanel::chooseFile() {
  // Qt's own dialog: in a foreign one Escape would not reach the application
  const QString path = QFileDialog::getOpenFileName(this, tr("Tool"), {},
                                                    tr("Meshes (*.stl *.obj *.ply);;All files (*)"),
                                                    nullptr, QFileDialog::DontUseNativeDialog);
  if (!path.isEmpty()) emit toolFileFound(path);
}

void DevicePanel::askForUnit(const QString& path, const std::array<double, 3>& numbers) {
  if (const auto unit = ui::askForUnit(this, QFileInfo(path).fileName(), numbers))
    emit toolFileChosen(path, *unit);
}

}  // namespace ui
