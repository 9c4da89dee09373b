// SPDX-License-Identifier: BSD-3-Clause
// Distance maps from closed forms.
#pragma once

#include "datasets/phantoms/sampled_distances.h"

namespace made {

using datasets::distanceMap;

}  // namespace made
