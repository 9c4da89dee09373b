// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/devices/inverse3.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <chrono>
#include <clocale>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "tests/support/inverse3_service.h"
#include "tests/support/sentence.h"

namespace {

using haptics::DeviceReading;
using haptics::DeviceStatus;
using haptics::Inverse3Address;
using haptics::Mat3;
using haptics::Quat;
using haptics::Trouble;
using haptics::Vec3;
using haptics::wordOf;
using haptics::Wrench;
using nlohmann::json;
using ServiceReply = Inverse3Service::Reply;
using namespace std::chrono_literals;

json xyz(const Vec3& v) { return {{"x", v.x()}, {"y", v.y()}, {"z", v.z()}}; }

json device(const Vec3& p_S, const std::string& id = "049D") {
  return {{"device_id", id},
          {"state", {{"cursor_position", xyz(p_S)}, {"cursor_velocity", xyz(Vec3::Zero())}}},
          {"status",
           {{"calibrated", true},
            {"in_use", false},
            {"power_supply", true},
            {"ready", true},
            {"started", true}}}};
}

json grip(const Quat& q) {
  return {{"device_id", "61548"},
          {"state",
           {{"orientation", {{"w", q.w()}, {"x", q.x()}, {"y", q.y()}, {"z", q.z()}}},
            {"buttons", {{"a", true}, {"b", false}, {"c", true}}},
            {"hall", 3}}}};
}

json message(const std::vector<json>& devices) { return {{"inverse3", devices}}; }

Quat about(const Vec3& axis, double angle) { return Quat{Eigen::AngleAxisd{angle, axis}}; }

TEST(Inverse3Message, TurnsTheServicesAxesIntoThoseOfTheBase) {
  // 1 cm to the right, 2 cm away from the user, 3 cm up
  const auto read = haptics::readInverse3(message({device({0.01, 0.02, 0.03})}).dump());
  ASSERT_TRUE(read);
  ASSERT_EQ(read->devices.size(), 1u);
  EXPECT_TRUE(read->devices[0].p_BD.isApprox(Vec3{0.01, 0.03, -0.02}, 1e-15));
  EXPECT_EQ(read->devices[0].id, "049D");
  EXPECT_EQ(read->devices[0].trouble, Trouble::None);
  EXPECT_TRUE(read->devices[0].tells_status);
  EXPECT_FALSE(read->R_BD);
}

TEST(Inverse3Message, TurnsTheGripAsItTurnsTheCursor) {
  const Vec3 right{1, 0, 0}, away{0, 1, 0}, up{0, 0, 1};  // in the service's axes
  const struct {
    Vec3 about_S, about_B;
  } kCases[] = {{right, {1, 0, 0}}, {away, {0, 0, -1}}, {up, {0, 1, 0}}};
  for (const auto& turn : kCases) {
    json said = message({device(Vec3::Zero())});
    Quat q = about(turn.about_S, 0.7);
    q.coeffs() *= 1.01;  // not quite of length one
    said["wireless_verse_grip"] = json::array({grip(q)});
    const auto read = haptics::readInverse3(said.dump());
    ASSERT_TRUE(read && read->R_BD);
    EXPECT_TRUE(read->R_BD->isApprox(about(turn.about_B, 0.7).toRotationMatrix(), 1e-12));
    EXPECT_EQ(read->buttons, 0b101u);
  }
}

TEST(Inverse3Message, TakesTheFirstGripThatTellsItsOrientation) {
  json said = message({device(Vec3::Zero())});
  json silent = grip(Quat::Identity());
  silent["state"]["orientation"] = {{"w", 0}, {"x", 0}, {"y", 0}, {"z", 0}};
  json wired = grip(about({0, 0, 1}, 0.2));
  wired["state"].erase("buttons");
  wired["state"]["button"] = true;
  said["verse_grip"] = {silent, wired};
  said["wireless_verse_grip"] = json::array({grip(Quat::Identity())});
  const auto read = haptics::readInverse3(said.dump());
  ASSERT_TRUE(read && read->R_BD);
  EXPECT_TRUE(read->R_BD->isApprox(about({0, 1, 0}, 0.2).toRotationMatrix(), 1e-12));
  EXPECT_EQ(read->buttons, 1u);
}

TEST(Inverse3Message, SaysWhyADeviceIsNotReady) {
  for (const std::string flag : {"calibrated", "power_supply", "ready", "started"}) {
    json said = message({device(Vec3::Zero())});
    said["inverse3"][0]["status"][flag] = false;
    const auto read = haptics::readInverse3(said.dump());
    ASSERT_TRUE(read);
    EXPECT_EQ(read->devices[0].trouble,
              flag == "calibrated" ? Trouble::NeedsCalibration : Trouble::NotStarted)
        << flag;
    EXPECT_FALSE(read->devices[0].why.empty()) << flag;
  }
  json said = message({device(Vec3::Zero())});
  said["inverse3"][0].erase("status");
  const auto read = haptics::readInverse3(said.dump());
  ASSERT_TRUE(read);
  EXPECT_FALSE(read->devices[0].tells_status);
}

TEST(Inverse3Message, WhatIsNotOfTheProtocolIsNothing) {
  const auto with = [](const std::function<void(json&)>& change) {
    json said = message({device(Vec3::Zero())});
    change(said);
    return said.dump();
  };
  json& (*const state)(json&) = [](json& said) -> json& { return said["inverse3"][0]["state"]; };
  std::string not_a_number = message({device(Vec3::Zero())}).dump();
  not_a_number.replace(not_a_number.find("0.0"), 3, "NaN");
  std::string huge = message({device(Vec3::Zero())}).dump();
  huge.replace(huge.find("0.0"), 3, "1e999");
  std::vector<json> many(17, device(Vec3::Zero()));
  const std::vector<std::string> kBad{
      "", "{", "null", "[]", "7", "{}", R"({"inverse3":{}})", R"({"inverse3":7})",
      R"({"inverse3":[7]})", "\xff\xfe", std::string(3, '\0'), not_a_number, huge,
      std::string(60'000, '['), "{\"inverse3\":" + std::string(60'000, '['),
      std::string(haptics::kInverse3LongestMessage + 1, ' '), message(many).dump(),
      with([](json& said) { said["inverse3"][0].erase("device_id"); }),
      with([](json& said) { said["inverse3"][0]["device_id"] = 7; }),
      with([](json& said) { said["inverse3"][0]["device_id"] = "a\"b"; }),
      with([](json& said) { said["inverse3"][0]["device_id"] = std::string(33, 'a'); }),
      with([](json& said) { said["inverse3"][0]["device_id"] = ""; }),
      with([](json& said) { said["inverse3"][0].erase("state"); }),
      with([](json& said) { said["inverse3"][0]["state"] = "idle"; }),
      with([](json& said) { said["inverse3"][0]["status"] = true; }),
      with([](json& said) { said["inverse3"][0]["status"]["ready"] = "true"; }),
      with([&](json& said) { state(said).erase("cursor_position"); }),
      with([&](json& said) { state(said)["cursor_position"]["x"] = "0"; }),
      with([&](json& said) { state(said)["cursor_position"]["y"] = nullptr; }),
      with([&](json& said) { state(said)["cursor_position"].erase("z"); }),
      with([&](json& said) { state(said)["cursor_position"]["z"] = 10.1; }), with([&](json& said) {
        state(said)["cursor_position"] = {0, 0, 0};
      }),
      // as version 3.0 had it
      R"({"inverse3":{"049D":{"state":{"cursor_position":{"x":0,"y":0,"z":0}}}}})"};
  for (const std::string& text : kBad)
    EXPECT_FALSE(haptics::readInverse3(text)) << text.substr(0, 100);
  EXPECT_TRUE(haptics::readInverse3(with([](json&) {})));
}

TEST(Inverse3Message, AGripThatIsNotUnderstoodIsNoGrip) {
  for (const json& bad :
       {json{7}, json{{"state", 7}}, json{{"state", {{"orientation", {{"w", "1"}}}}}}}) {
    json said = message({device(Vec3::Zero())});
    said["verse_grip"] = {bad};
    said["wireless_verse_grip"] = 7;
    const auto read = haptics::readInverse3(said.dump());
    ASSERT_TRUE(read);
    EXPECT_FALSE(read->R_BD);
  }
}

TEST(Inverse3Command, SaysTheForceInTheServicesAxesInEveryLanguage) {
  const char* const german = std::setlocale(LC_NUMERIC, "de_DE.UTF-8");
  const std::string text = haptics::inverse3Command("049D", {1.25, 2.5, -3.75});
  if (german != nullptr) std::setlocale(LC_NUMERIC, "C");
  const json said = json::parse(text);
  EXPECT_EQ(
      said,
      (json{{"inverse3",
             {{{"device_id", "049D"},
               {"commands",
                {{"set_cursor_force", {{"vector", {{"x", 1.25}, {"y", 3.75}, {"z", 2.5}}}}}}}}}}}));
}

TEST(Inverse3Command, NeverSaysWhatIsNotFinite) {
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    const json said = json::parse(haptics::inverse3Command("049D", {1, bad, 1}));
    EXPECT_EQ(said["inverse3"][0]["commands"]["set_cursor_force"]["vector"],
              (json{{"x", 0.0}, {"y", 0.0}, {"z", 0.0}}));
  }
  // the longest that there is fits
  const Vec3 long_one = Vec3::Constant(-1.2345678901234567e-300);
  EXPECT_LT(haptics::inverse3Command(std::string(32, 'a'), long_one).size(), 300u);
}

/// A service with one device and a grip, and who feels it.
struct Inverse3 : testing::Test {
  Inverse3() { behave(); }

