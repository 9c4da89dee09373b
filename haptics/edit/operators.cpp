// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/edit/operators.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <exception>
#include <system_error>
#include <thread>
#include <variant>

namespace haptics {

Error editCancelled() { return {Error::Kind::Cancelled, {"edit-cancelled", {}}, "cancelled"}; }

bool EditProgress::each(std::int64_t count, const std::function<void(std::int64_t)>& work) const {
  std::atomic<std::int64_t> next{0};
  std::atomic<bool> failed{false};
  std::array<std::exception_ptr, 2> thrown;
  const auto take = [&](bool tells) {
    try {
      while (!cancelled() && !failed) {
        const std::int64_t n = next.fetch_add(1);
        if (n >= count) break;
        work(n);
        if (tells && watch_.advanced)
          watch_.advanced(from_ +
                          (until_ - from_) * static_cast<double>(n) / static_cast<double>(count));
      }
    } catch (...) {
      thrown[tells ? 0 : 1] = std::current_exception();
      failed = true;
    }
  };
  std::thread second;
  if (count > 1 && std::thread::hardware_concurrency() > 1) {
    try {
      second = std::thread{[&] { take(false); }};
    } catch (const std::system_error&) {  // no thread to be had: one does it
    }
  }
  take(true);
  if (second.joinable()) second.join();
  for (const std::exception_ptr& one : thrown)
    if (one) std::rethrow_exception(one);
  return !cancelled();
}

MadeOperator operatorOf(const Volume& volume, const Edit& edit, double isovalue,
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

}  // namespace haptics
