// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/session.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <system_error>
#include <utility>
#include <vector>

#include "haptics/core/clock.h"
#include "haptics/scene/legal_pose.h"
#include "haptics/servo/servo_loop.h"
#include "haptics/simulation/allowed_stiffness.h"
#include "haptics/simulation/simulated.h"

namespace haptics {
namespace {

constexpr double kDepth = 0.004;  // m that a simulated hand brings the device beyond the surface
constexpr std::uint64_t kSeed = 1;

Error nothingToTouch() { return {Error::Kind::NotFound, {"scene-no-volume", {}}}; }
Error noRoom() { return {Error::Kind::Unsupported, {"session-no-room", {}}}; }

/// What Settings allows; a number that is not finite stays what it was.
Settings withinRange(Settings settings, const Settings& before) {
  const auto keep = [&](double Settings::*member, Range range) {
    double& value = settings.*member;
    value = std::isfinite(value) ? std::clamp(value, range.least, range.most) : before.*member;
  };
  keep(&Settings::stiffness, kStiffnessRange);
  keep(&Settings::angular_stiffness, kAngularStiffnessRange);
  keep(&Settings::friction, kFrictionRange);
  keep(&Settings::force_scale, kScaleRange);
  keep(&Settings::position_scale, kScaleRange);
  return settings;
}

/// N/m and N·m/rad that do not pass what the device may render stably: K at the hand is K at the
/// volume times both scales, and no more than allowed, or where that is `lifted`, than rated.
Settings underRating(Settings settings, const DeviceRating& rating, ServoRate rate,
                     const Scene* scene, bool lifted) {
  settings.stiffness *= settings.force_scale;
  settings.angular_stiffness *= settings.force_scale;
  // without motors for torque no hand feels it, and the limit below is that of the tool's own
  if (rating.stiffness > 0.0 && rating.torque == 0.0) settings.angular_stiffness = 0.0;
  if (rating.stiffness > 0.0) {
    const PointShell none;
    const PointShell& shell = scene == nullptr ? none : scene->tool.shell;
    const double most =
        lifted ? rating.stiffness : allowedStiffness(rating, shell, {rate.period(), rating.delay});
    settings.stiffness = std::min(settings.stiffness, most / settings.position_scale);
  }
  if (rating.torque > 0.0 && rating.angular_stiffness > 0.0) {
    double angular = settings.angular_stiffness;
    if (angular == 0.0 && scene != nullptr)
      angular = settings.stiffness * largestInertia(scene->tool.shell.inertia);
    if (angular > rating.angular_stiffness) settings.angular_stiffness = rating.angular_stiffness;
  }
  return settings;
}

/// What the grip of the mouse and of the simulated hands carries.
Settings underGrip(Settings settings, ServoRate rate, const Scene* scene) {
  if (scene != nullptr)
    settings.stiffness =
        std::min(settings.stiffness, allowedStiffness(Grip{}, scene->tool.shell, rate.period()));
  return settings;
}

HandMotion motionOf(HandKind hand) {
  switch (hand) {
    case HandKind::Slide:
      return HandMotion::Slide;
    case HandKind::Wedge:
      return HandMotion::Wedge;
    case HandKind::Pry:
      return HandMotion::Pry;
    case HandKind::Hook:
      return HandMotion::Hook;
    case HandKind::Jerk:
      return HandMotion::Jerk;
    case HandKind::Twist:
      return HandMotion::Twist;
    case HandKind::Tap:
    case HandKind::Mouse:
      break;
  }
  return HandMotion::Tap;
}

}  // namespace

/// The GUI's side of an open loop, and what outlives one.
class Session::Loop {
 public:
  /// How hot the motors of a model were left. Opened anew, they are no cooler than time has made
  /// them.
  struct Warmth {
    std::string_view model = {};  ///< id of its rating
    double heat = 0.0;
    std::int64_t left_ns = 0;

