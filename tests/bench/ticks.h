// SPDX-License-Identifier: BSD-3-Clause

// What a servo loop counted, as benchmarks tell it.
#pragma once

#include <algorithm>
#include <cstdint>
#include <nlohmann/json.hpp>

#include "haptics/snapshot.h"

namespace bench {

/// What a session counted since it was last asked.
struct Ticks {
  std::uint64_t ticks = 0, late = 0, missed = 0;
  Ticks operator-(const Ticks& o) const {
    return {ticks - o.ticks, late - o.late, missed - o.missed};
  }
  Ticks& operator+=(const Ticks& o) {
    ticks += o.ticks, late += o.late, missed += o.missed;
    return *this;
  }
};

inline Ticks ticksOf(const haptics::Snapshot& s) { return {s.tick, s.late_ticks, s.missed_ticks}; }

inline nlohmann::ordered_json jsonOf(const Ticks& t) {
  const double each = 1e4 / double(std::max<std::uint64_t>(t.ticks, 1));
  return {{"ticks", t.ticks},
          {"late_in_10000", double(t.late) * each},
          {"missed_in_10000", double(t.missed) * each}};
}

}  // namespace bench
