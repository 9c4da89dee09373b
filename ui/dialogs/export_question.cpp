// SPDX-License-Identifier: BSD-3-Clause
#include "ui/dialogs/export_question.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QRadioButton>
#include <QVBoxLayout>
#include <array>
#include <utility>

#include "ui/controls/number_box.h"
#include "ui/controls/time_words.h"

namespace ui {
namespace {

using Camera = ExportWish::Film::Camera;

constexpr double kFastest = 1000.0;  // Hz: a step each
constexpr double kUsualRate = 100.0;
constexpr std::array<QSize, 2> kSizes{QSize{1280, 720}, QSize{1920, 1080}};

}  // namespace

ExportDialog::ExportDialog(double begin, double end, std::vector<ExportFormat> formats,
                           QWidget* parent)
    : QDialog(parent),
      begin_(begin),
      end_(end),
      tables_(std::move(formats)),
      formats_(new QComboBox),
      about_(new QLabel),
      from_(timeSpin("exportFrom", begin)),
      to_(timeSpin("exportTo", end)),
      range_(new QLabel),
      every_step_(new QRadioButton(tr("every step"))),
      at_rate_(new QRadioButton(tr("at"))),
      rate_(new NumberBox),
      contacts_(new QCheckBox(tr("With the contacts of each step"))),
      cameras_(new QComboBox),
      sizes_(new QComboBox),
      frame_rates_(new QComboBox),
      figures_(new QCheckBox(tr("Show force, its curve and time in the picture"))),
      slices_(new QCheckBox(tr("Show the slices through the tool beside it"))) {
  setWindowTitle(tr("Export a recording"));
  formats_->setObjectName("exportFormat");
  formats_->setToolTip(tr("Format of the exported recording"));
  for (const ExportFormat& table : tables_) formats_->addItem(table.title);
  formats_->addItem(tr("Film"));
  from_->setAccessibleName(tr("From"));
  from_->setToolTip(tr("Where the export begins, by the time of the recording"));
  to_->setToolTip(tr("Where the export ends, by the time of the recording"));
  to_->setAccessibleName(tr("To"));
  range_->setObjectName("exportRange");
  range_->setWordWrap(true);
  // room for two lines from the start, so that nothing jumps
  range_->setMinimumSize(360, 2 * fontMetrics().lineSpacing());
  range_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  samples_ = buildSamples();
  film_ = buildFilm();

  auto* times = new QHBoxLayout;
  times->addWidget(from_, 1);
  times->addWidget(new QLabel(tr("to")));
  times->addWidget(to_, 1);
  auto* form = new QFormLayout;
  form->addRow(tr("Format"), formats_);
  form->addRow(QString{}, about_);
  form->addRow(tr("From"), times);
  form->addRow(QString{}, range_);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
  export_ = buttons->addButton(tr("Export…"), QDialogButtonBox::AcceptRole);
  export_->setObjectName("exportAgree");
  export_->setToolTip(tr("Asks for the file, then writes it"));
  buttons->button(QDialogButtonBox::Cancel)->setToolTip(tr("Writes nothing"));
  auto* column = new QVBoxLayout(this);
  column->addLayout(form);
  column->addWidget(samples_);
  column->addWidget(film_);
  column->addStretch();
  column->addWidget(buttons);
  column->setSizeConstraint(QLayout::SetFixedSize);

  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(formats_, &QComboBox::currentIndexChanged, this, &ExportDialog::showFormat);
  connect(frame_rates_, &QComboBox::currentIndexChanged, this, &ExportDialog::showRange);
  connect(at_rate_, &QRadioButton::toggled, this, &ExportDialog::showRange);
  for (NumberBox* spin : {from_, to_, rate_})
    connect(spin, &NumberBox::typedChanged, this, &ExportDialog::showRange);
  export_->setDefault(true);  // known to the dialog only now
  showFormat();
}

NumberBox* ExportDialog::timeSpin(const char* name, double value) {
  auto* spin = new NumberBox;
  spin->setObjectName(name);
  spin->setDecimals(3);
  spin->setSuffix(tr(" s"));
  spin->setRange(begin_, end_);
  spin->setValue(value);
  return spin;
}

QWidget* ExportDialog::buildSamples() {
  every_step_->setObjectName("exportEveryStep");
  at_rate_->setObjectName("exportAtRate");
  every_step_->setToolTip(tr("Writes every tick of the servo loop"));
  at_rate_->setToolTip(tr("Writes so many samples a second"));
  at_rate_->setAccessibleName(tr("At a rate"));
  every_step_->setChecked(true);
  rate_->setObjectName("exportRate");
  rate_->setDecimals(1);
  rate_->setRange(0.1, kFastest);
  rate_->setValue(kUsualRate);
  rate_->setSuffix(tr(" Hz"));
  rate_->setAccessibleName(tr("Rate"));
  rate_->setToolTip(tr("Samples for each second"));
  rate_->setEnabled(false);
  connect(at_rate_, &QRadioButton::toggled, rate_, &QWidget::setEnabled);
  contacts_->setObjectName("exportContacts");
  contacts_->setToolTip(tr("Writes where the tool touches, too"));
  contacts_->setChecked(true);

  auto* rates = new QHBoxLayout;
  rates->addWidget(every_step_);
  rates->addWidget(at_rate_);
  rates->addWidget(rate_, 1);
  auto* all = new QWidget;
  auto* form = new QFormLayout(all);
  form->setContentsMargins(0, 0, 0, 0);
  form->addRow(tr("Samples"), rates);
  form->addRow(contacts_);
  return all;
}

QWidget* ExportDialog::buildFilm() {
  cameras_->setObjectName("filmCamera");
  cameras_->setToolTip(tr("From where the film is seen"));
  cameras_->addItem(tr("as it was recorded"), static_cast<int>(Camera::AsRecorded));
  cameras_->addItem(tr("fixed, as it is now"), static_cast<int>(Camera::Fixed));
  sizes_->setObjectName("filmSize");
  sizes_->setToolTip(tr("Pixels of the film"));
  for (const QSize size : kSizes)
    sizes_->addItem(tr("%1 × %2").arg(size.width()).arg(size.height()), size);
  frame_rates_->setObjectName("filmRate");
  frame_rates_->setToolTip(tr("Pictures for each second of the film"));
  for (const int rate : {30, 60}) frame_rates_->addItem(tr("%1 a second").arg(rate), rate);
  figures_->setObjectName("filmFigures");
  figures_->setToolTip(
      tr("The film then has the force and the time in figures, and the curve of the force"));
  figures_->setChecked(true);
  slices_->setObjectName("filmSlices");
  slices_->setToolTip(
      tr("The film then has the axial, coronal and sagittal slice in a column at its right"));

  auto* all = new QWidget;
  auto* form = new QFormLayout(all);
  form->setContentsMargins(0, 0, 0, 0);
  form->addRow(tr("Camera"), cameras_);
  form->addRow(tr("Size"), sizes_);
  form->addRow(tr("Frames"), frame_rates_);
  form->addRow(figures_);
  form->addRow(slices_);
  return all;
}

void ExportDialog::showFormat() {
  const std::optional<std::size_t> table = wish().table;
  about_->setText(table ? tables_[*table].about
                        : tr("The 3-D view, with its colours, second surface and marks as now."));
  samples_->setVisible(table.has_value());
  film_->setVisible(!table);
  showRange();
}

void ExportDialog::showRange() {
  const ExportWish wished = wish();
  const bool rated = !wished.table || !at_rate_->isChecked() || rate_->typed();
  if (!from_->typed() || !to_->typed() || !rated) {
    export_->setEnabled(false);
    return range_->setText(tr("This is not a number that can be taken here."));
  }
  // a recording of one step has no length, and is whole
  const bool whole = wished.from == begin_ && wished.to == end_;
  const bool sound = wished.from < wished.to || whole;
  export_->setEnabled(sound);
  if (!sound) return range_->setText(tr("The end does not come after the beginning."));
  const double length = wished.to - wished.from;
  QString words = whole ? tr("All of it: %1 (minutes and seconds)").arg(clockTime(length, 3))
                        : tr("A part of it: %1 (minutes and seconds)").arg(clockTime(length, 3));
  if (!wished.table)
    words = tr("%1, %2 pictures").arg(words).arg(qRound64(length * wished.film.frames_per_second));
  range_->setText(words);
}

ExportWish ExportDialog::wish() const {
  ExportWish wish;
  const auto chosen = static_cast<std::size_t>(formats_->currentIndex());
  wish.table = chosen < tables_.size() ? std::optional{chosen} : std::nullopt;
  // the fields round to milliseconds: at an end of theirs it is the recording's own
  const double from = from_->typed().value_or(from_->value());
  const double to = to_->typed().value_or(to_->value());
  wish.from = from == from_->minimum() ? begin_ : from;
  wish.to = to == to_->maximum() ? end_ : to;
  if (at_rate_->isChecked()) wish.rate = rate_->typed().value_or(rate_->value());
  wish.contacts = contacts_->isChecked();
  wish.film.camera = static_cast<Camera>(cameras_->currentData().toInt());
  const QSize size = sizes_->currentData().toSize();
  wish.film.width = size.width();
  wish.film.height = size.height();
  wish.film.frames_per_second = frame_rates_->currentData().toInt();
  wish.film.figures = figures_->isChecked();
  wish.film.slices = slices_->isChecked();
  return wish;
}

std::optional<ExportWish> askForExport(QWidget* parent, double begin, double end,
                                       std::vector<ExportFormat> formats) {
  ExportDialog dialog(begin, end, std::move(formats), parent);
  if (dialog.exec() != QDialog::Accepted) return {};
  return dialog.wish();
}

}  // namespace ui
