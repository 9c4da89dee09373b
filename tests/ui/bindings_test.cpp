// SPDX-License-Identifier: BSD-3-Clause
#include "ui/bindings.h"

#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QFile>
#include <QMainWindow>
#include <QTest>
#include <QTextBrowser>
#include <QTimer>
#include <algorithm>
#include <vector>

#include "ui/main_window.h"
#include "window_support.h"

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
  EXPECT_EQ(with({.place = Where::Anywhere, .key = Qt::Key_G, .words = "planted"}), 1);
  EXPECT_EQ(with({.place = Where::Space,
                  .mode = MouseMode::Hand,
                  .gesture = Gesture::Drag,
                  .key = Qt::MiddleButton,
                  .words = "planted"}),
            1);
  EXPECT_EQ(with({.place = Where::Space, .key = Qt::Key_C, .words = "planted"}), 1);
  // a view's own key that all views have
  EXPECT_EQ(with({.place = Where::Slice, .key = Qt::Key_D, .words = "planted"}), 1);
  EXPECT_EQ(with({.place = Where::Slice, .key = Qt::Key_G, .words = "not in conflict"}), 0);
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

TEST(Bindings, AreWhatTheReadmeSays) {
  QFile file(PALPATE_SOURCE "/ui/README.md");
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  const QString section =
      QString::fromUtf8(file.readAll()).section("## Keys and mouse", 1).section("\n## ", 0, 0);
  QStringList told, expected;
  for (const QString& line : section.split('\n'))
    if (line.startsWith("| ") && !line.startsWith("| key") && !line.startsWith("| mouse"))
      told << line;
  for (const ui::ControlRow& row : ui::controlRows()) {
    expected << QString("| %1 | %2 | %3 |").arg(row.triggers, row.place, row.words);
    EXPECT_TRUE(ui::controlsText().contains(row.words));
  }
  EXPECT_EQ(told, expected) << "ui/README.md should say:\n" << expected.join('\n').toStdString();
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
  const auto controls = std::ranges::find(actions, QKeySequence(Qt::Key_F1), &QAction::shortcut);
  ASSERT_NE(controls, actions.end());
  (*controls)->trigger();
  EXPECT_GT(shown.width(), 400);
  EXPECT_LT(shown.height(), 768);
  EXPECT_TRUE(std::ranges::all_of(ui::controlRows(), [&](const ui::ControlRow& row) {
    return told.contains(row.triggers) && told.contains(row.words);
  }));
}

}  // namespace
