// SPDX-License-Identifier: BSD-3-Clause
#include "app/recording/carved_copy.h"

#include "app/recording/cut_words.h"
#include "haptics/scene/carved_scene.h"

namespace app {

haptics::Expected<void> CarvedCopy::open() {
  if (voxels_ != nullptr) return {};
  auto view = haptics::viewLike(*uncut_);
  if (!view) return tl::unexpected(view.error());
  volume_.voxels = voxels_ = std::move(*view);
  return {};
}

haptics::Expected<CarvedCopy::Done> CarvedCopy::carve(const haptics::BurrCut& cut) {
  if (!isPossible(cut)) return Done{};
  if (auto opened = open(); !opened) return tl::unexpected(opened.error());
  haptics::BurrCarving carving{*uncut_, cut};
  Done done;
  done.removed = carving.lowerAll(voxels_.get(), uncut_->voxels.get());
  done.looked = haptics::voxelsIn(carving.box());
  if (done.removed.voxels > 0) done.box = carving.box();
  return done;
}

std::uint64_t CarvedCopy::digest() const {
  return voxels_ == nullptr ? 0 : digestOfCuts(*uncut_, volume_);
}

}  // namespace app
