// SPDX-License-Identifier: BSD-3-Clause
#include "ui/window/view_frame.h"

#include <QEvent>
#include <QIcon>
#include <QLabel>
#include <QPainter>
#include <QToolButton>

#include "ui/controls/bindings.h"
#include "ui/panels/force_panel.h"
#include "ui/style/scene_colours.h"
#include "ui/style/style.h"

namespace ui {
namespace {

constexpr int kLine = 2;  // px, of the coloured line above the view
constexpr int kCardMargin = 12;
// px from the top of the view to a card there, and about the card that stay free
constexpr int kBelowCube = 108, kBelowSentences = 84, kClear = 8;
constexpr std::size_t kCorners = 4;
constexpr QSize kRoomForPlot{420, 320}, kRoomForCard{150, 100};  // px, of the view
constexpr int kButton = 20;                                      // px
constexpr int kHint = 20;                                        // px, height of the line

enum class Sign { Menu, Larger, Smaller, Close };

QIcon iconOf(Sign sign) {
  QIcon icon;
  for (const int scale : {1, 2, 3}) {
    QPixmap pixmap(16 * scale, 16 * scale);
    pixmap.setDevicePixelRatio(scale);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    const QColor& colour = sign == Sign::Close ? style::kViewDim : style::kViewText;
    painter.setPen(QPen(colour, 1.5, Qt::SolidLine, Qt::RoundCap));
    if (sign == Sign::Menu) {
      for (const double y : {4.5, 8.0, 11.5}) painter.drawLine(QPointF{3.0, y}, QPointF{13.0, y});
    } else if (sign == Sign::Close) {
      painter.drawLine(QPointF{5.0, 5.0}, QPointF{11.0, 11.0});
      painter.drawLine(QPointF{5.0, 11.0}, QPointF{11.0, 5.0});
    } else {
      // brackets of two opposite corners, which open to the outside or to the inside
      const double tip = sign == Sign::Larger ? 3.0 : 7.0, arm = sign == Sign::Larger ? 4.0 : -4.0;
      for (const double side : {1.0, -1.0}) {
        painter.save();
        painter.translate(8.0, 8.0);
        painter.scale(side, side);
        painter.translate(-8.0, -8.0);
        painter.drawLine(QPointF{tip, tip}, QPointF{tip + arm, tip});
        painter.drawLine(QPointF{tip, tip}, QPointF{tip, tip + arm});
        painter.restore();
      }
    }
    painter.end();
    icon.addPixmap(pixmap);
  }
  return icon;
}

/// As many sentences as fit into so many pixels, and a sign that there are more.
QString wholeSentences(const QString& text, const QFontMetrics& metrics, int width) {
  static const QString kMore = QStringLiteral(" …");
  if (metrics.horizontalAdvance(text) <= width) return text;
  qsizetype end = 0;
  for (qsizetype next = 0; (next = text.indexOf(QLatin1String(". "), next)) >= 0; ++next)
    if (metrics.horizontalAdvance(text.left(next + 1) + kMore) <= width) end = next + 1;
  return end > 0 ? text.left(end) + kMore : metrics.elidedText(text, Qt::ElideRight, width);
}

/// A button over a view, which is dark in every theme.
class ViewButton : public QToolButton {
 public:
  explicit ViewButton(QWidget* parent) : QToolButton(parent) { setAttribute(Qt::WA_Hover); }

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(hasFocus() ? QPen(style::kViewFocus, 1.5) : QPen(Qt::NoPen));
    painter.setBrush(underMouse() || hasFocus() ? style::kViewFrame : style::kViewButton);
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 4.0, 4.0);
    icon().paint(&painter, rect().adjusted(2, 2, -2, -2));
  }
};

QToolButton* buttonOf(QWidget* parent, const char* name, Sign sign) {
  auto* button = new ViewButton(parent);
  button->setObjectName(name);
  button->setIcon(iconOf(sign));
  button->setIconSize({16, 16});
  button->setFixedSize(kButton, kButton);
  button->setFocusPolicy(Qt::TabFocus);
  return button;
}

}  // namespace

ViewFrame::ViewFrame(QWidget* view, const QColor& colour, bool has_menu, QWidget* parent)
    : QWidget(parent), view_(view), colour_(colour) {
  view->setParent(this);
  if (has_menu) {
    menu_ = buttonOf(this, "viewMenu", Sign::Menu);
    menu_->setAccessibleName(tr("Choices for slices"));
    connect(menu_, &QToolButton::clicked, this, [this] {
      emit menuWanted(menu_->mapToGlobal(QPoint{0, kButton}));
    });
  }
  maximise_ = buttonOf(this, "maximise", Sign::Larger);
  connect(maximise_, &QToolButton::clicked, this, &ViewFrame::maximiseWanted);
  whenKeysChange(*this, [this] {
    if (menu_ != nullptr) menu_->setToolTip(withKey(tr("Choices for slices"), Action::SliceMenu));
    setMaximised(maximised_);
  });
  hint_ = new QLabel(this);
  hint_->setObjectName("viewHint");
  QPalette dark;
  dark.setColor(QPalette::Window, style::kViewGround);
  dark.setColor(QPalette::WindowText, style::kViewDim);
  hint_->setPalette(dark);
  hint_->setAutoFillBackground(true);
  hint_->setIndent(6);
  style::setType(*hint_, style::Type::Small);
  hide_hint_ = buttonOf(this, "hideHints", Sign::Close);
  hide_hint_->setToolTip(tr("Hide the hints of all views (View > Hints shows them again)"));
  hide_hint_->setAccessibleName(tr("Hide hints"));
  connect(hide_hint_, &QToolButton::clicked, this, &ViewFrame::hintsUnwanted);
}

