// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>

#include <vtkVersion.h>

#include <QApplication>
#include <charconv>
#include <csignal>
#include <cstdio>
#include <exception>
#include <optional>
#include <sstream>
#include <system_error>
#include <utility>

#include "app/application.h"
#include "app/build_info/build_info.h"
#include "app/crash/raw_file.h"
#include "app/display.h"
#include "app/log/log.h"
#include "app/recording/volume_hash.h"
#include "app/signals.h"
#include "app/window/program/journal.h"
#include "app/window/program/preferences.h"
#include "datasets/phantoms/phantoms.h"
#include "datasets/readers/files/archive.h"
#include "haptics/process/process_limits.h"
#include "haptics/servo/emergency.h"
#include "resources/named_tools.h"
#include "ui/controls/language.h"
#include "ui/props/viewport.h"
#include "ui/style/style.h"

namespace {

constexpr int kUsage = 2, kFailed = 4;

/// CLI11's own range takes "nan" for a number within it.
CLI::Validator numberIn(double least, double greatest) {
  return {[least, greatest](const std::string& text) {
            double number = 0.0;
            const char* const end = text.data() + text.size();
            const auto [stop, error] = std::from_chars(text.data(), end, number);
            const bool holds =
                error == std::errc{} && stop == end && number >= least && number <= greatest;
            std::ostringstream words;
            words << '"' << text << "\" is no number from " << least << " to " << greatest;
            return holds ? std::string{} : words.str();
          },
          "NUMBER"};
}

// a list of names as CLI11 wants it
template <class Names>
CLI::Validator oneOf(const Names& names) {
  return CLI::IsMember(std::vector<std::string>(names.begin(), names.end()));
}

// The arguments as CLI11 reads them. Where several paths may come, it takes a path "[name]" for a
// list, so such a path is "./[name]".
std::vector<std::string> wordsOf(int argc, char** argv) {
  std::vector<std::string> words(argv, argv + argc);
  for (std::string& word : words)
    if (word.starts_with('[')) word.insert(0, "./");
  return words;
}

int run(int argc, char** argv) {
  haptics::installCrashStop();
  app::blockEndingSignals();
  app::Arguments arguments;
  std::vector<std::string> paths;
  std::string phantom, tool, tool_unit = "mm", surface, log_level = "info";
  double isovalue = 0.0;
  int series = 0;
  bool no_notice = false, correct = false;
  CLI::App cli{"Palpate: see a CT scan, and feel it through a haptic device."};
  cli.set_version_flag("--version", PALPATE_VERSION);
  auto* path_given =
      cli.add_option("path", paths,
                     "A scan: DICOM folder or files, NRRD, MetaImage or NIfTI; or a recording or a "
                     "view of Palpate's. Several files of one folder open the folder");
  auto* phantom_given = cli.add_option("--phantom", phantom, "A volume made by formula")
                            ->check(oneOf(datasets::phantomNames()));
  path_given->excludes(phantom_given);
  auto* isovalue_given =
      cli.add_option("--isovalue", isovalue, "Intensity of the surface, in the volume's unit")
          ->check(numberIn(-1e38, 1e38));
  auto* tool_given =
      cli.add_option("--tool", tool, resources::namesOfTools() + ", or an STL, OBJ or PLY file");
  cli.add_option("--tool-unit", tool_unit, "Unit of a tool file")
      ->check(CLI::IsMember({"m", "mm", "cm", "in"}));
  cli.add_option("--hand", arguments.hand, "The hand that holds the device")
      ->check(CLI::IsMember({"mouse", "tap", "slide", "wedge", "pry", "hook", "jerk", "twist"}));
  auto* surface_given = cli.add_option("--surface", surface, "How the surface is drawn")
                            ->check(CLI::IsMember({"raycast", "mesh"}));
  auto* series_given = cli.add_option("--series", series, "Number of a series of a folder");
  auto* labels_given = cli.add_option("--labels", arguments.labels,
                                      "Structures of the scan: a segmentation by another program");
  cli.add_flag("--correct", correct, "Resample slices that are tilted or unevenly spaced");
  auto* screenshot_given =
      cli.add_option("--screenshot", arguments.screenshot, "Write the window as a PNG and quit");
  cli.add_option("--after", arguments.screenshot_after, "Seconds before the screenshot")
      ->check(numberIn(0.0, 3600.0))
      ->needs(screenshot_given);
  cli.add_flag("--no-notice", no_notice, "Do not show the notice of the first start");
  cli.add_option("--log-level", log_level, "Least severity that the log keeps")
      ->check(CLI::IsMember({"error", "warning", "info", "debug", "off"}));
  try {
    const std::vector<std::string> words = wordsOf(argc, argv);
    std::vector<const char*> read;
    for (const std::string& word : words) read.push_back(word.c_str());
    cli.parse(static_cast<int>(read.size()), read.data());
    if (*labels_given && !*path_given && !*phantom_given)
      throw CLI::RequiresError("--labels", "path or --phantom");
  } catch (const CLI::ParseError& error) {
    return cli.exit(error) == 0 ? 0 : kUsage;
  }
  for (const std::string& path : paths) arguments.paths.append(QString::fromStdString(path));
  if (*phantom_given) arguments.load.phantom = phantom;
  if (*isovalue_given) arguments.load.isovalue = isovalue;
  if (*series_given) arguments.load.series = series;
  if (correct) arguments.load.geometry = datasets::Geometry::Corrected;
  if (*tool_given) {
    app::ToolSource source{.name = tool, .unit = tool_unit};
    if (resources::findNamedTool(tool) == nullptr) source.file = tool;
    arguments.load.tool = source;
  }
  if (*surface_given)
    arguments.surface = surface == "mesh" ? ui::SurfaceMode::Mesh : ui::SurfaceMode::RayCast;
  arguments.state = app::log::stateFolder();
  arguments.notice = !no_notice && arguments.screenshot.empty();

  const app::crash::RawFile crash_file{arguments.state};
  app::log::open(arguments.state, app::log::levelOf(log_level));
  app::log::write(app::log::Level::Info, "start",
                  {{"version", app::log::nameOfProgram(PALPATE_VERSION)},
                   {"build", app::log::nameOfProgram(app::buildHere())},
                   {"qt", app::log::nameOfProgram(qVersion())},
                   {"vtk", app::log::nameOfProgram(vtkVersion::GetVTKVersion())}});
  std::optional<app::HeldDisplay> display{std::in_place};
  if (!display->showsWindows()) {
    std::fprintf(stderr,
                 "There is no X display to open a window on; set DISPLAY, or use "
                 "palpate-cli, which needs none.\n");
    return kFailed;
  }
  // VTK's windows are X windows, also where Qt would choose Wayland
  qputenv("QT_QPA_PLATFORM", "xcb");
  ui::Viewport::prepareApplication();
  app::nameApplication();
  QCoreApplication::setApplicationVersion(PALPATE_VERSION);
  QGuiApplication::setDesktopFileName("palpate");
  int qt_argc = 1;  // the arguments are ours
  QApplication qt(qt_argc, argv);
  if (arguments.screenshot.empty()) arguments.journal = app::ownJournal();
  const app::Preferences preferences = app::loadPreferences();
  ui::setLanguage(preferences.language);
  ui::style::applyTheme(qt, ui::style::themeOf(preferences.theme));
  display.reset();  // Qt holds its own
  datasets::sweepTemporaryFolders();
  // a file that may not grow further is an error like any other
  std::signal(SIGXFSZ, SIG_IGN);
  app::Application application(std::move(arguments));
  QObject::connect(
      &application, &app::Application::finished, &qt,
      [](int code) { QCoreApplication::exit(code); }, Qt::QueuedConnection);
  bool ended = false;  // in the loop of a question, before the one below
  // as if the user had closed the window, whatever question stands open; none is asked
  const app::EndingSignals ending([&] {
    QMetaObject::invokeMethod(
        &application,
        [&] {
          ended = true;
          application.end();
          QCoreApplication::exit(0);
        },
        Qt::QueuedConnection);
  });
  application.start();
  return ended ? 0 : QApplication::exec();
}

}  // namespace

int main(int argc, char** argv) {
  haptics::forbidCoreDumps();  // names and scans lie in memory
  try {
    return run(argc, argv);
  } catch (const std::exception&) {
    std::fprintf(
        stderr,
        "The system has no thread or no memory left for this; close other programs and try "
        "again.\n");
    return kFailed;
  }
}
