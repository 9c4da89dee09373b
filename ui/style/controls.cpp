// SPDX-License-Identifier: BSD-3-Clause
#include "ui/style/controls.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QEvent>
#include <QLineEdit>
#include <QPainter>
#include <QScrollBar>
#include <QStyleFactory>
#include <QStyleOption>
#include <QToolButton>
#include <algorithm>
#include <cmath>

#include "ui/style/style.h"

namespace ui::style {
namespace {

constexpr int kScrollBar = 10;  // px
constexpr int kIndicator = 16;  // px: check boxes
constexpr int kSliderHandle = 14;
constexpr int kTextMargin = 8;

void drawRound(QPainter& painter, const QRectF& rect, double corner, const QColor& fill,
               const QColor& edge, double width = 1.0) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(edge.alpha() == 0 ? QPen(Qt::NoPen) : QPen(edge, width));
  painter.setBrush(fill);
  const double by = edge.alpha() == 0 ? 0.0 : 0.5 * width;
  painter.drawRoundedRect(rect.adjusted(by, by, -by, -by), corner, corner);
  painter.restore();
}

void drawChevron(QPainter& painter, const QPointF& middle, double half, double degrees,
                 const QColor& colour) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.translate(middle);
  painter.rotate(degrees);
  painter.setPen(QPen(colour, 1.6, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.drawPolyline(QPolygonF({{-half, -0.5 * half}, {0.0, 0.5 * half}, {half, -0.5 * half}}));
  painter.restore();
}

const QColor& none() {
  static const QColor transparent(Qt::transparent);
  return transparent;
}

/// The edge of what can be used: it tells of the focus, and of the pointer.
QColor edgeOf(const QStyleOption& option) {
  const Colours& c = colours();
  if (!(option.state & QStyle::State_Enabled)) return c.line;
  if (option.state & QStyle::State_HasFocus) return c.accent;
  return option.state & QStyle::State_MouseOver ? c.dim : c.edge;
}

double focusWidth(const QStyleOption& option) {
  return option.state & QStyle::State_HasFocus ? 2.0 : 1.0;
}

bool hasWordsAlone(const QWidget* widget) {
  const auto* button = qobject_cast<const QToolButton*>(widget);
  return button != nullptr && !button->autoRaise() &&
         (button->icon().isNull() || button->toolButtonStyle() == Qt::ToolButtonTextOnly);
}

void drawField(QPainter& painter, const QStyleOption& option) {
  drawRound(painter, option.rect, kCorner, colours().control, edgeOf(option), focusWidth(option));
}

void drawButton(QPainter& painter, const QStyleOption& option, bool flat) {
  const Colours& c = colours();
  const bool enabled = option.state & QStyle::State_Enabled;
  const bool on = option.state & QStyle::State_On;
  const bool over = enabled && (option.state & (QStyle::State_MouseOver | QStyle::State_Sunken));
  const bool focus = option.state & QStyle::State_HasFocus;
  const QColor fill = on ? c.chosen : over ? c.hover : flat ? none() : c.control;
  QColor edge = flat && !on ? none() : on ? c.accent : edgeOf(option);
  if (focus) edge = c.accent;
  drawRound(painter, option.rect, kCorner, fill, edge, focus ? 2.0 : 1.0);
}

bool isEditorInList(const QWidget* widget) {
  const QWidget* viewport = widget != nullptr ? widget->parentWidget() : nullptr;
  return viewport != nullptr &&
         qobject_cast<const QAbstractItemView*>(viewport->parentWidget()) != nullptr;
}

}  // namespace

ControlStyle::ControlStyle() : QProxyStyle(QStyleFactory::create("Fusion")) {}

void ControlStyle::polish(QWidget* widget) {
  QProxyStyle::polish(widget);
  if (qobject_cast<QAbstractButton*>(widget) != nullptr ||
      qobject_cast<QComboBox*>(widget) != nullptr ||
      qobject_cast<QAbstractSpinBox*>(widget) != nullptr ||
      qobject_cast<QLineEdit*>(widget) != nullptr || qobject_cast<QScrollBar*>(widget) != nullptr)
    widget->setAttribute(Qt::WA_Hover);
  if (qobject_cast<QAbstractSpinBox*>(widget) != nullptr ||
      qobject_cast<QComboBox*>(widget) != nullptr ||
      (qobject_cast<QAbstractSlider*>(widget) != nullptr &&
       qobject_cast<QScrollBar*>(widget) == nullptr)) {
    if (widget->focusPolicy() == Qt::WheelFocus) widget->setFocusPolicy(Qt::StrongFocus);
    widget->installEventFilter(this);
  }
}

bool ControlStyle::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::Wheel) return QProxyStyle::eventFilter(watched, event);
  const auto* field = qobject_cast<const QWidget*>(watched);
  if (field != nullptr && field->hasFocus() && qobject_cast<const QComboBox*>(field) == nullptr)
    return false;
  event->ignore();  // what it lies in may be scrolled
  return true;
}

