// SPDX-License-Identifier: BSD-3-Clause
#include "ui/panels/haptic_device_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTimer>
#include <QToolButton>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "ui/controls/bindings.h"
#include "ui/controls/number_box.h"
#include "ui/controls/set_up_page.h"
#include "ui/controls/state_chip.h"
#include "ui/panels/force_words.h"
#include "ui/style/look.h"
#include "ui/style/style.h"

namespace ui {
namespace {

using haptics::ForceState;
using haptics::Trouble;

enum Column { Name, State, kColumns };

constexpr int kLeastRows = 4;  // of the list, seen without scrolling
constexpr int kPatienceMs = 5'000;
constexpr double kCapped = 0.999;  // of what was wished: below it what is allowed counts

QLabel* label(const char* name) {
  auto* made = new QLabel;
  made->setObjectName(name);
  // what a device calls itself is no markup
  made->setTextFormat(Qt::PlainText);
  made->setWordWrap(true);
  return made;
}

QString wordsFor(Trouble trouble, bool present) {
  switch (trouble) {
    case Trouble::None:
      return present ? HapticDevicePanel::tr("here") : HapticDevicePanel::tr("to be tried");
    case Trouble::NotPluggedIn:
      return HapticDevicePanel::tr("not plugged in");
    case Trouble::NoPermission:
      return HapticDevicePanel::tr("not permitted");
    case Trouble::NoLibrary:
      return HapticDevicePanel::tr("library missing");
    case Trouble::NoService:
      return HapticDevicePanel::tr("service missing");
    case Trouble::InUse:
      return HapticDevicePanel::tr("in use");
    case Trouble::NoFirmware:
      return HapticDevicePanel::tr("needs firmware");
    case Trouble::NotHomed:
      return HapticDevicePanel::tr("needs homing");
    case Trouble::NeedsCalibration:
      return HapticDevicePanel::tr("needs calibration");
    case Trouble::NotStarted:
      return HapticDevicePanel::tr("not started");
    case Trouble::MotorsHot:
      return HapticDevicePanel::tr("motors hot");
    case Trouble::ForceOff:
      return HapticDevicePanel::tr("force switched off");
    case Trouble::Refused:
      return HapticDevicePanel::tr("not understood");
    case Trouble::Lost:
      return HapticDevicePanel::tr("disconnected");
  }
  return {};
}

// what the user sees to at the device, once it is connected
bool isAtDevice(Trouble trouble) {
  switch (trouble) {
    case Trouble::NotHomed:
    case Trouble::NeedsCalibration:
    case Trouble::NotStarted:
    case Trouble::MotorsHot:
    case Trouble::ForceOff:
      return true;
    default:
      return false;
  }
}

bool canConnect(const DeviceLine& device, bool firmware_named) {
  if (isAtDevice(device.trouble)) return device.present;
  switch (device.trouble) {
    case Trouble::None:
      return true;
    case Trouble::NoFirmware:
      return device.present && firmware_named;
    default:
      return false;
  }
}

NumberBox* scaleBox(const char* name) {
  auto* box = new NumberBox;
  box->setObjectName(name);
  box->setRange(haptics::kScaleRange.least, haptics::kScaleRange.most);
  box->setDecimals(2);
  box->setSingleStep(0.1);
  box->setValue(1.0);
  return box;
}

QComboBox* buttonBox(const char* name, Action action) {
  auto* box = new QComboBox;
  box->setObjectName(name);
  box->addItem({}, -1);
  whenKeysChange(*box, [box, action] {
    box->setItemText(0, HapticDevicePanel::tr("key %1 only").arg(keyOf(action)));
  });
  // a long name must not make the panel wider
  box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  box->setMinimumContentsLength(10);
  for (int n = 0; n < haptics::kButtons; ++n) {
    // one device alone may have as many; two share them
    const int second = n - haptics::kButtonsEach + 1;
    box->addItem(
        second < 1 ? HapticDevicePanel::tr("button %1").arg(n + 1)
                   : HapticDevicePanel::tr("button %1 (second device: %2)").arg(n + 1).arg(second),
        n);
  }
  return box;
}

// what tells it from others of its name
QString placeOf(const DeviceLine& device) { return device.id.section(':', 1); }

QString shownNumber(double value) { return QLocale().toString(value, 'g', 5); }

}  // namespace

HapticDevicePanel::HapticDevicePanel(QWidget* parent)
    : QWidget(parent),
      list_(new QTreeWidget),
      why_(label("deviceWhy")),
      firmware_row_(new QWidget),
      firmware_(new QLineEdit),
      turned_row_(new QWidget),
      turned_by_(new QComboBox),
      connect_(new QPushButton),
      set_up_(new QPushButton(tr("Set up…"))),
      link_words_(label("deviceLink")),
      arm_(new QPushButton),
      state_(new StateChip),
      reason_(label("forceReason")),
      share_(label("stiffnessShare")),
      position_scale_(scaleBox("positionScale")),
      position_words_(label("positionScaleWords")),
      force_scale_(scaleBox("forceScale")),
      follow_camera_(new QCheckBox(tr("Follow the camera"))),
      clutch_button_(buttonBox("clutchButton", Action::Clutch)),
      hold_to_run_(new QCheckBox(tr("Force only while held"))),
      hold_button_(buttonBox("holdButton", Action::HoldToRun)),
      cut_button_(buttonBox("cutButton", Action::Cut)),
      stiffness_(label("stiffnessTwice")),
      capped_(label("stiffnessCapped")),
      lift_(new QCheckBox(tr("Allow stiffness that may shake"))),
      lifted_words_(label("stiffnessLiftedWords")),
      patience_(new QTimer(this)) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(style::kEdge);
  column->addWidget(buildForce());
  column->addWidget(buildList());
  column->addWidget(buildMapping());
  setFocusProxy(list_);
  patience_->setSingleShot(true);
  connect(patience_, &QTimer::timeout, this, [this] {
    link_words_->setText(
        tr("Still connecting. Firmware takes a minute. If nothing happens, press Cancel, unplug "
           "the device, plug it in, and retry. If that does not help, restart Palpate."));
  });
  lifted_words_->hide();
  show(Mapping{});
  showStiffness({}, std::nullopt);
  showDisconnected({});
  display({});
}

