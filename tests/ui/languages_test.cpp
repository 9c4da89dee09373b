// SPDX-License-Identifier: BSD-3-Clause
// The window in a language that a script made, longer than English and with an accent on every
// letter; and in German.
#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAction>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QLocale>
#include <QMenu>
#include <QMenuBar>
#include <QRegularExpression>
#include <QTest>
#include <QTextDocumentFragment>
#include <QTextEdit>
#include <QTranslator>
#include <QTreeWidget>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "app/application.h"
#include "app/export/export.h"
#include "app/recording/recorder.h"
#include "app/window/program/help_controller.h"
#include "app/window/scan/sentence.h"
#include "tests/support/places.h"
#include "tests/ui/views/sphere_in_hand.h"
#include "tests/ui/window_support.h"
#include "ui/controls/bindings.h"
#include "ui/controls/language.h"
#include "ui/controls/number_box.h"
#include "ui/controls/section.h"
#include "ui/dialogs/export_question.h"
#include "ui/dialogs/help_window.h"
#include "ui/dialogs/pacs_window.h"
#include "ui/dialogs/part_question.h"
#include "ui/dialogs/preferences_window.h"
#include "ui/dialogs/series_browser.h"
#include "ui/dialogs/text_window.h"
#include "ui/dialogs/unit_question.h"
#include "ui/panels/edit_panel.h"
#include "ui/panels/force_panel.h"
#include "ui/panels/recording_panel.h"
#include "ui/panels/replay_bar.h"
#include "ui/views/volume_view.h"
#include "ui/window/main_window.h"
#include "ui/window/side_panel.h"
#include "ui/window/start_page.h"
#include "ui/window/top_bar.h"
#include "ui/window/views.h"

namespace {

using window::waitFor;

constexpr const char* kTabs[] = {"scanTab", "touchTab", "deviceTab", "recordTab"};

/// What is shown and has no accent in any language: names, units, keys, and the words of Qt's own
/// buttons, which come from its own translations.
const QRegularExpression& names() {
  static const QRegularExpression all(
      "\\b(Palpate|Hounsfield|int16|uint8|English|Deutsch|"
      "Novint|Falcon|Polhem|WoodenHaptics|3Dconnexion|SpaceMouse|"
      "Ctrl|Shift|Alt|Escape|Space|Delete|Backspace|Enter|Home|End|Page|Up|Down|Left|Right|Menu|"
      "Tab|"
      "OK|Cancel|Close|Save|Reset|Discard|Help|bytes|OpenHaptics|"
      "PALPATE|Muster|stl|https|dicom|web|pacs|example|org)\\b",
      QRegularExpression::UseUnicodePropertiesOption);
  return all;
}

/// The words without an accent in a text.
QStringList englishIn(QString text) {
  if (Qt::mightBeRichText(text)) text = QTextDocumentFragment::fromHtml(text).toPlainText();
  // files, and dates as Qt writes them
  static const QRegularExpression place(
      "/[\\w./-]+|\\blib\\w+\\.so[.\\d]*|\\d+ [A-Z][a-z]{2} \\d{4}");
  text.remove('&').remove(place).remove(names());
  static const QRegularExpression word("(?<![\\w.])([A-Za-z]{3,}|of|to|at|or|on|no)(?!\\w)",
                                       QRegularExpression::UseUnicodePropertiesOption);
  QStringList words;
  for (auto found = word.globalMatch(text); found.hasNext();) words << found.next().captured(1);
  return words;
}

/// Every text of a part of the window that a user can come to see or hear.
QStringList textsOf(const QWidget& part) {
  QStringList texts{part.toolTip(),        part.windowTitle(),
                    part.accessibleName(), part.accessibleDescription(),
                    part.statusTip(),      part.whatsThis()};
  if (const auto* label = qobject_cast<const QLabel*>(&part)) texts << label->text();
  if (const auto* button = qobject_cast<const QAbstractButton*>(&part)) texts << button->text();
  if (const auto* line = qobject_cast<const QLineEdit*>(&part)) texts << line->placeholderText();
  if (const auto* box = qobject_cast<const QComboBox*>(&part))
    for (int i = 0; i < box->count(); ++i) texts << box->itemText(i);
  if (const auto* spin = qobject_cast<const QDoubleSpinBox*>(&part))
    texts << spin->prefix() << spin->suffix() << spin->specialValueText();
  if (const auto* list = qobject_cast<const QAbstractItemView*>(&part);
      list != nullptr && list->model() != nullptr) {
    const QAbstractItemModel& model = *list->model();
    for (int column = 0; column < model.columnCount(); ++column) {
      texts << model.headerData(column, Qt::Horizontal).toString();
      for (int row = 0; row < model.rowCount(); ++row)
        for (const int role : {int(Qt::DisplayRole), int(Qt::ToolTipRole)})
          texts << model.index(row, column).data(role).toString();
    }
  }
  for (const QAction* action : part.actions()) texts << action->text() << action->toolTip();
  return texts;
}

/// Nothing in `parent`, seen or not, has a word that is not translated.
void expectNoEnglish(QWidget& parent, const char* where) {
  for (QMenu* menu : parent.findChildren<QMenu*>()) emit menu->aboutToShow();
  std::set<std::string> found;
  QList<QWidget*> parts = parent.findChildren<QWidget*>();
  parts.prepend(&parent);
  for (const QWidget* part : parts) {
    // Qt's own window for files and its fields' menus
    if (part->inherits("QFileDialog") || part->objectName().startsWith("qt_")) continue;
    for (const QString& text : textsOf(*part))
      if (!englishIn(text).isEmpty())
        found.insert((part->metaObject()->className() + (" " + part->objectName()) + ": " + text)
                         .toStdString());
  }
  for (const std::string& text : found) ADD_FAILURE() << where << ": " << text;
}

/// A language that is spoken as long as it lives.
class Pseudo {
 public:
  Pseudo() {
    if (!translator_.load(QString::fromStdString(places::built("tests/ui/pseudo.qm"))))
      throw std::runtime_error("no pseudo language");
    QCoreApplication::installTranslator(&translator_);
  }

