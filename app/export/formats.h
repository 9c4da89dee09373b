// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "app/export/export.h"

namespace app::exporting {

/// A format that a recording is exported to. Command line and window read the table of these.
struct Format {
  const char* name;    ///< of `palpate-cli export --format`
  const char* ending;  ///< of the file; "": the files' names begin with what the user gives
  // In the window, translated in the context "app::exporting".
  const char* title;   ///< in the list of formats
  const char* about;   ///< a sentence about it
  const char* filter;  ///< what the file dialog says is chosen
  haptics::Expected<Exported> (*write)(haptics::Recording& recording,
                                       const std::filesystem::path& out,
                                       const ExportOptions& options);
  /// Where `ending` is empty: how the files' names end, the largest file first.
  std::span<const char* const> files = {};
};

/// To add one, add its row.
std::span<const Format> formats();

}  // namespace app::exporting
