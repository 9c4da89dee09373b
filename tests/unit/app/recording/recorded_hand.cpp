// SPDX-License-Identifier: BSD-3-Clause
#include "tests/unit/app/recording/recorded_hand.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <fstream>
#include <thread>

#include "app/recording/recorder.h"
#include "tests/support/sentence.h"

namespace recording_tests {

namespace fs = std::filesystem;

std::shared_ptr<const Scene> scene(double radius) {
  constexpr std::int64_t kSide = 48;
  Grid grid;
  grid.dims = {kSide, kSide, kSide};
  grid.spacing = Vec3::Constant(0.001);
  auto voxels = *allocateVoxels(grid.voxelCount(), ScalarType::Float32);
  auto* f = static_cast<float*>(voxels.get());
  for (std::int64_t n = 0; n < grid.voxelCount(); ++n) {
    const Vec3 index(double(n % kSide), double(n / kSide % kSide), double(n / kSide / kSide));
    const Vec3 p = (index - Vec3::Constant(0.5 * double(kSide - 1))) * 0.001;
    const double ripple = 0.0005 * std::sin(p.x() * 3000.0) * std::sin(p.y() * 2000.0);
    f[n] = static_cast<float>((radius - p.norm() + ripple) * 1e4);
  }
  auto volume = std::make_shared<const Volume>(*makeVolume(grid, ScalarType::Float32, voxels));
  std::vector<Vec3> points;
  for (int i = 0; i < 400; ++i) {
    const double z = 1.0 - 2.0 * (i + 0.5) / 400.0, phi = 2.399963 * i;
    const double r = std::sqrt(1.0 - z * z);
    points.emplace_back(0.004 * r * std::cos(phi), 0.004 * r * std::sin(phi), 0.006 * z);
  }
  Tool tool;
  tool.name = "egg";
  tool.shell = *makeShell(points);
  return *makeScene(volume, tool);
}

namespace {

Step stepOf(const TraceRow& row, const ClosedLoop& loop, std::int64_t n) {
  Step step;
  step.time_ns = n * loop.rate.period_ns();
  step.X_WD = row.X_WD;
  step.X_WP = row.X_WP;
  step.sent_W = row.sent_W;
  step.settings = loop.settings;
  step.scene = static_cast<std::uint32_t>(loop.scene->id);
  step.cut_at = row.cut_at;
  step.cpu_ns = 10 * row.work;  // as counted, so that two runs give the same
  step.flags = StepFlags::kArmed;
  step.force_state = ForceState::On;
  step.contacts = row.bearing;
  return step;
}

/// In closed loop, tick by tick.
void work(const HandAtWork& at_work, std::shared_ptr<const Scene> touched,
          const std::function<void(const ProxyStart&)>& on_start,
          const std::function<void(const TraceRow&, Step&)>& each) {
  ClosedLoop loop{std::move(touched),
                  {.stiffness = at_work.stiffness, .friction = at_work.friction},
                  at_work.limits,
                  {}};
  loop.rate = at_work.rate;
  loop.linkage = at_work.linkage;
  loop.grip.gyration = std::sqrt(loop.scene->tool.shell.inertia.trace() / 3.0);
  loop.on_start = [&](const Pose& X_WP) {
    on_start({.scene = static_cast<std::uint32_t>(loop.scene->id),
              .X_WP = X_WP,
              .limits = loop.limits,
              .safety = {},
              .rate = loop.rate});
  };
  const auto hand = Hand::aimed(at_work.motion, *loop.scene, 0.0, 0.012, 1);
  EXPECT_TRUE(hand);
  std::int64_t n = 0;
  EXPECT_TRUE(loop.run(*hand, at_work.ticks, [&](const TraceRow& row) {
    Step step = stepOf(row, loop, n);
    if (at_work.change) at_work.change(step, n);
    ++n;
    each(row, step);
    return true;
  }));
}

}  // namespace

std::vector<Step> worked(const HandAtWork& at_work) {
  std::vector<Step> steps;
  work(
      at_work, scene(), [](const ProxyStart&) {},
      [&](const TraceRow&, Step& step) {
        step.sequence = steps.size();
        steps.push_back(step);
      });
  return steps;
}

std::vector<TraceRow> recorded(const fs::path& path, const HandAtWork& at_work,
                               std::shared_ptr<const Scene> touched) {
  fs::remove(path);
  auto recorder = Recorder::create(path, {"test", "a build", "a machine"},
                                   {.rate = at_work.rate_of_recorder.value_or(at_work.rate)});
  EXPECT_TRUE(recorder) << sentence(recorder.error());
  StepRing& ring = (*recorder)->ring();
  (*recorder)->describe(touched, "egg");
  std::vector<TraceRow> rows;
  work(
      at_work, touched, [&](const ProxyStart& start) { ring.start(start); },
      [&](const TraceRow& row, Step& step) {
        while (ring.full()) {
          (*recorder)->hurry();
          std::this_thread::yield();
        }
        EXPECT_TRUE(ring.push(step));
        rows.push_back(row);
      });
  const auto finished = (*recorder)->finish();
  EXPECT_TRUE(finished) << sentence(finished.error());
  return rows;
}

std::vector<RecordedStep> stepsIn(Recording& recording) {
  std::vector<RecordedStep> steps;
  const auto read = recording.forEach(-kEver, kEver, [&](const RecordedStep& step) {
    steps.push_back(step);
    return true;
  });
  EXPECT_TRUE(read) << sentence(read.error());
  return steps;
}

ReplayDifference replayed(Recording& recording, std::shared_ptr<const Volume> volume) {
  const auto difference = replay(
      recording,
      [&](std::uint32_t id) {
        const RecordedScene* then = recording.scene(id);
        return then == nullptr ? nullptr : *makeScene(volume, then->tool, then->options);
      },
      [](double) { return true; });
  EXPECT_TRUE(difference) << sentence(difference.error());
  return difference.value_or(ReplayDifference{});
}

bool same(const Pose& a, const Pose& b) {
  return std::memcmp(a.matrix().data(), b.matrix().data(), 16 * sizeof(double)) == 0;
}

int formatOf(const fs::path& path) {
  std::ifstream file{path, std::ios::binary};
  file.seekg(60);
  std::array<char, 4> bytes{};
  file.read(bytes.data(), 4);
  return bytes[3];
}

}  // namespace recording_tests
