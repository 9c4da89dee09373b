// SPDX-License-Identifier: BSD-3-Clause
#include "app/display.h"

#include <X11/Xlib.h>

#include <chrono>
#include <cstdlib>
#include <string_view>
#include <thread>

namespace app {
namespace {

/// What the X display answers; false where there is none. A virtual display begins anew when its
/// last window has gone and answers nobody meanwhile, so it is asked again for up to a second.
bool asked(bool (*question)(Display*)) {
  if (std::getenv("DISPLAY") == nullptr) return false;
  Display* display = XOpenDisplay(nullptr);
  for (int n = 0; n < 10 && display == nullptr; ++n) {
    std::this_thread::sleep_for(std::chrono::milliseconds{100});
    display = XOpenDisplay(nullptr);
  }
  if (display == nullptr) return false;
  const bool answer = question(display);
  XCloseDisplay(display);
  return answer;
}

}  // namespace

bool displayReachable() {
  const char* platform = std::getenv("QT_QPA_PLATFORM");
  if (platform != nullptr && !std::string_view{platform}.starts_with("xcb")) return false;
  return asked([](Display*) { return true; });
}

bool displayDraws() {
  return asked([](Display* display) {
    int opcode = 0, event = 0, error = 0;
    return XQueryExtension(display, "GLX", &opcode, &event, &error) == True;
  });
}

}  // namespace app