  /// As the maker's does.
  void behave() {
    service.greetWith({ServiceReply{.text = full().dump()}});
    service.answerWith([](int) { return std::vector{ServiceReply{.text = full().dump()}}; });
  }
  static json full(const Vec3& p_S = {0.01, 0.02, 0.03}) {
    json said = message({device(p_S)});
    said["wireless_verse_grip"] = json::array({grip(about({0, 0, 1}, 0.5))});
    return said;
  }
  /// From the nth command on it answers like this, and before as the maker's.
  void misbehaveFrom(int n, const std::vector<ServiceReply>& bad) {
    service.answerWith([n, bad](int command) {
      return command < n ? std::vector{ServiceReply{.text = full().dump()}} : bad;
    });
  }
  Inverse3Address patient() const { return {.port = service.port(), .answer = 2s}; }
  Inverse3Address hasty() const { return {.port = service.port(), .answer = 100ms}; }

  void open(const Inverse3Address& address, const std::string& id = "inverse3") {
    auto opened = haptics::openInverse3({.id = id}, address);
    ASSERT_TRUE(opened) << sentence(opened.error());
    device_here = std::move(*opened);
  }
  /// Refused, for this reason and with a sentence.
  void expectRefused(Trouble trouble, const std::string& id = "inverse3") {
    const auto opened = haptics::openInverse3({.id = id}, patient());
    ASSERT_FALSE(opened);
    EXPECT_EQ(opened.error().reason, wordOf(trouble));
    EXPECT_NE(sentence(opened.error()).find("Haply Inverse3"), std::string::npos);
    EXPECT_EQ(sentence(opened.error()).back(), '.');
  }
  /// A servo loop that pushes, until this holds or never will; a minute is for ever.
  bool pushUntil(const std::function<bool(DeviceStatus)>& holds) {
    const auto end = std::chrono::steady_clock::now() + 1min;
    DeviceStatus status = DeviceStatus::Ok;
    while (status != DeviceStatus::Lost && std::chrono::steady_clock::now() < end) {
      status = device_here->read(reading);
      if (holds(status)) return true;
      device_here->write(Wrench{Vec3{0, 1.5, 0}, Vec3::Zero()});
      std::this_thread::sleep_for(1ms);
    }
    std::cout << "status " << int(status) << ", trouble " << wordOf(reading.trouble) << ", "
              << service.commands().size() << " commands, "
              << (service.isConnected() ? "connected\n" : "not connected\n");
    return false;
  }
  int pushes() const {
    int count = 0;
    for (const auto& command : service.commands()) count += command.pushes();
    return count;
  }

