// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/program/preferences.h"

#include <QSettings>
#include <QStandardPaths>
#include <filesystem>
#include <system_error>

#include "app/window/program/recent_places.h"
#include "app/window/program/stored_values.h"
#include "haptics/process/input_file.h"
#include "haptics/session.h"
#include "haptics/settings.h"
#include "resources/named_tools.h"

namespace app {
namespace {

ui::Mapping loadMapping(StoredValues& stored) {
  ui::Mapping mapping;
  const auto scale = [&](const char* key, double& value) {
    value = stored.number(key, haptics::kScaleRange).value_or(value);
  };
  const auto button = [&](const char* key, int& value) {
    value = stored.whole(key, -1, haptics::kButtons - 1).value_or(value);
  };
  scale("device/position_scale", mapping.position_scale);
  scale("device/force_scale", mapping.force_scale);
  mapping.follow_camera = stored.flag("device/follow_camera").value_or(true);
  button("device/clutch_button", mapping.clutch_button);
  mapping.hold_to_run = stored.flag("device/hold_to_run").value_or(false);
  button("device/hold_button", mapping.hold_button);
  button("device/cut_button", mapping.cut_button);
  return mapping;
}

void loadStructures(StoredValues& stored, Preferences& preferences) {
  const auto number = [&](const char* key, double& value, haptics::Range range) {
    value = stored.number(key, range).value_or(value);
  };
  ui::StructureFeel& feel = preferences.feel;
  number("structures/near_mm", preferences.near.near_mm, {ui::kLeastNear_mm, ui::kMostNear_mm});
  number("structures/close_mm", preferences.near.close_mm, {ui::kLeastNear_mm, ui::kMostNear_mm});
  number("structures/stiffness", feel.stiffness, {ui::kLeastFeelStiffness, ui::kMostFeelStiffness});
  number("structures/margin_mm", feel.margin_mm, {ui::kLeastMargin_mm, ui::kMostMargin_mm});
  number("structures/most", feel.most, {ui::kLeastGuard, ui::kMostGuard});
}

void saveStructures(QSettings& settings, const Preferences& preferences) {
  settings.setValue("structures/near_mm", preferences.near.near_mm);
  settings.setValue("structures/close_mm", preferences.near.close_mm);
  settings.setValue("structures/stiffness", preferences.feel.stiffness);
  settings.setValue("structures/margin_mm", preferences.feel.margin_mm);
  settings.setValue("structures/most", preferences.feel.most);
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

/// Qt waits for a pipe in the place of the settings, and reads what does not end. Such a file is
/// left alone, and nothing is kept then.
bool settingsCanBeRead() {
  constexpr std::uintmax_t kLargest = 1'000'000;  // bytes
  const std::filesystem::path folder =
      QStandardPaths::writableLocation(QStandardPaths::GenericConfigLocation).toStdString();
  std::error_code error;
  for (const char* name : {"Palpate/Palpate.conf", "Palpate.conf"})
    if (const std::filesystem::path file = folder / name;
        std::filesystem::exists(std::filesystem::symlink_status(file, error)) &&
        !haptics::openInput(file, kLargest)) {
      QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, "/dev/null");
      return false;
    }
  return true;
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
  const bool readable = settingsCanBeRead();
  const QSettings settings;
  StoredValues stored(settings);
  Preferences preferences;
  const auto flag = [&](const char* key, bool otherwise) {
    return stored.flag(key).value_or(otherwise);
  };
  constexpr int kWidest = 100'000;  // pixels
  preferences.geometry = settings.value("window/geometry").toByteArray();
  preferences.layout = {.views = settings.value("window/views").toString(),
                        .borders = settings.value("window/borders").toString(),
                        .panels = {.tab = settings.value("window/tab").toString(),
                                   .folded = settings.value("window/folded").toStringList(),
                                   .unfolded = settings.value("window/unfolded").toStringList()},
                        .panel_width = stored.whole("window/panel_width", 0, kWidest).value_or(0),
                        .details = flag("window/details", false)};
  preferences.theme = settings.value("window/theme").toString();
  preferences.language = settings.value("window/language").toString();
  preferences.hints = flag("window/hints", true);
  preferences.notice_seen = flag("notice/seen", false);
  preferences.tour_seen = flag("tour/seen", false);
  if (const auto stiffness = stored.number("coupling/stiffness", haptics::kStiffnessRange))
    preferences.stiffness = *stiffness;
  preferences.stiffness_always =
      stored.number("coupling/stiffness_always", haptics::kStiffnessRange);
  if (const auto hz = stored.whole("servo/rate", 1, 1'000'000); hz && haptics::isServoRate(*hz))
    preferences.servo_rate = hz;
  loadStructures(stored, preferences);
  if (settings.value("units/lengths").toString() == QLatin1String("cm"))
    preferences.lengths = ui::LengthUnit::Centimetres;
  if (settings.value("mouse/at_first").toString() == QLatin1String("hand"))
    preferences.mouse.at_first = ui::MouseMode::Hand;
  preferences.mouse.slices_reversed = flag("mouse/slices_reversed", false);
  preferences.mouse.zoom_reversed = flag("mouse/zoom_reversed", false);
  preferences.keys = loadKeys();
  preferences.recordings = settings.value("recordings/folder").toString();
  preferences.mapping = loadMapping(stored);
  preferences.places_remembered = flag("places/remembered", true);
  if (preferences.places_remembered) {
    preferences.places = settings.value("places/recent").toStringList().mid(0, kMostPlaces);
    preferences.place_hashes =
        hashesOf(settings.value("places/hashes").toStringList(), preferences.places);
    preferences.structures = settings.value("places/structures").toStringList().mid(0, kMostPlaces);
    preferences.tools = settings.value("places/tools").toStringList().mid(0, kMostPlaces);
  }
  if (const QString tool = settings.value("tool/name").toString();
      resources::findNamedTool(tool.toStdString()) != nullptr)
    preferences.tool = tool;
  preferences.unread = stored.unread();
  if (!readable) preferences.unread << QStringLiteral("Palpate.conf");
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
  saveStructures(settings, preferences);
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
  settings.setValue("device/cut_button", mapping.cut_button);
  setOrRemove(settings, "tool/name", !preferences.tool.isEmpty(), preferences.tool);
  settings.setValue("places/remembered", preferences.places_remembered);
  // nothing is left of them in the file once they are forgotten
  const auto setList = [&](const char* key, const QStringList& list) {
    setOrRemove(settings, key, !list.isEmpty(), list);
  };
  setList("places/recent", preferences.places);
  setList("places/hashes", preferences.place_hashes);
  setList("places/structures", preferences.structures);
  setList("places/tools", preferences.tools);
}

}  // namespace app
