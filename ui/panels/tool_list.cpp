// SPDX-License-Identifier: BSD-3-Clause
#include "ui/panels/tool_list.h"

#include <QFontMetrics>
#include <QFrame>
#include <QKeyEvent>
#include <QListWidget>
#include <QListWidgetItem>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QScreen>
#include <QScrollBar>
#include <QStyle>
#include <QStyleOptionButton>
#include <QStyleOptionViewItem>
#include <QStyledItemDelegate>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace ui {
namespace {

constexpr QSize kPicture{84, 30}, kButtonPicture{56, 30};  // pixels
constexpr int kBeside = 8, kAbove = 4, kMarkWidth = 14;
constexpr int kWidest = 360;
constexpr double kSmallFont = 0.85;  // of the font
constexpr double kMostOfScreen = 0.8;

enum LineRole { kToolRole = Qt::UserRole, kPresentRole };  // kToolRole: its index, or one of these
constexpr int kGroupLine = -1, kFileLine = -2;

QFont smallOf(QFont font) {
  font.setPointSizeF(kSmallFont * font.pointSizeF());
  return font;
}

/// Text that steps back, still well legible.
QColor stepsBack(QColor colour) {
  colour.setAlphaF(0.75F);
  return colour;
}

QString inMillimetres(double metres) {
  const double mm = metres * 1e3;
  const bool whole = mm >= 10.0 || std::abs(mm - std::round(mm)) < 0.05;
  return QLocale().toString(mm, 'f', whole ? 0 : 1);
}

QString sizesOf(const ToolEntry& tool) {
  const QString length = ToolList::tr("length %1 mm").arg(inMillimetres(tool.length));
  if (tool.tip <= 0.0) return length;
  return ToolList::tr("%1 · tip %2 mm").arg(length, inMillimetres(tool.tip));
}

int heightOf(const QFont& font) {
  return std::max(kPicture.height(),
                  QFontMetrics(font).height() + QFontMetrics(smallOf(font)).height()) +
         2 * kAbove;
}

int widthOf(const ToolEntry& tool, QSize picture, const QFont& font) {
  return picture.width() + 3 * kBeside + kMarkWidth +
         std::max(QFontMetrics(font).horizontalAdvance(tool.title),
                  QFontMetrics(smallOf(font)).horizontalAdvance(sizesOf(tool)));
}

/// Picture, title and sizes, side by side.
void drawEntry(QPainter& painter, const QRect& where, const ToolEntry& tool,
               const ToolPicture& picture, QSize size, const QColor& ink) {
  const QRect left(where.left(), where.top() + (where.height() - size.height()) / 2, size.width(),
                   size.height());
  painter.drawPixmap(left.topLeft(),
                     picture.pixmap(size, painter.device()->devicePixelRatioF(), ink));
  const QFont font = painter.font(), small = smallOf(font);
  const QFontMetrics metrics(font), small_metrics(small);
  QRect text = where;
  text.setLeft(left.right() + 1 + kBeside);
  text.setTop(where.top() + (where.height() - metrics.height() - small_metrics.height()) / 2);
  painter.setPen(ink);
  painter.drawText(text, Qt::AlignLeft | Qt::AlignTop,
                   metrics.elidedText(tool.title, Qt::ElideRight, text.width()));
  text.setTop(text.top() + metrics.height());
  painter.setFont(small);
  painter.setPen(stepsBack(ink));
  painter.drawText(text, Qt::AlignLeft | Qt::AlignTop,
                   small_metrics.elidedText(sizesOf(tool), Qt::ElideRight, text.width()));
  painter.setFont(font);
}

/// Lines of one colour in a square: a tick, or an arrow down.
void drawMark(QPainter& painter, const QRect& where, const QColor& ink,
              std::initializer_list<QPointF> points) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.translate(where.center() + QPointF(0.5, 0.5));
  painter.setPen(QPen(ink, 1.7, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.drawPolyline(QPolygonF(points));
  painter.restore();
}

/// Closes at a click beside it. A click on the button that opened it does not open it again; any
/// other one, such as on the red button, does what it does.
class ToolPopup : public QFrame {
 public:
  explicit ToolPopup(QWidget* button) : QFrame(button, Qt::Popup), button_(button) {}

 protected:
  void mousePressEvent(QMouseEvent* event) override {
    const QPoint place = button_->mapFromGlobal(event->globalPosition().toPoint());
    setAttribute(Qt::WA_NoMouseReplay, button_->rect().contains(place));
    QFrame::mousePressEvent(event);
  }

 private:
  QWidget* button_;
};

}  // namespace

class ToolList::Delegate : public QStyledItemDelegate {
 public:
  explicit Delegate(ToolList& list) : QStyledItemDelegate(&list), list_(list) {}

  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    const int tool = index.data(kToolRole).toInt();
    if (tool == kGroupLine) return {0, QFontMetrics(option.font).height() + 3 * kAbove};
    if (tool == kFileLine) return {0, QFontMetrics(option.font).height() + 4 * kAbove};
    return {widthOf(list_.tools_[static_cast<std::size_t>(tool)].entry, kPicture, option.font),
            heightOf(option.font)};
  }

