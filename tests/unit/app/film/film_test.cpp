// SPDX-License-Identifier: BSD-3-Clause
// What a film shows. Needs an X display with GLX, and ffmpeg to look into what was written.
#include "app/film/film.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "app/film/stage.h"
#include "app/recording/carved_copy.h"
#include "recorded_film.h"
#include "tests/support/sentence.h"

namespace {

using namespace film;

TEST_F(Film, ShowsToolAndDeviceWhereEachStepHadThem) {
  auto recording = recorded(scratch, {});
  const auto film = app::makeFilm(recording, none, scratch / "f.mp4", options());
  ASSERT_TRUE(film) << sentence(film.error());
  EXPECT_EQ(film->film, scratch / "f.mp4");
  EXPECT_EQ(film->codec, "h264");
  EXPECT_EQ(film->frames, 30);
  EXPECT_DOUBLE_EQ(film->seconds, 1.5);
  EXPECT_EQ(scratch.names(), (std::vector<std::string>{"f.frames.csv", "f.mp4", "r.palpate"}));
  EXPECT_TRUE(childless());
  const Decoded pictures = decoded(film->film);
  const auto rows = rowsOf(film->times);
  ASSERT_EQ(pictures.frames.size(), 30U);
  ASSERT_EQ(rows.size(), 30U);
  double proxy_off = 0.0, device_off = 0.0;  // pixels
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(rows[i].sequence, std::int64_t(i) * 50);
    const Step step = stepAt(rows[i].sequence);
    const auto proxy = projected(front(), step.X_WP.translation());
    const auto seen = pictures.centroid(i, proxyColoured);
    proxy_off = std::max(proxy_off, std::hypot(seen[0] - proxy[0], seen[1] - proxy[1]));
    const auto device = projected(front(), step.X_WD.translation());
    // drawn above the proxy, and where it crosses it the colours mix
    if (std::hypot(device[0] - proxy[0], device[1] - proxy[1]) < 40.0) continue;
    const auto wire = pictures.centroid(i, deviceColoured);
    device_off = std::max(device_off, std::hypot(wire[0] - device[0], wire[1] - device[1]));
  }
  std::printf("proxy at most %.2f, device %.2f pixels from where it was\n", proxy_off, device_off);
  EXPECT_LT(proxy_off, 1.0);
  EXPECT_LT(device_off, 2.0);  // thin lines, and colours at half the resolution
}

TEST_F(Film, ShowsTheLastStepAtOrBeforeTheTimeOfEachFrame) {
  Session session;
  session.first = 700;  // begins late, in uneven steps
  session.steps = 1100;
  session.step = [](std::int64_t n) {
    Step step = stepAt(n % 1500);
    step.time_ns = n * 1'000'000 + (n * 7919) % 900'000;
    return step;
  };
  auto recording = recorded(scratch, session);
  std::vector<std::pair<std::int64_t, std::int64_t>> steps;
  ASSERT_TRUE(recording.forEach(-1.0, 1e9, [&](const app::RecordedStep& step) {
    steps.emplace_back(step.step.sequence, step.step.time_ns);
    return true;
  }));
  ASSERT_EQ(steps.size(), 1100U);
  FilmOptions chosen = options();
  chosen.from = 0.9;
  chosen.to = 1.5;
  chosen.speed = 0.37;
  const auto film = app::makeFilm(recording, none, scratch / "f", chosen);
  ASSERT_TRUE(film) << sentence(film.error());
  EXPECT_EQ(film->film, scratch / "f.mp4");
  const auto rows = rowsOf(film->times);
  ASSERT_EQ(rows.size(), 33U);  // 0.6 s at 0.37 / 20
  EXPECT_EQ(decoded(film->film).frames.size(), rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double time = 0.9 + double(i) * 0.37 / 20.0;
    std::pair<std::int64_t, std::int64_t> last = steps.front();
    for (const auto& step : steps)
      if (double(step.second) <= time * 1e9 + 0.5) last = step;
    EXPECT_EQ(rows[i].frame, std::int64_t(i));
    EXPECT_EQ(rows[i].sequence, last.first);
    EXPECT_EQ(rows[i].time_ns, last.second);
    EXPECT_DOUBLE_EQ(rows[i].film_time, double(i) / 20.0);
  }
  // before the first step there is the first
  chosen.from = -5.0;
  chosen.to = 0.75;
  const auto early = app::makeFilm(recording, none, scratch / "g", chosen);
  ASSERT_TRUE(early) << sentence(early.error());
  EXPECT_EQ(rowsOf(early->times).front().sequence, 0);
}

