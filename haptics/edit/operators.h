// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "haptics/core/error.h"
#include "haptics/core/volume.h"
#include "haptics/edit/edit.h"
#include "haptics/edit/edit_history.h"

namespace haptics {

/// What an edit does to one row of voxels.
struct RowCut {
  /// Voxels first <= i < end. All of them become background, or each becomes at most its ceiling.
  struct Span {
    std::int32_t first = 0, end = 0;
    bool background = false;
  };
  std::vector<Span> spans;      ///< by i, apart
  std::vector<double> ceiling;  ///< by i of the grid; only within spans that are not background
};

/// An edit of a given volume that writes voxels: it gives each of them a greatest value.
class EditOperator {
 public:
  virtual ~EditOperator() = default;
  VoxelBox box;           ///< within which voxels may change
  double isovalue = 0.0;  ///< at which its volume is counted
  /// The row (j, k) within the box; several threads at a time. `cut.ceiling` has the length of a
  /// row of the grid.
  virtual void cutRow(std::int64_t j, std::int64_t k, RowCut& cut) const = 0;
};

using MadeOperator = Expected<std::unique_ptr<EditOperator>>;

/// The operator of an edit that is no crop. The volume must outlive it. Refuses as removalOf().
MadeOperator operatorOf(const Volume& volume, const Edit& edit, double isovalue,
                        const EditWatch& watch);

MadeOperator planeOperator(const Volume& volume, const PlaneCut& cut);
MadeOperator lassoOperator(const Volume& volume, const LassoCut& cut, const EditWatch& watch);
MadeOperator pieceOperator(const Volume& volume, const Edit& edit, const EditWatch& watch);
MadeOperator holderOperator(const Volume& volume, const RemoveHolder& edit, const EditWatch& watch);

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

 private:
  const EditWatch& watch_;
  double from_, until_;
};

Error editCancelled();

}  // namespace haptics
