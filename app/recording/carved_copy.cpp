// SPDX-License-Identifier: BSD-3-Clause
#include "app/recording/carved_copy.h"

#include <algorithm>

#include "app/recording/cut_words.h"
#include "haptics/scene/carved_scene.h"

namespace app {

haptics::Expected<double> CarvedCopy::carve(const haptics::BurrCut& cut) {
  if (voxels_ == nullptr) {
    auto view = haptics::viewLike(*uncut_);
    if (!view) return tl::unexpected(view.error());
    voxels_ = std::move(*view);
  }
  haptics::BurrCarving carving{*uncut_, cut};
  haptics::Removed removed;
  while (!carving.isDone())
    removed.add(carving.lowerRow(voxels_.get(), uncut_->voxels.get(), haptics::Material{}));
  return std::max(0.0, removed.volume);
}

std::uint64_t CarvedCopy::digest() const {
  if (voxels_ == nullptr) return 0;
  haptics::Volume now = *uncut_;
  now.voxels = voxels_;
  return digestOfCuts(*uncut_, now);
}

}  // namespace app
