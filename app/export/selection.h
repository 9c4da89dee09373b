// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "app/export/export.h"

namespace app::exporting {

/// Times in ns since the recording began, both ends included.
struct Window {
  std::int64_t from, to;
};
Window windowOf(const ExportOptions& options);

/// Calls `each` with every step that the options choose, in order, until it returns false. Their
/// Step::removed is what all cuts from `from` to it removed. Refuses
/// a recording without such a step, and one whose time goes backwards.
haptics::Expected<void> forEachChosen(Recording& recording, const ExportOptions& options,
                                      const std::function<bool(const RecordedStep&)>& each);

/// The events between `from` and `to`, in order of time.
std::span<const RecordedEvent> eventsChosen(const Recording& recording,
                                            const ExportOptions& options);

}  // namespace app::exporting
