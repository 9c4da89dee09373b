// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QKeyCombination>
#include <QKeySequence>
#include <QMap>
#include <QObject>
#include <QString>
#include <QStringList>
#include <functional>
#include <optional>
#include <span>
#include <vector>

class QAction;
class QKeyEvent;

namespace ui {

/// Where a key is pressed or the mouse is.
enum class Where {
  Anywhere,
  View,   ///< the 3-D view and the slices
  Space,  ///< the 3-D view
  Slice,
  Marks,  ///< the list of measures and marks
  Structures,
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
  // the program
  OpenFile,
  OpenFolder,
  SaveView,
  SavePicture,
  CopyPicture,
  Undo,
  Redo,
  ShowPreferences,
  Quit,
  ShowHelp,
  ShowControls,
  NextView,
  ViewAlone,
  SetMark,  ///< in a recording
  // the picture of a view
  Rotate,
  Pan,
  Zoom,
  Nearer,
  Farther,
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
  BeforeAfter,
  // slices
  NextSlice,
  SliceBefore,
  TenSlicesOn,
  TenSlicesBack,
  FirstSlice,
  LastSlice,
  FitBody,
  Grey,  ///< brightness and contrast
  TypeGrey,
  // the usual grey windows, in the order of hounsfieldPresets()
  GreySoftTissue,
  GreyBone,
  GreyLung,
  GreyBrain,
  GreyMediastinum,
  GreyTemporalBone,
  GreyAtFirst,
  MoveCross,
  SliceMenu,
  // measures, marks and edits
  PlaceDistance,
  PlaceAngle,
  PlacePoint,
  PlaceNote,
  SetPlace,
  TakePlaceBack,
  SetPlaceOfEdit,
  TakeCornerBack,
  GoToMark,
  RenameMark,
  DeleteMark,
  GoToStructure,
  RenameStructure,
  ShowStructure,
  // the border between two views
  MoveBorder,
  FirstSizes,
  // the replay
  PlayPause,
  TickBack,
  TickForward,
  ToBegin,
  ToEnd,
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
  HoldToRun,
  Cut
};

/// One thing that a key or the mouse does. Views look up what to do here, menus take their keys
/// from here, and Help and tooltips say what is written here.
struct Binding {
  Action action = Action::Elsewhere;
  Where place = Where::Anywhere;
  std::optional<MouseMode> mode = {};  ///< none: in every mode
  Gesture gesture = Gesture::Key;
  int key = 0;  ///< Qt::Key, or Qt::MouseButton of a click or drag; 0 for the wheel
  Qt::KeyboardModifiers modifiers = Qt::NoModifier;
  Over over = Over::Nothing;
  const char* words = "";
  /// The name under which another key is kept. Empty: the key stays what it is, as Escape and
  /// Space.
  const char* name = "";
  QKeyCombination at_first = Qt::Key_unknown;  ///< the key, before the user changed it
};

/// All bindings, with the user's own keys.
std::span<const Binding> bindings();

/// What the mouse does there; none: nothing. A gesture with modifiers that no binding has counts as
/// the same without. `on_tool`: the mouse is on the tool. Keys are found too, as they are.
std::optional<Action> actionOf(Where place, MouseMode mode, Gesture gesture, int key,
                               Qt::KeyboardModifiers modifiers, bool on_tool = false);

/// What a key means there, by the user's own keys; null: nothing. Where one action has an arrow key
/// for each direction, at_first tells which. It stays valid while the program runs.
const Binding* meaningOf(Where place, const QKeyEvent& event, Gesture gesture = Gesture::Key,
                         Over over = Over::Nothing, MouseMode mode = MouseMode::Look);
/// The direction of an arrow key, in widget coordinates; (0, 0) of every other key.
QPoint wayOf(const Binding& binding);

/// Pairs that a key or the mouse could mean at once, in words; empty: there are none.
QStringList conflictsIn(std::span<const Binding> bindings);

/// The key of an action in words; empty if it has none. `place`: where, if the action has another
/// key elsewhere.
QString keyOf(Action action, std::optional<Where> place = {});
/// The keys of an action, as menus take them.
QList<QKeySequence> shortcutsOf(Action action);
/// A tooltip: the sentence with the key behind it, "Quits (Ctrl+Q)".
QString withKey(const QString& sentence, Action action);

/// Keys that the user chose, by the name of the binding, as portable text: "take_tool": "B".
using OwnKeys = QMap<QString, QString>;

/// Those that differ from the keys at first.
OwnKeys ownKeys();
/// Takes these instead of all that were there. What is not a key, names no binding, is not allowed,
/// or means two things keeps the key that it has at first.
void setOwnKeys(const OwnKeys& keys);
/// Gives a binding another key. A sentence on why it may not have it; empty: it has it.
QString changeKey(const QString& name, QKeyCombination key);
/// The key of a key event, as changeKey() and the table have it: Latin, without what a keypad adds,
/// and without the Shift that a sign needs on some keyboards.
QKeyCombination plainKey(const QKeyEvent& event);

/// Says that keys have changed; whenKeysChange() listens.
class KeyTeller : public QObject {
  Q_OBJECT
 signals:
  void changed();
};

/// Gives an entry of a menu the keys of an action, and a tooltip that ends with the first of them.
/// Empty: its own tooltip stays.
void giveKeys(QAction& entry, Action action, const QString& sentence = {});
/// Shows the key that a view dispatches behind the text of an entry, as menus do, and in its
/// tooltip.
void showKey(QAction& entry, Action action, const QString& sentence = {});

/// Calls `tell` now, and whenever keys have changed until `context` goes.
void whenKeysChange(QObject& context, const std::function<void()>& tell);

/// Key or mouse gesture in words, as Help writes it: "Ctrl and wheel".
QString triggerOf(const Binding& binding);
/// Where it works: "3-D view".
QString placeOf(const Binding& binding);
QString wordsOf(const Binding& binding);

/// One row of Help. Keys of the same place and words share it.
struct ControlRow {
  QString triggers, place, words;
  bool mouse = false;
};
std::vector<ControlRow> controlRows();

/// All of it for Help, as rich text.
QString controlsText();

}  // namespace ui
