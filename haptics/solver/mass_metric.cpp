// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/solver/mass_metric.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>

namespace haptics {

MassMetric::MassMetric(const Mat3& inertia_P) HAPTICS_RT : I_P_{inertia_P},
                                                           L_{inertia_P.llt().matrixL()},
                                                           L_inverse_{L_.inverse()} {}

}  // namespace haptics
