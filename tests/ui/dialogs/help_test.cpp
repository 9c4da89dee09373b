// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <QApplication>
#include <QDir>
#include <QFile>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QTextBlock>
#include <QToolButton>
#include <QTreeWidget>
#include <algorithm>
#include <set>

#include "app/application.h"
#include "app/window/program/help_controller.h"
#include "app/window/sessions/session_recording.h"
#include "resources/messages/messages.h"
#include "tests/ui/views/sphere_in_hand.h"
#include "tests/ui/window_support.h"
#include "ui/controls/language.h"
#include "ui/dialogs/help_window.h"
#include "ui/views/volume_view.h"
#include "ui/window/main_window.h"
#include "ui/window/menus.h"
#include "ui/window/messages.h"
#include "ui/window/side_panel.h"
#include "ui/window/touch_state.h"
#include "ui/window/views.h"

namespace {

/// The targets of all links of the page on view.
std::set<QString> linksOf(const QTextDocument& document) {
  std::set<QString> links;
  for (QTextBlock block = document.begin(); block.isValid(); block = block.next())
    for (auto part = block.begin(); !part.atEnd(); ++part) {
      const QString target = part.fragment().charFormat().anchorHref();
      if (!target.isEmpty()) links.insert(target);
    }
  return links;
}

/// What a message is with a word for each argument.
QString filled(const resources::Row& row) {
  haptics::Message message(std::string{row.id}.c_str(), {});
  for (int n = 1; n <= 9; ++n) message.arguments.emplace_back("word");
  return QString::fromStdString(resources::sentence(message));
}

TEST(Help, HasAllPagesAndEachLinkLeadsToAPlace) {
  ui::HelpPage page;
  // all are in the contents
  EXPECT_EQ(ui::helpPages().size(), QDir(":/help").entryList({"*.md"}).size());
  int links = 0;
  for (const QString& name : ui::helpPages()) {
    ASSERT_TRUE(page.open(name)) << name.toStdString();
    EXPECT_EQ(page.page(), name);
    EXPECT_EQ(page.document()->begin().blockFormat().headingLevel(), 1) << name.toStdString();
    for (const QString& link : linksOf(*page.document())) {
      ++links;
      ui::HelpPage other;
      EXPECT_TRUE(other.open(QString(link).replace(".md", "")))
          << name.toStdString() << ": " << link.toStdString();
    }
  }
  EXPECT_GT(links, 60);
  EXPECT_FALSE(page.open("nowhere"));
  EXPECT_FALSE(page.open("opening#nowhere"));
}

TEST(Help, KnowsEachMessageByItsWordsAndHasTheEntryOfItsReason) {
  ui::HelpPage page;
  int known = 0;
  for (const resources::Row& row : resources::rows()) {
    const QString entry = ui::helpPlaceOf(row.reason);
    EXPECT_EQ(entry.isEmpty(), row.reason.empty()) << row.id;
    if (entry.isEmpty()) continue;
    EXPECT_TRUE(page.open(entry)) << entry.toStdString();
    const QString sentence = filled(row);
    const QString place =
        app::helpPlaceOf("\"scan\" was not opened. " + sentence + " Still shown.");
    if (sentence.size() <= 30) continue;  // a clause, never shown alone
    ++known;
    EXPECT_EQ(place, entry) << row.id << ": " << sentence.toStdString();
  }
  EXPECT_GT(known, 280);
  EXPECT_EQ(app::helpPlaceOf("The view was saved."), "");
}

TEST(Help, MoreBesideAMessageLeadsToItsEntry) {
  ui::MainWindow window;
  const app::HelpController help(window.menus(), window.messages());
  window::showAndWait(window, {1000, 700});
  auto* more = window.findChild<QPushButton*>("messageMore");
  ASSERT_NE(more, nullptr);
  window.messages().showMessage("The view was saved.");
  EXPECT_FALSE(more->isVisible());
  const haptics::Message lost("device-gone", {haptics::Message("Polhem")});
  window.messages().showMessage(QString::fromStdString(resources::sentence(lost)));
  ASSERT_TRUE(more->isVisible());
  window::keep(window::pictureOf(window), "help_more");
  QTest::mouseClick(more, Qt::LeftButton);
  auto* shown = window.findChild<ui::HelpWindow*>("helpWindow");
  ASSERT_NE(shown, nullptr);
  EXPECT_TRUE(shown->isVisible());
  EXPECT_EQ(shown->page().page(), "messages");
  EXPECT_EQ(shown->page().textCursor().block().text(), "The device or the server went away");
  // where it is read, also once the window was closed: at the top, or as near as the page's end
  // lets it
  const auto isRead = [&] {
    QApplication::processEvents();
    const int top = shown->page().cursorRect().top(), height = shown->page().viewport()->height();
    const QScrollBar& bar = *shown->page().verticalScrollBar();
    EXPECT_GT(bar.value(), 0);
    EXPECT_TRUE(top >= 0 && top < (bar.value() == bar.maximum() ? height : 60)) << top;
  };
  isRead();
  // Escape closes it, and without motors that alone
  QSignalSpy stopped(&window.touch(), &ui::TouchState::forceOffWanted);
  QTest::keyClick(shown, Qt::Key_Escape);
  EXPECT_FALSE(shown->isVisible());
  EXPECT_EQ(stopped.count(), 0);
  QTest::mouseClick(more, Qt::LeftButton);
  isRead();
  window.messages().showFault(QString::fromStdString(resources::sentence(lost)));
  EXPECT_TRUE(window.findChild<QPushButton*>("faultMore")->isVisible());
}

/// Stored are what packaging/help/pictures.sh keeps of this test.
TEST(Help, PicturesShowTheWindowAsItIs) {
  constexpr int kWidest = 600;  // px, of a page
  QStringList made;
  const auto isStored = [&](const QString& name, QImage image) {
    if (image.width() > kWidest) image = image.scaledToWidth(kWidest, Qt::SmoothTransformation);
    window::keep(image, qPrintable("help_" + name));
    made << name;
    const QImage stored(":/help/pictures/" + name + ".png");
    // what is said of devices depends on the machine, and so does the height of the list
    if (name == "deviceSection") image = image.copy(0, 0, stored.width(), 180);
    EXPECT_LT(window::differing(stored.copy(image.rect()), image, 60), 0.15)
        << name.toStdString() << ": run packaging/help/pictures.sh, and look";
  };
  {
    app::Arguments arguments = window::sphereInHand("mouse");
    arguments.load.phantom = {};
    app::Application application(std::move(arguments));
    application.start();
    window::showAndWait(application.window(), {1280, 800});
    isStored("start", window::pictureOf(application.window()));
  }
  const QTemporaryDir folder;
  app::Arguments arguments = window::recordedSphere(folder);
  arguments.load.phantom = "demo";
  arguments.load.tool = app::ToolSource{.name = "drill"};
  arguments.load.isovalue = 300.0;
  app::Application application(std::move(arguments));
  application.start();
  ui::MainWindow& window = application.window();
  window::showAndWait(window, {1280, 800});
  ASSERT_TRUE(window::waitFor([&] { return application.snapshot().felt_W.force.norm() > 0.2; }));
  window::pictureAtRest(window.views().volume());
  isStored("touching", window::pictureOf(window));
  auto* record = window.findChild<QPushButton*>("record");
  auto& panel = *window.findChild<ui::SidePanel*>();
  panel.setTab(ui::Tab::Record);
  QTest::mouseClick(record, Qt::LeftButton);
  QTest::qWait(2'000);
  QTest::mouseClick(record, Qt::LeftButton);
  ASSERT_TRUE(window::waitFor([&] { return !application.recording().isRecording(); }));
  QTest::qWait(1'000);
  for (const auto& [section, tab] : {std::pair{"surfaceSection", ui::Tab::Touch},
                                     {"toolSection", ui::Tab::Touch},
                                     {"editSection", ui::Tab::Scan},
                                     {"deviceSection", ui::Tab::Device},
                                     {"recordingSection", ui::Tab::Record}}) {
    panel.setTab(tab);
    auto* shown = window.findChild<QWidget*>(section);
    ASSERT_NE(shown, nullptr) << section;
    if (auto* list = shown->findChild<QTreeWidget*>("deviceList")) {
      EXPECT_TRUE(window::waitFor([&] { return list->topLevelItemCount() > 0; }));
    }
    isStored(section, window::pictureOf(*shown));
  }
  // and each is on a page
  QString pages;
  for (const QString& name : ui::helpPages()) {
    QFile file(":/help/" + name + ".md");
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    pages += QString::fromUtf8(file.readAll());
  }
  EXPECT_EQ(pages.count("](pictures/"), made.size());
  for (const QString& name : made) EXPECT_TRUE(pages.contains("](pictures/" + name + ".png)"));
  ui::HelpWindow help;
  help.open("first-touch");
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&help, 120'000));
  window::keep(window::pictureOf(help), "first_touch_page");
  const QVariant found =
      help.page().loadResource(QTextDocument::ImageResource, QUrl("pictures/start.png"));
  EXPECT_EQ(QImage::fromData(found.toByteArray()).width(), kWidest);
  // all of page and contents is seen without a bar at the foot
  EXPECT_EQ(help.page().horizontalScrollBar()->maximum(), 0);
  EXPECT_EQ(help.findChild<QListWidget*>("helpContents")->horizontalScrollBar()->maximum(), 0);
}

TEST(Help, OpensAtThePartThatHasTheFocus) {
  app::Application application(window::sphereInHand("mouse"));
  application.start();
  ui::MainWindow& window = application.window();
  int asked = 0;
  for (const auto& [part, page] :
       {std::pair{"surfaceSection", "isovalue"}, std::pair{"editSection", "edits"},
        std::pair{"deviceSection", "devices"}, std::pair{"recordingSection", "recording"},
        std::pair{"views", "views"}}) {
    auto* section = window.findChild<QWidget*>(part);
    ASSERT_NE(section, nullptr) << part;
    EXPECT_EQ(ui::helpPageOf(section), page);
    for (QWidget* child : section->findChildren<QWidget*>()) {
      ++asked;
      EXPECT_NE(ui::helpPageOf(child), "index") << part;
    }
  }
  EXPECT_GT(asked, 50);
  EXPECT_EQ(ui::helpPageOf(nullptr), "index");
}

TEST(Help, SpeaksGermanWhereItCanAndItsLinksLeadWhereTheEnglishOnesDo) {
  ui::setLanguage("de");
  {
    const QStringList german = QDir(":/help/de").entryList({"*.md"});
    EXPECT_GE(german.size(), 24);
    ui::HelpPage page;
    int links = 0;
    for (const QString& name : ui::helpPages()) {
      ASSERT_TRUE(page.open(name)) << name.toStdString();
      const QTextBlock title = page.document()->begin();
      EXPECT_EQ(title.blockFormat().headingLevel(), 1) << name.toStdString();
      const bool translated = german.contains(name + ".md");
      EXPECT_EQ(title.next().text().contains("Englis") && title.next().text().size() < 60,
                !translated)
          << name.toStdString();
      for (const QString& link : linksOf(*page.document())) {
        ++links;
        ui::HelpPage other;
        EXPECT_TRUE(other.open(QString(link).replace(".md", "")))
            << name.toStdString() << ": " << link.toStdString();
      }
    }
    EXPECT_GT(links, 60);
    EXPECT_TRUE(page.open("opening#verdicts"));
    EXPECT_EQ(page.textCursor().block().text(), "Befunde");
    EXPECT_FALSE(page.open("opening#nowhere"));
    ui::HelpWindow window;
    window.open("force-safety");
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&window, 120'000));
    window::keep(window::pictureOf(window), "help_german");
    auto* contents = window.findChild<QListWidget*>("helpContents");
    EXPECT_EQ(contents->currentItem()->text(), "Sicherheit der Kraft");
    window.findChild<QLineEdit*>("helpSearch")->setText("Steifigkeit zittert");
    EXPECT_GE(contents->count(), 2);
    EXPECT_LT(contents->count(), ui::helpPages().size() / 2);
  }
}

TEST(Help, IsSearchedAndGoesBackAndForward) {
  ui::HelpWindow window;
  window.open("index");
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&window, 120'000));
  auto* contents = window.findChild<QListWidget*>("helpContents");
  auto* search = window.findChild<QLineEdit*>("helpSearch");
  auto* back = window.findChild<QToolButton*>("helpBack");
  auto* forward = window.findChild<QToolButton*>("helpForward");
  const int all = contents->count();
  EXPECT_EQ(all, ui::helpPages().size());
  EXPECT_FALSE(back->isEnabled());
  window.page().open("force-safety");
  EXPECT_EQ(contents->currentItem()->text(), "Safety of the force");
  window::keep(window::pictureOf(window), "help_page");
  QTest::mouseClick(back, Qt::LeftButton);
  EXPECT_EQ(window.page().page(), "index");
  QTest::mouseClick(forward, Qt::LeftButton);
  EXPECT_EQ(window.page().page(), "force-safety");
  // what fits best comes first
  search->setText("stop force");
  EXPECT_EQ(contents->item(0)->text(), "Safety of the force");
  search->setText("inkwell");
  EXPECT_GE(contents->count(), 2);
  EXPECT_LT(contents->count(), all / 2);
  QTest::keyClick(search, Qt::Key_Return);
  EXPECT_EQ(window.page().textCursor().selectedText(), "inkwell");
  search->setText("no such words anywhere");
  EXPECT_EQ(contents->count(), 0);
  search->clear();
  EXPECT_EQ(contents->count(), all);
}

}  // namespace