TEST_F(Film, DrawsTheSurfaceAtTheIsovalueOfEachStep) {
  for (const ui::SurfaceMode mode : {ui::SurfaceMode::Mesh, ui::SurfaceMode::RayCast}) {
    SCOPED_TRACE(mode == ui::SurfaceMode::Mesh ? "mesh" : "ray caster");
    Session session;
    session.step = [](std::int64_t n) {
      Step step = stepAt(n);
      // one behind the ball, the other inside
      step.X_WP = at(0.0, 25.0, 0.0);
      step.X_WD = at(0.0, 0.0, 0.0);
      return step;
    };
    auto recording = recorded(scratch, session);
    FilmOptions chosen = options();
    chosen.surface = mode;
    chosen.frames_per_second = 10;
    const auto film = app::makeFilm(
        recording, [&](std::uint32_t) { return session.scene->volume; }, scratch / "f", chosen);
    ASSERT_TRUE(film) << sentence(film.error());
    EXPECT_EQ(film->surface, mode);
    const Decoded pictures = decoded(film->film);
    ASSERT_EQ(pictures.frames.size(), 15U);
    for (std::size_t i = 0; i < 15; ++i) {
      EXPECT_EQ(pictures.count(i, proxyColoured), 0) << i;
      EXPECT_GT(pictures.count(i, deviceColoured), 30) << i;
      // 12 mm at 50, 4 mm at 90: as a disk whose edge is where the line of sight touches it
      const double radius_mm = i <= 7 ? 12.0 : 4.0;
      const double slope = radius_mm / std::sqrt(160.0 * 160.0 - radius_mm * radius_mm);
      const double radius = 0.5 * kHeight * slope / std::tan(12.5 * std::numbers::pi / 180.0);
      const double disk = std::numbers::pi * radius * radius;
      const double seen = pictures.count(i, surfaceColoured) + pictures.count(i, deviceColoured);
      EXPECT_NEAR(seen / disk, 1.0, i <= 7 ? 0.08 : 0.35) << i;
    }
  }
}

/// Half a second of cuts, from 0.5 s on: a ball of 4 mm on its way up at the front of the surface.
/// Tool and device are out of the picture.
Step stepThatCuts(std::int64_t n) {
  Step step = stepAt(n);
  step.settings.isovalue = 50.0;
  step.X_WP = step.X_WD = at(0.0, 500.0, 0.0);
  const auto placeAt = [](std::int64_t step_n) {
    return Vec3(0.0, -0.012, -0.006 + 12e-6 * double(step_n - 500));
  };
  if (n >= 500 && n < 1000)
    step.cut = {.from_W = placeAt(n - 1), .to_W = placeAt(n), .radius = 0.004, .isovalue = 50.0};
  return step;
}

int apart(Colour p, Colour q) {
  return std::max({std::abs(p.r - q.r), std::abs(p.g - q.g), std::abs(p.b - q.b)});
}

TEST_F(Film, ShowsWhatWasCutUntilEachFrame) {
  for (const ui::SurfaceMode mode : {ui::SurfaceMode::Mesh, ui::SurfaceMode::RayCast}) {
    SCOPED_TRACE(mode == ui::SurfaceMode::Mesh ? "mesh" : "ray caster");
    Session session;
    session.step = [](std::int64_t n) {
      Step step = stepThatCuts(n);
      step.cut.reset();
      return step;
    };
    FilmOptions chosen = options();
    chosen.surface = mode;
    const auto volume = [&](std::uint32_t) { return session.scene->volume; };
    auto uncut = recorded(scratch, session);
    const auto whole = app::makeFilm(uncut, volume, scratch / "whole", chosen);
    session.step = stepThatCuts;
    auto recording = recorded(scratch, session);
    ASSERT_TRUE(recording.isCut());
    const auto film = app::makeFilm(recording, volume, scratch / "cut", chosen);
    ASSERT_TRUE(whole && film);
    const Decoded a = decoded(whole->film), b = decoded(film->film);
    ASSERT_EQ(a.frames.size(), 30U);
    ASSERT_EQ(b.frames.size(), 30U);
    int fewest = kWidth * kHeight;
    for (std::size_t i = 0; i < b.frames.size(); ++i) {
      // the highest place that the burr has reached, and what the encoder makes of its edge
      const std::int64_t n = std::min<std::int64_t>(std::int64_t(i) * 50, 999);
      const double top = n < 500 ? -20.0 : -6.0 + 0.012 * double(n - 500) + 4.0;
      const int above = int(projected(front(), Vec3(0.0, -0.0154, top * 1e-3))[1]) - 8;
      int changed = 0, beyond = 0;
      for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
          const bool other = apart(a.pixel(i, x, y), b.pixel(i, x, y)) > 24;
          changed += other;
          beyond += other && (y < above || std::abs(x - kWidth / 2) > 24);
        }
      EXPECT_EQ(beyond, 0) << i;
      if (n < 500) {
        EXPECT_EQ(changed, 0) << i;
      }
      if (n >= 550) fewest = std::min(fewest, changed);
    }
    EXPECT_GT(fewest, 100);
    // in the window's colour
    const auto coral = [](Colour c) { return c.r > c.g + 45 && c.r > c.b + 45 && c.r > 100; };
    EXPECT_LT(b.count(9, coral), 30);
    EXPECT_GT(b.count(29, coral), 300);
  }
}

