// SPDX-License-Identifier: BSD-3-Clause
#include "ui/window/view_frame.h"

#include <QEvent>
#include <QIcon>
#include <QLabel>
#include <QPainter>
#include <QToolButton>
#include <algorithm>

#include "ui/controls/bindings.h"
#include "ui/panels/force_panel.h"
#include "ui/props/viewport.h"
#include "ui/style/scene_colours.h"
#include "ui/style/style.h"

namespace ui {
namespace {

constexpr int kLine = 2;     // px, of the coloured line above the view
constexpr int kBetween = 4;  // px, between two views of the same thing
constexpr QSize kLeastOfTwo{160, 164};
constexpr double kHighest = 1.5;  // in widths: beyond that two views stand above each other
constexpr int kCardMargin = 12;
// px from the top of the view to a card there, and about the card that stay free
constexpr int kBelowCube = 108, kBelowSentences = 84, kAboutCard = 8;
constexpr std::size_t kCorners = 4;
constexpr QSize kRoomForPlot{420, 320}, kRoomForCard{150, 100};  // px, of the view
constexpr int kButton = 20;                                      // px
constexpr int kPlate = 3;           // px, about the value under the pointer
constexpr int kBesideLetters = 30;  // px, from the edge of the 3-D view
constexpr int kHint = 34;           // px, height of two lines: another hint moves no view

enum class Sign { Menu, Larger, Smaller, Close, Fit, Follow, Stay };

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
    } else if (sign == Sign::Fit) {
      painter.drawEllipse(QRectF{5.0, 4.0, 6.0, 8.0});
      painter.drawRect(QRectF{2.5, 2.5, 11.0, 11.0});
    } else if (sign == Sign::Follow || sign == Sign::Stay) {
      // a crosshair, whose middle is full while it goes with the tool
      for (const QPointF& way : {QPointF{1, 0}, QPointF{-1, 0}, QPointF{0, 1}, QPointF{0, -1}})
        painter.drawLine(QPointF{8.0, 8.0} + 3.5 * way, QPointF{8.0, 8.0} + 6.0 * way);
      if (sign == Sign::Follow) painter.setBrush(style::kViewFocus);
      painter.drawEllipse(QPointF{8.0, 8.0}, 3.5, 3.5);
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

/// As many sentences as fit into two lines of so many pixels, broken between words.
QString wholeSentences(const QString& text, const QFontMetrics& metrics, int width) {
  const auto inLines = [&](const QString& words) -> QString {
    if (metrics.horizontalAdvance(words) <= width) return words;
    for (qsizetype at = words.size(); (at = words.lastIndexOf(' ', at - 1)) > 0;)
      if (metrics.horizontalAdvance(words.left(at)) <= width)
        return metrics.horizontalAdvance(words.mid(at + 1)) <= width
                   ? words.left(at) + '\n' + words.mid(at + 1)
                   : QString();
    return {};
  };
  for (qsizetype end = text.size(); end > 0;
       end = text.left(end - 1).lastIndexOf(QLatin1String(". ")) + 1)
    if (const QString lines = inLines(text.left(end)); !lines.isEmpty()) return lines;
  return metrics.elidedText(text, Qt::ElideRight, width);
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
    fit_ = buttonOf(this, "fitBody", Sign::Fit);
    fit_->setAccessibleName(tr("Fit to the body"));
    connect(fit_, &QToolButton::clicked, this, &ViewFrame::fitWanted);
    follow_ = buttonOf(this, "followTool", Sign::Follow);
    follow_->setCheckable(true);
    follow_->setAccessibleName(tr("Follow the tool"));
    connect(follow_, &QToolButton::clicked, this, &ViewFrame::followWanted);
    setFollowing(true);
  }
  maximise_ = buttonOf(this, "maximise", Sign::Larger);
  connect(maximise_, &QToolButton::clicked, this, &ViewFrame::maximiseWanted);
  whenKeysChange(*this, [this] {
    if (menu_ != nullptr) menu_->setToolTip(withKey(tr("Choices for slices"), Action::SliceMenu));
    if (fit_ != nullptr)
      fit_->setToolTip(withKey(tr("Shows the body as large as it can be"), Action::FitBody));
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
  pointed_ = new QLabel(this);
  pointed_->setObjectName("pointed");
  pointed_->setPalette(dark);
  pointed_->setAutoFillBackground(true);
  pointed_->setMargin(kPlate);
  pointed_->setTextFormat(Qt::PlainText);  // names come from files
  pointed_->setWordWrap(true);
  pointed_->setAttribute(Qt::WA_TransparentForMouseEvents);
  pointed_->hide();
  style::setType(*pointed_, style::Type::Small);
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

void ViewFrame::setPointed(const QString& words, std::vector<QRectF> written) {
  written_ = std::move(written);
  if (words != pointed_->text()) pointed_->setText(words);
  pointed_->setVisible(!words.isEmpty());
  placePointed();
}

void ViewFrame::placePointed() {
  if (pointed_->isHidden()) return;
  const QRect view = view_->geometry();
  const int single = pointed_->fontMetrics().horizontalAdvance(pointed_->text()) + 2 * kPlate + 2;
  const int wide = std::min(single, view.width() - 2 * kPlate);
  pointed_->resize(wide, pointed_->heightForWidth(wide));
  constexpr int kClear = 24, kStep = 8;  // px, from the pointer, and between two places
  // between the letters at the edges and the middle
  const QRect room =
      view.adjusted(kBesideLetters, kBesideLetters, -kBesideLetters, -kBesideLetters);
  const QPoint pointer = mapFromGlobal(QCursor::pos());
  const auto isFree = [&](const QRect& plate) {
    const QRectF part(plate.translated(-view.topLeft()));
    return !plate.adjusted(-kClear, -kClear, kClear, kClear).contains(pointer) &&
           std::ranges::none_of(covered_,
                                [&](const QRectF& one) { return one.intersects(part); }) &&
           std::ranges::none_of(written_, [&](const QRectF& one) { return one.intersects(part); });
  };
  const int first = std::min(room.left(), view.right() + 1 - kPlate - wide);
  QRect place({first, room.top()}, pointed_->size());
  for (const int left : {std::max(first, room.right() + 1 - wide), first})
    for (int top = room.bottom() + 1 - place.height(); top >= room.top(); top -= kStep)
      if (const QRect plate({left, top}, place.size()); isFree(plate)) place = plate;
  pointed_->setGeometry(place);
  pointed_->raise();
}

void ViewFrame::setFollowing(bool on) {
  if (follow_ == nullptr) return;
  follow_->setChecked(on);
  follow_->setIcon(iconOf(on ? Sign::Follow : Sign::Stay));
  follow_->setToolTip(on ? tr("The slices go with the tool. A click lets them stay")
                         : tr("The slices stay. A click lets them go with the tool"));
}

QList<QToolButton*> ViewFrame::buttons() const {
  QList<QToolButton*> all;
  for (QToolButton* button : {maximise_, menu_, fit_, follow_})
    if (button != nullptr) all << button;
  return all;
}

int ViewFrame::buttonRoom() const { return static_cast<int>(buttons().size()) * (kButton + 2) + 2; }

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
  const QSize least = before_ != nullptr ? kLeastOfTwo : view_->minimumSize();
  return least.expandedTo({120, 100}) + QSize{0, kLine + hint};
}

void ViewFrame::setBefore(QWidget* before) {
  before_ = before;
  if (before != nullptr) {
    const QSize half = (kLeastOfTwo - QSize{kBetween, kBetween}) / 2;
    before->setMinimumSize(half);
    view_->setMinimumSize(half);
    before->setParent(this);
    before->lower();
    before->show();
  } else {
    view_->setMinimumSize(Viewport::kLeast);
  }
  updateGeometry();
  place();
  update();
}

void ViewFrame::setCard(ForcePanel& card, IsIn taken, IsIn disliked) {
  card_ = &card;
  taken_ = std::move(taken);
  disliked_ = std::move(disliked);
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
  QPainter painter(this);
  if (before_ != nullptr) painter.fillRect(rect(), style::kBetweenViews);
  painter.fillRect(QRect(0, 0, width(), kLine), colour_);
}

void ViewFrame::resizeEvent(QResizeEvent*) { place(); }

void ViewFrame::place() {
  QRect inner = rect().adjusted(0, kLine, 0, 0);
  hint_->setVisible(hint_shown_);
  hide_hint_->setVisible(hint_shown_);
  if (hint_shown_) {
    hint_->setText(wholeSentences(hint_words_, hint_->fontMetrics(), inner.width() - kButton - 10));
    inner.setBottom(inner.bottom() - kHint);
    hint_->setGeometry(inner.left(), inner.bottom() + 1, inner.width(), kHint);
    hide_hint_->setGeometry(inner.right() + 1 - kButton, inner.bottom() + 1, kButton, kButton);
    hide_hint_->raise();
  }
  QRect after = inner;
  if (before_ != nullptr) {
    // the same size: a pixel of both is the same place
    const bool beside = kHighest * inner.width() >= inner.height();
    QRect before = inner;
    if (beside) {
      before.setWidth((inner.width() - kBetween) / 2);
      after.setLeft(after.right() + 1 - before.width());
    } else {
      before.setHeight((inner.height() - kBetween) / 2);
      after.setTop(after.bottom() + 1 - before.height());
    }
    before_->setGeometry(before);
  }
  view_->setGeometry(after);
  keepCardClear();
  placePointed();
  int x = width() - 4 - kButton;
  for (QToolButton* button : buttons()) {
    button->move(x, kLine + 3);
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
  const auto isFree = [&](std::size_t corner, bool folded, bool liked) {
    const QRect part = cardIn(corner, folded)
                           .adjusted(-kAboutCard, -kAboutCard, kAboutCard, kAboutCard)
                           .translated(-view_->pos());
    return !meetsSentence(part) && !taken_(part) && (!liked || !disliked_(part));
  };
  bool folded = true;
  const std::pair<bool, bool> ways[] = {{card_folded_, true}, {true, true}, {true, false}};
  for (const auto& [one_line, liked] : ways) {
    std::size_t n = corner_;  // where it is, as long as it may
    for (std::size_t other = 0; other < kCorners && !isFree(n, one_line, liked); ++other) n = other;
    if (!isFree(n, one_line, liked)) continue;
    corner_ = n;
    folded = one_line;
    break;
  }
  card_->setFolded(folded);
  const QRect place = cardIn(corner_, folded);
  if (card_->geometry() != place) {
    card_->setGeometry(place);
    card_->raise();
  }
  tellCovered();
}

void ViewFrame::setSentences(const QList<QRect>& parts) {
  if (parts == sentences_) return;
  sentences_ = parts;
  keepCardClear();
  tellCovered();
}

bool ViewFrame::meetsSentence(const QRect& part) const {
  return std::ranges::any_of(sentences_, [&](const QRect& one) { return one.intersects(part); });
}

void ViewFrame::tellCovered() {
  std::vector<QRectF> parts(sentences_.begin(), sentences_.end());
  if (card_ != nullptr && !card_->isHidden())
    parts.emplace_back(card_->geometry().translated(-view_->pos()));
  if (parts == covered_) return;
  covered_ = parts;
  placePointed();
  emit coveredChanged(covered_);
}

}  // namespace ui
