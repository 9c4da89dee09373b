// SPDX-License-Identifier: BSD-3-Clause
#include "app/display.h"

#include <X11/Xlib.h>

#include <cstdlib>
#include <string_view>

namespace app {
namespace {

/// What the X display answers; no where there is none.
bool asked(bool (*question)(Display*)) {
  Display* display = XOpenDisplay(nullptr);
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
