// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QString>

#include "haptics/core/trouble.h"
#include "haptics/snapshot.h"

namespace ui {

/// The state of the force in a word or two.
QString nameOf(haptics::ForceState state);
/// A sentence on its meaning and what to do, or empty.
QString sentenceFor(haptics::ForceState state, haptics::ForceReason reason,
                    haptics::Trouble trouble);
/// The background colour of the state, for white text. Never red: red is the stop button's.
QString colourOf(haptics::ForceState state);

}  // namespace ui
