// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QString>

namespace ui {

/// A time [s] as minutes and seconds, "83:05.2" with one decimal; a dash for a value that is not a
/// number.
QString clockTime(double seconds, int decimals);

}  // namespace ui
