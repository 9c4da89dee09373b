// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "haptics/devices/catalogue.h"

namespace app {

/// The functions that find and open devices. DeviceWatch calls them on its thread, one call at a
/// time.
struct DeviceCatalogue {
  std::function<std::vector<haptics::DeviceEntry>()> survey;
  std::function<haptics::Expected<std::unique_ptr<haptics::Device>>(const haptics::OpenRequest&)>
      open;
  /// Joins a device that senses translation and one that senses rotation.
  std::function<std::unique_ptr<haptics::Device>(std::unique_ptr<haptics::Device> moved,
                                                 std::unique_ptr<haptics::Device> turning)>
      join;
};

/// All built-in drivers; may be empty.
DeviceCatalogue builtInCatalogue();

}  // namespace app