QWidget* HapticDevicePanel::buildForce() {
  arm_->setObjectName("arm");
  arm_->setEnabled(false);
  arm_->setText(tr("Arm"));
  arm_->setToolTip(
      tr("The motors may push from now on: hold the handle. Escape, Space in the 3-D view and the "
         "stop button take the force away."));
  state_->setObjectName("forceState");
  state_->setAccessibleName(tr("State of the force"));
  connect(arm_, &QPushButton::clicked, this, &HapticDevicePanel::armWanted);
  auto* box = new QWidget;
  auto* column = new QVBoxLayout(box);
  column->setContentsMargins(0, 0, 0, 0);
  auto* row = new QHBoxLayout;
  row->addWidget(state_, 1);
  row->addWidget(arm_);
  column->addLayout(row);
  column->addWidget(reason_);
  column->addWidget(share_);
  return box;
}

QWidget* HapticDevicePanel::buildList() {
  list_->setObjectName("deviceList");
  list_->setAccessibleName(tr("Haptic devices"));
  list_->setToolTip(tr("All known devices; those that are present come first"));
  list_->setColumnCount(kColumns);
  list_->setHeaderLabels({tr("Device"), tr("State")});
  list_->setRootIsDecorated(false);
  list_->setUniformRowHeights(true);
  list_->header()->setSectionResizeMode(Name, QHeaderView::Stretch);
  list_->header()->setSectionResizeMode(State, QHeaderView::ResizeToContents);
  list_->header()->setStretchLastSection(false);
  // as long as the list is, within what the panel has room for
  list_->setSizeAdjustPolicy(QAbstractScrollArea::AdjustToContents);
  list_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  list_->setMinimumHeight(list_->fontMetrics().height() * (kLeastRows + 2));
  why_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  connect(list_, &QTreeWidget::itemSelectionChanged, this, &HapticDevicePanel::showSelected);

  firmware_->setObjectName("firmware");
  firmware_->setPlaceholderText(tr("Its maker's firmware file"));
  firmware_->setAccessibleName(tr("Firmware file"));
  firmware_->setToolTip(tr("The maker's firmware, which starts this device"));
  auto* choose = new QToolButton;
  choose->setObjectName("chooseFirmware");
  choose->setToolTip(tr("Looks for the firmware file"));
  choose->setText(tr("Choose…"));
  connect(choose, &QToolButton::clicked, this, &HapticDevicePanel::chooseFirmware);
  connect(firmware_, &QLineEdit::textChanged, this, &HapticDevicePanel::showSelected);
  auto* firmware = new QHBoxLayout(firmware_row_);
  firmware->setContentsMargins(0, 0, 0, 0);
  firmware->addWidget(firmware_, 1);
  firmware->addWidget(choose);

  turned_by_->setObjectName("turnedBy");
  turned_by_->setToolTip(tr("The device that turns the tool, where this one has no rotation"));
  auto* turned = new QHBoxLayout(turned_row_);
  turned->setContentsMargins(0, 0, 0, 0);
  turned->addWidget(new QLabel(tr("Rotation")));
  turned->addWidget(turned_by_, 1);

  connect_->setObjectName("connectDevice");
  connect_->setToolTip(tr("Connects the chosen device, without a force, or disconnects it"));
  connect(connect_, &QPushButton::clicked, this, &HapticDevicePanel::connectSelected);
  auto* again = new QPushButton(tr("Look again"));
  again->setObjectName("lookAgain");
  again->setToolTip(tr("Looks for devices that were plugged in meanwhile"));
  connect(again, &QPushButton::clicked, this, &HapticDevicePanel::surveyWanted);
  auto* row = new QHBoxLayout;
  row->addWidget(connect_, 1);
  row->addWidget(set_up_);
  row->addWidget(again);
  set_up_->setObjectName("setUpDevice");
  set_up_->setToolTip(tr("Cables, permission, first use and troubleshooting"));
  connect(set_up_, &QPushButton::clicked, this, &HapticDevicePanel::showSetUp);

  auto* box = new QWidget;
  auto* column = new QVBoxLayout(box);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(list_);
  column->addWidget(why_);
  column->addWidget(firmware_row_);
  column->addWidget(turned_row_);
  column->addLayout(row);
  column->addWidget(link_words_);
  return box;
}

