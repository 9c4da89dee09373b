// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/scene/carved_scene.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include "haptics/core/voxel_memory.h"

namespace haptics {
namespace {

/// A private view with the voxels of a volume: pages that are the scan's cost nothing.
Expected<std::shared_ptr<void>> viewLike(const Volume& volume) {
  if (!volume.memory)
    return tl::unexpected(
        Error{Error::Kind::Unsupported, {"edit-not-editable", {}}, "not-editable"});
  auto view = volume.memory->privateView();
  if (!view) return view;
  constexpr std::size_t kPage = 4096;
  const std::size_t bytes =
      static_cast<std::size_t>(volume.grid.voxelCount()) * sizeOf(volume.type);
  const auto* from = static_cast<const std::byte*>(volume.voxels.get());
  auto* to = static_cast<std::byte*>(view->get());
  for (std::size_t at = 0; at < bytes; at += kPage) {
    const std::size_t length = std::min(kPage, bytes - at);
    if (std::memcmp(from + at, to + at, length) != 0) std::memcpy(to + at, from + at, length);
  }
  return view;
}

}  // namespace

Expected<std::unique_ptr<CarvedScene>> CarvedScene::of(const Scene& scene) {
  auto view = viewLike(*scene.volume);
  if (!view) return tl::unexpected(view.error());
  auto volume = std::make_shared<Volume>(*scene.volume);
  volume->voxels = *view;
  std::unique_ptr<CarvedScene> carved{new CarvedScene};
  carved->voxels_ = std::move(*view);
  carved->field_ = std::make_shared<ScalarField>(volume, scene.field.kind(), scene.field.pyramid());
  const auto& counts = carved->field_->pyramid().finestCounts();
  const auto blocks = static_cast<std::size_t>(counts[0] * counts[1] * counts[2]);
  carved->raised_.assign(blocks, 0.0F);
  carved->waiting_.assign(blocks, 0);
  carved->scene_ = std::make_shared<const Scene>(
      Scene{newSceneId(), volume, scene.tool, scene.tree, carved->field_, *carved->field_,
            scene.metric, scene.lengths, scene.normal, scene.structures, scene.plan, scene.planned,
            scene.fineness, scene.scan_field});
  return carved;
}

void CarvedScene::raiseAround(const VoxelBox& changed) HAPTICS_RT {
  MaxPyramid& pyramid = field_->pyramid();
  const auto& counts = pyramid.finestCounts();
  const VoxelBox blocks = pyramid.blocksAround(changed, field_->kind());
  for (std::int64_t k = blocks.first[2]; k < blocks.end[2]; ++k)
    for (std::int64_t j = blocks.first[1]; j < blocks.end[1]; ++j)
      for (std::int64_t i = blocks.first[0]; i < blocks.end[0]; ++i) {
        const std::int64_t block = (k * counts[1] + j) * counts[0] + i;
        float& raised = raised_[static_cast<std::size_t>(block)];
        const bool was_exact = raised == 0.0F;
        pyramid.raise(block, carving_.steepest(), raised);
        if (!was_exact) continue;
        waiting_[(first_ + count_++) % waiting_.size()] = static_cast<std::uint32_t>(block);
      }
}

Removed CarvedScene::advance(std::int64_t rows, Contacts& contacts, const Vec3& tool_W) HAPTICS_RT {
  Removed removed;
  for (; rows > 0 && !carving_.isDone(); --rows) {
    const VoxelBox changed = carving_.changes(voxels_.get());
    if (changed.end[0] > 0) {
      raiseAround(changed);
      for (std::size_t n = 0; n < contacts.size();) {
        // its cell, or one that its normal is taken from, has a corner there
        const Vec3 u = field_->indexOf(tool_W + contacts[n].r_W);
        bool within = true;
        for (int axis = 0; axis < 3; ++axis) {
          const auto of = static_cast<std::size_t>(axis);
          within = within && u[axis] > double(changed.first[of]) - 2.0 &&
                   u[axis] < double(changed.end[of]) + 1.0;
        }
        if (within)
          contacts.dropUnordered(n);
        else
          ++n;
      }
    }
    removed.add(carving_.lower(voxels_.get(), changed));
  }
  return removed;
}

std::size_t CarvedScene::refresh(std::size_t blocks) HAPTICS_RT {
  if (!carving_.isDone()) return count_;
  for (; blocks > 0 && count_ > 0; --blocks, --count_) {
    const std::uint32_t block = waiting_[first_];
    first_ = (first_ + 1) % waiting_.size();
    // at the faces of the volume it stays raised
    if (field_->pyramid().renew(*scene_->volume, field_->kind(), block)) raised_[block] = 0.0F;
  }
  return count_;
}

}  // namespace haptics
