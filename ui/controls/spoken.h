// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QAccessible>
#include <QString>
#include <functional>
#include <optional>

class QWidget;

namespace ui {

/// A number that a screen reader reads and sets, in the unit that the name of its control says.
struct SpokenNumber {
  double now = 0.0, least = 0.0, most = 0.0, step = 0.0;
};

/// What a screen reader is told of a widget that Qt does not know, or that it knows by the steps of
/// a slider alone. A button can be pressed all the same. Its constructor calls offerSpoken(). GUI
/// thread.
class Spoken {
 public:
  virtual ~Spoken() = default;

  virtual QAccessible::Role spokenRole() const = 0;
  /// Empty: the accessible name, or what Qt makes of the widget.
  virtual QString spokenName() const { return {}; }
  /// The value in words, with its unit.
  virtual QString spokenValue() const { return {}; }
  /// The value as a number; none: it has none.
  virtual std::optional<SpokenNumber> spokenNumber() const { return {}; }
  /// Adds what is special about its state.
  virtual void spokenState(QAccessible::State&) const {}
  /// A screen reader wants another value.
  virtual void takeSpoken(double) {}
};

/// Lets Qt tell screen readers what Spoken says.
void offerSpoken();

/// Called with each name that is told, whether a screen reader listens or not; empty: nobody.
void listenToSpoken(std::function<void(const QString& name)> listener);

/// Tell screen readers that what is said of a widget has changed.
void tellSpokenName(QWidget& widget);
void tellSpokenNumber(QWidget& widget);

}  // namespace ui
