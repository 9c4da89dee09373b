// SPDX-License-Identifier: BSD-3-Clause
// The sentences of the programs, in the order of the source.
#pragma once

#include "resources/messages/row.h"

namespace resources {

inline constexpr Row kApp[] = {
    {"hand-unknown", "There is no hand \"%1\"; choose one of %2, or a CSV of poses."},
    {"isovalue-below-background",
     "The isovalue %1 is at or below the background %2, where everything would be solid; choose a "
     "higher one."},
    {"tool-points-length-unusual",
     "The tool is up to %1 mm long, which is unusual; the points are taken to be in metres."},
    {"build-without-readers",
     "This palpate-cli was built without readers and opens no files; use --phantom, or the desktop "
     "build."},
    {"tool-unknown-or-no-mesh", "There is no tool \"%1\"; choose one of %2, or a mesh file."},
    {"unit-unknown", "There is no unit \"%1\"; choose one of m, mm, cm, in."},
    {"build-without-mesh-readers",
     "This palpate-cli was built without readers and opens no mesh files; use a named tool or a "
     "CSV of points."},
    {"input-unreadable", "\"%1\" cannot be opened; check the path and who may read it."},
    {"input-no-file",
     "\"%1\" is no regular file: it is a folder, a pipe or a device; name a file."},
    {"input-too-large", "\"%1\" is larger than %2, and no such file is; choose another."},
    {"table-empty", "\"%1\" is empty."},
    {"table-no-names",
     "The first line of \"%1\" holds numbers, where the columns' names belong, and would be lost; "
     "write a line of names above it."},
    {"table-row-short", "\"%1\" needs %2 numbers, separated by commas, in line %3."},
    {"table-row-long",
     "\"%1\" has more numbers in line %2 than names in its first line; write them with decimal "
     "points, separated by commas."},
    {"table-line-long", "Line %2 of \"%1\" is longer than 64 kB; check that it is a table."},
    {"table-no-rows", "\"%1\" holds a header and no rows."},
    {"poses-no-rotation", "\"%1\" has a rotation that is no unit quaternion."},
    {"poses-too-far",
     "\"%1\" leads the hand further away than 100 m, which no hand goes; its positions are in "
     "metres."},
    {"view-field-wrong",
     "\"%1\" was not opened: its field \"%2\" has a value that no view has; use a copy of the "
     "file."},
    {"view-field-missing",
     "\"%1\" was not opened: its field \"%2\" is missing; use a copy of the file."},
    {"view-field-unknown",
     "\"%1\" was not opened: it has a field that this version of views does not have; use a copy "
     "of the file."},
    {"view-of-another-program",
     "\"%1\" is damaged, or is no view of Palpate's; views end in .palpate-view."},
    {"view-of-earlier-palpate",
     "\"%1\" was saved by an earlier Palpate, in a version of views that this one does not read; "
     "use "
     "that one."},
    {"view-of-later-palpate", "\"%1\" was saved by a later Palpate; use that one."},
    {"view-too-large", "\"%1\" is larger than 1 MB, and no view is; choose another file."},
    {"view-not-saved-too-large",
     "\"%1\" was not saved: with so many notes and edits it would be larger than 1 MB; delete some "
     "and save again."},
    {"measurement-cancelled", "The measurement was cancelled."},
    {"scan-unknown", "There is no scan named %1."},
};

}  // namespace resources
