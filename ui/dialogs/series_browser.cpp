// SPDX-License-Identifier: BSD-3-Clause
#include "ui/dialogs/series_browser.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QFontMetrics>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QMap>
#include <QPainter>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScreen>
#include <QScrollBar>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/style/look.h"
#include "ui/style/scene_colours.h"
#include "ui/style/style.h"

namespace ui {
namespace {

// in front of them stands the patient while names are shown
enum Column { Middle, Study, Series, Modality, Size, Spacing, Word, Memory, Load, kColumns };

// the same where its row is selected: a tint would change what a slice looks like
QIcon plainIcon(const QPixmap& pixmap) {
  QIcon icon(pixmap);
  icon.addPixmap(pixmap, QIcon::Selected);
  return icon;
}

void drawTriangle(QPainter& painter, const QPen& mark) {
  painter.setBrush(style::colours().attention);
  painter.drawPolygon(QPolygonF({{32, 4}, {62, 60}, {2, 60}}));
  painter.setPen(mark);
  painter.drawLine(QPointF{32, 25}, QPointF{32, 39});
  painter.drawPoint(QPointF{32, 51});
}

void drawDisc(QPainter& painter, const QPen& mark, bool ticked) {
  painter.setBrush(ticked ? style::colours().on : style::colours().stop);
  painter.drawEllipse(2, 2, 60, 60);
  painter.setPen(mark);
  if (ticked) return painter.drawPolyline(QPolygonF({{18, 33}, {28, 44}, {46, 21}}));
  painter.drawLine(QPointF{21, 21}, QPointF{43, 43});
  painter.drawLine(QPointF{43, 21}, QPointF{21, 43});
}

// Told apart by shape, not by colour alone: a disc with a tick, a triangle, a disc with a cross.
QIcon iconOf(Verdict verdict, qreal scale) {
  constexpr int kSide = 22;        // pixels, before the screen's own scale
  constexpr double kDrawn = 64.0;  // units to a side, in which it is drawn
  QPixmap pixmap(qRound(kSide * scale), qRound(kSide * scale));
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.scale(pixmap.width() / kDrawn, pixmap.height() / kDrawn);
  const QColor& ground = style::colours().panel;
  painter.setPen(QPen(ground, 2.0));  // seen on a selected row too
  const QPen mark(ground, 8.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin);
  if (verdict == Verdict::Correctable || verdict == Verdict::InPart)
    drawTriangle(painter, mark);
  else
    drawDisc(painter, mark, verdict == Verdict::Sound);
  painter.end();
  pixmap.setDevicePixelRatio(scale);
  return plainIcon(pixmap);
}

QString wordFor(Verdict verdict) {
  switch (verdict) {
    case Verdict::Sound:
      return SeriesBrowser::tr("sound");
    case Verdict::Correctable:
      return SeriesBrowser::tr("correctable");
    case Verdict::InPart:
      return SeriesBrowser::tr("in part");
    case Verdict::Structures:
      return SeriesBrowser::tr("structures");
    case Verdict::Refused:
      break;
  }
  return SeriesBrowser::tr("refused");
}

QString sizeOf(const SeriesRow& row) {
  if (row.dims[0] == 0) return {};
  const QString size =
      SeriesBrowser::tr("%1 × %2 × %3").arg(row.dims[0]).arg(row.dims[1]).arg(row.dims[2]);
  if (row.verdict != Verdict::InPart) return size;
  return SeriesBrowser::tr("%1 of %2").arg(size).arg(row.slices_there);
}

// what is refused may state anything
QString spacingOf(const SeriesRow& row) {
  if (row.verdict == Verdict::Refused || row.verdict == Verdict::Structures) return {};
  const auto figure = [](double mm) { return QLocale().toString(mm, 'g', 4); };
  return SeriesBrowser::tr("%1 × %2 × %3 mm")
      .arg(figure(row.spacing_mm[0]), figure(row.spacing_mm[1]), figure(row.spacing_mm[2]));
}

QString memoryOf(const SeriesRow& row) {
  if (row.verdict == Verdict::Refused || row.bytes <= 0) return {};
  return QLocale().formattedDataSize(row.bytes, 1, QLocale::DataSizeSIFormat);
}

QTableWidgetItem* itemOf(const QString& text) {
  auto* item = new QTableWidgetItem(text.isEmpty() ? QStringLiteral("–") : text);
  item->setFlags(Qt::ItemIsSelectable | Qt::ItemIsEnabled);
  item->setToolTip(text);
  return item;
}

// its edges are the slice's, so that a narrow slice is not taken for a wide one
QPixmap framed(const SmallPicture& picture, qreal scale) {
  return squareOf(picture, SeriesBrowser::kThumbnail, scale, style::kViewFrame);
}

}  // namespace

SeriesBrowser::SeriesBrowser(const QString& place, const QList<SeriesRow>& rows, QWidget* parent)
    : QDialog(parent), rows_(rows), table_(new QTableWidget), details_(new QPlainTextEdit) {
  setWindowTitle(tr("Series of %1").arg(place));
  auto* patients = new QCheckBox(tr("Show patients' &names"));
  patients->setObjectName("showPatients");
  patients->setToolTip(tr("Shows the patients' names until the list is closed"));
  connect(patients, &QCheckBox::toggled, this, &SeriesBrowser::showPatients);
  auto* top = new QHBoxLayout;
  top->addWidget(new QLabel(tr("%n series found", nullptr, seriesCount())));
  top->addStretch();
  top->addWidget(patients);

  table_->setObjectName("series");
  table_->setAccessibleName(tr("Series"));
  table_->setToolTip(tr("Enter or a double-click loads a series"));
  style::makeLines(*table_);
  table_->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
  table_->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  table_->setIconSize({kThumbnail, kThumbnail});
  table_->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
  table_->verticalHeader()->setDefaultSectionSize(kThumbnail + 8);
  connect(table_, &QTableWidget::cellActivated, this, &SeriesBrowser::choose);
  connect(table_, &QTableWidget::itemSelectionChanged, this, &SeriesBrowser::showDetails);

  details_->setObjectName("seriesDetails");
  details_->setAccessibleName(tr("Details of the selected series"));
  details_->setToolTip(tr("Details of the selected series"));
  details_->setReadOnly(true);
  details_->setTabChangesFocus(true);
  details_->setFixedHeight(QFontMetrics(details_->font()).lineSpacing() * 5);

  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  buttons->button(QDialogButtonBox::Close)
      ->setToolTip(tr("Closes the list; the present scan stays"));
  // Enter belongs to the selected row
  for (auto* button : buttons->findChildren<QPushButton*>()) button->setAutoDefault(false);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);

