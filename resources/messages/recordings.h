// SPDX-License-Identifier: BSD-3-Clause
// The sentences of the recordings, in the order of the source.
#pragma once

#include "resources/messages/row.h"

namespace resources {

inline constexpr Row kRecordings[] = {
    {"recording-part-damaged", "A part of the recording is damaged and cannot be read."},
    {"recording-unfinished-disk",
     "The recording could not be finished: %1. It stays \"%2\" and can be recovered once there is "
     "room."},
    {"recording-unfinished-damaged",
     "The recording could not be finished: the file is damaged. It stays \"%1\"; look at the "
     "disk."},
    {"recording-empty-no-tick", "Nothing was recorded: no tick came meanwhile."},
    {"memory-exhausted", "there is no memory left"},
    {"recording-stopped-empty",
     "The recording stopped, and touch goes on: %1. Nothing was recorded until then."},
    {"recording-stopped-disk-full",
     "The recording stopped, and touch goes on: %1. What was recorded until then is in \"%2\" and "
     "can be recovered once there is room."},
    {"recording-stopped",
     "The recording stopped, and touch goes on: %1. What was recorded until then is in \"%2\" and "
     "can be recovered."},
    {"recording-unwritable",
     "\"%1\" cannot be recorded to (%2); choose a folder that can be written and has room."},
    {"recording-left-over",
     "\"%1\" is what an earlier recording left; recover it with palpate-cli recover, or remove "
     "it."},
    {"recovery-failed", "\"%1\" cannot be recovered: %2."},
    {"recovery-name", "\"%1\" cannot be recovered: its name does not end in .part."},
    {"recovery-no-file", "\"%1\" cannot be recovered: there is no such file."},
    {"recovery-in-use", "\"%1\" cannot be recovered: it is being written."},
    {"recovery-no-recording", "\"%1\" cannot be recovered: it is no recording."},
    {"recovery-empty", "\"%1\" cannot be recovered: nothing was recorded yet; remove it."},
    {"recording-damaged", "The recording is damaged and cannot be read; use a copy of it."},
    {"recording-no-step", "\"%1\" holds no step; nothing was recorded."},
    {"recording-unreadable", "\"%1\" is no file that can be read; check the path."},
    {"recording-unfinished",
     "\"%1\" was never finished; palpate-cli recover brings back what is in it."},
    {"recording-not-opened", "\"%1\" cannot be opened; check its permissions."},
    {"recording-of-another-program",
     "\"%1\" is no recording of Palpate's; recordings end in .palpate."},
    {"recording-of-later-palpate", "\"%1\" was recorded by a later Palpate; use that one."},
    {"recording-other-tables",
     "\"%1\" does not have the tables of a recording, and is not read; use a recording that "
     "Palpate "
     "made."},
    {"recording-beside",
     "Beside \"%1\" lies \"%2\", which Palpate did not make and which would change the recording; "
     "move it elsewhere first."},
    {"recording-reading-cancelled", "The recording was not read: it was cancelled."},
    {"recovery-other-names",
     "\"%1\" cannot be recovered: the file has another name too, and would be changed under it; "
     "recover a copy."},
    {"replay-other-edits",
     "What was taken away from the scan in the recording comes out otherwise here: the scan or "
     "this "
     "version of Palpate is another; replay with the version that recorded it."},
    {"replay-cancelled", "The replay was cancelled."},
    {"recording-scene-damaged",
     "What the recording says of its scene is damaged; nothing can be replayed."},
    {"recording-start-damaged",
     "What the recording says of a start is damaged; nothing can be replayed."},
    {"recording-no-regular-file",
     "\"%1\" is no regular file, and a recording needs one; name a file."},
    {"volume-key-unusable",
     "The key of this installation, \"%1\", cannot be used (%2); volumes of recordings are not "
     "recognised until it can."},
    {"volume-key-damaged",
     "The key of this installation, \"%1\", is damaged; put it back from a copy. Or remove it, for "
     "a new one: then no volume of an earlier recording is recognised any more."},
};

}  // namespace resources
