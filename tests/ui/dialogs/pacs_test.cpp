// SPDX-License-Identifier: BSD-3-Clause
// Scans from a PACS: what the window asks of palpate-fetch, and what it makes of the answers. The
// program that answers here is a script that says what palpate-fetch says.
#include "app/window/opening/pacs_controller.h"

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

#include "app/application.h"
#include "app/window/scan/loader.h"
#include "tests/support/dicom_bytes.h"
#include "tests/ui/window_support.h"
#include "ui/dialogs/pacs_window.h"
#include "ui/window/main_window.h"
#include "ui/window/menus.h"
#include "ui/window/messages.h"

namespace {

using window::waitFor;

constexpr const char* kScript = R"(#!/usr/bin/python3
import json, os, shutil, signal, sys, time
work = os.path.dirname(os.path.abspath(__file__))
given = json.loads(sys.stdin.readline())
with open(work + "/asked", "a") as log:
    log.write(json.dumps({"arguments": sys.argv[1:], "given": given}) + "\n")
def say(answer):
    print(json.dumps(answer), flush=True)
command = sys.argv[1]
if "--dicomweb" in sys.argv and "wrong" in sys.argv[sys.argv.index("--dicomweb") + 1]:
    say({"error": {"code": 4, "reason": "host", "message": "There is no host \"wrong\"."}})
    sys.exit(4)
if command == "echo":
    say({"answers": True})
elif command in ("remember", "forget"):
    say({command: True})
elif command == "find":
    series = []
    for n in range(2):
        one = {"index": n, "study": n + 1, "modality": "CT", "study_date": "20240305", "number": 3,
               "images": 120 if n == 0 else None, "bytes": None, "check": "abc%d" % n}
        if "--names" in sys.argv:
            one.update(patient_name="MUSTER^HANS", patient_id="4711", study_description="Head",
                       series_description="Bone")
        series.append(one)
    say({"series": series, "left_out": 0})
elif given["index"] == 1:
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(130))
    say({"event": "progress", "images": 7, "of": 120, "bytes": 3700000})
    time.sleep(60)
else:
    folder = work + "/palpate-fetch-1a2b3c"
    shutil.copytree(work + "/scan", folder)
    say({"event": "progress", "images": 60, "of": 120, "bytes": 31000000})
    say({"event": "done", "folder": folder, "images": 120, "bytes": 62000000, "missing": 0, "not_kept": 0,
         "warnings": []})
    sys.stdin.read()
    shutil.rmtree(folder)
)";

class Pacs : public testing::Test {
 protected:
  Pacs() {
    QSettings().clear();
    QFile script(folder_.filePath("palpate-fetch"));
    EXPECT_TRUE(script.open(QFile::WriteOnly));
    script.write(kScript);
    script.setPermissions(script.permissions() | QFile::ExeOwner);
    script.close();
    writeScan();
    app::savePacsServers({{.name = "Archive",
                           .url = "https://pacs.example.org/dicom-web",
                           .login = ui::PacsServer::Login::Basic,
                           .user = "reader"},
                          {.name = "Wrong", .url = "https://wrong"}});
    controller_ = std::make_unique<app::PacsController>(window_.messages(), window_.menus(),
                                                        folder_.filePath("palpate-fetch"));
    window::showAndWait(window_, {1000, 700});
    window_.findChild<QAction*>("fromPacs")->trigger();
  }
  ~Pacs() override { QSettings().clear(); }

  /// What is fetched: four slices of somebody.
  void writeScan() {
    QDir(folder_.path()).mkdir("scan");
    for (int k = 0; k < 4; ++k) {
      datasets::testing::DicomSlice slice;
      slice.instance += "." + std::to_string(k);
      slice.position_mm = {0, 0, double(k)};
      slice.rows = slice.columns = 8;
      for (int n = 0; n < 64; ++n) slice.pixels.push_back(std::int16_t(n % 8 < 4 ? -1000 : 500));
      const std::string bytes = datasets::testing::edited(
          bytesOf(slice),
          {{0x8, 0x103e, "LO", "Bone of MUSTER"}, {0x10, 0x10, "PN", "MUSTER^HANS"}});
      QFile file(folder_.filePath(QString("scan/%1.dcm").arg(k)));
      EXPECT_TRUE(file.open(QFile::WriteOnly));
      file.write(bytes.data(), qint64(bytes.size()));
    }
  }

