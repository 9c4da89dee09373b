// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QString>

#include "haptics/core/trouble.h"
#include "haptics/snapshot.h"

namespace ui {

/// The state of the force in a word or two.
QString nameOf(haptics::ForceState state);
/// What it means and what to do now: a sentence, or empty where there is nothing to say.
QString sentenceFor(haptics::ForceState state, haptics::ForceReason reason,
                    haptics::Trouble trouble);
/// White text on this says the state by colour too; never red, which takes the force away.
QString colourOf(haptics::ForceState state);

}  // namespace ui
