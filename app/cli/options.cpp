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

std::optional<study::Shard> shardOf(const std::string& text) {
  study::Shard shard;
  const char* end = text.data() + text.size();
  const auto [slash, first] = std::from_chars(text.data(), end, shard.index);
  if (first != std::errc{} || slash == end || *slash != '/') return {};
  const auto [stop, second] = std::from_chars(slash + 1, end, shard.count);
  if (second != std::errc{} || stop != end) return {};
  if (shard.count < 1 || shard.count > 10'000 || shard.index < 1 || shard.index > shard.count)
    return {};
  return shard;
}

}  // namespace app::cli
