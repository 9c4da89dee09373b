// SPDX-License-Identifier: BSD-3-Clause
// Needs an X display with GLX, and ffmpeg to look into what was written.
#include "app/film/film.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <array>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <numbers>
#include <sstream>
#include <thread>

#include "app/display.h"
#include "app/film/stage.h"
#include "haptics/recording/recorder.h"
#include "tests/support/scratch_folder.h"

namespace {

namespace fs = std::filesystem;
using app::FilmCamera;
using app::FilmOptions;
using haptics::Pose;
using haptics::Step;
using haptics::Vec3;
using support::ScratchFolder;

constexpr int kWidth = 320, kHeight = 240;

/// A ball of 12 mm, 100 inside and 0 outside, in a volume of 40 mm about W's origin.
std::shared_ptr<const haptics::Volume> ball() {
  constexpr std::int64_t kSide = 41;
  haptics::Grid grid;
  grid.dims = {kSide, kSide, kSide};
  grid.spacing = Vec3::Constant(0.001);
  grid.origin = Vec3::Constant(-0.0005 * double(kSide - 1));
  auto voxels = *haptics::allocateVoxels(grid.voxelCount(), haptics::ScalarType::Float32);
  auto* f = static_cast<float*>(voxels.get());
  for (std::int64_t n = 0; n < grid.voxelCount(); ++n) {
    const Vec3 p =
        grid.worldOf(Vec3(double(n % kSide), double(n / kSide % kSide), double(n / kSide / kSide)));
    f[n] = float(std::clamp(50.0 + (0.012 - p.norm()) * 5e3, 0.0, 100.0));
  }
  return std::make_shared<const haptics::Volume>(
      *haptics::makeVolume(grid, haptics::ScalarType::Float32, voxels));
}

/// An octahedron with corners 3 mm from its middle, at the origin of the tool frame.
haptics::Tool octahedron() {
  haptics::TriangleMesh mesh;
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {1.0, -1.0}) mesh.vertices.push_back(side * 0.003 * Vec3::Unit(axis));
  for (const std::uint32_t x : {0U, 1U})
    for (const std::uint32_t y : {2U, 3U})
      for (const std::uint32_t z : {4U, 5U}) {
        const bool even = (x + y + z) % 2 == 0;
        mesh.triangles.push_back(even ? std::array{x, y, z} : std::array{y, x, z});
      }
  return *haptics::makeTool("octahedron", mesh);
}

std::shared_ptr<const haptics::Scene> scene(haptics::Tool tool = octahedron()) {
  return *haptics::makeScene(ball(), std::move(tool));
}

Pose at(double x_mm, double y_mm, double z_mm) {
  Pose X = Pose::Identity();
  X.translation() = Vec3(x_mm, y_mm, z_mm) * 1e-3;
  return X;
}

/// A second and a half of a tool that goes to and fro at the front of the ball, and of a device
/// that goes up and down beside it. Beside the steps, cameras at their times.
Step stepAt(std::int64_t n) {
  const double phase = double(n) / 1500.0 * 2.0 * std::numbers::pi;
  Step step;
  step.time_ns = n * 1'000'000;
  step.X_WP = at(18.0 * std::sin(phase), -16.0, 10.0 * std::cos(phase));
  step.X_WD = at(-15.0 * std::cos(phase), -4.0, 14.0 * std::sin(phase));
  step.sent_W.force = Vec3(0.0, 0.0, double(n) * 0.01);
  step.settings.isovalue = n < 750 ? 50.0 : 90.0;
  return step;
}

struct Session {
  std::int64_t first = 0, steps = 1500;
  std::function<Step(std::int64_t)> step = stepAt;
  std::map<std::int64_t, std::string> cameras = {};  ///< by time, ns
  std::shared_ptr<const haptics::Scene> scene = ::scene();
};

