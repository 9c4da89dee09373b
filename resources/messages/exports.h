// SPDX-License-Identifier: BSD-3-Clause
// The sentences of exports and films, and the files that are written, in the order of the source.
#pragma once

#include "resources/messages/row.h"

namespace resources {

inline constexpr Row kExports[] = {
    {"disk-full", "the disk is full", "unwritable"},
    {"output-unwritable",
     "\"%1\" cannot be written (%2); choose a folder that can be written and has room.",
     "unwritable"},
    {"output-is-input", "\"%1\" is a file that was read here, and would be lost; name another.",
     "unwritable"},
    {"output-no-regular-file", "\"%1\" is no regular file, and is not written over; name a file.",
     "unwritable"},
    {"film-other-volume",
     "The volume is not the one that was recorded: its voxels are others, or lie elsewhere; give "
     "the one that was touched, or none.",
     "another-volume"},
    {"export-names-folder",
     "\"%1\" names a folder; add how the files' names begin, such as sub-01_task-touch.",
     "unwritable"},
    {"ffmpeg-ended",
     "ffmpeg ended before the film was whole (%1); check the room on the disk, and that ffmpeg has "
     "libx264.",
     "encoder"},
    {"film-unwritable",
     "\"%1\" cannot be written; check that its folder exists, may be written to and has room.",
     "unwritable"},
    {"film-no-ffmpeg",
     "There is no ffmpeg, which makes MP4 films; install the package ffmpeg, or let the film's "
     "name "
     "end in .ogv.",
     "encoder"},
    {"film-other-name",
     "There is no ffmpeg, so the film would be \"%1\", which is there already; name it to write "
     "over it, or remove it.",
     "unwritable"},
    {"film-no-step", "The recording has no step in that stretch of time; choose another.", "empty"},
    {"film-too-long",
     "The film would have more than a million frames; take a shorter stretch, or a greater speed.",
     "options"},
    {"film-no-display",
     "There is no X display to draw a film on; set DISPLAY, or where there is no screen put "
     "\"xvfb-run -a\" before the command.",
     "no-display"},
    {"film-no-opengl",
     "This display has no OpenGL 3.2, which a film is drawn with; use another, or put \"xvfb-run "
     "-a\" before the command.",
     "no-graphics"},
    {"film-not-written", "The film could not be written; check the room on the disk.", "encoder"},
    {"recording-not-then",
     "The recording goes from %1 s to %2 s and has no step in the chosen time; choose another.",
     "empty"},
    {"surface-none",
     "There is no surface at the isovalue %1; choose one between %2 and %3, the range of the scan.",
     "nothing"},
    {"surface-all-solid",
     "At the isovalue %1 the whole scan is solid, and its surface is a box; choose an isovalue "
     "above "
     "%2, the least value of the scan, up to %3, the greatest.",
     "nothing"},
    {"surface-too-large",
     "The surface has %1 triangles, which is more than a file of this format can count; choose "
     "another isovalue, or crop the scan.",
     "too-large"},
    {"surface-not-closed",
     "The surface was not written, since a check found that it is not closed, or not turned "
     "outwards; choose an isovalue beside this one.",
     "not-closed"},
    {"film-options",
     "A film is 64 to 7680 pixels wide and high, both even, has 1 to 240 frames a second, and runs "
     "at 0.001 to 1000 times the speed of the session.",
     "options"},
};

}  // namespace resources
