// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <QApplication>
#include <QLocale>
#include <QSettings>
#include <QTemporaryDir>

#include "ui/props/viewport.h"
#include "ui/style/style.h"

int main(int argc, char** argv) {
  // in English, with its numbers, wherever the tests run
  qputenv("LC_ALL", "C.UTF-8");
  qunsetenv("LANGUAGE");
  ui::Viewport::prepareApplication();
  QApplication application(argc, argv);
  QLocale english = QLocale::c();
  english.setNumberOptions(QLocale::DefaultNumberOptions);  // with commas between thousands
  QLocale::setDefault(english);
  ui::style::applyTheme(application, ui::style::Theme::Dark);
  // preferences of nobody
  const QTemporaryDir home;
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, home.path());
  QCoreApplication::setOrganizationName("Palpate");
  QCoreApplication::setApplicationName("Palpate");
  ::testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
