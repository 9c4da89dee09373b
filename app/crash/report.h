// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace app::crash {

/// Makes one report of the raw files that processes which are no more left in this folder, removes
/// them, and keeps the report there in place of an older one. Nullopt if there was no crash, or if
/// cancelled; the raw files then stay. The report has version and build, system, signal, functions
/// with their modules, and the last 50 lines of the log of that process; no path. It looks for
/// symbols on this machine only. Where an earlier call ended the process, functions have no names,
/// so that it does not do so at every start. Takes up to seconds, on any thread but the servo's.
std::optional<std::string> takeReport(const std::filesystem::path& folder,
                                      const std::atomic<bool>& cancel);

/// Where takeReport() keeps the report.
std::filesystem::path reportFile(const std::filesystem::path& folder);

/// Whether the names of functions are looked for.
enum class Names { Sought, LeftOut };

/// The report of the text of a raw file, with lines of the log in this folder; nullopt if it tells
/// of no crash, a part of it if cancelled. Whatever the text is, lines that cannot be read are left
/// out.
std::optional<std::string> reportOf(std::string_view raw_text, const std::filesystem::path& folder,
                                    Names names, const std::atomic<bool>& cancel);

}  // namespace app::crash
