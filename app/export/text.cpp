// SPDX-License-Identifier: BSD-3-Clause
#include "app/export/text.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace app::exporting {

const StepColumn& columnNamed(std::string_view name) {
  return *std::ranges::find_if(stepColumns(),
                               [&](const auto& column) { return column.name == name; });
}

std::string plain(std::string text) {
  using nlohmann::json;
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = ' ';
  return json::parse(json(text).dump(-1, ' ', false, json::error_handler_t::replace))
      .get<std::string>();
}

}  // namespace app::exporting
