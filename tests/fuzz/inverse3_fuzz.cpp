// SPDX-License-Identifier: BSD-3-Clause
// Any bytes as a message of the Inverse3's service.
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string_view>

#include "haptics/devices/inverse3.h"
#include "tests/fuzz/require.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const auto message = haptics::readInverse3({reinterpret_cast<const char*>(bytes), size});
  if (!message) return 0;
  fuzz::require(message->devices.size() <= 16, "no more devices than a desk has");
  for (const haptics::Inverse3State& device : message->devices) {
    fuzz::require(device.p_BD.allFinite() && device.p_BD.norm() < 20.0, "a place on this desk");
    fuzz::require((device.trouble == haptics::Trouble::None) == device.why.empty(),
                  "a trouble has a sentence");
    // what the service calls a device is said back to it
    const auto command =
        nlohmann::json::parse(haptics::inverse3Command(device.id, device.p_BD), nullptr, false);
    fuzz::require(!command.is_discarded() && command["inverse3"][0]["device_id"] == device.id,
                  "an id is one word in a command");
  }
  if (message->R_BD) {
    fuzz::require(message->R_BD->isUnitary(1e-9) && message->R_BD->determinant() > 0.0,
                  "a rotation is one");
  }
  return 0;
}