QWidget* HapticDevicePanel::buildMapping() {
  auto* box = new QWidget;
  follow_camera_->setObjectName("followCamera");
  follow_camera_->setToolTip(
      tr("Right, up and towards you are the picture's; without it they stay as they are now."));
  hold_to_run_->setObjectName("holdToRun");
  whenKeysChange(*this, [this] {
    hold_to_run_->setToolTip(tr("Force only while this button, or %1 in the 3-D view, is held down")
                                 .arg(keyOf(Action::HoldToRun)));
    clutch_button_->setToolTip(
        tr("While this button, or %1 in the 3-D view, is held, the tool stays and the hand moves")
            .arg(keyOf(Action::Clutch)));
    hold_button_->setToolTip(tr("The button that is held for a force, beside %1 in the 3-D view")
                                 .arg(keyOf(Action::HoldToRun)));
    cut_button_->setToolTip(
        tr("While this button, or %1 in the 3-D view, is held, the burr turns and cuts")
            .arg(keyOf(Action::Cut)));
  });
  position_scale_->setToolTip(tr("Millimetres of the tool for a millimetre of the hand"));
  lift_->setObjectName("liftStiffness");
  lift_->setToolTip(
      tr("Up to the device's rated stiffness. Without it, a stiffness at which the device and a "
         "light hand may shake each other cannot be set."));
  lifted_words_->setText(
      tr("The device may shake, hard and at once: hold it firmly, and keep Escape in reach."));
  force_scale_->setToolTip(tr("Newtons at the hand for a newton in the scan"));
  auto* title = new QLabel(tr("From the hand to the scan"));
  style::setType(*title, style::Type::Section);
  style::setDim(*title);
  auto* form = new QFormLayout(box);
  form->setContentsMargins(0, 0, 0, 0);
  form->addRow(title);
  form->addRow(tr("Motion scale"), position_scale_);
  form->addRow(position_words_);
  form->addRow(tr("Force scale"), force_scale_);
  form->addRow(tr("Stiffness"), stiffness_);
  form->addRow(capped_);
  form->addRow(lift_);
  form->addRow(lifted_words_);
  form->addRow(follow_camera_);
  form->addRow(tr("Clutch"), clutch_button_);
  form->addRow(hold_to_run_);
  form->addRow(tr("Held by"), hold_button_);
  form->addRow(tr("Burr"), cut_button_);

  const auto changed = [this] { changeMapping(); };
  connect(position_scale_, &NumberBox::valueChanged, this, changed);
  connect(force_scale_, &NumberBox::valueChanged, this, changed);
  connect(lift_, &QCheckBox::toggled, lifted_words_, &QLabel::setVisible);
  connect(lift_, &QCheckBox::toggled, this, &HapticDevicePanel::stiffnessLifted);
  connect(follow_camera_, &QCheckBox::toggled, this, changed);
  connect(clutch_button_, &QComboBox::activated, this, changed);
  connect(hold_to_run_, &QCheckBox::toggled, this, changed);
  connect(hold_button_, &QComboBox::activated, this, changed);
  connect(cut_button_, &QComboBox::activated, this, changed);
  return box;
}

