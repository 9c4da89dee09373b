// SPDX-License-Identifier: BSD-3-Clause
#include "ui/panels/haptic_device_panel.h"

#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSet>
#include <QSignalSpy>
#include <QTest>
#include <QTextBrowser>
#include <QTreeWidget>

#include "haptics/devices/catalogue.h"
#include "tests/ui/window_support.h"
#include "ui/controls/set_up_page.h"
#include "ui/panels/force_words.h"
#include "ui/style/look.h"
#include "ui/style/style.h"

namespace {

using haptics::ForceReason;
using haptics::ForceState;
using haptics::Trouble;
using ui::DeviceLine;
using ui::HapticDevicePanel;

const QString kNotPlugged = "No SpaceMouse is plugged in; connect its cable or its receiver.";
const QString kNoFirmware = "The Falcon has no firmware; name its maker's file.";

QList<DeviceLine> someDevices() {
  return {
      {.id = "spacemouse",
       .name = "3Dconnexion SpaceMouse",
       .sensed = 6,
       .trouble = Trouble::NotPluggedIn,
       .why = kNotPlugged},
      {.id = "falcon",
       .name = "Novint Falcon",
       .sensed = 3,
       .actuated = 3,
       .present = true,
       .trouble = Trouble::NoFirmware,
       .why = kNoFirmware},
      {.id = "inverse3:1", .name = "Haply Inverse3", .sensed = 6, .actuated = 3, .present = true}};
}

class Shown {
 public:
  Shown() {
    panel.show(someDevices());
    window::showAndWait(panel, {330, 720});
  }
  template <class T>
  T* find(const char* name) {
    T* found = panel.findChild<T*>(name);
    EXPECT_NE(found, nullptr) << name;
    return found;
  }
  void select(int row) { list->setCurrentItem(list->topLevelItem(row)); }

