// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "haptics/core/budget.h"
#include "haptics/proxy/following.h"
#include "haptics/proxy/proxy.h"
#include "haptics/proxy/tick.h"

namespace haptics {

/// The sub-steps of a tick: passes of steps 1 to 5, until the proxy has arrived or rests, or the
/// tick's tries or its budget are used up. Each step is a function, to be called in order. It
/// returns whether it is done; if it is not, the sub-step has ended there, or the tick is cut and
/// the next one goes on from it. Proxy::search keeps all that a cut may interrupt.
class SubSteps {
 public:
  SubSteps(const TickInput& given, Proxy& proxy, Budget& budget) HAPTICS_RT;

  /// Whether there is a sub-step to take in this tick.
  bool next() const HAPTICS_RT { return !stopped_ && search_.stage != Search::Stage::Done; }
  /// Whether it begins. Otherwise an earlier tick was cut behind step 3.
  bool begins() const HAPTICS_RT { return search_.stage == Search::Stage::Look; }
  /// 1: the motion to the device.
  void aim() HAPTICS_RT;
  /// 2: drops contacts that no longer stand in the way, and finds points near the surface. A pose
  /// that turns out to be inside is left again.
  bool findContacts() HAPTICS_RT;
  /// 3: the nearest motion that contacts allow.
  bool constrain() HAPTICS_RT;
  /// Lets the proxy take the pose reached, or not, and chooses how far to go from there.
  bool follow() HAPTICS_RT;
  /// 4: how far along the motion the tool gets.
  bool sweep() HAPTICS_RT;
  /// 5: goes there, and keeps what stood in the way.
  void go() HAPTICS_RT;

  /// After the last sub-step of the tick: back to the pose that was taken last. Sets what the
  /// result says of the search.
  void end(TickResult& result) HAPTICS_RT;

 private:
  const Tolerances& lengths() const HAPTICS_RT { return given_.lengths(); }
  /// The tool at the pose that the sub-steps have got to.
  NearTool tool() const HAPTICS_RT {
    return {given_.solid, given_.scene.tree, search_.X, proxy_.clearance};
  }
  bool unhindered() HAPTICS_RT;
  bool collect(double reach) HAPTICS_RT;
  bool reach() HAPTICS_RT;
  void shorten(double length) HAPTICS_RT;
  bool crossFreeSpace() HAPTICS_RT;
  void wait() HAPTICS_RT;
  void arrive(double advance) HAPTICS_RT;
  void retreat() HAPTICS_RT;
  void travel(double way, double turned) HAPTICS_RT;
  bool keep(const Contact& contact) HAPTICS_RT;
  bool stop() HAPTICS_RT;
  bool pause() HAPTICS_RT;
  bool endSearch() HAPTICS_RT;
  bool triedEnough() const HAPTICS_RT;
  double shareOfOneStep(const Twist& motion) const HAPTICS_RT;
  Twist limited(const Twist& motion) const HAPTICS_RT;
  bool inOneStep(const Twist& motion) const HAPTICS_RT { return shareOfOneStep(motion) == 1.0; }

  const TickInput& given_;
  Proxy& proxy_;
  Search& search_;
  Budget& budget_;
  Following following_;
  const int most_tries_;
  Clearance::Verdict found_ = Clearance::Verdict::Legal;
  Arrival here_;
  MotionRows rows_;
  int tries_ = 0;         // motions that a contact shaped or stopped, in this tick
  double gone_ = 0.0;     // m: the farthest point, in it
  bool outside_ = true;   // no pose was found inside
  bool followed_ = true;  // as far as the search has ended
  bool stopped_ = false;  // the search goes on in the next tick
  bool paused_ = false;   // although the budget is not used up
};

}  // namespace haptics
