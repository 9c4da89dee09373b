// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "app/fetch/archive.h"

namespace app::fetch {

/// What comes on standard input, since a command line can be read by every user of the machine.
struct Input {
  Query query;
  std::optional<std::size_t> index;
  std::string check;  ///< of the series that the index named, or empty
  std::string user, password, token, key_passphrase;
};

/// Reads one JSON object, from a stream that may stay open behind it. Refuses fields that are
/// unknown, and values that no search has.
haptics::Expected<Input> readInput(int descriptor);
haptics::Expected<Input> inputFrom(const std::string& text);

}  // namespace app::fetch
