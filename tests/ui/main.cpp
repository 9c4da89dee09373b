// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <QApplication>
#include <QLocale>
#include <QSettings>
#include <QTemporaryDir>

#include "ui/controls/language.h"
#include "ui/props/viewport.h"
#include "ui/style/style.h"

namespace {

/// Each test begins in English, with commas between thousands, wherever it runs and whatever was
/// spoken in the one before.
class English : public testing::EmptyTestEventListener {
  void OnTestStart(const testing::TestInfo&) override {
    ui::setLanguage("en");
    QLocale english = QLocale::c();
    english.setNumberOptions(QLocale::DefaultNumberOptions);
    QLocale::setDefault(english);
  }
};

}  // namespace

int main(int argc, char** argv) {
  qputenv("LC_ALL", "C.UTF-8");
  qunsetenv("LANGUAGE");
  ui::Viewport::prepareApplication();
  QApplication application(argc, argv);
  ui::style::applyTheme(application, ui::style::Theme::Dark);
  // preferences of nobody
  const QTemporaryDir home;
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, home.path());
  QCoreApplication::setOrganizationName("Palpate");
  QCoreApplication::setApplicationName("Palpate");
  testing::InitGoogleTest(&argc, argv);
  testing::UnitTest::GetInstance()->listeners().Append(new English);
  return RUN_ALL_TESTS();
}
