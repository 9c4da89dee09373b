// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <filesystem>
#include <string>

#include "app/background/task.h"
#include "ui/window/messages.h"

namespace app {

/// Makes the report of a crash that an earlier start left, and offers to show it. The report stays
/// on this machine.
class CrashController : public QObject {
  Q_OBJECT
 public:
  /// `folder`: of log and reports; empty: nothing is looked for.
  CrashController(ui::Messages& messages, std::filesystem::path folder);

  /// Looks on another thread.
  void look();

 private:
  void show(const QString& report);

  ui::Messages& messages_;
  std::filesystem::path folder_;
  background::Task<std::string> task_;  ///< the report; empty: there was no crash
};

}  // namespace app
