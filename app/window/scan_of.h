// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "haptics/core/volume.h"
#include "haptics/edit/edited.h"

namespace app {

/// The scan of which a volume is an edited view; the volume itself without edits.
inline std::shared_ptr<const haptics::Volume> scanOf(
    const std::shared_ptr<const haptics::Volume>& volume) {
  return volume && volume->edited ? volume->edited->scan : volume;
}

}  // namespace app
