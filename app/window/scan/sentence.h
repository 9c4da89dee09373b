// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QCoreApplication>
#include <QLocale>
#include <QString>

#include "resources/messages/messages.h"

namespace app {

/// The language of the window, for the rows of resources/messages. Any thread.
inline resources::Wording windowsLanguage() {
  return {.row =
              [](std::string_view english) {
                return QCoreApplication::translate("Messages", std::string{english}.c_str())
                    .toStdString();
              },
          .decimal_mark = QLocale().decimalPoint().toStdString()};
}

/// What a user reads of an error, or of a sentence of the libraries.
inline QString sentenceOf(const haptics::Message& message) {
  return QString::fromStdString(resources::sentence(message, windowsLanguage()));
}
inline QString sentenceOf(const haptics::Error& error) { return sentenceOf(error.message); }

}  // namespace app