  Inverse3Service service;
  std::unique_ptr<haptics::Device> device_here;
  DeviceReading reading;
};

TEST_F(Inverse3, IsWhereItsMakerPutItAndAnswersWithinWhatATransportMayWait) {
  EXPECT_EQ(Inverse3Address{}.port, 10001);
  EXPECT_EQ(Inverse3Address{}.answer, haptics::Transport::kLongestWait);
}

TEST_F(Inverse3, ASurveySaysWhatIsThereAndSendsNothing) {
  const auto entries = haptics::surveyInverse3(patient());
  ASSERT_EQ(entries.size(), 1u);
  EXPECT_EQ(entries[0].id, "inverse3:049D");
  EXPECT_TRUE(entries[0].present);
  EXPECT_EQ(entries[0].trouble, Trouble::None);
  EXPECT_EQ(entries[0].sensed, 6);
  EXPECT_EQ(entries[0].actuated, 3);
  EXPECT_EQ(sentence(entries[0].why), "");
  EXPECT_EQ(service.connections(), 1);
  EXPECT_TRUE(service.commands().empty());
}

TEST_F(Inverse3, ASurveySaysWhatIsMissing) {
  const auto surveyed = [&] {
    const auto entries = haptics::surveyInverse3(patient());
    EXPECT_EQ(entries.size(), 1u);
    EXPECT_FALSE(entries[0].why.empty());
    return entries[0];
  };
  service.greetWith({ServiceReply{.text = message({}).dump()}});
  EXPECT_EQ(surveyed().trouble, Trouble::NotPluggedIn);
  EXPECT_FALSE(surveyed().present);

  json said = message({device(Vec3::Zero())});
  said["inverse3"][0]["config"]["basis"]["permutation"] = "XZY";
  service.greetWith({ServiceReply{.text = said.dump()}});
  EXPECT_EQ(surveyed().trouble, Trouble::Refused);

  said = message({device(Vec3::Zero())});
  said["inverse3"][0]["status"]["calibrated"] = false;
  service.greetWith({ServiceReply{.text = said.dump()}});
  EXPECT_EQ(surveyed().trouble, Trouble::NeedsCalibration);
  EXPECT_EQ(surveyed().sensed, 3);

  service.greetWith({ServiceReply{.text = "hello"}});
  EXPECT_EQ(surveyed().trouble, Trouble::Refused);
  service.greetWith({});
  EXPECT_EQ(surveyed().trouble, Trouble::NoService);
  service.refuse(true);
  EXPECT_EQ(surveyed().trouble, Trouble::Refused);
}

TEST_F(Inverse3, WithoutAServiceItSaysToInstallIt) {
  Inverse3Address nowhere = patient();
  {
    const Inverse3Service gone;
    nowhere.port = gone.port();
  }
  const auto entries = haptics::surveyInverse3(nowhere);
  ASSERT_EQ(entries.size(), 1u);
  EXPECT_EQ(entries[0].trouble, Trouble::NoService);
  EXPECT_NE(sentence(entries[0].why).find("haply-inverse-service"), std::string::npos);
  const auto opened = haptics::openInverse3({.id = "inverse3"}, nowhere);
  ASSERT_FALSE(opened);
  EXPECT_EQ(opened.error().reason, wordOf(Trouble::NoService));
}

TEST_F(Inverse3, AProxyIsNotAsked) {
  Inverse3Service proxy;
  const std::string address = "http://127.0.0.1:" + std::to_string(proxy.port());
  setenv("http_proxy", address.c_str(), 1);
  EXPECT_EQ(haptics::surveyInverse3(patient())[0].trouble, Trouble::None);
  const auto opened = haptics::openInverse3({.id = "inverse3"}, patient());
  unsetenv("http_proxy");
  EXPECT_TRUE(opened);
  EXPECT_EQ(proxy.connections(), 0);
  EXPECT_EQ(service.connections(), 2);
}

/// Takes one connection after the other and says the same to each, whatever it is asked.
class Parrot {
 public:
  explicit Parrot(std::string says) : says_{std::move(says)} {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t length = sizeof address;
    auto* const generic = reinterpret_cast<sockaddr*>(&address);
    if (::bind(listening_, generic, length) != 0 || ::listen(listening_, 4) != 0 ||
        ::getsockname(listening_, generic, &length) != 0)
      throw std::runtime_error("no port on loopback");
    port_ = ntohs(address.sin_port);
    thread_ = std::thread{[this] { run(); }};
  }
  ~Parrot() {
    ::shutdown(listening_, SHUT_RDWR);
    thread_.join();
    for (const int taken : taken_) ::close(taken);
    ::close(listening_);
  }
  Parrot(const Parrot&) = delete;
  Parrot& operator=(const Parrot&) = delete;
  std::uint16_t port() const { return port_; }

