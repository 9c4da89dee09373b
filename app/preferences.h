// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QByteArray>

namespace app {

/// What is remembered between runs. Never a path, never anything of a patient.
struct Preferences {
  QByteArray geometry = {};  ///< of the window, as Qt writes it
  QByteArray layout = {};    ///< of its docks
  bool notice_seen = false;
  double stiffness = 1000.0;  ///< N/m
};

Preferences loadPreferences();
void savePreferences(const Preferences& preferences);

}  // namespace app
