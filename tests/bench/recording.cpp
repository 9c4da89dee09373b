// SPDX-License-Identifier: BSD-3-Clause
// palpate-recording: what recording costs a session, and how much of an hour is kept: all of it.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <thread>
#include <vector>

#include "app/build_info/build_info.h"
#include "app/recording/facts.h"
#include "datasets/phantoms/phantoms.h"
#include "haptics/recording/recorder.h"
#include "haptics/recording/recording.h"
#include "haptics/session.h"
#include "haptics/simulation/closed_loop.h"
#include "resources/named_tools.h"
#include "tests/bench/ticks.h"
#include "tests/support/sentence.h"

namespace bench {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using Clock = std::chrono::steady_clock;

struct Options {
  std::string folder = "";
  double live = 300.0;   ///< s, in real time
  double fast = 3300.0;  ///< s, as fast as possible
  std::string out = "";
};

struct Touched {
  std::shared_ptr<const haptics::Scene> scene;
  double isovalue = 0.0;
  std::string tool = {};
};

Touched demo() {
  auto phantom = datasets::makePhantom("demo").value();
  auto tool = haptics::makeTool(phantom.tool, resources::namedToolMesh(phantom.tool).value());
  return {haptics::makeScene(std::make_shared<const haptics::Volume>(std::move(phantom.volume)),
                             std::move(*tool))
              .value(),
          phantom.isovalue, phantom.tool};
}

double median(std::vector<double> values) {
  if (values.empty()) return 0.0;
  std::ranges::sort(values);
  return values[values.size() / 2];
}

/// A session in which a hand slides over the skull.
struct Sliding {
  explicit Sliding(const Touched& touched) {
    haptics::Settings settings;
    settings.isovalue = touched.isovalue;
    session.set(settings);
    session.adopt(touched.scene, haptics::Pose::Identity());
    opened = session.open(haptics::HandKind::Slide).has_value();
  }
  void look() {
    if (session.latest(now) && now.tick_p99 > 0.0) p99_us.push_back(now.tick_p99 * 1e6);
  }
  Json report() const {
    Json json = jsonOf(ticksOf(now));
    json["median_of_p99_us"] = median(p99_us);
    return json;
  }
  haptics::Session session;
  haptics::Snapshot now;
  std::vector<double> p99_us;
  bool opened = false;
};

Json fileReport(const fs::path& path) {
  auto recording = haptics::Recording::open(path);
  if (!recording) return {{"failed", sentence(recording.error())}};
  const auto bytes = fs::file_size(path);
  return {{"steps", recording->stepCount()},
          {"gaps", recording->lostCount()},
          {"bytes", bytes},
          {"bytes_per_step", double(bytes) / double(recording->stepCount())}};
}

/// Two sessions side by side, one of them recorded.
Json measureLive(const Touched& touched, const Options& options) {
  const fs::path path = fs::path(options.folder) / "live.palpate";
  auto made = haptics::Recorder::create(path, app::recordingFacts());
  if (!made) return {{"failed", sentence(made.error())}};
  const std::shared_ptr<haptics::Recorder> recorder = std::move(*made);
  recorder->describe(touched.scene, touched.tool);
  Sliding with{touched}, without{touched};
  if (!with.opened || !without.opened) return {{"failed", "a hand found no surface"}};
  with.session.record({recorder, &recorder->ring()});
  const Clock::time_point end = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                                   std::chrono::duration<double>{options.live});
  while (Clock::now() < end) {
    std::this_thread::sleep_for(std::chrono::milliseconds{500});
    with.look();
    without.look();
  }
  with.session.close();
  without.session.close();
  const double longest = recorder->status().longest_wait;
  if (const auto finished = recorder->finish(); !finished)
    return {{"failed", sentence(finished.error())}};
  return {{"seconds", options.live},
          {"recorded", with.report()},
          {"beside_it", without.report()},
          {"longest_between_commits_s", longest},
          {"file", fileReport(path)}};
}

/// A closed loop that waits for the ring where it is full.
Json measureFast(const Touched& touched, const Options& options) {
  const fs::path path = fs::path(options.folder) / "fast.palpate";
  auto recorder = haptics::Recorder::create(path, app::recordingFacts());
  if (!recorder) return {{"failed", sentence(recorder.error())}};
  haptics::StepRing& ring = (*recorder)->ring();
  (*recorder)->describe(touched.scene, touched.tool);
  haptics::ClosedLoop loop{touched.scene, {.isovalue = touched.isovalue}, {}, {}};
  loop.grip.gyration = std::sqrt(touched.scene->tool.shell.inertia.trace() / 3.0);
  const auto id = static_cast<std::uint32_t>(touched.scene->id);
  loop.on_start = [&](const haptics::Pose& X) {
    ring.start({.scene = id, .X_WP = X, .limits = {}, .safety = {}, .rate = {}});
  };
  const auto hand =
      haptics::Hand::aimed(haptics::HandMotion::Slide, *touched.scene, touched.isovalue, 0.012, 1);
  if (!hand) return {{"failed", sentence(hand.error())}};
  const Clock::time_point begun = Clock::now();
  std::int64_t n = 0;
  const auto run = loop.run(*hand, static_cast<std::int64_t>(options.fast * 1000.0),
                            [&](const haptics::TraceRow& row) {
                              while (ring.full()) {
                                (*recorder)->hurry();
                                std::this_thread::sleep_for(std::chrono::milliseconds{1});
                              }
                              haptics::Step step;
                              step.time_ns = n++ * 1'000'000;
                              step.X_WD = row.X_WD;
                              step.X_WP = row.X_WP;
                              step.sent_W = row.sent_W;
                              step.settings.isovalue = touched.isovalue;
                              step.scene = id;
                              step.cut_at = row.cut_at;
                              step.cpu_ns = row.cpu_ns;
                              step.force_state = row.force_state;
                              step.flags = haptics::StepFlags::kArmed;
                              step.contacts = row.bearing;
                              return ring.push(step);
                            });
  if (!run) return {{"failed", sentence(run.error())}};
  if (const auto finished = (*recorder)->finish(); !finished)
    return {{"failed", sentence(finished.error())}};
  const double taken = std::chrono::duration<double>(Clock::now() - begun).count();
  return {{"seconds", options.fast},
          {"times_real_time", options.fast / taken},
          {"file", fileReport(path)}};
}

int run(const Options& options) {
  std::error_code error;
  fs::create_directories(options.folder, error);
  if (error) {
    std::fprintf(stderr, "\"%s\" cannot be made a folder; choose another.\n",
                 options.folder.c_str());
    return 3;
  }
  const Touched touched = demo();
  Json json{{"machine", app::machineHere()}, {"version", app::versionHere()}};
  json["live"] = measureLive(touched, options);
  json["as_fast_as_possible"] = measureFast(touched, options);
  std::puts(json.dump(2).c_str());
  if (!options.out.empty()) std::ofstream(options.out) << json.dump(2) << '\n';
  return 0;
}

}  // namespace
}  // namespace bench

int main(int argc, char** argv) {
  bench::Options options;
  CLI::App program{"What recording costs a session, and how much of it is kept"};
  program.add_option("folder", options.folder, "For the recordings, up to 1 GB")->required();
  program.add_option("--live", options.live, "Seconds in real time, two sessions side by side");
  program.add_option("--fast", options.fast, "Seconds simulated as fast as possible");
  program.add_option("--out", options.out, "JSON, besides what is printed");
  CLI11_PARSE(program, argc, argv);
  return bench::run(options);
}
