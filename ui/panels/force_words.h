// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QString>

#include "haptics/core/trouble.h"
#include "haptics/snapshot.h"
#include "ui/controls/state_chip.h"

namespace ui {

/// The state of the force in a word or two.
QString nameOf(haptics::ForceState state);
/// A sentence on its meaning and what to do, or empty.
QString sentenceFor(haptics::ForceState state, haptics::ForceReason reason,
                    haptics::Trouble trouble);

/// What comes of a computed force.
enum class Feel {
  Shown,   ///< the mouse or a simulated hand: it is shown
  Felt,    ///< a device with motors
  Nothing  ///< a device without
};

/// The one state of the force, as every part of the window says it.
struct ForceSaid {
  Mark mark = Mark::None;
  QString words = {};
};
ForceSaid stateOf(const haptics::Snapshot& snapshot, Feel feel);
/// The same of a loop that runs.
ForceSaid stateOf(haptics::ForceState state, Feel feel);
/// Whether a force is being shown or felt, or may begin by itself.
bool isForce(const haptics::Snapshot& snapshot);

}  // namespace ui
