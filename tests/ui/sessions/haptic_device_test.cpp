// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QAction>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QSettings>
#include <QSignalSpy>
#include <QTest>
#include <QTreeWidget>
#include <functional>
#include <mutex>

#include "app/application.h"
#include "app/window/program/preferences.h"
#include "app/window/scan/loader.h"
#include "haptics/session.h"
#include "tests/ui/sessions/hand_device.h"
#include "tests/ui/views/sphere_in_hand.h"
#include "tests/ui/window_support.h"
#include "ui/panels/device_panel.h"
#include "ui/views/volume_view.h"
#include "ui/window/main_window.h"
#include "ui/window/menus.h"
#include "ui/window/messages.h"
#include "ui/window/start_page.h"
#include "ui/window/touch_state.h"
#include "ui/window/views.h"

namespace {

using haptics::DeviceStatus;
using haptics::ForceState;
using haptics::Trouble;
using haptics::Vec3;
using window::HandDevice;
using window::Handle;
using window::waitFor;

constexpr double kDepth = 0.004;  // m beyond the surface, at which the Falcon's 8 N are reached
constexpr double kMoved = 2e-5;   // m

/// What the test has plugged in, and how it answers.
struct Bench {
  std::shared_ptr<Handle> handle = std::make_shared<Handle>();
  std::atomic<bool> plugged{true};
  window::Gate gate;  ///< of opening; lifted unless a test shuts it
  std::atomic<Trouble> refusing{Trouble::None};
  std::mutex lock;
  std::string named;  ///< firmware, at the last opening

  Bench() { gate.lift(); }
  /// What waits to be opened waits no longer.
  ~Bench() { gate.lift(); }

  std::string firmware() {
    const std::lock_guard guard{lock};
    return named;
  }

