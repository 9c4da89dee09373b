// SPDX-License-Identifier: BSD-3-Clause

// palpate-moving: what a picture costs in the whole window while the camera turns, and how long a
// new surface takes while the isovalue is dragged.

#include <QApplication>
#include <QMouseEvent>
#include <QTemporaryDir>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/application.h"
#include "app/build_info/build_info.h"
#include "app/window/scan/loader.h"
#include "tests/bench/window.h"
#include "ui/views/volume_view.h"
#include "ui/window/main_window.h"
#include "ui/window/views.h"

namespace {

using bench::Clock;
using bench::median;
using bench::msSince;
using bench::share;
using bench::waitFor;

constexpr int kWarm = 10;         // pictures before those that count
constexpr double kTurn_px = 7.0;  // of the mouse, for a picture
constexpr double kDrag = 0.003;   // of the range of the voxels, for a picture

double cpuOf(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return double(now.tv_sec) * 1e3 + double(now.tv_nsec) * 1e-6;
}

void turn(ui::VolumeView& view, QPointF& at, QPointF by) {
  at += by;
  QMouseEvent move(QEvent::MouseMove, at, view.mapToGlobal(at), Qt::NoButton, Qt::LeftButton, {});
  QCoreApplication::sendEvent(&view, &move);
}

/// Milliseconds from the wish for an isovalue, as the slider tells it, to the window with its
/// surface on the screen; over a sixteenth of the range from `isovalue` on.
std::vector<double> drag(app::Application& application, double isovalue, int pictures) {
  const haptics::Volume& volume = *application.shown()->volume();
  const double step = kDrag * (volume.greatest - volume.least);
  int swapped = 0;
  const auto counted = QObject::connect(&application.window().views().volume(),
                                        &QOpenGLWidget::frameSwapped, [&] { ++swapped; });
  std::vector<double> wall;
  for (int n = -kWarm; n < pictures; ++n) {
    const int drawn = application.window().views().volume().frames();
    const auto begun = Clock::now();
    emit application.window().views().isovalueWanted(isovalue + step * (1 + (n + kWarm) % 20));
    const bool done = waitFor([&] {
      if (application.window().views().volume().frames() == drawn) swapped = 0;
      return swapped > 0;
    });
    if (done && n >= 0) wall.push_back(msSince(begun));
  }
  QObject::disconnect(counted);
  return wall;
}

void rest(double seconds) {
  const auto begun = Clock::now();
  waitFor([&] { return msSince(begun) > seconds * 1e3; });
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App cli{"What a picture of the 3-D view costs while the camera turns."};
  std::string path, out;
  double isovalue = 0.0, second = 0.0, settle_s = 8.0;
  int pictures = 120;
  bool ray_cast = false;
  cli.add_option("scan", path, "A scan to open")->required();
  cli.add_option("--isovalue", isovalue, "Isovalue of the surface")->required();
  auto* second_given = cli.add_option("--second", second, "Isovalue of a second surface");
  cli.add_option("--pictures", pictures, "Pictures that count")->check(CLI::Range(10, 10'000));
  cli.add_option("--settle", settle_s, "Seconds of rest before, for the fine mesh");
  cli.add_flag("--ray-cast", ray_cast, "The surface ray-cast, for machines with a graphics card");
  cli.add_option("--out", out, "JSON, besides what is printed");
  CLI11_PARSE(cli, argc, argv);

  ui::Viewport::prepareApplication();
  int qt_argc = 1;
  QApplication qt(qt_argc, argv);
  const QTemporaryDir home;
  app::Arguments arguments = bench::unattended(home, path, isovalue);
  if (ray_cast) arguments.surface = ui::SurfaceMode::RayCast;
  app::Application application(std::move(arguments));
  application.window().resize(1280, 900);
  application.start();
  ui::VolumeView& view = application.window().views().volume();
  if (!waitFor([&] { return application.snapshot().scene != 0; })) {
    std::fprintf(stderr, "'%s' was not opened within two minutes.\n", path.c_str());
    return 4;
  }
  if (*second_given) view.setSecondSurface(second);
  rest(settle_s);

  QPointF at = view.rect().center();
  QMouseEvent press(QEvent::MouseButtonPress, at, view.mapToGlobal(at), Qt::LeftButton,
                    Qt::LeftButton, {});
  QCoreApplication::sendEvent(&view, &press);
  std::vector<double> wall, cpu, gui;
  for (int n = -kWarm; n < pictures; ++n) {
    const int before = view.frames();
    const auto begun = Clock::now();
    const double all = cpuOf(CLOCK_PROCESS_CPUTIME_ID), mine = cpuOf(CLOCK_THREAD_CPUTIME_ID);
    // a third of them tilt the view
    turn(view, at,
         n % 3 == 0 ? QPointF{0.0, n % 2 == 0 ? kTurn_px : -kTurn_px} : QPointF{kTurn_px, 0.0});
    while (view.frames() == before && msSince(begun) < 5'000.0)
      QCoreApplication::processEvents(QEventLoop::AllEvents, 1);
    if (n < 0) continue;
    wall.push_back(msSince(begun));
    cpu.push_back(cpuOf(CLOCK_PROCESS_CPUTIME_ID) - all);
    gui.push_back(cpuOf(CLOCK_THREAD_CPUTIME_ID) - mine);
  }
  std::printf("%s at %g%s: view of %d x %d, %d pictures\n",
              std::filesystem::path(path).filename().c_str(), isovalue,
              *second_given ? ", with a second surface" : "", view.width(), view.height(),
              pictures);
  std::printf(
      "  median of a picture: wall %.1f ms (%.1f a second), CPU %.1f ms of all threads, "
      "%.1f of the GUI's\n",
      median(wall), 1e3 / median(wall), median(cpu), median(gui));
  QMouseEvent release(QEvent::MouseButtonRelease, at, view.mapToGlobal(at), Qt::LeftButton,
                      Qt::NoButton, {});
  QCoreApplication::sendEvent(&view, &release);
  rest(settle_s);

  const std::vector<double> wanted_to_drawn = drag(application, isovalue, pictures);
  std::printf("  isovalue dragged, from wanted to drawn: median %.1f ms, nine of ten within %.1f\n",
              median(wanted_to_drawn), share(wanted_to_drawn, 0.9));
  if (!out.empty())
    std::ofstream(out) << nlohmann::ordered_json{{"machine", app::machineHere()},
                                                 {"version", app::versionHere()},
                                                 {"of",
                                                  std::filesystem::path(path).filename().string()},
                                                 {"view", {view.width(), view.height()}},
                                                 {"pictures", pictures},
                                                 {"turned",
                                                  {{"wall_ms", median(wall)},
                                                   {"cpu_ms", median(cpu)},
                                                   {"gui_ms", median(gui)}}},
                                                 {"isovalue_dragged",
                                                  {{"median_ms", median(wanted_to_drawn)},
                                                   {"nine_of_ten_ms", share(wanted_to_drawn, 0.9)},
                                                   {"most_ms", share(wanted_to_drawn, 1.0)}}}}
                              .dump(2)
                       << '\n';
  return 0;
}
