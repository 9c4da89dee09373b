// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "app/study/cohort/cohort.h"

namespace cohort {

/// Writes tables, dictionaries and pages of the results into `out`, whose pictures are there.
/// `before`: an earlier cohort's folder, or empty.
haptics::Expected<Summary> writeAll(const study::Results& results, const Manifest& manifest,
                                    const std::filesystem::path& out,
                                    const std::filesystem::path& before);

}  // namespace cohort
