// SPDX-License-Identifier: BSD-3-Clause
#include "ui/bindings.h"

#include <QCoreApplication>
#include <QKeyCombination>
#include <utility>
#include <vector>

namespace ui {
namespace {

#define WORDS(text) QT_TRANSLATE_NOOP("ui::bindings", text)

/// Lines of the table.
namespace binding_lines {

Binding key(Where place, QKeyCombination keys, const char* words, Action action = {}) {
  return {.action = action,
          .place = place,
          .key = keys.key(),
          .modifiers = keys.keyboardModifiers(),
          .words = words};
}
Binding held(Where place, Qt::Key key, const char* words, Action action) {
  return {
      .action = action, .place = place, .gesture = Gesture::HeldKey, .key = key, .words = words};
}
Binding mouse(Gesture gesture, Where place, int button, const char* words, Action action) {
  return {.action = action, .place = place, .gesture = gesture, .key = button, .words = words};
}
Binding click(Where place, Qt::MouseButton button, const char* words, Action action = {}) {
  return mouse(Gesture::Click, place, button, words, action);
}
Binding twice(Where place, Qt::MouseButton button, const char* words, Action action = {}) {
  return mouse(Gesture::DoubleClick, place, button, words, action);
}
Binding drag(Where place, Qt::MouseButton button, const char* words, Action action = {}) {
  return mouse(Gesture::Drag, place, button, words, action);
}
Binding wheel(Where place, const char* words, Action action = {}) {
  return mouse(Gesture::Wheel, place, 0, words, action);
}
Binding shift(Binding binding) {
  binding.modifiers |= Qt::ShiftModifier;
  return binding;
}
Binding ctrl(Binding binding) {
  binding.modifiers |= Qt::ControlModifier;
  return binding;
}
Binding in(MouseMode mode, Binding binding) {
  binding.mode = mode;
  return binding;
}
Binding over(Over what, Binding binding) {
  binding.over = what;
  return binding;
}

}  // namespace binding_lines

/// Lines that follow one another with the same place and words are one row of Help and README.
std::vector<Binding> allBindings() {
  using enum Action;
  using enum MouseMode;
  using enum Where;
  using namespace Qt;
  using namespace binding_lines;
  constexpr auto left = LeftButton, middle = MiddleButton, right = RightButton;
  return {
      key(Anywhere, CTRL | Key_O, WORDS("opens a file")),
      key(Anywhere, CTRL | SHIFT | Key_O, WORDS("opens a folder")),
      key(Anywhere, CTRL | Key_S, WORDS("saves the view")),
      key(Anywhere, CTRL | SHIFT | Key_S, WORDS("saves a picture of a view or the window")),
      key(Anywhere, CTRL | SHIFT | Key_C, WORDS("copies a picture of the 3-D view")),
      key(Anywhere, CTRL | Key_Z, WORDS("takes the last edit back")),
      key(Anywhere, CTRL | SHIFT | Key_Z, WORDS("makes it again")),
      key(Anywhere, CTRL | Key_Y, WORDS("makes it again")),
      key(Anywhere, CTRL | Key_Q, WORDS("quits")),
      key(Anywhere, Key_Escape,
          WORDS("force off; puts away the tool of an edit and a measure that is being placed")),
      key(Anywhere, Key_F1, WORDS("shows all controls")),
      key(Anywhere, Key_F6, WORDS("goes to the next view")),
      key(Anywhere, Key_M, WORDS("while recording: sets a mark")),

      key(View, Key_F, WORDS("shows a view alone, or all again")),
      key(View, Key_D, WORDS("places a distance; again: ends it")),
      key(View, Key_A, WORDS("places an angle; again: ends it")),
      key(View, Key_V, WORDS("places a point with its value; again: ends it")),
      key(View, Key_N, WORDS("places a note; again: ends it")),
      key(View, Key_Backspace, WORDS("while placing: takes the last place back")),
      key(View, Key_Delete, WORDS("deletes the chosen mark")),

      key(Space, Key_Space, WORDS("force off"), ForceOff),
      key(Space, Key_G, WORDS("takes the tool with the mouse, or lets it go"), TakeTool),
      key(Space, Key_J, WORDS("brings the tool to the crosshair"), ToolToCross),
      key(Space, Key_K, WORDS("brings the crosshair to the tool"), CrossToTool),
      key(Space, Key_L, WORDS("looks along the tool"), LookAlongTool),
      key(Space, Key_T, WORDS("shows everything from the tool's side"), LookFromTool),
      key(Space, Key_R, WORDS("shows everything, from the front"), ShowEverything),
      key(Space, Key_1, WORDS("from the front (A)"), ViewAnterior),
      key(Space, Key_2, WORDS("from behind (P)"), ViewPosterior),
      key(Space, Key_3, WORDS("from the patient's left (L)"), ViewLeft),
      key(Space, Key_4, WORDS("from the patient's right (R)"), ViewRight),
      key(Space, Key_5, WORDS("from above (S)"), ViewSuperior),
      key(Space, Key_6, WORDS("from below (I)"), ViewInferior),
      key(Space, Key_P, WORDS("parallel projection on or off"), ParallelProjection),
      key(Space, Key_Left, WORDS("turns the picture"), Rotate),
      key(Space, Key_Right, WORDS("turns the picture"), Rotate),
      key(Space, Key_Up, WORDS("turns the picture"), Rotate),
      key(Space, Key_Down, WORDS("turns the picture"), Rotate),
      key(Space, SHIFT | Key_Left, WORDS("shifts the picture"), Pan),
      key(Space, SHIFT | Key_Right, WORDS("shifts the picture"), Pan),
      key(Space, SHIFT | Key_Up, WORDS("shifts the picture"), Pan),
      key(Space, SHIFT | Key_Down, WORDS("shifts the picture"), Pan),
      key(Space, Key_Plus, WORDS("comes nearer at the pointer"), Zoom),
      key(Space, Key_Equal, WORDS("comes nearer at the pointer"), Zoom),
      key(Space, Key_Minus, WORDS("goes away from the pointer"), Zoom),
      held(Space, Key_C, WORDS("clutch; released when the view loses the focus"), Clutch),
      held(Space, Key_H, WORDS("hold-to-run; released when the view loses the focus"), HoldToRun),

      key(Slice, Key_Up, WORDS("next slice: towards S, P or L, with the tool deeper")),
      key(Slice, Key_Down, WORDS("slice before")),
      key(Slice, Key_PageUp, WORDS("ten slices on")),
      key(Slice, Key_PageDown, WORDS("ten slices back")),
      key(Slice, Key_Home, WORDS("first slice")),
      key(Slice, Key_End, WORDS("last slice")),
      key(Slice, Key_Plus, WORDS("comes nearer at the pointer")),
      key(Slice, Key_Equal, WORDS("comes nearer at the pointer")),
      key(Slice, Key_Minus, WORDS("goes away from the pointer")),
      key(Slice, Key_R, WORDS("shows the whole slice")),
      key(Slice, SHIFT | Key_Up, WORDS("shifts the picture")),
      key(Slice, SHIFT | Key_Down, WORDS("shifts the picture")),
      key(Slice, SHIFT | Key_Left, WORDS("shifts the picture")),
      key(Slice, SHIFT | Key_Right, WORDS("shifts the picture")),
      key(Slice, CTRL | Key_Up, WORDS("changes the brightness")),
      key(Slice, CTRL | Key_Down, WORDS("changes the brightness")),
      key(Slice, CTRL | Key_Left, WORDS("changes the contrast")),
      key(Slice, CTRL | Key_Right, WORDS("changes the contrast")),
      key(Slice, ALT | Key_Up, WORDS("moves the crosshair by a voxel")),
      key(Slice, ALT | Key_Down, WORDS("moves the crosshair by a voxel")),
      key(Slice, ALT | Key_Left, WORDS("moves the crosshair by a voxel")),
      key(Slice, ALT | Key_Right, WORDS("moves the crosshair by a voxel")),
      key(Slice, Key_J, WORDS("brings the tool to the crosshair")),
      key(Slice, Key_K, WORDS("brings the crosshair to the tool")),
      key(Slice, Key_Menu, WORDS("opens the choices for slices")),

      over(Over::Measuring,
           key(View, Key_Return, WORDS("sets a place: at the crosshair, in 3-D in the middle"))),
      over(Over::Editing, key(View, Key_Return,
                              WORDS("picks a piece, sets the clip plane or a corner of the "
                                    "scalpel: at the crosshair, in 3-D in the middle"))),
      over(Over::Editing, key(View, Key_Backspace, WORDS("takes the scalpel's last corner back"))),

      key(Marks, Key_Return, WORDS("goes to the place; again: to its next")),
      key(Marks, Key_F2, WORDS("renames the mark, or edits the note")),
      key(Marks, Key_Delete, WORDS("deletes the mark")),
      key(Border, Key_Left, WORDS("moves it")),
      key(Border, Key_Right, WORDS("moves it")),
      key(Border, Key_Up, WORDS("moves it")),
      key(Border, Key_Down, WORDS("moves it")),
      key(Border, Key_Home, WORDS("gives the views their first sizes")),
      key(ReplayBar, Key_Space, WORDS("plays and pauses")),
      key(ReplayBar, Key_Left, WORDS("one tick back")),
      key(ReplayBar, Key_Right, WORDS("one tick forward")),
      key(ReplayBar, Key_Home, WORDS("to the beginning")),
      key(ReplayBar, Key_End, WORDS("to the end")),

      // of the mouse the first that fits: what is drawn over a view is asked before the view
      over(Over::Handle, drag(View, left, WORDS("moves a mark, the crop box or the clip plane"))),
      over(Over::Measuring, click(View, left, WORDS("sets a place"))),
      over(Over::Measuring, drag(View, left, WORDS("draws a distance"))),
      over(Over::Editing, click(View, left,
                                WORDS("picks a piece; sets the clip plane; sets a corner of "
                                      "the scalpel, at the last one again: cuts"))),
      over(Over::Editing, drag(View, left, WORDS("draws the scalpel's outline"))),

      over(Over::Cube, click(Space, left, WORDS("looks from that side"))),
      over(Over::Tool,
           drag(Space, left, WORDS("moves the tool, if the mouse is the hand"), MoveTool)),
      over(Over::Tool,
           shift(drag(Space, left, WORDS("turns the tool, if the mouse is the hand"), TurnTool))),
      drag(Space, middle, WORDS("shifts the picture"), Pan),
      in(Look, drag(Space, left, WORDS("turns the picture"), Rotate)),
      in(Look, drag(Space, right, WORDS("comes nearer (up) or goes away (down)"), Zoom)),
      in(Look, wheel(Space, WORDS("comes nearer at the pointer"), Zoom)),
      in(Look, twice(Space, left, WORDS("on the surface: brings the tool there"), BringTool)),
      in(Hand, drag(Space, left, WORDS("moves the tool in the plane of the screen"), MoveTool)),
      in(Hand, shift(drag(Space, left, WORDS("turns the tool"), TurnTool))),
      in(Hand, drag(Space, right, WORDS("turns the picture"), Rotate)),
      in(Hand, wheel(Space, WORDS("moves the tool in depth"), PushTool)),
      in(Hand, ctrl(wheel(Space, WORDS("comes nearer at the pointer"), Zoom))),

      click(Slice, left, WORDS("moves the crosshair")),
      drag(Slice, left, WORDS("moves the crosshair")),
      twice(Slice, left, WORDS("brings the tool to the surface there"), BringTool),
      wheel(Slice, WORDS("goes through the slices")),
      ctrl(wheel(Slice, WORDS("comes nearer at the pointer"))),
      drag(Slice, middle, WORDS("shifts the picture")),
      shift(drag(Slice, left, WORDS("shifts the picture"))),
      drag(Slice, right, WORDS("brightness (up and down), contrast (left and right)")),
      click(Slice, right, WORDS("opens the choices for slices")),
      drag(Histogram, left, WORDS("moves the isovalue")),
      drag(Border, left, WORDS("moves it")),
      twice(Border, left, WORDS("gives the views their first sizes")),
      drag(ReplayBar, left, WORDS("moves through the time")),
  };
}

#undef WORDS

const std::vector<Binding>& table() {
  static const std::vector<Binding> kTable = allBindings();
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

/// Whether `inner` is a part of `outer`, or the same.
bool isPartOf(Where inner, Where outer) {
  return inner == outer || outer == Where::Anywhere ||
         (outer == Where::View && (inner == Where::Space || inner == Where::Slice));
}

bool overlap(const Binding& a, const Binding& b) {
  const bool places = isPartOf(a.place, b.place) || isPartOf(b.place, a.place);
  const bool modes = !a.mode || !b.mode || *a.mode == *b.mode;
  return places && modes && alike(a.gesture, b.gesture) && a.key == b.key &&
         a.modifiers == b.modifiers && a.over == b.over;
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
          binding.over == (tool ? Over::Tool : Over::Nothing))
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
    // as they are written on keyboards
    static const std::pair<const char*, const char*> kNames[] = {{"Esc", "Escape"},
                                                                 {"Del", "Delete"},
                                                                 {"Return", "Enter"},
                                                                 {"PgUp", "Page Up"},
                                                                 {"PgDown", "Page Down"}};
    QString key =
        QKeySequence(int(binding.modifiers) | binding.key).toString(QKeySequence::PortableText);
    for (const auto& [short_name, name] : kNames)
      if (key == QLatin1String(short_name)) key = QLatin1String(name);
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
              : binding.key == Qt::LeftButton           ? bindingWords("click")
                                                        : bindingWords("%1 click").arg(button);
  }
  if (binding.modifiers & Qt::ShiftModifier) trigger = bindingWords("Shift and %1").arg(trigger);
  if (binding.modifiers & Qt::ControlModifier) trigger = bindingWords("Ctrl and %1").arg(trigger);
  return trigger;
}

QString placeOf(const Binding& binding) {
  const auto place = [&] {
    switch (binding.place) {
      case Where::Anywhere:
        return bindingWords("anywhere");
      case Where::View:
        return bindingWords("any view");
      case Where::Slice:
        return bindingWords("slices");
      case Where::Marks:
        return bindingWords("list of marks");
      case Where::Histogram:
        return bindingWords("histogram");
      case Where::Border:
        return bindingWords("border between views");
      case Where::ReplayBar:
        return bindingWords("replay bar");
      case Where::Space:
        break;
    }
    return bindingWords("3-D view");
  }();
  switch (binding.over) {
    case Over::Tool:
      return bindingWords("%1, on the tool").arg(place);
    case Over::Cube:
      return bindingWords("%1, on the cube").arg(place);
    case Over::Handle:
      return bindingWords("%1, on a handle").arg(place);
    case Over::Measuring:
      return bindingWords("%1, while measuring").arg(place);
    case Over::Editing:
      return bindingWords("%1, with the tool of an edit").arg(place);
    case Over::Nothing:
      break;
  }
  if (!binding.mode) return place;
  return *binding.mode == MouseMode::Look ? bindingWords("%1, looking").arg(place)
                                          : bindingWords("%1, mouse as hand").arg(place);
}

QString wordsOf(const Binding& binding) { return bindingWords(binding.words); }

std::vector<ControlRow> controlRows() {
  std::vector<ControlRow> rows;
  for (const Binding& binding : table()) {
    ControlRow row{triggerOf(binding), placeOf(binding), wordsOf(binding),
                   isMouse(binding.gesture)};
    if (!rows.empty() && rows.back().place == row.place && rows.back().words == row.words &&
        rows.back().mouse == row.mouse)
      rows.back().triggers += QStringLiteral(", ") + row.triggers;
    else
      rows.push_back(std::move(row));
  }
  return rows;
}

QString controlsText() {
  QString text;
  for (const bool mouse_rows : {false, true}) {
    text += QStringLiteral("<table cellpadding=2>");
    for (const ControlRow& row : controlRows())
      if (row.mouse == mouse_rows)
        text += QStringLiteral("<tr><td><b>%1</b></td><td>%2</td><td>%3</td></tr>")
                    .arg(row.triggers, row.place, row.words);
    text += QStringLiteral("</table><p></p>");
  }
  return text;
}

}  // namespace ui
