// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>

#include "haptics/carving/burr.h"
#include "haptics/carving/material.h"
#include "haptics/core/budget.h"
#include "haptics/core/geometry.h"
#include "haptics/core/realtime.h"
#include "haptics/proxy/proxy.h"
#include "haptics/scene/carved_scene.h"
#include "haptics/scene/pages_ahead.h"

namespace haptics {

/// The part of a tool that cuts: a ball.
struct Burr {
  Vec3 centre_P = Vec3::Zero();  ///< m
  double radius = 0.0;           ///< m
};

/// The ball at the lower end of a tool along its axis z.
Burr ballAtTip(const PointShell& shell, double radius);

/// N: the greatest amplitude of a burr's vibration.
inline constexpr double kMostVibration = 0.5;
/// Hz: what is rendered of the frequency with which the teeth of a burr pass, at `speed` [rad/s]
/// and a tick of `period` [s]: itself, or its nearest subharmonic of at most 250 Hz, where skin
/// feels most [Bolanowski 1988], and a quarter of the rate of ticks.
double vibrationFrequency(double speed, double period) HAPTICS_RT;

/// How a burr removes material: as much in a second as
///
///   Q = share F speed radius / energy,
///
/// F the normal force on the burr, so that the power of its friction becomes energy of removal
/// [Agus 2003]; the energy that a volume takes is a constant of the material [Arbabtafti 2011].
struct CutLaw {
  Burr burr;
  double speed = 6283.0;  ///< rad/s; a surgical drill turns 10,000 to 80,000 times a minute
  /// Tangential force on the burr over the normal one, some 0.1 to 0.6; 0.3 is a choice.
  double share = 0.3;
  /// Amplitude of the vibration over the normal force, 0 to 1; 0: none. It is along that force, at
  /// the frequency with which teeth pass, so it never turns the push into a pull.
  double vibration = 0.0;
  /// By the scan's value. For cortical bone it is some 0.05 J/mm3 where chips are a tenth of a
  /// millimetre thick, and tens of times more where they are microns thin [Wiggins 1978]; 1 J/mm3
  /// is a choice between them.
  Material material;
};

/// Cuts with the tool's burr where the proxy is pressed against the surface. Servo thread, but for
/// its making.
class Cutting {
 public:
  Cutting(std::unique_ptr<CarvedScene> carved, const CutLaw& law)
      : carved_{std::move(carved)}, law_{law} {}

  /// Has pages copied before cuts write there, by a thread of its own, from now on.
  void lookAhead();
  /// The scene to touch. It changes with each cut.
  const std::shared_ptr<const Scene>& scene() const HAPTICS_RT { return carved_->scene(); }
  const CutLaw& law() const HAPTICS_RT { return law_; }

  /// After a tick: goes on with the cut under way, or begins the next while `held`. Returns the
  /// burr's drag on the hand, about the origin of D: up to the law's share of the normal force,
  /// against the device's motion along the surface; and its vibration, if the law has one. What a
  /// turning burr does besides, walk across its path, is left out: it would push a hand that did
  /// not ask for it.
  Wrench go(bool held, Proxy& proxy, const Pose& X_WD, double isovalue, double period,
            Budget& budget) HAPTICS_RT;

  /// Carries out a cut that was made before, whole. Before the first tick; not for the servo
  /// thread.
  void make(const BurrCut& cut);
  /// Carries the cut under way to its end, and has exact bounds, as after ticks without a cut. Not
  /// for the servo thread.
  void settle();
  /// A tick in which nothing is touched: no cut goes on.
  void skip() HAPTICS_RT { begun_.reset(); }
  /// Forgets the hand, the debt, the stand-off and what was removed, as Proxy::forget() does what
  /// the proxy found. A cut under way goes on.
  void forget() HAPTICS_RT;
  /// The cut that the last call began, if it did.
  const std::optional<BurrCut>& begun() const HAPTICS_RT { return begun_; }
  /// Since it was made, or forget().
  const Removed& removed() const HAPTICS_RT { return removed_; }
  double force() const HAPTICS_RT { return force_; }  ///< N, on the burr in the last call

 private:
  /// N, W: what the surface does to the burr.
  Vec3 pressOn(const Proxy& proxy) const HAPTICS_RT;
  void begin(const Vec3& press_W, const Vec3& centre_W, double isovalue) HAPTICS_RT;
  Vec3 dragFor(const Vec3& press_W, const Pose& X_WD, double period) HAPTICS_RT;
  Vec3 vibrationFor(const Vec3& press_W, double period) HAPTICS_RT;
  void forgetHand() HAPTICS_RT;
  void finish();

  std::unique_ptr<CarvedScene> carved_;
  std::unique_ptr<PagesAhead> ahead_;  ///< null: pages are copied when they are written
  CutLaw law_;
  Removed removed_;
  /// J that the law has given and cuts have not taken yet; below 0 they took more.
  double owed_ = 0.0;
  double standoff_ = 0.0;       ///< m: of the tool before the surface that it rests on
  double untouched_ = 0.0;      ///< s
  std::optional<Vec3> last_W_;  ///< where the last cut ended; none: the next begins anew
  std::optional<BurrCut> begun_;
  double force_ = 0.0;
  std::optional<Vec3> burr_WD_;     ///< m: of the device's burr, in the last tick
  Vec3 velocity_W_ = Vec3::Zero();  ///< m/s: of the device's burr, smoothed
  Vec3 drag_W_ = Vec3::Zero();      ///< N, smoothed
  double shake_ = 0.0;              ///< N: the vibration's amplitude, smoothed
  double passed_ = 0.0;             ///< periods of the vibration since it began, 0 to 1
};

}  // namespace haptics
