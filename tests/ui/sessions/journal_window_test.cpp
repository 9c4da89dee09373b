// SPDX-License-Identifier: BSD-3-Clause
// What the user does is kept while the program runs, and offered after an end that asked nothing.
#include <gtest/gtest.h>

#include <sys/stat.h>

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <memory>

#include "app/application.h"
#include "app/window/edits/edit_controller.h"
#include "app/window/program/journal.h"
#include "app/window/scan/loader.h"
#include "app/window/views/marks_controller.h"
#include "haptics/session.h"
#include "tests/ui/views/sphere_in_hand.h"
#include "tests/ui/window_support.h"
#include "ui/panels/device_panel.h"
#include "ui/window/main_window.h"
#include "ui/window/menus.h"
#include "ui/window/messages.h"
#include "ui/window/views.h"

namespace {
namespace kept_work {

using window::waitFor;
namespace fs = std::filesystem;

/// A user with a key, and a journal.
class User {
 public:
  User() : before_(qgetenv("XDG_DATA_HOME")) {
    qputenv("XDG_DATA_HOME", home_.path().toLocal8Bit());
  }
  ~User() {
    if (before_.isEmpty())
      qunsetenv("XDG_DATA_HOME");
    else
      qputenv("XDG_DATA_HOME", before_);
  }
  fs::path journal() const { return fs::path(home_.path().toStdString()) / "journal"; }
  /// The files of the journal that hold work.
  std::vector<fs::path> works() const {
    std::vector<fs::path> found;
    std::error_code error;
    for (const auto& entry : fs::recursive_directory_iterator(journal(), error))
      if (entry.path().extension() == app::kViewEnding) found.push_back(entry.path());
    return found;
  }
  std::unique_ptr<app::Application> start() const {
    app::Arguments arguments = window::sphereInHand("mouse");
    arguments.journal = journal();
    auto application = std::make_unique<app::Application>(arguments);
    application->start();
    EXPECT_TRUE(waitFor([&] {
      return application->shown() &&
             application->snapshot().scene == application->shown()->scene->id;
    }));
    return application;
  }
  /// What is kept, once this holds of it.
  template <class Holds>
  app::ViewFile kept(const Holds& holds) const {
    app::ViewFile view;
    EXPECT_TRUE(waitFor([&] {
      const auto files = works();
      if (files.size() != 1) return false;
      auto read = app::readViewFile(files.front());
      if (!read || !holds(*read)) return false;
      view = std::move(*read);
      return true;
    }));
    return view;
  }

