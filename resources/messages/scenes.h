// SPDX-License-Identifier: BSD-3-Clause
// The sentences of volumes, tools, hands and scenes, in the order of the source.
#pragma once

#include "resources/messages/row.h"

namespace resources {

inline constexpr Row kScenes[] = {
    {"name-unknown", "There is no \"%1\"; choose one of %2.", "unknown-name"},
    {"volume-memory",
     "The volume needs %1 MB of memory, which this machine does not give; try a smaller series or "
     "close other programs.",
     "too-large"},
    {"volume-axes-not-right-angled",
     "The volume's axes are not at right angles; only right-angled stacks can be loaded.",
     "sheared"},
    {"volume-no-finite-voxel",
     "The volume holds no finite voxel; there is nothing to see or touch.", "no-pixels"},
    {"edit-damaged", "What was taken away from the scan is stored in a way that cannot be read.",
     "damaged"},
    {"edit-cancelled", "The edit was cancelled; the scan is as it was.", "cancelled"},
    {"edit-nothing", "The edit would take nothing away; choose another place or isovalue.",
     "nothing"},
    {"edit-no-piece",
     "There is no solid at the place; point at the surface, or lower the isovalue.", "nothing"},
    {"edit-no-holder",
     "No table or holder was found beside the patient; take it away with the scalpel, or as a "
     "piece.",
     "nothing"},
    {"edit-crop-outside", "The crop box reaches beyond the scan; draw it within.", "nothing"},
    {"edit-other-grid",
     "The structures that may not be cut are those of another scan; open this one's again.",
     "nothing"},
    {"edit-not-editable",
     "The scan's voxels cannot be edited in memory; load the scan again from its file.", "nothing"},
    {"edit-memory",
     "There is too little memory for the edit, and the scan is as it was; close other programs.",
     "too-large"},
    {"walls-memory",
     "There is too little memory to feel a structure as solid or not there; close other programs.",
     "too-large"},
    {"edit-too-many", "The scan has %1 edits, and no more are kept; reset some first.", "too-many"},
    {"edit-too-long",
     "These structures have too many parts for a choice of how they are cut; choose for fewer of "
     "them, or for smoother ones.",
     "too-large"},
    {"edit-no-such", "There is no edit to undo or redo.", "nothing"},
    {"scene-no-volume", "There is nothing to touch yet; open a volume.", "nothing-inside"},
    {"tool-no-points", "The tool has no points; a tool needs at least one.", "no-triangle"},
    {"plan-free-space", "collision detection and contact rows in free space"},
    {"plan-free-space-why",
     "in a tick in which every point of the tool has more room than the hand moved, nothing can be "
     "met; so it is always above %1, the greatest value of the volume"},
    {"plan-rests-on-another", "it rests on another that was switched off"},
    {"plan-switched-off", "it was switched off"},
    {"plan-empty-space", "sampling where the pyramid's bounds prove the volume free"},
    {"plan-empty-space-why",
     "a block below the isovalue proves whole branches of the tool free (%1 points in %2 leaves), "
     "and paths"},
    {"plan-empty-space-one-leaf",
     "a block below the isovalue proves what lies in it free, points and paths; branches there are "
     "none, the tool is one leaf of %1 points"},
    {"plan-empty-space-one-point",
     "a block below the isovalue proves what lies in it free, points and paths; branches there are "
     "none, the tool is one leaf of 1 point"},
    {"plan-unspent-room", "another look at points whose room is not used up"},
    {"plan-unspent-room-why", "what was proven free stays so until the tool has moved that far"},
    {"plan-far-gradients", "gradients of points beyond the contact band"},
    {"plan-far-gradients-why", "only a point within a tenth of a voxel of the surface has a row"},
    {"plan-central-differences", "central differences"},
    {"plan-central-differences-why",
     "the rows take another normal: six of a point's seven samples would be for nothing"},
    {"plan-central-differences-taken", "the rows take them for their normals"},
    {"plan-still-rows", "rows anew while the tool is still"},
    {"plan-still-rows-why", "at the same pose they are the same"},
    {"touch-no-thread",
     "The system has no thread left for the touch; close other programs and try again.",
     "too-large"},
    {"session-no-room",
     "The tool would start inside the solid, with no room within 50 mm; raise the isovalue.",
     "nothing-inside"},
    {"hand-no-poses", "The hand has no poses.", "bad-table"},
    {"hand-row-no-number", "The hand's row %1 holds something that is not a number.", "bad-table"},
    {"hand-time-not-increasing", "The hand's time does not increase at row %1.", "bad-table"},
    {"hand-no-surface", "The tool finds no surface at the isovalue %1; choose a lower one.",
     "nothing-inside"},
    {"tool-point-no-number", "The tool has a point that is not a number; mend the file.",
     "no-triangle"},
    {"tool-point-too-far",
     "The tool has a point more than 10 m from its middle, and no hand holds that; check its unit.",
     "no-triangle"},
};

}  // namespace resources
