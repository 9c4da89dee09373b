// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/program/preferences_controller.h"

#include <algorithm>
#include <utility>

#include "app/window/sessions/recordings.h"
#include "ui/style/style.h"

namespace app {

PreferencesController::PreferencesController(ui::MainWindow& window, bool kept)
    : window_(window),
      views_(window.views()),
      messages_(window.messages()),
      menus_(window.menus()),
      preferences_(loadPreferences()),
      kept_(kept) {
  connect(&window, &ui::MainWindow::layoutChanged, this, &PreferencesController::save);
  for (const auto changed : {&ui::Menus::hintsChanged, &ui::Menus::themeChanged})
    connect(&menus_, changed, this, &PreferencesController::save);
  connect(&menus_, &ui::Menus::preferencesWanted, this, &PreferencesController::open);
}

double PreferencesController::firstStiffness() const {
  return preferences_.stiffness_always.value_or(preferences_.stiffness);
}

std::optional<haptics::ServoRate> PreferencesController::servoRate() const {
  static_assert(std::ranges::all_of(ui::kServoRateChoices, haptics::isServoRate) &&
                ui::kServoRateChoices.size() == haptics::kServoRates.size());
  if (!preferences_.servo_rate) return {};
  return haptics::ServoRate{*preferences_.servo_rate};
}

void PreferencesController::restoreWindow() {
  if (!kept_) return;
  ui::setOwnKeys(preferences_.keys);
  ui::setLengthUnit(preferences_.lengths);
  views_.setMouse(preferences_.mouse);
  menus_.setHintsShown(preferences_.hints);
  menus_.setTheme(ui::style::themeOf(preferences_.theme));
  if (const QStringList unread = std::exchange(preferences_.unread, {}); !unread.isEmpty())
    messages_.showMessage(
        tr("Some preferences could not be read and are as they were at first: %1.")
            .arg(unread.join(", ")));
  if (preferences_.geometry.isEmpty()) return;
  window_.restoreGeometry(preferences_.geometry);
  window_.restoreLayout(preferences_.layout);
}

void PreferencesController::showNotice() {
  messages_.showNotice();
  preferences_.notice_seen = true;
  save();
}

void PreferencesController::save() {
  preferences_.geometry = window_.saveGeometry();
  preferences_.layout = window_.layoutState();
  preferences_.theme = ui::style::nameOf(ui::style::theme());
  preferences_.hints = menus_.hintsShown();
  if (kept_) preferences_.keys = ui::ownKeys();
  emit saving(preferences_);
  if (kept_) savePreferences(preferences_);
  show();
}

void PreferencesController::open() {
  if (shown_ == nullptr) {
    shown_ = new ui::PreferencesWindow(&window_);
    connect(shown_, &ui::PreferencesWindow::changed, this, &PreferencesController::apply);
    connect(shown_, &ui::PreferencesWindow::keysChanged, this, &PreferencesController::save);
    connect(shown_, &ui::PreferencesWindow::forgetPlacesWanted, this,
            &PreferencesController::forgetPlacesWanted);
  }
  show();
  shown_->show();
  shown_->raise();
  shown_->activateWindow();
}

ui::PreferenceChoices PreferencesController::choices() const {
  return {.theme = ui::style::theme(),
          .language = preferences_.language,
          .hints = menus_.hintsShown(),
          .lengths = preferences_.lengths,
          .mouse = preferences_.mouse,
          .stiffness = preferences_.stiffness_always,
          .servo_rate = preferences_.servo_rate,
          .recordings = preferences_.recordings,
          .places_remembered = preferences_.places_remembered};
}

void PreferencesController::apply(const ui::PreferenceChoices& wanted) {
  const ui::PreferenceChoices before = choices();
  QString refusal;
  if (wanted.recordings != before.recordings && !wanted.recordings.isEmpty())
    refusal = refusalOf(wanted.recordings.toStdString());
  if (refusal.isEmpty() && wanted.recordings != before.recordings) {
    preferences_.recordings = wanted.recordings;
    emit recordingsChosen(wanted.recordings);
  }
  preferences_.language = wanted.language;
  preferences_.lengths = wanted.lengths;
  ui::setLengthUnit(wanted.lengths);
  preferences_.mouse = wanted.mouse;
  views_.setMouse(wanted.mouse);
  preferences_.stiffness_always = wanted.stiffness;
  if (wanted.stiffness && wanted.stiffness != before.stiffness)
    emit stiffnessChosen(*wanted.stiffness);
  preferences_.servo_rate = wanted.servo_rate;
  if (wanted.servo_rate != before.servo_rate) emit servoRateChosen();
  menus_.setHintsShown(wanted.hints);
  menus_.setTheme(wanted.theme);
  if (wanted.places_remembered != before.places_remembered)
    emit rememberPlacesChosen(wanted.places_remembered);
  save();
  shown_->showRefusal(refusal);
}

void PreferencesController::show() {
  if (shown_ == nullptr) return;
  shown_->show(choices(), QString::fromStdString(ownRecordings().string()));
  shown_->showPlaces(static_cast<int>(preferences_.places.size()));
}

}  // namespace app
