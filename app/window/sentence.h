// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QCoreApplication>
#include <QString>

#include "resources/messages/messages.h"

namespace app {

/// A row of resources/messages in the language of the window. Any thread.
inline std::string inWindowsLanguage(std::string_view english) {
  return QCoreApplication::translate("Messages", std::string{english}.c_str()).toStdString();
}

/// What a user reads of an error, or of a sentence of the libraries.
inline QString sentenceOf(const haptics::Message& message) {
  return QString::fromStdString(resources::sentence(message, inWindowsLanguage));
}
inline QString sentenceOf(const haptics::Error& error) { return sentenceOf(error.message); }

}  // namespace app
