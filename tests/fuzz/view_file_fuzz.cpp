// SPDX-License-Identifier: BSD-3-Clause
// Any bytes as the file of a view.
#include <cstdint>
#include <string_view>

#include "app/view_file/view_file.h"
#include "tests/fuzz/require.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const auto view =
      app::viewFileFrom(std::string_view(reinterpret_cast<const char*>(bytes), size), "a view");
  if (!view) {
    fuzz::require(!view.error().message.empty() && !view.error().reason.empty(),
                  "a refusal has a sentence and a reason");
    return 0;
  }
  fuzz::require(view->grid.spacing.minCoeff() > 0.0 && view->grid.spacing.allFinite(),
                "the spacing is positive");
  const ui::ViewLook& look = view->look;
  fuzz::require(look.voxels.thickness_mm > 0.0 && look.layout.active < ui::LayoutLook::kViews,
                "a slab is thick, and a view of the window was the active one");
  for (const std::vector<double>& column : look.layout.shares) {
    fuzz::require(column.size() >= 2, "a column has a width and views");
    for (const double share : column)
      fuzz::require(share >= ui::LayoutLook::kLeastShare, "a view has a size");
  }
  for (const ui::Measure& mark : view->marks) {
    fuzz::require(mark.places_mm.size() == ui::placesOf(mark.kind), "a mark has its places");
    for (const Eigen::Vector3d& p_mm : mark.places_mm)
      fuzz::require(p_mm.allFinite(), "a mark lies somewhere");
  }
  fuzz::require(app::viewFileFrom(app::textOf(*view), "a view").has_value(),
                "what was read can be saved and read again");
  return 0;
}
