// SPDX-License-Identifier: BSD-3-Clause
#include "ui/language.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>
#include <algorithm>
#include <clocale>

// of a static library, whose resources nobody else asks for
static void initTranslations() { Q_INIT_RESOURCE(translations); }

namespace ui {
namespace {

bool isSpoken(const QString& code) {
  return std::ranges::any_of(
      kLanguages, [&](const Language& language) { return code == QLatin1String(language.code); });
}

void install(const QString& name, const QString& folder) {
  auto* translator = new QTranslator(QCoreApplication::instance());
  if (translator->load(name, folder))
    QCoreApplication::installTranslator(translator);
  else
    delete translator;
}

}  // namespace

QString systemLanguage() {
  for (const QString& preferred : QLocale::system().uiLanguages()) {
    const QString code = preferred.section('-', 0, 0);
    if (isSpoken(code)) return code;
  }
  return QStringLiteral("en");
}

void speak(const QString& code) {
  initTranslations();
  const bool chosen = isSpoken(code);
  const QString language = chosen ? code : systemLanguage();
  QLocale locale = QLocale::system();
  if (chosen && locale.language() != QLocale(language).language()) locale = QLocale(language);
  locale.setNumberOptions(QLocale::OmitGroupSeparator);
  QLocale::setDefault(locale);
  // Qt has set it from the environment, where it changes what readers take for a number
  std::setlocale(LC_NUMERIC, "C");
  if (language == QLatin1String("en")) return;
  install("qtbase_" + language, QLibraryInfo::path(QLibraryInfo::TranslationsPath));
  install("palpate_" + language, QStringLiteral(":/translations"));
}

}  // namespace ui
