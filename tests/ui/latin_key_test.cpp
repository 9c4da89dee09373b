// SPDX-License-Identifier: BSD-3-Clause
// Keys mean the same on keyboards of every script. X numbers the places of keys: G is at 42
// wherever it is engraved with another letter.
#include "ui/controls/latin_key.h"

#include <dlfcn.h>
#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMenu>
#include <QProcess>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QTest>

#include "tests/ui/window_support.h"
#include "ui/controls/bindings.h"
#include "ui/views/volume_view.h"
#include "ui/window/main_window.h"
#include "ui/window/view_layout.h"
#include "ui/window/views.h"

namespace {

using ui::MouseMode;

// places of keys, by what a US keyboard writes there
constexpr quint32 kPlaceS = 39, kPlaceF = 41, kPlaceG = 42, kPlaceH = 43, kPlaceC = 54,
                  kPlaceComma = 59;

/// What a keyboard writes at the places of G, C, H and F.
struct Keyboard {
  const char* name;
  char32_t g, c, h, f;
};
constexpr Keyboard kKeyboards[] = {{"Russian", U'П', U'С', U'Р', U'А'},
                                   {"Greek", U'Γ', U'Ψ', U'Η', U'Φ'},
                                   {"Hebrew", U'ע', U'ב', U'י', U'כ'},
                                   {"Arabic", U'ل', U'ؤ', U'ا', U'ب'},
                                   {"Hindi", U'\x0909', U'\x092E', U'\x092A', U'\x093F'},
                                   {"Thai", U'เ', U'แ', U'้', U'ด'}};

QKeyEvent keyEvent(QEvent::Type type, char32_t key, quint32 place,
                   Qt::KeyboardModifiers modifiers = {}, bool repeats = false) {
  const QString text = key < 0x01000000 && !(modifiers & Qt::ControlModifier)
                           ? QString::fromUcs4(&key, 1).toLower()
                           : QString();
  return QKeyEvent(type, int(key), modifiers, place, 0, 0, text, repeats);
}

void send(QWidget& to, QEvent::Type type, char32_t key, quint32 place,
          Qt::KeyboardModifiers modifiers = {}, bool repeats = false) {
  QKeyEvent event = keyEvent(type, key, place, modifiers, repeats);
  QApplication::sendEvent(&to, &event);
}

int latin(char32_t key, quint32 place, Qt::KeyboardModifiers modifiers = {}) {
  return ui::latinKey(keyEvent(QEvent::KeyPress, key, place, modifiers));
}

TEST(Bindings, OfALetterOfAnotherScriptIsThePlace) {
  for (const Keyboard& keyboard : kKeyboards) {
    SCOPED_TRACE(keyboard.name);
    EXPECT_EQ(latin(keyboard.g, kPlaceG), Qt::Key_G);
    EXPECT_EQ(latin(keyboard.c, kPlaceC), Qt::Key_C);
    EXPECT_EQ(latin(keyboard.h, kPlaceH, Qt::ControlModifier), Qt::Key_H);
    EXPECT_EQ(latin(keyboard.f, kPlaceF, Qt::ShiftModifier), Qt::Key_F);
  }
  // every place of a letter, as a Russian keyboard goes through them
  const char32_t rows[][11] = {U"ЙЦУКЕНГШЩЗ", U"ФЫВАПРОЛД", U"ЯЧСМИТЬ"};
  const char* const expected[] = {"QWERTYUIOP", "ASDFGHJKL", "ZXCVBNM"};
  const quint32 first[] = {24, 38, 52};
  for (int row = 0; row < 3; ++row)
    for (quint32 n = 0; expected[row][n] != '\0'; ++n)
      EXPECT_EQ(latin(rows[row][n], first[row] + n), expected[row][n]) << expected[row] << n;
  EXPECT_EQ(latin(U'Б', kPlaceComma, Qt::ControlModifier), Qt::Key_Comma);
  EXPECT_EQ(latin(U'Б', kPlaceComma, Qt::ShiftModifier), Qt::Key_Less);
  EXPECT_EQ(latin(U'٣', 12), Qt::Key_3);
  EXPECT_EQ(latin(U'३', 0), Qt::Key_3);
}

TEST(Bindings, OfWhatIsLatinOrHasANameIsItself) {
  EXPECT_EQ(latin(U'G', kPlaceG), Qt::Key_G);
  EXPECT_EQ(latin(U'I', kPlaceG), Qt::Key_I);  // Dvorak
  EXPECT_EQ(latin(U'Ö', 47), int(U'Ö'));
  EXPECT_EQ(latin(U'É', 11), int(U'É'));       // on a French 2
  EXPECT_EQ(latin(U'Ğ', kPlaceG), int(U'Ğ'));  // Turkish
  EXPECT_EQ(latin(U'/', 24), Qt::Key_Slash);
  EXPECT_EQ(latin(U'€', 26), int(U'€'));
  EXPECT_EQ(latin(Qt::Key_Space, 65), Qt::Key_Space);
  EXPECT_EQ(latin(Qt::Key_Left, kPlaceG), Qt::Key_Left);
  // what AltGr writes, and a letter whose place is unknown or beside the letters
  EXPECT_EQ(latin(U'П', kPlaceG, Qt::GroupSwitchModifier), int(U'П'));
  EXPECT_EQ(latin(U'П', 0), int(U'П'));
  EXPECT_EQ(latin(U'П', 200), int(U'П'));
}

TEST(Bindings, ALetterOfAnyScriptHoldsClutchAndForce) {
  ui::VolumeView view;
  QSignalSpy clutch(&view, &ui::VolumeView::clutchHeld);
  QSignalSpy force(&view, &ui::VolumeView::forceHeld);
  for (const Keyboard& keyboard : kKeyboards) {
    SCOPED_TRACE(keyboard.name);
    for (auto* const spy : {&clutch, &force}) {
      spy->clear();
      const char32_t key = spy == &clutch ? keyboard.c : keyboard.h;
      const quint32 place = spy == &clutch ? kPlaceC : kPlaceH;
      send(view, QEvent::KeyPress, key, place);
      ASSERT_EQ(spy->count(), 1);
      EXPECT_TRUE(spy->at(0).at(0).toBool());
      send(view, QEvent::KeyRelease, key, place, Qt::ShiftModifier);
      ASSERT_EQ(spy->count(), 2);
      EXPECT_FALSE(spy->at(1).at(0).toBool());
    }
  }
}

TEST(Bindings, ALetterOfAnotherScriptThatTheUserChoseKeepsItsMeaning) {
  ui::setOwnKeys({{"take_tool", QString::fromUtf8("П")}});
  const QKeyEvent own = keyEvent(QEvent::KeyPress, U'П', kPlaceG);
  const ui::Binding* meaning = ui::meaningOf(ui::Where::Anywhere, own);
  ui::setOwnKeys({});
  ASSERT_NE(meaning, nullptr);
  EXPECT_EQ(meaning->action, ui::Action::TakeTool);
}

TEST(Bindings, AHeldKeyIsLetGoThoughTheLayoutHasChanged) {
  ui::VolumeView view;
  QSignalSpy force(&view, &ui::VolumeView::forceHeld);
  QSignalSpy to_cross(&view, &ui::VolumeView::toolToCrossWanted);
  struct {
    const char* name;
    char32_t pressed, released;
    quint32 place;
  } const changes[] = {{"Russian, then Latin", U'Р', U'H', kPlaceH},
                       {"Latin, then Russian", U'H', U'Р', kPlaceH},
                       {"Latin, then Dvorak", U'H', U'D', kPlaceH},
                       {"Russian, then nothing that is known", U'Р', U'Р', 0},
                       {"at another place", U'H', U'H', kPlaceG}};
  for (const auto& [name, pressed, released, place] : changes) {
    SCOPED_TRACE(name);
    force.clear();
    send(view, QEvent::KeyPress, pressed, kPlaceH);
    ASSERT_EQ(force.count(), 1);
    // another key is not this one
    send(view, QEvent::KeyRelease, U'П', kPlaceG);
    EXPECT_EQ(force.count(), 1);
    send(view, QEvent::KeyRelease, released, place);
    ASSERT_EQ(force.count(), 2);
    EXPECT_FALSE(force.at(1).at(0).toBool());
  }
  // while it is held, the new layout's letter does not do what that does
  send(view, QEvent::KeyPress, U'H', kPlaceH);
  send(view, QEvent::KeyPress, U'J', kPlaceH, {}, true);
  EXPECT_EQ(to_cross.count(), 0);
  send(view, QEvent::KeyRelease, U'J', kPlaceH);
  EXPECT_FALSE(force.back().at(0).toBool());
  send(view, QEvent::KeyPress, U'J', kPlaceH);
  EXPECT_EQ(to_cross.count(), 1);
  // a key that repeats itself begins nothing: a question may have come between
  force.clear();
  send(view, QEvent::KeyPress, U'H', kPlaceH, {}, true);
  EXPECT_EQ(force.count(), 0);
}

TEST(Bindings, ShortcutsAndMenusTakeLettersOfAnyScriptAndFieldsWriteThem) {
  ui::MainWindow window;
  window::showAndWait(window, {1000, 700});
  QApplication::setActiveWindow(&window);
  auto* alone = window.findChild<QAction*>("maximiseView");
  auto* picture = window.findChild<QAction*>("savePicture");
  alone->disconnect(&window.views().layout());
  picture->disconnect();
  QSignalSpy shown_alone(alone, &QAction::triggered), pictures(picture, &QAction::triggered);
  window.views().volume().setMouseHand(true);
  window.views().volume().setFocus();
  int times = 0;
  for (const Keyboard& keyboard : kKeyboards) {
    SCOPED_TRACE(keyboard.name);
    send(window.views().volume(), QEvent::KeyPress, keyboard.f, kPlaceF);
    EXPECT_EQ(shown_alone.count(), ++times);
    // the tool is taken from anywhere in the window
    QWidget& panel = *window.findChild<QWidget*>("touchTab");
    send(panel, QEvent::KeyPress, keyboard.g, kPlaceG);
    EXPECT_EQ(window.views().volume().mouseMode(), MouseMode::Hand);
    send(panel, QEvent::KeyPress, keyboard.g, kPlaceG);
    EXPECT_EQ(window.views().volume().mouseMode(), MouseMode::Look);
  }
  send(window.views().volume(), QEvent::KeyPress, U'Ы', kPlaceS,
       Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(pictures.count(), 1);
  // a field writes its letters, and copies with Ctrl and the key that has no C
  auto* field = new QLineEdit(&window);
  field->show();
  field->setFocus();
  send(*field, QEvent::KeyPress, U'А', kPlaceF);
  send(*field, QEvent::KeyPress, U'Φ', kPlaceF, Qt::ShiftModifier);
  EXPECT_EQ(field->text(), QString::fromUtf8("аφ"));
  EXPECT_EQ(shown_alone.count(), times);
  field->selectAll();
  send(*field, QEvent::KeyPress, U'С', kPlaceC, Qt::ControlModifier);
  field->clear();
  send(*field, QEvent::KeyPress, U'М', 55, Qt::ControlModifier);  // V
  EXPECT_EQ(field->text(), QString::fromUtf8("аφ"));
  // the underlined letter of an entry
  QMenu menu(&window);
  QSignalSpy chosen(menu.addAction("&Histogram"), &QAction::triggered);
  menu.addAction("&Grid");
  menu.popup({200, 200});
  send(menu, QEvent::KeyPress, U'Р', kPlaceH);
  EXPECT_EQ(chosen.count(), 1);
}

/// A key of the display's own keyboard, and which layout that has.
class XKeyboard {
 public:
  XKeyboard() {
    void* const x11 = dlopen("libX11.so.6", RTLD_LAZY);
    void* const test = dlopen("libXtst.so.6", RTLD_LAZY);
    if (x11 == nullptr || test == nullptr || QStandardPaths::findExecutable("setxkbmap").isEmpty())
      return;
    const auto open = reinterpret_cast<void* (*)(const char*)>(dlsym(x11, "XOpenDisplay"));
    focus_ = reinterpret_cast<Focus>(dlsym(x11, "XSetInputFocus"));
    sync_ = reinterpret_cast<Sync>(dlsym(x11, "XSync"));
    fake_ = reinterpret_cast<Fake>(dlsym(test, "XTestFakeKeyEvent"));
    display_ = open(nullptr);
  }
  ~XKeyboard() {
    if (there()) setLayout("us");
  }
  XKeyboard(const XKeyboard&) = delete;
  XKeyboard& operator=(const XKeyboard&) = delete;

  bool there() const { return display_ != nullptr; }
  static void setLayout(const QString& layout) {
    ASSERT_EQ(QProcess::execute("setxkbmap", {layout}), 0);
  }
  void giveTo(const QWidget& window) const {
    focus_(display_, window.winId(), 1, 0);
    sync_(display_, 0);
  }
  void turn(quint32 place, bool down) const {
    fake_(display_, place, down ? 1 : 0, 0);
    sync_(display_, 0);
  }

 private:
  using Focus = int (*)(void*, unsigned long, int, unsigned long);
  using Sync = int (*)(void*, int);
  using Fake = int (*)(void*, unsigned, int, unsigned long);
  void* display_ = nullptr;  // stays open: the program ends soon
  Focus focus_ = nullptr;
  Sync sync_ = nullptr;
  Fake fake_ = nullptr;
};

TEST(Bindings, ARealKeyboardWithoutLatinLettersDoesTheSame) {
  const XKeyboard keyboard;
  if (!keyboard.there()) GTEST_SKIP() << "NOT CHECKED: setxkbmap or libXtst is not here";
  ui::MainWindow window;
  window::showAndWait(window, {1000, 700});
  keyboard.giveTo(window);
  ASSERT_TRUE(window::waitFor([&] { return window.isActiveWindow(); }));
  ui::VolumeView& view = window.views().volume();
  view.setFocus();
  view.setMouseHand(true);
  auto* alone = window.findChild<QAction*>("maximiseView");
  alone->disconnect(&window.views().layout());
  QSignalSpy shown_alone(alone, &QAction::triggered), force(&view, &ui::VolumeView::forceHeld);
  int times = 0;
  for (const char* const layout : {"ru", "gr", "ru,us"}) {
    SCOPED_TRACE(layout);
    XKeyboard::setLayout(layout);
    for (const bool down : {true, false}) keyboard.turn(kPlaceF, down);
    ++times;
    EXPECT_TRUE(window::waitFor([&] { return shown_alone.count() == times; }));
    for (const bool down : {true, false}) keyboard.turn(kPlaceG, down);
    EXPECT_TRUE(window::waitFor([&] { return view.mouseMode() == MouseMode::Hand; }));
    view.setMouseMode(MouseMode::Look);
    // another layout while the key is down
    force.clear();
    keyboard.turn(kPlaceH, true);
    EXPECT_TRUE(window::waitFor([&] { return !force.isEmpty(); }));
    XKeyboard::setLayout("dvorak");
    keyboard.turn(kPlaceH, false);
    EXPECT_TRUE(window::waitFor([&] { return force.count() > 1; }));
    EXPECT_FALSE(force.back().at(0).toBool());
  }
}

}  // namespace
