// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace app {

/// Checks for an X display before Qt or VTK starts, because both end the process without one. A
/// virtual X server resets when its last client disconnects, and does not answer meanwhile. So the
/// connection stays open until Qt or VTK has opened its own.
class HeldDisplay {
 public:
  HeldDisplay();  ///< waits up to a second if DISPLAY is set and the server does not answer
  ~HeldDisplay();
  HeldDisplay(const HeldDisplay&) = delete;
  HeldDisplay& operator=(const HeldDisplay&) = delete;

  /// Whether Qt can open a window on the display. Also false if QT_QPA_PLATFORM names another
  /// platform.
  bool showsWindows() const;
  /// Whether VTK can draw on the display without a Qt window: whether it has GLX.
  bool draws() const;

 private:
  void* display_;
};

}  // namespace app
