// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <filesystem>

#include "app/window/shared_state.h"
#include "haptics/core/error.h"
#include "ui/main_window.h"
#include "ui/panels/recording_panel.h"

namespace app {

/// Writes into the log what the window does, and shows the log. What others tell it is made words
/// of the log here, so that no text of a scan is among them.
class LogController : public QObject {
  Q_OBJECT
 public:
  /// `folder`: of the log; empty: there is none, and only showing it is refused.
  LogController(ui::MainWindow& window, SharedState& shared, std::filesystem::path folder);

  void noteLoading() { since_loading_.start(); }
  void noteScene(bool new_volume);
  void noteRefusal(const haptics::Error& error);
  /// `id`: of a hand or a device; only its kind is written.
  void noteHand(const QString& id);
  /// "from -> to, reason", as recordings have it.
  void noteForce(const QString& transition);
  void noteRecording(const ui::RecordingStatus& status) { recording_ = status; }
  void noteRecorded(bool well);
  /// How well the servo thread kept its time since it was started.
  void noteServo();

 private:
  void show();

  ui::MainWindow& window_;
  SharedState& shared_;
  std::filesystem::path folder_;
  QElapsedTimer since_loading_;
  ui::RecordingStatus recording_;
};

}  // namespace app
