// SPDX-License-Identifier: BSD-3-Clause
// Above 1 kHz a recording holds what went into a tick to the bit and what came out rounded, in at
// most twice the bytes of a second at 1 kHz.
#include <gtest/gtest.h>
#include <zlib.h>

#include <bit>
#include <cmath>
#include <limits>
#include <random>

#include "app/recording/number_columns.h"
#include "app/recording/recorder.h"
#include "datasets/edits/edited.h"
#include "haptics/servo/servo_tick.h"
#include "haptics/simulation/device_model.h"
#include "tests/support/made.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/sentence.h"
#include "tests/unit/app/recording/recorded_hand.h"

namespace recording_tests {
namespace {

using support::ScratchFolder;
using Bytes = std::vector<std::uint8_t>;
constexpr ServoRate kFast{4000};

// half a rounding, and what a double loses on the way
constexpr double kSlack = 1.0 + 1e-6;
constexpr double kHalfMetre = 0.5e-9 * kSlack, kHalfQuaternion = 0.5e-8 * kSlack;
constexpr double kHalfNewton = 0.5e-6 * kSlack, kHalfNewtonMetre = 0.5e-7 * kSlack;
constexpr double kFloatSlack = 1.05;  // contacts are float32 besides
constexpr double kHalfArm = 0.5e-7 * kFloatSlack, kHalfNormal = 0.5e-4 * kFloatSlack;
constexpr double kHalfPush = 0.5e-4 * kFloatSlack;

double farthest(const Vec3& a, const Vec3& b) { return (a - b).cwiseAbs().maxCoeff(); }

/// Bytes of the steps and their contacts, in blocks of what is written at once at 4 kHz.
std::size_t bytesIn(std::span<const Step> steps, Layout layout) {
  constexpr std::size_t kAtOnce = 1000;
  std::size_t bytes = 0;
  for (; !steps.empty(); steps = steps.subspan(std::min(kAtOnce, steps.size()))) {
    const Block block = encoded(steps.first(std::min(kAtOnce, steps.size())), layout);
    bytes += block.steps.size() + block.contacts.size();
  }
  return bytes;
}

// a loop at 4 kHz, limited and guarded as for a device: only at its own rate is it the same again
TEST(RecordingRates, HoldTheRateAndAreReplayedAtIt) {
  const ScratchFolder scratch;
  for (const ServoRate rate : kServoRates) {
    SCOPED_TRACE(rate.hz);
    const auto path = scratch / (std::to_string(rate.hz) + ".palpate");
    EXPECT_EQ(StepRing(0, rate).capacity(), 8192U * std::size_t(rate.hz) / 1000U);
    const std::int64_t ticks = std::llround(1.5 / rate.period());
    recorded(path, {.ticks = ticks,
                    .stiffness = 800.0,
                    .rate = rate,
                    .limits = limitsOf(*findRating("omega.6"))});
    EXPECT_EQ(formatOf(path), rate.hz == 1000 ? 2 : 4);
    auto recording = Recording::open(path);
    ASSERT_TRUE(recording) << sentence(recording.error());
    ASSERT_EQ(recording->starts().size(), 1U);
    EXPECT_EQ(recording->starts().front().rate, rate);
    EXPECT_NEAR(recording->end(), 1.5, 1.1 * rate.period());
    const ReplayDifference same = replayed(*recording, scene()->volume);
    EXPECT_EQ(same.steps, ticks);
    EXPECT_EQ(same.skipped, 0);
    EXPECT_EQ(same.differing, 0);
    // over another volume it is not the same
    const ReplayDifference other = replayed(*recording, scene(0.0149)->volume);
    EXPECT_GT(other.differing, 200);
    EXPECT_GT(other.distance, 0.00005);
  }
}

TEST(RecordingRates, WhatWentInIsExactAndWhatCameOutIsRounded) {
  const ScratchFolder scratch;
  for (const Linkage& linkage : {Linkage{}, findDeviceModel("omega.6")->linkage}) {
    const HandAtWork hand{.ticks = 8000, .friction = 0.3, .rate = kFast, .linkage = linkage};
    const std::vector<Step> was = worked(hand);
    recorded(scratch / "r.palpate", hand);
    auto recording = Recording::open(scratch / "r.palpate");
    ASSERT_TRUE(recording) << sentence(recording.error());
    const auto read = stepsIn(*recording);
    ASSERT_EQ(read.size(), was.size());
    std::size_t touching = 0, moved = 0;
    for (std::size_t i = 0; i < read.size(); ++i) {
      SCOPED_TRACE(i);
      const Step &now = read[i].step, &then = was[i];
      ASSERT_EQ(now.sequence, i);
      ASSERT_TRUE(same(now.X_WD, then.X_WD));
      ASSERT_EQ(read[i].device, numbersOf(then.X_WD));
      ASSERT_EQ(now.time_ns, then.time_ns);
      ASSERT_EQ(now.settings.friction, then.settings.friction);
      ASSERT_EQ(now.settings.stiffness, then.settings.stiffness);
      ASSERT_EQ(now.cut_at, then.cut_at);
      ASSERT_EQ(now.cpu_ns, then.cpu_ns);
      ASSERT_EQ(now.flags, then.flags);
      ASSERT_EQ(now.force_state, then.force_state);
      const PoseNumbers proxy = numbersOf(then.X_WP);
      for (std::size_t k = 0; k < proxy.size(); ++k)
        ASSERT_NEAR(read[i].proxy[k], proxy[k], k < 3 ? kHalfMetre : kHalfQuaternion);
      ASSERT_LE(farthest(now.sent_W.force, then.sent_W.force), kHalfNewton);
      ASSERT_LE(farthest(now.sent_W.torque, then.sent_W.torque), kHalfNewtonMetre);
      ASSERT_EQ(read[i].check, checkOf(proxy, then.sent_W));
      ASSERT_EQ(now.contacts.size(), then.contacts.size());
      for (std::size_t c = 0; c < now.contacts.size(); ++c) {
        ASSERT_LE(farthest(now.contacts[c].r_W, then.contacts[c].r_W), kHalfArm);
        ASSERT_LE(farthest(now.contacts[c].n_W, then.contacts[c].n_W), kHalfNormal);
        ASSERT_NEAR(now.contacts[c].push, then.contacts[c].push, kHalfPush);
      }
      touching += now.contacts.size();
      moved += read[i].proxy != proxy;
    }
    EXPECT_GT(touching, 2000U);
    EXPECT_GT(moved, 7000U);  // it is rounded indeed
  }
}

TEST(RecordingRates, TheCheckChangesWithEveryBit) {
  const Step step = worked({.ticks = 3000, .rate = kFast}).back();
  const PoseNumbers proxy = numbersOf(step.X_WP);
  const std::uint32_t check = checkOf(proxy, step.sent_W);
  const auto flipped = [](double number, int bit) {
    return std::bit_cast<double>(std::bit_cast<std::uint64_t>(number) ^ (std::uint64_t{1} << bit));
  };
  for (int bit = 0; bit < 64; ++bit) {
    for (std::size_t k = 0; k < proxy.size(); ++k) {
      PoseNumbers other = proxy;
      other[k] = flipped(other[k], bit);
      EXPECT_NE(checkOf(other, step.sent_W), check) << k << ' ' << bit;
    }
    for (int axis = 0; axis < 3; ++axis) {
      Wrench force = step.sent_W, torque = step.sent_W;
      force.force[axis] = flipped(force.force[axis], bit);
      torque.torque[axis] = flipped(torque.torque[axis], bit);
      EXPECT_NE(checkOf(proxy, force), check) << axis << ' ' << bit;
      EXPECT_NE(checkOf(proxy, torque), check) << axis << ' ' << bit;
    }
  }
}

// less than any rounding, so only the check can tell it
TEST(RecordingRates, AReplayCountsAStepInWhichOneBitDiffers) {
  const ScratchFolder scratch;
  constexpr std::uint64_t kChanged = 2345;
  const auto nextTo = [](double& number) { number = std::nextafter(number, 1e9); };
  for (const std::function<void(Step&)>& change : {
           std::function<void(Step&)>{[&](Step& s) { nextTo(s.X_WP.translation().y()); }},
           {[&](Step& s) { nextTo(s.sent_W.force.x()); }},
           {[&](Step& s) { nextTo(s.sent_W.torque.z()); }},
       }) {
    HandAtWork hand{.ticks = 3000, .rate = kFast};
    hand.change = [&](Step& step, std::int64_t n) {
      if (n == std::int64_t{kChanged}) change(step);
    };
    recorded(scratch / "r.palpate", hand);
    auto recording = Recording::open(scratch / "r.palpate");
    ASSERT_TRUE(recording) << sentence(recording.error());
    const ReplayDifference difference = replayed(*recording, scene()->volume);
    EXPECT_EQ(difference.steps, 3000);
    EXPECT_EQ(difference.differing, 1);
    EXPECT_EQ(difference.first, kChanged);
    EXPECT_LT(difference.distance, 2.0 * kHalfMetre);
    EXPECT_LT(difference.force, 2.0 * kHalfNewton);
  }
}

TEST(RecordingRates, BegunAt1KilohertzStaysExactAtWhatRateItGoesOn) {
  const ScratchFolder scratch;
  HandAtWork hand{.ticks = 3000, .rate = kFast};
  hand.rate_of_recorder = ServoRate{};
  const auto rows = recorded(scratch / "r.palpate", hand);
  EXPECT_EQ(formatOf(scratch / "r.palpate"), 2);
  auto recording = Recording::open(scratch / "r.palpate");
  ASSERT_TRUE(recording) << sentence(recording.error());
  const auto steps = stepsIn(*recording);
  ASSERT_EQ(steps.size(), rows.size());
  for (std::size_t i = 0; i < steps.size(); ++i) {
    ASSERT_EQ(steps[i].proxy, numbersOf(rows[i].X_WP));
    ASSERT_FALSE(steps[i].check);
  }
  EXPECT_EQ(replayed(*recording, scene()->volume).differing, 0);
}

TEST(RecordingRates, AnEditedVolumeDoesNotLowerTheFormat) {
  const ScratchFolder scratch;
  const auto before = scene();
  const std::vector<Edit> edits = {Crop{{{0, 0, 0}, {48, 48, 46}}}};
  const auto volume = edited(before->volume, edits);
  ASSERT_TRUE(volume) << sentence(volume.error());
  recorded(scratch / "r.palpate", {.ticks = 500, .rate = kFast}, *makeScene(*volume, before->tool));
  EXPECT_EQ(formatOf(scratch / "r.palpate"), 4);
  auto recording = Recording::open(scratch / "r.palpate");
  ASSERT_TRUE(recording) << sentence(recording.error());
  EXPECT_EQ(recording->scenes().front().edits.size(), 1U);
  EXPECT_EQ(replayed(*recording, *volume).differing, 0);
}

TEST(RecordingRates, ASecondTakesAtMostTwiceTheBytesOf1Kilohertz) {
  if (made::kSanitized) GTEST_SKIP() << "it counts bytes, which no sanitizer changes";
  constexpr double kSeconds = 4.0, kMostGrowth = 2.0;
  for (const char* device : {"", "omega.6"})
    for (const HandMotion motion : {HandMotion::Slide, HandMotion::Tap, HandMotion::Wedge,
                                    HandMotion::Pry, HandMotion::Hook}) {
      std::vector<double> bytes;
      for (const ServoRate rate : kServoRates) {
        HandAtWork hand{.motion = motion, .friction = 0.2, .rate = rate};
        hand.ticks = std::llround(kSeconds * rate.hz);
        if (const auto model = findDeviceModel(device)) hand.linkage = model->linkage;
        const auto layout = rate.hz > 1000 ? Layout::Rounded : Layout::Exact;
        const auto steps = worked(hand);
        EXPECT_EQ(std::int64_t(steps.size()), hand.ticks);
        bytes.push_back(double(bytesIn(steps, layout)) / kSeconds);
      }
      std::printf("%8s %d: %.0f, %.0f, %.0f bytes a second, %.2f and %.2f of the first\n", device,
                  int(motion), bytes[0], bytes[1], bytes[2], bytes[1] / bytes[0],
                  bytes[2] / bytes[0]);
      SCOPED_TRACE(int(motion));
      EXPECT_LE(bytes[1], kMostGrowth * bytes[0]);
      EXPECT_LE(bytes[2], kMostGrowth * bytes[0]);
    }
}

TEST(RecordingRates, WhatIsNoNumberIsReadAsNone) {
  Step step;
  step.sent_W.force = {std::numeric_limits<double>::infinity(), 1e12, 3.25};
  step.sent_W.torque.x() = std::numeric_limits<double>::quiet_NaN();
  const auto read = decoded(encoded(std::span{&step, 1}, Layout::Rounded), Layout::Rounded);
  ASSERT_TRUE(read);
  const Wrench& sent = read->front().step.sent_W;
  EXPECT_TRUE(std::isnan(sent.force.x()));
  EXPECT_TRUE(std::isnan(sent.force.y()));
  EXPECT_EQ(sent.force.z(), 3.25);
  EXPECT_TRUE(std::isnan(sent.torque.x()));
}

TEST(NumberColumns, AreReadAsTheyWereWritten) {
  std::mt19937_64 random(11);
  constexpr auto kMost = std::numeric_limits<std::uint64_t>::max();
  std::vector<std::vector<std::uint64_t>> columns = {
      {}, {0}, {kMost}, {0, kMost, 0, kMost, 1}, std::vector<std::uint64_t>(500, kMost / 2 + 1)};
  for (int bits = 1; bits <= 64; bits += 7) {
    auto& noise = columns.emplace_back();
    for (int i = 0; i < 300; ++i) noise.push_back(random() >> (64 - bits));
  }
  auto& smooth = columns.emplace_back();
  for (int i = 0; i < 300; ++i) smooth.push_back(std::bit_cast<std::uint64_t>(std::sin(0.01 * i)));
  for (const auto& column : columns) {
    Bytes bytes;
    putDifferences(column, bytes);
    EXPECT_LE(bytes.size(), mostColumnBytes(column.size()));
    bytes.push_back(7);  // what follows stays
    std::span<const std::uint8_t> rest{bytes};
    std::vector<std::uint64_t> read(column.size(), 99);
    ASSERT_TRUE(takeDifferences(rest, read));
    EXPECT_EQ(read, column);
    EXPECT_EQ(rest.size(), 1U);
  }
}

TEST(NumberColumns, DamageIsRefused) {
  std::vector<std::uint64_t> read(3);
  // nothing, too few, too often, more often than there are values, too wide
  for (const Bytes& bytes : {Bytes{}, Bytes{0}, Bytes{0, 1, 5, 5}, Bytes{1, 1, 0, 0, 0, 0, 0},
                             Bytes{6, 0}, Bytes{255, 0}, Bytes(60, 4), Bytes(60, 9)}) {
    std::span<const std::uint8_t> rest{bytes};
    EXPECT_FALSE(takeDifferences(rest, read)) << bytes.size();
  }
  // often enough for the values, but oftener than is ever written
  Bytes often(2 + 6 * sizeof(std::uint64_t));
  often[0] = 6;
  std::span<const std::uint8_t> rest{often};
  read.resize(10);
  EXPECT_FALSE(takeDifferences(rest, read));
}

TEST(RecordingRates, ADamagedBlockIsRefusedOrHasAsManyStepsAsItSays) {
  const auto steps = worked({.ticks = 400, .rate = kFast});
  const Block whole = encoded(steps, Layout::Rounded);
  ASSERT_TRUE(decoded(whole, Layout::Rounded));
  EXPECT_FALSE(decoded(whole, Layout::Exact));
  EXPECT_FALSE(decoded(encoded(steps, Layout::Exact), Layout::Rounded));
  Bytes bytes(1 << 20);
  uLongf size = bytes.size();
  ASSERT_EQ(uncompress(bytes.data(), &size, whole.steps.data(), whole.steps.size()), Z_OK);
  bytes.resize(size);
  const auto packed = [](const Bytes& plain) {
    uLongf packed_size = compressBound(plain.size());
    Bytes out(packed_size);
    compress2(out.data(), &packed_size, plain.data(), plain.size(), 1);
    out.resize(packed_size);
    return out;
  };
  std::mt19937 random(7);
  int refused = 0;
  for (int n = 0; n < 300; ++n) {
    Bytes damaged = bytes;
    if (n % 3 == 0) damaged.resize(random() % bytes.size());
    if (n % 3 == 1) damaged.push_back(0);
    for (int k = 0; k < n % 20 && !damaged.empty(); ++k)
      damaged[random() % damaged.size()] = static_cast<std::uint8_t>(random());
    Block block = whole;
    block.steps = packed(damaged);
    const auto read = decoded(block, Layout::Rounded);
    if (read)
      EXPECT_EQ(std::int64_t(read->size()), block.count);
    else
      ++refused;
  }
  EXPECT_GE(refused, 200);  // too few bytes, and too many
}

}  // namespace
}  // namespace recording_tests
