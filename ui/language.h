// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QString>

namespace ui {

/// A language that the window speaks.
struct Language {
  const char* code;      ///< of ISO 639
  const char* own_name;  ///< in itself
};

/// English is in the sources; each other has resources/translations/palpate_CODE.ts.
inline constexpr Language kLanguages[] = {{"en", "English"}, {"de", "Deutsch"}};

/// The first of kLanguages among those that the user's system prefers; English if none is.
QString systemLanguage();

/// Gives the application's window a language, by its code; empty, or none of kLanguages: the
/// system's. Numbers and dates are then as the system has them, or as that language has them where
/// it is not the system's; digits are not grouped, since a group's mark can be taken for a decimal
/// one. The C library's numbers stay English, for files. Called once, after the QApplication and
/// before the first widget.
void speak(const QString& code);

}  // namespace ui
