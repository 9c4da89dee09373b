// SPDX-License-Identifier: BSD-3-Clause
#include "ui/dialogs/surface_question.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QVBoxLayout>
#include <utility>

namespace ui {

SurfaceDialog::SurfaceDialog(const QString& surface, const std::vector<QString>& endings,
                             bool edited, QWidget* parent)
    : QDialog(parent),
      formats_(new QComboBox),
      frames_(new QComboBox),
      pieces_(new QComboBox),
      removed_(new QCheckBox(tr("With the parts that were removed"))),
      size_(new QLabel) {
  setWindowTitle(tr("Export the surface"));
  formats_->setObjectName("surfaceFormat");
  formats_->setToolTip(tr("Format of the file"));
  for (const QString& ending : endings) formats_->addItem(ending.mid(1).toUpper());
  frames_->setObjectName("surfaceFrame");
  frames_->setToolTip(tr("Directions of x, y and z in the file"));
  frames_->addItem(tr("LPS: left, posterior, superior (as in DICOM)"));
  frames_->addItem(tr("RAS: right, anterior, superior (as in NIfTI)"));
  pieces_->setObjectName("surfacePieces");
  pieces_->setToolTip(tr("Which connected parts are written"));
  pieces_->addItem(tr("all"));
  pieces_->addItem(tr("the largest alone"));
  removed_->setObjectName("surfaceRemoved");
  removed_->setToolTip(tr("Writes the surface of the whole scan, as before all edits"));
  removed_->setEnabled(edited);
  size_->setObjectName("surfaceSize");
  size_->setWordWrap(true);
  // room for two lines from the start, so that nothing jumps
  size_->setMinimumSize(360, 2 * fontMetrics().lineSpacing());
  size_->setAlignment(Qt::AlignLeft | Qt::AlignTop);

  auto* form = new QFormLayout;
  form->addRow(tr("Surface"), new QLabel(surface));
  form->addRow(tr("Format"), formats_);
  form->addRow(tr("Axes"), frames_);
  form->addRow(tr("Pieces"), pieces_);
  form->addRow(QString{}, removed_);
  form->addRow(tr("Size"), size_);
  qobject_cast<QLabel*>(form->labelForField(size_))->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
  export_ = buttons->addButton(tr("Export…"), QDialogButtonBox::AcceptRole);
  export_->setObjectName("surfaceAgree");
  export_->setToolTip(tr("Asks for the file, then writes it"));
  buttons->button(QDialogButtonBox::Cancel)->setToolTip(tr("Writes nothing"));
  auto* column = new QVBoxLayout(this);
  column->addLayout(form);
  column->addStretch();
  column->addWidget(buttons);
  column->setSizeConstraint(QLayout::SetFixedSize);

  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(formats_, &QComboBox::currentIndexChanged, this, &SurfaceDialog::showFormat);
  connect(pieces_, &QComboBox::currentIndexChanged, this, &SurfaceDialog::change);
  connect(removed_, &QCheckBox::toggled, this, &SurfaceDialog::change);
  export_->setDefault(true);  // known to the dialog only now
  showFormat();
}

SurfaceWish SurfaceDialog::wish() const {
  return {.format = static_cast<std::size_t>(formats_->currentIndex()),
          .ras = frames_->currentIndex() == 1,
          .largest = pieces_->currentIndex() == 1,
          .removed = removed_->isChecked()};
}

void SurfaceDialog::showSize(std::int64_t triangles, std::vector<std::int64_t> bytes) {
  triangles_ = triangles;
  bytes_ = std::move(bytes);
  showFormat();
}

void SurfaceDialog::showProblem(const QString& sentence) {
  bytes_.clear();
  showFormat();
  size_->setText(sentence);
}

void SurfaceDialog::change() {
  bytes_.clear();
  showFormat();
  emit surfaceChanged();
}

void SurfaceDialog::showFormat() {
  export_->setEnabled(!bytes_.empty());
  if (bytes_.empty()) return size_->setText(tr("The triangles are being counted…"));
  constexpr double kBytesOfMb = 1e6;
  const double mb = static_cast<double>(bytes_.at(wish().format)) / kBytesOfMb;
  size_->setText(tr("%1 triangles, about %2 MB")
                     .arg(QLocale().toString(qlonglong{triangles_}),
                          QLocale().toString(mb, 'f', mb < 10.0 ? 1 : 0)));
}

}  // namespace ui
