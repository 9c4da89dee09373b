// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <QTemporaryDir>
#include <cstdint>

#include "app/application.h"
#include "haptics/snapshot.h"
#include "tests/ui/window_support.h"

namespace window {

/// The program that touches the sphere with this hand, until the test ends it, with neither notice
/// nor preferences of the user.
inline app::Arguments sphereInHand(const char* hand) {
  app::Arguments arguments;
  arguments.load.phantom = "sphere";
  arguments.hand = hand;
  arguments.surface = ui::SurfaceMode::Mesh;
  arguments.screenshot = "unused";  // whoever asks for one has no preferences
  arguments.screenshot_after = 3'600.0;
  arguments.notice = false;
  return arguments;
}

/// The same with a small sphere for a tool, whose recordings are kept in `folder`.
inline app::Arguments recordedSphere(const QTemporaryDir& folder, const char* hand = "slide") {
  app::Arguments arguments = sphereInHand(hand);
  arguments.load.tool = app::ToolSource{.name = "sphere"};
  arguments.recordings = folder.path().toStdString();
  return arguments;
}

/// Waits until the servo loop of the open hand has had so many ticks more, as the window sees it.
inline void afterTicks(app::Application& application, std::uint64_t ticks) {
  const auto first = application.snapshot().tick;
  EXPECT_TRUE(waitFor([&] { return application.snapshot().tick >= first + ticks; }));
}

}  // namespace window
