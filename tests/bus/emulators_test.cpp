// SPDX-License-Identifier: BSD-3-Clause
// the emulators without a driver of ours: what plain libusb and hidapi find there
#include <gtest/gtest.h>
#include <hidapi/hidapi.h>
#include <libusb-1.0/libusb.h>

#include <array>
#include <cmath>
#include <memory>
#include <span>

#include "tests/bus/falcon_emulator.h"
#include "tests/bus/space_mice.h"

namespace {

using bus::Bytes;
using haptics::Vec3;

/// The Falcon's chip, by libusb alone.
struct RawFalcon {
  RawFalcon() {
    libusb_init(&context);
    handle = libusb_open_device_with_vid_pid(context, 0x0403, 0xCB48);
    claimed = handle != nullptr && libusb_claim_interface(handle, 0) == 0;
  }
  ~RawFalcon() {
    if (handle != nullptr) libusb_close(handle);
    libusb_exit(context);
  }
  int ask(int request, int value) {
    return libusb_control_transfer(handle, 0x40, std::uint8_t(request), std::uint16_t(value), 0,
                                   nullptr, 0, 1000);
  }
  bool send(Bytes bytes) {
    int moved = 0;
    return libusb_bulk_transfer(handle, 0x02, bytes.data(), int(bytes.size()), &moved, 1000) == 0 &&
           moved == int(bytes.size());
  }
  /// So many bytes without the status, from as many packets as it takes, or fewer.
  Bytes fetch(std::size_t wanted) {
    Bytes bytes;
    std::array<std::uint8_t, 64> packet{};
    for (int n = 0; n < 200 && bytes.size() < wanted; ++n) {
      int moved = 0;
      if (libusb_bulk_transfer(handle, 0x81, packet.data(), 64, &moved, 1000) != 0) break;
      if (moved > 2) bytes.insert(bytes.end(), packet.begin() + 2, packet.begin() + moved);
    }
    return bytes;
  }
  libusb_context* context = nullptr;
  libusb_device_handle* handle = nullptr;
  bool claimed = false;
};

Bytes text(const std::string& letters) { return {letters.begin(), letters.end()}; }

TEST(Emulators, AFalconBootsEchoesItsFirmwareAndAnswersEachCommand) {
  bus::FalconEmulator falcon{false};
  const bus::UsbPort port{0, falcon};
  RawFalcon chip;
  ASSERT_TRUE(chip.claimed);
  ASSERT_GE(chip.ask(3, 0x4138), 0);
  chip.ask(1, 0x0100);
  chip.ask(1, 0x0101);
  ASSERT_TRUE(chip.send({0x0A, 0x43, 0x0D}));
  EXPECT_EQ(chip.fetch(4), (Bytes{0x0A, 0x44, 0x2C, 0x0D}));
  chip.ask(3, 0x15);
  ASSERT_TRUE(chip.send({0x41}));
  EXPECT_EQ(chip.fetch(1), Bytes{0x41});
  const Bytes chunk(62, 0x5A);
  ASSERT_TRUE(chip.send(chunk));
  EXPECT_EQ(chip.fetch(62), chunk);
  chip.ask(9, 1);
  chip.ask(3, 2);
  ASSERT_TRUE(chip.send(text("<EDCBAAAAPPPPBA>")));  // 0x1234, 0, -1; homing
  const Bytes reply = chip.fetch(16);
  ASSERT_EQ(reply.size(), 16u);
  EXPECT_EQ(reply.front(), '<');
  EXPECT_EQ(reply.back(), '>');
  const bus::FalconEmulator::Seen seen = falcon.seen();
  EXPECT_EQ(seen.commands, 1u);
  EXPECT_EQ(seen.malformed, 0u);
  EXPECT_EQ(seen.motors, (std::array{0x1234, 0, -1}));
  EXPECT_EQ(seen.control, 1);
  EXPECT_EQ(seen.forced_early, 1u);
  EXPECT_EQ(seen.firmware, chunk);
  // a thousand commands, a thousand answers
  for (int n = 0; n < 1000; ++n) {
    ASSERT_TRUE(chip.send(text("<AAAAAAAAAAAAAA>")));
    ASSERT_EQ(chip.fetch(16).size(), 16u) << n;
  }
  EXPECT_EQ(falcon.seen().commands, 1001u);
}

TEST(Emulators, ForcesAlongAnAxisOfSymmetryAreWhatTheLegsShareEqually) {
  // three equal torques push along z, and by symmetry nowhere else
  const Vec3 force = bus::FalconEmulator::forceOf({-1000, -1000, -1000}, {0, 0, 0.125});
  EXPECT_LT(force.head<2>().norm(), 1e-6 * std::abs(force.z()));
  // 0.1 N·m a leg on arms of 60 mm: some newtons in all, of the order of 3 · 0.1 / 0.06
  EXPECT_GT(std::abs(force.z()), 1.0);
  EXPECT_LT(std::abs(force.z()), 10.0);
}

struct Close {
  void operator()(hid_device* device) const { hid_close(device); }
};

TEST(Emulators, SpaceMiceReportAndShineThroughPlainHidapi) {
  bus::SpaceNavigatorEmulator navigator;
  const bus::UsbPort port{1, navigator};
  bus::UhidSpaceMouse compact;
  ASSERT_EQ(hid_init(), 0);
  {
    const std::unique_ptr<hid_device, Close> open{hid_open(0x046D, 0xC626, nullptr)};
    ASSERT_NE(open, nullptr);
    navigator.move({1, -2, 3, 0, 0, 350});
    Bytes report(16);
    ASSERT_EQ(hid_read_timeout(open.get(), report.data(), report.size(), 5000), 7);
    EXPECT_EQ(report[0], 1);
    EXPECT_EQ(report[3], 0xFE);  // -2
    ASSERT_EQ(hid_read_timeout(open.get(), report.data(), report.size(), 5000), 7);
    EXPECT_EQ(report[0], 2);
    const Bytes light{4, 1};
    EXPECT_GT(hid_write(open.get(), light.data(), light.size()), 0);
    EXPECT_EQ(navigator.lit(), 1);
  }
  {
    const std::unique_ptr<hid_device, Close> open{hid_open(0x256F, 0xC635, nullptr)};
    ASSERT_NE(open, nullptr);
    compact.move({0, 0, 0, 5, 0, 0});
    Bytes report(16);
    ASSERT_EQ(hid_read_timeout(open.get(), report.data(), report.size(), 5000), 7);
    ASSERT_EQ(hid_read_timeout(open.get(), report.data(), report.size(), 5000), 7);
    EXPECT_EQ(report[1], 5);
  }
  hid_exit();
}

}  // namespace