TEST_F(Film, OfCutsShowsNoMoreThanThatInSlicesAndUntilAnotherVolume) {
  const auto volume = ball();
  const haptics::BurrCut cut = *stepThatCuts(750).cut;
  for (const ui::SurfaceMode mode : {ui::SurfaceMode::Mesh, ui::SurfaceMode::RayCast}) {
    auto stage = app::FilmStage::open(kWidth, kHeight, mode, {.tint = false, .slices = true});
    ASSERT_TRUE(stage) << sentence(stage.error());
    const haptics::Tool tool = octahedron();
    (*stage)->show(&tool);
    (*stage)->show(volume);
    (*stage)->look(front());
    Step step = stepThatCuts(0);
    step.X_WP = at(0.0, -12.0, 0.0);
    const auto whole = (*stage)->draw(step).rgb;
    app::CarvedCopy copy{volume};
    ASSERT_TRUE(copy.open());
    (*stage)->showLive(copy.volume());
    EXPECT_EQ((*stage)->draw(step).rgb, whole);
    const auto done = copy.carve(cut);
    ASSERT_TRUE(done && done->removed.voxels > 0);
    (*stage)->carve(done->box);
    const auto carved = (*stage)->draw(step).rgb;
    const int column = kHeight / 6 * 2;
    int in_surface = 0, in_slices = 0;
    for (std::size_t n = 0; n < whole.size(); ++n)
      (int(n / 3) % kWidth < kWidth - column ? in_surface : in_slices) += whole[n] != carved[n];
    EXPECT_GT(in_surface, 100);
    EXPECT_GT(in_slices, 100);
    (*stage)->show(volume);
    EXPECT_EQ((*stage)->draw(step).rgb, whole);
  }
}

