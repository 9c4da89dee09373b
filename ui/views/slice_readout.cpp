// SPDX-License-Identifier: BSD-3-Clause
#include "ui/views/slice_readout.h"

#include <QCoreApplication>
#include <QFontMetrics>
#include <algorithm>
#include <cmath>

#include "ui/controls/lengths.h"
#include "ui/style/scene_colours.h"

namespace ui {
namespace {

constexpr int kTextPixels = 11, kLetterPixels = 17, kLettersPixels = 12;

int letterPixels(const QString& letters) {
  return letters.size() > 1 ? kLettersPixels : kLetterPixels;
}

QString sliceWords(const char* text) { return QCoreApplication::translate("ui::SliceView", text); }

QString placeWords(double mm) {
  return readoutLocale().toString(mm / mmPerLengthUnit(), 'f', lengthDecimals(1));
}

constexpr int kRow = 14, kTop = 26, kGap = 8, kEdge = 5;  // px
constexpr int kSide = 20, kObliqueSide = 28;              // px, for one letter, and for three
constexpr double kRulerShare = 0.3, kLongestRuler = 100.0, kShortestRuler = 12.0;

/// One row of the margin. Texts come from both ends, beside what stands in the middle.
class Row {
 public:
  /// `covered`: px at its right end that are not free.
  Row(ReadoutLayout& layout, const QFont& font, QRect room, int covered = 0)
      : layout_(layout),
        font_(font),
        left_(room.left()),
        right_(room.right() + 1 - covered),
        room_(room) {}

  enum class End { Left, Middle, Right };

  /// Whether there was room.
  bool place(const QString& text, End end, const QColor& colour, int pixels = kTextPixels,
             bool bold = false) {
    if (text.isEmpty()) return true;
    QFont font = font_;
    font.setPixelSize(pixels);
    font.setBold(bold);
    const int width = QFontMetrics(font).horizontalAdvance(text) + 2;
    const auto box = take(width, end);
    if (!box) return false;
    layout_.texts.push_back({*box, text, colour, pixels, bold});
    return true;
  }

  std::optional<QRect> take(int width, End end) {
    int x = left_;
    if (end == End::Right) x = right_ - width;
    if (end == End::Middle)
      x = std::min(room_.left() + (room_.width() - width) / 2, right_ - width);
    const QRect box(x, room_.top(), width, room_.height());
    if (x < left_ || x + width > right_) return {};
    if (middle_.isValid() && box.adjusted(-kGap, 0, kGap, 0).intersects(middle_)) return {};
    if (end == End::Left) left_ = x + width + kGap;
    if (end == End::Middle) middle_ = box;
    if (end == End::Right) right_ = x - kGap;
    return box;
  }

  /// How wide a text at the left may be.
  int roomAtLeft() const {
    return (middle_.isValid() ? middle_.left() - kGap : right_) - left_ - 2;
  }
  int roomAtRight() const {
    return right_ - (middle_.isValid() ? middle_.right() + 1 + kGap : left_) - 2;
  }

