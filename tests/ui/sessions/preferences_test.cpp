// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/program/preferences.h"

#include <gtest/gtest.h>

#include <QDir>
#include <QSettings>
#include <QTemporaryDir>

#include "app/window/sessions/recordings.h"

namespace {

const ui::Mapping kMapped{.position_scale = 2.5,
                          .force_scale = 0.4,
                          .follow_camera = false,
                          .clutch_button = 0,
                          .hold_to_run = true,
                          .hold_button = 8,  // the first of a second device
                          .cut_button = 2};

TEST(Preferences, RememberHowAHandIsTakenToTheScan) {
  QSettings().remove("device");
  EXPECT_EQ(app::loadPreferences().mapping, ui::Mapping{});
  app::Preferences preferences = app::loadPreferences();
  preferences.mapping = kMapped;
  app::savePreferences(preferences);
  EXPECT_EQ(app::loadPreferences().mapping, kMapped);
  preferences.mapping = {};
  app::savePreferences(preferences);
  EXPECT_EQ(app::loadPreferences().mapping, ui::Mapping{});
}

TEST(Preferences, RememberTheNumbersOfStructuresAndNotThatOneIsFelt) {
  QSettings().remove("structures");
  EXPECT_EQ(app::loadPreferences().near, ui::NearLimits{});
  EXPECT_EQ(app::loadPreferences().feel, ui::StructureFeel{});
  app::Preferences preferences = app::loadPreferences();
  preferences.near = {.near_mm = 7.5, .close_mm = 1.5};
  preferences.feel = {
      .kind = ui::StructureFeel::Kind::Guarded, .stiffness = 150.0, .margin_mm = 4.5, .most = 1.25};
  app::savePreferences(preferences);
  EXPECT_EQ(app::loadPreferences().near, preferences.near);
  ui::StructureFeel kept = preferences.feel;
  kept.kind = ui::StructureFeel::Kind::AsScan;
  EXPECT_EQ(app::loadPreferences().feel, kept);
  QSettings().setValue("structures/margin_mm", "0");
  EXPECT_EQ(app::loadPreferences().feel.margin_mm, ui::StructureFeel{}.margin_mm);
  EXPECT_EQ(app::loadPreferences().unread, QStringList{"structures/margin_mm"});
  QSettings().remove("structures");
}

TEST(Preferences, AValueThatCannotBeReadWholeIsAsAtFirstAndTold) {
  const double first = app::Preferences{}.stiffness;
  for (const QVariant& wrong :
       {QVariant("2,5"), QVariant(QStringList{"2", "5"}), QVariant("abc"), QVariant("1000 N/m"),
        QVariant("nan"), QVariant("1e999"), QVariant("-1"), QVariant("20001"), QVariant("")}) {
    QSettings().clear();
    QSettings().setValue("coupling/stiffness", wrong);
    const app::Preferences loaded = app::loadPreferences();
    EXPECT_EQ(loaded.stiffness, first) << wrong.toString().toStdString();
    EXPECT_EQ(loaded.unread, QStringList{"coupling/stiffness"}) << wrong.toString().toStdString();
  }
  QSettings().setValue("coupling/stiffness", "2000");
  QSettings().setValue("window/hints", "perhaps");
  QSettings().setValue("device/clutch_button", "1.5");
  QSettings().setValue("device/force_scale", "1000");
  const app::Preferences loaded = app::loadPreferences();
  EXPECT_EQ(loaded.stiffness, 2000.0);
  EXPECT_TRUE(loaded.hints);
  EXPECT_EQ(loaded.mapping, ui::Mapping{});
  EXPECT_EQ(loaded.unread,
            (QStringList{"window/hints", "device/force_scale", "device/clutch_button"}));
  QSettings().clear();
  EXPECT_TRUE(app::loadPreferences().unread.isEmpty());
  // what is written can be read
  app::savePreferences({});
  EXPECT_TRUE(app::loadPreferences().unread.isEmpty());
}

TEST(Preferences, RememberUnitsMouseKeysStiffnessAndFolder) {
  QSettings().clear();
  app::Preferences preferences = app::loadPreferences();
  EXPECT_EQ(preferences.lengths, ui::LengthUnit::Millimetres);
  EXPECT_EQ(preferences.mouse, ui::MouseChoices{});
  EXPECT_EQ(preferences.stiffness_always, std::nullopt);
  EXPECT_EQ(preferences.servo_rate, std::nullopt);
  EXPECT_TRUE(preferences.keys.isEmpty());
  EXPECT_TRUE(preferences.recordings.isEmpty());
  preferences.lengths = ui::LengthUnit::Centimetres;
  preferences.mouse = {
      .at_first = ui::MouseMode::Hand, .slices_reversed = true, .zoom_reversed = true};
  preferences.stiffness_always = 0.0;
  preferences.servo_rate = 2000;
  preferences.keys = {{"take_tool", "B"}, {"grey_left", "Ctrl+Shift+Left"}};
  preferences.recordings = "/home/somebody/recordings";
  app::savePreferences(preferences);
  const app::Preferences loaded = app::loadPreferences();
  EXPECT_EQ(loaded.lengths, preferences.lengths);
  EXPECT_EQ(loaded.mouse, preferences.mouse);
  EXPECT_EQ(loaded.stiffness_always, 0.0);
  EXPECT_EQ(loaded.servo_rate, 2000);
  EXPECT_EQ(loaded.keys, preferences.keys);
  EXPECT_EQ(loaded.recordings, preferences.recordings);
  app::savePreferences({});
  EXPECT_TRUE(app::loadPreferences().keys.isEmpty());
  EXPECT_EQ(app::loadPreferences().stiffness_always, std::nullopt);
  EXPECT_EQ(app::loadPreferences().servo_rate, std::nullopt);
  QSettings().setValue("servo/rate", "3000");
  EXPECT_EQ(app::loadPreferences().servo_rate, std::nullopt);
  EXPECT_FALSE(QSettings().contains("recordings/folder"));
  for (const char* const odd : {"-1", "1e9", "nan", "inf", "", "much"}) {
    QSettings().setValue("coupling/stiffness_always", odd);
    EXPECT_EQ(app::loadPreferences().stiffness_always, std::nullopt) << odd;
  }
  QSettings().clear();
}

TEST(Preferences, AFolderOfRecordingsIsTriedBeforeItIsTaken) {
  const QTemporaryDir folder;
  EXPECT_EQ(app::refusalOf(folder.path().toStdString()), "");
  EXPECT_TRUE(QDir(folder.path()).isEmpty());
  const QString missing = folder.path() + "/missing";
  EXPECT_TRUE(app::refusalOf(missing.toStdString()).contains(missing));
  // a folder of the system's own, in which nobody can make a file
  EXPECT_TRUE(app::refusalOf("/proc/self").contains("/proc/self"));
  app::Recordings recordings(folder.path().toStdString());
  recordings.setFolder({});
  EXPECT_EQ(recordings.folder(), app::ownRecordings());
}

TEST(Preferences, WhatCannotBeIsLeftOut) {
  for (const char* const odd : {"0.0", "-3", "1e9", "nan", "inf", "", "much"}) {
    QSettings settings;
    for (const char* const key : {"position_scale", "force_scale", "clutch_button", "hold_button"})
      settings.setValue(QString("device/%1").arg(key), odd);
    const ui::Mapping mapping = app::loadPreferences().mapping;
    EXPECT_EQ(mapping.position_scale, 1.0) << odd;
    EXPECT_EQ(mapping.force_scale, 1.0) << odd;
    EXPECT_EQ(mapping.clutch_button, -1) << odd;
    EXPECT_EQ(mapping.hold_button, -1) << odd;
  }
  QSettings().remove("device");
}

}  // namespace
