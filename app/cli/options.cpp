// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/options.h"

#include <cmath>

namespace app::cli {

CLI::Validator finiteNumber() {
  return {[](std::string& text) {
            const auto value = numberIn<double>(text);
            return value && std::isfinite(*value) ? std::string{}
                                                  : "\"" + text + "\" is not a number";
          },
          "NUMBER"};
}

CLI::Validator wholeNumber(std::uint64_t least, std::uint64_t greatest) {
  return {[least, greatest](std::string& text) {
            const auto value = numberIn<std::uint64_t>(text);
            // 010 is ten to some and eight to others
            if (!value || std::to_string(*value) != text || *value < least || *value > greatest)
              return "\"" + text + "\" is not a whole number of " + std::to_string(least) + " to " +
                     std::to_string(greatest);
            return std::string{};
          },
          "COUNT"};
}

CLI::Validator notEmpty() {
  return {[](std::string& text) { return text.empty() ? std::string{"is empty"} : std::string{}; },
          "TEXT"};
}

std::optional<double> energyIn(const std::string& text) {
  const auto energy = numberIn<double>(text);
  if (!energy || !(*energy >= 1e-3 && *energy <= 1e3)) return {};
  return *energy * 1e9;
}

}  // namespace app::cli