 private:
  ReadoutLayout& layout_;
  QFont font_;
  int left_, right_;
  QRect room_, middle_;
};

}  // namespace

QLocale readoutLocale() {
  QLocale locale;
  locale.setNumberOptions(QLocale::OmitGroupSeparator);
  return locale;
}

double rulerLength_mm(double longest_mm) {
  const double decade = std::pow(10.0, std::floor(std::log10(longest_mm)));
  for (const double times : {5.0, 2.0})
    if (times * decade <= longest_mm) return times * decade;
  return decade;
}

QString positionWords(const Eigen::Vector3d& p_W_mm, int axis) {
  return QStringLiteral("%1 %2").arg(QChar('x' + axis), placeWords(p_W_mm[axis]));
}

QString positionWords(const Eigen::Vector3d& p_W_mm, bool sides_known) {
  QStringList numbers;
  for (const double mm : p_W_mm) numbers << placeWords(mm);
  const bool comma = readoutLocale().decimalPoint() == QStringLiteral(",");
  return QStringLiteral("%1 %2 %3")
      .arg(sides_known ? QStringLiteral("LPS") : sliceWords("scan"),
           numbers.join(comma ? QStringLiteral("; ") : QStringLiteral(", ")), lengthUnitName());
}

QString rulerWords(double mm) {
  const double shown = mm / mmPerLengthUnit();
  const int decimals = shown < 0.0095 ? 3 : shown < 0.095 ? 2 : shown < 0.95 ? 1 : 0;
  return readoutLocale().toString(shown, 'f', decimals) + ' ' + lengthUnitName();
}

QString intensityWords(double value, const haptics::Volume& volume) {
  const bool whole = volume.type != haptics::ScalarType::Float32 || std::abs(value) >= 1000.0;
  const QString number = whole ? readoutLocale().toString(std::round(value) + 0.0, 'f', 0)
                               : readoutLocale().toString(value, 'g', 4);
  return volume.unit.empty() ? number : number + ' ' + QString::fromStdString(volume.unit);
}

QRect pictureIn(QRect widget, bool oblique) {
  const int side = oblique ? kObliqueSide : kSide;
  return widget.adjusted(side, kTop, -side, -(2 * kRow + 4));
}

ReadoutLayout layOut(const SliceReadout& readout, const QFont& font, QRect widget, QRect picture,
                     int buttons, double mm_per_pixel) {
  using enum Row::End;
  ReadoutLayout layout;
  const int left = widget.left() + kEdge, width = widget.width() - 2 * kEdge;
  const int bottom = picture.bottom() + 1;
  Row top(layout, font, {left, widget.top() + 4, width, kTop - 8}, buttons);
  Row foot(layout, font, {left, bottom + 2, width, kRow});
  Row last(layout, font, {left, bottom + 2 + kRow, width, kRow});
  const QColor ink = style::kReadout;

  if (readout.sides_known) {
    const auto beside = [&](QRect room, const QString& text) {
      if (text.isEmpty()) return;
      const int pixels = letterPixels(text);
      QFont bold = font;
      bold.setPixelSize(pixels);
      bold.setBold(true);
      QRect box(0, 0, QFontMetrics(bold).horizontalAdvance(text), pixels + 2);
      box.moveCenter(room.center());
      layout.texts.push_back({box, text, style::kLetter, pixels, true});
    };
    const int right = picture.right() + 1;
    beside({widget.left(), picture.top(), picture.left() - widget.left(), picture.height()},
           readout.letters[0]);
    beside({right, picture.top(), widget.right() + 1 - right, picture.height()},
           readout.letters[1]);
    top.place(readout.letters[2], Middle, style::kLetter, letterPixels(readout.letters[2]), true);
    foot.place(readout.letters[3], Middle, style::kLetter, letterPixels(readout.letters[3]), true);
  } else if (!top.place(sliceWords("left/right unknown"), Middle, style::kViewAttention)) {
    foot.place(sliceWords("left/right unknown"), Middle, style::kViewAttention);
  }
  QFont bold = font;
  bold.setPixelSize(kTextPixels);
  bold.setBold(true);
  const QString number = readout.place.section(QStringLiteral("   "), 0, 0);
  const QString at = readout.place.section(QStringLiteral("   "), 1);
  // words give way to the number, but for the short name: without it, nobody knows which slice it
  // is
  QFont plain = font;
  plain.setPixelSize(kTextPixels);
  const QFontMetrics metrics(bold);
  const int numbered =
      number.isEmpty() ? 0 : QFontMetrics(plain).horizontalAdvance(number) + kGap + 2;
  const int room = top.roomAtLeft() - numbered;
  const QString& name =
      metrics.horizontalAdvance(readout.name) <= room ? readout.name : readout.short_name;
  const int named =
      std::min(top.roomAtLeft(), std::max(room, metrics.horizontalAdvance(readout.short_name)));
  top.place(metrics.elidedText(name, Qt::ElideRight, named), Left, readout.colour, kTextPixels,
            true);
  if (!top.place(number, Left, ink)) foot.place(number, Left, ink);
  const bool above = top.place(at, Right, ink);

  foot.place(readout.grey, Left, ink);
  // behind the value where all of it fits; else below it, in place of the position
  const QFontMetrics plain_metrics(plain);
  const QString both = readout.value + QStringLiteral("   ") + readout.structures;
  const bool beside_value =
      !readout.structures.isEmpty() && plain_metrics.horizontalAdvance(both) <= foot.roomAtRight();
  foot.place(beside_value ? both : readout.value, Right, ink);
  const double mm =
      rulerLength_mm(std::min(kRulerShare * picture.width(), kLongestRuler) * mm_per_pixel);
  const int length = qRound(mm / mm_per_pixel);
  if (length >= kShortestRuler)
    if (const auto box = last.take(length + 1, Left)) {
      layout.ruler =
          QLineF(box->left(), box->center().y(), box->left() + length, box->center().y());
      last.place(rulerWords(mm), Left, ink);
    }
  const bool said = readout.slab.isEmpty() || last.place(readout.slab, Right, ink) ||
                    foot.place(readout.slab, Left, ink) || top.place(readout.slab, Right, ink);
  if (!said) foot.place(readout.slab, Right, ink);
  if (!last.place(readout.note, Right, style::kViewAttention))
    foot.place(readout.note, Right, style::kViewAttention);
  if (!beside_value)
    last.place(plain_metrics.elidedText(readout.structures, Qt::ElideRight, last.roomAtRight()),
               Right, ink);
  last.place(above || !readout.position.isEmpty() ? readout.position : at, Right, ink);
  return layout;
}

void drawReadout(QPainter& painter, const ReadoutLayout& layout) {
  QFont font = painter.font();
  for (const ReadoutText& text : layout.texts) {
    font.setPixelSize(text.pixels);
    font.setBold(text.bold);
    painter.setFont(font);
    painter.setPen(text.colour);
    painter.drawText(text.box, Qt::AlignCenter | Qt::TextDontClip, text.text);
  }
  if (!layout.ruler) return;
  painter.setPen(QPen(style::kReadout, 1.0));
  painter.drawLine(*layout.ruler);
  for (const QPointF end : {layout.ruler->p1(), layout.ruler->p2()})
    painter.drawLine(end - QPointF{0.0, 3.0}, end + QPointF{0.0, 3.0});
}

}  // namespace ui
