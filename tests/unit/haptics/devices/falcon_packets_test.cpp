// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/devices/falcon_packets.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <initializer_list>
#include <limits>
#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace {

using haptics::Vec3;
using haptics::falcon::Command;
using haptics::falcon::decoded;
using haptics::falcon::encoded;
using haptics::falcon::kMostMotor;
using haptics::falcon::Motors;
using haptics::falcon::motorsFor;
using haptics::falcon::Packet;
using haptics::falcon::Reply;
using haptics::falcon::ReplyStream;

std::string textOf(const Packet& packet) { return {packet.begin(), packet.end()}; }

Packet packetOf(std::string_view text) {
  Packet packet{};
  EXPECT_EQ(text.size(), packet.size());
  std::copy_n(text.begin(), std::min(text.size(), packet.size()), packet.begin());
  return packet;
}

/// Bytes as the chip hands them over: two of status before every 62.
std::vector<std::uint8_t> transferOf(std::string_view text) {
  std::vector<std::uint8_t> bytes{0x01, 0x60};
  for (const char c : text) {
    if (bytes.size() % 64 == 0) bytes.insert(bytes.end(), {0x01, 0x60});
    bytes.push_back(static_cast<std::uint8_t>(c));
  }
  return bytes;
}

TEST(FalconPackets, CommandsAreTheseBytes) {
  EXPECT_EQ(textOf(encoded({})), "<AAAAAAAAAAAAAA>");
  // 0x1234, -1 and -4096, the lowest nibble first
  EXPECT_EQ(textOf(encoded({.motors = {0x1234, -1, -4096}})), "<EDCBPPPPAAAPAA>");
  EXPECT_EQ(textOf(encoded({.homing = true})), "<AAAAAAAAAAAABA>");
  EXPECT_EQ(textOf(encoded({.green = true})), "<AAAAAAAAAAAACA>");
  EXPECT_EQ(textOf(encoded({.blue = true})), "<AAAAAAAAAAAAEA>");
  EXPECT_EQ(textOf(encoded({.red = true})), "<AAAAAAAAAAAAIA>");
  EXPECT_EQ(textOf(encoded({.homing = true, .red = true, .green = true, .blue = true})),
            "<AAAAAAAAAAAAPA>");
}

TEST(FalconPackets, RepliesAreReadFromTheseBytes) {
  const auto reply = decoded(packetOf("<EDCBPPPPAAAPAA>"));
  ASSERT_TRUE(reply);
  EXPECT_EQ(reply->encoders, (std::array<std::int16_t, 3>{0x1234, -1, -4096}));
  EXPECT_EQ(reply->buttons, 0);
  EXPECT_EQ(reply->homed, 0);
  EXPECT_FALSE(reply->isHomed());
  // buttons in the low bits, stops above
  std::string text = "<AAAAAAAAAAAAAA>";
  for (unsigned bits = 0; bits < 128; ++bits) {
    text[13] = static_cast<char>('A' + bits);
    const auto each = decoded(packetOf(text));
    ASSERT_TRUE(each);
    EXPECT_EQ(each->buttons, bits & 15);
    EXPECT_EQ(each->homed, bits >> 4);
    EXPECT_EQ(each->isHomed(), bits >= 112);
  }
  text[13] = static_cast<char>(0xC1);
  EXPECT_FALSE(decoded(packetOf(text)));
  for (const char wrong : {'@', 'Q', 'a', '\0', '0'})
    for (std::size_t i = 1; i <= 12; ++i) {
      std::string spoilt = "<AAAAAAAAAAAAAA>";
      spoilt[i] = wrong;
      EXPECT_FALSE(decoded(packetOf(spoilt))) << i << wrong;
    }
  EXPECT_FALSE(decoded(packetOf("AAAAAAAAAAAAAAA>")));
  EXPECT_FALSE(decoded(packetOf("<AAAAAAAAAAAAAAA")));
}

TEST(FalconPackets, EveryNumberComesBack) {
  for (int n = -32768; n <= 32767; ++n) {
    const auto value = static_cast<std::int16_t>(n);
    const auto back = decoded(encoded({.motors = {value, static_cast<std::int16_t>(~n), value}}));
    ASSERT_TRUE(back);
    ASSERT_EQ(back->encoders[0], value);
    ASSERT_EQ(back->encoders[1], static_cast<std::int16_t>(~n));
  }
}

