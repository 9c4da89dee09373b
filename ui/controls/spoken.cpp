// SPDX-License-Identifier: BSD-3-Clause
#include "ui/controls/spoken.h"

#include <QAbstractButton>
#include <QAccessibleWidget>
#include <QWidget>
#include <utility>

namespace ui {
namespace {

class SpokenInterface : public QAccessibleWidget, public QAccessibleValueInterface {
 public:
  explicit SpokenInterface(QWidget* widget) : QAccessibleWidget(widget) {}

  QAccessible::Role role() const override {
    return spoken() != nullptr ? spoken()->spokenRole() : QAccessibleWidget::role();
  }
  QString text(QAccessible::Text what) const override {
    const QString words = spoken() == nullptr          ? QString()
                          : what == QAccessible::Name  ? spoken()->spokenName()
                          : what == QAccessible::Value ? spoken()->spokenValue()
                                                       : QString();
    return words.isEmpty() ? QAccessibleWidget::text(what) : words;
  }
  QAccessible::State state() const override {
    QAccessible::State state = QAccessibleWidget::state();
    if (const QAbstractButton* button = asButton()) {
      state.checkable = button->isCheckable();
      state.checked = button->isChecked();
    }
    if (spoken() != nullptr) spoken()->spokenState(state);
    return state;
  }
  QStringList actionNames() const override {
    QStringList names = QAccessibleWidget::actionNames();
    if (asButton() != nullptr && widget()->isEnabled()) names.prepend(pressAction());
    return names;
  }
  void doAction(const QString& action) override {
    if (action == pressAction() && asButton() != nullptr)
      asButton()->click();
    else
      QAccessibleWidget::doAction(action);
  }
  void* interface_cast(QAccessible::InterfaceType type) override {
    if (type == QAccessible::ValueInterface && number())
      return static_cast<QAccessibleValueInterface*>(this);
    return QAccessibleWidget::interface_cast(type);
  }

  QVariant currentValue() const override { return number().value_or(SpokenNumber{}).now; }
  QVariant minimumValue() const override { return number().value_or(SpokenNumber{}).least; }
  QVariant maximumValue() const override { return number().value_or(SpokenNumber{}).most; }
  QVariant minimumStepSize() const override { return number().value_or(SpokenNumber{}).step; }
  void setCurrentValue(const QVariant& value) override {
    bool is_number = false;
    const double wanted = value.toDouble(&is_number);
    if (is_number && spoken() != nullptr && widget()->isEnabled()) spoken()->takeSpoken(wanted);
  }

 private:
  // asked anew each time: of a widget that is being destroyed nothing is left to ask
  Spoken* spoken() const { return dynamic_cast<Spoken*>(widget()); }
  QAbstractButton* asButton() const { return qobject_cast<QAbstractButton*>(widget()); }
  std::optional<SpokenNumber> number() const {
    return spoken() != nullptr ? spoken()->spokenNumber() : std::nullopt;
  }
};

std::function<void(const QString&)>& spokenListener() {
  static std::function<void(const QString&)> listener;
  return listener;
}

QAccessibleInterface* spokenInterface(const QString&, QObject* object) {
  auto* widget = qobject_cast<QWidget*>(object);
  return widget != nullptr && dynamic_cast<Spoken*>(widget) != nullptr ? new SpokenInterface(widget)
                                                                       : nullptr;
}

}  // namespace

void offerSpoken() { QAccessible::installFactory(spokenInterface); }

void listenToSpoken(std::function<void(const QString& name)> listener) {
  spokenListener() = std::move(listener);
}

void tellSpokenName(QWidget& widget) {
  if (spokenListener())
    spokenListener()(QAccessible::queryAccessibleInterface(&widget)->text(QAccessible::Name));
  QAccessibleEvent event(&widget, QAccessible::NameChanged);
  QAccessible::updateAccessibility(&event);
}

void tellSpokenNumber(QWidget& widget) {
  if (!QAccessible::isActive()) return;
  const auto* spoken = dynamic_cast<const Spoken*>(&widget);
  const auto number = spoken != nullptr ? spoken->spokenNumber() : std::nullopt;
  if (!number) return;
  QAccessibleValueChangeEvent event(&widget, number->now);
  QAccessible::updateAccessibility(&event);
}

}  // namespace ui