    double of(const DeviceRating& opened) const {
      if (model != opened.id) return 0.0;
      return heat * std::exp(-1e-9 * double(monotonicNs() - left_ns) / ForceLimits::kWarmUp);
    }
  };

  LatestValue<Pose> mouse;                         // before the servo: its device reads from it
  std::shared_ptr<StepRing> ring;                  ///< where steps go; outlives the servo
  std::vector<std::shared_ptr<StepRing>> leaving;  ///< where the last ones may yet go
  std::shared_ptr<const Watch> watch;              ///< in use; outlives the servo
  std::vector<std::shared_ptr<const Watch>> unwatched;  ///< may yet be in use
  std::unique_ptr<ServoLoop> servo;
  std::shared_ptr<const Scene> scene;
  std::unique_ptr<Cutting> cutting;  ///< of the scene, while no loop has it
  std::deque<BurrCut> cuts_left;     ///< of a loop that has ended
  Pose X_start = Pose::Identity();
  Settings settings;
  std::optional<DeviceRating> rating;  ///< of the real device that is open
  bool lifted = false;                 ///< it may have all that it is rated for
  Warmth warmth;                       ///< of the one before
  std::optional<ServoRate> wished;     ///< of the next hand
  ServoRate rate;                      ///< of the open hand
  Handling handling;