TEST_F(Film, GoesFromCameraToCamera) {
  const FilmCamera side{{170, 20, 10}, {0, 0, 5}, {0, 0, 1}, 20.0};
  Session session;
  session.cameras = {
      {400'000'000, wordsOf(front())}, {800'000'000, wordsOf(side)}, {1'200'000'000, "nonsense"}};
  auto recording = recorded(scratch, session);
  const auto film = app::makeFilm(
      recording, [&](std::uint32_t) { return session.scene->volume; }, scratch / "f", options());
  ASSERT_TRUE(film) << sentence(film.error());
  const Decoded pictures = decoded(film->film);
  ASSERT_EQ(pictures.frames.size(), 30U);
  for (std::size_t i = 0; i < 30; ++i) {
    const FilmCamera camera = i < 16 ? front() : side;  // before the first: the first
    const auto proxy = projected(camera, stepAt(std::int64_t(i) * 50).X_WP.translation());
    const auto seen = pictures.centroid(i, proxyColoured);
    EXPECT_NEAR(seen[0], proxy[0], 1.5) << i;
    EXPECT_NEAR(seen[1], proxy[1], 1.5) << i;
    // the ball as a disk, but for the tool before it
    const double radius_mm = i < 15 ? 12.0 : 4.0, away = camera.position_mm.norm();
    const double slope = radius_mm / std::sqrt(away * away - radius_mm * radius_mm);
    const double half = std::tan(0.5 * camera.angle_deg * std::numbers::pi / 180.0);
    const double radius = 0.5 * kHeight * slope / half;
    const int covered = pictures.count(i, proxyColoured) + pictures.count(i, deviceColoured);
    const double disk = std::numbers::pi * radius * radius;
    EXPECT_GT(pictures.count(i, surfaceColoured), 0.9 * disk - covered) << i;
    EXPECT_LT(pictures.count(i, surfaceColoured), 1.1 * disk) << i;
  }
  // and where that is not wanted, one of its own
  FilmOptions chosen = options();
  chosen.recorded_camera = false;
  const auto own = app::makeFilm(recording, none, scratch / "g", chosen);
  ASSERT_TRUE(own) << sentence(own.error());
  const auto proxy = projected(front(), stepAt(1400).X_WP.translation());
  const auto seen = decoded(own->film).centroid(28, proxyColoured);
  EXPECT_NEAR(seen[0], proxy[0], 1.5);
  EXPECT_NEAR(seen[1], proxy[1], 1.5);
}

TEST_F(Film, WithoutACameraSeesSurfaceAndToolWhole) {
  const Session session;
  auto recording = recorded(scratch, session);
  FilmOptions chosen = options();
  chosen.camera.reset();
  for (const bool surface : {true, false}) {
    const auto film = app::makeFilm(
        recording, [&](std::uint32_t) { return surface ? session.scene->volume : nullptr; },
        scratch / "f", chosen);
    ASSERT_TRUE(film) << sentence(film.error());
    const Decoded pictures = decoded(film->film);
    for (std::size_t i = 0; i < pictures.frames.size(); ++i) {
      EXPECT_GT(pictures.count(i, deviceColoured), 20) << i;
      for (int x = 0; x < kWidth; ++x)
        for (const int y : {0, kHeight - 1}) {
          const Colour c = pictures.pixel(i, x, y);
          ASSERT_FALSE(proxyColoured(c) || deviceColoured(c) || surfaceColoured(c)) << i;
        }
    }
  }
}

TEST_F(Film, BurnsTimeAndForceIntoItsCornersAlone) {
  const Session session;
  auto recording = recorded(scratch, session);
  FilmOptions chosen = options();
  const auto volume = [&](std::uint32_t) { return session.scene->volume; };
  const auto plain = app::makeFilm(recording, volume, scratch / "plain", chosen);
  chosen.burn_in = true;
  const auto burnt = app::makeFilm(recording, volume, scratch / "burnt", chosen);
  ASSERT_TRUE(plain && burnt);
  const Decoded a = decoded(plain->film), b = decoded(burnt->film);
  ASSERT_EQ(a.frames.size(), b.frames.size());
  int changed = 0, from_frame_to_frame = 0;
  for (std::size_t i = 0; i < a.frames.size(); ++i)
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) {
        const auto apart = [](Colour p, Colour q) {
          return std::max({std::abs(p.r - q.r), std::abs(p.g - q.g), std::abs(p.b - q.b)});
        };
        const bool corner = x < kWidth / 2 && y > kHeight * 9 / 10;
        const int difference = apart(a.pixel(i, x, y), b.pixel(i, x, y));
        // elsewhere only what the encoder makes of it
        const bool curve = x > kWidth * 2 / 3 && y > kHeight * 4 / 5;
        if (!corner && !curve) {
          ASSERT_LT(difference, 80) << i << ": " << x << ", " << y;
        }
        if (corner && difference > 100) ++changed;
        if (corner && i > 0 && apart(b.pixel(i - 1, x, y), b.pixel(i, x, y)) > 100)
          ++from_frame_to_frame;
      }
  EXPECT_GT(changed, 100 * int(a.frames.size()));
  EXPECT_GT(from_frame_to_frame, 10 * int(a.frames.size()));
}

TEST_F(Film, TextTouchesNoPixelOutsideItsCorner) {
  auto stage = app::FilmStage::open(kWidth, kHeight, {});
  ASSERT_TRUE(stage) << sentence(stage.error());
  const haptics::Tool tool = octahedron();
  (*stage)->show(&tool);
  (*stage)->show(ball());
  (*stage)->look(front());
  const app::FilmFrame plain = (*stage)->draw(stepAt(100));
  (*stage)->write("    0.100 s     1.00 N");
  const app::FilmFrame written = (*stage)->draw(stepAt(100));
  (*stage)->write("");
  EXPECT_EQ((*stage)->draw(stepAt(100)).rgb, plain.rgb);
  ASSERT_EQ(plain.rgb.size(), std::size_t(3 * kWidth * kHeight));
  int changed = 0;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x)
      for (int c = 0; c < 3; ++c) {
        const auto at = std::size_t(3 * (y * kWidth + x) + c);
        if (plain.rgb[at] == written.rgb[at]) continue;
        ++changed;
        ASSERT_LT(x, kWidth / 2);
        ASSERT_LT(y, kHeight / 10);  // rows from the lowest
      }
  EXPECT_GT(changed, 500);
}

