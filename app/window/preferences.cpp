// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/preferences.h"

#include <QSettings>

#include "app/window/recent_places.h"
#include "haptics/session.h"
#include "haptics/settings.h"

namespace app {
namespace {

// what cannot be is left at what it is without preferences
ui::Mapping loadMapping(const QSettings& settings) {
  ui::Mapping mapping;
  const auto scale = [&](const char* key, double& value) {
    const double stored = settings.value(key, value).toDouble();
    if (haptics::kScaleRange.holds(stored)) value = stored;
  };
  const auto button = [&](const char* key, int& value) {
    bool is_number = false;
    const int stored = settings.value(key, value).toInt(&is_number);
    if (is_number && stored >= 0 && stored < haptics::kButtons) value = stored;
  };
  scale("device/position_scale", mapping.position_scale);
  scale("device/force_scale", mapping.force_scale);
  mapping.follow_camera = settings.value("device/follow_camera", true).toBool();
  button("device/clutch_button", mapping.clutch_button);
  mapping.hold_to_run = settings.value("device/hold_to_run", false).toBool();
  button("device/hold_button", mapping.hold_button);
  return mapping;
}

// which of them can be keys the table of keys knows
ui::OwnKeys loadKeys() {
  QSettings settings;
  settings.beginGroup("keys");
  ui::OwnKeys keys;
  for (const QString& name : settings.childKeys()) keys[name] = settings.value(name).toString();
  return keys;
}

void saveKeys(const ui::OwnKeys& keys) {
  QSettings settings;
  settings.remove("keys");
  settings.beginGroup("keys");
  for (auto key = keys.begin(); key != keys.end(); ++key) settings.setValue(key.key(), key.value());
}

/// Leaves nothing in the file where there is nothing to say.
void setOrRemove(QSettings& settings, const char* key, bool kept, const QVariant& value) {
  if (kept)
    settings.setValue(key, value);
  else
    settings.remove(key);
}

}  // namespace

Preferences loadPreferences() {
  const QSettings settings;
  Preferences preferences;
  preferences.geometry = settings.value("window/geometry").toByteArray();
  preferences.layout = {.views = settings.value("window/views").toString(),
                        .borders = settings.value("window/borders").toString(),
                        .panels = {.tab = settings.value("window/tab").toString(),
                                   .folded = settings.value("window/folded").toStringList(),
                                   .unfolded = settings.value("window/unfolded").toStringList()},
                        .panel_width = settings.value("window/panel_width", 0).toInt(),
                        .details = settings.value("window/details", false).toBool()};
  preferences.theme = settings.value("window/theme").toString();
  preferences.language = settings.value("window/language").toString();
  preferences.hints = settings.value("window/hints", true).toBool();
  preferences.notice_seen = settings.value("notice/seen", false).toBool();
  preferences.tour_seen = settings.value("tour/seen", false).toBool();
  const double stiffness = settings.value("coupling/stiffness", 1000.0).toDouble();
  if (haptics::kStiffnessRange.holds(stiffness)) preferences.stiffness = stiffness;
  const double always = settings.value("coupling/stiffness_always", -1.0).toDouble();
  if (haptics::kStiffnessRange.holds(always)) preferences.stiffness_always = always;
  const int hz = settings.value("servo/rate", 0).toInt();
  if (haptics::isServoRate(hz)) preferences.servo_rate = hz;
  if (settings.value("units/lengths").toString() == QLatin1String("cm"))
    preferences.lengths = ui::LengthUnit::Centimetres;
  if (settings.value("mouse/at_first").toString() == QLatin1String("hand"))
    preferences.mouse.at_first = ui::MouseMode::Hand;
  preferences.mouse.slices_reversed = settings.value("mouse/slices_reversed", false).toBool();
  preferences.mouse.zoom_reversed = settings.value("mouse/zoom_reversed", false).toBool();
  preferences.keys = loadKeys();
  preferences.recordings = settings.value("recordings/folder").toString();
  preferences.mapping = loadMapping(settings);
  preferences.places_remembered = settings.value("places/remembered", true).toBool();
  if (preferences.places_remembered)
    preferences.places = settings.value("places/recent").toStringList().mid(0, kMostPlaces);
  return preferences;
}

void savePreferences(const Preferences& preferences) {
  QSettings settings;
  settings.setValue("window/geometry", preferences.geometry);
  const ui::WindowLayout& layout = preferences.layout;
  settings.setValue("window/views", layout.views);
  settings.setValue("window/borders", layout.borders);
  settings.setValue("window/tab", layout.panels.tab);
  settings.setValue("window/folded", layout.panels.folded);
  settings.setValue("window/unfolded", layout.panels.unfolded);
  settings.setValue("window/panel_width", layout.panel_width);
  settings.setValue("window/details", layout.details);
  settings.setValue("window/theme", preferences.theme);
  setOrRemove(settings, "window/language", !preferences.language.isEmpty(), preferences.language);
  settings.setValue("window/hints", preferences.hints);
  settings.setValue("notice/seen", preferences.notice_seen);
  settings.setValue("tour/seen", preferences.tour_seen);
  settings.setValue("coupling/stiffness", preferences.stiffness);
  setOrRemove(settings, "coupling/stiffness_always", preferences.stiffness_always.has_value(),
              preferences.stiffness_always.value_or(0.0));
  setOrRemove(settings, "servo/rate", preferences.servo_rate.has_value(),
              preferences.servo_rate.value_or(0));
  const bool centimetres = preferences.lengths == ui::LengthUnit::Centimetres;
  settings.setValue("units/lengths", centimetres ? "cm" : "mm");
  const bool hand = preferences.mouse.at_first == ui::MouseMode::Hand;
  settings.setValue("mouse/at_first", hand ? "hand" : "look");
  settings.setValue("mouse/slices_reversed", preferences.mouse.slices_reversed);
  settings.setValue("mouse/zoom_reversed", preferences.mouse.zoom_reversed);
  saveKeys(preferences.keys);
  setOrRemove(settings, "recordings/folder", !preferences.recordings.isEmpty(),
              preferences.recordings);
  const ui::Mapping& mapping = preferences.mapping;
  settings.setValue("device/position_scale", mapping.position_scale);
  settings.setValue("device/force_scale", mapping.force_scale);
  settings.setValue("device/follow_camera", mapping.follow_camera);
  settings.setValue("device/clutch_button", mapping.clutch_button);
  settings.setValue("device/hold_to_run", mapping.hold_to_run);
  settings.setValue("device/hold_button", mapping.hold_button);
  settings.setValue("places/remembered", preferences.places_remembered);
  // nothing is left of them in the file once they are forgotten
  if (preferences.places.isEmpty())
    settings.remove("places/recent");
  else
    settings.setValue("places/recent", preferences.places);
}

}  // namespace app