  app::DeviceCatalogue catalogue() {
    return {.survey =
                [this] {
                  haptics::DeviceEntry falcon{
                      .id = "falcon", .name = "Novint Falcon", .sensed = 3, .actuated = 3};
                  falcon.present = plugged;
                  if (!plugged) {
                    falcon.trouble = Trouble::NotPluggedIn;
                    falcon.why = "No Falcon is plugged in; connect its cable.";
                  }
                  return std::vector{falcon};
                },
            .open = [this](const haptics::OpenRequest& request)
                -> haptics::Expected<std::unique_ptr<haptics::Device>> {
              {
                const std::lock_guard guard{lock};
                named = request.firmware.string();
              }
              gate.pass();
              if (refusing != Trouble::None) {
                const std::string word{haptics::wordOf(refusing)};
                return tl::unexpected(haptics::Error{haptics::Error::Kind::Unsupported,
                                                     "Refused: " + word + ".", word});
              }
              return std::make_unique<HandDevice>(handle);
            },
            .join = [](auto moved, auto) { return moved; }};
  }
};

/// The whole application on the sphere, with a fake Falcon in its catalogue and the panel in view.
class Session {
 public:
  explicit Session(Bench& bench, bool kept = false)
      : bench_(bench), application(arguments(bench, kept)) {
    application.start();
    EXPECT_TRUE(waitFor([&] { return application.snapshot().scene != 0; }));
    for (QAction* action : window().findChildren<QAction*>())
      if (action->text() == "Haptic device") action->trigger();
    EXPECT_TRUE(waitFor([&] { return list()->topLevelItemCount() == 1; }));
    window().activateWindow();
    EXPECT_TRUE(QTest::qWaitForWindowActive(&window(), 120'000));
  }

  ui::MainWindow& window() { return application.window(); }
  ui::VolumeView& view() { return window().views().volume(); }
  haptics::Snapshot now() { return application.snapshot(); }
  Handle& handle() { return *bench_.handle; }
  QTreeWidget* list() { return window().findChild<QTreeWidget*>("deviceList"); }
  QLabel* label(const char* name) { return window().findChild<QLabel*>(name); }
  void click(const char* name) {
    auto* button = window().findChild<QAbstractButton*>(name);
    ASSERT_TRUE(button != nullptr && button->isVisible() && button->isEnabled()) << name;
    QTest::mouseClick(button, Qt::LeftButton);
  }
  bool is(ForceState state) { return now().force_state == state; }
  void connectDevice() {
    click("connectDevice");
    ASSERT_TRUE(waitFor([&] { return bench_.handle->open && settled(); }));
    // half of what a Falcon is rated for, at the hand
    const haptics::Settings settings = application.session().inForce();
    EXPECT_NEAR(settings.stiffness * settings.position_scale, 1500.0, 1e-9);
    // the hand is where it is; the tool is in front of the sphere
    home_B_ = handle().led();
  }
  /// Ready. A busy machine may miss its ticks, which is a fault: that is seen to.
  bool settled() {
    if (is(ForceState::Fault)) {
      application.session().forceOff();
      QTest::qWait(30);
      application.session().arm();
      QTest::qWait(30);
      application.session().forceOff();
    }
    return is(ForceState::Ready);
  }
  /// Leads the handle so that the tool goes from its start towards the middle of the sphere.
  void leadToSphere(double depth) {
    const Vec3 start = application.shown()->start.translation();
    const haptics::Grid& grid = application.shown()->picture.volume->grid;
    const Vec3 middle = grid.worldOf(
        Vec3{(grid.dims[0] - 1) * 0.5, (grid.dims[1] - 1) * 0.5, (grid.dims[2] - 1) * 0.5});
    const Vec3 way_B = view().viewAxes().transpose() * (middle - start).normalized();
    // onwards until the proxy stays behind as far as wanted
    double gone = 0.0;
    ASSERT_TRUE(waitFor([&] {
      if (handle().arrived() && gap() < depth) handle().lead(home_B_ + way_B * (gone += 5e-4));
      return gap() >= depth;
    }));
    handle().lead(handle().led());
  }
  /// Waits until the servo loop has had so many ticks more, as the window sees it.
  void afterTicks(std::uint64_t ticks) {
    const auto first = now().tick;
    ASSERT_TRUE(waitFor([&] { return now().tick >= first + ticks; }));
  }
  /// m between device and proxy.
  double gap() { return (now().X_WD.translation() - now().X_WP.translation()).norm(); }
  /// Arms it, again after a fault of a busy machine, until it is as far as wanted. A click on the
  /// button takes the focus from the view, and with it the key that is held there: `hold` presses
  /// it anew.
  void armUntil(const std::function<bool()>& wanted, const std::function<void()>& hold = {}) {
    ASSERT_TRUE(waitFor([&] {
      if (is(ForceState::Ready) || is(ForceState::Fault)) application.session().forceOff();
      if (is(ForceState::Ready) || is(ForceState::Fault)) {
        QTest::qWait(30);
        click("arm");
        QTest::qWait(30);
        if (hold) hold();
      }
      return wanted();
    }));
  }
  /// On, and pushing.
  void armUntilItPushes(const std::function<void()>& hold = {}) {
    armUntil([&] { return is(ForceState::On) && handle().lastForce() > 2.0; }, hold);
  }

 private:
  static app::Arguments arguments(Bench& bench, bool kept) {
    app::Arguments made = window::sphereInHand("mouse");
    if (kept) made.screenshot = {};  // with preferences, of nobody
    made.devices = bench.catalogue();
    return made;
  }

  Bench& bench_;
  Vec3 home_B_ = Vec3::Zero();

 public:
  app::Application application;
};

TEST(HapticDevice, IsConnectedButNeverArmedByItself) {
  Bench bench;
  Session session(bench);
  const double own = session.application.session().inForce().stiffness;
  EXPECT_EQ(session.label("forceState")->text(), "No device");
  session.connectDevice();
  EXPECT_NE(session.application.session().inForce().stiffness, own);
  session.leadToSphere(kDepth);
  EXPECT_TRUE(waitFor([&] { return session.handle().written.load() > 1'000U; }));
  EXPECT_EQ(session.handle().pushesSince(0), 0);
  session.armUntilItPushes();
  EXPECT_EQ(session.label("forceState")->text(), "Force on");
  EXPECT_TRUE(session.label("statusLine")->text().contains("Novint Falcon"));
  window::keep(window::pictureOf(session.window()), "haptic_device_on");
  // and let go of: no more writes, the device is closed, and the mouse has its stiffness again
  session.click("connectDevice");
  EXPECT_EQ(session.application.session().inForce().stiffness, own);
  EXPECT_FALSE(session.handle().open);
  EXPECT_EQ(session.handle().lastForce(), 0.0);
  EXPECT_TRUE(waitFor([&] { return session.now().tick > 100; }));  // the mouse has it again
}

TEST(HapticDevice, OneThatIsChosenInAnEmptyWindowIsConnectedWithTheFirstScan) {
  Bench bench;
  app::Arguments arguments;
  arguments.surface = ui::SurfaceMode::Mesh;
  arguments.notice = false;
  arguments.devices = bench.catalogue();
  app::Application application(std::move(arguments));
  application.start();
  emit application.window().startPage().deviceWanted();
  auto* list = application.window().findChild<QTreeWidget*>("deviceList");
  ASSERT_TRUE(waitFor([&] { return list->topLevelItemCount() == 1; }));
  auto* connect = application.window().findChild<QAbstractButton*>("connectDevice");
  ASSERT_TRUE(connect->isEnabled());
  QTest::mouseClick(connect, Qt::LeftButton);
  QTest::qWait(200);
  EXPECT_FALSE(bench.handle->open);
  emit application.window().menus().phantomWanted("sphere");
  EXPECT_TRUE(waitFor([&] { return bench.handle->open.load(); }));
  EXPECT_TRUE(waitFor([&] {
    return application.snapshot().force_state == ForceState::Ready ||
           application.snapshot().force_state == ForceState::Fault;
  }));
}

// The three ways to stop, from the key or click to what the device is written.
void expectStop(const std::function<void(Session&)>& stop) {
  Bench bench;
  Session session(bench);
  session.connectDevice();
  session.leadToSphere(kDepth);
  session.armUntilItPushes();
  // behind the application's own connection: the wish has been obeyed when this is called
  std::optional<std::size_t> delivered;
  QObject::connect(&session.window().touch(), &ui::TouchState::forceOffWanted, [&] {
    if (!delivered) delivered = session.handle().written.load();
  });
  const std::size_t before = session.handle().written.load();
  ASSERT_GT(session.handle().pushesSince(before - 1), 0);
  stop(session);
  ASSERT_TRUE(delivered.has_value());
  ::testing::Test::RecordProperty("writes_between_press_and_delivery",
                                  static_cast<int>(*delivered - before));
  EXPECT_TRUE(waitFor([&] { return session.handle().written.load() > *delivered + 500; }));
  // the one of the tick that was under way may yet push
  EXPECT_LE(session.handle().pushesSince(*delivered), 1);
  EXPECT_EQ(session.handle().pushesSince(*delivered + 1), 0);
  EXPECT_TRUE(session.is(ForceState::Ready) || session.is(ForceState::Fault));
  session.armUntilItPushes();
}

TEST(HapticDevice, EscapeStopsItWithinOneTick) {
  expectStop([](Session& session) {
    // wherever the focus is
    session.list()->setFocus();
    QTest::keyClick(session.list(), Qt::Key_Escape);
  });
}

TEST(HapticDevice, SpaceInTheViewStopsItWithinOneTick) {
  expectStop([](Session& session) {
    session.view().setFocus();
    QTest::keyClick(&session.view(), Qt::Key_Space);
  });
}

TEST(HapticDevice, TheRedButtonStopsItWithinOneTick) {
  expectStop([](Session& session) { session.click("forceOff"); });
}

TEST(HapticDevice, TheWindowAnswersHoweverLongADeviceTakesToOpen) {
  Bench bench;
  bench.gate.shut();
  Session session(bench);
  session.click("connectDevice");
  EXPECT_TRUE(session.label("deviceLink")->text().contains("Novint Falcon"));
  ASSERT_TRUE(waitFor([&] { return bench.gate.came() == 1; }));
  // the driver is at it until the window has taken many turns, and draws the touch of the mouse
  const int frames = session.view().frames();
  for (int turns = 0; turns < 60; ++turns) QTest::qWait(1);
  session.view().redraw();
  ASSERT_TRUE(waitFor([&] { return session.view().frames() > frames; }));
  EXPECT_EQ(bench.gate.passed(), 0);
  EXPECT_FALSE(bench.handle->open);
  bench.gate.lift();
  // a wish that is given up meanwhile comes to nothing
  ASSERT_TRUE(waitFor([&] { return session.settled(); }));
  session.click("connectDevice");
  EXPECT_FALSE(bench.handle->open);
  bench.gate.shut();
  session.click("connectDevice");
  ASSERT_TRUE(waitFor([&] { return bench.gate.came() == 2; }));
  session.click("connectDevice");
  EXPECT_EQ(session.window().findChild<QAbstractButton*>("connectDevice")->text(), "Connect");
  const std::size_t written = session.handle().written;
  bench.gate.lift();
  ASSERT_TRUE(waitFor([&] { return bench.gate.passed() == 2; }));
  QTest::qWait(200);
  EXPECT_TRUE(waitFor([&] { return !bench.handle->open; }));
  EXPECT_EQ(session.handle().written, written);
  EXPECT_EQ(session.window().findChild<QAbstractButton*>("connectDevice")->text(), "Connect");
}

TEST(HapticDevice, WhatIsPluggedInLaterAppearsByItself) {
  Bench bench;
  bench.plugged = false;
  Session session(bench);
  EXPECT_EQ(session.list()->topLevelItem(0)->text(1), "not plugged in");
  EXPECT_TRUE(session.label("deviceWhy")->text().contains("connect its cable"));
  bench.plugged = true;
  EXPECT_TRUE(waitFor([&] { return session.list()->topLevelItem(0)->text(1) == "here"; }));
  EXPECT_TRUE(session.window().findChild<QAbstractButton*>("connectDevice")->isEnabled());
}

TEST(HapticDevice, EveryRefusalIsSaidInTheWindow) {
  Bench bench;
  Session session(bench);
  for (int n = 1; n <= static_cast<int>(Trouble::Lost); ++n) {
    bench.refusing = static_cast<Trouble>(n);
    const QString sentence =
        "Refused: " + QString::fromUtf8(haptics::wordOf(bench.refusing).data()) + ".";
    session.click("connectDevice");
    EXPECT_TRUE(waitFor([&] { return session.label("message")->text() == sentence; })) << n;
    EXPECT_TRUE(session.label("message")->isVisible());
    EXPECT_EQ(session.label("deviceLink")->text(), sentence);
    EXPECT_EQ(session.window().findChild<QWidget*>("firmware")->isVisible(),
              bench.refusing == Trouble::NoFirmware)
        << n;
    if (bench.refusing == Trouble::NoFirmware) {
      // with a file it is tried again, and with none left to name it is as it was
      auto* file = session.window().findChild<QLineEdit*>("firmware");
      file->setText("/its/firmware");
      session.click("connectDevice");
      EXPECT_TRUE(waitFor([&] { return bench.firmware() == "/its/firmware"; }));
      EXPECT_TRUE(waitFor([&] { return session.label("deviceLink")->text() == sentence; }));
      bench.plugged = false;
      EXPECT_TRUE(waitFor([&] { return !file->isVisible(); }));
      bench.plugged = true;
      EXPECT_TRUE(waitFor([&] { return session.list()->topLevelItem(0)->text(1) == "here"; }));
    }
    session.click("messageClose");
  }
  // the mouse went on
  EXPECT_TRUE(session.application.session().isOpen());
}

TEST(HapticDevice, UnpluggedUnderForceIsAFaultThatStaysUntilItIsSeen) {
  Bench bench;
  Session session(bench);
  const double own = session.application.session().inForce().stiffness;
  session.connectDevice();
  session.leadToSphere(kDepth);
  session.armUntilItPushes();
  bench.plugged = false;
  session.handle().status = DeviceStatus::Lost;
  ASSERT_TRUE(waitFor([&] { return session.is(ForceState::Fault); }));
  EXPECT_EQ(session.label("forceState")->text(), "Fault: no force");
  EXPECT_TRUE(session.label("forceReason")->text().contains("disconnected"));
  QLabel* fault = session.label("fault");
  ASSERT_TRUE(waitFor([&] { return fault->isVisible(); }));
  EXPECT_TRUE(fault->text().contains("Novint Falcon") && fault->text().contains("connect it again"))
      << fault->text().toStdString();
  window::keep(window::pictureOf(session.window()), "haptic_device_fault");
  // other messages come and go
  session.window().messages().showMessage("Something else.");
  session.window().messages().clear();
  EXPECT_TRUE(fault->isVisible());
  // a device that is back is not taken up by itself, and arming does not bring it back
  session.handle().status = DeviceStatus::Lost;
  EXPECT_FALSE(session.window().findChild<QAbstractButton*>("arm")->isEnabled());
  session.application.session().arm();
  QTest::qWait(200);
  EXPECT_FALSE(session.is(ForceState::On));
  EXPECT_EQ(session.handle().lastForce(), 0.0);
  session.click("faultClose");
  EXPECT_FALSE(fault->isVisible());
  // let go of, the stiffness is again what was set before; connected again it is as new
  session.click("connectDevice");
  EXPECT_EQ(session.application.session().inForce().stiffness, own);
  bench.plugged = true;
  session.handle().status = DeviceStatus::Ok;
  ASSERT_TRUE(waitFor(
      [&] { return session.window().findChild<QAbstractButton*>("connectDevice")->isEnabled(); }));
  session.handle().lead(session.handle().led());
  const std::size_t then = session.handle().written;
  session.connectDevice();
  EXPECT_EQ(session.handle().pushesSince(then), 0);
  session.leadToSphere(kDepth);
  session.armUntilItPushes();
}

TEST(HapticDevice, TheClutchKeyHoldsTheToolWhileTheHandMoves) {
  Bench bench;
  Session session(bench);
  session.connectDevice();
  session.view().setFocus();
  const auto toolAt = [&] { return Vec3{session.now().X_WD.translation()}; };
  Vec3 at = toolAt();
  const Vec3 hand = session.handle().led();
  session.handle().lead(hand + Vec3{0.0, 0.01, 0.0});
  ASSERT_TRUE(waitFor([&] { return session.handle().arrived(); }));
  session.afterTicks(50);
  EXPECT_NEAR((toolAt() - at).norm(), 0.01, 1e-4);
  QTest::keyPress(&session.view(), Qt::Key_C);
  ASSERT_TRUE(waitFor([&] { return session.now().clutched; }));
  at = toolAt();
  session.handle().lead(hand);
  ASSERT_TRUE(waitFor([&] { return session.handle().arrived(); }));
  session.afterTicks(50);
  EXPECT_LT((toolAt() - at).norm(), kMoved);
  QTest::keyRelease(&session.view(), Qt::Key_C);
  ASSERT_TRUE(waitFor([&] { return !session.now().clutched; }));
  EXPECT_LT((toolAt() - at).norm(), kMoved);
  session.handle().lead(hand + Vec3{0.0, 0.005, 0.0});
  ASSERT_TRUE(waitFor([&] { return session.handle().arrived(); }));
  session.afterTicks(50);
  EXPECT_NEAR((toolAt() - at).norm(), 0.005, 1e-4);
  // a key whose release goes elsewhere does not stay down
  QTest::keyPress(&session.view(), Qt::Key_C);
  ASSERT_TRUE(waitFor([&] { return session.now().clutched; }));
  session.list()->setFocus();
  EXPECT_TRUE(waitFor([&] { return !session.now().clutched; }));
}

TEST(HapticDevice, HeldToRunItPushesOnlyWhileTheKeyIsDown) {
  Bench bench;
  Session session(bench);
  session.connectDevice();
  session.leadToSphere(kDepth);
  session.click("holdToRun");
  session.view().setFocus();
  session.afterTicks(50);
  const std::size_t from = session.handle().written;
  session.click("arm");
  session.afterTicks(500);
  EXPECT_EQ(session.handle().pushesSince(from), 0);
  session.armUntil([&] { return session.is(ForceState::Armed); });
  EXPECT_TRUE(waitFor([&] { return session.label("forceReason")->text().contains("held"); }))
      << "what is to be done";
  const auto hold = [&] {
    session.view().setFocus();
    QTest::keyPress(&session.view(), Qt::Key_H);
  };
  hold();
  session.armUntilItPushes(hold);
  QTest::keyRelease(&session.view(), Qt::Key_H);
  EXPECT_TRUE(waitFor([&] { return session.handle().lastForce() == 0.0; }));
  // and by its button
  session.handle().buttons = 1U << 1;
  auto* button = session.window().findChild<QComboBox*>("holdButton");
  button->setFocus();
  QTest::keyClick(button, Qt::Key_Down);
  QTest::keyClick(button, Qt::Key_Down);
  session.armUntilItPushes();
  session.handle().buttons = 0;
  EXPECT_TRUE(waitFor([&] { return session.handle().lastForce() == 0.0; }));
}

TEST(HapticDevice, TurningTheCameraTurnsTheHandsDirectionsAndMovesNothing) {
  Bench bench;
  Session session(bench);
  session.connectDevice();
  const auto toolAt = [&] { return Vec3{session.now().X_WD.translation()}; };
  const Vec3 hand = session.handle().led();
  for (const bool follow : {true, false}) {
    if (!follow) session.click("followCamera");
    Vec3 at = toolAt();
    const Eigen::Matrix3d before = session.view().viewAxes();
    QTest::mousePress(&session.view(), Qt::LeftButton, {}, {40, 40});
    QTest::mouseMove(&session.view(), {160, 70});
    QTest::mouseRelease(&session.view(), Qt::LeftButton, {}, {160, 70});
    const Eigen::Matrix3d after = session.view().viewAxes();
    ASSERT_GT((after - before).norm(), 0.2);
    // the session learns the axes when the snapshot is looked at, which on a busy machine may take
    // longer than any wait
    for (int n = 0; n < 3; ++n) {
      const auto tick = session.now().tick;
      ASSERT_TRUE(waitFor([&] { return session.now().tick != tick; }));
    }
    // and the servo turns by 0.002 rad a tick: after half a turn's ticks it has arrived
    const auto learnt = session.now().tick;
    ASSERT_TRUE(waitFor([&] { return session.now().tick > learnt + 1'600; }));
    EXPECT_LT((toolAt() - at).norm(), kMoved);
    // to the right of the picture, or of what it was
    session.handle().lead(session.handle().led() + Vec3{0.01, 0.0, 0.0});
    const Vec3 right = (follow ? after : before).col(0);
    // nearly all the way: what is still to come would count as moved by the next turn
    EXPECT_TRUE(waitFor([&] { return (toolAt() - at - 0.01 * right).norm() < 0.5 * kMoved; }))
        << follow << ", off by " << (toolAt() - at - 0.01 * right).transpose();
  }
  EXPECT_NEAR((session.handle().led() - hand).norm(), 0.02, 1e-9);
}

TEST(HapticDevice, TheStiffnessThatIsRememberedIsTheUsersAndNotTheDevices) {
  QSettings().clear();
  Bench bench;
  Session session(bench, true);
  const double own = session.application.session().inForce().stiffness;
  session.connectDevice();
  EXPECT_NE(session.application.session().inForce().stiffness, own);
  emit session.window().layoutChanged();  // the preferences are saved
  EXPECT_EQ(app::loadPreferences().stiffness, own);
  session.click("connectDevice");
  EXPECT_EQ(session.application.session().inForce().stiffness, own);
  QSettings().clear();
}

TEST(HapticDevice, AScaledForceStartsAtHalfOfWhatTheHandIsRatedForToo) {
  Bench bench;
  Session session(bench);
  auto* scale = session.window().findChild<QDoubleSpinBox*>("forceScale");
  ASSERT_NE(scale, nullptr);
  scale->setValue(0.5);
  session.connectDevice();
  EXPECT_EQ(session.application.session().inForce().force_scale, 0.5);
}

TEST(HapticDevice, AnotherHandTakesItsPlaceAndClosesIt) {
  Bench bench;
  Session session(bench);
  const double own = session.application.session().inForce().stiffness;
  session.connectDevice();
  EXPECT_NE(session.application.session().inForce().stiffness, own);
  emit window::panelOf<ui::DevicePanel>(session.window()).handChosen("mouse");
  EXPECT_FALSE(bench.handle->open);
  EXPECT_EQ(session.application.session().inForce().stiffness, own);
  EXPECT_TRUE(session.label("deviceLink")->text().contains("disconnected"));
  EXPECT_EQ(session.window().findChild<QAbstractButton*>("connectDevice")->text(), "Connect");
}

TEST(HapticDevice, AnotherToolAndVolumeLeaveItConnected) {
  Bench bench;
  Session session(bench);
  session.connectDevice();
  auto scene = session.now().scene;
  emit window::panelOf<ui::DevicePanel>(session.window()).toolChosen("wrench");
  ASSERT_TRUE(waitFor([&] { return session.now().scene > scene; }));
  EXPECT_TRUE(bench.handle->open);
  scene = session.now().scene;
  emit session.window().menus().phantomWanted("torus");
  ASSERT_TRUE(waitFor([&] { return session.now().scene > scene; }));
  EXPECT_TRUE(bench.handle->open);
  EXPECT_EQ(session.handle().pushesSince(0), 0);
}

}  // namespace
