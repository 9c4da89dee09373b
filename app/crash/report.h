// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace app::crash {

/// Makes one report of the raw files that processes which are no more left in this folder, removes
/// them, and keeps the report there in place of an older one, readable by the user alone. Nullopt
/// if there was no crash. The report has version and build, system, signal, functions with their
/// modules, and the last 50 lines of the log of that process; no path. It looks for symbols on this
/// machine only. Takes up to seconds, on any thread but the servo's.
std::optional<std::string> takeReport(const std::filesystem::path& folder);

/// Where takeReport() keeps the report.
std::filesystem::path reportFile(const std::filesystem::path& folder);

/// The report of the text of a raw file, with these lines of the log; nullopt if it tells of no
/// crash. Whatever the text is, lines that cannot be read are left out.
std::optional<std::string> reportOf(std::string_view raw_text, const std::filesystem::path& folder);

}  // namespace app::crash
