// SPDX-License-Identifier: BSD-3-Clause
#include "tests/unit/haptics/devices/stub_dhd.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>

#include "haptics/core/clock.h"

namespace {
StubDhd stub;

void called() {
  if (stub.closes > 0) stub.asked_after_close = true;
}
int open(char unit, bool robotics) {
  if (stub.open_result < 0) return stub.open_result;
  stub.opened = unit;
  stub.opened_by_robotics = robotics;
  stub.closes = 0;
  return stub.open_result;
}
int close() { return ++stub.closes, 0; }
}  // namespace

extern "C" {
StubDhd* stubDhd();
void dhdGetSDKVersion(int*, int*, int*, int*);
int dhdGetDeviceCount();
int dhdOpenID(char);
int dhdClose(char);
int drdOpenID(char);
int drdClose(char);
bool drdIsInitialized(char);
int dhdStop(char);
int dhdErrorGetLast();
int dhdGetSystemType(char);
bool dhdHasActiveWrist(char);
int dhdEnableExpertMode();
int dhdSetWatchdog(unsigned char, char);
int dhdEnableForce(unsigned char, char);
int dhdSetGravityCompensation(int, char);
int dhdGetStatus(int*, char);
int dhdGetPositionAndOrientationFrame(double*, double*, double*, double (*)[3], char);
unsigned dhdGetButtonMask(char);
int dhdSetForceAndTorqueAndGripperForce(double, double, double, double, double, double, double,
                                        char);

StubDhd* stubDhd() { return &stub; }

void dhdGetSDKVersion(int* major, int* minor, int* release, int* revision) {
  *major = stub.major;
  *minor = stub.minor;
  *release = stub.release;
  *revision = 1234;
}
int dhdGetDeviceCount() { return stub.count; }
int dhdOpenID(char unit) { return open(unit, false); }
int drdOpenID(char unit) { return open(unit, true); }
int dhdClose(char) { return close(); }
int drdClose(char) { return close(); }
bool drdIsInitialized(char) { return stub.initialised; }
int dhdStop(char) { return called(), ++stub.brakes, 0; }
int dhdErrorGetLast() { return stub.last_error; }
int dhdGetSystemType(char) { return stub.model; }
bool dhdHasActiveWrist(char) { return stub.active_wrist; }
int dhdEnableExpertMode() { return stub.expert_result; }
int dhdSetWatchdog(unsigned char value, char) {
  stub.watchdog = value;
  return stub.watchdog_result;
}
int dhdEnableForce(unsigned char on, char) {
  called();
  ++stub.enables;
  if (stub.enable_result < 0) return stub.enable_result;
  stub.force = on;
  if (on != 0) stub.cause = 0;
  return 0;
}
int dhdSetGravityCompensation(int on, char) {
  stub.weight = on;
  return stub.weight_result;
}
int dhdGetStatus(int* state, char) {
  called();
  if (stub.state_result < 0) return stub.state_result;
  std::fill_n(state, 17, 0);
  state[0] = state[2] = 1;
  state[1] = stub.connected;
  state[3] = stub.reset;
  state[5] = stub.force;
  state[14] = stub.cause;
  return stub.state_result;
}
int dhdGetPositionAndOrientationFrame(double* x, double* y, double* z, double (*frame)[3], char) {
  called();
  {
    const std::lock_guard lock{stub.mutex};
    const auto n = static_cast<std::size_t>(stub.poses + 1);
    stub.asks[n % stub.asks.size()] = {haptics::monotonicNs(), stub.last};
  }
  ++stub.poses;
  if (stub.pose_ms > 0) std::this_thread::sleep_for(std::chrono::milliseconds{stub.pose_ms});
  if (stub.pose_result < 0) return stub.pose_result;
  *x = stub.p_F[0];
  *y = stub.p_F[1];
  *z = stub.p_F[2];
  for (std::size_t n = 0; n < 9; ++n) frame[n / 3][n % 3] = stub.R_FD[n];
  return stub.pose_result;
}
unsigned dhdGetButtonMask(char) { return stub.buttons; }
int dhdSetForceAndTorqueAndGripperForce(double fx, double fy, double fz, double tx, double ty,
                                        double tz, double fg, char) {
  called();
  const std::array<double, 7> sent{fx, fy, fz, tx, ty, tz, fg};
  for (const double number : sent)
    if (!std::isfinite(number)) stub.not_finite = true;
  if (std::any_of(sent.begin(), sent.end(), [](double number) { return number != 0.0; }))
    ++stub.wrenches_unlike_zero;
  {
    const std::lock_guard lock{stub.mutex};
    stub.last = sent;
  }
  ++stub.rounds;
  return stub.wrench_result;
}
}
