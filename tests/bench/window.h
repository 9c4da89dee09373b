// SPDX-License-Identifier: BSD-3-Clause

// A window that a benchmark works: how it is opened and waited for.
#pragma once

#include <QCoreApplication>
#include <QSettings>
#include <QTemporaryDir>
#include <algorithm>
#include <chrono>
#include <functional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "app/application.h"
#include "app/measurement/quantile.h"

namespace bench {

using Clock = std::chrono::steady_clock;

inline double msSince(Clock::time_point begun) {
  return std::chrono::duration<double, std::milli>(Clock::now() - begun).count();
}

/// What this share of the values does not exceed.
inline double share(std::vector<double> values, double of) {
  std::ranges::sort(values);
  return measurement::quantile(values, of);
}
inline double median(std::vector<double> values) { return share(std::move(values), 0.5); }

/// Whether it came true within `longest_s` seconds; the window is at work meanwhile.
inline bool waitFor(const std::function<bool()>& done, double longest_s = 120.0) {
  const auto begun = Clock::now();
  while (!done() && msSince(begun) < longest_s * 1e3) {
    QCoreApplication::processEvents(QEventLoop::AllEvents, 20);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return done();
}

/// A window that asks nothing, knows no preferences of this user, and keeps none; its recordings
/// are in `home`.
inline app::Arguments unattended(const QTemporaryDir& home) {
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, home.path());
  app::Arguments arguments;
  arguments.screenshot = "unused";  // whoever asks for one has no preferences
  arguments.screenshot_after = 1e6;
  arguments.notice = false;
  arguments.recordings = home.path().toStdString();
  return arguments;
}

/// The same, with a scan and the probe.
inline app::Arguments unattended(const QTemporaryDir& home, const std::string& path,
                                 double isovalue) {
  app::Arguments arguments = unattended(home);
  arguments.load.path = path;
  arguments.load.isovalue = isovalue;
  arguments.load.tool = app::ToolSource{};
  return arguments;
}

}  // namespace bench
