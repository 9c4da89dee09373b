// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QLabel>
#include <QTest>
#include <cstddef>

#include "tests/ui/edits/editing.h"
#include "tests/ui/window_support.h"
#include "ui/window/main_window.h"

namespace window {

/// A burr in the mouse's hand, and what it does to a plate.
class Cutting : public Editing {
 protected:
  /// A plate across the patient, and a burr of 4 mm that is ready.
  void openWithBurr();
  QString state() { return child<QLabel>("cutState").text(); }
  bool isReady() {
    return waitFor(
        [&] { return application_->snapshot().can_cut && state().startsWith("Hold X"); });
  }
  /// The hand goes there with the burr's tip, in small steps.
  void pullTip(const Vector3d& p_mm);
  /// So deep below the plate's front, and so far aside.
  static Vector3d at(double depth_mm, double aside_mm = 0.0) {
    return {aside_mm, kFront_mm + depth_mm, 0.0};
  }
  void holdKey(bool down);
  double removed_mm3();
  std::size_t strokes();
  /// Presses the burr into the plate from the front, so far beside its middle, until it has removed
  /// so much more, and lets the key go. The tool stays in contact.
  void cut(double aside_mm, double mm3);
  void lift();
  /// After a question: without a window manager the window does not become active by itself.
  void comeBack() {
    window().activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&window(), 120'000));
  }

  static constexpr double kFront_mm = -10.0;  ///< y of the plate's front; it is 20 mm thick
};

}  // namespace window
