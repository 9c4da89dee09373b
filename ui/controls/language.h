// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QString>
#include <QStringList>

namespace ui {

/// A language that the window speaks.
struct Language {
  const char* code;      ///< of ISO 639
  const char* own_name;  ///< in itself
};

/// English is in the sources; each other has resources/translations/palpate_CODE.ts.
inline constexpr Language kLanguages[] = {{"en", "English"}, {"de", "Deutsch"}};

/// The code of the language to speak: the chosen one; else the first that the system prefers, of
/// "de-AT", "de" and so on; else English.
QString languageFor(const QString& chosen, const QStringList& system_prefers);

/// Gives the application's window a language, by its code; empty, or none of kLanguages: the
/// system's. Numbers and dates are then as the system has them, or as that language has them where
/// it is not the system's; digits are not grouped, since a group's mark can be taken for a decimal
/// one. The C library's numbers stay English, for files. Call it after the QApplication was made:
/// widgets that are there keep their words.
void setLanguage(const QString& code);
/// The code of the language that is set.
QString language();

}  // namespace ui
