// SPDX-License-Identifier: BSD-3-Clause
// What the keyboard and a screen reader find in the window.
#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QAccessible>
#include <QApplication>
#include <QButtonGroup>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QOpenGLWidget>
#include <QScrollBar>
#include <QSlider>
#include <QTest>
#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "app/application.h"
#include "tests/ui/panelled_window.h"
#include "tests/ui/views/sphere_in_hand.h"
#include "tests/ui/window_support.h"
#include "ui/controls/bindings.h"
#include "ui/controls/section.h"
#include "ui/controls/spoken.h"
#include "ui/controls/state_chip.h"
#include "ui/dialogs/export_question.h"
#include "ui/dialogs/preferences_window.h"
#include "ui/dialogs/series_browser.h"
#include "ui/panels/force_panel.h"
#include "ui/panels/histogram_slider.h"
#include "ui/panels/isosurface_panel.h"
#include "ui/panels/replay_bar.h"
#include "ui/style/style.h"
#include "ui/views/volume_view.h"
#include "ui/window/banner.h"
#include "ui/window/main_window.h"
#include "ui/window/menus.h"
#include "ui/window/messages.h"
#include "ui/window/views.h"

namespace {

using window::waitFor;

QAccessibleInterface& spokenOf(QWidget& widget) {
  auto* found = QAccessible::queryAccessibleInterface(&widget);
  if (found == nullptr) throw std::logic_error("nothing is said of a widget");
  return *found;
}

/// What a user presses, types into or chooses from; not what such a control is made of.
bool isControl(const QWidget& widget) {
  const QWidget* parent = widget.parentWidget();
  if (qobject_cast<const QAbstractSpinBox*>(parent) || qobject_cast<const QComboBox*>(parent) ||
      qobject_cast<const QLineEdit*>(parent) || qobject_cast<const QScrollBar*>(&widget) ||
      widget.objectName().startsWith("qt_") || widget.inherits("QHeaderView") ||
      widget.inherits("QMenuBar") || widget.inherits("QTableCornerButton"))
    return false;
  // a table's own button in its corner
  if (qobject_cast<const QAbstractItemView*>(parent) && parent->inherits("QTableView") &&
      qobject_cast<const QAbstractButton*>(&widget))
    return false;
  return qobject_cast<const QAbstractButton*>(&widget) ||
         qobject_cast<const QAbstractSpinBox*>(&widget) ||
         qobject_cast<const QComboBox*>(&widget) || qobject_cast<const QAbstractSlider*>(&widget) ||
         qobject_cast<const QLineEdit*>(&widget) ||
         qobject_cast<const QAbstractItemView*>(&widget) ||
         (widget.focusPolicy() & Qt::TabFocus) != 0;
}

std::string nameFor(const QWidget& widget) {
  std::string name =
      std::string(widget.metaObject()->className()) + " " + widget.objectName().toStdString();
  for (const QWidget* up = widget.parentWidget(); up != nullptr; up = up->parentWidget())
    if (!up->objectName().isEmpty()) return name + " in " + up->objectName().toStdString();
  return name;
}

/// The visible controls of a window that are not in another.
std::vector<QWidget*> controlsOf(QWidget& window) {
  std::vector<QWidget*> controls;
  for (QWidget* widget : window.findChildren<QWidget*>())
    if (widget->isVisible() && widget->window() == &window && isControl(*widget))
      controls.push_back(widget);
  return controls;
}

bool isReached(const QWidget& widget) {
  return widget.isEnabled() && (widget.focusPolicy() & Qt::TabFocus) != 0 &&
         widget.focusProxy() == nullptr;
}

void expectSaid(QWidget& window, const char* where) {
  int seen = 0;
  for (QWidget* control : controlsOf(window)) {
    ++seen;
    const std::string what = std::string(where) + ": " + nameFor(*control);
    const QAccessibleInterface& said = spokenOf(*control);
    EXPECT_FALSE(said.text(QAccessible::Name).trimmed().isEmpty()) << what;
    // under X its name is what is chosen, and its label says what for
    if (qobject_cast<QComboBox*>(control)) {
      EXPECT_FALSE(said.relations(QAccessible::Label).isEmpty()) << what;
    }
    EXPECT_NE(said.role(), QAccessible::Client) << what;
    EXPECT_NE(said.role(), QAccessible::NoRole) << what;
    // over a view a tooltip would stand before what is looked at: its hint says what can be done
    const bool view = said.role() == QAccessible::Canvas;
    if (!view) {
      EXPECT_FALSE(control->toolTip().isEmpty()) << what;
    }
  }
  EXPECT_GT(seen, 3) << where;
}

/// The whole program with all sections open, in one tab after the other.
class WholeWindow {
 public:
  explicit WholeWindow(const char* hand = "mouse") : application(window::sphereInHand(hand)) {
    application.start();
    if (!waitFor([&] { return application.snapshot().scene != 0; }))
      throw std::runtime_error("nothing was loaded");
    window().resize(1280, 860);
    for (ui::Section* section : window().findChildren<ui::Section*>()) section->setFolded(false);
  }
  ui::MainWindow& window() { return application.window(); }
  void activate() {
    window().activateWindow();
    EXPECT_TRUE(waitFor([&] { return window().isActiveWindow(); }));
  }
  template <class Check>
  void inEachTab(const Check& check) {
    for (const char* tab : {"scanTab", "touchTab", "deviceTab", "recordTab"}) {
      QTest::mouseClick(window().findChild<QAbstractButton*>(tab), Qt::LeftButton);
      QTest::qWait(50);
      check(tab);
    }
  }

