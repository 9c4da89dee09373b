// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/scene/carved_scene.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include "haptics/core/voxel_memory.h"

namespace haptics {

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

Expected<std::unique_ptr<CarvedScene>> CarvedScene::of(const Scene& scene) {
  auto view = viewLike(*scene.volume);
  if (!view) return tl::unexpected(view.error());
  auto volume = std::make_shared<Volume>(*scene.volume);
  volume->voxels = *view;
  std::unique_ptr<CarvedScene> carved{new CarvedScene};
  carved->voxels_ = std::move(*view);
  carved->scan_ = scene.volume;
  carved->field_ = std::make_shared<ScalarField>(volume, scene.field.kind(), scene.field.pyramid());
  const auto& counts = carved->field_->pyramid().finestCounts();
  const auto blocks = static_cast<std::size_t>(counts[0] * counts[1] * counts[2]);
  carved->raised_.assign(blocks, 0.0F);
  carved->waiting_.assign(blocks, 0);
  carved->scene_ = std::make_shared<const Scene>(
      Scene{scene.id, volume, scene.tool, scene.tree, carved->field_, *carved->field_, scene.metric,
            scene.lengths, scene.normal, scene.structures, scene.plan, scene.planned,
            scene.fineness, scene.scan_field});
  return carved;
}

bool CarvedScene::isWithinRaised(const VoxelBox& blocks) const HAPTICS_RT {
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (blocks.first[axis] < raised_box_.first[axis] || blocks.end[axis] > raised_box_.end[axis])
      return false;
  return true;
}

void CarvedScene::begin(const BurrCut& cut) HAPTICS_RT {
  cut_ = cut;
  carving_ = BurrCarving{*scene_->volume, cut};
  if (carving_.isDone()) return;
  const MaxPyramid& pyramid = field_->pyramid();
  const auto& counts = pyramid.finestCounts();
  VoxelBox blocks = pyramid.blocksAround(carving_.box(), field_->kind());
  const double steepest = carving_.steepest();
  if (steepest <= raised_by_ && isWithinRaised(blocks)) return;
  // a block more on each side, so that a burr that moves on need not raise at once again
  for (std::size_t axis = 0; axis < 3; ++axis) {
    blocks.first[axis] = std::max<std::int64_t>(0, blocks.first[axis] - 1);
    blocks.end[axis] = std::min(counts[axis], blocks.end[axis] + 1);
  }
  raising_ = Raising{blocks, steepest, blocks.first[1], blocks.first[2]};
}

std::int64_t CarvedScene::raiseRow() HAPTICS_RT {
  Raising& now = *raising_;
  MaxPyramid& pyramid = field_->pyramid();
  const auto& counts = pyramid.finestCounts();
  std::int64_t work = 1 + (now.blocks.end[0] - now.blocks.first[0]) / 4;
  for (std::int64_t i = now.blocks.first[0]; i < now.blocks.end[0]; ++i) {
    const std::int64_t block = (now.k * counts[1] + now.j) * counts[0] + i;
    float& raised = raised_[static_cast<std::size_t>(block)];
    const bool was_exact = raised == 0.0F;
    work += pyramid.raise(block, now.steepest, raised);
    if (was_exact)
      waiting_[(first_ + count_++) % waiting_.size()] = static_cast<std::uint32_t>(block);
  }
  if (++now.j == now.blocks.end[1]) {
    now.j = now.blocks.first[1];
    ++now.k;
  }
  if (now.k == now.blocks.end[2]) {
    raised_box_ = now.blocks;
    raised_by_ = now.steepest;
    raising_.reset();
  }
  return work;
}

Removed CarvedScene::advance(const Material& material, std::int64_t work,
                             Budget& budget) HAPTICS_RT {
  // before any voxel changes
  while (work > 0 && raising_ && budget.left()) {
    const std::int64_t of_row = raiseRow();
    work -= of_row;
    budget.spend(of_row);
  }
  Removed removed;
  if (raising_) return removed;
  const std::int64_t of_row = 1 + carving_.voxelsInRow() / 12;
  for (; work > 0 && !carving_.isDone() && budget.left(); work -= of_row) {
    removed.add(carving_.lowerRow(voxels_.get(), scan_->voxels.get(), material));
    budget.spend(of_row);
  }
  return removed;
}

void CarvedScene::drop(Contacts& contacts, const Vec3& tool_W) const HAPTICS_RT {
  // their cell, or one that their normal is taken from, may have a corner that was lowered
  const Vec3 way = cut_.to_W - cut_.from_W;
  const double square = way.squaredNorm();
  const double reach = cut_.radius + carving_.reach() + 2.0 * scene_->volume->grid.spacing.norm();
  for (std::size_t n = 0; n < contacts.size();) {
    Vec3 from = tool_W + contacts[n].r_W - cut_.from_W;
    if (square > 0.0) from -= std::clamp(from.dot(way) / square, 0.0, 1.0) * way;
    if (from.squaredNorm() < reach * reach)
      contacts.dropUnordered(n);
    else
      ++n;
  }
}

std::size_t CarvedScene::refresh(std::size_t blocks) HAPTICS_RT {
  if (raising_) return count_;  // what was raised already must stay
  const auto& counts = field_->pyramid().finestCounts();
  for (blocks = std::min(blocks, count_); blocks > 0; --blocks) {
    const std::uint32_t block = waiting_[first_];
    first_ = (first_ + 1) % waiting_.size();
    --count_;
    const std::int64_t i = block % counts[0], j = block / counts[0] % counts[1],
                       k = block / (counts[0] * counts[1]);
    const VoxelBox here{{i, j, k}, {i + 1, j + 1, k + 1}};
    float& raised = raised_[block];
    // at the faces of the volume it stays raised
    if (!field_->pyramid().renew(*scene_->volume, field_->kind(), block)) continue;
    raised = 0.0F;
    if (!isWithinRaised(here)) continue;
    field_->pyramid().raise(block, raised_by_, raised);
    waiting_[(first_ + count_++) % waiting_.size()] = block;
  }
  return count_;
}

}  // namespace haptics