haptics::Recording recorded(const ScratchFolder& scratch, const Session& session) {
  const fs::path path = scratch / "r.palpate";
  auto recorder = haptics::Recorder::create(path, {"test", "a build", "a machine"});
  EXPECT_TRUE(recorder) << recorder.error().what;
  (*recorder)->describe(session.scene, "");
  (*recorder)->ring().start({});
  for (std::int64_t n = 0; n < session.steps; ++n) {
    Step step = session.step(session.first + n);
    step.scene = static_cast<std::uint32_t>(session.scene->id);
    EXPECT_TRUE((*recorder)->ring().push(step));
  }
  const auto finished = (*recorder)->finish();
  EXPECT_TRUE(finished) << finished.error().what;
  {
    auto database = haptics::Database::open(path, haptics::Database::Mode::Recover);
    EXPECT_TRUE(database);
    for (const auto& [time_ns, text] : session.cameras) {
      auto row = database->prepare(
          "INSERT INTO event (sequence, time_ns, kind, text) VALUES (0, ?, 'camera', ?)");
      EXPECT_TRUE(row.bind(1, time_ns).bind(2, text).run());
    }
    EXPECT_TRUE(database->run("PRAGMA wal_checkpoint(TRUNCATE); PRAGMA journal_mode = DELETE;"));
  }
  auto recording = haptics::Recording::open(path);
  EXPECT_TRUE(recording) << recording.error().what;
  return std::move(*recording);
}

/// From the front, 160 mm away.
FilmCamera front() { return {{0, -160, 0}, {0, 0, 0}, {0, 0, 1}, 25.0}; }

FilmOptions options() {
  FilmOptions chosen;
  chosen.width = kWidth;
  chosen.height = kHeight;
  chosen.frames_per_second = 20;
  chosen.camera = front();
  return chosen;
}

std::shared_ptr<const haptics::Volume> none(std::uint32_t) { return nullptr; }

/// Where a point of W is drawn: pixels from the left and from the top, by the rule of the pinhole.
std::array<double, 2> projected(const FilmCamera& camera, const Vec3& p_W) {
  const Vec3 away = (camera.focus_mm - camera.position_mm).normalized();
  const Vec3 right = away.cross(camera.up).normalized(), up = right.cross(away);
  const Vec3 p = p_W * 1e3 - camera.position_mm;
  const double pixels =
      0.5 * kHeight / std::tan(0.5 * camera.angle_deg * std::numbers::pi / 180.0) / away.dot(p);
  return {0.5 * kWidth + right.dot(p) * pixels, 0.5 * kHeight - up.dot(p) * pixels};
}

struct Colour {
  int r, g, b;
};
bool proxyColoured(Colour c) { return c.b > c.r + 50 && c.b > c.g + 15; }
bool deviceColoured(Colour c) { return c.r > c.b + 70 && c.r > c.g + 40; }
bool surfaceColoured(Colour c) { return c.r > 60 && c.r > c.b && c.r < c.b + 60 && c.r < c.g + 40; }

/// The frames of a film as ffmpeg decodes them, rows from the top.
struct Decoded {
  std::vector<std::vector<std::uint8_t>> frames;
  int width = kWidth;
  Colour pixel(std::size_t frame, int x, int y) const {
    const std::uint8_t* p = &frames[frame][std::size_t(3 * (y * width + x))];
    return {p[0], p[1], p[2]};
  }
  int count(std::size_t frame, bool (*wanted)(Colour)) const {
    int found = 0;
    for (int y = 0; y < int(frames[frame].size()) / 3 / width; ++y)
      for (int x = 0; x < width; ++x) found += wanted(pixel(frame, x, y));
    return found;
  }
  /// Mean place of the pixels of a colour.
  std::array<double, 2> centroid(std::size_t frame, bool (*wanted)(Colour)) const {
    double sx = 0.0, sy = 0.0, n = 0.0;
    for (int y = 0; y < int(frames[frame].size()) / 3 / width; ++y)
      for (int x = 0; x < width; ++x)
        if (wanted(pixel(frame, x, y))) sx += x + 0.5, sy += y + 0.5, n += 1.0;
    return {sx / n, sy / n};
  }
};

Decoded decoded(const fs::path& film, int width = kWidth, int height = kHeight) {
  Decoded result;
  result.width = width;
  const std::string command =
      "ffmpeg -v error -i '" + film.string() + "' -f rawvideo -pix_fmt rgb24 -";
  std::FILE* pipe = popen(command.c_str(), "r");
  std::vector<std::uint8_t> frame(std::size_t(3 * width * height));
  while (std::fread(frame.data(), 1, frame.size(), pipe) == frame.size())
    result.frames.push_back(frame);
  EXPECT_EQ(pclose(pipe), 0);
  return result;
}

struct Row {
  std::int64_t frame, sequence, time_ns;
  double film_time;
};
std::vector<Row> rowsOf(const fs::path& csv) {
  std::ifstream file(csv);
  std::string line;
  std::getline(file, line);
  EXPECT_EQ(line, "frame,sequence,time_ns,film_time_s");
  std::vector<Row> rows;
  char comma;
  while (std::getline(file, line)) {
    std::istringstream words(line);
    Row row{};
    words >> row.frame >> comma >> row.sequence >> comma >> row.time_ns >> comma >> row.film_time;
    EXPECT_FALSE(words.fail()) << line;
    rows.push_back(row);
  }
  return rows;
}

