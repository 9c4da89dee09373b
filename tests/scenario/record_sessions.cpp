// SPDX-License-Identifier: BSD-3-Clause
// Records the sessions of tests/scenario/sessions: what a touch came to, to hold later builds to.
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "app/recording/recorder.h"
#include "datasets/edits/edit_history.h"
#include "datasets/phantoms/phantoms.h"
#include "haptics/scene/legal_pose.h"
#include "haptics/servo/servo_loop.h"
#include "haptics/simulation/hand.h"
#include "haptics/simulation/simulated.h"
#include "resources/named_tools.h"
#include "tests/support/sentence.h"

namespace {

using namespace datasets;
using namespace haptics;

constexpr int kTicks = 1600;

struct Session {
  const char* phantom;
  const char* tool;
  HandMotion motion;
  Settings settings;
  bool limited;  ///< by what the device is rated for, ramped and guarded
  SceneOptions options;
  /// What is changed before a tick.
  std::function<void(int tick, Settings&, ServoLoop&)> change;
  /// What was taken away from the phantom.
  std::function<std::vector<Edit>(double isovalue)> edits = {};
};

void record(const Session& session, const std::filesystem::path& target) {
  datasets::Phantom phantom = datasets::makePhantom(session.phantom).value();
  auto volume = std::make_shared<const Volume>(std::move(phantom.volume));
  if (session.edits) volume = edited(volume, session.edits(phantom.isovalue)).value();
  Tool tool = makeTool(session.tool, resources::namedToolMesh(session.tool).value()).value();
  const auto scene = makeScene(volume, std::move(tool), session.options).value();
  const auto recorder = Recorder::create(target, {"1.0", "record_sessions", "{}"}).value();
  recorder->describe(scene, session.tool);

  Settings settings = session.settings;
  settings.isovalue = phantom.isovalue;
  Grip grip;
  grip.gyration = std::sqrt(scene->tool.shell.inertia.trace() / 3.0);
  const double reach = Hand::reachFor(3e-3, settings.stiffness, grip.stiffness);
  Hand hand = Hand::aimed(session.motion, *scene, settings.isovalue, reach, 1).value();
  const Pose X_start = hand.at(0.0);
  grip.X_WD = X_start;
  auto device = openSimulated(std::move(hand), grip, ServoRate{}.period());
  const auto made = session.limited
                        ? std::make_unique<ServoLoop>(std::move(device), settings, X_start)
                        : std::make_unique<ServoLoop>(std::move(device), settings);
  ServoLoop& loop = *made;
  loop.scenes.offer(std::make_unique<Engagement>(
      scene, legalPoseNear(*scene, settings.isovalue, X_start).value()));
  loop.recording.store(&recorder->ring());
  loop.armed.store(true);
  for (int tick = 0; tick < kTicks; ++tick) {
    while (recorder->ring().full()) {
      recorder->hurry();
      std::this_thread::yield();
    }
    session.change(tick, settings, loop);
    loop.settings.publish(settings);
    loop.step(1e-3 * tick);
  }
  loop.recording.store(nullptr);
  loop.step(1e-3 * kTicks);
  const auto finished = recorder->finish();
  if (!finished) throw std::runtime_error{sentence(finished.error())};
  std::printf("%s: %lld steps\n", finished->c_str(),
              static_cast<long long>(recorder->status().steps));
}

/// Half of the ball, by a cut, a lasso over the edge of what is left, and a crop.
std::vector<Edit> editsOfSphere(double isovalue) {
  LassoCut lasso;
  lasso.outline = {{0.06, -0.3}, {0.3, -0.3}, {0.3, 0.3}, {0.07, 0.3}};
  lasso.X_WC = poseOf({0.0, 0.0, 0.15}, Quat{Eigen::AngleAxisd{0.1, Vec3::UnitY()}});
  lasso.isovalue = isovalue;
  return {PlaneCut{{0.0, 0.0, 0.004}, Vec3{0.3, 0.2, 1.0}.normalized(), isovalue}, lasso,
          Crop{{{0, 0, 1}, {64, 64, 60}}}};
}

}  // namespace

int main(int count, char** words) {
  if (count != 2) {
    std::fprintf(stderr, "Use: record_sessions FOLDER\n");
    return 2;
  }
  const std::filesystem::path folder = words[1];
  // a slide over a surface that moves
  record({"demo",
          "probe",
          HandMotion::Slide,
          {.stiffness = 1000.0},
          false,
          {},
          [](int tick, Settings& settings, ServoLoop&) {
            if (tick == 700) settings.isovalue += 60.0;
            if (tick == 1100) settings.isovalue -= 90.0;
          }},
         folder / "demo-slide.palpate");
  // prying with friction, under the limits of a device, that is switched off and on
  record({"demo",
          "drill",
          HandMotion::Pry,
          {.stiffness = 3000.0, .friction = 0.6},
          true,
          {},
          [](int tick, Settings& settings, ServoLoop& loop) {
            if (tick == 900) loop.armed.store(false);
            if (tick == 1000) loop.armed.store(true);
            if (tick == 1400) settings.stiffness = 2000.0;
          }},
         folder / "demo-pry.palpate");
  // hooking in a smooth field, with friction that comes and goes
  record({"torus",
          "wrench",
          HandMotion::Hook,
          {.stiffness = 2000.0},
          false,
          {.field = FieldKind::CubicSpline},
          [](int tick, Settings& settings, ServoLoop&) {
            if (tick == 600) settings.friction = 0.4;
            if (tick == 1200) settings.friction = 0.0;
          }},
         folder / "torus-hook.palpate");
  // a slide over the wall of a cut
  record({"sphere",
          "probe",
          HandMotion::Slide,
          {.stiffness = 1000.0, .friction = 0.3},
          false,
          {},
          [](int, Settings&, ServoLoop&) {},
          editsOfSphere},
         folder / "sphere-cut.palpate");
  return 0;
}
