// SPDX-License-Identifier: BSD-3-Clause
#include "tests/support/places.h"

namespace places {

std::string scan(const std::string& name) {
  return name.empty() ? PALPATE_SCANS : PALPATE_SCANS "/" + name;
}

std::string source(const std::string& name) { return PALPATE_SOURCE "/" + name; }

std::string built(const std::string& name) { return PALPATE_BUILT "/" + name; }

}  // namespace places
