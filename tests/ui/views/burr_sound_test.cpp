// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <QCheckBox>
#include <QCoreApplication>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <numbers>
#include <span>
#include <vector>

#include "app/window/edits/cut_controller.h"
#include "app/window/scan/shared_state.h"
#include "app/window/sound/burr_player.h"
#include "app/window/sound/burr_tone.h"
#include "haptics/carving/burr.h"
#include "tests/ui/fake_program.h"
#include "tests/ui/window_support.h"

namespace {

using app::BurrPlayer;
using app::BurrRun;
using app::BurrTone;
using window::waitFor;
using Samples = std::vector<std::int16_t>;

constexpr int kBlock = 480;

/// What comes next, block by block, as a player asks for it.
Samples next(BurrTone& tone, const BurrRun& run, double seconds) {
  Samples all(static_cast<std::size_t>(seconds * BurrTone::kRate) / kBlock * kBlock);
  for (std::size_t n = 0; n < all.size(); n += kBlock)
    tone.fill(std::span{all}.subspan(n, kBlock), run);
  return all;
}

/// A second of a burr that has run for a while.
Samples steady(const BurrRun& run) {
  BurrTone tone;
  (void)next(tone, run, 0.5);
  return next(tone, run, 1.0);
}

double energyOf(std::span<const std::int16_t> samples) {
  double sum = 0.0;
  for (const double one : samples) sum += one * one;
  return sum;
}

/// The energy of a sine of this frequency in them; of whole periods, all of it.
double energyAt(const Samples& samples, double hertz, bool swelling = false) {
  double real = 0.0, imaginary = 0.0;
  const auto count = static_cast<double>(samples.size());
  for (std::size_t n = 0; n < samples.size(); ++n) {
    const double at = 2.0 * std::numbers::pi * static_cast<double>(n);
    const double value = samples[n] * (swelling ? 1.0 - std::cos(at / count) : 1.0);
    real += value * std::cos(at * hertz / BurrTone::kRate);
    imaginary += value * std::sin(at * hertz / BurrTone::kRate);
  }
  return 2.0 * (real * real + imaginary * imaginary) / count;
}

/// The strongest frequency within a tenth of this one.
double pitchNear(const Samples& samples, double hertz) {
  double best = 0.0, strongest = 0.0;
  for (double tried = 0.9 * hertz; tried < 1.1 * hertz; tried += 0.001 * hertz)
    if (const double energy = energyAt(samples, tried, true); energy > strongest) {
      strongest = energy;
      best = tried;
    }
  return best;
}

int steepest(std::span<const std::int16_t> samples) {
  int most = 0;
  for (std::size_t n = 1; n < samples.size(); ++n)
    most = std::max(most, std::abs(samples[n] - samples[n - 1]));
  return most;
}

TEST(BurrSound, ItsPitchIsHowOftenTheBurrTurnsAndFallsUnderLoad) {
  for (const double speed_rpm : {20'000.0, 60'000.0, 80'000.0, 100'000.0}) {
    SCOPED_TRACE(speed_rpm);
    const double turns = speed_rpm / 60.0;
    const Samples idle = steady({.turns = true, .speed_rpm = speed_rpm});
    EXPECT_NEAR(pitchNear(idle, turns), turns, 0.01 * turns);
    EXPECT_LT(energyAt(idle, 0.5 * turns, true), 1e-4 * energyAt(idle, turns, true));
    double before = turns;
    for (const double force : {0.5, 2.0, 10.0}) {
      const BurrRun run{.turns = true, .speed_rpm = speed_rpm, .force = force};
      const double expected = BurrTone::pitchOf(run);
      EXPECT_LT(expected, 0.99 * before);
      EXPECT_GT(expected, 0.85 * turns);
      EXPECT_NEAR(pitchNear(steady(run), expected), expected, 0.005 * expected);
      before = expected;
    }
  }
}

TEST(BurrSound, GrowsLouderAndRougherWithTheForceAndStaysWithinItsScale) {
  double before = 0.0, rough_before = 0.0;
  for (const double force : {0.0, 0.25, 0.5, 1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 1e6}) {
    SCOPED_TRACE(force);
    const BurrRun run{.turns = true, .speed_rpm = 96'060.0, .force = force};
    const Samples heard = steady(run);
    const double energy = energyOf(heard);
    EXPECT_GT(energy, 1.02 * before);
    before = energy;
    // above all partials there is noise alone
    double rough = 0.0;
    for (int k = 0; k < 200; ++k) rough += energyAt(heard, 14'000.0 + 31.0 * k, true);
    EXPECT_GT(rough, rough_before);
    rough_before = rough;
    const auto [low, high] = std::ranges::minmax(heard);
    EXPECT_LT(std::max(-low, int{high}), 31'000);
    EXPECT_GT(high, 2'000);
  }
}

TEST(BurrSound, HasNoPartialBeyondItsFlutes) {
  // 1601 turns in a second: a partial that were folded at half the rate would lie beside these
  const Samples heard = steady({.turns = true, .speed_rpm = 96'060.0});
  double partials = 0.0;
  for (int k = 1; k <= haptics::kBurrTeeth; ++k) partials += energyAt(heard, 1'601.0 * k);
  const double all = energyOf(heard);
  EXPECT_NEAR(partials / all, 1.0, 1e-5);
  EXPECT_GT(energyAt(heard, 1'601.0 * haptics::kBurrTeeth) / all, 0.01);
}

TEST(BurrSound, NeverJumpsWhateverChanges) {
  // without load, where the wave is smooth; and under load, where noise is in it
  for (const double force : {0.0, 20.0}) {
    SCOPED_TRACE(force);
    BurrTone fastest;
    const int slope =
        steepest(next(fastest, {.turns = true, .speed_rpm = 100'000.0, .force = force}, 20.0));
    BurrTone tone;
    Samples heard;
    const auto go = [&](const BurrRun& run, std::size_t count) {
      heard.resize(heard.size() + count);
      tone.fill(std::span{heard}.last(count), run);
    };
    std::size_t count = 1;
    for (int round = 0; round < 40; ++round) {
      for (const double speed_rpm : {100'000.0, 1'000.0, 60'000.0, 100'000.0}) {
        go({.turns = true, .speed_rpm = speed_rpm, .force = force * (round % 3) / 2.0}, count);
        count = count * 7 % 1'009;  // of any length
      }
      go({}, count);
      if (round % 4 == 0) go({}, BurrTone::kFade);
    }
    EXPECT_GT(slope, 500);
    // the swelling adds its own
    EXPECT_LE(steepest(heard), slope + 32'767 / BurrTone::kFade);
  }
}

TEST(BurrSound, IsSilentWhileTheBurrDoesNotTurnAndFadesWithinFiftyMilliseconds) {
  const BurrRun run{.turns = true, .speed_rpm = 60'000.0, .force = 5.0};
  const BurrRun rests{.turns = false, .speed_rpm = 60'000.0, .force = 5.0};
  BurrTone tone;
  EXPECT_EQ(energyOf(next(tone, rests, 0.5)), 0.0);
  const Samples begun = next(tone, run, 0.5);
  EXPECT_LT(std::abs(begun.front()), 20);
  EXPECT_GT(energyOf(std::span{begun}.last(4'800)), 0.0);
  const Samples ended = next(tone, rests, 0.5);
  constexpr std::size_t kFifty = BurrTone::kRate / 20;
  EXPECT_GT(energyOf(std::span{ended}.first(kFifty / 2)), 0.0);
  EXPECT_EQ(energyOf(std::span{ended}.subspan(kFifty)), 0.0);
}

Samples heardOf(const window::FakeProgram& program) {
  const QByteArray bytes = program.written("heard");
  Samples samples(static_cast<std::size_t>(bytes.size()) / sizeof(std::int16_t));
  std::memcpy(samples.data(), bytes.data(), samples.size() * sizeof(std::int16_t));
  return samples;
}

TEST(BurrSound, IsStreamedToAProgramWhileTheBurrTurns) {
  const window::FakeProgram program("paplay", window::kKeepsWhatItReads);
  ASSERT_TRUE(BurrPlayer::isPossible());
  BurrPlayer player;
  player.prepare();
  const BurrRun run{.turns = true, .speed_rpm = 60'000.0};
  ASSERT_TRUE(waitFor([&] {
    player.show(run);
    return heardOf(program).size() > 72'000;
  }));
  const Samples whine = [&] {
    const Samples all = heardOf(program);
    return Samples(all.begin() + 24'000, all.begin() + 72'000);
  }();
  EXPECT_NEAR(pitchNear(whine, 1'000.0), 1'000.0, 10.0);
  player.show({});
  const auto endsInSilence = [&] {
    const Samples all = heardOf(program);
    return energyOf(std::span{all}.last(4'800)) == 0.0;
  };
  EXPECT_TRUE(waitFor(endsInSilence));
  EXPECT_EQ(program.written("called"),
            "--raw --format=s16ne --channels=1 --rate=48000 --latency-msec=50 "
            "--client-name=Palpate\n");
  // nobody says that it still turns
  const std::size_t before = heardOf(program).size();
  player.show(run);
  ASSERT_TRUE(waitFor([&] { return heardOf(program).size() > before + 4'800; }));
  EXPECT_TRUE(waitFor(endsInSilence));
}

TEST(BurrSound, AProgramThatDoesNotReadGetsNoMoreThanItMayLeave) {
  const window::FakeProgram program("paplay", "exec sleep 600\n");
  BurrPlayer player;
  player.prepare();
  int most = 0;
  for (int n = 0; n < 1'000; ++n) {
    player.feed(kBlock);
    most = std::max(most, player.unread());
    QCoreApplication::processEvents();
  }
  EXPECT_EQ(most, BurrPlayer::kMostUnread);
}

TEST(BurrSound, AProgramThatIsGoneIsSilentAndStartedAgainByTheNextStroke) {
  const window::FakeProgram program("paplay", "echo >> \"$here/started\"\nexit 1\n");
  BurrPlayer player;
  const auto starts = [&] { return program.written("started").size(); };
  player.prepare();
  ASSERT_TRUE(waitFor([&] { return starts() == 1; }));
  for (int n = 0; n < 1'000; ++n) {
    player.feed(kBlock);
    ASSERT_LE(player.unread(), BurrPlayer::kMostUnread);
    QCoreApplication::processEvents();
  }
  // what it has left is not for the next
  ASSERT_TRUE(waitFor([&] {
    player.prepare();
    return starts() == 2;
  }));
  EXPECT_EQ(player.unread(), 0);
  ASSERT_TRUE(waitFor([&] {
    player.show({});
    player.show({.turns = true, .speed_rpm = 60'000.0});
    return starts() >= 3;
  }));
}

TEST(BurrSound, IsOfferedWhereAProgramPlaysIt) {
  const auto box = [](bool possible) {
    ui::MainWindow window;
    app::SharedState shared;
    const app::CutController cut(window, shared);
    const auto* sound = window.findChild<QCheckBox*>("burrSound");
    ASSERT_NE(sound, nullptr);
    EXPECT_FALSE(sound->isChecked());
    EXPECT_EQ(sound->isEnabled(), possible);
    EXPECT_EQ(sound->toolTip().startsWith("There is no program"), !possible);
  };
  {
    const window::FakeProgram program("aplay", window::kKeepsWhatItReads);
    box(true);
  }
  const QByteArray path = qgetenv("PATH");
  const QTemporaryDir nothing;
  qputenv("PATH", nothing.path().toUtf8());
  box(false);
  qputenv("PATH", path);
}

}  // namespace
