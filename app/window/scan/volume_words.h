// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QCoreApplication>
#include <QLocale>
#include <QString>

#include "haptics/core/volume.h"
#include "ui/props/picture.h"

namespace app {

/// What tells one geometry from another: "64 x 64 x 64 voxels of 1 x 1 x 1 mm (int16)".
inline QString geometryWords(const haptics::Grid& grid, haptics::ScalarType type) {
  const auto mm = [&](int axis) {
    return QLocale().toString(grid.spacing[axis] * ui::kMmPerM, 'g', 4);
  };
  return QCoreApplication::translate("app::geometryWords",
                                     "%1 x %2 x %3 voxels of %4 x %5 x %6 mm (%7)")
      .arg(grid.dims[0])
      .arg(grid.dims[1])
      .arg(grid.dims[2])
      .arg(mm(0), mm(1), mm(2), QString::fromLatin1(nameOf(type)));
}

}  // namespace app
