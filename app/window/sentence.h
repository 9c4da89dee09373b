// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QString>

#include "resources/messages/messages.h"

namespace app {

/// What a user reads of an error, or of a sentence of the libraries.
inline QString sentenceOf(const haptics::Message& message) {
  return QString::fromStdString(resources::sentence(message));
}
inline QString sentenceOf(const haptics::Error& error) { return sentenceOf(error.message); }

}  // namespace app
