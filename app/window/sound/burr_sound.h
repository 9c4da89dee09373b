// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QThread>

#include "app/window/sound/burr_player.h"

namespace app {

/// The sound of the burr, off at first. It is made and played in a thread of its own, so that it
/// does not break off while a picture is drawn, and no program delays the window. GUI thread.
class BurrSound {
 public:
  BurrSound() = default;
  BurrSound(const BurrSound&) = delete;
  BurrSound& operator=(const BurrSound&) = delete;
  ~BurrSound();

  void setOn(bool on);
  /// How the burr runs; call it at display rate.
  void show(const BurrRun& run);

 private:
  QThread thread_;
  BurrPlayer* player_ = nullptr;  ///< the thread's; null: off until now
  bool on_ = false;
  bool turned_ = false;  ///< as was said last
};

}  // namespace app