TEST_F(Film, WhatIsKeptOfTheSurfaceIsNeverOutOfDate) {
  const haptics::Tool tool = octahedron();
  const auto volume = ball();
  const auto opened = [&] {
    auto stage = app::FilmStage::open(kWidth, kHeight, ui::SurfaceMode::Mesh);
    EXPECT_TRUE(stage) << sentence(stage.error());
    (*stage)->show(&tool);
    (*stage)->show(volume);
    return std::move(*stage);
  };
  FilmCamera aside = front();
  aside.focus_mm.x() = 12.0;
  Step far = stepAt(800);
  far.X_WD = at(0.0, 900.0, 0.0);
  const std::vector<std::pair<FilmCamera, Step>> course{
      {front(), stepAt(100)}, {front(), stepAt(200)}, {aside, stepAt(200)},  {aside, stepAt(800)},
      {aside, far},           {front(), far},         {front(), stepAt(300)}};
  const auto stage = opened();
  std::vector<std::uint8_t> last;
  for (std::size_t n = 0; n < course.size(); ++n) {
    stage->look(course[n].first);
    const app::FilmFrame frame = stage->draw(course[n].second);
    const auto fresh = opened();
    fresh->look(course[n].first);
    const app::FilmFrame expected = fresh->draw(course[n].second);
    int apart = 0;
    for (std::size_t i = 0; i < frame.rgb.size(); ++i)
      apart += std::abs(int(frame.rgb[i]) - int(expected.rgb[i])) > 2;
    EXPECT_EQ(apart, 0) << n;
    EXPECT_NE(frame.rgb, last) << n;
    last = frame.rgb;
  }
}

TEST_F(Film, OfNumbersThatAreNoneIsDrawnWithoutThem) {
  Session session;
  session.steps = 500;
  session.step = [](std::int64_t n) {
    Step step = stepAt(n);
    const double wild = n % 3 == 0 ? 1e300 : n % 3 == 1 ? std::nan("") : 1e12;
    if (n >= 100) step.X_WD.translation().x() = wild;
    if (n >= 200) step.X_WP.translation().y() = wild;
    if (n >= 300) step.settings.isovalue = wild;
    if (n >= 400) step.sent_W.force.z() = wild;
    return step;
  };
  auto recording = recorded(scratch, session);
  FilmOptions chosen = options();
  chosen.burn_in = true;
  for (const bool given : {true, false}) {
    if (!given) chosen.camera.reset();
    const auto film = app::makeFilm(
        recording, [&](std::uint32_t) { return session.scene->volume; }, scratch / "f", chosen);
    // a reader that refuses such numbers is as good
    if (!film) {
      EXPECT_EQ(film.error().reason, "damaged");
      continue;
    }
    EXPECT_EQ(decoded(film->film).frames.size(), 10U);
  }
}

TEST_F(Film, OfAToolThatIsOnlyPointsShowsThem) {
  Session session;
  haptics::Tool points;
  points.shell = *haptics::makeShell(octahedron().mesh.vertices);
  session.scene = scene(points);
  auto recording = recorded(scratch, session);
  const auto film = app::makeFilm(recording, none, scratch / "f", options());
  ASSERT_TRUE(film) << sentence(film.error());
  const auto proxy = projected(front(), stepAt(0).X_WP.translation());
  const Decoded pictures = decoded(film->film);
  const auto seen = pictures.centroid(0, proxyColoured);
  EXPECT_NEAR(seen[0], proxy[0], 1.5);
  EXPECT_NEAR(seen[1], proxy[1], 1.5);
}

