// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QProcess>
#include <QTimer>
#include <cstdint>
#include <vector>

#include "app/window/sound/burr_tone.h"

namespace app {

/// Plays a burr: a program of the system gets samples through its standard input, as many as time
/// goes by. One that does not read gets no more, and of one that is gone nothing is heard. It needs
/// an event loop; BurrSound gives it a thread.
class BurrPlayer : public QObject {
  Q_OBJECT
 public:
  /// Samples that a program may leave unread here, besides what its pipe holds.
  static constexpr int kMostUnread = 4'800;

  BurrPlayer();
  ~BurrPlayer() override;

  /// Whether the system has a program that plays what it reads.
  static bool isPossible();
  /// Has the program ready: it takes a while to start.
  void prepare();
  void end();
  /// How the burr runs now. Who does not say it again within a quarter of a second has stopped, as
  /// for the servo loop.
  void show(const BurrRun& run);
  /// Gives the program so many samples more, unless it has not read those from before.
  void feed(int count);
  /// Samples that wait here to be read.
  int unread() const { return static_cast<int>(program_.bytesToWrite() / kBytes); }

 private:
  static constexpr int kBytes = 2;  ///< of a sample

  void pump();

  QProcess program_;
  QTimer pumping_;
  QElapsedTimer clock_;   ///< since the burr began to turn
  QElapsedTimer told_;    ///< since show()
  std::int64_t due_ = 0;  ///< samples since then
  int after_ = 0;         ///< samples since the burr stands
  BurrRun run_;
  BurrTone tone_;
  std::vector<std::int16_t> samples_;
};

}  // namespace app
