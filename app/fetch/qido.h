// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "app/fetch/archive.h"

namespace app::fetch {

inline constexpr std::size_t kMostJson = std::size_t{16} << 20;  ///< bytes of one answer

/// The entries of a QIDO-RS answer (application/dicom+json) as series. Fields that it lacks stay
/// empty: of a study there is no series_uid. An entry whose identifier at `level` is not well
/// formed is counted and left out.
enum class Level { Study, Series };
haptics::Expected<Findings> findingsFrom(std::string_view json, Level level);

/// The SOP instance UIDs of an answer about images; those that are not well formed are left out.
haptics::Expected<std::vector<std::string>> imagesFrom(std::string_view json);

}  // namespace app::fetch
