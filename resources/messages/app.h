// SPDX-License-Identifier: BSD-3-Clause
// The sentences of the programs, in the order of the source.
#pragma once

#include "resources/messages/row.h"

namespace resources {

inline constexpr Row kApp[] = {
    {"watch-no-structure",
     "The label map has no structure %1 with voxels in the scan; of its %2, info --labels tells "
     "which have.",
     "unknown-name"},
    {"feel-unreadable",
     "\"%1\" is no way to feel a structure; write its number and how, such as 3=softer:300, "
     "2=guarded:2:1.5, 1=solid or 4=not-there.",
     "unknown-name"},
    {"tissue-unreadable",
     "\"%1\" does not say what cutting a structure takes; write its number and 0.001 to 1000 "
     "J/mm3, "
     "such as 3=0.2, or 1=never.",
     "unknown-name"},
    {"band-unreadable",
     "\"%1\" does not say what cutting takes from a value on; write the value and 0.001 to 1000 "
     "J/mm3, such as 700=2, at most 3 times.",
     "unknown-name"},
    {"watch-too-many",
     "Distances to %1 structures are too many at a time; name %2 of them at most, with --watch.",
     "unknown-name"},
    {"name-or-file-unknown", "There is no \"%1\"; choose one of %2, or a file.", "unknown-name"},
    {"volume-constant",
     "Every voxel of the volume is %1, so it has no surface to touch; choose another series, or "
     "check "
     "the file.",
     "nothing-inside"},
    {"isovalue-below-background",
     "The isovalue %1 is at or below the background %2, where everything would be solid; choose a "
     "higher one.",
     "nothing-inside"},
    {"tool-points-length-unusual",
     "The tool is up to %1 mm long, which is unusual; the points are taken to be in metres.",
     "no-triangle"},
    {"build-without-readers",
     "This palpate-cli was built without readers and opens no scans or meshes; use --phantom, a "
     "named tool or a CSV of points, or the desktop build.",
     "unreadable"},
    {"input-unreadable", "\"%1\" cannot be opened; check the path and who may read it.",
     "unreadable"},
    {"input-no-file", "\"%1\" is no regular file: it is a folder, a pipe or a device; name a file.",
     "no-file"},
    {"input-too-large", "\"%1\" is larger than %2, and no such file is; choose another.",
     "too-large"},
    {"info-recording",
     "\"%1\" is a recording, not a scan; palpate-cli replay and palpate-cli export read it.",
     "unreadable"},
    {"table-empty", "\"%1\" holds no rows.", "bad-table"},
    {"table-no-names",
     "The first line of \"%1\" holds numbers, where the columns' names belong, and would be lost; "
     "write a line of names above it.",
     "bad-table"},
    {"table-row-short", "\"%1\" needs %2 numbers, separated by commas, in line %3.", "bad-table"},
    {"table-row-long",
     "\"%1\" has more numbers in line %2 than names in its first line; write them with decimal "
     "points, separated by commas.",
     "bad-table"},
    {"table-not-finite", "\"%1\" has a number in column %2 of line %3 that is not finite; mend it.",
     "bad-table"},
    {"table-line-long", "Line %2 of \"%1\" is longer than 64 kB; check that it is a table.",
     "bad-table"},
    {"poses-names",
     "Column %2 of \"%1\" is called \"%3\", where %4 belongs; the first eight columns of a hand "
     "are "
     "%5.",
     "bad-table"},
    {"poses-no-rotation", "\"%1\" has a rotation in line %2 that is no unit quaternion.",
     "bad-table"},
    {"poses-too-far",
     "\"%1\" leads the hand further away than 100 m in line %2, which no hand goes; its positions "
     "are "
     "in metres.",
     "bad-table"},
    {"poses-time",
     "The time of \"%1\" does not increase in line %2; each row needs a later time than the one "
     "before.",
     "bad-table"},
    {"view-field-wrong",
     "\"%1\" was not opened: its field \"%2\" is missing or wrong; use a copy of the file.",
     "no-recording"},
    {"view-of-another-program",
     "\"%1\" is damaged, or is no view of Palpate's; views end in .palpate-view.", "no-recording"},
    {"view-of-earlier-palpate",
     "\"%1\" was saved by an earlier Palpate, in a version of views that this one does not read; "
     "use that one.",
     "earlier"},
    {"view-not-saved-too-large",
     "\"%1\" was not saved: with so many notes and edits it would be larger than 64 MB; delete "
     "some "
     "and save again.",
     "too-large"},
    {"view-other-scan",
     "The view \"%1\" belongs to another scan; give the view of this one, or none.",
     "another-volume"},
    {"measurement-cancelled", "The measurement was cancelled.", "cancelled"},
    {"scan-unknown", "There is no scan named %1.", "unknown-name"},
};

}  // namespace resources
