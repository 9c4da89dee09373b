// SPDX-License-Identifier: BSD-3-Clause
#include "ui/bindings.h"

#include <QCoreApplication>
#include <array>
#include <utility>

namespace ui {
namespace {

#define WORDS(text) QT_TRANSLATE_NOOP("ui::bindings", text)

auto allBindings() {
  using enum Gesture;
  using enum MouseMode;
  using enum Where;
  constexpr auto kCtrl = Qt::ControlModifier;
  constexpr auto kShift = Qt::ShiftModifier;
  return std::to_array<Binding>({
      // keys
      {Action::Elsewhere, Anywhere, {}, Key, Qt::Key_O, kCtrl, false, WORDS("opens a file")},
      {Action::Elsewhere,
       Anywhere,
       {},
       Key,
       Qt::Key_O,
       kCtrl | kShift,
       false,
       WORDS("opens a folder")},
      {Action::Elsewhere,
       Anywhere,
       {},
       Key,
       Qt::Key_S,
       kCtrl | kShift,
       false,
       WORDS("saves a picture of the view or the window")},
      {Action::Elsewhere,
       Anywhere,
       {},
       Key,
       Qt::Key_C,
       kCtrl | kShift,
       false,
       WORDS("copies a picture of the 3-D view")},
      {Action::Elsewhere, Anywhere, {}, Key, Qt::Key_Z, kCtrl, false, WORDS("takes an edit back")},
      {Action::Elsewhere,
       Anywhere,
       {},
       Key,
       Qt::Key_Z,
       kCtrl | kShift,
       false,
       WORDS("makes it again")},
      {Action::Elsewhere, Anywhere, {}, Key, Qt::Key_Y, kCtrl, false, WORDS("makes it again")},
      {Action::Elsewhere, Anywhere, {}, Key, Qt::Key_Q, kCtrl, false, WORDS("quits")},
      {Action::Elsewhere,
       Anywhere,
       {},
       Key,
       Qt::Key_Escape,
       {},
       false,
       WORDS("force off; ends cutting")},
      {Action::Elsewhere, Anywhere, {}, Key, Qt::Key_F1, {}, false, WORDS("shows all controls")},
      {Action::Elsewhere,
       Anywhere,
       {},
       Key,
       Qt::Key_M,
       {},
       false,
       WORDS("while recording: sets a mark")},
      {Action::ForceOff, Space, {}, Key, Qt::Key_Space, {}, false, WORDS("force off")},
      {Action::TakeTool,
       Space,
       {},
       Key,
       Qt::Key_G,
       {},
       false,
       WORDS("takes the tool with the mouse, or lets it go")},
      {Action::ToolToCross,
       Space,
       {},
       Key,
       Qt::Key_J,
       {},
       false,
       WORDS("brings the tool to the crosshair")},
      {Action::CrossToTool,
       Space,
       {},
       Key,
       Qt::Key_K,
       {},
       false,
       WORDS("brings the crosshair to the tool")},
      {Action::LookAlongTool, Space, {}, Key, Qt::Key_L, {}, false, WORDS("looks along the tool")},
      {Action::LookFromTool,
       Space,
       {},
       Key,
       Qt::Key_T,
       {},
       false,
       WORDS("shows everything from the tool's side")},
      {Action::ShowEverything,
       Space,
       {},
       Key,
       Qt::Key_R,
       {},
       false,
       WORDS("shows everything, from the front")},
      {Action::ViewAnterior, Space, {}, Key, Qt::Key_1, {}, false, WORDS("from the front (A)")},
      {Action::ViewPosterior, Space, {}, Key, Qt::Key_2, {}, false, WORDS("from behind (P)")},
      {Action::ViewLeft,
       Space,
       {},
       Key,
       Qt::Key_3,
       {},
       false,
       WORDS("from the patient's left (L)")},
      {Action::ViewRight,
       Space,
       {},
       Key,
       Qt::Key_4,
       {},
       false,
       WORDS("from the patient's right (R)")},
      {Action::ViewSuperior, Space, {}, Key, Qt::Key_5, {}, false, WORDS("from above (S)")},
      {Action::ViewInferior, Space, {}, Key, Qt::Key_6, {}, false, WORDS("from below (I)")},
      {Action::ParallelProjection,
       Space,
       {},
       Key,
       Qt::Key_P,
       {},
       false,
       WORDS("parallel projection on or off")},
      {Action::Clutch,
       Space,
       {},
       HeldKey,
       Qt::Key_C,
       {},
       false,
       WORDS("clutch; released when the view loses the focus")},
      {Action::HoldToRun,
       Space,
       {},
       HeldKey,
       Qt::Key_H,
       {},
       false,
       WORDS("hold-to-run; released when the view loses the focus")},
      {Action::Elsewhere,
       Space,
       {},
       Key,
       Qt::Key_D,
       {},
       false,
       WORDS("places a distance; again: ends it")},
      {Action::Elsewhere,
       Slice,
       {},
       Key,
       Qt::Key_D,
       {},
       false,
       WORDS("places a distance; again: ends it")},
      {Action::Elsewhere,
       Space,
       {},
       Key,
       Qt::Key_A,
       {},
       false,
       WORDS("places an angle; again: ends it")},
      {Action::Elsewhere,
       Slice,
       {},
       Key,
       Qt::Key_A,
       {},
       false,
       WORDS("places an angle; again: ends it")},
      {Action::Elsewhere,
       Space,
       {},
       Key,
       Qt::Key_V,
       {},
       false,
       WORDS("places a point with its value; again: ends it")},
      {Action::Elsewhere,
       Slice,
       {},
       Key,
       Qt::Key_V,
       {},
       false,
       WORDS("places a point with its value; again: ends it")},
      {Action::Elsewhere,
       Space,
       {},
       Key,
       Qt::Key_N,
       {},
       false,
       WORDS("places a note; again: ends it")},
      {Action::Elsewhere,
       Slice,
       {},
       Key,
       Qt::Key_N,
       {},
       false,
       WORDS("places a note; again: ends it")},
      {Action::Elsewhere,
       Space,
       {},
       Key,
       Qt::Key_Backspace,
       {},
       false,
       WORDS("while placing: takes the last place back")},
      {Action::Elsewhere,
       Slice,
       {},
       Key,
       Qt::Key_Backspace,
       {},
       false,
       WORDS("while placing: takes the last place back")},
      {Action::Elsewhere,
       Space,
       {},
       Key,
       Qt::Key_Delete,
       {},
       false,
       WORDS("deletes the chosen mark")},
      {Action::Elsewhere,
       Slice,
       {},
       Key,
       Qt::Key_Delete,
       {},
       false,
       WORDS("deletes the chosen mark")},
      {Action::Elsewhere, Anywhere, {}, Key, Qt::Key_S, kCtrl, false, WORDS("saves the view")},
      {Action::Elsewhere, ReplayBar, {}, Key, Qt::Key_Space, {}, false, WORDS("plays and pauses")},
      {Action::Elsewhere, ReplayBar, {}, Key, Qt::Key_Left, {}, false, WORDS("one tick back")},
      {Action::Elsewhere, ReplayBar, {}, Key, Qt::Key_Right, {}, false, WORDS("one tick forward")},
      {Action::Elsewhere, ReplayBar, {}, Key, Qt::Key_Home, {}, false, WORDS("to the beginning")},
      {Action::Elsewhere, ReplayBar, {}, Key, Qt::Key_End, {}, false, WORDS("to the end")},
      // mouse
      {Action::MoveTool,
       Space,
       {},
       Drag,
       Qt::LeftButton,
       {},
       true,
       WORDS("moves the tool in the plane of the screen, if the mouse is the hand")},
      {Action::TurnTool,
       Space,
       {},
       Drag,
       Qt::LeftButton,
       kShift,
       true,
       WORDS("turns the tool, if the mouse is the hand")},
      {Action::Rotate, Space, Look, Drag, Qt::LeftButton, {}, false, WORDS("turns the picture")},
      {Action::Pan, Space, {}, Drag, Qt::MiddleButton, {}, false, WORDS("shifts the picture")},
      {Action::Zoom,
       Space,
       Look,
       Drag,
       Qt::RightButton,
       {},
       false,
       WORDS("comes nearer (up) or goes away (down)")},
      {Action::Zoom, Space, Look, Wheel, 0, {}, false, WORDS("comes nearer at the cursor")},
      {Action::BringTool,
       Space,
       Look,
       DoubleClick,
       Qt::LeftButton,
       {},
       false,
       WORDS("on the surface: brings the tool there")},
      {Action::MoveTool,
       Space,
       Hand,
       Drag,
       Qt::LeftButton,
       {},
       false,
       WORDS("moves the tool in the plane of the screen")},
      {Action::TurnTool, Space, Hand, Drag, Qt::LeftButton, kShift, false, WORDS("turns the tool")},
      {Action::Rotate, Space, Hand, Drag, Qt::RightButton, {}, false, WORDS("turns the picture")},
      {Action::PushTool, Space, Hand, Wheel, 0, {}, false, WORDS("moves the tool in depth")},
      {Action::Zoom, Space, Hand, Wheel, 0, kCtrl, false, WORDS("comes nearer at the cursor")},
      {Action::Elsewhere,
       Slice,
       {},
       Click,
       Qt::LeftButton,
       {},
       false,
       WORDS("moves the crosshair")},
      {Action::BringTool,
       Slice,
       {},
       DoubleClick,
       Qt::LeftButton,
       {},
       false,
       WORDS("brings the tool to the surface there")},
      {Action::Elsewhere, Slice, {}, Wheel, 0, {}, false, WORDS("goes through the slices")},
      {Action::Elsewhere,
       Slice,
       {},
       Drag,
       Qt::RightButton,
       {},
       false,
       WORDS("changes brightness (up and down) and contrast (left and right)")},
      {Action::Elsewhere,
       Histogram,
       {},
       Drag,
       Qt::LeftButton,
       {},
       false,
       WORDS("moves the isovalue")},
      {Action::Elsewhere,
       ReplayBar,
       {},
       Drag,
       Qt::LeftButton,
       {},
       false,
       WORDS("moves through the time")},
  });
}

#undef WORDS

const auto& table() {
  static const auto kTable = allBindings();
  return kTable;
}

QString bindingWords(const char* text) { return QCoreApplication::translate("ui::bindings", text); }

bool isMouse(Gesture gesture) { return gesture != Gesture::Key && gesture != Gesture::HeldKey; }

/// Whether two gestures are one and the same to a hand: a held key is a key, and a double click
/// begins as a click, which does not keep it from being one.
bool alike(Gesture a, Gesture b) {
  const auto kind = [](Gesture gesture) {
    return gesture == Gesture::HeldKey ? Gesture::Key : gesture;
  };
  return kind(a) == kind(b);
}

bool overlap(const Binding& a, const Binding& b) {
  const bool places =
      a.place == b.place || a.place == Where::Anywhere || b.place == Where::Anywhere;
  const bool modes = !a.mode || !b.mode || *a.mode == *b.mode;
  return places && modes && alike(a.gesture, b.gesture) && a.key == b.key &&
         a.modifiers == b.modifiers && a.on_tool == b.on_tool;
}

}  // namespace

std::span<const Binding> bindings() { return table(); }

std::optional<Action> actionOf(Where place, MouseMode mode, Gesture gesture, int key,
                               Qt::KeyboardModifiers modifiers, bool on_tool) {
  modifiers &= ~Qt::KeyboardModifiers{Qt::KeypadModifier | Qt::GroupSwitchModifier};
  const auto find = [&](Qt::KeyboardModifiers held, bool tool) -> std::optional<Action> {
    for (const Binding& binding : table())
      if (binding.place == place && (!binding.mode || *binding.mode == mode) &&
          binding.gesture == gesture && binding.key == key && binding.modifiers == held &&
          binding.on_tool == tool)
        return binding.action;
    return {};
  };
  for (const bool tool : {true, false}) {
    if (tool && !on_tool) continue;
    if (const auto action = find(modifiers, tool)) return action;
    if (!isMouse(gesture)) continue;
    if (const auto action = find({}, tool)) return action;
  }
  return {};
}

QStringList conflictsIn(std::span<const Binding> bindings) {
  QStringList conflicts;
  for (std::size_t i = 0; i < bindings.size(); ++i)
    for (std::size_t j = i + 1; j < bindings.size(); ++j)
      if (overlap(bindings[i], bindings[j]))
        conflicts << QStringLiteral("%1, %2: \"%3\" and \"%4\"")
                         .arg(triggerOf(bindings[i]), placeOf(bindings[j]), wordsOf(bindings[i]),
                              wordsOf(bindings[j]));
  return conflicts;
}

QString keyOf(Action action) {
  for (const Binding& binding : table())
    if (binding.action == action && binding.gesture == Gesture::Key)
      return QKeySequence(int(binding.modifiers) | binding.key).toString(QKeySequence::NativeText);
  return {};
}

QString triggerOf(const Binding& binding) {
  if (!isMouse(binding.gesture)) {
    const QString key = QKeySequence(int(binding.modifiers) | binding.key)
                            .toString(QKeySequence::PortableText)
                            .replace(QLatin1String("Esc"), QLatin1String("Escape"));
    return binding.gesture == Gesture::HeldKey ? bindingWords("%1, held").arg(key) : key;
  }
  QString trigger;
  if (binding.gesture == Gesture::Wheel) {
    trigger = bindingWords("wheel");
  } else {
    const QString button = binding.key == Qt::LeftButton    ? bindingWords("left")
                           : binding.key == Qt::RightButton ? bindingWords("right")
                                                            : bindingWords("middle");
    trigger = binding.gesture == Gesture::Drag          ? bindingWords("%1 drag").arg(button)
              : binding.gesture == Gesture::DoubleClick ? bindingWords("double-click")
                                                        : bindingWords("click");
  }
  if (binding.modifiers & Qt::ShiftModifier) trigger = bindingWords("Shift and %1").arg(trigger);
  if (binding.modifiers & Qt::ControlModifier) trigger = bindingWords("Ctrl and %1").arg(trigger);
  return trigger;
}

QString placeOf(const Binding& binding) {
  switch (binding.place) {
    case Where::Anywhere:
      return bindingWords("anywhere");
    case Where::Slice:
      return bindingWords("slices");
    case Where::Histogram:
      return bindingWords("histogram");
    case Where::ReplayBar:
      return bindingWords("replay bar");
    case Where::Space:
      break;
  }
  if (binding.on_tool) return bindingWords("3-D view, on the tool");
  if (!binding.mode) return bindingWords("3-D view");
  return *binding.mode == MouseMode::Look ? bindingWords("3-D view, looking")
                                          : bindingWords("3-D view, mouse as hand");
}

QString wordsOf(const Binding& binding) { return bindingWords(binding.words); }

QString controlsText() {
  QString text;
  const auto rows = [&](bool mouse) {
    text += QStringLiteral("<table cellpadding=2>");
    for (const Binding& binding : table())
      if (isMouse(binding.gesture) == mouse)
        text += QStringLiteral("<tr><td><b>%1</b></td><td>%2</td><td>%3</td></tr>")
                    .arg(triggerOf(binding), placeOf(binding), wordsOf(binding));
    text += QStringLiteral("</table>");
  };
  rows(false);
  text += QStringLiteral("<p></p>");
  rows(true);
  return text;
}

}  // namespace ui
