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

/// The modality that a file states if it is a word of the standard, such as "CT"; else nothing,
/// since it might be anything, a name too. Source: DICOM PS3.3, C.7.3.1.1.1, retired words
/// included.
std::string modalityFrom(std::string_view stated);

std::string lowered(std::string_view text);
std::string_view trimmed(std::string_view text);
std::vector<std::string_view> wordsOf(std::string_view text);
/// The whole word as a number, whatever the locale: "2", "+2" or "-2", and for numberOf() also
/// "1.5", ".5", "1e-3", "nan" and "inf". Empty if it is anything else, such as "1,5" or "1.5mm".
std::optional<std::int64_t> integerOf(std::string_view word);
std::optional<double> numberOf(std::string_view word);

/// The refusal ("bad-header") of a header that has something else where this field needs numbers,
/// or more or fewer of them than it needs.
tl::unexpected<haptics::Error> noNumbers(const std::filesystem::path& header, const char* field);
/// The refusal of a header in which this field has a value that makes no sense.
tl::unexpected<haptics::Error> wrongField(const std::filesystem::path& header,
                                          const std::string& field);
/// The refusal of a header that lacks this field.
tl::unexpected<haptics::Error> missingField(const std::filesystem::path& header, const char* field);

}  // namespace datasets