TEST(FalconPackets, MotorsKeepTheRatioOfTheirTorques) {
  EXPECT_EQ(motorsFor({0.1, -0.2, 0.0}), (Motors{-1000, 2000, 0}));
  // four times too much: all three by one factor
  EXPECT_EQ(motorsFor({1.6384, -0.8192, 0.4096}), (Motors{-4096, 2048, -1024}));
  EXPECT_EQ(motorsFor({1e300, 0.0, -1e300}), (Motors{-4096, 0, 4096}));
  const double nan = std::numeric_limits<double>::quiet_NaN(),
               infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(motorsFor({nan, 0.1, 0.1}), Motors{});
  EXPECT_EQ(motorsFor({0.1, 0.1, nan}), Motors{});
  EXPECT_EQ(motorsFor({0.1, -infinity, 0.1}), Motors{});
  EXPECT_EQ(motorsFor(Vec3::Constant(1e308)), Motors{});  // the scaled number is none
  std::mt19937 random{2};
  std::normal_distribution<double> normal{0.0, 3.0};
  for (int n = 0; n < 10'000; ++n) {
    const Vec3 torques{normal(random), normal(random), normal(random)};
    const Motors motors = motorsFor(torques);
    const Vec3 sent{double(motors[0]), double(motors[1]), double(motors[2])};
    EXPECT_LE(sent.cwiseAbs().maxCoeff(), kMostMotor);
    EXPECT_LT(sent.dot(torques), 0.0);
    EXPECT_LT(sent.cross(torques).norm() / (sent.norm() * torques.norm()), 2e-2);
  }
}

TEST(FalconPackets, FindsRepliesInWhatTheChipHandsOver) {
  struct Case {
    std::vector<std::vector<std::uint8_t>> transfers;
    int replies;
    int newest;  ///< first encoder of the newest
  };
  const std::string a = "<BAAAAAAAAAAAAA>", b = "<CAAAAAAAAAAAAA>";
  const std::string many = a + a + a + a + b;  // longer than a packet of the bus
  const std::vector<Case> cases{
      {{transferOf(a)}, 1, 1},
      {{transferOf(a + b)}, 2, 2},
      {{transferOf(a.substr(0, 5)), transferOf(a.substr(5))}, 1, 1},
      {{transferOf(many)}, 5, 2},
      {{transferOf("xx>yy" + a + "##" + b + "zz")}, 2, 2},
      {{transferOf(a.substr(0, 9) + b)}, 1, 2},          // cut off by the next
      {{transferOf("<AAAAAA>" + b)}, 1, 2},              // too short
      {{transferOf("<AAAAAAAAAAAAAAAAAA>" + b)}, 1, 2},  // too long
      {{transferOf("<<" + a.substr(1))}, 1, 1},
      {{transferOf("<AAAQAAAAAAAAAA>" + b)}, 1, 2},  // no letter of the code
      {{transferOf(""), {}, {0x01}, transferOf(b)}, 1, 2},
      {{transferOf(std::string(5000, '<'))}, 0, 0},
      {{transferOf(std::string(5000, 'A'))}, 0, 0},
      {{transferOf(">>>>")}, 0, 0},
  };
  for (std::size_t n = 0; n < cases.size(); ++n) {
    ReplyStream stream;
    Reply newest;
    int replies = 0;
    for (const auto& transfer : cases[n].transfers) replies += stream.take(transfer, newest);
    EXPECT_EQ(replies, cases[n].replies) << n;
    EXPECT_EQ(newest.encoders[0], cases[n].newest) << n;
  }
}

TEST(FalconPackets, StatusBytesAreNeverPartOfAReply) {
  // status bytes that look like the protocol's own
  const std::string a = "<BAAAAAAAAAAAAA>";
  for (std::size_t cut = 1; cut < a.size(); ++cut) {
    ReplyStream stream;
    Reply newest;
    std::vector<std::uint8_t> first{'<', '>'}, second{'>', '<'};
    first.insert(first.end(), a.begin(), a.begin() + long(cut));
    second.insert(second.end(), a.begin() + long(cut), a.end());
    EXPECT_EQ(stream.take(first, newest) + stream.take(second, newest), 1) << cut;
    EXPECT_EQ(newest.encoders[0], 1);
  }
}

TEST(FalconPackets, WhatIsClearedDoesNotEndLater) {
  ReplyStream stream;
  Reply newest;
  EXPECT_EQ(stream.take(transferOf("<BAAAAAAA"), newest), 0);
  stream.clear();
  EXPECT_EQ(stream.take(transferOf("AAAAAA>"), newest), 0);
}

}  // namespace
