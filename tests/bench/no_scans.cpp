// SPDX-License-Identifier: BSD-3-Clause
#include "tests/bench/scenes.h"

namespace bench {

const std::vector<std::string>& scanNames() {
  static const std::vector<std::string> kNone;
  return kNone;
}

}  // namespace bench
