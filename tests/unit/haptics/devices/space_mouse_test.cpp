// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/devices/space_mouse.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>
#include <set>

#include "tests/support/sentence.h"
#include "tests/unit/haptics/devices/fake_port.h"

namespace {

using fake::Bytes;
using haptics::CapReport;
using haptics::CapState;
using haptics::DeviceReading;
using haptics::DeviceStatus;
using haptics::HidPlace;
using haptics::Pose;
using haptics::RateControl;
using haptics::Trouble;
using haptics::Vec3;

constexpr std::int64_t kMs = 1'000'000;
std::int64_t mouse_now = 0;
std::int64_t mouseClock() noexcept { return mouse_now; }

CapReport decode(const Bytes& bytes, CapState& cap) { return haptics::decodeCap(bytes, cap); }

/// An int16 in two bytes.
void append(Bytes& bytes, int value) {
  bytes.push_back(static_cast<std::uint8_t>(value & 0xff));
  bytes.push_back(static_cast<std::uint8_t>((value >> 8) & 0xff));
}

Bytes axes(std::uint8_t id, std::initializer_list<int> values) {
  Bytes bytes{id};
  for (const int value : values) append(bytes, value);
  return bytes;
}

TEST(CapReports, ACaptureOfACompactIsATurn) {
  CapState cap;
  EXPECT_EQ(decode({0x02, 0x20, 0x00, 0x00, 0x00, 0x17, 0x00}, cap), CapReport::Turn);
  EXPECT_EQ(cap.turn, (std::array<std::int16_t, 3>{32, 0, 23}));
  EXPECT_EQ(cap.shift, (std::array<std::int16_t, 3>{0, 0, 0}));
}

TEST(CapReports, WiredModelsReportShiftAndTurnApart) {
  CapState cap;
  EXPECT_EQ(decode(axes(1, {350, -350, 1}), cap), CapReport::Shift);
  EXPECT_EQ(decode(axes(2, {-1, 256, -257}), cap), CapReport::Turn);
  EXPECT_EQ(cap.shift, (std::array<std::int16_t, 3>{350, -350, 1}));
  EXPECT_EQ(cap.turn, (std::array<std::int16_t, 3>{-1, 256, -257}));
}

TEST(CapReports, WirelessModelsReportAllSixAtOnce) {
  CapState cap;
  EXPECT_EQ(decode(axes(1, {1, -2, 3, -4, 5, -6}), cap), CapReport::Both);
  EXPECT_EQ(cap.shift, (std::array<std::int16_t, 3>{1, -2, 3}));
  EXPECT_EQ(cap.turn, (std::array<std::int16_t, 3>{-4, 5, -6}));
}

TEST(CapReports, ButtonsOfOneToFourBytes) {
  CapState cap;
  EXPECT_EQ(decode({3, 0x02}, cap), CapReport::Buttons);
  EXPECT_EQ(cap.buttons, 0x2u);
  decode({3, 0x01, 0x80}, cap);
  EXPECT_EQ(cap.buttons, 0x8001u);
  decode({3, 0x00, 0x00, 0x40}, cap);
  EXPECT_EQ(cap.buttons, 0x400000u);
  decode({3, 0x01, 0x10, 0xc0, 0x07}, cap);  // a Pro: menu, 1, Esc, Alt, Shift, Ctrl, lock
  EXPECT_EQ(cap.buttons, 0x07c01001u);
  decode({3, 0x00, 0x00, 0x00, 0x00, 0xff, 0xff}, cap);  // what is behind is nobody's
  EXPECT_EQ(cap.buttons, 0u);
}

TEST(CapReports, WhatIsNoReportOfACapChangesNothing) {
  CapState cap;
  decode(axes(1, {10, 20, 30, 40, 50, 60}), cap);
  decode({3, 5}, cap);
  const CapState before = cap;
  std::vector<Bytes> strange{{}, {1}, {2}, {3}};
  for (std::size_t length = 2; length < 7; ++length)
    for (const std::uint8_t id : {1, 2}) strange.emplace_back(length, id);
  for (std::size_t length = 17; length < 70; ++length)
    for (const std::uint8_t id : {1, 2, 3}) strange.emplace_back(length, id);
  for (int id = 0; id < 256; ++id)
    if (id < 1 || id > 3)
      for (const std::size_t length : {2u, 7u, 13u})
        strange.emplace_back(length, static_cast<std::uint8_t>(id));
  strange.push_back(axes(1, {1001, 0, 0}));
  strange.push_back(axes(2, {0, -32768, 0}));
  strange.push_back(axes(1, {1, 2, 3, 4, 5, -1001}));
  for (const Bytes& bytes : strange) {
    EXPECT_EQ(decode(bytes, cap), CapReport::Unknown) << bytes.size();
    EXPECT_EQ(cap.shift, before.shift);
    EXPECT_EQ(cap.turn, before.turn);
    EXPECT_EQ(cap.buttons, before.buttons);
  }
}

TEST(CapReports, NoiseOf64BytesIsNone) {
  std::mt19937 random{11};
  CapState cap;
  for (int trial = 0; trial < 100'000; ++trial) {
    Bytes bytes(64);
    for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random());
    bytes[0] = static_cast<std::uint8_t>(1 + trial % 3);
    ASSERT_EQ(decode(bytes, cap), CapReport::Unknown);
  }
}

