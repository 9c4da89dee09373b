// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace app {

/// Whether there is an X display to open a window on. Waits up to a second for one that is named
/// and does not answer, as displayDraws does. Asked before anything of Qt or VTK begins,
/// because both end the process where there is none.
bool displayReachable();

/// Whether VTK can draw without a window of Qt's: an X display that knows GLX.
bool displayDraws();

/// An open X display. A virtual one begins anew when its last client has gone, and VTK ends the
/// process where it is asked meanwhile: so it is held from the check until VTK is done.
class HeldDisplay {
 public:
  HeldDisplay();  ///< waits as displayDraws does
  ~HeldDisplay();
  HeldDisplay(const HeldDisplay&) = delete;
  HeldDisplay& operator=(const HeldDisplay&) = delete;
  /// As displayDraws.
  bool draws() const;

 private:
  void* display_;
};

}  // namespace app