  auto* column = new QVBoxLayout(this);
  column->addLayout(top);
  column->addWidget(table_, 1);
  column->addWidget(details_);
  column->addWidget(buttons);
  fill();
  addLoadButtons();
  const QScrollBar* scroll = table_->verticalScrollBar();
  connect(scroll, &QScrollBar::valueChanged, this, &SeriesBrowser::addLoadButtons);
  connect(scroll, &QScrollBar::rangeChanged, this, &SeriesBrowser::addLoadButtons);
  table_->setFocus();
  const QFontMetrics letters(font());
  resize(QSize(letters.averageCharWidth() * 150, letters.lineSpacing() * 12 + 5 * kThumbnail)
             .boundedTo(screen()->availableSize() * 0.95));
}

int SeriesBrowser::seriesCount() const {
  return static_cast<int>(rows_.size() -
                          std::ranges::count(rows_, Verdict::Structures, &SeriesRow::verdict));
}

int SeriesBrowser::columnOf(int column) const { return column + (patients_shown_ ? 1 : 0); }

void SeriesBrowser::fill() {
  table_->setColumnCount(kColumns);
  table_->setHorizontalHeaderLabels({tr("Middle slice"),
                                     tr("Study"),
                                     tr("Series"),
                                     tr("Modality"),
                                     tr("Voxels"),
                                     tr("Spacing"),
                                     tr("Verdict"),
                                     tr("Memory"),
                                     {}});
  table_->setRowCount(static_cast<int>(rows_.size()));
  const qreal scale = devicePixelRatioF();
  const QIcon empty = plainIcon(framed({}, scale));
  QMap<Verdict, QIcon> marks;
  for (const Verdict verdict :
       {Verdict::Sound, Verdict::Correctable, Verdict::InPart, Verdict::Refused})
    marks[verdict] = iconOf(verdict, scale);
  for (int row = 0; row < rows_.size(); ++row) fillRow(row, marks[rows_[row].verdict], empty);
  QHeaderView* header = table_->horizontalHeader();
  header->setResizeContentsPrecision(50);  // of thousands of rows the first are enough
  header->setSectionResizeMode(QHeaderView::ResizeToContents);
  header->setMinimumSectionSize(QFontMetrics(font()).averageCharWidth() * 10);
  for (const int column : {Study, Series})
    header->setSectionResizeMode(column, QHeaderView::Stretch);
  // the one with the most voxels of those that can be loaded whole
  const auto voxels = [](const SeriesRow& row) {
    const bool whole = row.verdict == Verdict::Sound || row.verdict == Verdict::Correctable;
    return whole ? static_cast<double>(row.dims[0]) * static_cast<double>(row.dims[1]) *
                       static_cast<double>(row.dims[2])
                 : -1.0;
  };
  if (!rows_.isEmpty())
    table_->selectRow(
        static_cast<int>(std::ranges::max_element(rows_, {}, voxels) - rows_.begin()));
}

