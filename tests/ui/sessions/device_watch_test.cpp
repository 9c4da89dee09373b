// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/device/device_watch.h"

#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTest>
#include <QTimer>
#include <stdexcept>

#include "tests/ui/sessions/hand_device.h"

namespace {

using app::DeviceCatalogue;
using app::DeviceWatch;
using haptics::Device;
using haptics::DeviceEntry;
using haptics::Expected;
using haptics::OpenRequest;
using haptics::Trouble;
using window::Gate;
using window::HandDevice;
using window::Handle;
using Made = Expected<std::unique_ptr<Device>>;

constexpr int kSoon_ms = 120'000;  // far more than it takes on a machine that is busy

DeviceEntry entry(std::string id, bool present = true) {
  DeviceEntry made{.id = id, .name = "The " + id, .sensed = 3, .actuated = 3, .present = present};
  if (!present) {
    made.trouble = Trouble::NotPluggedIn;
    made.why = "The " + id + " is not plugged in; connect its cable.";
  }
  return made;
}

DeviceCatalogue catalogueOf(std::function<Made(const OpenRequest&)> open) {
  return {.survey = [] { return std::vector{entry("falcon")}; },
          .open = std::move(open),
          .join = [](auto moved, auto) { return moved; }};
}

TEST(DeviceWatch, TheWindowGoesOnHoweverLongADeviceTakesToOpen) {
  Gate gate;
  auto handle = std::make_shared<Handle>();
  DeviceWatch watch(catalogueOf([&](const OpenRequest&) -> Made {
    gate.pass();
    return std::make_unique<HandDevice>(handle);
  }));
  QSignalSpy opened(&watch, &DeviceWatch::opened);
  int turns = 0;
  QTimer timer;
  QObject::connect(&timer, &QTimer::timeout, [&turns] { ++turns; });
  timer.start(1);
  watch.open({.id = "falcon"});
  ASSERT_TRUE(QTest::qWaitFor([&] { return gate.came() == 1; }, kSoon_ms));
  // the driver is at it until the window has gone on for long
  turns = 0;
  ASSERT_TRUE(QTest::qWaitFor([&] { return turns > 100; }, kSoon_ms));
  EXPECT_EQ(gate.passed(), 0);
  EXPECT_EQ(opened.size(), 0);
  gate.lift();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !opened.isEmpty(); }, kSoon_ms));
  EXPECT_EQ(qvariant_cast<ui::DeviceWish>(opened[0][0]).id, "falcon");
  EXPECT_TRUE(handle->open);
  opened.clear();  // nobody took it; the thread that opened it may hold it for a moment yet
  EXPECT_TRUE(QTest::qWaitFor([&] { return !handle->open; }, kSoon_ms));
}

TEST(DeviceWatch, AnotherWishTakesTheFirstOnesPlace) {
  Gate gate;
  auto first = std::make_shared<Handle>(), second = std::make_shared<Handle>();
  std::atomic<int> made = 0;
  DeviceWatch watch(catalogueOf([&](const OpenRequest& request) -> Made {
    if (request.id == "first") gate.pass();
    ++made;
    return std::make_unique<HandDevice>(request.id == "first" ? first : second);
  }));
  QSignalSpy opened(&watch, &DeviceWatch::opened);
  watch.open({.id = "first"});
  ASSERT_TRUE(QTest::qWaitFor([&] { return gate.came() == 1; }, kSoon_ms));
  watch.open({.id = "never"});
  watch.open({.id = "second"});
  gate.lift();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !opened.isEmpty(); }, kSoon_ms));
  EXPECT_EQ(made, 2);  // the one in between was never tried
  EXPECT_FALSE(first->open);
  EXPECT_TRUE(second->open);
  QTest::qWait(100);
  ASSERT_EQ(opened.size(), 1);
  EXPECT_EQ(qvariant_cast<ui::DeviceWish>(opened[0][0]).id, "second");
}

TEST(DeviceWatch, WhatIsGivenUpIsClosedAndNotReported) {
  Gate gate;
  auto handle = std::make_shared<Handle>();
  std::atomic<bool> over = false;
  DeviceWatch watch(catalogueOf([&](const OpenRequest&) -> Made {
    gate.pass();
    auto device = std::make_unique<HandDevice>(handle);
    over = true;
    return device;
  }));
  QSignalSpy opened(&watch, &DeviceWatch::opened), refused(&watch, &DeviceWatch::refused);
  watch.open({.id = "falcon"});
  ASSERT_TRUE(QTest::qWaitFor([&] { return gate.came() == 1; }, kSoon_ms));
  watch.cancel();
  gate.lift();
  ASSERT_TRUE(QTest::qWaitFor([&] { return over && !handle->open; }, kSoon_ms));
  QTest::qWait(100);
  EXPECT_EQ(opened.size() + refused.size(), 0);
}

TEST(DeviceWatch, OneThatTurnsIsJoinedToOneThatMoves) {
  auto moved = std::make_shared<Handle>(), turning = std::make_shared<Handle>();
  DeviceCatalogue catalogue = catalogueOf([&](const OpenRequest& request) -> Made {
    return std::make_unique<HandDevice>(request.id == "falcon" ? moved : turning);
  });
  std::atomic<int> joined = 0;
  catalogue.join = [&](std::unique_ptr<Device> a, std::unique_ptr<Device> b) {
    ++joined;
    EXPECT_TRUE(a && b && moved->open && turning->open);
    return a;
  };
  DeviceWatch watch(catalogue);
  QSignalSpy opened(&watch, &DeviceWatch::opened);
  watch.open({.id = "falcon", .turned_by = "spacemouse"});
  ASSERT_TRUE(QTest::qWaitFor([&] { return !opened.isEmpty(); }, kSoon_ms));
  EXPECT_EQ(joined, 1);
}