void HapticDevicePanel::show(const QList<DeviceLine>& devices) {
  const DeviceLine* before = selected();
  const QString kept = before != nullptr ? before->id : connected_;
  surveyed_ = devices_ = devices;
  std::stable_partition(devices_.begin(), devices_.end(),
                        [](const DeviceLine& line) { return line.present; });
  bool refused_is_here = false;
  for (DeviceLine& device : devices_) {
    if (device.id != without_firmware_ || !device.present) continue;
    refused_is_here = true;
    device.trouble = Trouble::NoFirmware;
    device.why = firmware_words_;
  }
  if (!refused_is_here) without_firmware_.clear();
  {
    const QSignalBlocker quiet(list_);
    list_->clear();
    for (const DeviceLine& device : devices_) {
      const bool mine = link_ == Link::Connected && device.id == connected_;
      const bool alone = std::ranges::count(devices_, device.name, &DeviceLine::name) == 1;
      const QString name =
          alone || placeOf(device).isEmpty()
              ? device.name
              : tr("%1 at %2", "a device and its place").arg(device.name, placeOf(device));
      const QString state = lost_ ? wordsFor(Trouble::Lost, true) : tr("connected");
      auto* line =
          new QTreeWidgetItem({name, mine ? state : wordsFor(device.trouble, device.present)});
      line->setToolTip(Name, (name + '\n' + device.why).trimmed().toHtmlEscaped());
      if (!canConnect(device, true))
        for (int c = 0; c < kColumns; ++c) line->setForeground(c, style::colours().dim);
      list_->addTopLevelItem(line);
      if (device.id == kept) list_->setCurrentItem(line);
    }
    if (list_->currentItem() == nullptr && list_->topLevelItemCount() > 0)
      list_->setCurrentItem(list_->topLevelItem(0));
  }
  showSelected();
}

const DeviceLine* HapticDevicePanel::selected() const {
  const auto row = list_->indexOfTopLevelItem(list_->currentItem());
  return row < 0 || row >= devices_.size() ? nullptr : &devices_[row];
}

