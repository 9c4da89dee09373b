// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/structures/near_sound.h"

#include <gtest/gtest.h>

#include <QTest>
#include <QtEndian>

#include "tests/ui/fake_program.h"

namespace {

using app::NearSound;
using ui::NearLimits;
using ui::StructureNear;

constexpr NearLimits kLimits{.near_mm = 5.0, .close_mm = 2.0};

TEST(NearSound, ComesSoonerTheNearerItIs) {
  EXPECT_FALSE(NearSound::pauseAt(5.01, kLimits));
  EXPECT_EQ(NearSound::pauseAt(5.0, kLimits), 900);
  EXPECT_EQ(NearSound::pauseAt(3.5, kLimits), 525);
  EXPECT_EQ(NearSound::pauseAt(2.0, kLimits), 150);
  EXPECT_EQ(NearSound::pauseAt(-4.0, kLimits), 150);
  EXPECT_EQ(NearSound::pauseAt(1.0, {.near_mm = 2.0, .close_mm = 2.0}), 150);
}

/// A player that copies what it plays, and counts.
class Player : public window::FakeProgram {
 public:
  Player()
      : FakeProgram("pw-play", "cp \"$1\" \"$here\"\necho \"${1##*/}\" >> \"$here/played\"\n") {}

  int played(const QByteArray& name) const { return int(written("played").count(name)); }
};

/// How often the samples of a sound turn upwards through zero, in a second.
double pitchOf(const QByteArray& wav) {
  const auto at = [&](qsizetype byte) { return qFromLittleEndian<qint16>(wav.data() + byte); };
  int rises = 0;
  for (qsizetype byte = 46; byte + 1 < wav.size(); byte += 2)
    rises += at(byte - 2) < 0 && at(byte) >= 0;
  const double seconds =
      double(wav.size() - 44) / (2.0 * qFromLittleEndian<quint32>(wav.data() + 24));
  return rises / seconds;
}

TEST(NearSound, IsPlayedWhileItIsOnAndSomethingIsNear) {
  const Player player;
  ASSERT_TRUE(NearSound::isPossible());
  NearSound sound;
  const std::vector<StructureNear> close{{"a", {}, 1.0, false}, {"b", {}, 20.0, true}};
  const std::vector<StructureNear> near{{"a", {}, 4.9, false}};
  sound.show(close, kLimits);
  QTest::qWait(300);
  EXPECT_EQ(player.played("wav"), 0);  // off at first
  sound.setOn(true);
  ASSERT_TRUE(QTest::qWaitFor([&] { return player.played("close.wav") >= 3; }, 60'000));
  EXPECT_EQ(player.played("near.wav"), 0);
  sound.show(near, kLimits);
  ASSERT_TRUE(QTest::qWaitFor([&] { return player.played("near.wav") >= 1; }, 60'000));
  for (const std::vector<StructureNear>& none :
       {std::vector<StructureNear>{}, {{"b", {}, 20.0, true}}}) {
    sound.show(near, kLimits);
    EXPECT_TRUE(sound.isBeeping());
    sound.show(none, kLimits);
    EXPECT_FALSE(sound.isBeeping());
  }
  sound.show(near, kLimits);
  sound.setOn(false);
  EXPECT_FALSE(sound.isBeeping());
  const QByteArray low = player.written("near.wav"), high = player.written("close.wav");
  EXPECT_TRUE(low.startsWith("RIFF") && low.mid(8, 8) == "WAVEfmt ");
  EXPECT_EQ(qFromLittleEndian<quint32>(low.data() + 40), quint32(low.size() - 44));
  EXPECT_NEAR(pitchOf(low), 660.0, 20.0);
  EXPECT_NEAR(pitchOf(high), 990.0, 20.0);
}

}  // namespace
