// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/views/grey_keeper.h"

namespace app {

GreyKeeper::GreyKeeper(ui::SliceSet& slices, SharedState& shared)
    : slices_(slices), shared_(shared) {
  connect(&slices, &ui::SliceSet::greyChosen, this, &GreyKeeper::keep);
}

void GreyKeeper::showScene() {
  if (const auto grey = kept()) slices_.setGrey(*grey);
}

std::optional<ui::GreyWindow> GreyKeeper::kept() const {
  if (!shared_.shown) return {};
  const auto found = kept_.find(name());
  if (found == kept_.end()) return {};
  return found->second;
}

void GreyKeeper::keep(const ui::GreyWindow& grey) {
  if (shared_.shown) kept_[name()] = grey;
}

std::string GreyKeeper::name() const {
  return shared_.shown->place.string() + '\n' + shared_.shown->title.toStdString();
}

}  // namespace app
