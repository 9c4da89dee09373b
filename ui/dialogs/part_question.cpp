// SPDX-License-Identifier: BSD-3-Clause
#include "ui/dialogs/part_question.h"

#include <QDialogButtonBox>
#include <QGridLayout>
#include <QLabel>
#include <QLocale>
#include <QMessageBox>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "ui/controls/number_box.h"

namespace ui {
namespace {

constexpr int kGreatestStep = 20;

double voxelsOf(const std::array<std::int64_t, 3>& count) {
  return static_cast<double>(count[0]) * static_cast<double>(count[1]) *
         static_cast<double>(count[2]);
}

QString inWords(double bytes) {
  return QLocale().formattedDataSize(static_cast<qint64>(bytes), 1, QLocale::DataSizeSIFormat);
}

}  // namespace

double LargeVolume::bytesOf(const std::array<std::int64_t, 3>& count) const {
  return static_cast<double>(bytes) * (voxelsOf(count) / voxelsOf(dims));
}

std::array<std::int64_t, 3> everyNth(const std::array<std::int64_t, 3>& dims, int step) {
  std::array<std::int64_t, 3> count{};
  for (std::size_t a = 0; a < 3; ++a) count[a] = (dims[a] + step - 1) / step;
  return count;
}

std::optional<int> stepThatFits(const LargeVolume& volume) {
  for (int step = 2; step <= kGreatestStep; ++step)
    if (volume.holds(volume.bytesOf(everyNth(volume.dims, step)))) return step;
  return {};
}

QString ordinal(int step) {
  if (step == 2) return BoxDialog::tr("2nd");
  if (step == 3) return BoxDialog::tr("3rd");
  return BoxDialog::tr("%1th").arg(step);
}

BoxDialog::BoxDialog(const LargeVolume& volume, QWidget* parent)
    : QDialog(parent), volume_(volume), size_(new QLabel) {
  setWindowTitle(tr("Choose a box"));
  auto* grid = new QGridLayout;
  grid->addWidget(new QLabel(tr("First")), 0, 1);
  grid->addWidget(new QLabel(tr("Last")), 0, 2);
  auto* column = new QVBoxLayout(this);
  column->addWidget(new QLabel(tr("Voxels to read, counted from 1:")));
  column->addLayout(grid);
  size_->setObjectName("boxSize");
  size_->setWordWrap(true);
  column->addWidget(size_);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
  read_ = buttons->addButton(tr("Read the box"), QDialogButtonBox::AcceptRole);
  read_->setObjectName("readBox");
  column->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);

  const std::array<QString, 3> names{tr("Columns"), tr("Rows"), tr("Slices")};
  for (std::size_t a = 0; a < 3; ++a) {
    addAxis(a, names[a]);
    const int row = static_cast<int>(a) + 1;
    grid->addWidget(new QLabel(names[a]), row, 0);
    grid->addWidget(first_[a], row, 1);
    grid->addWidget(last_[a], row, 2);
    grid->addWidget(new QLabel(tr("of %1").arg(volume.dims[a])), row, 3);
  }
  showSize();
}

void BoxDialog::addAxis(std::size_t axis, const QString& name) {
  const int count = static_cast<int>(volume_.dims[axis]);
  auto* first = new NumberBox;
  auto* last = new NumberBox;
  first->setObjectName(QStringLiteral("first%1").arg(axis));
  last->setObjectName(QStringLiteral("last%1").arg(axis));
  first->setAccessibleName(tr("%1: first").arg(name));
  last->setAccessibleName(tr("%1: last").arg(name));
  first->setDecimals(0);
  last->setDecimals(0);
  first->setRange(1, count);
  last->setRange(1, count);
  first->setValue(count / 4 + 1);
  last->setValue(std::max(count / 4 + 1, count - count / 4));
  connect(first, &NumberBox::typedChanged, this, &BoxDialog::showSize);
  connect(last, &NumberBox::typedChanged, this, &BoxDialog::showSize);
  first_[axis] = first;
  last_[axis] = last;
}

VoxelChoice::Box BoxDialog::box() const {
  VoxelChoice::Box box;
  for (std::size_t a = 0; a < 3; ++a) {
    box.first[a] = std::lround(first_[a]->typed().value_or(first_[a]->value())) - 1;
    box.end[a] = std::lround(last_[a]->typed().value_or(last_[a]->value()));
  }
  return box;
}

void BoxDialog::showSize() {
  const auto refused = [](const NumberBox* field) { return !field->typed(); };
  if (std::ranges::any_of(first_, refused) || std::ranges::any_of(last_, refused)) {
    size_->setText(tr("Each end is a whole number within its axis."));
    return read_->setEnabled(false);
  }
  const VoxelChoice::Box chosen = box();
  std::array<std::int64_t, 3> count{};
  for (std::size_t a = 0; a < 3; ++a) count[a] = chosen.end[a] - chosen.first[a];
  if (count[0] < 1 || count[1] < 1 || count[2] < 1) {
    size_->setText(tr("The last voxel of an axis comes before its first."));
    return read_->setEnabled(false);
  }
  const double bytes = volume_.bytesOf(count);
  const bool fits = volume_.holds(bytes);
  const QString words = fits ? tr("%1 × %2 × %3 voxels: %4 of memory, %5 are free.")
                             : tr("%1 × %2 × %3 voxels: %4 of memory, too much for the %5 that "
                                  "are free.");
  size_->setText(words.arg(count[0]).arg(count[1]).arg(count[2]).arg(inWords(bytes),
                                                                     inWords(volume_.free_bytes)));
  read_->setEnabled(fits);
}

std::optional<VoxelChoice> askForPart(QWidget* parent, const QString& sentence,
                                      const LargeVolume& volume) {
  QMessageBox question(QMessageBox::Question, QMessageBox::tr("Read a part of it?"), sentence,
                       QMessageBox::Cancel, parent);
  question.setInformativeText(
      QMessageBox::tr("A part of it can be read instead. The files stay as they are."));
  const std::optional<int> step = stepThatFits(volume);
  const QAbstractButton* thinned = nullptr;
  if (step) {
    const QString size = inWords(volume.bytesOf(everyNth(volume.dims, *step)));
    thinned = question.addButton(
        *step == 2 ? BoxDialog::tr("Read every second voxel (%1)").arg(size)
                   : BoxDialog::tr("Read every %1 voxel (%2)").arg(ordinal(*step), size),
        QMessageBox::AcceptRole);
  }
  const QAbstractButton* boxed =
      question.addButton(BoxDialog::tr("Choose a box…"), QMessageBox::ActionRole);
  question.setDefaultButton(QMessageBox::Cancel);
  question.exec();
  if (thinned != nullptr && question.clickedButton() == thinned) return VoxelChoice{.step = *step};
  if (question.clickedButton() != boxed) return {};
  BoxDialog dialog(volume, parent);
  if (dialog.exec() != QDialog::Accepted) return {};
  return VoxelChoice{.box = dialog.box()};
}

}  // namespace ui