TEST_F(Film, MayBeLargerThanTheScreen) {
  auto recording = recorded(scratch, {});
  FilmOptions chosen = options();
  chosen.width = 1920;
  chosen.height = 1080;
  chosen.to = 0.1;
  const auto film = app::makeFilm(recording, none, scratch / "f", chosen);
  ASSERT_TRUE(film) << sentence(film.error());
  const Decoded pictures = decoded(film->film, 1920, 1080);
  ASSERT_EQ(pictures.frames.size(), 3U);
  const auto proxy = projected(front(), stepAt(0).X_WP.translation());
  const auto seen = pictures.centroid(0, proxyColoured);
  EXPECT_NEAR(seen[0] - 960.0, (proxy[0] - 160.0) * 4.5, 2.0);
  EXPECT_NEAR(seen[1] - 540.0, (proxy[1] - 120.0) * 4.5, 2.0);
}

TEST_F(Film, ShowsTheMarksAndTheSecondSurfaceOfTheView) {
  auto recording = recorded(scratch, {});
  FilmOptions chosen = options();
  chosen.to = 0.1;
  const auto made = [&] {
    const auto film = app::makeFilm(
        recording, [](std::uint32_t) { return ball(); }, scratch / "f", chosen);
    EXPECT_TRUE(film) << sentence(film.error());
    return decoded(film->film);
  };
  const auto markColoured = [](Colour c) { return c.r > c.g + 40 && c.b > c.g + 40 && c.r > 150; };
  const auto brightness = [](const Decoded& film, const std::array<double, 2>& at) {
    const Colour c = film.pixel(1, int(at[0]), int(at[1]));
    return c.r + c.g + c.b;
  };
  const Vec3 left(-15.0, -15.0, 14.0), right(15.0, -15.0, 14.0);   // mm
  const auto beside = projected(front(), {0.0106, 0.0, -0.0106});  // 15 mm; the first has 12
  const Decoded bare = made();
  EXPECT_EQ(bare.count(1, markColoured), 0);
  chosen.look.marks = {{{left, right}, ""}};
  chosen.look.second = 20.0;
  const Decoded film = made();
  EXPECT_GT(film.count(1, markColoured), 50);
  const auto seen = film.centroid(1, markColoured);
  const auto a = projected(front(), left * 1e-3), b = projected(front(), right * 1e-3);
  EXPECT_NEAR(seen[0], 0.5 * (a[0] + b[0]), 3.0);
  EXPECT_NEAR(seen[1], 0.5 * (a[1] + b[1]), 2.0);
  EXPECT_GT(brightness(film, beside), brightness(bare, beside) + 60);
  chosen.look.second_opacity = 0.9;
  const Decoded opaque = made();
  EXPECT_GT(brightness(opaque, beside), brightness(film, beside) + 60);
}

/// Whether a frame is darker than another about a place of W [m], and brighter: a plate and words.
struct Written {
  int darker = 0, brighter = 0;
};
Written writtenAbout(const app::FilmFrame& frame, const app::FilmFrame& bare,
                     const std::array<double, 2>& at, int side) {
  Written written;
  for (int y = int(at[1]) - side; y <= int(at[1]) + side; ++y)
    for (int x = int(at[0]) - side; x <= int(at[0]) + side; ++x) {
      const auto sumOf = [&](const app::FilmFrame& of) {
        const auto first = std::size_t(3 * ((kHeight - 1 - y) * kWidth + x));
        return of.rgb[first] + of.rgb[first + 1] + of.rgb[first + 2];
      };
      written.darker += sumOf(frame) < sumOf(bare) / 2;
      written.brighter += sumOf(frame) > sumOf(bare) + 60;
    }
  return written;
}

TEST_F(Film, LettersStandOnPlatesAtTheEdges) {
  const auto known = ball();
  auto unknown = std::make_shared<haptics::Volume>(*known);
  unknown->orientation_known = false;
  auto stage = app::FilmStage::open(kWidth, kHeight, {});
  ASSERT_TRUE(stage) << sentence(stage.error());
  FilmCamera near = front();
  near.position_mm = {0.0, -30.0, 0.0};  // the ball fills the picture
  (*stage)->look(near);
  (*stage)->show(known);
  const app::FilmFrame lettered = (*stage)->draw(stepAt(0));
  (*stage)->show(unknown);
  const app::FilmFrame bare = (*stage)->draw(stepAt(0));
  for (const auto& edge : {std::array{11.0, 120.0}, {309.0, 120.0}, {160.0, 11.0}, {160.0, 229.0}})
    EXPECT_GT(writtenAbout(lettered, bare, edge, 10).darker, 20) << edge[0] << ' ' << edge[1];
  EXPECT_EQ(writtenAbout(lettered, bare, {160.0, 120.0}, 90).darker, 0);
}

