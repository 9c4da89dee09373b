// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "haptics/core/error.h"

namespace datasets {

inline constexpr std::int64_t kLongestHeader = 1 << 20;  ///< bytes of text, lists of files included

/// The modality that a file states if it is a code such as "CT", else nothing: never free text.
std::string modalityFrom(std::string_view stated);

std::string lowered(std::string_view text);
std::string_view trimmed(std::string_view text);
std::vector<std::string_view> wordsOf(std::string_view text);
/// The whole word as a number, whatever the locale; empty if it is anything else.
std::optional<std::int64_t> integerOf(std::string_view word);
std::optional<double> numberOf(std::string_view word);

}  // namespace datasets
