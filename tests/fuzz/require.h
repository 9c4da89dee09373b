// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdio>
#include <cstdlib>

namespace fuzz {

/// Ends the run as a crash does, so that the fuzzer keeps the input.
inline void require(bool holds, const char* promise) {
  if (holds) return;
  std::fprintf(stderr, "Does not hold: %s\n", promise);
  std::abort();
}

}  // namespace fuzz