void SeriesBrowser::fillRow(int row, const QIcon& verdict, const QIcon& no_picture_yet) {
  const SeriesRow& series = rows_[row];
  auto* middle = new QTableWidgetItem;
  middle->setFlags(Qt::ItemIsSelectable | Qt::ItemIsEnabled);
  const bool structures = series.verdict == Verdict::Structures;
  if (!structures) middle->setIcon(no_picture_yet);
  table_->setItem(row, Middle, middle);
  table_->setItem(row, Study, itemOf(series.study));
  table_->setItem(row, Series, itemOf(series.series));
  table_->setItem(row, Modality, itemOf(series.modality));
  table_->setItem(row, Size, itemOf(sizeOf(series)));
  table_->setItem(row, Spacing, itemOf(spacingOf(series)));
  table_->setItem(row, Memory, itemOf(memoryOf(series)));
  QTableWidgetItem* word = itemOf(wordFor(series.verdict));
  if (!structures) word->setIcon(verdict);
  word->setToolTip(series.sentence);
  table_->setItem(row, Word, word);
  table_->setItem(row, Load, itemOf(QStringLiteral(" ")));
}

// in sight and a page around it: thousands of buttons would take seconds
void SeriesBrowser::addLoadButtons() {
  const int page = table_->viewport()->height() / (kThumbnail + 8) + 8;
  const int first = std::max(0, table_->rowAt(0) - page);
  const int last = std::min(static_cast<int>(rows_.size()), first + 3 * page);
  for (int row = first; row < last; ++row)
    if (rows_[row].verdict != Verdict::Refused &&
        table_->cellWidget(row, columnOf(Load)) == nullptr)
      addLoadButton(row);
}

void SeriesBrowser::addLoadButton(int row) {
  const bool structures = rows_[row].verdict == Verdict::Structures;
  auto* load = new QPushButton(structures ? tr("Open") : tr("Load"));
  load->setObjectName(QStringLiteral("load%1").arg(row));
  load->setAutoDefault(false);
  load->setAccessibleName(structures ? tr("Open structures %1").arg(row + 1 - seriesCount())
                                     : tr("Load series %1").arg(row + 1));
  load->setToolTip(structures ? tr("Opens these structures in the scan on view")
                              : tr("Loads this series"));
  load->setFocusPolicy(Qt::NoFocus);
  connect(load, &QPushButton::clicked, this, [this, row] {
    table_->selectRow(row);
    choose(row);
  });
  auto* cell = new QWidget;
  auto* centred = new QHBoxLayout(cell);
  centred->addWidget(load, 0, Qt::AlignCenter);
  table_->setCellWidget(row, columnOf(Load), cell);
}

void SeriesBrowser::showPatients(bool shown) {
  if (shown == patients_shown_) return;
  patients_shown_ = shown;
  if (!shown) return table_->removeColumn(0);
  const int selected = table_->currentRow();
  table_->insertColumn(0);
  table_->setHorizontalHeaderItem(0, new QTableWidgetItem(tr("Patient")));
  table_->horizontalHeader()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
  for (int row = 0; row < rows_.size(); ++row) table_->setItem(row, 0, itemOf(rows_[row].patient));
  table_->selectRow(selected);  // with the new column
}

void SeriesBrowser::showThumbnail(int row, const SmallPicture& picture) {
  QTableWidgetItem* item = table_->item(row, columnOf(Middle));
  if (item == nullptr) return;
  if (picture.image.isNull()) {
    item->setIcon({});
    item->setText(tr("no picture"));
    return;
  }
  item->setIcon(plainIcon(framed(picture, devicePixelRatioF())));
  item->setToolTip(wordsOf(picture));
  if (!picture.sides_known) item->setData(Qt::AccessibleTextRole, wordsOf(picture));
}

void SeriesBrowser::showDetails() {
  const QList<QTableWidgetItem*> selected = table_->selectedItems();
  if (selected.isEmpty()) return details_->clear();
  const SeriesRow& series = rows_[selected.first()->row()];
  details_->setPlainText((QStringList(series.sentence) + series.faults).join(QLatin1Char('\n')));
}

void SeriesBrowser::choose(int row) {
  if (rows_[row].verdict != Verdict::Refused) emit loadWanted(row);
}

}  // namespace ui
