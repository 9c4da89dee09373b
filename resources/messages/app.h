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
    {"table-unreadable", "\"%1\" cannot be opened; check the path."},
    {"table-empty", "\"%1\" is empty."},
    {"table-no-names",
     "The first line of \"%1\" holds numbers, where the columns' names belong, and would be lost; "
     "write a line of names above it."},
    {"table-row-short", "\"%1\" needs %2 numbers, separated by commas, in line %3."},
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
    {"view-unreadable", "\"%1\" is no file that can be read; check the path."},
    {"view-not-saved-too-large",
     "\"%1\" was not saved: with so many notes and edits it would be larger than 1 MB; delete some "
     "and save again."},
    {"measurement-cancelled", "The measurement was cancelled."},
    {"scan-unknown", "There is no scan named %1."},
};

}  // namespace resources