  /// Takes over, with the proxy at X_WP.
  Expected<void> begin(std::unique_ptr<ServoLoop> loop, const Pose& X_WP) {
    servo = std::move(loop);
    if (cutting) {
      cutting->forget();
      servo->scenes.offer(std::make_unique<Engagement>(std::move(cutting), X_WP));
    } else {
      servo->scenes.offer(std::make_unique<Engagement>(scene, X_WP));
    }
    servo->recording.store(ring.get());
    servo->watch.store(watch.get());
    servo->cut_until = cut_until;
    servo->cut_rests = cut_rests;
    rested_at = 0;
    try {
      servo->start();
    } catch (const std::system_error&) {
      keep();
      servo.reset();
      return tl::unexpected(Error{Error::Kind::Unsupported, {"touch-no-thread", {}}, "no-thread"});
    }
    return {};
  }
  /// Keeps what cuts in the scene for the next loop.
  void keep() {
    if (scene) cutting = servo->scenes.release(scene->id);
  }
  bool armed = true;            ///< the user's word, through every hand and scene
  std::int64_t cut_until = 0;   ///< holdCut(), through every hand
  bool cut_rests = false;       ///< restCut(), through every hand
  std::uint64_t rested_at = 0;  ///< the boundary behind which no cut is begun
  std::uint64_t left_at = 0;    ///< the boundary behind which they do no more
  std::uint64_t unwatched_at = 0;
};

Session::Session() : loop_{std::make_unique<Loop>()} {}
Session::~Session() = default;

Expected<void> Session::open(HandKind hand, const std::optional<Pose>& from) {
  if (!loop_->scene) return tl::unexpected(nothingToTouch());
  const ServoRate rate = loop_->wished.value_or(ServoRate{});
  const Settings settings = underGrip(loop_->settings, rate, loop_->scene.get());
  Grip grip;
  grip.gyration = gyrationOf(loop_->scene->tool.shell);
  Pose X_start = from.value_or(loop_->X_start);
  std::optional<Hand> path;
  if (hand != HandKind::Mouse) {
    const double reach = Hand::reachFor(kDepth, settings.stiffness, grip.stiffness);
    const double isovalue = loop_->settings.isovalue;
    auto aimed = from ? Hand::from(*from, motionOf(hand), *loop_->scene, isovalue, reach, kSeed)
                      : Hand::aimed(motionOf(hand), *loop_->scene, isovalue, reach, kSeed);
    if (!aimed) return tl::unexpected(aimed.error());
    X_start = aimed->at(0.0);
    path = std::move(*aimed);
  }
  const std::optional<Pose> legal = legalPoseNear(*loop_->scene, loop_->settings.isovalue, X_start);
  if (!legal) return tl::unexpected(noRoom());

  // from here on only a thread can lack: the old hand lets go, the new one takes over
  close();
  loop_->rate = rate;
  loop_->X_start = X_start;
  grip.X_WD = X_start;
  std::unique_ptr<Device> device;
  if (path) {
    device = openSimulated(std::move(*path), grip, rate.period());
  } else {
    loop_->mouse.publish(X_start);
    device = openMouse(loop_->mouse, grip, rate.period());
  }
  return loop_->begin(std::make_unique<ServoLoop>(std::move(device), settings, loop_->armed, rate),
                      *legal);
}

Expected<void> Session::open(std::unique_ptr<Device> device) {
  if (!loop_->scene) return tl::unexpected(nothingToTouch());
  const std::optional<Pose> legal =
      legalPoseNear(*loop_->scene, loop_->settings.isovalue, loop_->X_start);
  if (!legal) return tl::unexpected(noRoom());
  close();
  loop_->rating = device->rating();
  const ServoRate most = rateOf(*loop_->rating);
  loop_->rate = {std::min(loop_->wished.value_or(most).hz, most.hz)};
  auto servo = std::make_unique<ServoLoop>(std::move(device), inForce(), *legal,
                                           loop_->warmth.of(*loop_->rating), loop_->rate);
  servo->handling.publish(loop_->handling);
  return loop_->begin(std::move(servo), *legal);
}

void Session::close() {
  if (loop_->servo) {
    loop_->servo->end();
    if (loop_->rating) loop_->warmth = {loop_->rating->id, loop_->servo->heat(), monotonicNs()};
    loop_->keep();
    for (BurrCut cut; loop_->servo->cuts.try_dequeue(cut);) loop_->cuts_left.push_back(cut);
  }
  loop_->servo.reset();
  loop_->rating.reset();
  loop_->lifted = false;
  loop_->leaving.clear();
  loop_->unwatched.clear();
}
bool Session::isOpen() const { return loop_->servo != nullptr; }

void Session::adopt(std::shared_ptr<const Scene> scene, const Pose& start_W, bool with_hand) {
  loop_->scene = std::move(scene);
  loop_->cutting.reset();
  loop_->X_start = start_W;
  if (!loop_->servo) return;
  // with no room near, the proxy starts where it is and is brought out, force faded
  const Pose X_legal =
      legalPoseNear(*loop_->scene, loop_->settings.isovalue, start_W).value_or(start_W);
  loop_->servo->settings.publish(inForce());  // the tool's inertia may have changed
  auto engagement = std::make_unique<Engagement>(loop_->scene, X_legal);
  if (with_hand) engagement->X_WH = X_legal;
  loop_->servo->scenes.offer(std::move(engagement));
}

void Session::bring(const Pose& X_WT, const Pose& X_WH) {
  loop_->X_start = X_WT;
  if (!loop_->servo || !loop_->scene) return;
  auto engagement = std::make_unique<Engagement>(loop_->scene, X_WT);
  engagement->X_WH = X_WH;
  loop_->servo->scenes.offer(std::move(engagement));
}

void Session::cut(std::unique_ptr<Cutting> cutting) {
  if (!loop_->scene || cutting->scene()->id != loop_->scene->id) return;
  if (loop_->servo)
    loop_->servo->scenes.offer(std::move(cutting));
  else
    loop_->cutting = std::move(cutting);
}

void Session::holdCut(bool down) {
  constexpr std::int64_t kKeyCounts = 250'000'000;  // ns
  loop_->cut_until = down ? Watchdog::clock() + kKeyCounts : 0;
  if (loop_->servo) loop_->servo->cut_until = loop_->cut_until;
}

void Session::restCut(bool rests) {
  loop_->cut_rests = rests;
  if (!loop_->servo) return;
  loop_->servo->cut_rests = rests;
  loop_->rested_at = loop_->servo->boundary.load() + 2;
}

bool Session::cutRests() const {
  return loop_->cut_rests && (!loop_->servo || loop_->servo->boundary.load() >= loop_->rested_at);
}

std::size_t Session::cuts(std::span<BurrCut> cuts) {
  std::size_t count = 0;
  for (; count < cuts.size() && !loop_->cuts_left.empty(); ++count) {
    cuts[count] = loop_->cuts_left.front();
    loop_->cuts_left.pop_front();
  }
  if (loop_->servo)
    while (count < cuts.size() && loop_->servo->cuts.try_dequeue(cuts[count])) ++count;
  return count;
}

void Session::renew(std::shared_ptr<const Scene> scene) {
  if (loop_->scene && loop_->scene->id == scene->id) loop_->scene = std::move(scene);
}

void Session::collectGarbage() {
  if (!loop_->servo) return;
  loop_->servo->scenes.collect();
  if (loop_->servo->boundary.load() >= loop_->unwatched_at) loop_->unwatched.clear();
}

void Session::set(const Settings& settings) {
  loop_->settings = withinRange(settings, loop_->settings);
  if (loop_->servo) loop_->servo->settings.publish(inForce());
}

Settings Session::inForce() const {
  const Scene* scene = loop_->scene.get();
  if (loop_->rating)
    return underRating(loop_->settings, *loop_->rating, loop_->rate, scene, loop_->lifted);
  return underGrip(loop_->settings, rate(), scene);
}

void Session::chooseRate(std::optional<ServoRate> rate) { loop_->wished = rate; }

ServoRate Session::rate() const {
  return isOpen() ? loop_->rate : loop_->wished.value_or(ServoRate{});
}

void Session::liftStiffness(bool lifted) {
  loop_->lifted = lifted && loop_->rating;
  if (loop_->servo) loop_->servo->settings.publish(inForce());
}

void Session::handle(const Handling& handling) {
  loop_->handling = handling;
  if (loop_->servo) loop_->servo->handling.publish(handling);
}

void Session::pull(const Pose& X_WH) { loop_->mouse.publish(X_WH); }

void Session::forceOff() {
  loop_->armed = false;
  if (loop_->servo) loop_->servo->armed.store(false, std::memory_order_relaxed);
}
void Session::arm() {
  loop_->armed = true;
  if (loop_->servo) loop_->servo->armed.store(true, std::memory_order_relaxed);
}

void Session::record(std::shared_ptr<StepRing> ring) {
  if (loop_->servo) {
    loop_->servo->recording.store(ring.get());
    if (loop_->ring) loop_->leaving.push_back(std::move(loop_->ring));
    loop_->left_at = loop_->servo->boundary.load() + 2;
  }
  loop_->ring = std::move(ring);
}

void Session::watch(std::shared_ptr<const Watch> watch) {
  if (loop_->servo) {
    loop_->servo->watch.store(watch.get(), std::memory_order_release);
    loop_->unwatched.push_back(std::move(loop_->watch));
    loop_->unwatched_at = loop_->servo->boundary.load() + 2;
  }
  loop_->watch = std::move(watch);
}

bool Session::hasLeftRing() const {
  if (!loop_->leaving.empty() && loop_->servo && loop_->servo->boundary.load() < loop_->left_at)
    return false;
  loop_->leaving.clear();
  return true;
}

bool Session::latest(Snapshot& snapshot) {
  return loop_->servo && loop_->servo->snapshots.take(snapshot);
}

std::size_t Session::transitions(std::span<ForceTransition> transitions) {
  if (!loop_->servo) return 0;
  std::size_t count = 0;
  while (count < transitions.size() && loop_->servo->transitions.try_dequeue(transitions[count]))
    ++count;
  return count;
}

std::size_t Session::forces(std::span<ForceSample> samples) {
  if (!loop_->servo) return 0;
  std::size_t count = 0;
  while (count < samples.size() && loop_->servo->forces.try_dequeue(samples[count])) ++count;
  return count;
}

}  // namespace haptics