void HapticDevicePanel::showSelected() {
  const DeviceLine* device = selected();
  const bool mine = device != nullptr && link_ == Link::Connected && device->id == connected_;
  // that this program has it is no trouble to the user
  const bool told = device != nullptr && (!mine || isAtDevice(device->trouble));
  why_->setText(told ? device->why : QString{});
  why_->setVisible(!why_->text().isEmpty());
  const bool free = link_ == Link::None;
  firmware_row_->setVisible(free && device != nullptr && device->trouble == Trouble::NoFirmware);
  turned_row_->setVisible(free && device != nullptr && device->sensed == 3);
  if (free) listTurners(device);
  if (link_ == Link::Connecting)
    connect_->setText(tr("Cancel"));
  else
    connect_->setText(free ? tr("Connect") : tr("Disconnect"));
  set_up_->setEnabled(device != nullptr && !setUpPage(device->id).isEmpty());
  connect_->setEnabled(
      !free || (device != nullptr && canConnect(*device, !firmware_->text().trimmed().isEmpty())));
}

void HapticDevicePanel::showSetUp() {
  const DeviceLine* device = selected();
  if (device == nullptr) return;
  (new SetUpDialog(device->id, device->name, device->actuated > 0, this))->show();
}

void HapticDevicePanel::listTurners(const DeviceLine* device) {
  const QString kept = turned_by_->currentData().toString();
  turned_by_->clear();
  turned_by_->addItem(tr("held as it is"), QString());
  for (const DeviceLine& other : devices_)
    if (device != nullptr && other.id != device->id && other.sensed >= 6 && other.actuated == 0 &&
        canConnect(other, false))
      turned_by_->addItem(other.name, other.id);
  turned_by_->setCurrentIndex(std::max(0, turned_by_->findData(kept)));
}

void HapticDevicePanel::chooseFirmware() {
  // Qt's own dialog: in a foreign one Escape would not reach the application
  const QString path =
      QFileDialog::getOpenFileName(this, tr("Firmware of the device"), {}, tr("All files (*)"),
                                   nullptr, QFileDialog::DontUseNativeDialog);
  if (!path.isEmpty()) firmware_->setText(path);
}

void HapticDevicePanel::connectSelected() {
  if (link_ != Link::None) return void(emit disconnectWanted());
  const DeviceLine* device = selected();
  if (device == nullptr) return;
  DeviceWish wish{.id = device->id};
  if (device->trouble == Trouble::NoFirmware) wish.firmware = firmware_->text().trimmed();
  if (device->sensed == 3) wish.turned_by = turned_by_->currentData().toString();
  emit connectWanted(wish);
}

void HapticDevicePanel::showConnecting(const QString& name) {
  link_ = Link::Connecting;
  link_words_->setText(tr("Connecting %1…").arg(name));
  link_words_->show();
  patience_->start(kPatienceMs);
  showSelected();
}

void HapticDevicePanel::showConnected(const QString& id) {
  link_ = Link::Connected;
  connected_ = id;
  if (id == without_firmware_) without_firmware_.clear();
  const auto device = std::ranges::find(devices_, id, &DeviceLine::id);
  motors_ = device == devices_.end() || device->actuated > 0;
  lost_ = false;
  lift_->setChecked(false);
  lift_->setEnabled(motors_);
  link_words_->hide();
  patience_->stop();
  show(QList<DeviceLine>{surveyed_});
  display({});
}

void HapticDevicePanel::showRefused(const QString& id, Trouble trouble, const QString& why) {
  if (trouble == Trouble::NoFirmware) {
    without_firmware_ = id;
    firmware_words_ = why;
  }
  showDisconnected(why);
}

void HapticDevicePanel::showDisconnected(const QString& why) {
  link_ = Link::None;
  connected_.clear();
  lift_->setChecked(false);
  lift_->setEnabled(false);
  patience_->stop();
  link_words_->setText(why);
  link_words_->setVisible(!why.isEmpty());
  show(QList<DeviceLine>{surveyed_});
  display({});
}

void HapticDevicePanel::show(const Mapping& mapping) {
  mapping_ = mapping;
  const QSignalBlocker quiet[] = {QSignalBlocker(position_scale_), QSignalBlocker(force_scale_),
                                  QSignalBlocker(follow_camera_), QSignalBlocker(hold_to_run_)};
  position_scale_->setValue(mapping.position_scale);
  force_scale_->setValue(mapping.force_scale);
  follow_camera_->setChecked(mapping.follow_camera);
  clutch_button_->setCurrentIndex(std::max(0, clutch_button_->findData(mapping.clutch_button)));
  hold_to_run_->setChecked(mapping.hold_to_run);
  hold_button_->setCurrentIndex(std::max(0, hold_button_->findData(mapping.hold_button)));
  cut_button_->setCurrentIndex(std::max(0, cut_button_->findData(mapping.cut_button)));
  showMappingWords();
}

