// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>

namespace app {

/// How a burr runs.
struct BurrRun {
  bool turns = false;
  double speed_rpm = 0.0;  ///< without load
  double force = 0.0;      ///< N, on the burr
};

/// The sound of a burr, made of its speed and its load alone: the whine of its turns, and the
/// rattle of its teeth. Under load the pitch falls, and both grow louder and rougher. What they
/// are made of are choices, not measurements of a drill. It begins and ends within 40 ms, and has
/// no jump whenever anything changes.
class BurrTone {
 public:
  static constexpr int kRate = 48'000;  ///< samples/s, of one channel
  static constexpr int kFade = 1'920;   ///< samples

  /// Turns in a second under this load [Hz].
  static double pitchOf(const BurrRun& run);

  /// Makes the samples that come next. While the burr does not turn its numbers count for nothing.
  void fill(std::span<std::int16_t> samples, const BurrRun& run);

 private:
  double nextNoise();

  double gain_ = 0.0;       ///< 0: silent, 1: whole
  double phase_ = 0.0;      ///< turns
  double frequency_ = 0.0;  ///< turns/s
  double load_ = 0.0;       ///< 0: none, 1: as great as can be
  double rattle_ = 0.0;     ///< noise of the teeth
  double unrest_ = 0.0;     ///< slow noise: how the bite changes
  std::uint32_t random_ = 1;
};

}  // namespace app