  HapticDevicePanel panel;
  QTreeWidget* list = find<QTreeWidget>("deviceList");
  QLabel* why = find<QLabel>("deviceWhy");
  QPushButton* connect = find<QPushButton>("connectDevice");
};

TEST(HapticDevicePanel, WhatIsHereComesFirstAndWhatIsMissingIsGreyWithItsReasonAsText) {
  Shown shown;
  ASSERT_EQ(shown.list->topLevelItemCount(), 3);
  EXPECT_EQ(shown.list->topLevelItem(0)->text(0), "Novint Falcon");
  EXPECT_EQ(shown.list->topLevelItem(1)->text(0), "Haply Inverse3");
  const QTreeWidgetItem* missing = shown.list->topLevelItem(2);
  EXPECT_EQ(missing->text(0), "3Dconnexion SpaceMouse");
  EXPECT_EQ(missing->text(1), "not plugged in");
  // a grey that can be read: its contrast is tested with the themes
  EXPECT_EQ(missing->foreground(0).color(), ui::style::colours().dim);
  EXPECT_EQ(missing->foreground(0).style(), Qt::SolidPattern);
  EXPECT_EQ(shown.list->topLevelItem(1)->foreground(0).style(), Qt::NoBrush);
  shown.select(2);
  EXPECT_TRUE(shown.why->isVisible());
  EXPECT_EQ(shown.why->text(), kNotPlugged);
  EXPECT_FALSE(shown.connect->isEnabled());
  window::keep(window::pictureOf(shown.panel), "haptic_device_missing");
  shown.select(1);
  EXPECT_FALSE(shown.why->isVisible());
  EXPECT_TRUE(shown.connect->isEnabled());
}

TEST(HapticDevicePanel, EachTroubleHasItsWordsAndSentenceAndOnlySomeLetConnect) {
  Shown shown;
  QSet<QString> words;
  for (int n = 1; n <= static_cast<int>(Trouble::Lost); ++n) {
    const auto trouble = static_cast<Trouble>(n);
    const QString sentence = QString("Sentence %1 <b>.").arg(n);
    shown.panel.show(QList<DeviceLine>{{.id = "x",
                                        .name = "X",
                                        .sensed = 6,
                                        .present = trouble != Trouble::NotPluggedIn,
                                        .trouble = trouble,
                                        .why = sentence}});
    words << shown.list->topLevelItem(0)->text(1);
    EXPECT_EQ(shown.why->text(), sentence);
    EXPECT_EQ(shown.why->textFormat(), Qt::PlainText);
    const bool user_sees_to_it = trouble == Trouble::NotHomed ||
                                 trouble == Trouble::NeedsCalibration ||
                                 trouble == Trouble::NotStarted || trouble == Trouble::MotorsHot ||
                                 trouble == Trouble::ForceOff;
    EXPECT_EQ(shown.connect->isEnabled(), user_sees_to_it) << n;
  }
  EXPECT_EQ(words.size(), static_cast<int>(Trouble::Lost));
}

TEST(HapticDevicePanel, TheListIsAsLongAsThePanelHasRoomFor) {
  Shown shown;
  QList<DeviceLine> many;
  for (int n = 0; n < 16; ++n)
    many << DeviceLine{.id = QString("d%1").arg(n), .name = QString("Device %1").arg(n)};
  shown.panel.show(many);
  shown.panel.resize(330, 1100);
  QTest::qWait(50);
  window::keep(window::pictureOf(shown.panel), "haptic_device_list");
  const QRect last = shown.list->visualItemRect(shown.list->topLevelItem(15));
  EXPECT_TRUE(shown.list->viewport()->rect().contains(last));
  // where there is none, it scrolls, and four are seen
  shown.panel.resize(330, shown.panel.minimumSizeHint().height());
  QTest::qWait(50);
  EXPECT_TRUE(shown.list->viewport()->rect().contains(
      shown.list->visualItemRect(shown.list->topLevelItem(3))));
  const int height = shown.list->sizeHint().height();
  shown.panel.show(many.first(8));
  EXPECT_LT(shown.list->sizeHint().height(), height);
}

TEST(HapticDevicePanel, EveryDriverHasItsPageOfHowToSetItUp) {
  for (const haptics::Driver& driver : haptics::drivers()) {
    const std::string name(driver.name);
    const QString page = ui::setUpPage(QString::fromStdString(name) + ":1-2");
    for (const char* part : {"# ", "## Cables and power", "## First use", "## What can go wrong"})
      EXPECT_TRUE(page.contains(part)) << name << ": " << part;
    EXPECT_TRUE(page.contains("ermission") || page.contains("## Service")) << name;
  }
  EXPECT_EQ(ui::setUpPage("something"), "");
  Shown shown;
  auto* set_up = shown.find<QPushButton>("setUpDevice");
  shown.select(0);
  EXPECT_TRUE(set_up->isEnabled());
  QTest::mouseClick(set_up, Qt::LeftButton);
  auto* page = shown.find<QTextBrowser>("setUpPage");
  EXPECT_TRUE(page->window()->isVisible());
  EXPECT_FALSE(page->window()->isModal());
  EXPECT_TRUE(page->toPlainText().contains("Homing"));
  EXPECT_TRUE(page->toPlainText().contains("For every device with motors"));
  window::keep(window::pictureOf(*page->window()), "haptic_device_set_up");
  page->window()->close();
  QTest::qWait(30);
  // what has no motors cannot hurt
  shown.select(2);
  QTest::mouseClick(set_up, Qt::LeftButton);
  EXPECT_FALSE(shown.find<QTextBrowser>("setUpPage")->toPlainText().contains("with motors"));
}

TEST(HapticDevicePanel, WhatOnlyOpeningTellsCanBeTried) {
  Shown shown;
  QSignalSpy wanted(&shown.panel, &HapticDevicePanel::connectWanted);
  shown.panel.show(QList<DeviceLine>{
      {.id = "openhaptics", .name = "Touch", .sensed = 6, .actuated = 3, .why = "Opening tells."}});
  const QTreeWidgetItem* line = shown.list->topLevelItem(0);
  EXPECT_EQ(line->text(1), "to be tried");
  EXPECT_EQ(line->foreground(0).style(), Qt::NoBrush);
  EXPECT_EQ(shown.why->text(), "Opening tells.");
  QTest::mouseClick(shown.connect, Qt::LeftButton);
  ASSERT_EQ(wanted.size(), 1);
  EXPECT_EQ(qvariant_cast<ui::DeviceWish>(wanted[0][0]), (ui::DeviceWish{.id = "openhaptics"}));
}

TEST(HapticDevicePanel, FirmwareIsAskedForOnlyWhereItIsMissing) {
  Shown shown;
  QSignalSpy wanted(&shown.panel, &HapticDevicePanel::connectWanted);
  shown.select(0);
  auto* firmware = shown.find<QLineEdit>("firmware");
  EXPECT_TRUE(firmware->isVisible());
  EXPECT_FALSE(shown.connect->isEnabled());
  QTest::keyClicks(firmware, "/firmware of its maker");
  ASSERT_TRUE(shown.connect->isEnabled());
  window::keep(window::pictureOf(shown.panel), "haptic_device_firmware");
  QTest::mouseClick(shown.connect, Qt::LeftButton);
  ASSERT_EQ(wanted.size(), 1);
  EXPECT_EQ(qvariant_cast<ui::DeviceWish>(wanted[0][0]),
            (ui::DeviceWish{.id = "falcon", .firmware = "/firmware of its maker"}));
  shown.select(1);
  EXPECT_FALSE(firmware->isVisible());
  QTest::mouseClick(shown.connect, Qt::LeftButton);
  ASSERT_EQ(wanted.size(), 2);
  EXPECT_EQ(qvariant_cast<ui::DeviceWish>(wanted[1][0]), (ui::DeviceWish{.id = "inverse3:1"}));
}

TEST(HapticDevicePanel, WhatOnlyOpeningTellsOfFirmwareIsRemembered) {
  Shown shown;
  QSignalSpy wanted(&shown.panel, &HapticDevicePanel::connectWanted);
  QList<DeviceLine> devices = someDevices();
  devices[1].trouble = Trouble::None;
  devices[1].why.clear();
  shown.panel.show(devices);
  shown.select(0);
  auto* firmware = shown.find<QLineEdit>("firmware");
  EXPECT_FALSE(firmware->isVisible());
  shown.panel.showConnecting("Novint Falcon");
  shown.panel.showRefused("falcon", Trouble::NoFirmware, kNoFirmware);
  EXPECT_EQ(shown.list->topLevelItem(0)->text(1), "needs firmware");
  EXPECT_EQ(shown.why->text(), kNoFirmware);
  ASSERT_TRUE(firmware->isVisible());
  QTest::keyClicks(firmware, "/firmware");
  shown.panel.show(devices);  // looked for again: it does not say so by itself
  QTest::mouseClick(shown.connect, Qt::LeftButton);
  ASSERT_EQ(wanted.size(), 1);
  EXPECT_EQ(qvariant_cast<ui::DeviceWish>(wanted[0][0]),
            (ui::DeviceWish{.id = "falcon", .firmware = "/firmware"}));
  // connected it has it, from then on
  shown.panel.showConnected("falcon");
  shown.panel.showDisconnected({});
  EXPECT_EQ(shown.list->topLevelItem(0)->text(1), "here");
  EXPECT_FALSE(firmware->isVisible());
  shown.panel.showRefused("falcon", Trouble::NoFirmware, kNoFirmware);
  EXPECT_TRUE(firmware->isVisible());
  // pulled out and plugged in it may have some
  devices[1].present = false;
  shown.panel.show(devices);
  devices[1].present = true;
  shown.panel.show(devices);
  EXPECT_EQ(shown.list->topLevelItem(0)->text(1), "here");
  // other refusals do not ask for it
  shown.panel.showRefused("falcon", Trouble::InUse, "Another program uses it.");
  EXPECT_EQ(shown.list->topLevelItem(0)->text(1), "here");
  EXPECT_EQ(shown.find<QLabel>("deviceLink")->text(), "Another program uses it.");
}

TEST(HapticDevicePanel, DevicesOfOneNameAreToldApartByTheirPlaces) {
  Shown shown;
  QList<DeviceLine> devices = someDevices();
  devices[1].id = "falcon:1-2";
  devices << devices[1];
  devices.last().id = "falcon:3-1.4";
  shown.panel.show(devices);
  EXPECT_EQ(shown.list->topLevelItem(0)->text(0), "Novint Falcon at 1-2");
  EXPECT_EQ(shown.list->topLevelItem(1)->text(0), "Haply Inverse3");
  EXPECT_EQ(shown.list->topLevelItem(2)->text(0), "Novint Falcon at 3-1.4");
}

TEST(HapticDevicePanel, ADeviceWithoutRotationMayBeTurnedByAnother) {
  Shown shown;
  QSignalSpy wanted(&shown.panel, &HapticDevicePanel::connectWanted);
  QList<DeviceLine> devices = someDevices();
  devices[0].present = true;
  devices[0].trouble = devices[1].trouble = Trouble::None;
  shown.panel.show(devices);
  auto* turned_by = shown.find<QComboBox>("turnedBy");
  shown.select(2);
  EXPECT_FALSE(turned_by->isVisible());  // an Inverse3 knows its rotation
  shown.select(1);
  ASSERT_TRUE(turned_by->isVisible());
  EXPECT_EQ(turned_by->currentData().toString(), QString());
  ASSERT_GE(turned_by->findData("spacemouse"), 0);
  EXPECT_EQ(turned_by->findData("falcon"), -1);
  EXPECT_EQ(turned_by->findData("inverse3:1"), -1);  // it has motors of its own to see to
  turned_by->setCurrentIndex(turned_by->findData("spacemouse"));
  // it is not forgotten while the list is told anew
  shown.panel.show(devices);
  QTest::mouseClick(shown.connect, Qt::LeftButton);
  ASSERT_EQ(wanted.size(), 1);
  EXPECT_EQ(qvariant_cast<ui::DeviceWish>(wanted[0][0]),
            (ui::DeviceWish{.id = "falcon", .turned_by = "spacemouse"}));
}

TEST(HapticDevicePanel, ConnectingCanBeGivenUpAndConnectedBeEnded) {
  Shown shown;
  QSignalSpy ended(&shown.panel, &HapticDevicePanel::disconnectWanted);
  shown.select(1);
  shown.panel.showConnecting("Haply Inverse3");
  auto* link = shown.find<QLabel>("deviceLink");
  EXPECT_TRUE(link->text().contains("Haply Inverse3"));
  EXPECT_EQ(shown.connect->text(), "Cancel");
  QTest::mouseClick(shown.connect, Qt::LeftButton);
  EXPECT_EQ(ended.size(), 1);
  shown.panel.showConnected("inverse3:1");
  EXPECT_EQ(shown.connect->text(), "Disconnect");
  EXPECT_EQ(shown.list->topLevelItem(1)->text(1), "connected");
  // that this program has it is no trouble to the user
  QList<DeviceLine> devices = someDevices();
  devices[2].trouble = Trouble::InUse;
  devices[2].why = "Another program has it.";
  shown.panel.show(devices);
  EXPECT_EQ(shown.list->topLevelItem(1)->text(1), "connected");
  EXPECT_FALSE(shown.why->isVisible());
  // but what the device wants of the user is
  devices[2].trouble = Trouble::NotStarted;
  devices[2].why = "It has no power.";
  shown.panel.show(devices);
  EXPECT_EQ(shown.list->topLevelItem(1)->text(1), "connected");
  EXPECT_EQ(shown.why->text(), "It has no power.");
  EXPECT_TRUE(shown.why->isVisible());
  QTest::mouseClick(shown.connect, Qt::LeftButton);
  EXPECT_EQ(ended.size(), 2);
  shown.panel.showDisconnected("It was unplugged.");
  EXPECT_EQ(link->text(), "It was unplugged.");
  EXPECT_TRUE(link->isVisible());
}

TEST(HapticDevicePanel, TheMappingIsSaidInWordsAndEachChangeIsToldOnce) {
  Shown shown;
  QSignalSpy changed(&shown.panel, &HapticDevicePanel::mappingChanged);
  ui::Mapping mapping{.position_scale = 2.0, .force_scale = 0.5, .follow_camera = false};
  shown.panel.show(mapping);
  EXPECT_EQ(changed.size(), 0);
  EXPECT_EQ(shown.find<QLabel>("positionScaleWords")->text(),
            "1 mm of the hand is 2 mm in the scan.");
  auto* scale = shown.find<QDoubleSpinBox>("positionScale");
  scale->setValue(100.0);
  EXPECT_EQ(scale->value(), 10.0);
  scale->setValue(0.5);
  shown.find<QCheckBox>("followCamera")->click();
  shown.find<QCheckBox>("holdToRun")->click();
  auto* clutch = shown.find<QComboBox>("clutchButton");
  clutch->setFocus();
  QTest::keyClick(clutch, Qt::Key_Down);
  auto* hold = shown.find<QComboBox>("holdButton");
  hold->setFocus();
  QTest::keyClick(hold, Qt::Key_End);
  auto* cut = shown.find<QComboBox>("cutButton");
  cut->setFocus();
  QTest::keyClick(cut, Qt::Key_Down);
  QTest::keyClick(cut, Qt::Key_Down);
  ASSERT_EQ(changed.size(), 8);
  EXPECT_EQ(qvariant_cast<ui::Mapping>(changed.last()[0]), (ui::Mapping{.position_scale = 0.5,
                                                                        .force_scale = 0.5,
                                                                        .follow_camera = true,
                                                                        .clutch_button = 0,
                                                                        .hold_to_run = true,
                                                                        .hold_button = 15,
                                                                        .cut_button = 1}));
  EXPECT_EQ(clutch->count(), 17);
  EXPECT_EQ(hold->itemText(8), "button 8");
  EXPECT_EQ(hold->currentText(), "button 16 (second device: 8)");
}

TEST(HapticDevicePanel, TheStiffnessIsShownAtBothEndsAndWhetherItIsCapped) {
  Shown shown;
  haptics::Settings wished;
  wished.stiffness = 1'000.0;
  wished.position_scale = 2.0;
  wished.force_scale = 0.5;
  auto* twice = shown.find<QLabel>("stiffnessTwice");
  auto* capped = shown.find<QLabel>("stiffnessCapped");
  shown.panel.showStiffness(wished, std::nullopt);
  EXPECT_EQ(twice->text(), "1,000 N/m at the hand\n1,000 N/m in the scan");
  EXPECT_FALSE(capped->isVisible());
  // half the scale, half the stiffness at the hand
  wished.position_scale = 1.0;
  shown.panel.showStiffness(wished, std::nullopt);
  EXPECT_EQ(twice->text(), "500 N/m at the hand\n1,000 N/m in the scan");
  // in force its force scale is taken into it: 3 x 2000 N/m are not rendered by 3000 N/m
  wished = {};
  wished.stiffness = 2'000.0;
  wished.position_scale = 3.0;
  haptics::Settings in_force = wished;
  in_force.stiffness = 1'000.0;
  shown.panel.showStiffness(wished, in_force);
  EXPECT_EQ(twice->text(), "3,000 N/m at the hand\n1,000 N/m in the scan");
  EXPECT_TRUE(capped->isVisible());
  EXPECT_TRUE(capped->text().contains("6,000 N/m")) << capped->text().toStdString();
  in_force.stiffness = 2'000.0;
  shown.panel.showStiffness(wished, in_force);
  EXPECT_FALSE(capped->isVisible());
}

TEST(HapticDevicePanel, WhatMayShakeIsAllowedByTheUserAloneAndForOneConnection) {
  Shown shown;
  QSignalSpy lifted(&shown.panel, &HapticDevicePanel::stiffnessLifted);
  auto* lift = shown.find<QCheckBox>("liftStiffness");
  auto* warning = shown.find<QLabel>("stiffnessLiftedWords");
  EXPECT_FALSE(lift->isEnabled());
  EXPECT_FALSE(warning->isVisible());
  for (int connection = 0; connection < 2; ++connection) {
    shown.panel.showConnected("falcon");
    ASSERT_TRUE(lift->isEnabled());
    ASSERT_FALSE(lift->isChecked());
    lift->click();
    EXPECT_TRUE(warning->isVisible());
    EXPECT_TRUE(lifted.takeLast().at(0).toBool());
    // another one, without a word of the first, or none
    if (connection == 1) shown.panel.showDisconnected({});
  }
  EXPECT_FALSE(lift->isChecked());
  EXPECT_FALSE(lift->isEnabled());
  EXPECT_FALSE(warning->isVisible());
  EXPECT_FALSE(lifted.takeLast().at(0).toBool());
}

TEST(HapticDevicePanel, EachStateIsToldByAWordAMarkAndWhy) {
  Shown shown;
  QSignalSpy armed(&shown.panel, &HapticDevicePanel::armWanted);
  auto* state = shown.find<ui::StateChip>("forceState");
  auto* reason = shown.find<QLabel>("forceReason");
  auto* arm = shown.find<QPushButton>("arm");
  QSet<QString> words;
  QSet<int> marks;
  std::vector<QImage> pictures;
  // nobody's force but a connected device's
  haptics::Snapshot mouse;
  mouse.force_state = ForceState::On;
  shown.panel.display(mouse);
  EXPECT_EQ(state->text(), "No device");
  EXPECT_FALSE(arm->isEnabled());
  shown.panel.showConnected("inverse3:1");
  const struct {
    ForceState state;
    ForceReason reason;
    bool may_arm;
    const char* word;
    const char* sentence;
  } cases[] = {
      {ForceState::Off, ForceReason::NoReading, false, "No force yet", "has not reported"},
      {ForceState::Ready, ForceReason::User, true, "Force off", "Arm the device"},
      {ForceState::Armed, ForceReason::Clutched, false, "Force withheld", "clutch"},
      {ForceState::Ramping, ForceReason::Gap, false, "Force rising", "gap"},
      {ForceState::On, ForceReason::User, false, "Force on", ""},
      {ForceState::Fault, ForceReason::Jump, true, "Fault: no force", "arm the device again"},
  };
  for (const auto& c : cases) {
    haptics::Snapshot snapshot;
    snapshot.policy = haptics::SchedulingPolicy::Ordinary;
    snapshot.force_state = c.state;
    snapshot.reason = c.reason;
    shown.panel.display(snapshot);
    EXPECT_EQ(state->text(), c.word);
    EXPECT_TRUE(reason->text().contains(c.sentence)) << reason->text().toStdString();
    EXPECT_EQ(reason->isVisible(), *c.sentence != '\0');
    EXPECT_EQ(arm->isEnabled(), c.may_arm) << c.word;
    words << state->text();
    marks << static_cast<int>(state->mark());
    // no colour alone: the marks differ where every colour is made the same
    QImage mark = window::pictureOf(*state).copy(8, 0, 20, state->height());
    for (int y = 0; y < mark.height(); ++y)
      for (int x = 0; x < mark.width(); ++x)
        mark.setPixel(x, y, qGray(mark.pixel(x, y)) > 60 ? 0xffffffff : 0xff000000);
    for (const QImage& other : pictures) EXPECT_GT(window::differing(mark, other), 0.01) << c.word;
    pictures.push_back(mark);
    // the colour of the stop button is no state's
    EXPECT_EQ(window::count(window::pictureOf(*state),
                            [](QColor p) { return p.rgb() == ui::style::kDark.stop.rgb(); }),
              0)
        << c.word;
    window::keep(
        window::pictureOf(shown.panel),
        QString("haptic_device_%1").arg(QString(c.word).remove(':').replace(' ', '_')).toUtf8());
  }
  EXPECT_EQ(words.size(), 6);
  EXPECT_EQ(marks.size(), 6);
  QTest::mouseClick(arm, Qt::LeftButton);
  EXPECT_EQ(armed.size(), 1);
  // what is gone is not armed, and the list says so
  haptics::Snapshot gone;
  gone.force_state = ForceState::Fault;
  gone.reason = ForceReason::Lost;
  shown.panel.display(gone);
  EXPECT_TRUE(reason->text().contains("connect it again"));
  EXPECT_FALSE(arm->isEnabled());
  EXPECT_EQ(shown.list->topLevelItem(1)->text(1), "disconnected");
  shown.panel.showConnected("inverse3:1");
  EXPECT_EQ(shown.list->topLevelItem(1)->text(1), "connected");
}

TEST(HapticDevicePanel, WhatHasNoMotorsIsNotArmed) {
  Shown shown;
  QList<DeviceLine> devices = someDevices();
  devices[0].present = true;
  devices[0].trouble = Trouble::None;
  shown.panel.show(devices);
  shown.panel.showConnected("spacemouse");
  haptics::Snapshot snapshot;
  snapshot.force_state = ForceState::Ready;
  shown.panel.display(snapshot);
  EXPECT_EQ(shown.find<QLabel>("forceState")->text(), "No motors, no force");
  EXPECT_TRUE(shown.find<QLabel>("forceReason")->text().contains("nothing is felt"));
  EXPECT_FALSE(shown.find<QPushButton>("arm")->isEnabled());
  snapshot.trouble = Trouble::Lost;
  snapshot.force_state = ForceState::Fault;
  snapshot.reason = ForceReason::Lost;
  shown.panel.display(snapshot);
  EXPECT_TRUE(shown.find<QLabel>("forceReason")->text().contains("disconnected"));
}

TEST(HapticDevicePanel, EveryReasonAndWhatTheDeviceAsksForHaveASentence) {
  QSet<QString> sentences;
  for (int n = static_cast<int>(ForceReason::NoReading);
       n <= static_cast<int>(ForceReason::Stalled); ++n) {
    const QString sentence =
        ui::sentenceFor(ForceState::Armed, static_cast<ForceReason>(n), Trouble::None);
    EXPECT_FALSE(sentence.isEmpty()) << n;
    sentences << sentence;
  }
  EXPECT_EQ(sentences.size(), static_cast<int>(ForceReason::Stalled) - 1);
  EXPECT_TRUE(
      ui::sentenceFor(ForceState::Off, ForceReason::NotHomed, Trouble::NotHomed).contains("stops"));
  EXPECT_TRUE(
      ui::sentenceFor(ForceState::On, ForceReason::User, Trouble::MotorsHot).contains("hot"));
}

TEST(HapticDevicePanel, WhatThePassivityGuardTookIsSaid) {
  Shown shown;
  auto* share = shown.find<QLabel>("stiffnessShare");
  shown.panel.showConnected("inverse3:1");
  haptics::Snapshot snapshot;
  shown.panel.display(snapshot);
  EXPECT_FALSE(share->isVisible());
  snapshot.stiffness_share = 0.42;
  shown.panel.display(snapshot);
  EXPECT_TRUE(share->isVisible());
  EXPECT_TRUE(share->text().contains("42 %")) << share->text().toStdString();
}

}  // namespace