void ViewFrame::setHint(const QString& hint) {
  if (hint == hint_words_) return;
  hint_words_ = hint;
  hint_->setToolTip(hint);
  hint_->setAccessibleName(hint);
  place();
}

void ViewFrame::setHintShown(bool shown) {
  hint_shown_ = shown;
  place();
}

void ViewFrame::setMaximised(bool maximised) {
  maximise_->setIcon(iconOf(maximised ? Sign::Smaller : Sign::Larger));
  maximised_ = maximised;
  maximise_->setToolTip(
      withKey(maximised ? tr("Show the other views again") : tr("Show this view alone"),
              Action::ViewAlone));
  maximise_->setAccessibleName(maximised ? tr("Show the other views again")
                                         : tr("Show this view alone"));
}

QSize ViewFrame::minimumSizeHint() const {
  const int hint = hint_shown_ ? kHint : 0;
  return view_->minimumSize().expandedTo({120, 100}) + QSize{0, kLine + hint};
}

void ViewFrame::setCard(ForcePanel& card, std::function<bool(const QRect& part)> taken) {
  card_ = &card;
  taken_ = std::move(taken);
  card.setParent(this);
  card.show();
  connect(&card, &ForcePanel::foldWanted, this, [this](bool folded) {
    setCardFolded(folded);
    emit cardFoldedChanged();
  });
  place();
}

void ViewFrame::setCardFolded(bool folded) {
  card_folded_ = folded;
  keepCardClear();
}

bool ViewFrame::event(QEvent* event) {
  // the card became taller or lower
  if (event->type() == QEvent::LayoutRequest) place();
  return QWidget::event(event);
}

void ViewFrame::paintEvent(QPaintEvent*) {
  QPainter(this).fillRect(QRect(0, 0, width(), kLine), colour_);
}

void ViewFrame::resizeEvent(QResizeEvent*) { place(); }

void ViewFrame::place() {
  QRect inner = rect().adjusted(0, kLine, 0, 0);
  hint_->setVisible(hint_shown_);
  hide_hint_->setVisible(hint_shown_);
  if (hint_shown_) {
    inner.setBottom(inner.bottom() - kHint);
    hint_->setGeometry(inner.left(), inner.bottom() + 1, inner.width(), kHint);
    hint_->setText(wholeSentences(hint_words_, hint_->fontMetrics(), inner.width() - kHint - 10));
    hide_hint_->setGeometry(inner.right() + 1 - kHint, inner.bottom() + 1, kHint, kHint);
    hide_hint_->raise();
  }
  view_->setGeometry(inner);
  keepCardClear();
  int x = width() - 4 - kButton;
  for (QToolButton* button : {maximise_, menu_}) {
    if (button == nullptr) continue;
    button->move(x, kLine + 4);
    button->raise();
    x -= kButton + 2;
  }
}

QRect ViewFrame::cardIn(std::size_t corner, bool folded) const {
  const QRect view = view_->geometry();
  const int height = card_->heightIf(folded);
  const int right = view.right() + 1 - kCardMargin - card_->width();
  const int low = view.bottom() + 1 - kCardMargin - height;
  const QPoint places[kCorners] = {{right, low},
                                   {view.left() + kCardMargin, low},
                                   {right, view.top() + kBelowCube},
                                   {view.left() + kCardMargin, view.top() + kBelowSentences}};
  return {places[corner], QSize(card_->width(), height)};
}

void ViewFrame::keepCardClear() {
  if (card_ == nullptr) return;
  const auto holds = [&](QSize room) {
    return view_->width() >= room.width() && view_->height() >= room.height();
  };
  card_->setVisible(holds(kRoomForCard));
  card_->setCompact(!holds(kRoomForPlot));
  const auto isFree = [&](std::size_t corner, bool folded) {
    const QRect part = cardIn(corner, folded).adjusted(-kClear, -kClear, kClear, kClear);
    return !taken_(part.translated(-view_->pos()));
  };
  bool folded = true;
  for (const bool one_line : {card_folded_, true}) {
    std::size_t n = corner_;  // where it is, as long as it may
    for (std::size_t other = 0; other < kCorners && !isFree(n, one_line); ++other) n = other;
    if (!isFree(n, one_line)) continue;
    corner_ = n;
    folded = one_line;
    break;
  }
  card_->setFolded(folded);
  const QRect place = cardIn(corner_, folded);
  if (card_->geometry() == place) return;
  card_->setGeometry(place);
  card_->raise();
}

}  // namespace ui
