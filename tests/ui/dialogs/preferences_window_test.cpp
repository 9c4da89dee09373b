// SPDX-License-Identifier: BSD-3-Clause
#include "ui/dialogs/preferences_window.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QTableWidget>
#include <QTest>
#include <QWheelEvent>

#include "app/application.h"
#include "app/window/sessions/session_recording.h"
#include "tests/ui/panelled_window.h"
#include "tests/ui/views/sphere_in_hand.h"
#include "tests/ui/window_support.h"
#include "ui/controls/number_box.h"
#include "ui/style/style.h"
#include "ui/views/slice_readout.h"
#include "ui/views/volume_view.h"
#include "ui/window/main_window.h"
#include "ui/window/menus.h"
#include "ui/window/views.h"

namespace {

using ui::PreferenceChoices;
using window::waitFor;

/// What a test may have changed is as at first when it ends.
struct Untouched {
  Untouched() { QSettings().clear(); }
  ~Untouched() {
    ui::setOwnKeys({});
    ui::setLengthUnit(ui::LengthUnit::Millimetres);
    ui::style::applyTheme(*qApp, ui::style::Theme::Dark);
    QSettings().clear();
  }
};

template <class Part>
Part& part(QWidget& window, const char* name) {
  auto* found = window.findChild<Part*>(name);
  if (found == nullptr) throw std::logic_error(name);
  return *found;
}

/// Chooses an entry as a user does.
void choose(QComboBox& box, int index) {
  box.setCurrentIndex(index);
  emit box.activated(index);
}

int rowOf(const QTableWidget& list, const QString& words, const QString& place) {
  for (int row = 0; row < list.rowCount(); ++row)
    if (list.item(row, 2)->text() == words && list.item(row, 1)->text() == place) return row;
  return -1;
}

int shownRows(const QTableWidget& list) {
  int shown = 0;
  for (int row = 0; row < list.rowCount(); ++row) shown += list.isRowHidden(row) ? 0 : 1;
  return shown;
}

TEST(PreferencesWindow, EveryChoiceIsToldAtOnceAndTheDefaultsComeBack) {
  const Untouched untouched;
  ui::PreferencesWindow window;
  QList<PreferenceChoices> told;
  QObject::connect(&window, &ui::PreferencesWindow::changed,
                   [&](const PreferenceChoices& choices) { told << choices; });
  window.show(PreferenceChoices{}, "/own");
  EXPECT_TRUE(told.isEmpty());
  choose(part<QComboBox>(window, "themeChoice"), 1);
  EXPECT_EQ(told.last().theme, ui::style::Theme::Light);
  choose(part<QComboBox>(window, "lengthChoice"), 1);
  EXPECT_EQ(told.last().lengths, ui::LengthUnit::Centimetres);
  part<QCheckBox>(window, "hintsChoice").click();
  EXPECT_FALSE(told.last().hints);
  choose(part<QComboBox>(window, "mouseChoice"), 1);
  choose(part<QComboBox>(window, "sliceWheelChoice"), 1);
  choose(part<QComboBox>(window, "zoomWheelChoice"), 1);
  EXPECT_EQ(told.last().mouse,
            (ui::MouseChoices{
                .at_first = ui::MouseMode::Hand, .slices_reversed = true, .zoom_reversed = true}));
  auto& stiffness = part<ui::NumberBox>(window, "stiffnessAtFirst");
  EXPECT_FALSE(stiffness.isEnabled());
  part<QCheckBox>(window, "stiffnessAlways").click();
  EXPECT_EQ(told.last().stiffness, 1000.0);
  stiffness.setValue(450.0);
  EXPECT_EQ(told.last().stiffness, 450.0);
  choose(part<QComboBox>(window, "servoRate"), 3);
  EXPECT_EQ(told.last().servo_rate, 4000);
  part<QCheckBox>(window, "placesChoice").click();
  EXPECT_FALSE(told.last().places_remembered);
  EXPECT_EQ(told.size(), 10);
  // what it is given is shown, and not told
  window.show(told.last(), "/own");
  EXPECT_EQ(told.size(), 10);
  part<QPushButton>(window, "resetPreferences").click();
  EXPECT_EQ(told.size(), 11);
  EXPECT_EQ(told.last(), PreferenceChoices{});
  EXPECT_EQ(part<QComboBox>(window, "themeChoice").currentIndex(), 0);
  EXPECT_FALSE(stiffness.isEnabled());
}

TEST(PreferencesWindow, TheListOfShortcutsIsSearchedAndItsKeysAreChangedByPressingThem) {
  const Untouched untouched;
  ui::PreferencesWindow window;
  QSignalSpy changed(&window, &ui::PreferencesWindow::keysChanged);
  window.show(PreferenceChoices{}, "/own");
  part<QListWidget>(window, "preferencePages").setCurrentRow(5);
  window::showAndWait(window, {720, 560});
  window.activateWindow();
  ASSERT_TRUE(waitFor([&] { return window.isActiveWindow(); }));
  auto& list = part<QTableWidget>(window, "shortcuts");
  auto& search = part<QLineEdit>(window, "shortcutSearch");
  auto& change = part<QPushButton>(window, "changeShortcut");
  auto& reset = part<QPushButton>(window, "resetShortcut");
  auto& said = part<QLabel>(window, "shortcutSaid");
  EXPECT_EQ(list.rowCount(), int(ui::bindings().size()));
  QTest::keyClicks(&search, "tool mouse");
  EXPECT_GT(shownRows(list), 0);
  EXPECT_LT(shownRows(list), 30);
  const int take = rowOf(list, "takes the tool with the mouse, or lets it go", "anywhere");
  ASSERT_GE(take, 0);
  EXPECT_FALSE(list.isRowHidden(take));
  // each of the words counts, the first and the last
  const int both = shownRows(list);
  QTest::keyClicks(&search, " takes");
  EXPECT_FALSE(list.isRowHidden(take));
  EXPECT_LT(shownRows(list), both);
  for (const char* const words : {"zzz tool mouse", "tool zzz mouse", "tool mouse zzz"}) {
    search.clear();
    QTest::keyClicks(&search, words);
    EXPECT_EQ(shownRows(list), 0) << words;
  }
  search.clear();
  EXPECT_EQ(shownRows(list), list.rowCount());

  // by keys alone: Enter on the line, then the key
  list.setCurrentCell(take, 0);
  list.setFocus();
  QTest::keyClick(&list, Qt::Key_Return);
  ASSERT_TRUE(change.isChecked() && change.hasFocus());
  QTest::keyClick(&change, Qt::Key_E);
  EXPECT_EQ(list.item(take, 0)->text(), "E");
  EXPECT_EQ(ui::keyOf(ui::Action::TakeTool), "E");
  EXPECT_EQ(changed.count(), 1);
  EXPECT_FALSE(change.isChecked());
  EXPECT_TRUE(said.text().contains("G")) << said.text().toStdString();
  window::keep(window::pictureOf(window), "preferences_shortcuts");
  // taken: it says by what, and nothing changes
  change.click();
  QTest::keyClick(&change, Qt::Key_K);
  EXPECT_EQ(list.item(take, 0)->text(), "E");
  EXPECT_TRUE(said.text().contains("brings the crosshair to the tool"));
  EXPECT_EQ(changed.count(), 1);
  // with modifiers, which are no key by themselves; Escape takes none and closes nothing
  change.click();
  QTest::keyClick(&change, Qt::Key_Control);
  EXPECT_TRUE(change.isChecked());
  QTest::keyClick(&change, Qt::Key_Escape);
  EXPECT_FALSE(change.isChecked());
  EXPECT_TRUE(window.isVisible());
  EXPECT_EQ(list.item(take, 0)->text(), "E");
  reset.click();
  EXPECT_EQ(list.item(take, 0)->text(), "G");
  EXPECT_FALSE(reset.isEnabled());

  // those that stay what they are
  for (const char* const words :
       {"force off", "force off; puts away the tool of an edit and a measure that is being placed",
        "plays and pauses"})
    for (int row = 0; row < list.rowCount(); ++row)
      if (list.item(row, 2)->text() == words) {
        list.setCurrentCell(row, 0);
        EXPECT_FALSE(change.isEnabled()) << words;
      }
  EXPECT_EQ(ui::changeKey("parallel", QKeyCombination(Qt::Key_U)), "");
  ASSERT_EQ(ui::ownKeys().size(), 1);
  part<QPushButton>(window, "resetShortcuts").click();
  EXPECT_TRUE(ui::ownKeys().isEmpty());
}

TEST(PreferencesWindow, IsOpenedByItsKeyAndAppliesAndKeepsWhatIsChosen) {
  const Untouched untouched;
  const QTemporaryDir folder;
  {
    app::Arguments arguments = window::sphereInHand("mouse");
    arguments.screenshot = {};  // with preferences, of nobody
    app::Application application(arguments);
    application.start();
    ui::MainWindow& main = application.window();
    ASSERT_TRUE(waitFor([&] { return application.snapshot().scene != 0; }));
    main.activateWindow();
    ASSERT_TRUE(waitFor([&] { return main.isActiveWindow(); }));
    QTest::keyClick(&main, Qt::Key_Comma, Qt::ControlModifier);
    auto* window = main.findChild<ui::PreferencesWindow*>();
    ASSERT_NE(window, nullptr);
    EXPECT_TRUE(window->isVisible());
    PreferenceChoices wanted{.theme = ui::style::Theme::Light,
                             .hints = false,
                             .lengths = ui::LengthUnit::Centimetres,
                             .mouse = {.at_first = ui::MouseMode::Hand, .slices_reversed = true},
                             .stiffness = 320.0,
                             .servo_rate = 4000,
                             .recordings = folder.path(),
                             .places_remembered = false};
    emit window->changed(wanted);
    EXPECT_EQ(ui::style::theme(), ui::style::Theme::Light);
    EXPECT_FALSE(main.menus().hintsShown());
    EXPECT_EQ(main.views().volume().mouseMode(), ui::MouseMode::Hand);
    EXPECT_EQ(part<QDoubleSpinBox>(main, "stiffnessTyped").value(), 320.0);
    EXPECT_TRUE(main.views().slice(ui::Plane::Axial).readout().place.endsWith(" cm"))
        << main.views().slice(ui::Plane::Axial).readout().place.toStdString();
    // a folder that cannot be written to is refused with a sentence, and the old one stays
    wanted.recordings = "/proc/self";
    emit window->changed(wanted);
    auto& refusal = part<QLabel>(*window, "recordingsRefusal");
    EXPECT_TRUE(refusal.text().contains("/proc/self"));
    EXPECT_EQ(part<QLabel>(*window, "recordingsFolder").text(), folder.path());
    EXPECT_EQ(ui::changeKey("take_tool", QKeyCombination(Qt::Key_E)), "");
    emit window->keysChanged();
    // where the next recording goes
    part<QPushButton>(main, "record").click();
    ASSERT_TRUE(waitFor([&] { return application.recording().isRecording(); }));
    EXPECT_EQ(application.recording().present().parent_path(), folder.path().toStdString());
    part<QPushButton>(main, "record").click();
    ASSERT_TRUE(waitFor([&] { return !application.recording().isRecording(); }));
    application.end();
  }
  const app::Preferences kept = app::loadPreferences();
  EXPECT_EQ(kept.theme, "light");
  EXPECT_FALSE(kept.hints || kept.places_remembered);
  EXPECT_EQ(kept.lengths, ui::LengthUnit::Centimetres);
  EXPECT_EQ(kept.mouse,
            (ui::MouseChoices{.at_first = ui::MouseMode::Hand, .slices_reversed = true}));
  EXPECT_EQ(kept.stiffness_always, 320.0);
  EXPECT_EQ(kept.servo_rate, 4000);
  EXPECT_EQ(kept.recordings, folder.path());
  EXPECT_EQ(kept.keys, (ui::OwnKeys{{"take_tool", "E"}}));
  // the next start begins with them
  ui::setOwnKeys({});
  ui::setLengthUnit(ui::LengthUnit::Millimetres);
  ui::style::applyTheme(*qApp, ui::style::Theme::Dark);
  app::Arguments arguments = window::sphereInHand("mouse");
  arguments.screenshot = {};
  app::Application application(arguments);
  application.start();
  EXPECT_EQ(ui::keyOf(ui::Action::TakeTool), "E");
  EXPECT_EQ(ui::lengthUnit(), ui::LengthUnit::Centimetres);
  EXPECT_EQ(ui::style::theme(), ui::style::Theme::Light);
  EXPECT_FALSE(application.window().menus().hintsShown());
  EXPECT_EQ(part<QDoubleSpinBox>(application.window(), "stiffnessTyped").value(), 320.0);
  ASSERT_TRUE(waitFor([&] { return application.snapshot().scene != 0; }));
  EXPECT_TRUE(waitFor(
      [&] { return application.window().views().volume().mouseMode() == ui::MouseMode::Hand; }));
  part<QPushButton>(application.window(), "record").click();
  ASSERT_TRUE(waitFor([&] { return application.recording().isRecording(); }));
  EXPECT_EQ(application.recording().present().parent_path(), folder.path().toStdString());
  application.end();
}

TEST(PreferencesWindow, TheWheelTurnsTheWayThatWasChosen) {
  ui::SliceView slice(ui::Plane::Axial);
  const auto volume = window::volumeOf(window::cubeGrid(20), haptics::ScalarType::Int16,
                                       window::ball({0, 0, 0}, 0.006));
  slice.show(ui::pictureOf(volume));
  window::showAndWait(slice, {300, 300});
  QList<double> moved;
  QObject::connect(&slice, &ui::SliceView::crossMoved,
                   [&](const Eigen::Vector3d& p) { moved << p.z(); });
  const auto turn = [&](Qt::KeyboardModifiers held) {
    QWheelEvent wheel({150, 150}, slice.mapToGlobal(QPointF{150, 150}), {}, {0, 120}, {}, held,
                      Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(&slice, &wheel);
  };
  turn({});
  ASSERT_EQ(moved.size(), 1);
  slice.setMouse({.slices_reversed = true, .zoom_reversed = true});
  turn({});
  ASSERT_EQ(moved.size(), 2);
  EXPECT_LT(moved[0] * moved[1], 0.0);
  const double before = slice.mmPerPixel();
  turn(Qt::ControlModifier);
  EXPECT_GT(slice.mmPerPixel(), before);
  slice.setMouse({});
  turn(Qt::ControlModifier);
  EXPECT_NEAR(slice.mmPerPixel(), before, 1e-9);
}

}  // namespace
