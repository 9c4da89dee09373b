// SPDX-License-Identifier: BSD-3-Clause
// From a recording to the ticks of which figures are made, and to the three files of a report.
#include "app/report/session.h"

#include <gtest/gtest.h>

#include <cmath>

#include "app/recording/felt_words.h"
#include "app/report/report.h"
#include "tests/support/made_distances.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/sentence.h"
#include "tests/unit/app/recording/recorded_hand.h"

namespace recording_tests {
namespace {

using app::report::Report;
using app::report::Session;
using app::report::sessionOf;
using app::report::Tick;
using app::report::Ticks;
using support::ScratchFolder;

/// The upper half of the ball and what is above it, and the lower one.
Watch halves(Grid grid, bool mirrored = false) {
  // the scan's voxels, and twenty more on each side
  for (std::int64_t& dim : grid.dims) dim += 40;
  grid.origin = grid.worldOf(Vec3::Constant(-20.0));
  const double up = mirrored ? -1.0 : 1.0;
  Watch watch;
  watch.structures.push_back(
      {0, made::distanceMap(grid, [&](const Vec3& p) { return -up * p.z() - 0.0001; })});
  watch.structures.push_back(
      {6, made::distanceMap(grid, [&](const Vec3& p) { return up * p.z() + 0.0001; })});
  return watch;
}

const auto kGoOn = [](double) { return true; };

TEST(RehearsalReport, TicksAreThoseOfTheRecording) {
  const ScratchFolder scratch;
  const auto touched = scene();
  const Watch watch = halves(touched->volume->grid);
  recorded(scratch / "r.palpate", HandMotion::Slide, 3000, 0.0, touched);
  auto recording = Recording::open(scratch / "r.palpate");
  ASSERT_TRUE(recording) << sentence(recording.error());
  Ticks ticks{*recording, watch, *touched->volume};
  const double half = 0.5 * touched->volume->grid.spacing.minCoeff();
  int bearing = 0, measured = 0;
  for (const RecordedStep& recorded : stepsIn(*recording)) {
    const Step& step = recorded.step;
    const Tick tick = ticks.of(recorded);
    ASSERT_TRUE(tick.known);
    ASSERT_EQ(tick.structures.size(), 2U);
    EXPECT_LE((tick.tip_W - step.X_WP * touched->tool.shell.tip).norm(), 1e-12);
    EXPECT_EQ(tick.force, step.sent_W.force.norm());
    // the planes' distances, of all points
    double lowest = INFINITY, highest = -INFINITY;
    bool within = true;  // the samples of the maps
    for (const Vec3& p : touched->tool.shell.points) {
      lowest = std::min(lowest, (step.X_WP * p).z());
      highest = std::max(highest, (step.X_WP * p).z());
      within = within && (step.X_WP * p).cwiseAbs().maxCoeff() < 0.043;
    }
    if (within) {
      ++measured;
      const auto told = [](double distance) { return std::clamp(distance, -0.030, 0.020); };
      EXPECT_NEAR(double(tick.structures[0].nearest), told(-highest - 0.0001), 2e-6);
      EXPECT_NEAR(double(tick.structures[1].nearest), told(lowest + 0.0001), 2e-6);
      EXPECT_NEAR(double(tick.structures[1].tip), told(tick.tip_W.z() + 0.0001), 2e-6);
    }
    double pushes[2] = {0.0, 0.0};
    for (const BearingContact& contact : step.contacts) {
      const Vec3 p = step.X_WP.translation() + contact.r_W - half * contact.n_W;
      const Grid& grid = touched->volume->grid;
      const Vec3 voxel = grid.worldOf(grid.indexOf(p).array().round().matrix());
      pushes[voxel.z() > -0.0001 ? 0 : 1] += contact.push;
    }
    for (std::size_t n = 0; n < 2; ++n) {
      EXPECT_DOUBLE_EQ(tick.structures[n].push, pushes[n]);
      bearing += pushes[n] > 0.0;
    }
    EXPECT_EQ(tick.touches, !step.contacts.empty());
  }
  EXPECT_GT(bearing, 100);
  EXPECT_GT(measured, 100);
  EXPECT_EQ(ticks.compared, 0);
}

TEST(RehearsalReport, KnowsAnotherLabelMapByTheRecordedDistances) {
  const ScratchFolder scratch;
  const auto touched = scene();
  const Watch watch = halves(touched->volume->grid);
  for (const int hz : {1000, 4000}) {
    recorded(scratch / "r.palpate", {.ticks = 2000, .rate = {hz}, .change = [&](Step& step, auto) {
                                       measure(watch, *touched, step.X_WP, step.near);
                                     }});
    auto recording = Recording::open(scratch / "r.palpate");
    ASSERT_TRUE(recording) << sentence(recording.error());
    const auto same = sessionOf(*recording, watch, touched->volume, {}, {{}, {}}, kGoOn);
    ASSERT_TRUE(same) << sentence(same.error());
    EXPECT_EQ(same->compared, 4000);
    EXPECT_EQ(same->differing, 0);
    const Watch other = halves(touched->volume->grid, true);
    EXPECT_GT(sessionOf(*recording, other, touched->volume, {}, {{}, {}}, kGoOn)->differing, 200);
  }
}

TEST(RehearsalReport, StepsOverAnotherScanAreNotKnown) {
  const ScratchFolder scratch;
  const auto touched = scene();
  recorded(scratch / "r.palpate", HandMotion::Tap, 500, 0.0, touched);
  auto recording = Recording::open(scratch / "r.palpate");
  Volume other = *touched->volume;
  other.grid.origin.x() += 1e-3;
  const Watch watch = halves(touched->volume->grid);
  const auto session =
      sessionOf(*recording, watch, std::make_shared<const Volume>(other), {}, {{}, {}}, kGoOn);
  ASSERT_TRUE(session);
  EXPECT_GT(session->figures.time, 0.4);
  EXPECT_NEAR(session->figures.unknown, session->figures.time, 1e-9);
  EXPECT_EQ(session->figures.path, 0.0);
  EXPECT_TRUE(session->tools.empty());
}

TEST(RehearsalReport, EndsWhenItIsToldTo) {
  const ScratchFolder scratch;
  const auto touched = scene();
  recorded(scratch / "r.palpate", HandMotion::Tap, 500, 0.0, touched);
  auto recording = Recording::open(scratch / "r.palpate");
  const Watch watch = halves(touched->volume->grid);
  const auto session =
      sessionOf(*recording, watch, touched->volume, {}, {{}, {}}, [](double) { return false; });
  ASSERT_FALSE(session);
  EXPECT_EQ(session.error().reason, "cancelled");
}

TEST(RehearsalReport, SaysTheSameInThreeFormats) {
  const ScratchFolder scratch;
  const auto touched = scene();
  const Watch watch = halves(touched->volume->grid);
  recorded(scratch / "r.palpate", HandMotion::Slide, 2000, 0.0, touched);
  auto recording = Recording::open(scratch / "r.palpate");
  Report report;
  report.structures = {{1, "<own> & name", 0.0005, 0.020, {0.001, 0.0025}},
                       {7, {}, 0.0005, 0.020, {0.002}}};
  for (int n = 0; n < 2; ++n)
    report.sessions.push_back(
        *sessionOf(*recording, watch, touched->volume, {}, {{0.001, 0.0025}, {0.002}}, kGoOn));
  report.sessions[1].guarded[0] = true;
  const auto json = jsonOf(report);
  const std::string csv = csvOf(report), html = htmlOf(report);
  ASSERT_EQ(json["sessions"].size(), 2U);
  EXPECT_EQ(json["structures"][0]["name"], "<own> & name");
  EXPECT_TRUE(json["sessions"][1]["structures"][0]["guarded"]);
  const auto& figures = report.sessions[0].figures;
  EXPECT_EQ(json["sessions"][0]["path_mm"], 1e3 * figures.path);
  EXPECT_EQ(json["sessions"][0]["force_largest_N_at_s"], figures.largest_force.at);
  EXPECT_EQ(json["sessions"][0]["structures"][1]["within"][0]["margin_mm"], 2.0);
  // a row for each figure, and every figure has its definition
  const auto rows = std::ranges::count(csv, '\n');
  EXPECT_EQ(rows, 1 + 2 * std::ssize(app::report::figuresOfSessions()) +
                      2 * 2 * std::ssize(app::report::figuresOfStructures()) + 2 * 3);
  for (const auto& definition : json["definitions"])
    EXPECT_NE(csv.find("," + definition["figure"].get<std::string>() + ","), std::string::npos);
  EXPECT_NE(html.find("Structure 1: &lt;own&gt; &amp; name"), std::string::npos);
  EXPECT_EQ(html.find("<own>"), std::string::npos);
  EXPECT_NE(html.find("session 2"), std::string::npos);
  for (const char* fetched : {"<script", "src=", "href=", "url("})
    EXPECT_EQ(html.find(fetched), std::string::npos) << fetched;
}

}  // namespace
}  // namespace recording_tests
