// SPDX-License-Identifier: BSD-3-Clause
#include "ui/dialogs/unit_question.h"

#include <QButtonGroup>
#include <QDialogButtonBox>
#include <QGridLayout>
#include <QLabel>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QPushButton>
#include <QRadioButton>
#include <QTransform>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/style/look.h"
#include "ui/style/style.h"

namespace ui {
namespace {

constexpr QSize kPictureSize{132, 150};  // px
constexpr double kPictureRim = 8.0;      // px around what is drawn
constexpr double kApart = 0.12;          // between tool and hand, of the higher of the two
constexpr double kShortestTool = 10.0, kLongestTool = 500.0;  // mm

/// A finger: a bar with round ends from its root to its tip, mm.
QPainterPath finger(QPointF root, QPointF tip, double width) {
  QPainterPath line(root);
  line.lineTo(tip);
  QPainterPathStroker stroker;
  stroker.setWidth(width);
  stroker.setCapStyle(Qt::RoundCap);
  return stroker.createStroke(line);
}

/// The sides of a tool in this unit [mm], the longest last.
std::array<double, 3> sidesIn(const FileUnit& unit, std::array<double, 3> numbers) {
  for (double& side : numbers) side *= 1e3 * unit.metres;
  std::ranges::sort(numbers);
  return numbers;
}

QString lengthWords(double mm) {
  const bool metres = mm >= 1000.0;
  return metres ? UnitDialog::tr("%1 m").arg(QLocale().toString(mm * 1e-3, 'g', 3))
                : UnitDialog::tr("%1 mm").arg(QLocale().toString(mm, 'g', 3));
}

QString boxWords(const std::array<double, 3>& sides) {
  return UnitDialog::tr("%1 long,\n%2 by %3")
      .arg(lengthWords(sides[2]), lengthWords(sides[1]), lengthWords(sides[0]));
}

/// The box of a tool, standing on its short side, beside a hand; both to one scale.
class SizePicture : public QWidget {
 public:
  SizePicture(const std::array<double, 3>& sides, QRadioButton& choice)
      : sides_{sides}, choice_{choice} {
    setFixedSize(kPictureSize);
    setCursor(Qt::PointingHandCursor);
    QObject::connect(&choice, &QRadioButton::toggled, this, qOverload<>(&QWidget::update));
  }

 protected:
  void mousePressEvent(QMouseEvent* event) override {
    if (event->button() == Qt::LeftButton) choice_.setChecked(true);
  }
  void paintEvent(QPaintEvent*) override {
    const style::Colours& c = style::colours();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(choice_.isChecked() ? c.accent : c.line, choice_.isChecked() ? 2.0 : 1.0));
    painter.setBrush(c.control);
    painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), style::kCorner, style::kCorner);
    const QPainterPath hand = handOutline();
    const QRectF hand_box = hand.boundingRect();
    const double gap = kApart * std::max(kHandLength, sides_[2]);
    const double wide = sides_[1] + gap + hand_box.width();
    const double high = std::max(kHandLength, sides_[2]);
    const double scale =
        std::min((width() - 2.0 * kPictureRim) / wide, (height() - 2.0 * kPictureRim) / high);
    const double left = 0.5 * (width() - wide * scale), foot = height() - kPictureRim;
    // what is too small to be seen is a point of two pixels
    const QSizeF tool(std::max(2.0, sides_[1] * scale), std::max(2.0, sides_[2] * scale));
    painter.setPen(QPen(c.text, 1.0));
    painter.setBrush(c.solid);
    painter.drawRect(QRectF(QPointF(left, foot - tool.height()), tool));
    QTransform place;
    place.translate(left + (sides_[1] + gap - hand_box.left()) * scale, foot);
    place.scale(scale, scale);
    painter.setPen(QPen(c.dim, 1.4));
    painter.setBrush(Qt::NoBrush);
    painter.drawPath(place.map(hand));
  }

 private:
  std::array<double, 3> sides_;
  QRadioButton& choice_;
};

}  // namespace

QPainterPath handOutline() {
  QPainterPath hand;
  hand.addRoundedRect(QRectF(-40.0, -100.0, 80.0, 92.0), 22.0, 22.0);
  hand.addRect(QRectF(-26.0, -20.0, 52.0, 20.0));
  hand = hand.united(finger({-31.0, -84.0}, {-36.0, -154.0}, 17.0));
  hand = hand.united(finger({-10.5, -88.0}, {-11.5, -171.5}, 17.0));
  hand = hand.united(finger({10.5, -88.0}, {13.0, -162.0}, 17.0));
  hand = hand.united(finger({31.0, -82.0}, {37.0, -132.0}, 15.0));
  hand = hand.united(finger({-28.0, -36.0}, {-66.0, -92.0}, 19.0));
  return hand.simplified();
}

QString likelyUnit(const std::array<double, 3>& numbers) {
  for (const std::size_t n : {0U, 2U, 1U, 3U}) {
    const double longest = sidesIn(kFileUnits[n], numbers)[2];
    if (longest >= kShortestTool && longest <= kLongestTool) return kFileUnits[n].name;
  }
  return kFileUnits[0].name;
}

UnitDialog::UnitDialog(const QString& file, const std::array<double, 3>& numbers, QWidget* parent)
    : QDialog(parent), choices_(new QButtonGroup(this)) {
  setWindowTitle(tr("Unit of the tool"));
  auto* what = new QLabel(tr("In which unit are the numbers of \"%1\"? The file does not say. The "
                             "picture shows a hand of 18 cm beside the box of the tool.")
                              .arg(file));
  what->setTextFormat(Qt::PlainText);
  what->setWordWrap(true);
  auto* grid = new QGridLayout;
  const QString likely = likelyUnit(numbers);
  for (std::size_t n = 0; n < kFileUnits.size(); ++n) {
    const std::array<double, 3> sides = sidesIn(kFileUnits[n], numbers);
    const QString name = QString::fromLatin1(kFileUnits[n].name);
    auto* choice = new QRadioButton(name);
    choice->setObjectName("unit_" + name);
    choice->setChecked(name == likely);
    auto* size = new QLabel(boxWords(sides));
    size->setObjectName("size_" + name);
    style::setDim(*size);
    choice->setAccessibleDescription(QString(size->text()).replace('\n', ' '));
    choices_->addButton(choice, static_cast<int>(n));
    const int column = static_cast<int>(n);
    grid->addWidget(new SizePicture(sides, *choice), 0, column);
    grid->addWidget(choice, 1, column);
    grid->addWidget(size, 2, column);
  }
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
  QPushButton* take = buttons->addButton(tr("Take the tool"), QDialogButtonBox::AcceptRole);
  take->setObjectName("takeUnit");
  take->setDefault(true);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* column = new QVBoxLayout(this);
  column->addWidget(what);
  column->addLayout(grid);
  column->addWidget(buttons);
  if (QAbstractButton* chosen = choices_->checkedButton()) chosen->setFocus();
}

QString UnitDialog::unit() const {
  return QString::fromLatin1(kFileUnits.at(static_cast<std::size_t>(choices_->checkedId())).name);
}

std::optional<QString> askForUnit(QWidget* parent, const QString& file,
                                  const std::array<double, 3>& numbers) {
  UnitDialog dialog(file, numbers, parent);
  if (dialog.exec() != QDialog::Accepted) return std::nullopt;
  return dialog.unit();
}

}  // namespace ui
