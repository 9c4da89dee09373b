// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/comparison/scenes.h"

namespace comparison {

const std::vector<std::string>& scanNames() {
  static const std::vector<std::string> kNone;
  return kNone;
}

}  // namespace comparison