 private:
  QByteArray before_;
  QTemporaryDir home_;
};

std::vector<ui::Measure> twoMarks() {
  return {{ui::MeasureKind::Distance, "Width", {{-5.25, 1, 2}, {10, 1, 2}}},
          {ui::MeasureKind::Note, "thin wall", {{3, -7, 5}}}};
}
const auto kTwoMarks = [](const app::ViewFile& view) { return view.marks.size() == 2; };

QPushButton& offer(app::Application& application) {
  return *application.window().findChild<QPushButton*>("takeWork");
}
bool offers(app::Application& application) {
  return waitFor([&] { return offer(application).isVisible(); });
}
QString messageOf(app::Application& application) {
  return application.window().findChild<QLabel*>("message")->text();
}

/// Clicks this button of every question.
struct Choice {
  explicit Choice(const char* button) {
    QObject::connect(&timer, &QTimer::timeout, [this, button] {
      auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
      if (box == nullptr) return;
      said << box->text();
      for (QAbstractButton* choice : box->buttons())
        if (choice->text().remove('&').startsWith(button)) return choice->click();
    });
    timer.start(20);
  }
  QTimer timer;
  QStringList said;
};

TEST(Journal, WorkIsKeptAndOfferedAgainUntilItIsSavedOrDiscarded) {
  const User user;
  {
    const auto application = user.start();
    EXPECT_FALSE(offer(*application).isVisible());
    application->marks().measures().replace(twoMarks());
    user.kept(kTwoMarks);
    // what came last is in it, though a signal leaves no time
    application->marks().measures().replace({twoMarks().front()});
    application->end();
  }
  EXPECT_EQ(user.kept([](const app::ViewFile&) { return true; }).marks.size(), 1U);
  {
    const auto application = user.start();
    ASSERT_TRUE(offers(*application));
    EXPECT_TRUE(application->marks().measures().all().empty());
    window::keep(window::pictureOf(application->window()), "work_offered");
    offer(*application).click();
    EXPECT_FALSE(offer(*application).isVisible());
    ASSERT_TRUE(waitFor([&] { return application->marks().measures().all().size() == 1; }));
    // it is in no file yet, so closing asks
    const fs::path before = user.works().front();
    EXPECT_TRUE(waitFor([&] {
      const auto now = user.works();
      return now.size() == 1 && now.front() != before;
    }));
    Choice choice("Discard");
    application->window().close();
    EXPECT_EQ(choice.said.size(), 1);
    EXPECT_FALSE(application->window().isVisible());
    EXPECT_TRUE(user.works().empty());
  }
  const auto application = user.start();
  application->marks().measures().replace(twoMarks());
  user.kept(kTwoMarks);  // by then it would have offered
  EXPECT_FALSE(offer(*application).isVisible());
  application->end();
}

TEST(Journal, EditsIsovalueToolAndItsPlaceComeBack) {
  const User user;
  app::ViewFile view;
  {
    const auto application = user.start();
    EXPECT_TRUE(user.works().empty());  // looking alone is no work
    application->editing().restore({datasets::Crop{{{0, 0, 10}, {64, 64, 60}}}});
    user.kept([](const app::ViewFile& kept) { return kept.edits.size() == 1; });
    emit window::panelOf<ui::DevicePanel>(application->window()).toolChosen("needle");
    user.kept([](const app::ViewFile& kept) { return kept.tool == "needle"; });
    emit application->window().views().isovalueWanted(60.0);
    application->window().views().setCross({-28.0, -28.0, 0.0});
    application->window().findChild<QAction*>("toolToCross")->trigger();
    view = user.kept([&](const app::ViewFile& kept) {
      return kept.isovalue == 60.0 && kept.X_WP &&
             (kept.X_WP->translation() - application->snapshot().X_WP.translation()).norm() <
                 1e-4 &&
             std::abs(kept.X_WP->translation().x() + 0.028) < 2e-3;
    });
    application->end();
  }
  const auto application = user.start();
  ASSERT_TRUE(offers(*application));
  offer(*application).click();
  EXPECT_TRUE(waitFor([&] {
    const haptics::Pose& X_WP = application->snapshot().X_WP;
    return application->shown()->tool.name == "needle" &&
           (X_WP.translation() - view.X_WP->translation()).norm() < 1e-4 &&
           X_WP.linear().isApprox(view.X_WP->linear(), 1e-3);
  })) << messageOf(*application).toStdString();
  EXPECT_EQ(application->editing().edits().size(), 1U);
  EXPECT_EQ(user.kept([](const app::ViewFile& kept) { return kept.tool == "needle"; }).isovalue,
            60.0);
  application->end();
}

TEST(Journal, AnotherScanGivesUpTheEditsAndADiscardIsAskedAbout) {
  const User user;
  {
    const auto application = user.start();
    const auto sphere = application->shown()->volume()->grid.dims;
    application->marks().measures().replace(twoMarks());
    application->editing().restore({datasets::Crop{{{0, 0, 10}, {64, 64, 60}}}});
    emit application->window().views().isovalueWanted(60.0);
    user.kept(
        [](const app::ViewFile& view) { return view.edits.size() == 1 && view.isovalue == 60.0; });
    const QString before = application->window().windowTitle();
    {
      const Choice choice("Discard");
      emit application->window().menus().phantomWanted("torus");
      EXPECT_TRUE(waitFor([&] { return application->window().windowTitle() != before; }));
    }
    const auto view = user.kept([](const app::ViewFile& kept) { return kept.edits.empty(); });
    EXPECT_EQ(view.marks.size(), 2U);
    EXPECT_EQ(view.isovalue, 60.0);  // not that of the other scan
    EXPECT_EQ(view.grid.dims, sphere);
    QTest::qWait(1'200);
    EXPECT_EQ(user.works().size(), 1U);  // with the other scan nothing was done
    application->end();
  }
  const auto application = user.start();
  ASSERT_TRUE(offers(*application));
  // of another scan nothing is offered, and of this one again when it comes back
  const auto showAnother = [&](const char* phantom) {
    const auto scene = application->shown()->scene->id;
    emit application->window().menus().phantomWanted(phantom);
    EXPECT_TRUE(waitFor([&] { return application->shown()->scene->id != scene; }));
  };
  showAnother("torus");
  EXPECT_TRUE(waitFor([&] { return !offer(*application).isVisible(); }));
  QTest::qWait(600);
  EXPECT_FALSE(offer(*application).isVisible());
  showAnother("sphere");
  ASSERT_TRUE(offers(*application));
  auto* drop = application->window().findChild<QPushButton*>("dropWork");
  {
    const Choice choice("Cancel");
    drop->click();
  }
  EXPECT_EQ(user.works().size(), 1U);
  ASSERT_TRUE(offers(*application));
  const Choice choice("Discard");
  drop->click();
  EXPECT_TRUE(user.works().empty());
  EXPECT_FALSE(offer(*application).isVisible());
  application->end();
}

TEST(Journal, ForgettingPlacesRemovesItAtOnceAndOffKeepsNothing) {
  const User user;
  const auto application = user.start();
  application->marks().measures().replace(twoMarks());
  user.kept(kTwoMarks);
  ui::Menus& menus = application->window().menus();
  emit menus.forgetPlacesWanted();
  EXPECT_TRUE(user.works().empty());
  // what is done after that is kept again
  application->marks().measures().replace({twoMarks().front()});
  user.kept([](const app::ViewFile& view) { return view.marks.size() == 1; });
  emit menus.rememberPlacesChanged(false);
  EXPECT_TRUE(user.works().empty());
  application->marks().measures().replace(twoMarks());
  QTest::qWait(1'500);
  EXPECT_TRUE(user.works().empty());
  // the same of a scan that came meanwhile, until it is switched on
  emit menus.phantomWanted("sphere");
  EXPECT_TRUE(waitFor([&] { return application->shown()->title.contains("phere"); }));
  emit menus.rememberPlacesChanged(true);
  application->marks().measures().replace(twoMarks());
  user.kept(kTwoMarks);
  emit menus.rememberPlacesChanged(false);
  EXPECT_TRUE(user.works().empty());
  // nor where the scan is left with its marks
  const auto scene = application->shown()->scene->id;
  emit menus.phantomWanted("torus");
  EXPECT_TRUE(waitFor([&] { return application->shown()->scene->id != scene; }));
  QTest::qWait(300);
  EXPECT_TRUE(user.works().empty());
  application->end();
  EXPECT_TRUE(user.works().empty());
}

TEST(Journal, WhatIsDamagedIsLeftOutWithASentence) {
  const User user;
  {
    const auto application = user.start();
    application->marks().measures().replace(twoMarks());
    user.kept(kTwoMarks);
    application->end();
  }
  std::ofstream(user.works().front(), std::ios::app) << "x";
  const auto application = user.start();
  EXPECT_TRUE(waitFor([&] { return messageOf(*application).contains("left out"); }));
  EXPECT_FALSE(offer(*application).isVisible());
  EXPECT_EQ(user.works().size(), 1U);
  application->marks().measures().replace(twoMarks());
  EXPECT_TRUE(waitFor([&] { return user.works().size() == 2; }));
  application->end();
}

TEST(Journal, WhereNothingCanBeKeptOneSentenceSaysSo) {
  const User user;
  std::ofstream(user.journal()) << "no folder";
  const auto application = user.start();
  application->marks().measures().replace(twoMarks());
  EXPECT_TRUE(waitFor([&] { return messageOf(*application).contains("not kept while you work"); }));
  application->end();
}

/// Work on the n-th of many scans.
app::ViewFile workOn(std::uint8_t n) {
  app::ViewFile view;
  view.grid.dims = {n + 1, 4, 4};
  view.grid.spacing = {1e-3, 1e-3, 1e-3};
  view.hash.emplace();
  view.hash->fill(n);
  view.look.eye_mm = {0, -100, 0};
  return view;
}

TEST(Journal, OfSeveralProcessesNoneTouchesTheWorkOfAnother) {
  const User user;
  auto one = std::make_unique<app::Journal>(user.journal());
  app::Journal other(user.journal());
  EXPECT_FALSE(fs::exists(user.journal()));
  ASSERT_TRUE(one->write(workOn(1)));
  ASSERT_TRUE(other.write(workOn(1)));
  EXPECT_EQ(user.works().size(), 2U);
  for (const fs::path& work : user.works()) {
    struct stat what {};
    ASSERT_EQ(::stat(work.c_str(), &what), 0);
    EXPECT_EQ(what.st_mode & 0777U, 0600U);
    ASSERT_EQ(::stat(work.parent_path().c_str(), &what), 0);
    EXPECT_EQ(what.st_mode & 0777U, 0700U);
  }
  // both go on, so there is nothing to offer or to sweep
  EXPECT_TRUE(app::Journal(user.journal()).left().empty());
  app::Journal(user.journal()).sweep();
  EXPECT_EQ(user.works().size(), 2U);
  one.reset();
  ASSERT_EQ(other.left().size(), 1U);
  EXPECT_EQ(other.left().front().hash, *workOn(1).hash);
  other.clear();
  EXPECT_EQ(other.left().size(), 1U);
  EXPECT_EQ(user.works().size(), 1U);
  ASSERT_TRUE(other.write(workOn(2)));
  app::Journal(user.journal()).forget();
  EXPECT_TRUE(user.works().empty());
  ASSERT_TRUE(other.write(workOn(3)));  // its folder is still its own
}

TEST(Journal, KeepsTheNewestScansAndNoRubbish) {
  const User user;
  for (std::uint8_t n = 0; n < 12; ++n) {
    app::Journal journal(user.journal());
    ASSERT_TRUE(journal.write(workOn(n)));
    std::ofstream(user.works().front().parent_path() / "x.part7") << "half";
    for (const fs::path& work : user.works())
      if (app::readViewFile(work)->grid.dims[0] == n + 1)
        fs::last_write_time(work, fs::file_time_type::clock::now() - std::chrono::hours(24 * 30) +
                                      std::chrono::hours(n));
  }
  app::Journal journal(user.journal());
  journal.sweep();
  const auto left = journal.left();
  ASSERT_EQ(left.size(), app::Journal::kMostScans);
  EXPECT_EQ(left.front().hash, *workOn(11).hash);
  EXPECT_EQ(left.back().hash, *workOn(4).hash);
  std::size_t folders = 0;
  for (const auto& entry : fs::directory_iterator(user.journal())) folders += entry.is_directory();
  EXPECT_EQ(folders, app::Journal::kMostScans);
}

/// Types a name into every file dialog, says no to what it asks, and goes.
struct Refusing {
  explicit Refusing(const QString& path) {
    QObject::connect(&timer, &QTimer::timeout, [this, path] {
      QWidget* open = QApplication::activeModalWidget();
      if (auto* box = qobject_cast<QMessageBox*>(open)) {
        asked << box->text();
        auto* no = box->button(QMessageBox::No);
        return no != nullptr ? no->click() : box->reject();
      }
      auto* dialog = qobject_cast<QFileDialog*>(open);
      if (dialog == nullptr) {
        if (auto* wish = qobject_cast<QDialog*>(open)) wish->accept();
        return;
      }
      if (!asked.isEmpty()) return dialog->reject();
      dialog->findChild<QLineEdit*>("fileNameEdit")->setText(path);
      QMetaObject::invokeMethod(dialog, "accept", Qt::QueuedConnection);
    });
    timer.start(50);
  }
  QTimer timer;
  QStringList asked;
};

TEST(Journal, NothingIsWrittenOverWithoutAQuestion) {
  const User user;
  const QTemporaryDir folder;
  const auto application = user.start();
  application->editing().restore({datasets::Crop{{{0, 0, 10}, {64, 64, 60}}}});
  ASSERT_TRUE(waitFor([&] { return application->editing().edits().size() == 1; }));
  for (const auto& [action, name] : {std::pair{"saveViewAs", "a.palpate-view"},
                                     {"savePicture", "a.png"},
                                     {"saveEdited", "a.nrrd"}}) {
    const QString path = folder.filePath(name);
    std::ofstream(path.toStdString()) << "mine";
    Refusing refusing(path);
    application->window().findChild<QAction*>(action)->trigger();
    EXPECT_EQ(refusing.asked.size(), 1) << action;
    EXPECT_EQ(fs::file_size(path.toStdString()), 4U) << action;
  }
  // one that the program gives its ending
  {
    Refusing refusing(folder.filePath("a.other"));
    std::ofstream(folder.filePath("a.other.nrrd").toStdString()) << "mine";
    application->window().findChild<QAction*>("saveEdited")->trigger();
    EXPECT_EQ(refusing.asked.size(), 1);
    EXPECT_EQ(fs::file_size(folder.filePath("a.other.nrrd").toStdString()), 4U);
  }
  application->end();
}

}  // namespace kept_work
}  // namespace