  void paint(QPainter* painter, const QStyleOptionViewItem& given,
             const QModelIndex& index) const override {
    QStyleOptionViewItem option = given;
    initStyleOption(&option, index);
    const int tool = index.data(kToolRole).toInt();
    const bool chosen = option.state.testFlag(QStyle::State_Selected);
    const QPalette::ColorRole role = chosen ? QPalette::HighlightedText : QPalette::Text;
    const QColor ink = option.palette.color(QPalette::Active, role);
    const QRect inside = option.rect.adjusted(kBeside, 0, -kBeside, 0);
    painter->save();
    painter->setFont(option.font);
    if (tool == kGroupLine) {
      QFont bold = smallOf(option.font);
      bold.setWeight(QFont::DemiBold);
      painter->setFont(bold);
      painter->setPen(stepsBack(ink));
      painter->drawText(inside.adjusted(0, 0, 0, -kAbove / 2), Qt::AlignLeft | Qt::AlignBottom,
                        option.text);
    } else {
      const QWidget* widget = option.widget;
      widget->style()->drawPrimitive(QStyle::PE_PanelItemViewItem, &option, painter, widget);
    }
    if (tool == kFileLine) {
      painter->setPen(ink);
      painter->drawText(inside.adjusted(kPicture.width() + kBeside, 0, 0, 0),
                        Qt::AlignLeft | Qt::AlignVCenter, option.text);
    } else if (tool != kGroupLine) {
      const Tool& shown = list_.tools_[static_cast<std::size_t>(tool)];
      drawEntry(*painter, inside.adjusted(0, 0, -kMarkWidth, 0), shown.entry, shown.picture,
                kPicture, ink);
      if (index.data(kPresentRole).toBool())
        drawMark(*painter,
                 {inside.right() - kMarkWidth + 1, inside.top(), kMarkWidth, inside.height()}, ink,
                 {{-5.0, 0.0}, {-1.5, 3.5}, {5.0, -4.0}});
    }
    painter->restore();
  }

 private:
  ToolList& list_;
};

ToolList::ToolList(QWidget* parent)
    : QPushButton(parent), popup_(new ToolPopup(this)), lines_(new QListWidget) {
  setAccessibleName(tr("Tool"));
  setToolTip(tr("Choose a tool"));
  setAutoDefault(false);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  popup_->setAttribute(Qt::WA_WindowPropagation);  // the colours of the panel
  popup_->setFrameShape(QFrame::StyledPanel);
  auto* layout = new QVBoxLayout(popup_);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(lines_);
  lines_->setObjectName("toolLines");
  lines_->setAccessibleName(tr("Tools"));
  lines_->setFrameShape(QFrame::NoFrame);
  lines_->setItemDelegate(new Delegate(*this));
  lines_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  lines_->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  lines_->setMouseTracking(true);
  lines_->installEventFilter(this);
  connect(this, &QPushButton::clicked, this, &ToolList::open);
  connect(lines_, &QListWidget::itemEntered, this, [this](QListWidgetItem* line) {
    if (line->flags().testFlag(Qt::ItemIsEnabled)) lines_->setCurrentItem(line);
  });
  connect(lines_, &QListWidget::itemClicked, this,
          [this](QListWidgetItem* line) { choose(lines_->row(line)); });
}

void ToolList::setTools(const QList<ToolEntry>& tools) {
  tools_.clear();
  for (const ToolEntry& tool : tools) tools_.push_back({tool, ToolPicture(tool.mesh)});
  listed_ = tools_.size();
  list();
}

void ToolList::showTool(const QString& id) {
  if (id == present_ && tools_.size() == listed_) return;
  present_ = id;
  if (tools_.size() > listed_) {
    tools_.resize(listed_);
    list();
  }
  markPresent();
}

void ToolList::showOther(const ToolEntry& tool) {
  tools_.resize(listed_);
  tools_.push_back({tool, ToolPicture(tool.mesh)});
  present_ = tool.id;
  list();
}

void ToolList::list() {
  lines_->clear();
  QString use;
  for (std::size_t k = 0; k < tools_.size(); ++k) {
    const ToolEntry& tool = tools_[k].entry;
    if (tool.use != use) {
      auto* group = new QListWidgetItem(use = tool.use, lines_);
      group->setFlags(Qt::NoItemFlags);
      group->setData(kToolRole, kGroupLine);
    }
    auto* line = new QListWidgetItem(tool.title, lines_);
    line->setData(kToolRole, static_cast<int>(k));
    line->setData(Qt::AccessibleTextRole, tr("%1, %2").arg(tool.title, sizesOf(tool)));
  }
  auto* file = new QListWidgetItem(tr("From a file…"), lines_);
  file->setData(kToolRole, kFileLine);
  file->setData(Qt::AccessibleTextRole, tr("Tool from a file"));
  markPresent();
}