TEST(CapAxes, AreRightUpAndTowardsTheUser) {
  EXPECT_EQ(haptics::capInBase({7, 0, 0}), Vec3(7, 0, 0));   // pushed right
  EXPECT_EQ(haptics::capInBase({0, 7, 0}), Vec3(0, 0, 7));   // pulled towards the user
  EXPECT_EQ(haptics::capInBase({0, 0, 7}), Vec3(0, -7, 0));  // pushed down
}

/// How far a deflection takes the pose in a tenth of a second.
Vec3 shiftOf(const Vec3& counts) {
  RateControl control;
  control.step(0);
  control.shift(counts, 0);
  for (int ms = 1; ms <= 100; ++ms) control.step(ms * kMs);
  return control.step(100 * kMs).translation();
}

TEST(RateControlOfACap, RestsWithinTheDeadBandAndLeavesItWithoutAJump) {
  std::mt19937 random{5};
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 200; ++trial) {
    const Vec3 direction = Vec3{normal(random), normal(random), normal(random)}.normalized();
    EXPECT_EQ(shiftOf(direction * 24.999), Vec3::Zero());
    double last = 0.0;
    for (double size = 25.0; size <= 350.0; size += 1.0) {
      const Vec3 moved = shiftOf(direction * size);
      ASSERT_GE(moved.norm(), last - 1e-15);
      ASSERT_LT(moved.norm() - last, 0.01 * 2.0 / 325.0 + 1e-12);  // the steepest of a square
      if (size > 25.5) {
        ASSERT_GT(moved.normalized().dot(direction), 1.0 - 1e-12);
      }
      last = moved.norm();
    }
    EXPECT_NEAR(last, 0.01, 1e-12);                               // 0.1 m/s
    EXPECT_NEAR(shiftOf(direction * 606.0).norm(), 0.01, 1e-12);  // and never more
  }
  // the slope begins at zero: a count beyond the band is a hundred-thousandth of the full speed
  EXPECT_NEAR(shiftOf({26.0, 0, 0}).x(), 0.01 / (325.0 * 325.0), 1e-12);
}

