// SPDX-License-Identifier: BSD-3-Clause
#include "ui/controls/bindings.h"

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QKeyEvent>
#include <QMainWindow>
#include <QSignalSpy>
#include <QTest>
#include <QTextBrowser>
#include <QTimer>
#include <algorithm>
#include <vector>

#include "tests/ui/window_support.h"
#include "ui/views/volume_view.h"
#include "ui/window/main_window.h"
#include "ui/window/views.h"

namespace {

using ui::Action;
using ui::Binding;
using ui::Gesture;
using ui::MouseMode;
using ui::Where;

TEST(Bindings, DoNotMeanTwoThingsAtOnce) {
  EXPECT_TRUE(ui::conflictsIn(ui::bindings()).isEmpty())
      << ui::conflictsIn(ui::bindings()).join("\n").toStdString();
  const auto with = [](const Binding& planted) {
    std::vector<Binding> all(ui::bindings().begin(), ui::bindings().end());
    all.push_back(planted);
    return ui::conflictsIn(all).size();
  };
  // a key of the window that the view has already, one in both modes, one held
  EXPECT_EQ(with({.place = Where::Anywhere, .key = Qt::Key_P, .words = "planted"}), 1);
  EXPECT_EQ(with({.place = Where::Space,
                  .mode = MouseMode::Hand,
                  .gesture = Gesture::Drag,
                  .key = Qt::MiddleButton,
                  .words = "planted"}),
            1);
  EXPECT_EQ(with({.place = Where::Space, .key = Qt::Key_C, .words = "planted"}), 1);
  // a view's own key that all views have
  EXPECT_EQ(with({.place = Where::Slice, .key = Qt::Key_D, .words = "planted"}), 1);
  EXPECT_EQ(with({.place = Where::Slice, .key = Qt::Key_P, .words = "not in conflict"}), 0);
}

TEST(Bindings, LeaveXToTheCutting) {
  for (const Binding& binding : ui::bindings())
    EXPECT_FALSE(binding.gesture == Gesture::Key && binding.key == Qt::Key_X);
}

TEST(Bindings, GiveTheToolBeforeThePictureAndTheModeBeforeNothing) {
  const auto drag = [](MouseMode mode, Qt::MouseButton button, Qt::KeyboardModifiers modifiers,
                       bool on_tool) {
    return ui::actionOf(Where::Space, mode, Gesture::Drag, button, modifiers, on_tool);
  };
  EXPECT_EQ(drag(MouseMode::Look, Qt::LeftButton, {}, false), Action::Rotate);
  EXPECT_EQ(drag(MouseMode::Look, Qt::LeftButton, {}, true), Action::MoveTool);
  EXPECT_EQ(drag(MouseMode::Look, Qt::LeftButton, Qt::ShiftModifier, true), Action::TurnTool);
  EXPECT_EQ(drag(MouseMode::Look, Qt::LeftButton, Qt::ShiftModifier, false), Action::Rotate);
  EXPECT_EQ(drag(MouseMode::Look, Qt::RightButton, {}, false), Action::Zoom);
  EXPECT_EQ(drag(MouseMode::Look, Qt::MiddleButton, {}, false), Action::Pan);
  EXPECT_EQ(drag(MouseMode::Hand, Qt::LeftButton, {}, false), Action::MoveTool);
  EXPECT_EQ(drag(MouseMode::Hand, Qt::RightButton, {}, false), Action::Rotate);
  EXPECT_EQ(ui::actionOf(Where::Space, MouseMode::Look, Gesture::Key, Qt::Key_S,
                         Qt::ControlModifier | Qt::ShiftModifier),
            std::nullopt);  // a key is not the same without its modifiers
}

TEST(Bindings, AreAllInTheListOfControls) {
  const QString shown = ui::controlsText();
  for (const ui::ControlRow& row : ui::controlRows())
    for (const QString& part : {row.triggers, row.place, row.words})
      EXPECT_TRUE(shown.contains(part)) << part.toStdString();
}

TEST(Bindings, HoldEveryShortcutOfTheMenus) {
  ui::MainWindow window;
  int found = 0;
  for (const QAction* action : window.findChildren<QAction*>()) {
    for (const QKeySequence& shortcut : action->shortcuts()) {
      if (shortcut.isEmpty()) continue;
      ++found;
      // a letter belongs to the views alone: in a field it is a letter
      const bool of_views = action->shortcutContext() == Qt::WidgetShortcut ||
                            action->shortcutContext() == Qt::WidgetWithChildrenShortcut;
      EXPECT_TRUE(std::ranges::any_of(ui::bindings(), [&](const Binding& binding) {
        return binding.place == (of_views ? Where::View : Where::Anywhere) &&
               QKeySequence(int(binding.modifiers) | binding.key) == shortcut;
      })) << shortcut.toString().toStdString();
    }
    // the key that an entry shows is one that the view knows
    const QString shown = action->text().section('\t', 1);
    if (shown.isEmpty()) continue;
    ++found;
    EXPECT_TRUE(std::ranges::any_of(ui::bindings(), [&](const Binding& binding) {
      return binding.gesture == Gesture::Key && ui::triggerOf(binding) == shown;
    })) << shown.toStdString();
  }
  EXPECT_GT(found, 15);
}

/// The keys are those at first again when a test ends.
struct KeysAtFirst {
  ~KeysAtFirst() { ui::setOwnKeys({}); }
};

QKeyCombination key(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
  return QKeyCombination(modifiers, key);
}

TEST(Bindings, EveryKeyButEscapeAndSpaceHasANameOfItsOwn) {
  QStringList names;
  for (const Binding& binding : ui::bindings()) {
    if (binding.gesture != Gesture::Key && binding.gesture != Gesture::HeldKey) continue;
    const bool fixed = binding.key == Qt::Key_Escape || binding.key == Qt::Key_Space;
    EXPECT_EQ(QByteArray(binding.name).isEmpty(), fixed) << binding.words;
    if (!fixed) names << binding.name;
  }
  EXPECT_GT(names.size(), 80);
  EXPECT_EQ(names.removeDuplicates(), 0);
}

TEST(Bindings, AnotherKeyIsTakenByViewsMenusTooltipsAndHelp) {
  const KeysAtFirst at_first;
  ui::MainWindow window;
  window::showAndWait(window, {1000, 700});
  QSignalSpy to_cross(&window.views().slice(ui::Plane::Axial), &ui::SliceView::toolToCrossWanted);
  QSignalSpy hints(&window.views().volume(), &ui::VolumeView::hintChanged);
  auto* take = window.findChild<QAction*>("takeTool");
  auto* picture = window.findChild<QAction*>("savePicture");
  EXPECT_EQ(take->shortcut(), QKeySequence(Qt::Key_G));
  EXPECT_EQ(ui::changeKey("take_tool", key(Qt::Key_E)), "");
  EXPECT_EQ(ui::changeKey("save_picture", key(Qt::Key_F9)), "");
  EXPECT_EQ(ui::changeKey("slice_tool_to_cross", key(Qt::Key_Y, Qt::ShiftModifier)), "");
  EXPECT_EQ(take->shortcut(), QKeySequence(Qt::Key_E));
  EXPECT_TRUE(take->toolTip().contains("(E)")) << take->toolTip().toStdString();
  EXPECT_EQ(picture->shortcut(), QKeySequence(Qt::Key_F9));
  EXPECT_TRUE(picture->toolTip().contains("(F9)"));
  EXPECT_TRUE(window.findChild<QAbstractButton*>("savePictureButton")->toolTip().contains("(F9)"));
  EXPECT_GT(hints.count(), 0);
  EXPECT_TRUE(ui::controlsText().contains("<b>F9</b>"));
  // the view knows the new key, and the old one no longer
  ui::VolumeView& view = window.views().volume();
  view.setMouseHand(true);
  EXPECT_TRUE(view.hint().contains("take it with E")) << view.hint().toStdString();
  QApplication::setActiveWindow(&window);
  QTest::keyClick(&view, Qt::Key_G);
  EXPECT_EQ(view.mouseMode(), MouseMode::Look);
  QTest::keyClick(&view, Qt::Key_E);
  EXPECT_EQ(view.mouseMode(), MouseMode::Hand);
  QTest::keyClick(&window.views().slice(ui::Plane::Axial), Qt::Key_J);
  EXPECT_EQ(to_cross.count(), 0);
  QTest::keyClick(&window.views().slice(ui::Plane::Axial), Qt::Key_Y, Qt::ShiftModifier);
  EXPECT_EQ(to_cross.count(), 1);
  EXPECT_EQ(ui::ownKeys(),
            (ui::OwnKeys{
                {"take_tool", "E"}, {"save_picture", "F9"}, {"slice_tool_to_cross", "Shift+Y"}}));
  ui::setOwnKeys({});
  EXPECT_EQ(take->shortcut(), QKeySequence(Qt::Key_G));
  EXPECT_EQ(picture->shortcut(), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_S));
}

