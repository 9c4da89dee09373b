// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace app {

/// An open X display. Qt and VTK both end the process where there is none, so this is asked before
/// either begins. A virtual display begins anew when its last client has gone and answers nobody
/// meanwhile: so it is held from the check until whoever draws has opened it too.
class HeldDisplay {
 public:
  HeldDisplay();  ///< waits up to a second for a display that is named and does not answer
  ~HeldDisplay();
  HeldDisplay(const HeldDisplay&) = delete;
  HeldDisplay& operator=(const HeldDisplay&) = delete;

  /// Whether Qt can open a window on it: false too where QT_QPA_PLATFORM names another platform.
  bool showsWindows() const;
  /// Whether VTK can draw on it without a window of Qt's: it knows GLX.
  bool draws() const;

 private:
  void* display_;
};

}  // namespace app
