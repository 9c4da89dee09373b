// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/structures/near_sound.h"

#include <gtest/gtest.h>

#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <QtEndian>

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

/// A folder with a player that copies what it plays into `played`, and counts.
class Player {
 public:
  Player() {
    QFile program(folder_.filePath("pw-play"));
    EXPECT_TRUE(program.open(QIODevice::WriteOnly));
    program.write("#!/bin/sh\ncp \"$1\" '" + folder_.path().toUtf8() +
                  "/'\necho \"${1##*/}\" >> '" + log().toUtf8() + "'\n");
    program.close();
    program.setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
    qputenv("PATH", (folder_.path() + ":").toUtf8() + path_);
  }
  ~Player() { qputenv("PATH", path_); }

  QString log() const { return folder_.filePath("played"); }
  int played(const QByteArray& name) const {
    QFile file(log());
    return file.open(QIODevice::ReadOnly) ? int(file.readAll().count(name)) : 0;
  }
  QByteArray sound(const QString& name) const {
    QFile file(folder_.filePath(name));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray{};
  }

 private:
  QByteArray path_ = qgetenv("PATH");
  QTemporaryDir folder_;
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
  const QByteArray low = player.sound("near.wav"), high = player.sound("close.wav");
  EXPECT_TRUE(low.startsWith("RIFF") && low.mid(8, 8) == "WAVEfmt ");
  EXPECT_EQ(qFromLittleEndian<quint32>(low.data() + 40), quint32(low.size() - 44));
  EXPECT_NEAR(pitchOf(low), 660.0, 20.0);
  EXPECT_NEAR(pitchOf(high), 990.0, 20.0);
}

}  // namespace
