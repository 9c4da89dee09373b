// SPDX-License-Identifier: BSD-3-Clause
// The sentences of exports and films, and the files that are written, in the order of the source.
#pragma once

#include "resources/messages/row.h"

namespace resources {

inline constexpr Row kExports[] = {
    {"disk-full", "the disk is full"},
    {"output-unwritable",
     "\"%1\" cannot be written (%2); choose a folder that can be written and has room."},
    {"output-is-input", "\"%1\" is a file that was read here, and would be lost; name another."},
    {"output-no-regular-file", "\"%1\" is no regular file, and is not written over; name a file."},
    {"film-other-volume",
     "The volume is not the one that was recorded: its voxels are others, or lie elsewhere; give "
     "the one that was touched, or none."},
    {"export-names-folder",
     "\"%1\" names a folder; add how the files' names begin, such as sub-01_task-touch."},
    {"export-no-step",
     "The recording goes from %1 s to %2 s and holds no step%3%4%5; choose others."},
    {"export-from", " from %1 s"},
    {"export-to", " to %1 s"},
    {"export-at-rate", " at %1 Hz"},
    {"recording-time-backwards", "The recording is damaged: its time goes backwards; use a copy."},
    {"export-cancelled", "Stopped; nothing was exported."},
    {"film-cancelled", "The film was cancelled."},
    {"ffmpeg-ended",
     "ffmpeg ended before the film was whole; check the room on the disk, and that ffmpeg has "
     "libx264."},
    {"ffmpeg-ended-saying",
     "ffmpeg ended before the film was whole (%1); check the room on the disk, and that ffmpeg has "
     "libx264."},
    {"film-unwritable",
     "\"%1\" cannot be written; check that its folder exists, may be written to and has room."},
    {"film-other-name",
     "There is no ffmpeg, so the film would be \"%1\", which is there already; name it to write "
     "over it, or remove it."},
    {"film-no-step", "The recording has no step in that stretch of time; choose another."},
    {"film-too-long",
     "The film would have more than a million frames; take a shorter stretch, or a greater speed."},
    {"film-size", "A film's width and height are even numbers of 64 to 7680 pixels."},
    {"film-rate", "A film has 1 to 240 frames a second."},
    {"film-speed", "A film's speed is 0.001 to 1000 times that of the session."},
    {"film-no-display",
     "There is no X display to draw a film on; set DISPLAY, or where there is no screen put "
     "\"xvfb-run -a\" before the command."},
    {"film-no-opengl",
     "This display has no OpenGL 3.2, which a film is drawn with; use another, or put \"xvfb-run "
     "-a\" before the command."},
    {"film-not-written", "The film could not be written; check the room on the disk."},
};

}  // namespace resources