TEST_F(Film, AnAngleHasItsArcAndEveryFilmSaysThatItIsNotForTreatment) {
  const ui::Measure angle{
      ui::MeasureKind::Angle, "", {{14.0, -20.0, 0.0}, {0.0, -20.0, 0.0}, {0.0, -20.0, 14.0}}};
  const std::vector<app::FilmMark> marks = app::filmMarks({angle}, {});
  ASSERT_EQ(marks.size(), 1U);
  const double reach = 0.3 * 14.0 * std::sqrt(0.5);  // mm, of the arc's middle
  const auto drawn = [&](app::FilmLook look) {
    auto stage = app::FilmStage::open(kWidth, kHeight, {}, std::move(look));
    EXPECT_TRUE(stage) << sentence(stage.error());
    (*stage)->look(front());
    return (*stage)->draw(stepAt(0));
  };
  const app::FilmFrame bare = drawn({}), marked = drawn({.marks = marks});
  const auto arc = projected(front(), Vec3(reach, -20.0, reach) * 1e-3);
  EXPECT_GT(writtenAbout(marked, bare, arc, 2).brighter, 4);
  const auto inside = projected(front(), Vec3(0.5 * reach, -20.0, 0.5 * reach) * 1e-3);
  EXPECT_EQ(writtenAbout(marked, bare, inside, 1).brighter, 0);
  // words in the upper left corner
  int bright = 0;
  for (int y = kHeight - 20; y < kHeight; ++y)
    for (int x = 0; x < kWidth / 2; ++x)
      bright += bare.rgb[std::size_t(3 * (y * kWidth + x))] > 120;
  EXPECT_GT(bright, 40);
}

TEST_F(Film, TheWordsOfAMarkAreWholeAtTheRightEdge) {
  const auto wordsAt = [](double x_mm) {
    const auto drawn = [](app::FilmLook look) {
      auto stage = app::FilmStage::open(kWidth, kHeight, {}, std::move(look));
      EXPECT_TRUE(stage) << sentence(stage.error());
      (*stage)->look(front());
      return (*stage)->draw(stepAt(0));
    };
    const app::FilmFrame marked = drawn({.marks = {{{{x_mm, -20.0, 20.0}}, "95.4 mm"}}});
    const app::FilmFrame bare = drawn({});
    return writtenAbout(marked, bare, {160.0, 40.0}, 40).brighter +
           writtenAbout(marked, bare, {279.0, 40.0}, 40).brighter;
  };
  const double per_pixel = 1.0 / (projected(front(), Vec3(1e-3, -0.02, 0.02))[0] -
                                  projected(front(), Vec3(0.0, -0.02, 0.02))[0]);  // mm
  const int whole = wordsAt(0.0);
  EXPECT_GT(whole, 100);
  EXPECT_NEAR(wordsAt(140.0 * per_pixel), whole, 0.1 * whole);
}

TEST_F(Film, ShowsTheCurveOfTheForceAndLosesNoPeak) {
  Session session;
  session.step = [](std::int64_t n) {
    Step step = stepAt(n);
    step.sent_W.force = Vec3(0.0, 0.0, n == 731 ? 16.0 : 2.0);  // between two frames
    return step;
  };
  auto recording = recorded(scratch, session);
  FilmOptions chosen = options();
  chosen.burn_in = true;
  const auto film = app::makeFilm(recording, none, scratch / "f", chosen);
  ASSERT_TRUE(film) << sentence(film.error());
  const Decoded pictures = decoded(film->film);
  // the highest pixel of the curve, from the lower edge; its upper edge is 20 N
  const auto highest = [&](std::size_t frame) {
    for (int y = 180; y < kHeight; ++y)
      for (int x = 2 * kWidth / 3; x < kWidth; ++x)
        if (const Colour c = pictures.pixel(frame, x, y); c.b > c.r + 60 && c.b > 120)
          return kHeight - y;
    return 0;
  };
  const double low = kHeight / 45.0 + 1.0, high = 0.14 * kHeight - 2.0;
  EXPECT_NEAR(highest(10), low + high * 2.0 / 20.0, 2.5);
  EXPECT_NEAR(highest(20), low + high * 16.0 / 20.0, 2.5);
}