  template <class Widget>
  Widget& part(const char* name) {
    auto* found = shown_->findChild<Widget*>(name);
    EXPECT_NE(found, nullptr) << name;
    return *found;
  }
  void click(const char* name) {
    auto& button = part<QPushButton>(name);
    ASSERT_TRUE(button.isEnabled()) << name;
    QTest::mouseClick(&button, Qt::LeftButton);
  }
  bool answers(const char* words) {
    return waitFor([&] { return part<QLabel>("pacsAnswer").text().contains(words); });
  }
  QString asked() {
    QFile file(folder_.filePath("asked"));
    return file.open(QFile::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString{};
  }
  void search() {
    part<QLineEdit>("pacsPatientId").setText("4711");
    part<QLineEdit>("pacsSecret").setText("s3cret");
    click("pacsSearch");
    ASSERT_TRUE(answers("2 series match")) << part<QLabel>("pacsAnswer").text().toStdString();
  }
  QTableWidget& list() { return part<QTableWidget>("pacsSeries"); }

  QTemporaryDir folder_;
  ui::MainWindow window_;
  ui::MainWindow* shown_ = &window_;  ///< whose parts are meant
  std::unique_ptr<app::PacsController> controller_;
};

TEST_F(Pacs, HidesNamesFromTheStartAndEachLetterIsOneKey) {
  for (int column = 5; column < list().columnCount(); ++column)
    EXPECT_TRUE(list().isColumnHidden(column)) << column;
  QStringList letters;
  const auto take = [&](const QString& words) {
    const qsizetype at = words.indexOf('&');
    if (at >= 0) letters << words.mid(at + 1, 1).toUpper();
  };
  for (const auto* one : list().window()->findChildren<QAbstractButton*>()) take(one->text());
  for (const auto* one : list().window()->findChildren<QLabel*>()) take(one->text());
  EXPECT_GE(letters.size(), 11);
  EXPECT_EQ(letters.removeDuplicates(), 0) << letters.join(' ').toStdString();
}

TEST_F(Pacs, AServerIsTestedAndASentenceSaysWhatIsWrong) {
  click("pacsTest");
  EXPECT_TRUE(answers("The server answers"));
  auto& servers = part<QComboBox>("pacsServers");
  servers.setCurrentIndex(1);
  emit servers.activated(1);
  click("pacsTest");
  EXPECT_TRUE(answers("There is no host \"wrong\"."));
  EXPECT_TRUE(waitFor([&] { return part<QPushButton>("pacsTest").isEnabled(); }));
}

TEST_F(Pacs, SeriesAreListedWithoutNamesUntilTheirSwitchIsOn) {
  search();
  ASSERT_EQ(list().rowCount(), 2);
  EXPECT_EQ(list().item(0, 4)->text(), "120");
  EXPECT_EQ(list().item(1, 4)->text(), "");
  for (int column = 0; column < list().columnCount(); ++column)
    EXPECT_FALSE(list().item(0, column)->text().contains("MUSTER"));
  EXPECT_TRUE(list().isColumnHidden(5));
  window::keep(window::pictureOf(*list().window()), "pacs_window");
  part<QCheckBox>("pacsNames").click();
  EXPECT_TRUE(waitFor([&] { return list().rowCount() == 2 && !list().isColumnHidden(5); }));
  EXPECT_EQ(list().item(0, 5)->text(), "MUSTER^HANS");
  // neither what is searched nor a secret stands in a list of processes or in the preferences
  const QStringList lines = asked().split('\n', Qt::SkipEmptyParts);
  ASSERT_EQ(lines.size(), 2);
  for (const QString& line : lines) {
    const QString arguments = line.section("\"given\"", 0, 0), given = line.section("\"given\"", 1);
    for (const char* word : {"4711", "s3cret"}) {
      EXPECT_FALSE(arguments.contains(word)) << line.toStdString();
      EXPECT_TRUE(given.contains(word)) << line.toStdString();
    }
  }
  QSettings().sync();
  QFile settings(QSettings().fileName());
  ASSERT_TRUE(settings.open(QFile::ReadOnly));
  const QByteArray stored = settings.readAll();
  for (const char* word : {"4711", "s3cret", "MUSTER"}) EXPECT_FALSE(stored.contains(word)) << word;
}

TEST_F(Pacs, ASeriesIsFetchedAndItsFolderStaysToTheEnd) {
  search();
  QSignalSpy opened(controller_.get(), &app::PacsController::openWanted);
  list().selectRow(0);
  click("pacsFetch");
  ASSERT_TRUE(waitFor([&] { return opened.count() == 1; }));
  const QString folder = opened.at(0).at(0).toString();
  EXPECT_TRUE(QDir(folder).exists());
  EXPECT_TRUE(answers("120 images"));
  EXPECT_FALSE(list().window()->isVisible());
  EXPECT_TRUE(asked().contains("\"check\": \"abc0\""));
  QTest::qWait(300);
  EXPECT_TRUE(QDir(folder).exists());
  controller_.reset();
  EXPECT_TRUE(waitFor([&] { return !QDir(folder).exists(); }));
}

TEST_F(Pacs, AScanThatWasFetchedIsCalledSoAndByNoName) {
  app::Application application({.surface = ui::SurfaceMode::Mesh,
                                .notice = false,
                                .fetch_program = folder_.filePath("palpate-fetch")});
  application.start();
  shown_ = &application.window();
  shown_->findChild<QAction*>("fromPacs")->trigger();
  search();
  list().selectRow(0);
  click("pacsFetch");
  ASSERT_TRUE(waitFor([&] { return application.shown().has_value(); }));
  EXPECT_TRUE(shown_->windowTitle().startsWith("From the PACS"))
      << shown_->windowTitle().toStdString();
  for (const char* word : {"palpate-fetch", "MUSTER", "Bone"})
    EXPECT_FALSE(shown_->windowTitle().contains(word)) << word;
}

TEST_F(Pacs, NothingStaysOfAServerThatWasEdited) {
  part<QLineEdit>("pacsSecret").setText("s3cret");
  click("pacsTest");
  ASSERT_TRUE(answers("The server answers"));
  QTimer::singleShot(0, &window_, [&] {
    auto* dialog = qobject_cast<ui::PacsServerDialog*>(QApplication::activeModalWidget());
    ASSERT_NE(dialog, nullptr);
    dialog->findChild<QLineEdit*>("pacsUrl")->setText("https://other.example.org/dicom-web");
    dialog->accept();
  });
  click("pacsEdit");
  EXPECT_EQ(part<QLabel>("pacsAnswer").text(), "");
  EXPECT_EQ(part<QLineEdit>("pacsSecret").text(), "");
  click("pacsTest");
  ASSERT_TRUE(answers("The server answers"));
  auto& servers = part<QComboBox>("pacsServers");
  servers.setCurrentIndex(1);
  emit servers.activated(1);
  EXPECT_EQ(part<QLabel>("pacsAnswer").text(), "");
}

TEST_F(Pacs, ALoginGoesIntoTheKeyringAndOutOfIt) {
  QTimer::singleShot(0, &window_, [&] {
    auto* dialog = qobject_cast<ui::PacsServerDialog*>(QApplication::activeModalWidget());
    ASSERT_NE(dialog, nullptr);
    auto* login = dialog->findChild<QComboBox*>("pacsLogin");
    login->setCurrentIndex(login->findData(int(ui::PacsServer::Login::Keyring)));
    dialog->accept();
  });
  EXPECT_FALSE(part<QPushButton>("pacsRemember").isVisible());
  click("pacsEdit");
  EXPECT_FALSE(part<QPushButton>("pacsRemember").isEnabled());
  part<QLineEdit>("pacsSecret").setText("s3cret");
  window::keep(window::pictureOf(*list().window()), "pacs_keyring");
  click("pacsRemember");
  ASSERT_TRUE(answers("The keyring has it now."));
  EXPECT_EQ(part<QLineEdit>("pacsSecret").text(), "");
  click("pacsForget");
  ASSERT_TRUE(answers("The keyring has it no more."));
  const QStringList lines = asked().split('\n', Qt::SkipEmptyParts);
  ASSERT_EQ(lines.size(), 2);
  EXPECT_TRUE(lines[0].contains("\"remember\"")) << lines[0].toStdString();
  EXPECT_TRUE(lines[0].contains("\"given\": {\"login\": {\"password\": \"s3cret\"}}"))
      << lines[0].toStdString();
  EXPECT_EQ(lines[0].count("s3cret"), 1);
  EXPECT_TRUE(lines[1].contains("\"forget\"")) << lines[1].toStdString();
  for (const QString& line : lines)
    EXPECT_TRUE(line.contains("\"--login\", \"keyring\", \"--user\", \"reader\""))
        << line.toStdString();
  QSettings().sync();
  QFile settings(QSettings().fileName());
  ASSERT_TRUE(settings.open(QFile::ReadOnly));
  EXPECT_FALSE(settings.readAll().contains("s3cret"));
}

TEST_F(Pacs, AFetchIsCancelledAndTheNextSearchWorks) {
  search();
  QSignalSpy opened(controller_.get(), &app::PacsController::openWanted);
  list().selectRow(1);
  click("pacsFetch");
  ASSERT_TRUE(
      waitFor([&] { return part<QLabel>("pacsProgress").text().contains("7 of 120 images"); }));
  window::keep(window::pictureOf(*list().window()), "pacs_fetching");
  click("pacsCancel");
  EXPECT_TRUE(answers("Cancelled."));
  EXPECT_EQ(opened.count(), 0);
  search();
}

TEST_F(Pacs, ServersAreDescribedAndKept) {
  QTimer::singleShot(0, &window_, [&] {
    auto* dialog = qobject_cast<ui::PacsServerDialog*>(QApplication::activeModalWidget());
    ASSERT_NE(dialog, nullptr);
    dialog->findChild<QLineEdit*>("pacsName")->setText("Ward");
    dialog->findChild<QComboBox*>("pacsKind")->setCurrentIndex(1);
    EXPECT_FALSE(dialog->findChild<QLineEdit*>("pacsUrl")->isVisible());
    dialog->findChild<QLineEdit*>("pacsHost")->setText("10.0.0.7");
    dialog->findChild<QLineEdit*>("pacsCalled")->setText("ARCHIVE");
    dialog->findChild<QCheckBox*>("pacsTls")->setChecked(true);
    dialog->accept();
  });
  click("pacsAdd");
  const QList<ui::PacsServer> kept = app::loadPacsServers();
  ASSERT_EQ(kept.size(), 3);
  EXPECT_EQ(kept[2].name, "Ward");
  EXPECT_FALSE(kept[2].web);
  EXPECT_EQ(kept[2].host, "10.0.0.7");
  EXPECT_EQ(kept[2].port, 104);
  EXPECT_EQ(kept[2].called, "ARCHIVE");
  EXPECT_TRUE(kept[2].tls);
  EXPECT_EQ(kept[0].user, "reader");
  EXPECT_EQ(part<QComboBox>("pacsServers").currentText(), "Ward");
  click("pacsTest");
  EXPECT_TRUE(answers("The server answers"));
  EXPECT_TRUE(asked().contains("\"--dimse\", \"10.0.0.7:104\", \"--called\", \"ARCHIVE\""))
      << asked().toStdString();
}

TEST_F(Pacs, WithoutTheProgramTheMenuSaysSo) {
  ui::MainWindow other;
  const app::PacsController controller(other.messages(), other.menus());
  other.findChild<QAction*>("fromPacs")->trigger();
  EXPECT_TRUE(other.findChild<QLabel*>("message")->text().contains("palpate-fetch"));
}

TEST_F(Pacs, DaysAreTypedAsTheyAreRead) {
  QLocale::setDefault(QLocale("de_DE"));
  ui::PacsWindow window;
  auto* date = window.findChild<QLineEdit*>("pacsDate");
  EXPECT_EQ(date->placeholderText(), "01.03.2024 - 31.03.2024");
  for (const auto& [typed, sought] : {std::pair{"01.03.2024 - 31.03.2024", "20240301-20240331"},
                                      {"5.3.2024", "20240305"},
                                      {"2024-03-01-2024-03-31", "20240301-20240331"},
                                      {"- 2024-03-31", "-20240331"},
                                      {"20240301-", "20240301-"},
                                      {"", ""},
                                      {"no day", "no day"}}) {
    date->setText(typed);
    EXPECT_EQ(window.query().study_date, sought) << typed;
  }
}

}  // namespace
