// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <string>

#include "app/window/scan/shared_state.h"
#include "ui/window/main_window.h"
#include "ui/window/views.h"

namespace app {

/// Writes a picture of the window some time after a volume was shown, for --screenshot. Errors are
/// reported on stderr.
class ScreenshotController : public QObject {
  Q_OBJECT
 public:
  /// `path`: the picture's file, PNG or another format by its ending; empty: none. `after`: delay
  /// [s].
  ScreenshotController(ui::MainWindow& window, SharedState& shared, std::string path, double after);

  bool isWanted() const { return !path_.empty(); }
  /// A view or structures are being opened, and the picture is of them: it waits for as many
  /// arrived(), or fail().
  void await() { ++awaited_; }
  void arrived(bool done);
  /// A scene is shown.
  void prepare(bool new_volume);
  /// There is nothing to show, and why.
  void fail(const QString& sentence);

 signals:
  /// With the exit code of the program.
  void finished(int exit_code);

 private:
  void take();

  ui::MainWindow& window_;
  ui::Views& views_;
  SharedState& shared_;
  std::string path_;
  double after_;
  int awaited_ = 0;
};

}  // namespace app
