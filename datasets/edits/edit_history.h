// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "datasets/edits/edit.h"
#include "datasets/edits/edited.h"
#include "haptics/carving/lowering.h"
#include "haptics/core/error.h"

namespace datasets {

/// How an edit is watched and stopped.
struct EditWatch {
  const std::atomic<bool>* cancel = nullptr;  ///< true: ends with Error::Kind::Cancelled
  std::function<void(double)> advanced = {};  ///< gets the fraction that is done; may be empty
};

/// What an edit takes away.
struct Removal {
  double volume = 0.0;  ///< m^3 of the solid at the edit's isovalue (of a cut: at `isovalue`)
  std::vector<haptics::VoxelRun> runs;  ///< the voxels that it lowers, by k, j, i
};

/// What an edit would take away from a volume, without doing it. `isovalue`: the present one, for
/// edits that have none. A stroke was felt when it was made, and is not asked for. Refuses an edit
/// that takes nothing away, reason "nothing", and a seed that is not in the solid, reason
/// "no-piece". Any thread.
haptics::Expected<Removal> removalOf(const haptics::Volume& volume, const Edit& edit,
                                     double isovalue, const EditWatch& watch = {});

/// The edits of one scan, with undo and redo.
///
/// The scan's voxels lie in a memory object. Each volume is a private view of it, in which only
/// touched pages are copies. Volumes are immutable once handed out: an edit makes a new view, so a
/// servo loop may go on with the old one. Undo and redo restore every byte, from a journal up to
/// its limit of memory, beyond that by applying the commands to the scan again.
///
/// One thread at a time. Each call takes up to seconds, so do not call it on the GUI thread.
class EditHistory {
 public:
  static constexpr std::size_t kJournalLimit = std::size_t{256} << 20;  ///< bytes
  static constexpr std::size_t kMostSteps = 1000;

  explicit EditHistory(std::shared_ptr<const haptics::Volume> scan,
                       std::size_t journal_limit = kJournalLimit);
  ~EditHistory();
  EditHistory(const EditHistory&) = delete;
  EditHistory& operator=(const EditHistory&) = delete;

  const std::shared_ptr<const haptics::Volume>& scan() const;
  /// The volume after the edits in force; the scan itself without any.
  const std::shared_ptr<const haptics::Volume>& present() const;
  /// The edits in force, oldest first.
  std::span<const Edit> edits() const;
  bool canUndo() const;
  bool canRedo() const;
  std::size_t journalBytes() const;

  // Each returns the new present volume. On an error, and if it is cancelled, nothing has changed.

  /// Applies an edit and forgets what could be redone. Refuses as removalOf() does, and a volume
  /// without a memory object, reason "not-editable".
  haptics::Expected<std::shared_ptr<const haptics::Volume>> apply(const Edit& edit,
                                                                  const EditWatch& watch = {});
  haptics::Expected<std::shared_ptr<const haptics::Volume>> undo(const EditWatch& watch = {});
  haptics::Expected<std::shared_ptr<const haptics::Volume>> redo(const EditWatch& watch = {});
  /// Takes all edits back; they can be redone.
  haptics::Expected<std::shared_ptr<const haptics::Volume>> reset(const EditWatch& watch = {});

 private:
  class State;
  std::unique_ptr<State> state_;
};

/// The volume after these edits of a scan: for a replay and a session file.
haptics::Expected<std::shared_ptr<const haptics::Volume>> edited(
    std::shared_ptr<const haptics::Volume> scan, std::span<const Edit> edits,
    const EditWatch& watch = {});

}  // namespace datasets