  app::Application application;
};

TEST(Access, EveryControlHasARoleANameAndATooltip) {
  WholeWindow whole;
  whole.window().replayBar().show(ui::ReplayTrack{.begin = 0.0, .end = 4.0});
  whole.window().messages().showMessage("A message.");
  whole.window().messages().showFault("A fault.");
  whole.inEachTab([&](const char* tab) { expectSaid(whole.window(), tab); });
  // the tools of an edit have pages of their own
  QTest::mouseClick(whole.window().findChild<QAbstractButton*>("scanTab"), Qt::LeftButton);
  for (const char* tool : {"cropTool", "planeTool", "piecesTool", "holderTool", "scalpelTool"}) {
    auto* button = whole.window().findChild<QAbstractButton*>(tool);
    ASSERT_NE(button, nullptr) << tool;
    button->click();
    QTest::qWait(20);
    expectSaid(whole.window(), tool);
  }
}

TEST(Access, TheOtherWindowsSayTheirControls) {
  ui::PreferencesWindow preferences;
  preferences.show(ui::PreferenceChoices{}, "/own");
  window::showAndWait(preferences, {800, 540});
  for (int page = 0; page < 6; ++page) {
    preferences.findChild<QListWidget*>("preferencePages")->setCurrentRow(page);
    QTest::qWait(10);
    expectSaid(preferences, "preferences");
    window::keep(window::pictureOf(preferences), ("preferences_" + std::to_string(page)).c_str());
  }
  ui::SeriesRow row;
  row.study = "1";
  ui::SeriesBrowser series("a folder", {row});
  window::showAndWait(series, {900, 500});
  expectSaid(series, "series");
  ui::ExportDialog question(0.0, 2.0, window::exportFormats());
  window::showAndWait(question, question.sizeHint());
  expectSaid(question, "export");
}

TEST(Access, TooltipsEndWithTheKey) {
  WholeWindow whole;
  const std::pair<const char*, ui::Action> buttons[] = {
      {"openFolderButton", ui::Action::OpenFolder},
      {"undoButton", ui::Action::Undo},
      {"redoButton", ui::Action::Redo},
      {"undoEdit", ui::Action::Undo},
      {"redoEdit", ui::Action::Redo},
      {"takeToolButton", ui::Action::TakeTool},
      {"savePictureButton", ui::Action::SavePicture},
      {"placeDistanceButton", ui::Action::PlaceDistance},
      {"placeAngleButton", ui::Action::PlaceAngle},
      {"placePointButton", ui::Action::PlacePoint},
      {"placeNoteButton", ui::Action::PlaceNote},
      {"maximise", ui::Action::ViewAlone},
      {"viewMenu", ui::Action::SliceMenu},
      {"mark", ui::Action::SetMark},
      {"goToMark", ui::Action::GoToMark},
      {"renameMark", ui::Action::RenameMark},
      {"replayBack", ui::Action::TickBack},
      {"replayForward", ui::Action::TickForward},
      {"replayPlay", ui::Action::PlayPause}};
  const auto check = [&] {
    for (const auto& [name, action] : buttons) {
      const auto found = whole.window().findChildren<QAbstractButton*>(name);
      EXPECT_FALSE(found.isEmpty()) << name;
      for (const QAbstractButton* button : found)
        EXPECT_TRUE(button->toolTip().contains(ui::keyOf(action)))
            << name << ": " << button->toolTip().toStdString();
    }
  };
  check();
  ui::setOwnKeys({{"open_file", "F7"}, {"take_tool", "F8"}, {"tick_back", "F9"}, {"undo", "F10"}});
  check();
  ui::setOwnKeys({});
  EXPECT_TRUE(whole.window().findChild<QWidget*>("forceOff")->toolTip().contains("Escape"));
}

TEST(Access, TabReachesEveryControlFromLeftToRightAndDown) {
  WholeWindow whole;
  whole.activate();
  whole.inEachTab([&](const char* tab) {
    std::set<QWidget*> wanted;
    for (QWidget* control : controlsOf(whole.window())) {
      if (isReached(*control)) wanted.insert(control);
      // none that the keyboard cannot come to; of a group the arrow keys reach the others
      const auto* button = qobject_cast<const QAbstractButton*>(control);
      const bool grouped = button != nullptr && button->group() != nullptr;
      EXPECT_TRUE(!control->isEnabled() || isReached(*control) || grouped ||
                  control->focusProxy() != nullptr)
          << tab << ": " << nameFor(*control);
    }
    EXPECT_GT(wanted.size(), 20U) << tab;
    std::vector<QWidget*> reached;
    whole.window().views().volume().setFocus();
    for (std::size_t n = 0; n < 2 * wanted.size() + 20; ++n) {
      QWidget* focus = QApplication::focusWidget();
      ASSERT_NE(focus, nullptr) << tab;
      if (!reached.empty() && focus == reached.front()) break;
      reached.push_back(focus);
      // a view takes its keys itself; what Qt does with Tab is asked for directly
      QKeyEvent press(QEvent::KeyPress, Qt::Key_Tab, Qt::NoModifier);
      QCoreApplication::sendEvent(focus, &press);
    }
    const auto isOneOf = [&](const QWidget* control) {
      return std::ranges::find(reached, control) != reached.end();
    };
    std::string order;
    for (const QWidget* one : reached) order += "\n  " + nameFor(*one);
    for (QWidget* control : wanted) {
      // of buttons of one group Tab reaches one, and the arrow keys the others
      const auto* button = qobject_cast<const QAbstractButton*>(control);
      const QButtonGroup* group = button != nullptr ? button->group() : nullptr;
      const bool found =
          group == nullptr ? isOneOf(control) : std::ranges::any_of(group->buttons(), isOneOf);
      EXPECT_TRUE(found) << tab << " does not reach " << nameFor(*control) << order;
    }
    // bar, tabs, panels, views, status bar
    const auto at = [&](const QWidget* part) { return std::ranges::find(reached, part); };
    const auto* stop = whole.window().findChild<QWidget*>("forceOff");
    const auto* open = whole.window().findChild<QWidget*>("openFolderButton");
    const auto* details = whole.window().findChild<QWidget*>("details");
    EXPECT_LT(at(open), at(stop)) << tab << order;
    EXPECT_LT(at(stop), at(whole.window().findChild<QWidget*>(tab))) << tab << order;
    EXPECT_LT(at(&whole.window().views().volume()), at(details)) << tab << order;
    // within a section, row by row
    const auto sectionOf = [](QWidget* widget) {
      QWidget* up = widget;
      while (up != nullptr && qobject_cast<ui::Section*>(up) == nullptr) up = up->parentWidget();
      return up;
    };
    for (std::size_t n = 1; n < reached.size(); ++n) {
      QWidget* section = sectionOf(reached[n]);
      if (section == nullptr || section != sectionOf(reached[n - 1])) continue;
      const auto placeOf = [&](QWidget* widget) {
        return QRect(widget->mapTo(section, QPoint{}), widget->size());
      };
      const QRect before = placeOf(reached[n - 1]), after = placeOf(reached[n]);
      const bool same_row =
          after.top() <= before.center().y() && before.top() <= after.center().y();
      EXPECT_TRUE(same_row ? after.left() > before.left() : after.top() > before.top())
          << tab << ": " << nameFor(*reached[n]) << " comes after " << nameFor(*reached[n - 1]);
    }
  });
}

/// How many pixels of a control the focus changes.
int changedByFocus(QWidget& control, QWidget& elsewhere) {
  const auto picture = [&] {
    auto* view = qobject_cast<QOpenGLWidget*>(&control);
    return view != nullptr ? view->grabFramebuffer() : control.grab().toImage();
  };
  elsewhere.setFocus(Qt::TabFocusReason);
  const QImage without = picture();
  control.setFocus(Qt::TabFocusReason);
  const QImage with = picture();
  int changed = 0;
  for (int y = 0; y < with.height(); ++y)
    for (int x = 0; x < with.width(); ++x) changed += with.pixel(x, y) != without.pixel(x, y);
  return changed;
}

TEST(Access, TheFocusIsSeenOnEveryControlInEveryTheme) {
  WholeWindow whole;
  whole.activate();
  for (const auto theme :
       {ui::style::Theme::Dark, ui::style::Theme::Light, ui::style::Theme::HighContrast}) {
    whole.window().menus().setTheme(theme);
    whole.inEachTab([&](const char* tab) {
      auto* elsewhere = whole.window().findChild<QWidget*>("forceOff");
      auto* other = whole.window().findChild<QWidget*>("deviceTab");
      int seen = 0;
      for (QWidget* control : controlsOf(whole.window())) {
        if (!isReached(*control)) continue;
        ++seen;
        if (control == &whole.window().views().volume())
          window::keep(control->grab().toImage(), "access_view");
        EXPECT_GE(changedByFocus(*control, control == elsewhere ? *other : *elsewhere), 16)
            << ui::style::nameOf(theme).toStdString() << ", " << tab << ": " << nameFor(*control);
      }
      EXPECT_GT(seen, 20) << tab;
    });
  }
  whole.window().menus().setTheme(ui::style::Theme::Dark);
}

TEST(Access, SlidersSayAndTakeTheirValueInItsUnit) {
  window::Panelled w;
  const auto volume = window::volumeOf(window::cubeGrid(24), haptics::ScalarType::Int16,
                                       window::ball({0, 0, 0}, 0.008), {.unit = "HU"});
  w.show(ui::pictureOf(volume), 50.0, "Ball");
  auto& slider = window::panelOf<ui::HistogramSlider>(w.window);
  QAccessibleInterface& said = spokenOf(slider);
  EXPECT_EQ(said.role(), QAccessible::Slider);
  EXPECT_EQ(said.text(QAccessible::Name), "Isovalue in HU");
  EXPECT_EQ(said.text(QAccessible::Value), "50 HU");
  QAccessibleValueInterface* value = said.valueInterface();
  ASSERT_NE(value, nullptr);
  EXPECT_EQ(value->currentValue().toDouble(), 50.0);
  EXPECT_EQ(value->minimumValue().toDouble(), volume->least);
  EXPECT_EQ(value->maximumValue().toDouble(), volume->greatest);
  // between two of the slider's steps, too
  value->setCurrentValue(33.0);
  EXPECT_EQ(value->currentValue().toDouble(), 33.0);
  EXPECT_EQ(w.window.findChild<QDoubleSpinBox*>("isovalueTyped")->value(), 33.0);
  EXPECT_EQ(said.text(QAccessible::Value), "33 HU");
  EXPECT_EQ(w.shared.settings.isovalue, 33.0);
  EXPECT_TRUE(
      spokenOf(w.window.views().volume()).text(QAccessible::Name).contains("surface at 33 HU"));
  // what cannot be is refused as when it is typed
  value->setCurrentValue(1e6);
  EXPECT_EQ(value->currentValue().toDouble(), volume->greatest);

  auto* stiffness = w.window.findChild<QSlider*>("stiffness");
  QAccessibleInterface& stiff = spokenOf(*stiffness);
  EXPECT_EQ(stiff.text(QAccessible::Name), "Stiffness in N/m");
  EXPECT_EQ(stiff.valueInterface()->currentValue().toDouble(), 1000.0);
  stiff.valueInterface()->setCurrentValue(640.0);
  EXPECT_EQ(w.shared.settings.stiffness, 640.0);
  EXPECT_EQ(stiff.text(QAccessible::Value), "640 N/m");

  ui::ReplayBar replay;
  replay.show(ui::ReplayTrack{.begin = 0.0, .end = 4.0});
  replay.setTime(1.5);
  QAccessibleInterface& line = spokenOf(*replay.findChild<QWidget*>("replayTimeline"));
  EXPECT_EQ(line.role(), QAccessible::Slider);
  EXPECT_EQ(line.valueInterface()->currentValue().toDouble(), 1.5);
  double wanted = 0.0;
  QObject::connect(&replay, &ui::ReplayBar::timeWanted, [&](double time) { wanted = time; });
  line.valueInterface()->setCurrentValue(2.5);
  EXPECT_EQ(wanted, 2.5);
}

/// Names of whom screen readers were told that they have changed, in order.
QStringList& told() {
  static QStringList names;
  return names;
}
/// Notes what is said while it lives.
struct Listening {
  Listening() {
    told().clear();
    ui::listenToSpoken([](const QString& name) { told() << name; });
  }
  ~Listening() { ui::listenToSpoken({}); }
};

TEST(Access, EachStateOfTheForceIsSaidOnce) {
  const Listening listening;
  ui::StateChip chip;
  chip.setAccessibleName("State of the force");
  told().clear();
  chip.show(ui::Mark::On, "Force on");
  chip.show(ui::Mark::On, "Force on");
  EXPECT_EQ(told(), QStringList{"State of the force: Force on"});
  chip.show(ui::Mark::Ready, "Force off");
  EXPECT_EQ(told().size(), 2);
  EXPECT_EQ(told().last(), "State of the force: Force off");
  // a recording's time runs on unsaid
  told().clear();
  for (int s = 0; s < 5; ++s) chip.show(ui::Mark::Recording, QString("REC 0:0%1").arg(s));
  EXPECT_EQ(told().size(), 1);

  ui::Banner banner(ui::Banner::Kind::Stopped, "stopped");
  told().clear();
  banner.setSentence("Force stopped by Escape");
  EXPECT_TRUE(told().isEmpty());  // it is not to be seen yet
  banner.show();
  EXPECT_EQ(told(), QStringList{"Force stopped by Escape"});
  EXPECT_EQ(spokenOf(banner).role(), QAccessible::AlertMessage);
}

TEST(Access, TheForceIsSaidWhereItBeginsAndByHalfANewtonOnceASecond) {
  const Listening listening;
  ui::ForcePanel card;
  haptics::Snapshot snapshot;
  snapshot.force_state = haptics::ForceState::On;
  const auto at = [&](double time, double newton) {
    told().clear();
    snapshot.time = time;
    snapshot.felt_W.force = {newton, 0.0, 0.0};
    card.display(snapshot);
    return told().filter("Force");
  };
  EXPECT_TRUE(at(1.0, 0.0).isEmpty());
  EXPECT_EQ(at(2.0, 0.2), QStringList{"Force: 0.20 N"});
  EXPECT_TRUE(at(4.0, 0.5).isEmpty());
  EXPECT_EQ(at(5.0, 0.8), QStringList{"Force: 0.80 N"});
  EXPECT_TRUE(at(5.5, 3.0).isEmpty());  // within a second
  EXPECT_EQ(at(6.1, 3.0), QStringList{"Force: 3.00 N"});
  EXPECT_EQ(at(7.2, 0.0), QStringList{"Force: 0.00 N"});
  EXPECT_EQ(at(0.1, 1.0), QStringList{"Force: 1.00 N"});  // another hand counts anew
  // and a touch where it begins and ends, not how many places it has
  const auto touching = [&](double time, int contacts) {
    told().clear();
    snapshot.time = time;
    snapshot.contacts = contacts;
    card.display(snapshot);
    return told().filter("Touch");
  };
  EXPECT_EQ(touching(3.0, 2), QStringList{"Touch: Touching"});
  EXPECT_TRUE(touching(5.0, 3).isEmpty());
  EXPECT_EQ(touching(7.0, 0), QStringList{"Touch: Nothing is touched"});
}

TEST(Access, ViewsSayWhatTheyShow) {
  window::Panelled w;
  const auto said = [&] { return spokenOf(w.window.views().volume()).text(QAccessible::Name); };
  EXPECT_EQ(said(), "3-D view: nothing is open");
  const auto volume = window::volumeOf(window::cubeGrid(24), haptics::ScalarType::Int16,
                                       window::ball({0, 0, 0}, 0.008), {.unit = "HU"});
  w.show(ui::pictureOf(volume), 50.0, "Ball");
  EXPECT_EQ(said(), "3-D view: surface at 50 HU");
  w.window.views().setIsovalue(-12.5);
  EXPECT_EQ(said(), "3-D view: surface at -12.5 HU");
  window::showAndWait(w.window, {1000, 760});
  ui::SliceView& axial = w.window.views().slice(ui::Plane::Axial);
  const QString first = spokenOf(axial).text(QAccessible::Name);
  EXPECT_TRUE(first.startsWith("Axial slice: ") && first.contains("/ 24")) << first.toStdString();
  w.window.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&w.window, 120'000));
  axial.setFocus();
  const Listening listening;
  QTest::keyClick(&axial, Qt::Key_Up);
  EXPECT_EQ(told().filter("Axial slice").size(), 1) << told().join('\n').toStdString();
  EXPECT_NE(told().filter("Axial slice").value(0), first);
  // where all slices change, one of them is said: that which has the focus
  told().clear();
  w.window.views().setCross({5.5, -4.5, 3.5});
  EXPECT_EQ(told().filter("Axial slice").size(), 1) << told().join('\n').toStdString();
  EXPECT_EQ(told().filter(" slice").size(), 1) << told().join('\n').toStdString();
}

}  // namespace
