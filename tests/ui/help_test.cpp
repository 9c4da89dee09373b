// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <QApplication>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QTextBlock>
#include <QToolButton>
#include <algorithm>
#include <set>

#include "app/application.h"
#include "app/window/help_controller.h"
#include "resources/messages/messages.h"
#include "sphere_in_hand.h"
#include "ui/help_window.h"
#include "ui/main_window.h"
#include "window_support.h"

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
  ASSERT_GT(ui::helpPages().size(), 25);
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

TEST(Help, KnowsEachMessageByItsWordsAndHasItsEntry) {
  ui::HelpPage page;
  int known = 0;
  for (const resources::Row& row : resources::rows()) {
    const QString sentence = filled(row);
    const QString place =
        app::helpPlaceOf("\"scan\" was not opened. " + sentence + " Still shown.");
    if (place.isEmpty()) {
      EXPECT_LE(sentence.size(), 30) << row.id;  // a clause, never shown alone
      continue;
    }
    ++known;
    EXPECT_TRUE(page.open(place)) << place.toStdString();
    EXPECT_TRUE(page.textCursor().selectedText().startsWith(place.section('#', 1) + ':'));
    // of messages with the same words the entry is in the same section
    const QString own = page.page();
    if (place.section('#', 1) != QString::fromUtf8(row.id.data(), qsizetype(row.id.size()))) {
      EXPECT_TRUE(page.open(own + '#' + QString::fromUtf8(row.id.data(), qsizetype(row.id.size()))))
          << row.id << " was taken for " << place.toStdString();
    }
  }
  EXPECT_GT(known, 380);
  EXPECT_EQ(app::helpPlaceOf("The view was saved."), "");
}

TEST(Help, MoreBesideAMessageLeadsToItsEntry) {
  ui::MainWindow window;
  const app::HelpController help(window);
  window::showAndWait(window, {1000, 700});
  auto* more = window.findChild<QPushButton*>("messageMore");
  ASSERT_NE(more, nullptr);
  window.showMessage("The view was saved.");
  EXPECT_FALSE(more->isVisible());
  const haptics::Message lost("hid-gone", {haptics::Message("Polhem")});
  window.showMessage(QString::fromStdString(resources::sentence(lost)));
  ASSERT_TRUE(more->isVisible());
  window::keep(window::pictureOf(window), "help_more");
  QTest::mouseClick(more, Qt::LeftButton);
  auto* shown = window.findChild<ui::HelpWindow*>("helpWindow");
  ASSERT_NE(shown, nullptr);
  EXPECT_TRUE(shown->isVisible());
  EXPECT_EQ(shown->page().page(), "messages-devices");
  EXPECT_TRUE(shown->page().textCursor().selectedText().startsWith("hid-gone:"));
  window.showFault(QString::fromStdString(resources::sentence(lost)));
  EXPECT_TRUE(window.findChild<QPushButton*>("faultMore")->isVisible());
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

TEST(Help, IsSearchedAndGoesBackAndForward) {
  ui::HelpWindow window;
  window.open("index");
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
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
