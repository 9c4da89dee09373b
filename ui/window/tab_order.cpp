// SPDX-License-Identifier: BSD-3-Clause
#include "ui/window/tab_order.h"

#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QGridLayout>
#include <QLayout>
#include <QLineEdit>
#include <QScrollArea>
#include <QSplitter>
#include <QWidget>
#include <algorithm>
#include <cstddef>
#include <tuple>
#include <vector>

namespace ui {
namespace {

using TabStops = std::vector<QWidget*>;

void collect(QWidget& widget, TabStops& stops);

void collect(const QLayout& layout, TabStops& stops) {
  std::vector<int> order;
  for (int n = 0; n < layout.count(); ++n) order.push_back(n);
  // a grid keeps its items in the order in which they were added
  if (const auto* grid = qobject_cast<const QGridLayout*>(&layout)) {
    const auto placeOf = [grid](int n) {
      int row = 0, column = 0, rows = 0, columns = 0;
      grid->getItemPosition(n, &row, &column, &rows, &columns);
      return std::tuple(row, column);
    };
    std::stable_sort(order.begin(), order.end(),
                     [&](int a, int b) { return placeOf(a) < placeOf(b); });
  }
  for (const int n : order) {
    QLayoutItem* item = layout.itemAt(n);
    if (item->widget() != nullptr)
      collect(*item->widget(), stops);
    else if (item->layout() != nullptr)
      collect(*item->layout(), stops);
  }
}

void collect(QWidget& widget, TabStops& stops) {
  if (std::find(stops.begin(), stops.end(), &widget) != stops.end() || widget.isWindow()) return;
  if ((widget.focusPolicy() & Qt::TabFocus) != 0 && widget.focusProxy() == nullptr)
    stops.push_back(&widget);
  // what these are made of is theirs
  if (qobject_cast<QAbstractItemView*>(&widget) || qobject_cast<QAbstractSpinBox*>(&widget) ||
      qobject_cast<QComboBox*>(&widget) || qobject_cast<QLineEdit*>(&widget))
    return;
  if (const auto* scroll = qobject_cast<QScrollArea*>(&widget)) {
    if (scroll->widget() != nullptr) collect(*scroll->widget(), stops);
    return;
  }
  if (const auto* splitter = qobject_cast<QSplitter*>(&widget)) {
    for (int n = 0; n < splitter->count(); ++n) collect(*splitter->widget(n), stops);
    return;
  }
  if (widget.layout() != nullptr) collect(*widget.layout(), stops);
  // what is placed without a layout
  std::vector<QWidget*> placed;
  for (QObject* child : widget.children())
    if (auto* part = qobject_cast<QWidget*>(child)) placed.push_back(part);
  std::stable_sort(placed.begin(), placed.end(), [](const QWidget* a, const QWidget* b) {
    return std::tuple(a->y(), a->x()) < std::tuple(b->y(), b->x());
  });
  for (QWidget* part : placed) collect(*part, stops);
}

}  // namespace

std::vector<QWidget*> tabStopsOf(QWidget& part) {
  TabStops stops;
  collect(part, stops);
  return stops;
}

QWidget* nextTabStop(const std::vector<QWidget*>& stops, bool forwards) {
  // the focus may be on a part of a stop, such as the field in which a line of a list is typed
  QWidget* focus = QApplication::focusWidget();
  auto found = stops.end();
  for (; focus != nullptr && found == stops.end(); focus = focus->parentWidget())
    found = std::find(stops.begin(), stops.end(), focus);
  const auto count = static_cast<std::ptrdiff_t>(stops.size());
  const std::ptrdiff_t from = found != stops.end() ? found - stops.begin() : forwards ? -1 : count;
  for (std::ptrdiff_t n = 1; n <= count; ++n) {
    QWidget* stop =
        stops[static_cast<std::size_t>((from + (forwards ? n : -n) + 2 * count) % count)];
    if (stop->isVisible() && stop->isEnabled()) return stop;
  }
  return nullptr;
}

}  // namespace ui
