// SPDX-License-Identifier: BSD-3-Clause
#include "app/preferences.h"

#include <QSettings>

#include "app/recent_places.h"

namespace app {

Preferences loadPreferences() {
  const QSettings settings;
  Preferences preferences;
  preferences.geometry = settings.value("window/geometry").toByteArray();
  preferences.layout = settings.value("window/layout").toByteArray();
  preferences.notice_seen = settings.value("notice/seen", false).toBool();
  const double stiffness = settings.value("coupling/stiffness", 1000.0).toDouble();
  if (stiffness >= 0.0 && stiffness <= 20'000.0) preferences.stiffness = stiffness;
  preferences.places_remembered = settings.value("places/remembered", true).toBool();
  if (preferences.places_remembered)
    preferences.places = settings.value("places/recent").toStringList().mid(0, kMostPlaces);
  return preferences;
}

void savePreferences(const Preferences& preferences) {
  QSettings settings;
  settings.setValue("window/geometry", preferences.geometry);
  settings.setValue("window/layout", preferences.layout);
  settings.setValue("notice/seen", preferences.notice_seen);
  settings.setValue("coupling/stiffness", preferences.stiffness);
  settings.setValue("places/remembered", preferences.places_remembered);
  // nothing is left of them in the file once they are forgotten
  if (preferences.places.isEmpty())
    settings.remove("places/recent");
  else
    settings.setValue("places/recent", preferences.places);
}

}  // namespace app
