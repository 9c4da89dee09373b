// SPDX-License-Identifier: BSD-3-Clause
#include "app/display.h"

#include <X11/Xlib.h>

#include <chrono>
#include <cstdlib>
#include <string_view>
#include <thread>

namespace app {
namespace {

/// Null where there is none. Asked again for up to a second.
Display* opened() {
  if (std::getenv("DISPLAY") == nullptr) return nullptr;
  Display* display = XOpenDisplay(nullptr);
  for (int n = 0; n < 10 && display == nullptr; ++n) {
    std::this_thread::sleep_for(std::chrono::milliseconds{100});
    display = XOpenDisplay(nullptr);
  }
  return display;
}

}  // namespace

HeldDisplay::HeldDisplay() : display_{opened()} {}
HeldDisplay::~HeldDisplay() {
  if (display_ != nullptr) XCloseDisplay(static_cast<Display*>(display_));
}
bool HeldDisplay::showsWindows() const {
  const char* platform = std::getenv("QT_QPA_PLATFORM");
  return display_ != nullptr &&
         (platform == nullptr || std::string_view{platform}.starts_with("xcb"));
}
bool HeldDisplay::draws() const {
  int opcode = 0, event = 0, error = 0;
  return display_ != nullptr &&
         XQueryExtension(static_cast<Display*>(display_), "GLX", &opcode, &event, &error) == True;
}

}  // namespace app