 private:
  void run() {
    for (;;) {
      const int taken = ::accept(listening_, nullptr, nullptr);
      if (taken < 0) return;
      taken_.push_back(taken);
      std::array<char, 4096> asked;
      if (::recv(taken, asked.data(), asked.size(), 0) > 0)
        ::send(taken, says_.data(), says_.size(), MSG_NOSIGNAL);
    }
  }

  const std::string says_;
  const int listening_ = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  std::vector<int> taken_;
  std::uint16_t port_ = 0;
  std::thread thread_;
};

TEST_F(Inverse3, NobodyIsFollowedToAnotherPlace) {
  for (const char* const code : {"301 Moved", "302 Found", "307 Temporary Redirect"}) {
    const std::string there = "127.0.0.1:" + std::to_string(service.port()) + "/";
    for (const char* const scheme : {"ws://", "http://"}) {
      const Parrot elsewhere{std::string{"HTTP/1.1 "} + code + "\r\nLocation: " + scheme + there +
                             "\r\nContent-Length: 0\r\n\r\n"};
      const auto entries = haptics::surveyInverse3({.port = elsewhere.port()});
      EXPECT_EQ(entries[0].trouble, Trouble::Refused) << code;
    }
  }
  EXPECT_EQ(service.connections(), 0);
}

TEST_F(Inverse3, WhoListensAndIsNoWebSocketIsNotTheService) {
  const Parrot silent{""};
  EXPECT_EQ(haptics::surveyInverse3({.port = silent.port()})[0].trouble, Trouble::NoService);
  for (const char* const says :
       {"HTTP/1.1 200 OK\r\nContent-Length: 2\r\n\r\nhi", "220 mail.example ESMTP\r\n", "\n"}) {
    const Parrot other{says};
    const auto entries = haptics::surveyInverse3({.port = other.port()});
    EXPECT_NE(entries[0].trouble, Trouble::None) << says;
    EXPECT_FALSE(entries[0].why.empty());
  }
}

TEST_F(Inverse3, DoesNotMindHowManyFilesAreOpen) {
  std::vector<int> files;
  for (int n = 0; n < 300; ++n) files.push_back(::open("/dev/null", O_RDONLY | O_CLOEXEC));
  ASSERT_GT(files.back(), 256);
  open(patient());
  EXPECT_TRUE(pushUntil([&](DeviceStatus) { return pushes() >= 5; }));
  for (const int file : files) ::close(file);
}

TEST_F(Inverse3, IsFeltAndFollowed) {
  open(patient());
  EXPECT_EQ(device_here->rating().id, "inverse3");
  EXPECT_EQ(device_here->rating().sensed, 6);
  ASSERT_TRUE(
      pushUntil([&](DeviceStatus status) { return status == DeviceStatus::Ok && pushes() >= 20; }));
  EXPECT_TRUE(reading.X_BD.translation().isApprox(Vec3{0.01, 0.03, -0.02}, 1e-15));
  EXPECT_TRUE(reading.X_BD.linear().isApprox(about({0, 1, 0}, 0.5).toRotationMatrix(), 1e-12));
  EXPECT_EQ(reading.buttons, 0b101u);
  for (const auto& command : service.commands()) {
    EXPECT_EQ(command.x, 0.0);
    EXPECT_EQ(command.y, 0.0);
    EXPECT_TRUE(command.z == 0.0 || command.z == 1.5);  // up
  }
  EXPECT_FALSE(service.commands().front().pushes());
}

TEST_F(Inverse3, TheLastCommandIsZeroWhenItIsClosed) {
  open(patient());
  ASSERT_TRUE(pushUntil([&](DeviceStatus) { return pushes() >= 5; }));
  device_here->write(Wrench{Vec3{0, 1.5, 0}, Vec3::Zero()});
  device_here.reset();
  EXPECT_FALSE(service.commands().back().pushes());
}

TEST_F(Inverse3, StopIsTheLastWord) {
  open(patient());
  ASSERT_TRUE(pushUntil([&](DeviceStatus) { return pushes() >= 5; }));
  device_here->stop();
  const std::size_t at_stop = service.commands().size();
  ASSERT_TRUE(pushUntil([&](DeviceStatus) { return service.commands().size() >= at_stop + 20; }));
  const auto commands = service.commands();
  for (std::size_t n = at_stop + 2; n < commands.size(); ++n)
    EXPECT_FALSE(commands[n].pushes()) << n - at_stop;
  device_here->resume();
  const int before = pushes();
  EXPECT_TRUE(pushUntil([&](DeviceStatus) { return pushes() > before; }));
}

TEST_F(Inverse3, OpensTheOneThatIsAskedFor) {
  const auto two = message({device({0.01, 0, 0}, "A1"), device({0.02, 0, 0}, "B-2_x")}).dump();
  service.greetWith({ServiceReply{.text = two}});
  service.answerWith([two](int) { return std::vector{ServiceReply{.text = two}}; });
  EXPECT_EQ(haptics::surveyInverse3(patient()).size(), 2u);
  open(patient(), "inverse3:B-2_x");
  ASSERT_TRUE(pushUntil([&](DeviceStatus status) { return status == DeviceStatus::Ok; }));
  EXPECT_EQ(reading.X_BD.translation().x(), 0.02);
  EXPECT_NE(service.commands().back().text.find("\"B-2_x\""), std::string::npos);
  EXPECT_EQ(device_here->rating().sensed, 3);
  EXPECT_EQ(reading.X_BD.linear(), Mat3::Identity());  // without a grip
  device_here.reset();
  expectRefused(Trouble::NotPluggedIn, "inverse3:C3");
}

TEST_F(Inverse3, IsNotOpenedWhereItWouldBeMisunderstood) {
  service.greetWith({ServiceReply{.text = message({}).dump()}});
  expectRefused(Trouble::NotPluggedIn);
  json said = full();
  said["inverse3"][0]["config"]["basis"]["permutation"] = "X-YZ";
  service.greetWith({ServiceReply{.text = said.dump()}});
  expectRefused(Trouble::Refused);
  service.greetWith({ServiceReply{.text = R"({"hello":"world"})"}});
  expectRefused(Trouble::Refused);
  service.greetWith({});
  expectRefused(Trouble::NoService);
  service.greetWith({ServiceReply{.closes = true}});
  expectRefused(Trouble::Refused);
  behave();
  misbehaveFrom(0, {ServiceReply{.text = R"({"state":1})"}});
  expectRefused(Trouble::Refused);
  misbehaveFrom(0, {});
  expectRefused(Trouble::NoService);
  misbehaveFrom(0, {ServiceReply{.closes = true}});
  expectRefused(Trouble::Refused);
  service.refuse(true);
  expectRefused(Trouble::Refused);
  for (const auto& command : service.commands()) EXPECT_FALSE(command.pushes());
  // and as soon as it is mended
  service.refuse(false);
  behave();
  EXPECT_TRUE(haptics::openInverse3({.id = "inverse3"}, patient()));
}

TEST_F(Inverse3, NotReadyIsToldAndGoesAway) {
  const auto calibrated = std::make_shared<std::atomic<int>>(1);  // 2: the status is left out
  service.answerWith([calibrated](int) {
    json said = full();
    if (*calibrated == 2)
      said["inverse3"][0].erase("status");
    else
      said["inverse3"][0]["status"]["calibrated"] = *calibrated == 1;
    return std::vector{ServiceReply{.text = said.dump()}};
  });
  open(patient());
  ASSERT_TRUE(pushUntil([](DeviceStatus status) { return status == DeviceStatus::Ok; }));
  *calibrated = 0;
  ASSERT_TRUE(pushUntil([](DeviceStatus status) { return status == DeviceStatus::NotReady; }));
  EXPECT_EQ(reading.trouble, Trouble::NeedsCalibration);
  *calibrated = 2;
  const std::size_t sent = service.commands().size();
  ASSERT_TRUE(pushUntil([&](DeviceStatus) { return service.commands().size() > sent + 5; }));
  EXPECT_EQ(device_here->read(reading), DeviceStatus::NotReady);
  EXPECT_FALSE(service.commands().back().pushes());
  *calibrated = 1;
  ASSERT_TRUE(pushUntil([](DeviceStatus status) { return status == DeviceStatus::Ok; }));
  EXPECT_EQ(reading.trouble, Trouble::None);
}

TEST_F(Inverse3, TheRotationOfAGripThatGoesSilentIsHeld) {
  const auto silent = std::make_shared<std::atomic<bool>>(false);
  service.answerWith([silent](int) {
    const bool now = *silent;
    json said = full({now ? 0.05 : 0.01, 0, 0});
    if (now) said.erase("wireless_verse_grip");
    return std::vector{ServiceReply{.text = said.dump()}};
  });
  open(patient());
  ASSERT_TRUE(pushUntil([](DeviceStatus status) { return status == DeviceStatus::Ok; }));
  *silent = true;
  ASSERT_TRUE(pushUntil([&](DeviceStatus) { return reading.X_BD.translation().x() == 0.05; }));
  EXPECT_TRUE(reading.X_BD.linear().isApprox(about({0, 1, 0}, 0.5).toRotationMatrix(), 1e-12));
  EXPECT_EQ(reading.buttons, 0u);  // none stays down
}

TEST_F(Inverse3, MessagesInPiecesAreWhole) {
  service.greetWith({ServiceReply{.text = full().dump(), .fragments = 5}});
  service.answerWith([](int n) {
    json said = full();
    said["inverse3"][0]["config"]["filler"] = std::string(40'000, 'x');
    return std::vector{ServiceReply{.text = said.dump(), .fragments = 1 + n % 7}};
  });
  open(patient());
  ASSERT_TRUE(pushUntil([&](DeviceStatus status) {
    EXPECT_NE(status, DeviceStatus::Lost);
    return status == DeviceStatus::Lost || pushes() >= 20;
  }));
  EXPECT_EQ(device_here->read(reading), DeviceStatus::Ok);
}

TEST_F(Inverse3, AServiceThatAnswersTwiceIsFollowedToWhatIsNewest) {
  service.answerWith([](int n) {
    const ServiceReply reply{.text = full({0.001 * (n % 50), 0, 0}).dump()};
    return std::vector{reply, reply};
  });
  open(patient());
  double last = -1.0;
  int changes = 0;
  ASSERT_TRUE(pushUntil([&](DeviceStatus status) {
    EXPECT_NE(status, DeviceStatus::Lost);
    changes += std::exchange(last, reading.X_BD.translation().x()) != last;
    return status == DeviceStatus::Lost || changes >= 30;
  }));
}

/// What a service may do wrong while it is felt, from its 20th answer on.
struct Wrong {
  const char* name;
  std::vector<ServiceReply> replies;
  bool hasty = false;
  bool at_once = false;  ///< after one answer, not three

  friend void PrintTo(const Wrong& wrong, std::ostream* out) { *out << wrong.name; }
};

std::vector<Wrong> wrongs() {
  const auto changed = [](const std::function<void(json&)>& change) {
    json said = Inverse3::full();
    change(said);
    return ServiceReply{.text = said.dump()};
  };
  std::string not_a_number = Inverse3::full().dump();
  not_a_number.replace(not_a_number.find("0.01"), 4, "NaN");
  const ServiceReply good{.text = Inverse3::full().dump()};
  ServiceReply late = good, binary = good;
  late.delay = 150ms;
  binary.binary = true;
  return {
      {.name = "NeverAnswers", .replies = {}, .hasty = true},
      {.name = "IsAlwaysLate", .replies = {late}, .hasty = true},
      {.name = "Garbage", .replies = {ServiceReply{.text = "\x01{]["}}},
      {.name = "Empty", .replies = {ServiceReply{.text = "{}"}}},
      {.name = "Deep", .replies = {ServiceReply{.text = std::string(60'000, '[')}}},
      {.name = "NaN", .replies = {ServiceReply{.text = not_a_number}}},
      {.name = "Strings", .replies = {changed([](json& said) {
                            said["inverse3"][0]["state"]["cursor_position"]["x"] = "0.01";
                          })}},
      {.name = "WithoutTheDevice",
       .replies = {changed([](json& said) { said["inverse3"] = json::array(); })}},
      {.name = "AnotherDevice",
       .replies = {changed([](json& said) { said["inverse3"][0]["device_id"] = "0000"; })}},
      {.name = "Oversized",
       .replies = {ServiceReply{.text = std::string(haptics::kInverse3LongestMessage + 1, ' ')}},
       .at_once = true},
      {.name = "OversizedInPieces",
       .replies = {ServiceReply{.text = std::string(500'000, ' '), .fragments = 100}},
       .at_once = true},
      {.name = "Binary", .replies = {binary}, .at_once = true},
      {.name = "Closes", .replies = {ServiceReply{.closes = true}}, .at_once = true},
  };
}

struct Misbehaving : Inverse3, testing::WithParamInterface<Wrong> {};

TEST_P(Misbehaving, IsLostWithItsLastForceCountedAndComesBackWhenItIsOpenedAgain) {
  constexpr std::size_t kFrom = 20;
  const Wrong& wrong = GetParam();
  for (int round = 0; round < 2; ++round) {
    const std::size_t before = service.commands().size();
    misbehaveFrom(int(kFrom), wrong.replies);
    open(wrong.hasty ? hasty() : patient());
    ASSERT_TRUE(pushUntil([&](DeviceStatus status) { return status == DeviceStatus::Lost; }));
    EXPECT_EQ(reading.trouble, Trouble::Lost);
    EXPECT_EQ(device_here->write(Wrench{Vec3{0, 1.5, 0}, Vec3::Zero()}), DeviceStatus::Lost);
    device_here.reset();

    // three that were answered badly, and a zero; or none after a connection that is gone
    const auto commands = service.commands();
    const std::size_t after = commands.size() - before - kFrom;
    EXPECT_EQ(after, wrong.at_once ? 1u : 4u);
    EXPECT_TRUE(wrong.at_once || !commands.back().pushes());
    EXPECT_GT(pushes(), 0);
  }
  behave();
  open(patient());
  const int before = pushes();
  EXPECT_TRUE(pushUntil(
      [&](DeviceStatus status) { return status == DeviceStatus::Ok && pushes() > before + 10; }));
}

INSTANTIATE_TEST_SUITE_P(Inverse3, Misbehaving, testing::ValuesIn(wrongs()),
                         [](const auto& wrong) { return std::string{wrong.param.name}; });

TEST_F(Inverse3, AServiceThatDiesIsLostAndTheNextOneIsAsGood) {
  auto mortal = std::make_unique<Inverse3Service>();
  mortal->greetWith({ServiceReply{.text = full().dump()}});
  mortal->answerWith([](int) { return std::vector{ServiceReply{.text = full().dump()}}; });
  open({.port = mortal->port(), .answer = 2s});
  ASSERT_TRUE(pushUntil([](DeviceStatus status) { return status == DeviceStatus::Ok; }));
  mortal.reset();
  ASSERT_TRUE(pushUntil([](DeviceStatus status) { return status == DeviceStatus::Lost; }));
  device_here.reset();
  open(patient());
  EXPECT_TRUE(pushUntil([](DeviceStatus status) { return status == DeviceStatus::Ok; }));
}

TEST_F(Inverse3, TheCatalogueKnowsIt) {
  const haptics::Driver* known = nullptr;
  for (const haptics::Driver& driver : haptics::drivers())
    if (driver.name == "inverse3") known = &driver;
  ASSERT_NE(known, nullptr);
  ASSERT_NE(haptics::findRating("inverse3"), nullptr);
}

}  // namespace
