// SPDX-License-Identifier: BSD-3-Clause
#include "ui/tab_order.h"

#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QGridLayout>
#include <QLayout>
#include <QLineEdit>
#include <QScrollArea>
#include <QSplitter>
#include <QWidget>
#include <algorithm>
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
  for (QObject* child : widget.children())
    if (auto* part = qobject_cast<QWidget*>(child)) collect(*part, stops);
}

}  // namespace

void orderTabs(QWidget& first_part, QWidget& last_part) {
  TabStops stops;
  collect(first_part, stops);
  collect(last_part, stops);
  for (std::size_t n = 1; n < stops.size(); ++n) QWidget::setTabOrder(stops[n - 1], stops[n]);
}

}  // namespace ui
