// SPDX-License-Identifier: BSD-3-Clause
// Controllers of the window, each made without the others and without the application.
#include <gtest/gtest.h>

#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <optional>

#include "app/window/hand_controller.h"
#include "app/window/measurement_controller.h"
#include "app/window/tool_controller.h"
#include "ui/panels/device_panel.h"
#include "ui/panels/performance_panel.h"
#include "window_support.h"

namespace {

using window::waitFor;

/// The phantom "sphere" with a tool, as the loader hands it over.
app::Loaded loadedSphere() {
  app::Loader loader([] { return 1e12; });
  std::optional<app::Loaded> loaded;
  QObject::connect(&loader, &app::Loader::loaded,
                   [&](const app::Loaded& result) { loaded = result; });
  loader.start({.phantom = "sphere"});
  EXPECT_TRUE(waitFor([&] { return loaded.has_value(); }));
  return loaded.value_or(app::Loaded{});
}

TEST(Controllers, AToolAndAFieldAreWantedForTheVolumeOnView) {
  ui::MainWindow window;
  app::SharedState shared;
  app::ToolController controller(window, shared);
  QSignalSpy wanted(&controller, &app::ToolController::wanted);
  emit window.devicePanel().toolChosen("wrench");
  EXPECT_EQ(wanted.count(), 0);  // nothing is on view
  std::optional<app::LoadRequest> request;
  QObject::connect(&controller, &app::ToolController::wanted, &window,
                   [&](const app::LoadRequest& given) { request = given; });
  shared.shown = loadedSphere();
  shared.settings.isovalue = 12.0;
  emit window.devicePanel().toolChosen("wrench");
  ASSERT_TRUE(request);
  EXPECT_EQ(request->tool->name, "wrench");
  EXPECT_EQ(request->keep->picture.volume, shared.shown->picture.volume);
  EXPECT_EQ(request->isovalue, 12.0);
  emit window.devicePanel().fieldChosen("spline");
  EXPECT_EQ(wanted.count(), 2);
  EXPECT_EQ(request->tool->name, shared.shown->tool.name);
  EXPECT_EQ(shared.options.field, haptics::FieldKind::CubicSpline);
}

TEST(Controllers, AHandIsOpenedWithTheSceneAndChangedUnlessARecordingIsOnView) {
  ui::MainWindow window;
  app::SharedState shared;
  app::HandController controller(window, shared, "mouse", 700.0);
  QSignalSpy changed(&controller, &app::HandController::changed);
  QSignalSpy replay_end(&controller, &app::HandController::replayEndWanted);
  EXPECT_EQ(shared.settings.stiffness, 700.0);
  controller.reopen();
  EXPECT_FALSE(shared.session.isOpen());  // there is nothing to touch
  shared.shown = loadedSphere();
  shared.settings.isovalue = shared.shown->isovalue;
  controller.adopt(true, false);
  controller.resume();
  EXPECT_TRUE(shared.session.isOpen());
  EXPECT_EQ(controller.name(), "mouse");
  emit window.devicePanel().handChosen("tap");
  EXPECT_EQ(controller.name(), "tap");
  EXPECT_EQ(changed.count(), 2);
  // while a recording is on view the choice is kept for later
  shared.session.close();
  shared.replaying = true;
  emit window.devicePanel().handChosen("mouse");
  EXPECT_EQ(controller.name(), "mouse");
  EXPECT_EQ(changed.count(), 2);
  EXPECT_EQ(replay_end.count(), 1);
  EXPECT_FALSE(shared.session.isOpen());
}

TEST(Controllers, AMeasurementIsMadeAndEndedWithAReason) {
  ui::MainWindow window;
  app::SharedState shared;
  app::MeasurementController controller(window, shared);
  auto* button = window.findChild<QPushButton*>("measure");
  auto* details = window.findChild<QLabel*>("performanceDetails");
  EXPECT_FALSE(button->isEnabled());
  controller.resume();
  EXPECT_FALSE(button->isEnabled());  // there is nothing to measure
  shared.shown = loadedSphere();
  shared.settings.isovalue = shared.shown->isovalue;
  controller.showScene();
  ASSERT_TRUE(button->isEnabled());
  button->click();
  EXPECT_EQ(button->text(), "Cancel");
  controller.end("It was ended by the test.");
  EXPECT_EQ(details->text(), "It was ended by the test.");
  EXPECT_NE(button->text(), "Cancel");
  controller.end("There is none to end.");
  EXPECT_EQ(details->text(), "It was ended by the test.");
  controller.pause();
  EXPECT_FALSE(button->isEnabled());
  controller.resume();
  EXPECT_TRUE(button->isEnabled());
}

}  // namespace
