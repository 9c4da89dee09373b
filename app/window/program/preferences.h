// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QByteArray>
#include <QString>
#include <QStringList>
#include <optional>

#include "ui/controls/bindings.h"
#include "ui/controls/lengths.h"
#include "ui/controls/mouse_choices.h"
#include "ui/panels/haptic_device_panel.h"
#include "ui/panels/nearness_lines.h"
#include "ui/props/structures.h"
#include "ui/window/main_window.h"

namespace app {

/// The values that are stored between runs. The only paths are the recent places and files of
/// structures and tools, which the user can switch off, and the folder of recordings if the user
/// chose one. Of a scan only its keyed hash is stored, beside its place.
struct Preferences {
  QByteArray geometry = {};      ///< geometry of the window, as Qt writes it
  ui::WindowLayout layout = {};  ///< views, borders, panels
  QString theme = {};            ///< as ui::style::nameOf() has it; empty: dark
  QString language = {};         ///< a code of ui::kLanguages; empty: the system's
  bool hints = true;             ///< each view says what the mouse does in it
  bool notice_seen = false;
  bool tour_seen = false;                       ///< of the first steps
  double stiffness = 1000.0;                    ///< N/m, as it was last
  std::optional<double> stiffness_always = {};  ///< N/m with which each start begins instead
  std::optional<int> servo_rate = {};           ///< Hz; none: as the device's link carries
  ui::NearLimits near = {};                     ///< of structures
  ui::StructureFeel feel = {};                  ///< as the next structure is felt otherwise
  ui::LengthUnit lengths = ui::LengthUnit::Millimetres;
  ui::MouseChoices mouse = {};
  ui::OwnKeys keys = {};     ///< keys that the user changed
  QString recordings = {};   ///< folder of recordings; empty: the user's own
  ui::Mapping mapping = {};  ///< mapping of haptic devices
  QStringList places = {};   ///< entries of File > Open recent, the newest first
  bool places_remembered = true;
  QStringList place_hashes = {};  ///< of scans of these places: keyed hash, blank, path
  QStringList structures = {};    ///< files of structures of scans, as place_hashes
  QStringList tools = {};         ///< files of tools, the newest first
  QString tool = {};              ///< named tool that the user chose last; empty: none
  QStringList unread = {};        ///< keys of values that could not be read, and are as at first
};

Preferences loadPreferences();
void savePreferences(const Preferences& preferences);

}  // namespace app