void ControlStyle::drawPrimitive(PrimitiveElement element, const QStyleOption* option,
                                 QPainter* painter, const QWidget* widget) const {
  const Colours& c = colours();
  switch (element) {
    case PE_PanelButtonCommand: {
      const auto* button = qstyleoption_cast<const QStyleOptionButton*>(option);
      return drawButton(*painter, *option, button && button->features & QStyleOptionButton::Flat);
    }
    case PE_FrameDefaultButton:
      return;
    case PE_PanelButtonTool:
    case PE_FrameButtonTool: {
      // what has words alone looks like a button, a symbol does not
      return drawButton(*painter, *option, !hasWordsAlone(widget));
    }
    case PE_PanelLineEdit:
    case PE_FrameLineEdit: {
      const auto* frame = qstyleoption_cast<const QStyleOptionFrame*>(option);
      // inside another field the field has the frame; over a line of a list nothing shines through
      if (frame != nullptr && frame->lineWidth == 0) {
        if (isEditorInList(widget)) painter->fillRect(option->rect, c.control);
        return;
      }
      return drawField(*painter, *option);
    }
    case PE_Frame:
    case PE_FrameGroupBox:
      painter->save();
      // a list without a line that could show the focus has its frame
      painter->setPen(option->state & State_HasFocus ? c.accent : c.line);
      painter->drawRect(option->rect.adjusted(0, 0, -1, -1));
      painter->restore();
      return;
    case PE_FrameMenu:
    case PE_PanelMenu:
      return drawRound(*painter, option->rect, 0.0, c.control, c.line);
    case PE_PanelTipLabel:
      return drawRound(*painter, option->rect, 0.0, c.control, c.edge);
    case PE_FrameStatusBarItem:
      return;
    case PE_FrameFocusRect:
      // the row in focus is selected, and says so
      if (qobject_cast<const QAbstractItemView*>(widget) != nullptr) return;
      return drawRound(*painter, option->rect, kCorner, none(), c.accent, 2.0);
    case PE_PanelItemViewItem: {
      QProxyStyle::drawPrimitive(element, option, painter, widget);
      // a bar as on the rail: the tint alone is no sign
      const auto* item = qstyleoption_cast<const QStyleOptionViewItem*>(option);
      if (item != nullptr && item->state & State_Selected && item->index.column() == 0)
        painter->fillRect(QRect(item->rect.left(), item->rect.top(), 3, item->rect.height()),
                          c.accent);
      return;
    }
    case PE_IndicatorCheckBox: {
      const bool enabled = option->state & State_Enabled, on = option->state & State_On;
      const QRectF box = QRectF(option->rect).adjusted(0.0, 0.0, 0.0, 0.0);
      drawRound(*painter, box, 4.0, on ? (enabled ? c.accent : c.line) : c.control,
                on ? none() : edgeOf(*option));
      if (!on) return;
      painter->save();
      painter->setRenderHint(QPainter::Antialiasing);
      painter->setPen(
          QPen(enabled ? c.on_accent : c.off, 2.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
      const auto at = [&](double x, double y) {
        return QPointF(box.left() + x * box.width(), box.top() + y * box.height());
      };
      painter->drawPolyline(QPolygonF({at(0.25, 0.53), at(0.43, 0.71), at(0.76, 0.32)}));
      painter->restore();
      return;
    }
    case PE_IndicatorRadioButton: {
      const bool enabled = option->state & State_Enabled, on = option->state & State_On;
      const QRectF box = QRectF(option->rect);
      drawRound(*painter, box, 0.5 * box.height(), c.control,
                on ? (enabled ? c.accent : c.line) : edgeOf(*option));
      if (on)
        drawRound(*painter, box.adjusted(4.0, 4.0, -4.0, -4.0), 0.5 * box.height() - 4.0,
                  enabled ? c.accent : c.off, none());
      return;
    }
    case PE_IndicatorArrowDown:
    case PE_IndicatorArrowUp:
    case PE_IndicatorArrowLeft:
    case PE_IndicatorArrowRight: {
      const double degrees = element == PE_IndicatorArrowDown   ? 0.0
                             : element == PE_IndicatorArrowUp   ? 180.0
                             : element == PE_IndicatorArrowLeft ? 90.0
                                                                : -90.0;
      return drawChevron(*painter, QRectF(option->rect).center(), 4.0, degrees,
                         option->state & State_Enabled ? c.dim : c.off);
    }
    default:
      return QProxyStyle::drawPrimitive(element, option, painter, widget);
  }
}

void ControlStyle::drawControl(ControlElement element, const QStyleOption* option,
                               QPainter* painter, const QWidget* widget) const {
  const Colours& c = colours();
  switch (element) {
    case CE_HeaderSection:
      painter->fillRect(option->rect, c.panel);
      painter->fillRect(QRect(option->rect.left(), option->rect.bottom(), option->rect.width(), 1),
                        c.line);
      return;
    case CE_HeaderEmptyArea:
      painter->fillRect(option->rect, c.panel);
      return;
    case CE_MenuBarEmptyArea:
      painter->fillRect(option->rect, c.panel);
      return;
    case CE_MenuBarItem: {
      const auto* item = qstyleoption_cast<const QStyleOptionMenuItem*>(option);
      if (item == nullptr) break;
      painter->fillRect(option->rect, c.panel);
      const bool over = option->state & State_Selected;
      if (over) drawRound(*painter, option->rect.adjusted(1, 2, -1, -2), 4.0, c.hover, none());
      drawItemText(painter, option->rect,
                   Qt::AlignCenter | Qt::TextShowMnemonic | Qt::TextSingleLine, option->palette,
                   option->state & State_Enabled, item->text, QPalette::ButtonText);
      return;
    }
    case CE_ProgressBarGroove:
      return drawRound(*painter, option->rect, 4.0, c.control, c.line);
    case CE_ProgressBarContents: {
      const auto* bar = qstyleoption_cast<const QStyleOptionProgressBar*>(option);
      // of an unknown length: Qt's own, which moves
      if (bar == nullptr || bar->maximum <= bar->minimum) break;
      const double share =
          static_cast<double>(bar->progress - bar->minimum) / (bar->maximum - bar->minimum);
      QRectF done = QRectF(option->rect).adjusted(1.0, 1.0, -1.0, -1.0);
      done.setWidth(std::clamp(share, 0.0, 1.0) * done.width());
      if (done.width() >= 1.0) drawRound(*painter, done, 3.0, c.accent, none());
      return;
    }
    case CE_ProgressBarLabel:
      return;  // the words beside it say what is done
    case CE_Splitter:
      painter->fillRect(option->rect, option->state & State_MouseOver ? c.accent : c.ground);
      painter->fillRect(QRect(option->rect.left(), option->rect.top(), 1, option->rect.height()),
                        c.line);
      return;
    case CE_ToolBar:
      painter->fillRect(option->rect, c.panel);
      return;
    default:
      break;
  }
  QProxyStyle::drawControl(element, option, painter, widget);
}

void ControlStyle::drawComplexControl(ComplexControl control, const QStyleOptionComplex* option,
                                      QPainter* painter, const QWidget* widget) const {
  const Colours& c = colours();
  switch (control) {
    case CC_ComboBox: {
      const auto* box = qstyleoption_cast<const QStyleOptionComboBox*>(option);
      if (box == nullptr) break;
      drawField(*painter, *option);
      const QRect arrow = subControlRect(CC_ComboBox, option, SC_ComboBoxArrow, widget);
      drawChevron(*painter, QRectF(arrow).center(), 4.0, 0.0,
                  option->state & State_Enabled ? c.dim : c.off);
      return;
    }
    case CC_SpinBox:
      drawField(*painter, *option);
      return;
    case CC_Slider: {
      const auto* slider = qstyleoption_cast<const QStyleOptionSlider*>(option);
      if (slider == nullptr || slider->orientation != Qt::Horizontal) break;
      const bool enabled = option->state & State_Enabled;
      QRectF handle = subControlRect(CC_Slider, option, SC_SliderHandle, widget);
      handle.moveTop(option->rect.top() + 0.5 * (option->rect.height() - handle.height()));
      handle.adjust(1.0, 1.0, -1.0, -1.0);
      QRectF groove = option->rect;
      groove.setTop(handle.center().y() - 2.0);
      groove.setHeight(4.0);
      drawRound(*painter, groove, 2.0, enabled ? c.edge : c.line, none());
      QRectF filled = groove;
      filled.setRight(handle.center().x());
      drawRound(*painter, filled, 2.0, enabled ? c.accent : c.line, none());
      drawRound(*painter, handle, 0.5 * handle.width(), enabled ? c.text : c.off,
                option->state & State_HasFocus ? c.accent : none(), 2.0);
      return;
    }
    case CC_ScrollBar: {
      const auto* bar = qstyleoption_cast<const QStyleOptionSlider*>(option);
      if (bar == nullptr) break;
      painter->fillRect(option->rect, option->palette.color(QPalette::Window));
      if (bar->maximum <= bar->minimum) return;
      const QRectF handle = QRectF(subControlRect(CC_ScrollBar, option, SC_ScrollBarSlider, widget))
                                .adjusted(2.0, 2.0, -2.0, -2.0);
      const bool held = option->state & (State_Sunken | State_MouseOver);
      return drawRound(*painter, handle, 3.0, held ? c.dim : c.edge, none());
    }
    default:
      break;
  }
  QProxyStyle::drawComplexControl(control, option, painter, widget);
}

QRect ControlStyle::subControlRect(ComplexControl control, const QStyleOptionComplex* option,
                                   SubControl part, const QWidget* widget) const {
  if (control == CC_ScrollBar) {
    // no buttons at its ends
    const auto* bar = qstyleoption_cast<const QStyleOptionSlider*>(option);
    if (bar != nullptr) {
      const bool level = bar->orientation == Qt::Horizontal;
      const int length = level ? bar->rect.width() : bar->rect.height();
      const int range = bar->maximum - bar->minimum;
      const int least = std::min(length, 28);
      int size = length;
      if (range > 0)
        size = std::clamp(static_cast<int>(static_cast<qint64>(length) * bar->pageStep /
                                           (static_cast<qint64>(range) + bar->pageStep)),
                          least, length);
      const int at = sliderPositionFromValue(bar->minimum, bar->maximum, bar->sliderPosition,
                                             length - size, bar->upsideDown);
      const auto span = [&](int from, int to) {
        const QRect rect = level ? QRect(from, 0, to - from, bar->rect.height())
                                 : QRect(0, from, bar->rect.width(), to - from);
        return visualRect(bar->direction, bar->rect, rect.translated(bar->rect.topLeft()));
      };
      switch (part) {
        case SC_ScrollBarSlider:
          return span(at, at + size);
        case SC_ScrollBarGroove:
          return span(0, length);
        case SC_ScrollBarSubPage:
          return span(0, at);
        case SC_ScrollBarAddPage:
          return span(at + size, length);
        default:
          return {};
      }
    }
  }
  if (control == CC_ComboBox && part == SC_ComboBoxEditField)
    return visualRect(option->direction, option->rect,
                      option->rect.adjusted(kTextMargin, 1, -24, -1));
  if (control == CC_ComboBox && part == SC_ComboBoxArrow)
    return visualRect(
        option->direction, option->rect,
        QRect(option->rect.right() - 23, option->rect.top(), 20, option->rect.height()));
  if (control == CC_SpinBox && part == SC_SpinBoxEditField)
    return option->rect.adjusted(kTextMargin - 2, 1, -2, -1);
  return QProxyStyle::subControlRect(control, option, part, widget);
}

QSize ControlStyle::sizeFromContents(ContentsType type, const QStyleOption* option,
                                     const QSize& size, const QWidget* widget) const {
  QSize made = QProxyStyle::sizeFromContents(type, option, size, widget);
  switch (type) {
    case CT_PushButton:
      made.setWidth(std::max(made.width(), size.width() + 2 * kTextMargin));
      made.setHeight(std::max(size.height() + 6, kControlHeight));
      break;
    case CT_ComboBox:
      made = {size.width() + kTextMargin + 28, std::max(size.height() + 6, kControlHeight)};
      break;
    case CT_SpinBox:
      made.setHeight(std::max(size.height() + 2, kControlHeight));
      break;
    case CT_LineEdit:
      if (const auto* frame = qstyleoption_cast<const QStyleOptionFrame*>(option);
          frame != nullptr && frame->lineWidth > 0)
        made.setHeight(std::max(size.height() + 2, kControlHeight));
      break;
    case CT_ToolButton:
      if (hasWordsAlone(widget))
        made = {size.width() + 2 * kTextMargin, std::max(size.height() + 6, kControlHeight)};
      break;
    case CT_MenuBarItem:
      made = {size.width() + 16, size.height() + 10};
      break;
    case CT_MenuItem:
      made.setHeight(std::max(made.height(), made.height() > 12 ? 26 : made.height()));
      break;
    default:
      break;
  }
  return made;
}

QRect ControlStyle::subElementRect(SubElement element, const QStyleOption* option,
                                   const QWidget* widget) const {
  const QRect rect = QProxyStyle::subElementRect(element, option, widget);
  if (element != SE_LineEditContents) return rect;
  const auto* frame = qstyleoption_cast<const QStyleOptionFrame*>(option);
  return frame != nullptr && frame->lineWidth > 0 ? rect.adjusted(4, 0, -4, 0) : rect;
}

int ControlStyle::pixelMetric(PixelMetric metric, const QStyleOption* option,
                              const QWidget* widget) const {
  switch (metric) {
    case PM_ScrollBarExtent:
      return kScrollBar;
    case PM_IndicatorWidth:
    case PM_IndicatorHeight:
      return kIndicator;
    case PM_SliderLength:
    case PM_SliderThickness:
    case PM_SliderControlThickness:
      return kSliderHandle;
    case PM_LayoutHorizontalSpacing:
    case PM_LayoutVerticalSpacing:
      return kGap;
    case PM_SplitterWidth:
      return 5;
    case PM_SmallIconSize:
    case PM_ButtonIconSize:
      return kSmallIcon;
    case PM_MenuBarPanelWidth:
      return 0;
    case PM_MenuPanelWidth:
      return 1;
    case PM_ButtonShiftHorizontal:
    case PM_ButtonShiftVertical:
      return 0;
    default:
      return QProxyStyle::pixelMetric(metric, option, widget);
  }
}

int ControlStyle::styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                            QStyleHintReturn* data) const {
  if (hint == SH_EtchDisabledText || hint == SH_DitherDisabledText) return 0;
  if (hint == SH_ToolTipLabel_Opacity) return 255;
  if (hint == SH_DialogButtonBox_ButtonsHaveIcons) return 0;
  return QProxyStyle::styleHint(hint, option, widget, data);
}

}  // namespace ui::style
