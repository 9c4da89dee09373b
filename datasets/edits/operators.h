// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "datasets/edits/edit.h"
#include "datasets/edits/edit_history.h"
#include "haptics/carving/lowering.h"
#include "haptics/core/error.h"
#include "haptics/core/volume.h"

namespace datasets {

/// What an edit that writes voxels does to a given volume.
using MadeOperator = haptics::Expected<std::unique_ptr<haptics::RowCutter>>;

/// The operator of an edit that is no crop and no stroke. The volume must outlive it. Refuses as
/// removalOf().
MadeOperator operatorOf(const haptics::Volume& volume, const Edit& edit, double isovalue,
                        const EditWatch& watch);

MadeOperator planeOperator(const haptics::Volume& volume, const PlaneCut& cut);
MadeOperator lassoOperator(const haptics::Volume& volume, const LassoCut& cut,
                           const EditWatch& watch);
MadeOperator pieceOperator(const haptics::Volume& volume, const Edit& edit, const EditWatch& watch);
MadeOperator holderOperator(const haptics::Volume& volume, const RemoveHolder& edit,
                            const EditWatch& watch);

/// How an edit on several threads goes on.
class EditProgress {
 public:
  /// Its work is the part [from, until] of the whole.
  EditProgress(const EditWatch& watch, double from, double until)
      : watch_{watch}, from_{from}, until_{until} {}
  bool cancelled() const { return watch_.cancel != nullptr && watch_.cancel->load(); }
  /// Calls work(n) for 0 <= n < count, in any order, on up to two threads; false if it was
  /// cancelled. The caller's thread tells the watch. What work throws on either thread leaves here.
  bool each(std::int64_t count, const std::function<void(std::int64_t)>& work) const;
  /// Tells the watch that so much is done, from 0 to 1.
  void advance(double done) const {
    if (watch_.advanced) watch_.advanced(from_ + (until_ - from_) * done);
  }

 private:
  const EditWatch& watch_;
  double from_, until_;
};

/// Makes the cuts of a stroke in a view of the volume. The runs in which voxels were lowered, and
/// some around them, by k, j, i; none if nothing was.
haptics::Expected<std::vector<haptics::VoxelRun>> carve(const haptics::Volume& volume,
                                                        const Stroke& stroke, void* voxels,
                                                        const EditProgress& progress);

haptics::Error editCancelled();

}  // namespace datasets
