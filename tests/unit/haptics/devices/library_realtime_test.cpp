// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "haptics/core/clock.h"
#include "haptics/devices/force_dimension.h"
#include "haptics/devices/open_haptics.h"
#include "tests/support/no_allocation.h"
#include "tests/support/sentence.h"
#include "tests/unit/haptics/devices/stub_dhd.h"
#include "tests/unit/haptics/devices/stub_hd.h"
#include "tests/unit/haptics/devices/stub_library.h"

namespace {

/// What the servo thread's four calls do that they must not, after a wait for a reading, too.
support::Calls forbidden(haptics::Device& device) {
  haptics::DeviceReading reading;
  if (device.inStep()) device.awaitReading(haptics::monotonicNs() + 1'000'000'000);
  const support::NoAllocation guard;
  for (int n = 0; n < 20; ++n) {
    device.read(reading);
    device.write({.force = {1.0, 2.0, 3.0}});
    if (n % 10 == 0) device.stop();
    if (n % 10 == 5) device.resume();
  }
  return guard.calls();
}

TEST(DriversOverLibraries, NeitherAllocateNorWaitOnTheServoThread) {
  auto& dhd = stubs::control<StubDhd>(stubs::dhd(), "stubDhd");
  for (std::size_t n = 0; n < 9; n += 4) dhd.R_FD[n] = 1.0;
  auto& hd = stubs::control<StubHd>(stubs::hd(), "stubHd");
  for (std::size_t n = 0; n < 16; n += 5) hd.transform[n] = 1.0;
  const std::vector<std::string> dhd_names{stubs::dhd()}, hd_names{stubs::hd()};
  const auto force_dimension = haptics::openForceDimension({.id = "force-dimension"}, dhd_names);
  const auto open_haptics = haptics::openOpenHaptics({.id = "openhaptics"}, hd_names);
  for (const auto* device : {&force_dimension, &open_haptics}) {
    ASSERT_TRUE(*device) << sentence(device->error());
    haptics::DeviceReading reading;
    ASSERT_TRUE(
        stubs::comes([&] { return (**device)->read(reading) == haptics::DeviceStatus::Ok; }));
    for (int times = 0; times < 50; ++times) {
      const support::Calls calls = forbidden(***device);
      ASSERT_EQ(calls.all(), 0) << calls.first;
    }
  }
}

}  // namespace
