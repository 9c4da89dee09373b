// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <memory>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include "app/display.h"
#include "app/film/film.h"
#include "app/recording/recorder.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/sentence.h"

/// A recorded session about a ball, and the film that was made of it, as numbers.
namespace film {

namespace fs = std::filesystem;
using app::FilmCamera;
using app::FilmOptions;
using haptics::Pose;
using haptics::Step;
using haptics::Vec3;
using support::ScratchFolder;

inline constexpr int kWidth = 320, kHeight = 240;

/// A ball of 12 mm, 100 inside and 0 outside, in a volume of 40 mm about W's origin.
inline std::shared_ptr<const haptics::Volume> ball() {
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
inline haptics::Tool octahedron() {
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

inline std::shared_ptr<const haptics::Scene> scene(haptics::Tool tool = octahedron()) {
  return *haptics::makeScene(ball(), std::move(tool));
}

inline Pose at(double x_mm, double y_mm, double z_mm) {
  Pose X = Pose::Identity();
  X.translation() = Vec3(x_mm, y_mm, z_mm) * 1e-3;
  return X;
}

/// A second and a half of a tool that goes to and fro at the front of the ball, and of a device
/// that goes up and down beside it. Beside the steps, cameras at their times.
inline Step stepAt(std::int64_t n) {
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
  std::shared_ptr<const haptics::Scene> scene = film::scene();
};

inline app::Recording recorded(const ScratchFolder& scratch, const Session& session) {
  const fs::path path = scratch / "r.palpate";
  auto recorder = app::Recorder::create(path, {"test", "a build", "a machine"});
  EXPECT_TRUE(recorder) << sentence(recorder.error());
  (*recorder)->describe(session.scene, "");
  (*recorder)->ring().start({});
  for (std::int64_t n = 0; n < session.steps; ++n) {
    Step step = session.step(session.first + n);
    step.scene = static_cast<std::uint32_t>(session.scene->id);
    EXPECT_TRUE((*recorder)->ring().push(step));
  }
  const auto finished = (*recorder)->finish();
  EXPECT_TRUE(finished) << sentence(finished.error());
  {
    auto database = app::Database::open(path, app::Database::Mode::Recover);
    EXPECT_TRUE(database);
    for (const auto& [time_ns, text] : session.cameras) {
      auto row = database->prepare(
          "INSERT INTO event (sequence, time_ns, kind, text) VALUES (0, ?, 'camera', ?)");
      EXPECT_TRUE(row.bind(1, time_ns).bind(2, text).run());
    }
    EXPECT_TRUE(database->run("PRAGMA wal_checkpoint(TRUNCATE); PRAGMA journal_mode = DELETE;"));
  }
  auto recording = app::Recording::open(path);
  EXPECT_TRUE(recording) << sentence(recording.error());
  return std::move(*recording);
}

/// From the front, 160 mm away.
inline FilmCamera front() { return {{0, -160, 0}, {0, 0, 0}, {0, 0, 1}, 25.0}; }

inline FilmOptions options() {
  FilmOptions chosen;
  chosen.width = kWidth;
  chosen.height = kHeight;
  chosen.frames_per_second = 20;
  chosen.camera = front();
  return chosen;
}

inline std::shared_ptr<const haptics::Volume> none(std::uint32_t) { return nullptr; }

/// Where a point of W is drawn: pixels from the left and from the top, by the rule of the pinhole.
inline std::array<double, 2> projected(const FilmCamera& camera, const Vec3& p_W) {
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
inline bool proxyColoured(Colour c) { return c.b > c.r + 50 && c.b > c.g + 15; }
inline bool deviceColoured(Colour c) { return c.r > c.b + 70 && c.r > c.g + 40; }
inline bool surfaceColoured(Colour c) {
  return c.r > 60 && c.r > c.b && c.r < c.b + 60 && c.r < c.g + 40;
}

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

inline Decoded decoded(const fs::path& film, int width = kWidth, int height = kHeight) {
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
inline std::vector<Row> rowsOf(const fs::path& csv) {
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
inline bool childless() { return waitpid(-1, nullptr, WNOHANG) == -1 && errno == ECHILD; }

class Film : public testing::Test {
 protected:
  void SetUp() override {
    if (!app::HeldDisplay{}.draws()) GTEST_SKIP() << "no X display with GLX";
    if (std::system("ffmpeg -version > /dev/null 2>&1") != 0) GTEST_SKIP() << "no ffmpeg";
  }
  ScratchFolder scratch;
};

}  // namespace film