TEST(RateControlOfACap, IntegratesWhatIsHeld) {
  RateControl control;
  Pose X_BD = control.step(1'000 * kMs);
  for (int ms = 0; ms <= 1'000; ++ms) {
    if (ms % 8 == 0) {
      control.shift({0, 0, -350}, (1'000 + ms) * kMs);
      control.turn({0, 350, 0}, (1'000 + ms) * kMs);
    }
    X_BD = control.step((1'000 + ms) * kMs);
  }
  EXPECT_NEAR((X_BD.translation() - Vec3{0, 0, -0.1}).norm(), 0.0, 1e-12);
  const Eigen::AngleAxisd turned{X_BD.linear()};
  EXPECT_NEAR((turned.axis() * turned.angle() - Vec3{0, 1, 0}).norm(), 0.0, 1e-9);
}

TEST(RateControlOfACap, TurnsAboutTheAxesOfTheBase) {
  RateControl control;
  std::int64_t t = 0;
  control.step(t);
  const auto hold = [&](const Vec3& counts, double angle) {
    const int steps = static_cast<int>(std::lround(angle * 1'000));
    for (int i = 0; i < steps; ++i) {
      control.turn(counts, t);
      control.step(t += kMs);
    }
    control.turn(Vec3::Zero(), t);
  };
  hold({350, 0, 0}, 1.571);
  hold({0, 350, 0}, 1.571);
  using Eigen::AngleAxisd;
  const haptics::Mat3 expected =
      (AngleAxisd{1.571, Vec3::UnitY()} * AngleAxisd{1.571, Vec3::UnitX()}).toRotationMatrix();
  EXPECT_LT((control.step(t).linear() - expected).norm(), 1e-9);
}

TEST(RateControlOfACap, StaysARotationForAnHour) {
  RateControl control;
  std::int64_t t = 0;
  Pose X_BD = control.step(t);
  for (int i = 0; i < 3'600'000; ++i) {
    control.turn({300.0 * std::sin(1e-3 * i), 200, 100.0 * std::cos(7e-4 * i)}, t);
    X_BD = control.step(t += kMs);
  }
  EXPECT_LT((X_BD.linear() * X_BD.linear().transpose() - haptics::Mat3::Identity()).norm(), 1e-12);
}

TEST(RateControlOfACap, WhatIsSilentStopsAndWhatIsRepeatedDoesNot) {
  RateControl control;
  control.step(0);
  control.turn({350, 0, 0}, 0);
  Pose last = Pose::Identity();
  for (int ms = 0; ms <= 5'000; ++ms) {
    if (ms % 8 == 0) control.shift({350, 0, 0}, ms * kMs);
    last = control.step(ms * kMs);
  }
  EXPECT_NEAR(last.translation().x(), 0.5, 1e-9);
  EXPECT_NEAR(Eigen::AngleAxisd{last.linear()}.angle(), 0.2, 1e-9);
  // now nothing comes any more, for an hour
  for (int s = 0; s < 36'000; ++s) last = control.step((5'000 + s * 100) * kMs);
  EXPECT_LT(last.translation().x(), 0.5 + 0.1 * 0.2 + 1e-9);
  // and the next report counts again
  const std::int64_t later = 10'000'000 * kMs;
  control.step(later);
  control.shift({350, 0, 0}, later);
  EXPECT_NEAR(control.step(later + 10 * kMs).translation().x(), last.translation().x() + 1e-3,
              1e-12);
}

TEST(RateControlOfACap, AGapIsNotCaughtUpAndTheClockMayGoBack) {
  RateControl control;
  control.step(0);
  control.shift({350, 0, 0}, 30'000 * kMs);
  EXPECT_NEAR(control.step(30'000 * kMs).translation().x(), 0.1 * 0.020, 1e-12);
  EXPECT_NEAR(control.step(29'000 * kMs).translation().x(), 0.1 * 0.020, 1e-12);
  control.shift(Vec3::Constant(std::nan("")), 29'000 * kMs);
  EXPECT_TRUE(control.step(29'010 * kMs).matrix().allFinite());
  control.shift(Vec3::Constant(-2147483648.0), 29'010 * kMs);
  EXPECT_NEAR((control.step(29'020 * kMs).translation() - Vec3{0.002, 0, 0}).norm(), 1e-3, 1e-12);
}

struct Opened {
  std::vector<std::shared_ptr<fake::Hid>> hids;
  std::unique_ptr<haptics::Device> device;
};

Opened opened(std::size_t count = 1) {
  mouse_now = 0;
  Opened it;
  std::vector<std::unique_ptr<haptics::HidPort>> ports;
  for (std::size_t i = 0; i < count; ++i) {
    it.hids.push_back(std::make_shared<fake::Hid>());
    ports.push_back(std::make_unique<fake::Port>(it.hids.back()));
  }
  it.device = haptics::spaceMouseAt(std::move(ports), mouseClock);
  return it;
}

TEST(SpaceMouse, MovesAsItIsPushedAndShowsItsLight) {
  auto [hids, device] = opened();
  EXPECT_EQ(hids[0]->written, (std::vector<Bytes>{{4, 1}}));
  EXPECT_EQ(device->rating().sensed, 6);
  EXPECT_EQ(device->rating().actuated, 0);
  DeviceReading reading;
  for (int ms = 0; ms <= 1'000; ++ms) {
    mouse_now = ms * kMs;
    if (ms % 8 == 0) hids[0]->reports.push_back(axes(1, {0, 350, 0}));  // towards the user
    ASSERT_EQ(device->read(reading), DeviceStatus::Ok);
    EXPECT_EQ(reading.time_ns, mouse_now);
  }
  EXPECT_NEAR((reading.X_BD.translation() - Vec3{0, 0, 0.1}).norm(), 0.0, 1e-9);
  hids[0]->reports = {{3, 4}, axes(1, {0, 0, 0}), axes(1, {0, 0, 0}), axes(1, {0, 0, 0})};
  device->read(reading);
  EXPECT_EQ(reading.buttons, 4u);
  const Pose rest = reading.X_BD;
  for (mouse_now += 8 * kMs; mouse_now < 3'000 * kMs; mouse_now += kMs) device->read(reading);
  EXPECT_EQ(reading.X_BD.matrix(), rest.matrix());
  EXPECT_EQ(reading.buttons, 4u);  // a button that is held is not repeated
  device.reset();
  EXPECT_EQ(hids[0]->written, (std::vector<Bytes>{{4, 1}, {4, 0}}));
}

TEST(SpaceMouse, AllSixAxesOfAWirelessOne) {
  auto [hids, device] = opened();
  DeviceReading reading;
  device->read(reading);
  for (int i = 0; i < 100; ++i) {
    mouse_now += 8 * kMs;
    hids[0]->reports.push_back(axes(1, {350, 0, 0, 0, 0, -350}));
    device->read(reading);
  }
  EXPECT_NEAR((reading.X_BD.translation() - Vec3{0.08, 0, 0}).norm(), 0.0, 1e-9);
  EXPECT_NEAR(
      (reading.X_BD.linear() * Vec3::UnitZ() - Vec3{std::sin(0.8), 0, std::cos(0.8)}).norm(), 0.0,
      1e-9);
}

TEST(SpaceMouse, UnpluggedWhileItIsHeldItIsLostAndStill) {
  auto [hids, device] = opened();
  DeviceReading reading;
  hids[0]->reports = {axes(1, {350, 0, 0}), {3, 1}};
  device->read(reading);
  mouse_now += 8 * kMs;
  device->read(reading);
  EXPECT_GT(reading.X_BD.translation().x(), 0.0);
  const Pose last = reading.X_BD;
  hids[0]->gone = true;
  for (int i = 0; i < 100; ++i) {
    mouse_now += kMs;
    EXPECT_EQ(device->read(reading), DeviceStatus::Lost);
    EXPECT_EQ(reading.trouble, Trouble::Lost);
    EXPECT_EQ(reading.X_BD.matrix(), last.matrix());
    EXPECT_EQ(reading.buttons, 0u);
  }
  hids[0]->gone = false;  // it stays lost until it is opened again
  EXPECT_EQ(device->read(reading), DeviceStatus::Lost);
  device.reset();
  EXPECT_EQ(hids[0]->written.size(), 1u);
}

TEST(SpaceMouse, OfAReceiverWhicheverInterfaceReportsCounts) {
  auto [hids, device] = opened(3);
  DeviceReading reading;
  device->read(reading);
  hids[2]->reports = {axes(1, {350, 0, 0, 0, 0, 0})};
  mouse_now += kMs;
  device->read(reading);
  EXPECT_GT(reading.X_BD.translation().x(), 0.0);
  hids[0]->gone = hids[1]->gone = true;
  EXPECT_EQ(device->read(reading), DeviceStatus::Ok);
  hids[2]->gone = true;
  EXPECT_EQ(device->read(reading), DeviceStatus::Lost);
}

TEST(SpaceMouse, ReadsNoMoreThanItMustOfOneThatBabbles) {
  auto [hids, device] = opened();
  for (int i = 0; i < 1'000; ++i) hids[0]->reports.push_back(Bytes(64, 1));
  DeviceReading reading;
  EXPECT_EQ(device->read(reading), DeviceStatus::Ok);
  EXPECT_EQ(hids[0]->reads, 16);
  EXPECT_EQ(reading.X_BD.matrix(), Pose::Identity().matrix());
}

HidPlace place(std::uint16_t vendor, std::uint16_t product, std::string path = "/dev/null",
               std::uint16_t page = 1, std::uint16_t usage = 8) {
  return {std::move(path), vendor, product, page, usage, 0};
}

TEST(SpaceMiceAmong, FindsEveryModelAndNothingElse) {
  const std::set<int> left_alone{0xc650, 0xc651, 0xc654, 0xc655, 0xc656, 0xc657,
                                 0xc658, 0xc664, 0xc668, 0xc665, 0xc62c, 0xc641};
  int found = 0;
  for (const std::uint16_t vendor : {0x046d, 0x256f, 0x1234})
    for (int product = 0xc600; product < 0xc680; ++product) {
      const std::array places{place(vendor, static_cast<std::uint16_t>(product))};
      const auto entries = haptics::spaceMiceAmong(places);
      if (entries.empty()) continue;
      ++found;
      EXPECT_FALSE(left_alone.contains(product)) << std::hex << product;
      EXPECT_EQ(entries[0].id, "spacemouse:/dev/null");
      EXPECT_TRUE(entries[0].present);
      EXPECT_EQ(entries[0].trouble, Trouble::None);
    }
  EXPECT_EQ(found, 22);
  EXPECT_EQ(haptics::spaceMouseModels().size(), 22u);
}

TEST(SpaceMiceAmong, PicksTheCollectionOfTheCap) {
  const std::array places{place(0x256f, 0xc635, "/dev/hidraw1", 1, 6),       // its keys
                          place(0x256f, 0xc635, "/dev/hidraw2", 0xff00, 1),  // the maker's own
                          place(0x256f, 0xc635, "/dev/hidraw3"),
                          place(0x256f, 0xc635, "/dev/hidraw3"),  // once more: another collection
                          place(0x046d, 0xc626, "/dev/hidraw4", 0, 0)};
  const auto entries = haptics::spaceMiceAmong(places);
  ASSERT_EQ(entries.size(), 2u);
  EXPECT_EQ(entries[0].id, "spacemouse:/dev/hidraw3");
  EXPECT_EQ(entries[0].name, "3Dconnexion SpaceMouse Compact");
  EXPECT_EQ(entries[1].id, "spacemouse:/dev/hidraw4");
  EXPECT_EQ(entries[1].trouble, Trouble::NotPluggedIn);  // there is no such file here
}

TEST(SpaceMiceAmong, AReceiverIsOneDevice) {
  const std::array places{place(0x256f, 0xc652, "/dev/null"), place(0x256f, 0xc652, "/dev/zero"),
                          place(0x256f, 0xc652, "/dev/full")};
  EXPECT_EQ(haptics::spaceMiceAmong(places).size(), 1u);
}

TEST(SpaceMiceAmong, SaysWhichRuleIsMissing) {
  const auto file = std::filesystem::temp_directory_path() /
                    ("palpate-no-permission-" + std::to_string(::getpid()));
  std::ofstream{file} << ' ';
  std::filesystem::permissions(file, std::filesystem::perms::none);
  const bool root = ::geteuid() == 0;  // who may do all is nobody for a moment
  if (root) {
    ASSERT_EQ(::seteuid(65534), 0);
  }
  const std::array places{place(0x256f, 0xc635, file.string())};
  const auto entries = haptics::spaceMiceAmong(places);
  const auto port = haptics::openHid(places[0], "SpaceMouse");
  if (root) {
    ASSERT_EQ(::seteuid(0), 0);
  }
  std::filesystem::remove(file);
  ASSERT_EQ(entries.size(), 1u);
  EXPECT_TRUE(entries[0].present);
  EXPECT_EQ(entries[0].trouble, Trouble::NoPermission);
  EXPECT_NE(sentence(entries[0].why).find("70-palpate.rules"), std::string::npos);
  ASSERT_FALSE(port);
  EXPECT_EQ(port.error().reason, "no-permission");
}

TEST(SpaceMouseDriver, IsKnownWhereNoneIsPluggedIn) {
  const auto entries = haptics::surveySpaceMice();
  ASSERT_FALSE(entries.empty());
  if (entries[0].present) GTEST_SKIP() << "a SpaceMouse is plugged in";
  EXPECT_EQ(entries[0].trouble, Trouble::NotPluggedIn);
  EXPECT_FALSE(entries[0].why.empty());
  const auto device = haptics::openDevice({"spacemouse"});
  ASSERT_FALSE(device);
  EXPECT_EQ(device.error().reason, "not-plugged-in");
}

}  // namespace