TEST_F(Film, HasTheSlicesThroughTheToolBesideItTheRightWayRound) {
  // solid to the left, in front and on top
  constexpr std::int64_t kSide = 41;
  haptics::Volume made = *ball();
  auto voxels = *haptics::allocateVoxels(kSide * kSide * kSide, haptics::ScalarType::Float32);
  for (std::int64_t n = 0; n < kSide * kSide * kSide; ++n)
    static_cast<float*>(voxels.get())[n] =
        n % kSide > 20 && n / kSide % kSide < 20 && n / kSide / kSide > 20 ? 100.0F : 0.0F;
  const auto corner = std::make_shared<const haptics::Volume>(
      *haptics::makeVolume(made.grid, haptics::ScalarType::Float32, voxels));
  Session session;
  session.scene = *haptics::makeScene(corner, octahedron());
  session.step = [](std::int64_t n) {
    Step step = stepAt(n);
    step.X_WP = step.X_WD = at(8.0, -6.0, n < 750 ? 13.0 : -7.0);  // the tip is 3 mm lower
    return step;
  };
  auto recording = recorded(scratch, session);
  FilmOptions chosen = options();
  chosen.width = 640;
  chosen.height = 480;
  chosen.look.slices = true;
  const auto film = app::makeFilm(
      recording, [&](std::uint32_t) { return corner; }, scratch / "f", chosen);
  ASSERT_TRUE(film) << sentence(film.error());
  const Decoded pictures = decoded(film->film, 640, 480);
  ASSERT_EQ(pictures.frames.size(), 30U);
  constexpr int kPane = 160, kMargin = 15, kPicture = kPane - 2 * kMargin;
  const auto middleOf = [](int pane) {
    return std::array{640 - kPane / 2, pane * kPane + kPane / 2};
  };
  // bright in this quarter of a pane and in no other
  const auto solidIn = [&](std::size_t frame, int pane) {
    std::string quarters;
    const auto [x0, y0] = middleOf(pane);
    for (const int y : {-1, 1})
      for (const int x : {-1, 1}) {
        const Colour c = pictures.pixel(frame, x0 + x * kPicture / 8, y0 + y * kPicture / 8);
        if (c.r + c.g + c.b > 600) quarters += y < 0 ? x < 0 ? "a" : "b" : x < 0 ? "c" : "d";
      }
    return quarters;
  };
  EXPECT_EQ(solidIn(2, 0), "b");  // axial: left is at the right, the front above
  EXPECT_EQ(solidIn(2, 1), "b");  // coronal: left, the head above
  EXPECT_EQ(solidIn(2, 2), "a");  // sagittal: the front is at the left, the head above
  EXPECT_EQ(solidIn(25, 0), "");  // beneath it
  EXPECT_EQ(solidIn(25, 1), "b");
  // the axial plane is a line in the coronal one, which goes with the tip
  const auto redLine = [&](std::size_t frame) {
    const auto [x0, y0] = middleOf(1);
    for (int y = -kPicture / 2 + 2; y < kPicture / 2 - 2; ++y)
      if (const Colour c = pictures.pixel(frame, x0 - kPicture / 3, y0 + y); c.r > c.g + 20)
        return y;
    return 1000;
  };
  const double pixels_per_mm = kPicture / 40.0 / 1.04;
  EXPECT_NEAR(redLine(2), -10.0 * pixels_per_mm, 2.0);
  EXPECT_NEAR(redLine(25), 10.0 * pixels_per_mm, 2.0);
  // words in the margins
  const auto marked = [&](int x, int y, int side) {
    int bright = 0;
    for (int dy = -side; dy <= side; ++dy)
      for (int dx = -side; dx <= side; ++dx) {
        const Colour c = pictures.pixel(2, x + dx, y + dy);
        bright += c.r + c.g > 200;
      }
    return bright;
  };
  for (int pane = 0; pane < 3; ++pane) {
    const auto [x0, y0] = middleOf(pane);
    for (const int side : {-1, 1}) {
      EXPECT_GT(marked(x0 + side * (kPane - kMargin) / 2, y0, 5), 5) << pane;
      EXPECT_GT(marked(x0, y0 + side * (kPane - kMargin) / 2, 5), 5) << pane;
    }
    EXPECT_GT(marked(x0 - kPicture / 2 + 3, y0 + kPicture / 2 + 2, 3), 3) << pane;  // the bar
  }
}

}  // namespace
