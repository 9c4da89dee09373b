// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QByteArray>
#include <QStringList>

#include "ui/panels/haptic_device_panel.h"

namespace app {

/// What is remembered between runs. Of paths only the recent places, for their menu and nothing
/// else, and none where the user does not want it; nothing that was read from a scan.
struct Preferences {
  QByteArray geometry = {};  ///< of the window, as Qt writes it
  QByteArray layout = {};    ///< of its docks
  bool notice_seen = false;
  double stiffness = 1000.0;  ///< N/m
  ui::Mapping mapping = {};   ///< of haptic devices
  QStringList places = {};    ///< what File > Open recent offers, the newest first
  bool places_remembered = true;
};

Preferences loadPreferences();
void savePreferences(const Preferences& preferences);

}  // namespace app
