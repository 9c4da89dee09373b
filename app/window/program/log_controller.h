// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <filesystem>

#include "app/window/scan/shared_state.h"
#include "haptics/core/error.h"
#include "ui/panels/recording_panel.h"
#include "ui/window/menus.h"
#include "ui/window/messages.h"
#include "ui/window/views.h"

namespace app {

/// Writes into the log what the window does, and shows the log. What others tell it is made words
/// of the log here, so that no text of a scan is among them.
class LogController : public QObject {
  Q_OBJECT
 public:
  /// `folder`: of the log; empty: there is none, and only showing it is refused.
  LogController(ui::Views& views, ui::Messages& messages, ui::Menus& menus, SharedState& shared,
                std::filesystem::path folder);

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

  ui::Messages& messages_;
  SharedState& shared_;
  std::filesystem::path folder_;
  QElapsedTimer since_loading_;
  ui::RecordingStatus recording_;
};

}  // namespace app
