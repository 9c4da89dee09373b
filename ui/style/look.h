// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QColor>

namespace ui::style {

// The look of the window: every colour, size and distance of its widgets. What is drawn in the
// views has its colours in scene_colours.h. A test finds colours that are written elsewhere, and
// another computes the contrast of every pair that is used.

/// What the user can choose. System: dark or light, as the desktop is.
enum class Theme { System, Dark, Light, HighContrast };

/// The colours of a theme.
struct Colours {
  // grounds, from the back to the front
  QColor ground, panel, control;
  QColor hover;   ///< of a control under the pointer
  QColor chosen;  ///< of a control that is on
  QColor line;    ///< between parts; not the only sign of anything
  QColor edge;    ///< around what can be used
  // words and marks
  QColor text, dim;
  QColor off;  ///< words of what cannot be used now
  QColor accent, on_accent;
  QColor on, attention, attention_ground;
  QColor stop;                  ///< the outline of the stop button, and marks of faults
  QColor stop_words;            ///< the same as words
  QColor stop_fill, on_stop;    ///< the stop button under the pointer, and the words on it
  QColor fault_ground;          ///< of the bar that tells of a fault
  QColor solid, empty;          ///< both sides of the isovalue in the histogram; a recorded force
  QColor force, torque;         ///< curves
  QColor note, setting, scene;  ///< marks on the replay's timeline; the rest are attention and stop
};

inline constexpr Colours kDark{
    .ground = {0x10, 0x12, 0x16},
    .panel = {0x17, 0x1a, 0x20},
    .control = {0x1f, 0x23, 0x2b},
    .hover = {0x2a, 0x30, 0x3b},
    .chosen = {0x1d, 0x33, 0x50},
    .line = {0x2b, 0x31, 0x3c},
    .edge = {0x6d, 0x77, 0x8a},
    .text = {0xe6, 0xe9, 0xee},
    .dim = {0x98, 0xa2, 0xb3},
    .off = {0x76, 0x80, 0x92},
    .accent = {0x4d, 0xa3, 0xff},
    .on_accent = {0x10, 0x12, 0x16},
    .on = {0x3f, 0xb2, 0x7f},
    .attention = {0xe0, 0xa6, 0x3a},
    .attention_ground = {0x2b, 0x24, 0x15},
    .stop = {0xd6, 0x45, 0x45},
    .stop_words = {0xff, 0x8d, 0x8d},
    .stop_fill = {0xc8, 0x3a, 0x3a},
    .on_stop = {0xff, 0xff, 0xff},
    .fault_ground = {0x3a, 0x1a, 0x1e},
    .solid = {0xd6, 0xc4, 0xa0},
    .empty = {0x55, 0x5d, 0x6b},
    .force = {0x4d, 0xa3, 0xff},
    .torque = {0x98, 0xa2, 0xb3},
    .note = {0x4d, 0xa3, 0xff},
    .setting = {0x3f, 0xb2, 0x7f},
    .scene = {0xb0, 0x8c, 0xf0},
};

inline constexpr Colours kLight{
    .ground = {0xf4, 0xf5, 0xf7},
    .panel = {0xff, 0xff, 0xff},
    .control = {0xec, 0xee, 0xf2},
    .hover = {0xe3, 0xe6, 0xec},
    .chosen = {0xe3, 0xef, 0xfc},
    .line = {0xd5, 0xd9, 0xe0},
    .edge = {0x7d, 0x87, 0x98},
    .text = {0x1b, 0x1f, 0x27},
    .dim = {0x56, 0x60, 0x72},
    .off = {0x7d, 0x87, 0x98},
    .accent = {0x0b, 0x66, 0xd0},
    .on_accent = {0xff, 0xff, 0xff},
    .on = {0x18, 0x74, 0x4b},
    .attention = {0x8a, 0x5a, 0x00},
    .attention_ground = {0xfb, 0xf1, 0xdc},
    .stop = {0xb3, 0x26, 0x1e},
    .stop_words = {0xb3, 0x26, 0x1e},
    .stop_fill = {0xb3, 0x26, 0x1e},
    .on_stop = {0xff, 0xff, 0xff},
    .fault_ground = {0xfb, 0xe4, 0xe2},
    .solid = {0x9a, 0x7b, 0x42},
    .empty = {0xb9, 0xc0, 0xcb},
    .force = {0x0b, 0x66, 0xd0},
    .torque = {0x56, 0x60, 0x72},
    .note = {0x0b, 0x66, 0xd0},
    .setting = {0x18, 0x74, 0x4b},
    .scene = {0x6b, 0x3f, 0xc0},
};

inline constexpr Colours kHighContrast{
    .ground = {0x00, 0x00, 0x00},
    .panel = {0x00, 0x00, 0x00},
    .control = {0x00, 0x00, 0x00},
    .hover = {0x26, 0x26, 0x26},
    .chosen = {0x00, 0x37, 0x5f},
    .line = {0xff, 0xff, 0xff},
    .edge = {0xff, 0xff, 0xff},
    .text = {0xff, 0xff, 0xff},
    .dim = {0xff, 0xff, 0xff},
    .off = {0xa0, 0xa0, 0xa0},
    .accent = {0x6e, 0xc1, 0xff},
    .on_accent = {0x00, 0x00, 0x00},
    .on = {0x5f, 0xf0, 0xab},
    .attention = {0xff, 0xd2, 0x4d},
    .attention_ground = {0x00, 0x00, 0x00},
    .stop = {0xff, 0x7b, 0x7b},
    .stop_words = {0xff, 0x9d, 0x9d},
    .stop_fill = {0xff, 0x7b, 0x7b},
    .on_stop = {0x00, 0x00, 0x00},
    .fault_ground = {0x00, 0x00, 0x00},
    .solid = {0xff, 0xe9, 0xb8},
    .empty = {0x80, 0x80, 0x80},
    .force = {0x6e, 0xc1, 0xff},
    .torque = {0xff, 0xff, 0xff},
    .note = {0x6e, 0xc1, 0xff},
    .setting = {0x5f, 0xf0, 0xab},
    .scene = {0xc9, 0xab, 0xff},
};

// distances [px]: steps of four
inline constexpr int kStep = 4;
inline constexpr int kGap = 8;    ///< between the parts of a section
inline constexpr int kEdge = 16;  ///< at the edge of a section
inline constexpr int kControlHeight = 28;
inline constexpr int kBarButton = 34;  ///< height of a button of the bar
inline constexpr int kIcon = 20;       ///< of the bar and the rail
inline constexpr int kSmallIcon = 16;
inline constexpr double kCorner = 6.0, kLargeCorner = 8.0;
inline constexpr int kPanelWidth = 300;  ///< of the panels at first

// sizes of type [px]; the desktop's own size counts where it is larger
inline constexpr int kBody = 13, kSmall = 11, kSection = 12, kFigure = 18, kForce = 30;

}  // namespace ui::style
