// SPDX-License-Identifier: BSD-3-Clause
#include "ui/controls/language.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>
#include <algorithm>
#include <clocale>
#include <memory>
#include <vector>

// of a static library, whose resources nobody else asks for
static void initTranslations() { Q_INIT_RESOURCE(translations); }

namespace ui {
namespace {

QString spoken_language = QStringLiteral("en");

bool isSpoken(const QString& code) {
  return std::ranges::any_of(
      kLanguages, [&](const Language& language) { return code == QLatin1String(language.code); });
}

/// The translators in use; one that is gone is asked no more.
void install(std::vector<std::unique_ptr<QTranslator>>& spoken, const QString& name,
             const QString& folder) {
  auto translator = std::make_unique<QTranslator>();
  if (!translator->load(name, folder)) return;
  QCoreApplication::installTranslator(translator.get());
  spoken.push_back(std::move(translator));
}

}  // namespace

QString languageFor(const QString& chosen, const QStringList& system_prefers) {
  if (isSpoken(chosen)) return chosen;
  for (const QString& preferred : system_prefers)
    if (const QString code = preferred.section('-', 0, 0); isSpoken(code)) return code;
  return QStringLiteral("en");
}

void setLanguage(const QString& code) {
  initTranslations();
  QLocale locale = QLocale::system();
  const QString wanted = languageFor(code, locale.uiLanguages());
  if (isSpoken(code) && locale.language() != QLocale(wanted).language()) locale = QLocale(wanted);
  locale.setNumberOptions(QLocale::OmitGroupSeparator);
  QLocale::setDefault(locale);
  // Qt has set it from the environment, where it changes what readers take for a number
  std::setlocale(LC_NUMERIC, "C");
  static std::vector<std::unique_ptr<QTranslator>> spoken;
  spoken.clear();
  spoken_language = wanted;
  if (wanted == QLatin1String("en")) return;
  install(spoken, "qtbase_" + wanted, QLibraryInfo::path(QLibraryInfo::TranslationsPath));
  install(spoken, "palpate_" + wanted, QStringLiteral(":/translations"));
}

QString language() { return spoken_language; }

}  // namespace ui
