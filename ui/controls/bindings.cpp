// SPDX-License-Identifier: BSD-3-Clause
#include "ui/controls/bindings.h"

#include <QAction>
#include <QCoreApplication>
#include <QKeyEvent>
#include <algorithm>
#include <utility>
#include <vector>

#include "ui/controls/latin_key.h"

namespace ui {
namespace {

#define WORDS(text) QT_TRANSLATE_NOOP("ui::bindings", text)

/// Lines of the table.
namespace binding_lines {

Binding key(Where place, QKeyCombination keys, const char* words, Action action = {},
            const char* name = "") {
  return {.action = action,
          .place = place,
          .key = keys.key(),
          .modifiers = keys.keyboardModifiers(),
          .words = words,
          .name = name,
          .at_first = keys};
}
Binding held(Where place, Qt::Key held_key, const char* words, Action action, const char* name) {
  Binding binding = key(place, held_key, words, action, name);
  binding.gesture = Gesture::HeldKey;
  return binding;
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

/// Lines that follow one another with the same place and words are one row of Help.
std::vector<Binding> allBindings() {
  using enum Action;
  using enum MouseMode;
  using enum Where;
  using namespace Qt;
  using namespace binding_lines;
  constexpr auto left = LeftButton, middle = MiddleButton, right = RightButton;
  return {
      key(Anywhere, CTRL | Key_O, WORDS("opens a file"), OpenFile, "open_file"),
      key(Anywhere, CTRL | SHIFT | Key_O, WORDS("opens a folder"), OpenFolder, "open_folder"),
      key(Anywhere, CTRL | Key_S, WORDS("saves the view"), SaveView, "save_view"),
      key(Anywhere, CTRL | SHIFT | Key_S, WORDS("saves a picture of a view or the window"),
          SavePicture, "save_picture"),
      key(Anywhere, CTRL | SHIFT | Key_C, WORDS("copies a picture of the 3-D view"), CopyPicture,
          "copy_picture"),
      key(Anywhere, CTRL | Key_Z, WORDS("takes the last edit back"), Undo, "undo"),
      key(Anywhere, CTRL | SHIFT | Key_Z, WORDS("makes it again"), Redo, "redo"),
      key(Anywhere, CTRL | Key_Y, WORDS("makes it again"), Redo, "redo_too"),
      key(Anywhere, CTRL | Key_Comma, WORDS("opens the preferences"), ShowPreferences,
          "preferences"),
      key(Anywhere, CTRL | Key_Q, WORDS("quits"), Quit, "quit"),
      key(Anywhere, Key_Escape,
          WORDS("force off; closes what is open, without motors at first that alone")),
      key(Anywhere, Key_F1, WORDS("shows the help for the focused control"), ShowHelp, "help"),
      key(Anywhere, SHIFT | Key_F1, WORDS("shows all controls"), ShowControls, "controls"),
      key(Anywhere, Key_F6, WORDS("selects the next view"), NextView, "next_view"),
      key(Anywhere, CTRL | Key_B, WORDS("shows the unedited scan beside what is left, or hides it"),
          BeforeAfter, "before_after"),
      key(Anywhere, Key_M, WORDS("while recording: sets a mark"), SetMark, "mark"),
      key(Anywhere, Key_G, WORDS("takes the tool with the mouse, or lets it go"), TakeTool,
          "take_tool"),

      key(View, Key_F, WORDS("shows a view alone, or all again"), ViewAlone, "view_alone"),
      key(View, Key_D, WORDS("places a distance; again: ends it"), PlaceDistance, "distance"),
      key(View, Key_A, WORDS("places an angle; again: ends it"), PlaceAngle, "angle"),
      key(View, Key_V, WORDS("places a point with its value; again: ends it"), PlacePoint, "point"),
      key(View, Key_N, WORDS("places a note; again: ends it"), PlaceNote, "note"),
      key(View, Key_Backspace, WORDS("while placing: takes the last place back"), TakePlaceBack,
          "place_back"),
      key(View, Key_Delete, WORDS("deletes the chosen mark"), DeleteMark, "delete_mark"),

      key(Space, Key_Space, WORDS("force off"), ForceOff),
      key(Space, Key_J, WORDS("brings the tool to the crosshair"), ToolToCross, "tool_to_cross"),
      key(Space, Key_K, WORDS("brings the crosshair to the tool"), CrossToTool, "cross_to_tool"),
      key(Space, Key_L, WORDS("looks along the tool"), LookAlongTool, "look_along_tool"),
      key(Space, Key_T, WORDS("shows everything from the tool's side"), LookFromTool,
          "look_from_tool"),
      key(Space, Key_R, WORDS("shows everything, from the front"), ShowEverything,
          "show_everything"),
      key(Space, Key_1, WORDS("from the front (A)"), ViewAnterior, "view_anterior"),
      key(Space, Key_2, WORDS("from behind (P)"), ViewPosterior, "view_posterior"),
      key(Space, Key_3, WORDS("from the patient's left (L)"), ViewLeft, "view_left"),
      key(Space, Key_4, WORDS("from the patient's right (R)"), ViewRight, "view_right"),
      key(Space, Key_5, WORDS("from above (S)"), ViewSuperior, "view_superior"),
      key(Space, Key_6, WORDS("from below (I)"), ViewInferior, "view_inferior"),
      key(Space, Key_P, WORDS("parallel projection on or off"), ParallelProjection, "parallel"),
      in(Look, key(Space, Key_Left, WORDS("turns the picture"), Rotate, "turn_left")),
      in(Look, key(Space, Key_Right, WORDS("turns the picture"), Rotate, "turn_right")),
      in(Look, key(Space, Key_Up, WORDS("turns the picture"), Rotate, "turn_up")),
      in(Look, key(Space, Key_Down, WORDS("turns the picture"), Rotate, "turn_down")),
      in(Look, key(Space, SHIFT | Key_Left, WORDS("shifts the picture"), Pan, "shift_left")),
      in(Look, key(Space, SHIFT | Key_Right, WORDS("shifts the picture"), Pan, "shift_right")),
      in(Look, key(Space, SHIFT | Key_Up, WORDS("shifts the picture"), Pan, "shift_up")),
      in(Look, key(Space, SHIFT | Key_Down, WORDS("shifts the picture"), Pan, "shift_down")),
      in(Hand, key(Space, Key_Left, WORDS("moves the tool by 1 mm; Page Up: deeper"), MoveTool,
                   "tool_left")),
      in(Hand, key(Space, Key_Right, WORDS("moves the tool by 1 mm; Page Up: deeper"), MoveTool,
                   "tool_right")),
      in(Hand,
         key(Space, Key_Up, WORDS("moves the tool by 1 mm; Page Up: deeper"), MoveTool, "tool_up")),
      in(Hand, key(Space, Key_Down, WORDS("moves the tool by 1 mm; Page Up: deeper"), MoveTool,
                   "tool_down")),
      in(Hand, key(Space, Key_PageUp, WORDS("moves the tool by 1 mm; Page Up: deeper"), PushTool,
                   "tool_page_up")),
      in(Hand, key(Space, Key_PageDown, WORDS("moves the tool by 1 mm; Page Up: deeper"), PushTool,
                   "tool_page_down")),
      in(Hand, key(Space, CTRL | Key_Left, WORDS("moves the tool by 0.1 mm"), MoveTool,
                   "tool_fine_left")),
      in(Hand, key(Space, CTRL | Key_Right, WORDS("moves the tool by 0.1 mm"), MoveTool,
                   "tool_fine_right")),
      in(Hand,
         key(Space, CTRL | Key_Up, WORDS("moves the tool by 0.1 mm"), MoveTool, "tool_fine_up")),
      in(Hand, key(Space, CTRL | Key_Down, WORDS("moves the tool by 0.1 mm"), MoveTool,
                   "tool_fine_down")),
      in(Hand, key(Space, CTRL | Key_PageUp, WORDS("moves the tool by 0.1 mm"), PushTool,
                   "tool_fine_page_up")),
      in(Hand, key(Space, CTRL | Key_PageDown, WORDS("moves the tool by 0.1 mm"), PushTool,
                   "tool_fine_page_down")),
      in(Hand, key(Space, SHIFT | Key_Left, WORDS("turns the tool by 5 degrees"), TurnTool,
                   "tool_turn_left")),
      in(Hand, key(Space, SHIFT | Key_Right, WORDS("turns the tool by 5 degrees"), TurnTool,
                   "tool_turn_right")),
      in(Hand, key(Space, SHIFT | Key_Up, WORDS("turns the tool by 5 degrees"), TurnTool,
                   "tool_turn_up")),
      in(Hand, key(Space, SHIFT | Key_Down, WORDS("turns the tool by 5 degrees"), TurnTool,
                   "tool_turn_down")),
      in(Hand, key(Space, SHIFT | Key_PageUp, WORDS("turns the tool by 5 degrees"), TurnTool,
                   "tool_turn_page_up")),
      in(Hand, key(Space, SHIFT | Key_PageDown, WORDS("turns the tool by 5 degrees"), TurnTool,
                   "tool_turn_page_down")),
      key(Space, Key_Plus, WORDS("zooms in at the pointer"), Nearer, "nearer"),
      key(Space, Key_Equal, WORDS("zooms in at the pointer"), Nearer, "nearer_too"),
      key(Space, Key_Minus, WORDS("zooms out at the pointer"), Farther, "farther"),
      held(Space, Key_C, WORDS("clutch; released when the view loses the focus"), Clutch, "clutch"),
      held(Space, Key_H, WORDS("hold-to-run; released when the view loses the focus"), HoldToRun,
           "hold_to_run"),
      held(Space, Key_X, WORDS("turns the burr, which cuts what it is pressed against"), Cut,
           "cut"),

      key(Slice, Key_Up, WORDS("next slice: towards S, P or L, with the tool deeper"), NextSlice,
          "next_slice"),
      key(Slice, Key_Down, WORDS("slice before"), SliceBefore, "slice_before"),
      key(Slice, Key_PageUp, WORDS("ten slices on"), TenSlicesOn, "ten_slices_on"),
      key(Slice, Key_PageDown, WORDS("ten slices back"), TenSlicesBack, "ten_slices_back"),
      key(Slice, Key_Home, WORDS("first slice"), FirstSlice, "first_slice"),
      key(Slice, Key_End, WORDS("last slice"), LastSlice, "last_slice"),
      key(Slice, Key_Plus, WORDS("zooms in at the pointer"), Nearer, "slice_nearer"),
      key(Slice, Key_Equal, WORDS("zooms in at the pointer"), Nearer, "slice_nearer_too"),
      key(Slice, Key_Minus, WORDS("zooms out at the pointer"), Farther, "slice_farther"),
      key(Slice, Key_R, WORDS("shows the whole slice"), ShowEverything, "whole_slice"),
      key(Slice, Key_B, WORDS("fits the body into the view"), FitBody, "fit_body"),
      key(Slice, Key_1, WORDS("grey window: soft tissue"), GreySoftTissue, "grey_soft_tissue"),
      key(Slice, Key_2, WORDS("grey window: bone"), GreyBone, "grey_bone"),
      key(Slice, Key_3, WORDS("grey window: lung"), GreyLung, "grey_lung"),
      key(Slice, Key_4, WORDS("grey window: brain"), GreyBrain, "grey_brain"),
      key(Slice, Key_5, WORDS("grey window: mediastinum"), GreyMediastinum, "grey_mediastinum"),
      key(Slice, Key_6, WORDS("grey window: temporal bone"), GreyTemporalBone,
          "grey_temporal_bone"),
      key(Slice, Key_0, WORDS("grey window: as at first"), GreyAtFirst, "grey_at_first"),
      key(Slice, Key_W, WORDS("takes level and width as numbers"), TypeGrey, "type_grey"),
      key(Slice, SHIFT | Key_Up, WORDS("shifts the picture"), Pan, "slice_shift_up"),
      key(Slice, SHIFT | Key_Down, WORDS("shifts the picture"), Pan, "slice_shift_down"),
      key(Slice, SHIFT | Key_Left, WORDS("shifts the picture"), Pan, "slice_shift_left"),
      key(Slice, SHIFT | Key_Right, WORDS("shifts the picture"), Pan, "slice_shift_right"),
      key(Slice, CTRL | Key_Up, WORDS("changes the brightness"), Grey, "grey_up"),
      key(Slice, CTRL | Key_Down, WORDS("changes the brightness"), Grey, "grey_down"),
      key(Slice, CTRL | Key_Left, WORDS("changes the contrast"), Grey, "grey_left"),
      key(Slice, CTRL | Key_Right, WORDS("changes the contrast"), Grey, "grey_right"),
      key(Slice, ALT | Key_Up, WORDS("moves the crosshair by a voxel"), MoveCross, "cross_up"),
      key(Slice, ALT | Key_Down, WORDS("moves the crosshair by a voxel"), MoveCross, "cross_down"),
      key(Slice, ALT | Key_Left, WORDS("moves the crosshair by a voxel"), MoveCross, "cross_left"),
      key(Slice, ALT | Key_Right, WORDS("moves the crosshair by a voxel"), MoveCross,
          "cross_right"),
      key(Slice, Key_J, WORDS("brings the tool to the crosshair"), ToolToCross,
          "slice_tool_to_cross"),
      key(Slice, Key_K, WORDS("brings the crosshair to the tool"), CrossToTool,
          "slice_cross_to_tool"),
      key(Slice, Key_Menu, WORDS("opens the choices for slices"), SliceMenu, "slice_menu"),

      over(Over::Measuring,
           key(View, Key_Return, WORDS("sets a place: at the crosshair, in 3-D in the middle"),
               SetPlace, "set_place")),
      over(Over::Editing, key(View, Key_Return,
                              WORDS("picks a piece, sets the clip plane or a corner of the "
                                    "scalpel: at the crosshair, in 3-D in the middle"),
                              SetPlaceOfEdit, "set_place_of_edit")),
      over(Over::Editing, key(View, Key_Backspace, WORDS("takes the scalpel's last corner back"),
                              TakeCornerBack, "corner_back")),

      key(Marks, Key_Return, WORDS("shows the place; again: its next one"), GoToMark, "go_to_mark"),
      key(Marks, Key_F2, WORDS("renames the mark, or edits the note"), RenameMark, "rename_mark"),
      key(Marks, Key_Delete, WORDS("deletes the mark"), DeleteMark, "list_delete_mark"),
      key(Structures, Key_Return, WORDS("turns the views to the structure"), GoToStructure,
          "go_to_structure"),
      key(Structures, Key_F2, WORDS("renames the structure"), RenameStructure, "rename_structure"),
      key(Structures, Key_Space, WORDS("shows the structure, or hides it"), ShowStructure),
      key(Border, Key_Left, WORDS("moves it"), MoveBorder, "border_left"),
      key(Border, Key_Right, WORDS("moves it"), MoveBorder, "border_right"),
      key(Border, Key_Up, WORDS("moves it"), MoveBorder, "border_up"),
      key(Border, Key_Down, WORDS("moves it"), MoveBorder, "border_down"),
      key(Border, Key_Home, WORDS("gives the views their first sizes"), FirstSizes, "first_sizes"),
      key(ReplayBar, Key_Space, WORDS("plays and pauses"), PlayPause),
      key(ReplayBar, Key_Left, WORDS("one tick back"), TickBack, "tick_back"),
      key(ReplayBar, Key_Right, WORDS("one tick forward"), TickForward, "tick_forward"),
      key(ReplayBar, Key_Home, WORDS("to the beginning"), ToBegin, "to_begin"),
      key(ReplayBar, Key_End, WORDS("to the end"), ToEnd, "to_end"),

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
      in(Look, drag(Space, right, WORDS("zooms in (up) or out (down)"), Zoom)),
      in(Look, wheel(Space, WORDS("zooms in at the pointer"), Zoom)),
      twice(Space, left, WORDS("on the surface: brings the tool there"), BringTool),
      in(Hand, drag(Space, left, WORDS("moves the tool in the plane of the screen"), MoveTool)),
      in(Hand, shift(drag(Space, left, WORDS("turns the tool"), TurnTool))),
      in(Hand, drag(Space, right, WORDS("turns the picture"), Rotate)),
      in(Hand, wheel(Space, WORDS("moves the tool in depth"), PushTool)),
      in(Hand, ctrl(wheel(Space, WORDS("zooms in at the pointer"), Zoom))),

      click(Slice, left, WORDS("moves the crosshair")),
      drag(Slice, left, WORDS("moves the crosshair")),
      twice(Slice, left, WORDS("brings the tool to the surface there"), BringTool),
      wheel(Slice, WORDS("scrolls through the slices")),
      ctrl(wheel(Slice, WORDS("zooms in at the pointer"))),
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

std::vector<Binding>& table() {
  static std::vector<Binding> all = allBindings();
  return all;
}

KeyTeller& keyTeller() {
  static KeyTeller teller;
  return teller;
}

void tellKeys() { emit keyTeller().changed(); }

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

/// Letters, digits and signs, as Qt numbers them.
bool isPrinted(int key) { return key > Qt::Key_Space && key < 0x01000000; }

QKeyCombination plainKey(int key, Qt::KeyboardModifiers modifiers) {
  modifiers &= ~Qt::KeyboardModifiers{Qt::KeypadModifier | Qt::GroupSwitchModifier};
  if (key == Qt::Key_Enter) key = Qt::Key_Return;
  // many keyboards write the plus, and some the digits, with Shift
  if (isPrinted(key) && !QChar(static_cast<char16_t>(std::min(key, 0xffff))).isLetter())
    modifiers &= ~Qt::KeyboardModifiers{Qt::ShiftModifier};
  return QKeyCombination(modifiers, static_cast<Qt::Key>(key));
}

QString nameOfKey(QKeyCombination keys) {
  // as they are written on keyboards
  static constexpr std::pair<Qt::Key, const char*> kNames[] = {
      {Qt::Key_Escape, WORDS("Escape")},
      {Qt::Key_Delete, WORDS("Delete")},
      {Qt::Key_Return, WORDS("Enter")},
      {Qt::Key_PageUp, WORDS("Page Up")},
      {Qt::Key_PageDown, WORDS("Page Down")}};
  for (const auto& [key, name] : kNames)
    if (keys.key() == key) {
      const QString held = QKeySequence(keys.keyboardModifiers() | Qt::Key_A)
                               .toString(QKeySequence::NativeText)
                               .chopped(1);
      return held + bindingWords(name);
    }
  return QKeySequence(keys).toString(QKeySequence::NativeText);
}

#undef WORDS

QKeyCombination keysOf(const Binding& binding) {
  return QKeyCombination(binding.modifiers, static_cast<Qt::Key>(binding.key));
}

void give(Binding& binding, QKeyCombination keys) {
  binding.key = keys.key();
  binding.modifiers = keys.keyboardModifiers();
}

/// Why a binding may not have a key, whatever others have; empty: it may.
QString refusalOf(const Binding& binding, QKeyCombination keys) {
  const int key = keys.key();
  const Qt::KeyboardModifiers modifiers = keys.keyboardModifiers();
  const bool strong = modifiers & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier);
  if (keys == binding.at_first) return {};
  if (key == Qt::Key_Escape || key == Qt::Key_Space)
    return bindingWords("Escape and Space stop the force and cannot be changed.");
  if (key == Qt::Key_Tab || key == Qt::Key_Backtab)
    return bindingWords("Tab selects the next control and cannot be changed.");
  if (modifiers == Qt::AltModifier && isPrinted(key))
    return bindingWords("Alt with a letter opens menus; choose another key.");
  if (binding.gesture == Gesture::HeldKey && modifiers != Qt::NoModifier)
    return bindingWords("A function that works while a key is held needs a single key.");
  static constexpr int kOfControls[] = {Qt::Key_Left,      Qt::Key_Right,    Qt::Key_Up,
                                        Qt::Key_Down,      Qt::Key_Home,     Qt::Key_End,
                                        Qt::Key_PageUp,    Qt::Key_PageDown, Qt::Key_Return,
                                        Qt::Key_Backspace, Qt::Key_Delete};
  if (binding.place == Where::Anywhere && !strong &&
      std::find(std::begin(kOfControls), std::end(kOfControls), key) != std::end(kOfControls))
    return bindingWords("Fields and lists need this key; choose one with Ctrl.");
  return {};
}

/// The first other binding that the key of this one could mean as well; null: none.
const Binding* rivalOf(const Binding& binding, std::span<const Binding> all) {
  for (const Binding& other : all)
    if (&other != &binding && overlap(binding, other)) return &other;
  return nullptr;
}

/// A key that is stored; none: it is no single key.
std::optional<QKeyCombination> storedKey(const QString& text) {
  const QKeySequence sequence(text, QKeySequence::PortableText);
  if (sequence.count() != 1 || sequence[0].key() == Qt::Key_unknown ||
      sequence[0].key() < Qt::Key_Space)
    return {};
  const QKeyCombination key = plainKey(sequence[0].key(), sequence[0].keyboardModifiers());
  return key;
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

const Binding* meaningOf(Where place, const QKeyEvent& event, Gesture gesture, Over over,
                         MouseMode mode) {
  // a user may have chosen a letter of another script
  for (const QKeyCombination pressed : {plainKey(event.key(), event.modifiers()), plainKey(event)})
    for (const Binding& binding : table())
      if (binding.place == place && (!binding.mode || *binding.mode == mode) &&
          binding.gesture == gesture && binding.over == over && keysOf(binding) == pressed)
        return &binding;
  return nullptr;
}

QPoint wayOf(const Binding& binding) {
  const int key = binding.at_first.key();
  return {int(key == Qt::Key_Right) - int(key == Qt::Key_Left),
          int(key == Qt::Key_Down) - int(key == Qt::Key_Up)};
}

QString keyOf(Action action, std::optional<Where> place) {
  for (const Binding& binding : table())
    if (binding.action == action && !isMouse(binding.gesture) &&
        (!place || binding.place == *place))
      return nameOfKey(keysOf(binding));
  return {};
}

QList<QKeySequence> shortcutsOf(Action action) {
  QList<QKeySequence> keys;
  for (const Binding& binding : table())
    if (binding.action == action && binding.gesture == Gesture::Key) keys << keysOf(binding);
  return keys;
}

QString withKey(const QString& sentence, Action action) {
  const QString key = keyOf(action);
  return key.isEmpty() ? sentence : bindingWords("%1 (%2)").arg(sentence, key);
}

OwnKeys ownKeys() {
  OwnKeys own;
  for (const Binding& binding : table())
    if (*binding.name != '\0' && keysOf(binding) != binding.at_first)
      own[QString::fromLatin1(binding.name)] =
          QKeySequence(keysOf(binding)).toString(QKeySequence::PortableText);
  return own;
}

void setOwnKeys(const OwnKeys& keys) {
  std::vector<Binding>& all = table();
  for (Binding& binding : all) {
    if (*binding.name == '\0') continue;
    give(binding, binding.at_first);
    const auto own = keys.constFind(QString::fromLatin1(binding.name));
    if (own == keys.constEnd()) continue;
    const auto key = storedKey(*own);
    if (key && refusalOf(binding, *key).isEmpty()) give(binding, *key);
  }
  // each turn takes one key back, and those at first do not conflict
  const auto conflicting = [&] {
    return std::find_if(all.begin(), all.end(), [&](const Binding& binding) {
      return *binding.name != '\0' && keysOf(binding) != binding.at_first &&
             rivalOf(binding, all) != nullptr;
    });
  };
  for (auto found = conflicting(); found != all.end(); found = conflicting())
    give(*found, found->at_first);
  tellKeys();
}

QString changeKey(const QString& name, QKeyCombination key) {
  std::vector<Binding>& all = table();
  const auto found = std::find_if(all.begin(), all.end(), [&](const Binding& binding) {
    return !name.isEmpty() && name == QLatin1String(binding.name);
  });
  if (found == all.end()) return bindingWords("This key cannot be changed.");
  const QKeyCombination plain = plainKey(key.key(), key.keyboardModifiers());
  if (const QString refusal = refusalOf(*found, plain); !refusal.isEmpty()) return refusal;
  const QKeyCombination before = keysOf(*found);
  give(*found, plain);
  if (const Binding* rival = rivalOf(*found, all)) {
    give(*found, before);
    return bindingWords("%1 is taken: %2, %3. Give that another key first.")
        .arg(nameOfKey(plain), placeOf(*rival), wordsOf(*rival));
  }
  tellKeys();
  return {};
}

QKeyCombination plainKey(const QKeyEvent& event) {
  return plainKey(latinKey(event), event.modifiers());
}

void giveKeys(QAction& entry, Action action, const QString& sentence) {
  whenKeysChange(entry, [&entry, action, sentence] {
    entry.setShortcuts(shortcutsOf(action));
    if (!sentence.isEmpty()) entry.setToolTip(withKey(sentence, action));
  });
}

void showKey(QAction& entry, Action action, const QString& sentence) {
  const QString text = entry.text();
  whenKeysChange(entry, [&entry, action, text, sentence] {
    entry.setText(text + '\t' + keyOf(action));
    if (!sentence.isEmpty()) entry.setToolTip(withKey(sentence, action));
  });
}

void whenKeysChange(QObject& context, const std::function<void()>& tell) {
  tell();
  QObject::connect(&keyTeller(), &KeyTeller::changed, &context, tell);
}

QString triggerOf(const Binding& binding) {
  if (!isMouse(binding.gesture)) {
    const QString key = nameOfKey(keysOf(binding));
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
      case Where::Structures:
        return bindingWords("list of structures");
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
                                          : bindingWords("%1, while the mouse has the tool (%2)")
                                                .arg(place, keyOf(Action::TakeTool));
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
