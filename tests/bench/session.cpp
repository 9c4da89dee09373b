// SPDX-License-Identifier: BSD-3-Clause

// palpate-session: what a window, a recording and a touch cost each other in real time, at any rate
// of the servo.

#include <QApplication>
#include <QTemporaryDir>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/application.h"
#include "app/build_info/build_info.h"
#include "app/recording/recording.h"
#include "app/window/scan/loader.h"
#include "app/window/sessions/session_recording.h"
#include "haptics/servo/servo_loop.h"
#include "haptics/session.h"
#include "haptics/simulation/simulated.h"
#include "tests/bench/ticks.h"
#include "tests/bench/window.h"
#include "tests/support/sentence.h"
#include "ui/views/volume_view.h"
#include "ui/window/main_window.h"
#include "ui/window/views.h"

namespace {

namespace fs = std::filesystem;
using bench::jsonOf;
using bench::ticksOf;
using bench::waitFor;
using Json = nlohmann::ordered_json;

bool isRealTime(const haptics::Snapshot& snapshot) {
  return snapshot.policy == haptics::SchedulingPolicy::RealTime;
}

/// The only recording in the folder of recordings.
Json fileIn(const fs::path& folder, double seconds) {
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.path().extension() != ".palpate") continue;
    const auto recording = app::Recording::open(entry.path());
    if (!recording) return {{"failed", sentence(recording.error())}};
    const auto bytes = fs::file_size(entry.path());
    return {{"steps", recording->stepCount()},
            {"gaps", recording->lostCount()},
            {"bytes_per_step", double(bytes) / double(recording->stepCount())},
            {"bytes_per_second", double(bytes) / seconds}};
  }
  return {{"failed", "no recording was found"}};
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App cli{"A window in which a simulated hand slides, recorded, beside an empty loop."};
  std::string path, out;
  double isovalue = 0.0, seconds = 600.0;
  int hz = 4000;
  bool cut = false;
  cli.add_option("scan", path, "A scan to open; default: the demo phantom");
  cli.add_option("--isovalue", isovalue, "Isovalue of the scan's surface");
  cli.add_option("--rate", hz, "Of both loops [Hz]")->check(CLI::IsMember({1000, 2000, 4000}));
  cli.add_option("--seconds", seconds, "Of touching")->check(CLI::Range(1.0, 36'000.0));
  cli.add_flag("--cut", cut, "The hand has a burr of 4 mm, which cuts");
  cli.add_option("--out", out, "JSON, besides what is printed");
  CLI11_PARSE(cli, argc, argv);

  ui::Viewport::prepareApplication();
  int qt_argc = 1;
  QApplication qt(qt_argc, argv);
  const QTemporaryDir home;
  app::Arguments arguments =
      path.empty() ? bench::unattended(home) : bench::unattended(home, path, isovalue);
  if (path.empty()) arguments.load.phantom = "demo";
  arguments.hand = "slide";
  if (cut) arguments.load.tool = app::ToolSource{.name = "burr-4"};
  app::Application application(std::move(arguments));
  const haptics::ServoRate rate{hz};
  application.session().chooseRate(rate);
  application.window().resize(1280, 900);
  application.start();
  if (!waitFor([&] {
        return application.snapshot().scene != 0 && application.snapshot().contacts > 0;
      })) {
    std::fprintf(stderr, "No hand touched the surface within two minutes.\n");
    return 4;
  }

  haptics::LatestValue<haptics::Pose> nowhere;
  haptics::Settings settings;
  settings.isovalue = application.snapshot().isovalue;
  haptics::ServoLoop empty{haptics::openMouse(nowhere, {}, rate.period()), settings, true, rate};
  empty.start();
  if (const auto begun = application.recording().start(application.shown()->scene, ""); !begun) {
    std::fprintf(stderr, "%s\n", sentence(begun.error()).c_str());
    return 4;
  }
  haptics::Snapshot turning;
  const auto turns = [&] {
    empty.snapshots.take(turning);
    return turning.tick > 0;
  };
  if (!waitFor(turns, 10.0)) {
    std::fprintf(stderr, "The empty loop does not run.\n");
    return 4;
  }
  const bench::Ticks touch_before = ticksOf(application.snapshot()),
                     empty_before = ticksOf(turning);
  const int drawn = application.window().views().volume().frames();
  std::vector<double> p99_us;
  const auto begun = bench::Clock::now();
  int looks = 0, cutting = 0;
  while (bench::msSince(begun) < 1e3 * seconds) {
    waitFor(
        [&] {
          if (cut) application.session().holdCut(true);
          ++looks;
          cutting += application.snapshot().cuts;
          return false;
        },
        1.0);
    p99_us.push_back(1e6 * application.snapshot().tick_p99);
  }
  empty.snapshots.take(turning);
  const int pictures = application.window().views().volume().frames() - drawn;
  Json json{{"machine", app::machineHere()},
            {"version", app::versionHere()},
            {"rate_hz", hz},
            {"seconds", seconds},
            {"real_time_policy",
             {{"touch", isRealTime(application.snapshot())}, {"empty_loop", isRealTime(turning)}}},
            {"touch", jsonOf(ticksOf(application.snapshot()) - touch_before)},
            {"empty_loop", jsonOf(ticksOf(turning) - empty_before)},
            {"median_of_p99_us", bench::median(p99_us)},
            {"pictures_per_second", pictures / seconds}};
  if (cut) json["cuts_in"] = double(cutting) / looks;
  application.recording().stop();
  waitFor([&] { return application.recording().present().empty(); });
  json["file"] = fileIn(home.path().toStdString(), seconds);
  std::puts(json.dump(2).c_str());
  if (!out.empty()) std::ofstream(out) << json.dump(2) << '\n';
  application.end();
  return json["file"].contains("failed") || json["file"]["gaps"] != 0 ? 4 : 0;
}
