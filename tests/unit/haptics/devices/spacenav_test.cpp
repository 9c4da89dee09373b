// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>

#include "haptics/devices/spacenav_socket.h"
#include "tests/support/sentence.h"

namespace {

using haptics::DeviceReading;
using haptics::DeviceStatus;
using haptics::SpacenavEvent;
using haptics::SpacenavStep;
using haptics::Trouble;
using haptics::Vec3;

constexpr std::int64_t kMillisecond = 1'000'000;
std::int64_t spacenav_now = 0;
std::int64_t spacenavClock() noexcept { return spacenav_now; }

/// A service that listens at a place of its own and does what the test says.
class Service {
 public:
  Service() {
    folder_ = std::filesystem::temp_directory_path() /
              ("palpate-spnav-" + std::to_string(::getpid()) + "-" + std::to_string(++count_));
    std::filesystem::create_directories(folder_);
    listening_ = ::socket(AF_UNIX, SOCK_STREAM, 0);
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::strncpy(address.sun_path, place().c_str(), sizeof(address.sun_path) - 1);
    EXPECT_EQ(::bind(listening_, reinterpret_cast<sockaddr*>(&address), sizeof(address)), 0);
    EXPECT_EQ(::listen(listening_, 4), 0);
  }
  ~Service() {
    hangUp();
    ::close(listening_);
    std::filesystem::remove_all(folder_);
  }
  std::string place() const { return (folder_ / "spnav.sock").string(); }
  void accept() { client_ = ::accept(listening_, nullptr, nullptr); }
  void send(const void* bytes, std::size_t count) {
    ASSERT_EQ(::send(client_, bytes, count, MSG_NOSIGNAL), static_cast<ssize_t>(count));
  }
  void send(const SpacenavEvent& event) { send(event.data(), sizeof(event)); }
  /// As many bytes as the socket takes.
  std::size_t flood(std::uint8_t byte) {
    std::array<std::uint8_t, 4096> bytes;
    bytes.fill(byte);
    std::size_t sent = 0;
    for (;;) {
      const ssize_t count =
          ::send(client_, bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
      if (count <= 0) return sent;
      sent += static_cast<std::size_t>(count);
    }
  }
  void hangUp() {
    if (client_ >= 0) ::close(std::exchange(client_, -1));
  }

 private:
  static inline int count_ = 0;
  std::filesystem::path folder_;
  int listening_ = -1, client_ = -1;
};

struct Connected {
  Service service;
  std::unique_ptr<haptics::Device> device;
  DeviceReading reading;
  Connected() {
    spacenav_now = 0;
    auto opened = haptics::spacenavAt(service.place(), spacenavClock);
    EXPECT_TRUE(opened);
    device = std::move(*opened);
    service.accept();
    read();
  }
  DeviceStatus read() { return device->read(reading); }
};

constexpr SpacenavEvent kRight{0, 350, 0, 0, 0, 0, 0, 8};

TEST(SpacenavStream, AnEventIsWholeInWhateverPiecesItComes) {
  std::array<std::uint8_t, 3 * sizeof(SpacenavEvent)> bytes{};
  const std::array<SpacenavEvent, 3> sent{
      SpacenavEvent{0, 1, -2, 3, -4, 5, -6, 8}, {1, 4, 1, 0, 0, 0, 0, 0}, {0, 9, 9, 9, 9, 9, 9, 8}};
  std::memcpy(bytes.data(), sent.data(), bytes.size());
  for (std::size_t piece = 1; piece <= bytes.size(); ++piece) {
    haptics::SpacenavStream stream;
    std::vector<SpacenavEvent> came;
    for (std::size_t at = 0; at < bytes.size(); at += piece) {
      std::span<const std::uint8_t> rest =
          std::span{bytes}.subspan(at, std::min(piece, bytes.size() - at));
      while (const auto event = stream.take(rest)) came.push_back(*event);
      EXPECT_TRUE(rest.empty());
    }
    ASSERT_EQ(came.size(), 3u) << piece;
    EXPECT_TRUE(std::equal(came.begin(), came.end(), sent.begin())) << piece;
  }
}

TEST(SpacenavEvents, AxesAreRightUpAndAwayFromTheUser) {
  const auto moved = [](const SpacenavEvent& event) {
    haptics::RateControl control;
    std::uint32_t buttons = 0;
    control.step(0);
    EXPECT_EQ(haptics::applySpacenav(event, 0, control, buttons), SpacenavStep::Taken);
    const haptics::Pose X = control.step(10 * kMillisecond);
    const Eigen::AngleAxisd turned{X.linear()};
    return std::pair<Vec3, Vec3>{X.translation() * 1e3, turned.axis() * turned.angle() * 100};
  };
  const Vec3 zero = Vec3::Zero();
  const std::array units{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, -1}};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    SpacenavEvent event{0, 0, 0, 0, 0, 0, 0, 8};
    event[1 + axis] = 350;
    auto [shift, turn] = moved(event);
    EXPECT_LT((shift - units[axis]).norm(), 1e-9);
    EXPECT_LT((turn - zero).norm(), 1e-9);
    event = {0, 0, 0, 0, 0, 0, 0, 8};
    event[4 + axis] = 350;
    std::tie(shift, turn) = moved(event);
    EXPECT_LT((shift - zero).norm(), 1e-9);
    EXPECT_LT((turn - units[axis]).norm(), 1e-6);
  }
  // what no cap sends is the full speed and no more
  constexpr std::int32_t kLeast = std::numeric_limits<std::int32_t>::min();
  const auto [shift, turn] = moved({0, kLeast, kLeast, kLeast, kLeast, kLeast, kLeast, kLeast});
  EXPECT_NEAR(shift.norm(), 1.0, 1e-9);
  EXPECT_NEAR(turn.norm(), 1.0, 1e-6);
}

