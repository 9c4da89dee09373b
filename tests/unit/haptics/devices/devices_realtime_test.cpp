// SPDX-License-Identifier: BSD-3-Clause
// What the servo thread calls of the drivers that have no thread of their own allocates nothing and
// waits for nothing.
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <string>

#include "haptics/devices/space_mouse.h"
#include "haptics/devices/spacenav_socket.h"
#include "tests/support/no_allocation.h"

namespace {

using haptics::DeviceReading;
using haptics::DeviceStatus;
using haptics::Wrench;

/// A cap that is always out, and gone after so many reads.
class Held final : public haptics::HidPort {
 public:
  std::optional<std::size_t> read(std::span<std::uint8_t> report,
                                  std::chrono::milliseconds) noexcept override {
    constexpr std::array<std::uint8_t, 13> kOut{1, 94, 1, 0, 0, 0, 0, 50, 0, 0, 0, 0, 0};
    if (++reads_ > 40'000) return std::nullopt;
    std::copy(kOut.begin(), kOut.end(), report.begin());
    return kOut.size();
  }
  bool write(std::span<const std::uint8_t>) noexcept override { return true; }

 private:
  long reads_ = 0;
};

/// What reading until it is lost, and a thousand times beyond, calls.
support::Calls callsOf(haptics::Device& device, DeviceStatus& last) {
  DeviceReading reading;
  const support::NoAllocation guard;
  for (int i = 0; i < 5'000; ++i) {
    last = device.read(reading);
    device.write(Wrench{});
    device.stop();
    device.resume();
  }
  return guard.calls();
}

TEST(DevicesRealTime, ASpaceMouseIsReadWithoutAllocationOrWait) {
  std::vector<std::unique_ptr<haptics::HidPort>> ports;
  ports.push_back(std::make_unique<Held>());
  const auto device = haptics::spaceMouseAt(std::move(ports));
  DeviceStatus last = DeviceStatus::Ok;
  const support::Calls calls = callsOf(*device, last);
  EXPECT_EQ(calls.all(), 0) << calls.first;
  EXPECT_EQ(last, DeviceStatus::Lost);
}

TEST(DevicesRealTime, SpacenavdIsReadWithoutAllocationOrWait) {
  const std::string place = (std::filesystem::temp_directory_path() /
                             ("palpate-spnav-realtime-" + std::to_string(::getpid())))
                                .string();
  const int listening = ::socket(AF_UNIX, SOCK_STREAM, 0);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::strncpy(address.sun_path, place.c_str(), sizeof(address.sun_path) - 1);
  ASSERT_EQ(::bind(listening, reinterpret_cast<sockaddr*>(&address), sizeof(address)), 0);
  ASSERT_EQ(::listen(listening, 1), 0);
  auto device = haptics::spacenavAt(place);
  ASSERT_TRUE(device);
  const int client = ::accept(listening, nullptr, nullptr);
  const haptics::SpacenavEvent out{0, 350, 0, 0, 0, 50, 0, 8};
  for (int i = 0; i < 100; ++i)
    ASSERT_EQ(::send(client, out.data(), sizeof(out), MSG_NOSIGNAL | MSG_DONTWAIT),
              static_cast<ssize_t>(sizeof(out)));
  ::close(client);
  ::close(listening);
  std::filesystem::remove(place);
  DeviceStatus last = DeviceStatus::Ok;
  const support::Calls calls = callsOf(**device, last);
  EXPECT_EQ(calls.all(), 0) << calls.first;
  EXPECT_EQ(last, DeviceStatus::Lost);
}

}  // namespace
