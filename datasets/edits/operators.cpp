// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/edits/operators.h"

#include <algorithm>
#include <thread>
#include <variant>

#include "haptics/core/parallel.h"

namespace datasets {

haptics::Error editCancelled() {
  return {haptics::Error::Kind::Cancelled, {"edit-cancelled", {}}, "cancelled"};
}

bool EditProgress::each(std::int64_t count, const std::function<void(std::int64_t)>& work) const {
  const auto caller = std::this_thread::get_id();
  haptics::inParallel(
      count,
      [&](std::int64_t n) {
        if (cancelled()) return;
        work(n);
        if (std::this_thread::get_id() == caller)
          advance(static_cast<double>(n) / static_cast<double>(count));
      },
      std::min(2, haptics::coreCount()));  // the touch and the window need the others
  return !cancelled();
}

MadeOperator operatorOf(const haptics::Volume& volume, const Edit& edit, double isovalue,
                        const EditWatch& watch) {
  MadeOperator made;
  if (const auto* plane = std::get_if<PlaneCut>(&edit))
    made = planeOperator(volume, *plane);
  else if (const auto* lasso = std::get_if<LassoCut>(&edit))
    made = lassoOperator(volume, *lasso, watch);
  else if (const auto* holder = std::get_if<RemoveHolder>(&edit))
    made = holderOperator(volume, *holder, watch);
  else
    made = pieceOperator(volume, edit, watch);
  if (made && (std::holds_alternative<PlaneCut>(edit) || std::holds_alternative<LassoCut>(edit)))
    (*made)->isovalue = isovalue;
  return made;
}

}  // namespace datasets