TEST(SpacenavEvents, ButtonsAndWhatIsNotAboutTheCap) {
  haptics::RateControl control;
  std::uint32_t buttons = 0;
  const auto apply = [&](std::int32_t type, std::int32_t value) {
    return haptics::applySpacenav({type, value, 0, 0, 0, 0, 0, 0}, 0, control, buttons);
  };
  EXPECT_EQ(apply(1, 0), SpacenavStep::Taken);
  EXPECT_EQ(apply(1, 31), SpacenavStep::Taken);
  EXPECT_EQ(buttons, 0x80000001u);
  EXPECT_EQ(apply(2, 0), SpacenavStep::Taken);
  EXPECT_EQ(buttons, 0x80000000u);
  for (const std::int32_t number : {32, 257, -1, 2147483647}) {
    EXPECT_EQ(apply(1, number), SpacenavStep::PassedOver);
    EXPECT_EQ(apply(2, number), SpacenavStep::PassedOver);
  }
  EXPECT_EQ(buttons, 0x80000000u);
  for (const std::int32_t type : {3, 4, 5, 6, 0x7faa3000})
    EXPECT_EQ(apply(type, 1), SpacenavStep::PassedOver);
  for (const std::int32_t type : {7, -1, 0x01000000, 0x7fab0000})
    EXPECT_EQ(apply(type, 1), SpacenavStep::Refused);
}

TEST(Spacenav, MovesByWhatTheServiceSends) {
  Connected it;
  for (int i = 0; i < 100; ++i) {
    it.service.send(kRight);
    spacenav_now += 8 * kMillisecond;
    ASSERT_EQ(it.read(), DeviceStatus::Ok);
  }
  EXPECT_NEAR(it.reading.X_BD.translation().x(), 0.08, 1e-9);
  it.service.send({1, 2, 1, 0, 0, 0, 0, 0});
  it.service.send({0, 0, 0, 0, 0, 0, 0, 8});
  it.read();
  EXPECT_EQ(it.reading.buttons, 4u);
  EXPECT_EQ(it.reading.time_ns, spacenav_now);
}

TEST(Spacenav, HalfAnEventIsNothingYet) {
  Connected it;
  std::array<std::uint8_t, sizeof(SpacenavEvent)> bytes;
  std::memcpy(bytes.data(), kRight.data(), bytes.size());
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    spacenav_now += kMillisecond;
    ASSERT_EQ(it.read(), DeviceStatus::Ok);
    ASSERT_EQ(it.reading.X_BD.translation().x(), 0.0);
    it.service.send(&bytes[i], 1);
  }
  spacenav_now += kMillisecond;
  it.read();
  EXPECT_NEAR(it.reading.X_BD.translation().x(), 1e-4, 1e-12);
}

