// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/report/outcome.h"

#include <cmath>

namespace study {

bool Case::pass() const {
  if (!std::isfinite(value)) return false;
  return sense == Sense::AtMost ? value <= bound : value >= bound;
}

}  // namespace study
