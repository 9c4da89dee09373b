// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cstddef>
#include <utility>
#include <variant>
#include <vector>

#include "datasets/edits/edited.h"
#include "datasets/edits/operators.h"
#include "haptics/carving/burr.h"

namespace datasets {
namespace {

/// Of each row along i in a box the part that cuts reach.
class ReachedRows {
 public:
  explicit ReachedRows(const haptics::Grid& grid)
      : rows_(static_cast<std::size_t>(grid.dims[2])), across_{grid.dims[1]} {}

  void add(const haptics::VoxelBox& box) {
    for (std::int64_t k = box.first[2]; k < box.end[2]; ++k) {
      std::vector<Part>& slice = rows_[static_cast<std::size_t>(k)];
      slice.resize(static_cast<std::size_t>(across_));
      for (std::int64_t j = box.first[1]; j < box.end[1]; ++j) {
        Part& part = slice[static_cast<std::size_t>(j)];
        if (part.first == part.end) part = {box.first[0], box.end[0]};
        part = {std::min(part.first, box.first[0]), std::max(part.end, box.end[0])};
      }
    }
  }
  std::vector<haptics::VoxelRun> runs() const {
    std::vector<haptics::VoxelRun> runs;
    for (std::size_t k = 0; k < rows_.size(); ++k)
      for (std::size_t j = 0; j < rows_[k].size(); ++j)
        if (const Part& part = rows_[k][j]; part.first < part.end)
          runs.push_back({static_cast<std::int32_t>(part.first), static_cast<std::int32_t>(j),
                          static_cast<std::int32_t>(k),
                          static_cast<std::int32_t>(part.end - part.first)});
    return runs;
  }

 private:
  struct Part {
    std::int64_t first = 0, end = 0;
  };
  std::vector<std::vector<Part>> rows_;  // of a slice all or none
  std::int64_t across_;
};

}  // namespace

std::vector<haptics::VoxelBox> boxesOfStrokes(const haptics::Volume& volume) {
  std::vector<haptics::VoxelBox> boxes;
  const Edited* const edited = editedOf(volume);
  if (edited == nullptr) return boxes;
  for (const Edit& edit : edited->edits) {
    const auto* stroke = std::get_if<Stroke>(&edit);
    if (stroke == nullptr) continue;
    for (const haptics::BurrCut& cut : stroke->cuts())
      haptics::add(haptics::BurrCarving{volume, cut}.box(), boxes);
  }
  return boxes;
}

haptics::Expected<std::vector<haptics::VoxelRun>> carve(const haptics::Volume& volume,
                                                        const Stroke& stroke, void* voxels,
                                                        const EditProgress& progress) {
  ReachedRows reached{volume.grid};
  std::size_t done = 0;
  for (const haptics::BurrCut& cut : stroke.cuts()) {
    if (progress.cancelled()) return tl::unexpected(editCancelled());
    haptics::BurrCarving carving{volume, cut};
    if (carving.lowerAll(voxels, voxels).voxels > 0) reached.add(carving.box());
    progress.advance(static_cast<double>(++done) / static_cast<double>(stroke.cuts().size()));
  }
  return reached.runs();
}

}  // namespace datasets
