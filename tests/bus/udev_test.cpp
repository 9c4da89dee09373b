// SPDX-License-Identifier: BSD-3-Clause
// Udev's own word on devices that a real kernel shows, under packaging/70-palpate.rules and all
// rules of Debian.
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <string>

#include "tests/bus/falcon_emulator.h"
#include "tests/bus/felt_sphere.h"
#include "tests/bus/space_mice.h"

namespace {

using bus::comesTrue;

/// Where mkinit.sh puts it, if there is one to put there.
constexpr const char* kUdev = "/bin/udevadm";

/// What udev says that it does when this node of /dev comes.
std::string saidOf(const std::string& node) {
  struct stat about {};
  if (stat(node.c_str(), &about) != 0) return "there is no " + node;
  // it remembers tags of an earlier device with this number
  std::filesystem::remove_all("/run/udev");
  const std::string place = "/sys/dev/char/" + std::to_string(major(about.st_rdev)) + ':' +
                            std::to_string(minor(about.st_rdev));
  FILE* const words =
      popen((std::string{kUdev} + " test --action=add " + place + " 2>&1").c_str(), "r");
  if (words == nullptr) return "udevadm does not start";
  std::string said;
  std::array<char, 4096> part{};
  for (std::size_t n = 0; (n = fread(part.data(), 1, part.size(), words)) > 0;)
    said.append(part.data(), n);
  if (pclose(words) != 0) said += "\nudevadm failed";
  return said;
}

/// To whoever sits at the machine.
bool isGiven(const std::string& said) { return said.find("run: 'uaccess'") != std::string::npos; }

class Udev : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(kUdev)) GTEST_SKIP() << "packaging/test fetched no udev.";
  }
};

TEST_F(Udev, GivesAFalconToWhoeverSitsThere) {
  bus::FalconEmulator falcon{true};
  const bus::UsbPort port{0, falcon};
  ASSERT_TRUE(comesTrue([&] { return !port.node().empty(); }));
  const std::string said = saidOf(port.node());
  EXPECT_TRUE(isGiven(said)) << said;
  EXPECT_EQ(said.find("failed"), std::string::npos) << said;
  EXPECT_EQ(said.find("70-palpate.rules:"), std::string::npos) << said;  // a complaint
}

TEST_F(Udev, GivesASpaceMouseButNotTheUsbDeviceThatItIs) {
  bus::SpaceNavigatorEmulator mouse;
  const bus::UsbPort port{1, mouse};
  ASSERT_TRUE(comesTrue([] { return !bus::hidNode(0x046D, 0xC626).empty(); }));
  const std::string said = saidOf(bus::hidNode(0x046D, 0xC626));
  EXPECT_TRUE(isGiven(said)) << said;
  const std::string whole = saidOf(port.node());
  EXPECT_FALSE(isGiven(whole)) << whole;
}

TEST_F(Udev, GivesNoOtherDevice) {
  // no device of USB has made this node, so its ids are not to be trusted
  const bus::UhidSpaceMouse mouse;
  const std::string said = saidOf(mouse.node());
  EXPECT_NE(said.find("hidraw"), std::string::npos) << said;
  EXPECT_FALSE(isGiven(said)) << said;
}

}  // namespace