/// No process is left of those that were started.
bool childless() { return waitpid(-1, nullptr, WNOHANG) == -1 && errno == ECHILD; }

class Film : public testing::Test {
 protected:
  void SetUp() override {
    if (!app::displayDraws()) GTEST_SKIP() << "no X display with GLX";
    if (std::system("ffmpeg -version > /dev/null 2>&1") != 0) GTEST_SKIP() << "no ffmpeg";
  }
  ScratchFolder scratch;
};

TEST_F(Film, ShowsToolAndDeviceWhereEachStepHadThem) {
  auto recording = recorded(scratch, {});
  const auto film = app::makeFilm(recording, none, scratch / "f.mp4", options());
  ASSERT_TRUE(film) << film.error().what;
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
  ASSERT_TRUE(recording.forEach(-1.0, 1e9, [&](const haptics::RecordedStep& step) {
    steps.emplace_back(step.step.sequence, step.step.time_ns);
    return true;
  }));
  ASSERT_EQ(steps.size(), 1100U);
  FilmOptions chosen = options();
  chosen.from = 0.9;
  chosen.to = 1.5;
  chosen.speed = 0.37;
  const auto film = app::makeFilm(recording, none, scratch / "f", chosen);
  ASSERT_TRUE(film) << film.error().what;
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
  ASSERT_TRUE(early) << early.error().what;
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
    ASSERT_TRUE(film) << film.error().what;
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

TEST_F(Film, GoesFromCameraToCamera) {
  const FilmCamera side{{170, 20, 10}, {0, 0, 5}, {0, 0, 1}, 20.0};
  Session session;
  session.cameras = {
      {400'000'000, wordsOf(front())}, {800'000'000, wordsOf(side)}, {1'200'000'000, "nonsense"}};
  auto recording = recorded(scratch, session);
  const auto film = app::makeFilm(
      recording, [&](std::uint32_t) { return session.scene->volume; }, scratch / "f", options());
  ASSERT_TRUE(film) << film.error().what;
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
  ASSERT_TRUE(own) << own.error().what;
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
    ASSERT_TRUE(film) << film.error().what;
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

TEST_F(Film, BurnsTimeAndForceIntoItsCornerAlone) {
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
        if (!corner) {
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
  ASSERT_TRUE(stage) << stage.error().what;
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
    EXPECT_TRUE(stage) << stage.error().what;
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

TEST_F(Film, TwiceTheSameHasTheSameFrames) {
  const Session session;
  auto recording = recorded(scratch, session);
  FilmOptions chosen = options();
  chosen.burn_in = true;
  const auto volume = [&](std::uint32_t) { return session.scene->volume; };
  const auto first = app::makeFilm(recording, volume, scratch / "a", chosen);
  // the second by another thread
  std::optional<haptics::Expected<app::FilmResult>> second;
  std::thread other([&] { second = app::makeFilm(recording, volume, scratch / "b", chosen); });
  other.join();
  ASSERT_TRUE(first && *second);
  EXPECT_EQ(decoded(first->film).frames, decoded((*second)->film).frames);
  std::ifstream a(first->film, std::ios::binary), b((*second)->film, std::ios::binary);
  const std::string bytes_a{std::istreambuf_iterator<char>(a), {}};
  const std::string bytes_b{std::istreambuf_iterator<char>(b), {}};
  EXPECT_GT(bytes_a.size(), 1000U);
  EXPECT_TRUE(bytes_a == bytes_b);
}

TEST_F(Film, WithoutFfmpegIsOggTheora) {
  auto recording = recorded(scratch, {});
  for (const char* program : {"", "no-such-program", "/no/such/program", "/"}) {
    FilmOptions chosen = options();
    chosen.ffmpeg = program;
    const auto film = app::makeFilm(recording, none, scratch / "f.mp4", chosen);
    ASSERT_TRUE(film) << film.error().what;
    EXPECT_EQ(film->film, scratch / "f.ogv");
    EXPECT_EQ(film->codec, "theora");
    EXPECT_EQ(scratch.names(), (std::vector<std::string>{"f.frames.csv", "f.ogv", "r.palpate"}));
    const Decoded pictures = decoded(film->film);
    ASSERT_EQ(pictures.frames.size(), 30U);
    for (const std::size_t i : {0U, 14U, 29U}) {
      const auto proxy = projected(front(), stepAt(std::int64_t(i) * 50).X_WP.translation());
      const auto seen = pictures.centroid(i, proxyColoured);
      EXPECT_NEAR(seen[0], proxy[0], 1.5) << i;
      EXPECT_NEAR(seen[1], proxy[1], 1.5) << i;
    }
  }
}

/// What a program says on both outputs.
std::string saidBy(const std::string& command) {
  std::string said;
  FILE* pipe = popen(("{ " + command + "; } 2>&1").c_str(), "r");
  std::array<char, 256> piece{};
  while (pipe != nullptr && std::fgets(piece.data(), int(piece.size()), pipe) != nullptr)
    said += piece.data();
  if (pipe != nullptr) pclose(pipe);
  return said;
}

TEST_F(Film, NothingIsSaidAgainstIt) {
  auto recording = recorded(scratch, {});
  // also where the picture fills no whole blocks, and with more than one key frame
  for (const auto& [width, rate] : {std::pair{640, 30}, std::pair{98, 240}})
    for (const char* program : {"ffmpeg", ""}) {
      FilmOptions chosen = options();
      chosen.ffmpeg = program;
      chosen.width = width;
      chosen.frames_per_second = rate;
      const auto film = app::makeFilm(recording, none, scratch / "f", chosen);
      ASSERT_TRUE(film) << film.error().what;
      const std::string named = " -i '" + film->film.string() + "'";
      EXPECT_EQ(saidBy("ffmpeg -nostdin -v warning" + named + " -f null -"), "") << film->film;
      EXPECT_EQ(saidBy("ffprobe -v warning -show_frames" + named + " > /dev/null"), "");
      const std::string size =
          saidBy("ffprobe -v warning -show_entries stream=width -of csv=p=0" + named);
      EXPECT_EQ(size, std::to_string(width) + "\n");
    }
}

TEST_F(Film, CancelledLeavesNothing) {
  auto recording = recorded(scratch, {});
  for (const char* program : {"ffmpeg", ""})
    for (const double until : {0.0, 0.4, 0.98}) {
      FilmOptions chosen = options();
      chosen.ffmpeg = program;
      chosen.goes_on = [&](double done) { return done < until; };
      const auto film = app::makeFilm(recording, none, scratch / "f", chosen);
      ASSERT_FALSE(film);
      EXPECT_EQ(film.error().reason, "cancelled");
      EXPECT_EQ(scratch.names(), std::vector<std::string>{"r.palpate"});
      EXPECT_TRUE(childless());
    }
}

TEST_F(Film, AnEncoderThatFailsIsOneSentence) {
  auto recording = recorded(scratch, {});
  const auto script = [&](const char* name, const std::string& text) {
    std::ofstream(scratch / name) << "#!/bin/sh\n" << text;
    fs::permissions(scratch / name, fs::perms::owner_all);
    return (scratch / name).string();
  };
  const std::array programs{
      script("dies", "echo 'no such thing as libx264' >&2; echo more >&2; exit 1\n"),
      script("killed", "head -c 2000000 > /dev/null; kill -9 $$\n"),
      script("shouts", "yes 'a very long complaint' | head -c 5000000 >&2; exit 3\n"),
      script("lies", "cat > /dev/null; for last; do :; done; echo film > \"${last#file:}\"\n"),
      script("deaf", "exec 0<&-; sleep 0.3; exit 1\n")};
  for (const std::string& program : programs) {
    SCOPED_TRACE(program);
    FilmOptions chosen = options();
    chosen.ffmpeg = program;
    const auto film = app::makeFilm(recording, none, scratch / "f", chosen);
    ASSERT_FALSE(film);
    EXPECT_EQ(film.error().reason, "encoder");
    EXPECT_LT(film.error().what.size(), 400U);
    EXPECT_EQ(film.error().what.find('\n'), std::string::npos);
    EXPECT_TRUE(childless());
    EXPECT_EQ(scratch.names().size(), 1U + programs.size());
  }
  FilmOptions chosen = options();
  chosen.ffmpeg = programs[0];
  const auto film = app::makeFilm(recording, none, scratch / "f", chosen);
  EXPECT_NE(film.error().what.find("no such thing as libx264"), std::string::npos);
  // one that neither reads nor ends can be left
  chosen.ffmpeg = script("hangs", "exec sleep 1000\n");
  int asked = 0;
  chosen.goes_on = [&](double) { return ++asked < 20; };
  const auto left = app::makeFilm(recording, none, scratch / "f", chosen);
  ASSERT_FALSE(left);
  EXPECT_EQ(left.error().reason, "cancelled");
  EXPECT_TRUE(childless());
}

TEST_F(Film, AFullDiskLeavesNothing) {
  auto recording = recorded(scratch, {});
  // a file cannot grow beyond this: as on a full disk, but for the error's name
  std::signal(SIGXFSZ, SIG_IGN);
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  for (const char* program : {"ffmpeg", ""}) {
    FilmOptions chosen = options();
    chosen.ffmpeg = program;
    const auto whole = app::makeFilm(recording, none, scratch / "f", chosen);
    ASSERT_TRUE(whole) << whole.error().what;
    const rlim_t size = fs::file_size(whole->film);
    fs::remove(whole->film);
    fs::remove(whole->times);
    for (const rlim_t room : {rlim_t{10}, size / 10, size / 2, size * 9 / 10, size - 1}) {
      rlimit little = before;
      little.rlim_cur = room;
      setrlimit(RLIMIT_FSIZE, &little);
      const auto film = app::makeFilm(recording, none, scratch / "f", chosen);
      setrlimit(RLIMIT_FSIZE, &before);
      ASSERT_FALSE(film) << fs::file_size(film->film) << " bytes with room for " << room;
      EXPECT_TRUE(film.error().reason == "encoder" || film.error().reason == "unwritable");
      EXPECT_EQ(scratch.names(), std::vector<std::string>{"r.palpate"});
    }
  }
  std::signal(SIGXFSZ, SIG_DFL);
}

TEST_F(Film, WhatCannotBeIsRefused) {
  auto recording = recorded(scratch, {});
  const auto reason = [&](auto change, fs::path out = {}) {
    FilmOptions chosen = options();
    change(chosen);
    const auto film = app::makeFilm(recording, none, out.empty() ? scratch / "f" : out, chosen);
    return film ? std::string{} : film.error().reason;
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(reason([](FilmOptions& o) { o.width = 321; }), "options");
  EXPECT_EQ(reason([](FilmOptions& o) { o.height = 1'000'000; }), "options");
  EXPECT_EQ(reason([](FilmOptions& o) { o.height = 0; }), "options");
  EXPECT_EQ(reason([](FilmOptions& o) { o.frames_per_second = 0; }), "options");
  EXPECT_EQ(reason([](FilmOptions& o) { o.speed = 0.0; }), "options");
  EXPECT_EQ(reason([&](FilmOptions& o) { o.speed = nan; }), "options");
  EXPECT_EQ(reason([](FilmOptions& o) { o.from = 2.0; }), "nothing");
  EXPECT_EQ(reason([](FilmOptions& o) { o.to = -1.0; }), "nothing");
  EXPECT_EQ(reason([&](FilmOptions& o) { o.from = nan; }), "nothing");
  const auto as_is = [](FilmOptions&) {};
  EXPECT_EQ(reason(as_is, scratch / "nowhere" / "f"), "unwritable");
  EXPECT_EQ(reason(as_is, scratch.folder() / ""), "unwritable");
  fs::create_directory(scratch / "folder.mp4");
  EXPECT_EQ(reason(as_is, scratch / "folder"), "unwritable");
  EXPECT_EQ(scratch.names(), (std::vector<std::string>{"folder.mp4", "r.palpate"}));
  const std::string display = std::getenv("DISPLAY");
  unsetenv("DISPLAY");
  EXPECT_EQ(reason(as_is), "no-display");
  setenv("DISPLAY", ":65530", 1);
  EXPECT_EQ(reason(as_is), "no-display");
  setenv("DISPLAY", display.c_str(), 1);
  EXPECT_EQ(scratch.names(), (std::vector<std::string>{"folder.mp4", "r.palpate"}));
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
  ASSERT_TRUE(film) << film.error().what;
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
  ASSERT_TRUE(film) << film.error().what;
  const Decoded pictures = decoded(film->film, 1920, 1080);
  ASSERT_EQ(pictures.frames.size(), 3U);
  const auto proxy = projected(front(), stepAt(0).X_WP.translation());
  const auto seen = pictures.centroid(0, proxyColoured);
  EXPECT_NEAR(seen[0] - 960.0, (proxy[0] - 160.0) * 4.5, 2.0);
  EXPECT_NEAR(seen[1] - 540.0, (proxy[1] - 120.0) * 4.5, 2.0);
}

}  // namespace
