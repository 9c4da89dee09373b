// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "haptics/core/budget.h"
#include "haptics/core/realtime.h"

namespace haptics {

/// The position in a list of work that is done over several ticks: after a cut, the next call goes
/// on there. Whoever begins a list anew sets it to 0.
class Cursor {
 public:
  std::size_t at() const HAPTICS_RT { return at_; }
  void set(std::size_t at) HAPTICS_RT { at_ = at; }

  /// Works on the items before `end` that are left. work(i) does some, from item i on, and returns
  /// the one after them, which is beyond i. Each call costs a unit of the budget. False if the
  /// budget cut.
  template <class Work>
  bool through(std::size_t end, Budget& budget, Work&& work) HAPTICS_RT {
    return through(
        end, budget, [](std::size_t i) HAPTICS_RT { return i; }, work);
  }
  /// The same, where some items need no work: skip(i) returns the first item from i on that does.
  template <class Skip, class Work>
  bool through(std::size_t end, Budget& budget, Skip&& skip, Work&& work) HAPTICS_RT {
    while ((at_ = skip(at_)) < end) {
      if (!budget.left()) return false;
      at_ = work(at_);
    }
    return true;
  }

 private:
  std::size_t at_ = 0;
};

}  // namespace haptics
