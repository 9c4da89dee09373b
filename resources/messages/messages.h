// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "haptics/core/error.h"
#include "resources/messages/row.h"

namespace resources {

/// All sentences, table by table in the order of the source.
std::span<const Row> rows();

/// Another language.
struct Wording {
  /// A row in it, with the same places of arguments. None: English.
  std::function<std::string(std::string_view english)> row = {};
  std::string decimal_mark = ".";
};

/// The message in words. A row that is not there gives its id and its arguments.
std::string sentence(const haptics::Message& message, const Wording& wording = {});
std::string sentence(const haptics::Error& error, const Wording& wording = {});

/// The row whose words stand in `words`, which may have more around them; of several the one of
/// which most stands there. Null if there is none. `wording`: as they were worded.
const Row* rowIn(std::string_view words, const Wording& wording = {});

}  // namespace resources