void HapticDevicePanel::changeMapping() {
  mapping_ = {.position_scale = position_scale_->value(),
              .force_scale = force_scale_->value(),
              .follow_camera = follow_camera_->isChecked(),
              .clutch_button = clutch_button_->currentData().toInt(),
              .hold_to_run = hold_to_run_->isChecked(),
              .hold_button = hold_button_->currentData().toInt(),
              .cut_button = cut_button_->currentData().toInt()};
  showMappingWords();
  emit mappingChanged(mapping_);
}

void HapticDevicePanel::showMappingWords() {
  position_words_->setText(
      tr("1 mm of the hand is %1 mm in the scan.").arg(shownNumber(mapping_.position_scale)));
  hold_button_->setEnabled(mapping_.hold_to_run);
}

void HapticDevicePanel::showStiffness(const haptics::Settings& wished,
                                      const std::optional<haptics::Settings>& in_force) {
  // the same spring, seen from either end
  const double wished_at_hand = wished.stiffness * wished.force_scale * wished.position_scale;
  const double at_hand = in_force ? in_force->stiffness * in_force->position_scale : wished_at_hand;
  const double in_scan = at_hand / (wished.force_scale * wished.position_scale);
  const QString twice = tr("%1 N/m at the hand\n%2 N/m in the scan")
                            .arg(shownNumber(std::round(at_hand)))
                            .arg(shownNumber(std::round(in_scan)));
  // sixty times a second: what has not changed is not set anew
  if (stiffness_->text() != twice) stiffness_->setText(twice);
  const QString capped =
      at_hand < kCapped * wished_at_hand
          ? tr("No more is allowed to this device: %1 N/m at the hand were asked for.")
                .arg(shownNumber(std::round(wished_at_hand)))
          : QString{};
  if (capped_->text() != capped) capped_->setText(capped);
  capped_->setVisible(!capped.isEmpty());
}

void HapticDevicePanel::display(const haptics::Snapshot& snapshot) {
  const bool here = link_ == Link::Connected;
  const bool lost = here && (snapshot.trouble == Trouble::Lost ||
                             (snapshot.force_state == ForceState::Fault &&
                              snapshot.reason == haptics::ForceReason::Lost));
  if (lost != lost_) {
    lost_ = lost;
    show(QList<DeviceLine>{surveyed_});
  }
  ForceSaid state{Mark::Off, tr("No device")};
  QString sentence, share;
  bool waits = false;
  if (here && !motors_) {
    state = stateOf(snapshot.force_state, Feel::Nothing);
    sentence = lost ? sentenceFor(snapshot.force_state, snapshot.reason, snapshot.trouble)
                    : tr("It moves the tool; nothing is felt.");
  } else if (here) {
    state = stateOf(snapshot.force_state, Feel::Felt);
    sentence = sentenceFor(snapshot.force_state, snapshot.reason, snapshot.trouble);
    if (snapshot.stiffness_share < kCapped)
      share = tr("The stiffness is lowered to %1 % for now: the hand and the device shook.")
                  .arg(std::round(snapshot.stiffness_share * 100.0));
    waits = !lost && (snapshot.force_state == ForceState::Ready ||
                      snapshot.force_state == ForceState::Fault);
  }
  // sixty times a second: what has not changed is not set anew
  if (share_->text() != share) share_->setText(share);
  share_->setVisible(!share.isEmpty());
  if (reason_->text() != sentence) reason_->setText(sentence);
  reason_->setVisible(!sentence.isEmpty());
  arm_->setEnabled(waits);
  state_->show(state.mark, state.words);
}

void HapticDevicePanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  emit seen(true);
}

void HapticDevicePanel::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  emit seen(false);
}

}  // namespace ui
