// SPDX-License-Identifier: BSD-3-Clause
#include "tests/unit/haptics/devices/stub_hd.h"

#include <chrono>
#include <cmath>

namespace {

StubHd& stub() {
  static StubHd* const one = new StubHd;  // its thread may outlive the program's statics
  return *one;
}

struct Error {
  unsigned code;
  int inner;
  unsigned unit;
};

void fail(unsigned code) {
  if (code == 0) return;
  const std::lock_guard lock{stub().mutex};
  stub().errors.push_back(code);
}

void run() {
  while (stub().running) {
    std::this_thread::sleep_for(std::chrono::milliseconds{1});
    if (stub().frozen || stub().call == nullptr || !stub().running) continue;
    ++stub().calls;
    if (stub().call(stub().given) == 0) stub().call = nullptr;
  }
}

}  // namespace

extern "C" {
StubHd* stubHd();
unsigned hdInitDevice(const char*);
void hdDisableDevice(unsigned);
void hdMakeCurrentDevice(unsigned);
void hdBeginFrame(unsigned);
void hdEndFrame(unsigned);
Error hdGetError();
void hdEnable(unsigned);
void hdDisable(unsigned);
void hdGetDoublev(unsigned, double*);
void hdGetIntegerv(unsigned, int*);
const char* hdGetString(unsigned);
void hdSetDoublev(unsigned, const double*);
unsigned hdCheckCalibration();
void hdUpdateCalibration(unsigned);
unsigned long hdScheduleAsynchronous(unsigned (*)(void*), void*, unsigned short);
void hdUnschedule(unsigned long);
void hdStartScheduler();
void hdStopScheduler();

StubHd* stubHd() { return &stub(); }

unsigned hdInitDevice(const char* name) {
  stub().tell("open");
  {
    const std::lock_guard lock{stub().mutex};
    stub().opened = name != nullptr ? name : "(default)";
  }
  fail(stub().open_error);
  return stub().unit;
}
void hdDisableDevice(unsigned) { stub().tell("close"); }
void hdMakeCurrentDevice(unsigned) {}
void hdBeginFrame(unsigned) { stub().in_frame = true; }
void hdEndFrame(unsigned) {
  {
    const std::lock_guard lock{stub().mutex};
    stub().sent = stub().next;
    for (const double number : stub().sent) {
      if (!std::isfinite(number)) stub().not_finite = true;
      if (number != 0.0) {
        ++stub().unlike_zero;
        break;
      }
    }
  }
  stub().in_frame = false;
  ++stub().frames;
  if (stub().errors_left == 0) return;
  if (stub().errors_left > 0 && stub().frame_error != 0) --stub().errors_left;
  fail(stub().frame_error);
  fail(stub().second_error);
}
Error hdGetError() {
  if (stub().endless_errors) return {0x100, 0, stub().unit};
  const std::lock_guard lock{stub().mutex};
  if (stub().errors.empty()) return {0, 0, stub().unit};
  const unsigned code = stub().errors.back();
  stub().errors.pop_back();
  return {code, -1, stub().unit};
}
void hdEnable(unsigned what) {
  if (what == 0x4000) stub().force_on = true;
  if (what == 0x4001) stub().clamped = true;
  fail(stub().enable_error);
}
void hdDisable(unsigned what) {
  stub().tell("disable");
  if (what == 0x4000) stub().force_on = false;
}
void hdGetDoublev(unsigned what, double* values) {
  switch (what) {
    case 0x2052:
      for (std::size_t n = 0; n < 16; ++n) values[n] = stub().transform[n];
      return;
    case 0x2602:
      *values = stub().stiffness;
      return;
    case 0x2603:
      *values = stub().force;
      return;
    case 0x2604:
      *values = stub().continuous_force;
      return;
    case 0x2622:
      for (int joint = 0; joint < 3; ++joint) values[joint] = stub().torque;
      if (stub().torque == 0.0) fail(0x100);
      return;
    default:
      fail(0x100);
  }
}
void hdGetIntegerv(unsigned what, int* values) {
  switch (what) {
    case 0x2000:
      *values = stub().buttons;
      return;
    case 0x2553:
      *values = stub().inputs;
      return;
    case 0x2554:
      *values = stub().outputs;
      return;
    case 0x2555:
      *values = stub().style;
      return;
    default:
      fail(0x100);
  }
}
const char* hdGetString(unsigned what) {
  if (what == 0x2501) return stub().model;
  fail(0x100);
  return nullptr;
}
void hdSetDoublev(unsigned what, const double* values) {
  if (!stub().in_frame) stub().set_outside_frame = true;
  if (what == 0x2701 && stub().outputs < 6) stub().torque_to_unit_without = true;
  const std::lock_guard lock{stub().mutex};
  for (std::size_t n = 0; n < 3; ++n) stub().next[(what == 0x2701 ? 3 : 0) + n] = values[n];
}
unsigned hdCheckCalibration() { return stub().calibration; }
void hdUpdateCalibration(unsigned style) {
  ++stub().calibrations;
  stub().calibration_style = static_cast<int>(style);
  fail(0x103);  // what it says then is not the fault of a frame
}
unsigned long hdScheduleAsynchronous(unsigned (*call)(void*), void* given, unsigned short) {
  stub().tell("schedule");
  fail(stub().schedule_error);
  if (stub().schedule_error != 0) return 0;
  stub().call = call;
  stub().given = given;
  return 42;
}
void hdUnschedule(unsigned long) {
  stub().tell("unschedule");
  stub().call = nullptr;
}
void hdStartScheduler() {
  stub().tell("start");
  fail(stub().start_error);
  if (stub().start_error != 0) return;
  stub().running = true;
  stub().thread = std::thread{run};
}
void hdStopScheduler() {
  stub().tell("stop");
  stub().running = false;
  if (stub().thread.joinable()) stub().thread.join();
}
}
