// SPDX-License-Identifier: BSD-3-Clause
// The sentences of the recordings, in the order of the source.
#pragma once

#include "resources/messages/row.h"

namespace resources {

inline constexpr Row kRecordings[] = {
    {"recording-unfinished-disk",
     "The recording could not be finished: %1. It stays \"%2\" and can be recovered once there is "
     "room.",
     "unfinished"},
    {"recording-unfinished-damaged",
     "The recording could not be finished: the file is damaged. It stays \"%1\"; look at the disk.",
     "unfinished"},
    {"recording-empty-no-tick", "Nothing was recorded: no tick came meanwhile.", "empty"},
    {"memory-exhausted", "there is no memory left", "too-large"},
    {"recording-stopped-empty",
     "The recording stopped, and touch goes on: %1. Nothing was recorded until then.",
     "unfinished"},
    {"recording-stopped",
     "The recording stopped, and touch goes on: %1. What was recorded until then is in \"%2\" and "
     "can be recovered.",
     "unfinished"},
    {"recording-left-over",
     "\"%1\" is what an earlier recording left; recover it with palpate-cli recover, or remove it.",
     "unfinished"},
    {"recovery-failed", "\"%1\" cannot be recovered: %2.", "unfinished"},
    {"recovery-no-file", "\"%1\" cannot be recovered: there is no such file.", "unfinished"},
    {"recovery-in-use", "\"%1\" cannot be recovered: it is being written.", "unfinished"},
    {"recovery-no-recording",
     "\"%1\" cannot be recovered: it is no unfinished recording; those end in .palpate.part.",
     "unfinished"},
    {"recovery-no-log",
     "\"%1\" cannot be recovered: it is damaged, or \"%2\", which holds what was recorded, is not "
     "beside it; copy both.",
     "unfinished"},
    {"recovery-empty", "\"%1\" cannot be recovered: nothing was recorded yet; remove it.",
     "unfinished"},
    {"recording-damaged", "The recording is damaged and cannot be read; use a copy of it.",
     "damaged"},
    {"recording-no-step", "\"%1\" holds no step; nothing was recorded.", "empty"},
    {"recording-unfinished",
     "\"%1\" was never finished; palpate-cli recover brings back what is in it.", "unfinished"},
    {"recording-of-another-program",
     "\"%1\" is damaged, or is no recording of Palpate's; recordings end in .palpate.",
     "no-recording"},
    {"file-of-later-palpate", "\"%1\" is of a later Palpate; use that one.", "newer"},
    {"recording-beside",
     "Beside \"%1\" lies \"%2\", which Palpate did not make and which would change the recording; "
     "move it elsewhere first.",
     "beside"},
    {"recovery-other-names",
     "\"%1\" cannot be recovered: the file has another name too, and would be changed under it; "
     "recover a copy.",
     "beside"},
    {"replay-structure-missing",
     "Structure %1 was felt in this recording; give the label map, with --labels, and watch it.",
     "no-structures"},
    {"replay-other-edits",
     "What was taken away from the scan in the recording comes out otherwise here: the scan or "
     "this version of Palpate is another; replay with the version that recorded it.",
     "other-edits"},
    {"replay-other-structures",
     "The structures that were solid or not there in the recording come out otherwise here: the "
     "label map or this version of Palpate is another; replay with those of the recording.",
     "other-structures"},
    {"volume-key-unusable",
     "The key of this installation, \"%1\", cannot be used (%2); volumes of recordings are not "
     "recognised until it can.",
     "no-key"},
    {"volume-key-damaged",
     "The key of this installation, \"%1\", is damaged; put it back from a copy. Or remove it, for "
     "a new one: then no volume of an earlier recording is recognised any more.",
     "no-key"},
};

}  // namespace resources
