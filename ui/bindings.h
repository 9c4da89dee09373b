// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QKeySequence>
#include <QString>
#include <QStringList>
#include <optional>
#include <span>
#include <vector>

namespace ui {

/// Where a key is pressed or the mouse is.
enum class Where {
  Anywhere,
  View,   ///< the 3-D view and the slices
  Space,  ///< the 3-D view
  Slice,
  Marks,  ///< the list of measures and marks
  Histogram,
  Border,  ///< between two views
  ReplayBar
};

/// What takes a gesture of the mouse before the view does.
enum class Over { Nothing, Tool, Cube, Handle, Measuring, Editing };

/// What the mouse does in the 3-D view.
enum class MouseMode {
  Look,  ///< the camera
  Hand   ///< the mouse holds the tool
};

enum class Gesture { Key, HeldKey, Click, DoubleClick, Drag, Wheel };

enum class Action {
  Elsewhere,  ///< what others dispatch: here for Help and against conflicts
  // the camera of the 3-D view
  Rotate,
  Pan,
  Zoom,
  ShowEverything,
  LookFromTool,
  LookAlongTool,
  ViewAnterior,
  ViewPosterior,
  ViewLeft,
  ViewRight,
  ViewSuperior,
  ViewInferior,
  ParallelProjection,
  // the tool
  TakeTool,  ///< the mode in which the mouse is the hand, on or off
  MoveTool,
  TurnTool,
  PushTool,
  BringTool,
  ToolToCross,
  CrossToTool,
  // the force
  ForceOff,
  Clutch,
  HoldToRun
};

/// One thing that a key or the mouse does. Views look up what to do here; Help and the README say
/// what is written here, and a test holds the menus to it.
struct Binding {
  Action action = Action::Elsewhere;
  Where place = Where::Anywhere;
  std::optional<MouseMode> mode = {};  ///< none: in every mode
  Gesture gesture = Gesture::Key;
  int key = 0;  ///< Qt::Key, or Qt::MouseButton of a click or drag; 0 for the wheel
  Qt::KeyboardModifiers modifiers = Qt::NoModifier;
  Over over = Over::Nothing;
  const char* words = "";
};

/// All bindings.
std::span<const Binding> bindings();

/// What to do; none: nothing. A mouse gesture with modifiers that no binding has counts as the same
/// without. `on_tool`: the mouse is on the tool.
std::optional<Action> actionOf(Where place, MouseMode mode, Gesture gesture, int key,
                               Qt::KeyboardModifiers modifiers, bool on_tool = false);

/// Pairs that a key or the mouse could mean at once, in words; empty: there are none.
QStringList conflictsIn(std::span<const Binding> bindings);

/// The key of an action as menus write it; empty if it has none.
QString keyOf(Action action);

/// Key or mouse gesture in words, as Help and README write it: "Ctrl and wheel".
QString triggerOf(const Binding& binding);
/// Where it works: "3-D view".
QString placeOf(const Binding& binding);
QString wordsOf(const Binding& binding);

/// What Help and README say in one row. Keys of the same place and words share it.
struct ControlRow {
  QString triggers, place, words;
  bool mouse = false;
};
std::vector<ControlRow> controlRows();

/// All of it for Help, as rich text.
QString controlsText();

}  // namespace ui