void ToolList::markPresent() {
  for (int row = 0; row < lines_->count(); ++row) {
    QListWidgetItem* line = lines_->item(row);
    const int k = line->data(kToolRole).toInt();
    if (k < 0) continue;
    const ToolEntry& tool = tools_[static_cast<std::size_t>(k)].entry;
    const bool is_present = tool.id == present_;
    line->setData(kPresentRole, is_present);
    line->setData(Qt::AccessibleDescriptionRole,
                  is_present ? tr("%1; the present tool").arg(tool.use) : tool.use);
  }
  const Tool* tool = present();
  setAccessibleName(tool != nullptr ? tr("Tool: %1").arg(tool->entry.title) : tr("Tool"));
  setAccessibleDescription(
      tool != nullptr ? tr("%1, %2").arg(tool->entry.title, sizesOf(tool->entry)) : QString());
  updateGeometry();
  update();
}

const ToolList::Tool* ToolList::present() const {
  const auto found =
      std::ranges::find_if(tools_, [&](const Tool& tool) { return tool.entry.id == present_; });
  return found != tools_.end() ? &*found : nullptr;
}

void ToolList::open() {
  for (int row = 0; row < lines_->count(); ++row)
    if (lines_->item(row)->data(kPresentRole).toBool()) lines_->setCurrentRow(row);
  const QRect room = screen()->availableGeometry();
  int height = 2 * popup_->frameWidth();
  for (int row = 0; row < lines_->count(); ++row) height += lines_->sizeHintForRow(row);
  const int most = static_cast<int>(kMostOfScreen * room.height());
  const int bar = height > most ? lines_->verticalScrollBar()->sizeHint().width() : 0;
  const QSize size(std::max(width(), std::min(kWidest, lines_->sizeHintForColumn(0)) +
                                         2 * popup_->frameWidth() + bar),
                   std::min(height, most));
  const QPoint below = mapToGlobal(QPoint(0, QWidget::height()));
  popup_->setGeometry(
      {{std::clamp(below.x(), room.left(), std::max(room.left(), room.right() + 1 - size.width())),
        std::min(below.y(), room.bottom() + 1 - size.height())},
       size});
  popup_->show();
  lines_->setFocus();
  if (lines_->currentItem() != nullptr)
    lines_->scrollToItem(lines_->currentItem(), QAbstractItemView::PositionAtCenter);
}

void ToolList::choose(int row) {
  const QListWidgetItem* line = lines_->item(row);
  const int k = line != nullptr ? line->data(kToolRole).toInt() : kGroupLine;
  if (k == kGroupLine) return;
  popup_->hide();
  if (k == kFileLine)
    emit fileWanted();
  else
    emit toolChosen(tools_[static_cast<std::size_t>(k)].entry.id);
}

void ToolList::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
    case Qt::Key_Up:
    case Qt::Key_Down:
    case Qt::Key_F4:
    case Qt::Key_Return:
    case Qt::Key_Enter:
      return open();
    default:
      return QPushButton::keyPressEvent(event);
  }
}

bool ToolList::eventFilter(QObject* watched, QEvent* event) {
  if (watched != lines_ || event->type() != QEvent::KeyPress)
    return QPushButton::eventFilter(watched, event);
  switch (static_cast<QKeyEvent*>(event)->key()) {
    case Qt::Key_Return:
    case Qt::Key_Enter:
      choose(lines_->currentRow());
      return true;
    case Qt::Key_Escape:
    case Qt::Key_F4:
      popup_->hide();
      return true;
    default:
      return false;
  }
}

QSize ToolList::sizeHint() const {
  int width = 0;  // a file may have any name
  for (std::size_t k = 0; k < listed_; ++k)
    width = std::max(width, widthOf(tools_[k].entry, kButtonPicture, font()));
  return {width + 2 * kBeside, heightOf(font()) + 2 * kAbove};
}

QSize ToolList::minimumSizeHint() const {
  return {kButtonPicture.width() + 8 * kBeside + kMarkWidth, sizeHint().height()};
}

void ToolList::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  QStyleOptionButton option;
  initStyleOption(&option);
  style()->drawControl(QStyle::CE_PushButton, &option, &painter, this);
  const QColor ink = palette().color(QPalette::ButtonText);
  const QRect inside = rect().adjusted(kBeside, kAbove, -kBeside, -kAbove);
  painter.setFont(font());
  if (const Tool* tool = present())
    drawEntry(painter, inside.adjusted(0, 0, -kMarkWidth - kAbove, 0), tool->entry, tool->picture,
              kButtonPicture, ink);
  else
    painter.drawText(inside, Qt::AlignLeft | Qt::AlignVCenter, tr("No scan, no tool yet"));
  drawMark(painter, {inside.right() - kMarkWidth + 1, inside.top(), kMarkWidth, inside.height()},
           ink, {{-4.0, -2.0}, {0.0, 2.0}, {4.0, -2.0}});
}

}  // namespace ui