 private:
  QTranslator translator_;
};

void expectWhole(QWidget& dialog, const char* where) {
  window::showAndWait(dialog, dialog.sizeHint().expandedTo({400, 200}));
  expectNoEnglish(dialog, where);
  window::expectNothingCut(dialog, where);
  window::keep(window::pictureOf(dialog), (std::string("language_") + where).c_str());
}

TEST(Languages, TheTestFindsEnglish) {
  EXPECT_EQ(englishIn("Ñóóťé ƒóóŕé 12.5 mm, Falcon, Ctrl+O"), QStringList{});
  EXPECT_EQ(englishIn("<b>Ñóóťé</b> &for treatment"), (QStringList{"for", "treatment"}));
  QWidget parent;
  QLabel label("nothing here", &parent);
  EXPECT_NONFATAL_FAILURE(expectNoEnglish(parent, "planted"), "nothing here");
}

// ctest runs it at other scales, too
TEST(Languages, NoEnglishIsLeftInTheWindowAndNothingIsCut) {
  const Pseudo pseudo;
  const QTemporaryDir folder;
  app::Application application(window::recordedSphere(folder, "tap"));
  application.start();
  ui::MainWindow& window = application.window();
  ASSERT_TRUE(waitFor([&] { return application.snapshot().scene != 0; }));
  window.resize(1280, 800);
  window.bar().showRecording(3'725.0);
  for (ui::Section* section : window.findChildren<ui::Section*>()) section->setFolded(false);
  auto* side = window.findChild<ui::SidePanel*>("sidePanel");
  for (const char* tab : kTabs) {
    QTest::mouseClick(window.findChild<QAbstractButton*>(tab), Qt::LeftButton);
    if (QString(tab) == "deviceTab") {  // devices are looked for, and their list changes
      auto* devices = window.findChild<QTreeWidget*>("deviceList");
      ASSERT_TRUE(waitFor([&] { return devices->topLevelItemCount() > 0; }));
    }
    QTest::qWait(100);
    EXPECT_EQ(window.size(), QSize(1280, 800)) << tab;
    window::expectNothingCut(window, tab);
    window::expectNothingBeside(*side, tab);
    window::keep(window::pictureOf(window), (std::string("language_") + tab).c_str());
  }
  window.replayBar().show(ui::ReplayTrack{.begin = 0.0, .end = 4.0});
  // the window grows to what the bar needs
  const auto* time = window.findChild<QLabel*>("replayTime");
  EXPECT_TRUE(waitFor([&] { return time->width() >= time->minimumSizeHint().width(); }));
  window.panels().reveal(window.findChild<ui::EditPanel*>());
  for (const char* tool : {"cropTool", "planeTool", "piecesTool", "holderTool", "scalpelTool"}) {
    QTest::mouseClick(window.findChild<QAbstractButton*>(tool), Qt::LeftButton);
    QTest::qWait(50);
    window::expectNothingCut(window, tool);
    window::expectNothingBeside(*side, tool);
  }
  window::keep(window::pictureOf(window), "language_scalpel");
  ASSERT_TRUE(
      waitFor([&] { return application.snapshot().force_state == haptics::ForceState::On; }));
  QTest::keyClick(&window.views().volume(), Qt::Key_Escape);  // the scalpel
  QTest::keyClick(&window.views().volume(), Qt::Key_Escape);
  auto* resume = window.findChild<QAbstractButton*>("forceOn");
  ASSERT_TRUE(waitFor([&] { return resume->isVisible(); }));
  QTest::qWait(50);
  window::expectNothingCut(window, "stopped");
  expectNoEnglish(window, "window");
  for (const ui::ControlRow& row : ui::controlRows())
    EXPECT_TRUE(englishIn(row.triggers + row.place + row.words).isEmpty())
        << (row.triggers + ", " + row.place + ", " + row.words).toStdString();
}

TEST(Languages, NoEnglishIsLeftInTheOtherWindowsAndNothingIsCut) {
  const Pseudo pseudo;
  {
    ui::PreferencesWindow preferences;
    preferences.show(ui::PreferenceChoices{}, "/own");
    for (int page = 0; page < 6; ++page) {
      preferences.findChild<QListWidget*>("preferencePages")->setCurrentRow(page);
      expectWhole(preferences, ("preferences_" + std::to_string(page)).c_str());
    }
  }
  {
    ui::SeriesRow row;
    row.study = "1";
    ui::SeriesBrowser series("/pacs", {row});
    expectWhole(series, "series");
  }
  {
    ui::ExportDialog question(0.0, 2.0, {{"ĊŠṼ", "Ťááƀĺéé."}});
    expectWhole(question, "export");
  }
  {
    ui::PacsServer server;
    server.name = "Muster";
    ui::PacsSeries found;
    found.modality = "CT";
    found.date = "20240305";
    ui::PacsWindow pacs;
    pacs.showServers({server}, 0);
    pacs.showSeries({found}, true);
    expectWhole(pacs, "pacs");
    for (const bool web : {true, false}) {
      server.web = web;
      ui::PacsServerDialog description(server);
      expectWhole(description, "server");
    }
  }
  {
    ui::UnitDialog unit("ťóóóóĺ.stl", {30.0, 20.0, 10.0});
    expectWhole(unit, "unit");
  }
  {
    ui::LargeVolume large;
    large.dims = {512, 512, 700};
    large.free_bytes = 1e8;
    ui::BoxDialog box(large);
    expectWhole(box, "box");
  }
  {
    ui::TextWindow text("log", "Ĺóóğ", "Ŵĥááť ííťé ďííďé.", {}, nullptr);
    text.setAttribute(Qt::WA_DeleteOnClose, false);
    text.offerDelete();
    expectWhole(text, "text");
  }
  ui::StartPage start;
  start.setPlaces({}, true);
  window::showAndWait(start, {1000, 620});
  expectNoEnglish(start, "start");
  window::expectNothingCut(start, "start");
  window::keep(window::pictureOf(start), "language_start");
}

TEST(Languages, EverySentenceOfTheLibrariesIsTranslated) {
  const Pseudo pseudo;
  for (const resources::Row& row : resources::rows()) {
    const QString words = app::sentenceOf(haptics::Message{std::string{row.id}.c_str(), {}});
    EXPECT_TRUE(englishIn(QString(words).remove(QRegularExpression("\\(\\*.*|%\\S+"))).isEmpty())
        << words.toStdString();
  }
}

TEST(Languages, AreTheUsersChoiceOrTheFirstThatTheSystemPrefers) {
  EXPECT_EQ(ui::languageFor("de", {"en-GB"}), "de");
  EXPECT_EQ(ui::languageFor("en", {"de-DE"}), "en");
  EXPECT_EQ(ui::languageFor("", {"de-AT", "de"}), "de");
  EXPECT_EQ(ui::languageFor("", {"fr-FR", "fr", "de-DE", "en"}), "de");
  EXPECT_EQ(ui::languageFor("", {"fr-FR"}), "en");
  EXPECT_EQ(ui::languageFor("xx", {"C"}), "en");
}

/// The window speaks German.
/// In one menu no letter of the keyboard stands for two entries.
int expectLettersApart(const QList<QAction*>& entries, const QString& where) {
  std::map<QString, QString> taken;
  int letters = 0;
  for (const QAction* entry : entries) {
    if (const QMenu* menu = entry->menu())
      letters += expectLettersApart(menu->actions(), where + " > " + entry->text());
    const QString letter = QKeySequence::mnemonic(entry->text()).toString();
    if (letter.isEmpty()) continue;
    ++letters;
    const auto [at, is_new] = taken.try_emplace(letter, entry->text());
    EXPECT_TRUE(is_new) << where.toStdString() << ": " << at->second.toStdString() << ", "
                        << entry->text().toStdString();
  }
  return letters;
}

TEST(Languages, NoLetterOpensTwoEntriesOfAMenu) {
  for (const char* language : {"en", "de"}) {
    ui::setLanguage(language);
    app::Application application(window::sphereInHand("mouse"));
    const ui::MainWindow& window = application.window();
    EXPECT_GT(expectLettersApart(window.menuBar()->actions(), language), 50);
  }
}

class German : public testing::Test {
 protected:
  German() { ui::setLanguage("de"); }
};

TEST_F(German, IsSpokenByTheWindowWithItsNumbers) {
  app::Application application(window::sphereInHand("tap"));
  application.start();
  ui::MainWindow& window = application.window();
  ASSERT_TRUE(waitFor([&] { return application.snapshot().scene != 0; }));
  EXPECT_EQ(window.menuBar()->actions().front()->text(), "&Datei");
  EXPECT_TRUE(window.windowTitle().startsWith("Kugel")) << window.windowTitle().toStdString();
  // the words of Qt itself
  EXPECT_EQ(QCoreApplication::translate("QPlatformTheme", "Cancel"), "Abbrechen");
  // a point and a comma are both decimal marks, and a comma is written
  ui::NumberBox typed;
  typed.setDecimals(2);
  for (const char* number : {"0.25", "0,25"}) {
    typed.setValue(0.5);
    EXPECT_EQ(typed.text(), "0,50");
    typed.selectAll();
    QTest::keyClicks(&typed, number);
    QTest::keyClick(&typed, Qt::Key_Return);
    EXPECT_EQ(typed.value(), 0.25) << number;
    EXPECT_EQ(typed.text(), "0,25") << number;
  }
  ui::ForcePanel card;
  haptics::Snapshot snapshot;
  snapshot.force_state = haptics::ForceState::On;
  snapshot.felt_W.force = {1.5, 0.0, 0.0};
  card.display(snapshot);
  EXPECT_TRUE(card.findChild<QLabel*>("forceNow")->text().contains("1,50"));
  const haptics::Message aside{"dicom-slice-aside", {haptics::Message::numbers("0.5")}};
  EXPECT_TRUE(app::sentenceOf(aside).contains("0,5 mm")) << app::sentenceOf(aside).toStdString();
}

TEST_F(German, SentencesHaveTheirEntryInTheHelp) {
  int found = 0;
  for (const resources::Row& row : resources::rows()) {
    const haptics::Message message{std::string{row.id}.c_str(), {"A", "B", "C", "D", "E"}};
    const std::string english = resources::sentence(message);
    if (resources::rowIn(english) != &row) continue;  // its words are those of others
    ++found;
    EXPECT_EQ(resources::rowIn(app::sentenceOf(message).toStdString(), app::windowsLanguage()),
              &row)
        << app::sentenceOf(message).toStdString();
  }
  EXPECT_GT(found, 300);
}

std::map<std::string, std::string> filesIn(const std::filesystem::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    std::ifstream file(entry.path(), std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    files[entry.path().filename().string()] = text.str();
  }
  return files;
}

TEST_F(German, ChangesNoRecordingAndNoExport) {
  const QTemporaryDir folder, german, english;
  {
    app::Application application(window::recordedSphere(folder));
    application.start();
    ASSERT_TRUE(waitFor([&] { return application.snapshot().felt_W.force.norm() > 0.2; }));
    auto* record = application.window().findChild<QAbstractButton*>("record");
    record->click();
    window::afterTicks(application, 800);
    record->click();
    ASSERT_TRUE(waitFor([&] { return QFile::exists(folder.filePath("session-0001.palpate")); }));
  }
  const auto written = [&](const QTemporaryDir& out) {
    auto recording = app::Recording::open(folder.filePath("session-0001.palpate").toStdString());
    for (const app::exporting::Format& format : app::exporting::kFormats)
      EXPECT_TRUE(format.write(*recording,
                               out.filePath(QString("touch") + format.ending).toStdString(), {}));
    return filesIn(out.path().toStdString());
  };
  const auto in_german = written(german);
  ui::setLanguage("en");
  const auto in_english = written(english);
  EXPECT_EQ(in_german.size(), in_english.size());
  EXPECT_GT(in_german.size(), 5U);
  for (const auto& [name, bytes] : in_english) EXPECT_TRUE(in_german.at(name) == bytes) << name;
  const std::string& motion = in_german.at("touch_motion.tsv");
  EXPECT_NE(motion.find('.'), std::string::npos);
  EXPECT_EQ(motion.find(','), std::string::npos);
}

}  // namespace