TEST(DeviceWatch, EveryTroubleComesThroughWithItsSentence) {
  std::atomic<Trouble> trouble = Trouble::None;
  DeviceWatch watch(catalogueOf([&](const OpenRequest&) -> Made {
    const std::string word{haptics::wordOf(trouble)};
    return tl::unexpected(
        haptics::Error{haptics::Error::Kind::Unsupported, "Because of " + word + ".", word});
  }));
  QSignalSpy refused(&watch, &DeviceWatch::refused);
  for (int n = 1; n <= static_cast<int>(Trouble::Lost); ++n) {
    trouble = static_cast<Trouble>(n);
    watch.open({.id = "falcon"});
    ASSERT_TRUE(QTest::qWaitFor([&] { return !refused.isEmpty(); }, kSoon_ms));
    const QList<QVariant> said = refused.takeFirst();
    EXPECT_EQ(qvariant_cast<Trouble>(said[1]), trouble);
    EXPECT_EQ(said[2].toString().toStdString(),
              "Because of " + std::string{haptics::wordOf(trouble)} + ".");
  }
}

TEST(DeviceWatch, ADriverThatThrowsIsARefusalAndNoEnd) {
  DeviceCatalogue catalogue = catalogueOf(
      [](const OpenRequest&) -> Made { throw std::runtime_error("a driver's own fault"); });
  std::atomic<int> surveys = 0;
  catalogue.survey = [&]() -> std::vector<DeviceEntry> {
    if (++surveys == 1) throw std::bad_alloc();
    return {entry("falcon")};
  };
  DeviceWatch watch(catalogue);
  QSignalSpy refused(&watch, &DeviceWatch::refused), surveyed(&watch, &DeviceWatch::surveyed);
  watch.open({.id = "falcon"});
  ASSERT_TRUE(QTest::qWaitFor([&] { return !refused.isEmpty(); }, kSoon_ms));
  watch.surveyNow();
  if (surveyed.isEmpty()) watch.surveyNow();
  ASSERT_TRUE(QTest::qWaitFor(
      [&] {
        if (surveyed.isEmpty()) watch.surveyNow();
        return !surveyed.isEmpty();
      },
      kSoon_ms));
}

TEST(DeviceWatch, ItLooksAgainAndAgainAndSaysOnlyWhatChanged) {
  std::atomic<int> surveys = 0;
  std::atomic<bool> plugged = false;
  DeviceCatalogue catalogue = catalogueOf([](const OpenRequest&) -> Made { return nullptr; });
  catalogue.survey = [&] {
    ++surveys;
    return std::vector{entry("falcon", plugged)};
  };
  DeviceWatch watch(catalogue);
  QSignalSpy surveyed(&watch, &DeviceWatch::surveyed);
  QTest::qWait(50);
  EXPECT_EQ(surveys, 0);  // nobody looks
  watch.watch(true);
  ASSERT_TRUE(QTest::qWaitFor([&] { return surveys >= 3; }, kSoon_ms));
  EXPECT_EQ(surveyed.size(), 1);
  plugged = true;
  ASSERT_TRUE(QTest::qWaitFor([&] { return surveyed.size() == 2; }, kSoon_ms));
  const auto lines = qvariant_cast<QList<ui::DeviceLine>>(surveyed[1][0]);
  ASSERT_EQ(lines.size(), 1);
  EXPECT_TRUE(lines[0].present);
  EXPECT_EQ(lines[0].force, 8.0);  // as a Falcon is rated
  watch.watch(false);
  QTest::qWait(200);
  const int then = surveys;
  QTest::qWait(1'500);  // it would be looked for each second
  EXPECT_EQ(surveys, then);
  watch.surveyNow();
  EXPECT_TRUE(QTest::qWaitFor([&] { return surveys == then + 1; }, kSoon_ms));
}

TEST(DeviceWatch, ASurveyThatHangsHoldsNobodyUp) {
  auto gate = std::make_shared<Gate>();
  auto over = std::make_shared<std::atomic<bool>>(false);
  {
    DeviceCatalogue catalogue = catalogueOf([](const OpenRequest&) -> Made { return nullptr; });
    catalogue.survey = [gate, over]() -> std::vector<DeviceEntry> {
      gate->pass();
      *over = true;
      return {entry("falcon")};
    };
    DeviceWatch watch(catalogue);
    watch.watch(true);
    ASSERT_TRUE(QTest::qWaitFor([&] { return gate->came() == 1; }, kSoon_ms));
    watch.open({.id = "falcon"});
    watch.cancel();
    watch.surveyNow();
  }
  // it is given two seconds to come to an end; whoever waited for it would wait for ever
  EXPECT_FALSE(*over);
  gate->lift();
  EXPECT_TRUE(QTest::qWaitFor([&] { return over->load(); }, kSoon_ms));
  QTest::qWait(100);  // it finds nobody to tell, and ends
}

}  // namespace
