// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/preferences.h"

#include <gtest/gtest.h>

#include <QSettings>

namespace {

const ui::Mapping kMapped{.position_scale = 2.5,
                          .force_scale = 0.4,
                          .follow_camera = false,
                          .clutch_button = 0,
                          .hold_to_run = true,
                          .hold_button = 8};  // the first of a second device

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