TEST(Bindings, ArrowKeysThatBecameLettersGoWhereTheyWent) {
  const KeysAtFirst at_first;
  EXPECT_EQ(ui::changeKey("turn_left", key(Qt::Key_U)), "");
  const QKeyEvent pressed(QEvent::KeyPress, Qt::Key_U, Qt::NoModifier);
  const Binding* meaning = ui::meaningOf(Where::Space, pressed);
  ASSERT_NE(meaning, nullptr);
  EXPECT_EQ(meaning->action, Action::Rotate);
  EXPECT_EQ(ui::wayOf(*meaning), QPoint(-1, 0));
  // a key of a held one is one alone, and is found so
  EXPECT_EQ(ui::changeKey("clutch", key(Qt::Key_W)), "");
  const QKeyEvent held(QEvent::KeyPress, Qt::Key_W, Qt::NoModifier);
  EXPECT_EQ(ui::meaningOf(Where::Space, held, Gesture::HeldKey)->action, Action::Clutch);
}

TEST(Bindings, AKeyThatIsTakenOrNeededIsRefusedWithTheReason) {
  const KeysAtFirst at_first;
  const QString taken = ui::changeKey("take_tool", key(Qt::Key_K));
  EXPECT_TRUE(taken.contains("K is taken") && taken.contains("brings the crosshair to the tool"))
      << taken.toStdString();
  // also by what works in every view, and anywhere
  EXPECT_NE(ui::changeKey("take_tool", key(Qt::Key_D)), "");
  EXPECT_NE(ui::changeKey("whole_slice", key(Qt::Key_M)), "");
  EXPECT_NE(ui::changeKey("mark", key(Qt::Key_G)), "");
  for (const Qt::Key needed : {Qt::Key_Escape, Qt::Key_Space, Qt::Key_Tab}) {
    EXPECT_NE(ui::changeKey("take_tool", key(needed)), "") << needed;
    EXPECT_NE(ui::changeKey("undo", key(needed, Qt::ControlModifier)), "") << needed;
  }
  EXPECT_NE(ui::changeKey("take_tool", key(Qt::Key_F, Qt::AltModifier)), "");  // a menu
  EXPECT_NE(ui::changeKey("clutch", key(Qt::Key_W, Qt::ControlModifier)), "");
  EXPECT_NE(ui::changeKey("open_file", key(Qt::Key_Return)), "");
  EXPECT_NE(ui::changeKey("open_file", key(Qt::Key_Enter, Qt::KeypadModifier)), "");
  EXPECT_NE(ui::changeKey("", key(Qt::Key_W)), "");
  EXPECT_NE(ui::changeKey("nothing", key(Qt::Key_W)), "");
  EXPECT_TRUE(ui::ownKeys().isEmpty());
  // P where no key means anything else
  EXPECT_EQ(ui::changeKey("whole_slice", key(Qt::Key_P)), "");
}

