// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/options.h"

#include <charconv>
#include <cmath>
#include <optional>

namespace app::cli {
namespace {

/// The number that a whole text is.
template <class T>
std::optional<T> numberIn(const std::string& text) {
  T value{};
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || stop != end) return {};
  return value;
}

}  // namespace

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

}  // namespace app::cli
