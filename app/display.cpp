// SPDX-License-Identifier: BSD-3-Clause
#include "app/display.h"

#include <X11/Xlib.h>

#include <cstdlib>
#include <string_view>

namespace app {

bool displayReachable() {
  const char* platform = std::getenv("QT_QPA_PLATFORM");
  if (platform != nullptr && !std::string_view{platform}.starts_with("xcb")) return false;
  Display* display = XOpenDisplay(nullptr);
  if (display == nullptr) return false;
  XCloseDisplay(display);
  return true;
}

}  // namespace app