TEST(Bindings, WhatIsStoredAndCannotBeIsLeftOut) {
  const KeysAtFirst at_first;
  for (const char* const odd :
       {"", "Ctrl+", "no key", "G, H", "Esc", "Space", "Alt+F", "\n", "K"}) {
    ui::setOwnKeys({{"take_tool", odd}});
    EXPECT_EQ(ui::keyOf(Action::TakeTool), "G") << odd;
  }
  ui::setOwnKeys({{"nothing", "E"}, {"", "E"}});
  EXPECT_TRUE(ui::ownKeys().isEmpty());
  // two that want the same key, and one that wants another's
  ui::setOwnKeys({{"take_tool", "E"}, {"parallel", "E"}, {"show_everything", "T"}});
  EXPECT_TRUE(ui::conflictsIn(ui::bindings()).isEmpty());
  EXPECT_EQ(ui::ownKeys().size(), 1);
  // two that change places
  const ui::OwnKeys swapped{{"tool_to_cross", "K"}, {"cross_to_tool", "J"}};
  ui::setOwnKeys(swapped);
  EXPECT_EQ(ui::ownKeys(), swapped);
}

TEST(Bindings, AreShownInAWindowThatFitsTheScreen) {
  ui::MainWindow window;
  window::showAndWait(window, {1000, 700});
  QSize shown;
  QString told;
  QTimer::singleShot(200, &window, [&] {
    QWidget* open = QApplication::activeModalWidget();
    ASSERT_NE(open, nullptr);
    shown = open->frameGeometry().size();
    if (auto* text = open->findChild<QTextBrowser*>()) told = text->toPlainText();
    QTest::keyClick(open, Qt::Key_Escape);
  });
  const auto actions = window.findChildren<QAction*>();
  const auto controls =
      std::ranges::find(actions, QKeySequence(Qt::SHIFT | Qt::Key_F1), &QAction::shortcut);
  ASSERT_NE(controls, actions.end());
  (*controls)->trigger();
  EXPECT_GT(shown.width(), 400);
  EXPECT_LT(shown.height(), 768);
  EXPECT_TRUE(std::ranges::all_of(ui::controlRows(), [&](const ui::ControlRow& row) {
    return told.contains(row.triggers) && told.contains(row.words);
  }));
}

}  // namespace
