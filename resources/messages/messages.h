// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "haptics/core/error.h"
#include "resources/messages/row.h"

namespace resources {

/// All sentences, table by table in the order of the source.
std::span<const Row> rows();

/// The message in words. A row that is not there gives its id and its arguments.
std::string sentence(const haptics::Message& message);
std::string sentence(const haptics::Error& error);

/// The id of the message whose words stand in `words`, which may have more around them; of several
/// the one of which most stands there. Empty if there is none.
std::string_view idOf(std::string_view words);

}  // namespace resources
