// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <QProcess>
#include <QTemporaryDir>
#include <QTimer>
#include <optional>
#include <vector>

#include "ui/panels/nearness_lines.h"

namespace app {

/// Beeps while the tool is near a structure: the nearer it is, the sooner comes the next, and from
/// "close" on they are higher. Off at first. A program of the system plays them, so that a slow one
/// delays nothing here. GUI thread.
class NearSound : public QObject {
  Q_OBJECT
 public:
  NearSound();
  ~NearSound() override;

  /// Whether the system has a program that plays.
  static bool isPossible();
  void setOn(bool on);
  bool isBeeping() const { return next_.isActive(); }
  /// How near the tool is now; none: nothing is near.
  void show(const std::vector<ui::StructureNear>& near, const ui::NearLimits& limits);

  /// How long after a beep the next one comes [ms]; none: it is not near.
  static std::optional<int> pauseAt(double distance_mm, const ui::NearLimits& limits);

 private:
  void beep();

  QTemporaryDir sounds_;  ///< near.wav and close.wav
  QProcess player_;
  QTimer next_;
  bool on_ = false, close_ = false;
  std::optional<int> pause_;
};

}  // namespace app
