// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "haptics/core/budget.h"
#include "haptics/core/realtime.h"

namespace haptics {

/// A place in a row of items of work, kept from one tick to the next: work that the budget cuts
/// goes on there.
class Cursor {
 public:
  std::size_t at() const HAPTICS_RT { return at_; }
  void set(std::size_t at) HAPTICS_RT { at_ = at; }

  /// Works on the items before `end` that are left. work(i) does some, from item i on, and returns
  /// the one after them. It is called as often as there is budget for it. False if the budget cut;
  /// the next call then goes on.
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