TEST(Spacenav, AServiceThatDiesIsLostAndMovesNothing) {
  Connected it;
  it.service.send(kRight);
  it.service.send({1, 0, 1, 0, 0, 0, 0, 0});
  it.service.send(kRight.data(), 13);  // and in the midst of an event
  spacenav_now += kMillisecond;
  it.read();
  EXPECT_EQ(it.reading.buttons, 1u);
  const haptics::Pose last = it.reading.X_BD;
  it.service.hangUp();
  for (int i = 0; i < 10; ++i) {
    spacenav_now += kMillisecond;
    EXPECT_EQ(it.read(), DeviceStatus::Lost);
    EXPECT_EQ(it.reading.trouble, Trouble::Lost);
    EXPECT_EQ(it.reading.X_BD.matrix(), last.matrix());
    EXPECT_EQ(it.reading.buttons, 0u);
  }
}

TEST(Spacenav, AStreamOutOfStepIsRefused) {
  Connected it;
  it.service.send(kRight);
  const std::uint8_t slipped = 0;
  it.service.send(&slipped, 1);  // every event after this begins a byte late
  for (int i = 0; i < 3; ++i) it.service.send({1, 3, 1, 0, 0, 0, 0, 0});
  spacenav_now += kMillisecond;
  EXPECT_EQ(it.read(), DeviceStatus::Lost);
  EXPECT_EQ(it.reading.trouble, Trouble::Refused);
  EXPECT_EQ(it.reading.X_BD.translation(), Vec3::Zero());
}

TEST(Spacenav, AFloodIsTakenInPortions) {
  Connected it;
  const std::size_t sent = it.service.flood(0);  // motions of nothing
  ASSERT_GT(sent, 128 * sizeof(SpacenavEvent));
  std::size_t reads = 0, left = sent;
  while (left > 0 && reads < sent) {
    ASSERT_EQ(it.read(), DeviceStatus::Ok);
    left -= std::min(left, 128 * sizeof(SpacenavEvent));
    ++reads;
  }
  it.service.send(kRight);
  spacenav_now += kMillisecond;
  it.read();
  EXPECT_GT(it.reading.X_BD.translation().x(), 0.0);
}

TEST(Spacenav, WithoutAServiceItSaysWhereItLooked) {
  const auto folder = std::filesystem::temp_directory_path();
  const std::string absent = (folder / "palpate-no-such-socket").string();
  const std::string plain = (folder / ("palpate-plain-" + std::to_string(::getpid()))).string();
  std::ofstream{plain} << "no socket";
  for (const std::string& place :
       {absent, plain, folder.string(), std::string(500, 'x'), std::string{}}) {
    const auto device = haptics::spacenavAt(place);
    ASSERT_FALSE(device) << place;
    EXPECT_EQ(device.error().reason, "no-service");
    EXPECT_NE(sentence(device.error()).find("'" + place + "'"), std::string::npos);
  }
  std::filesystem::remove(plain);
}

TEST(SpacenavDriver, LooksWhereItIsTold) {
  Service service;
  ::setenv("SPNAV_SOCKET", service.place().c_str(), 1);
  auto entries = haptics::surveySpacenav();
  ASSERT_EQ(entries.size(), 1u);
  EXPECT_TRUE(entries[0].present);
  EXPECT_EQ(entries[0].trouble, Trouble::None);
  EXPECT_TRUE(haptics::openDevice({"spacenav"}));
  ::setenv("SPNAV_SOCKET", "/nowhere/spnav.sock", 1);
  entries = haptics::surveySpacenav();
  ASSERT_EQ(entries.size(), 1u);
  EXPECT_FALSE(entries[0].present);
  EXPECT_EQ(entries[0].trouble, Trouble::NoService);
  EXPECT_NE(sentence(entries[0].why).find("/nowhere/spnav.sock"), std::string::npos);
  ::unsetenv("SPNAV_SOCKET");
  EXPECT_EQ(haptics::spacenavPlace(), "/var/run/spnav.sock");
}

}  // namespace
