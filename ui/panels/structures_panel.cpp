// SPDX-License-Identifier: BSD-3-Clause
#include "ui/panels/structures_panel.h"

#include <QApplication>
#include <QCheckBox>
#include <QColorDialog>
#include <QGridLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTableWidget>
#include <QVBoxLayout>
#include <utility>

#include "ui/controls/bindings.h"
#include "ui/controls/number_box.h"
#include "ui/style/style.h"

namespace ui {
namespace {

// a line is a structure, and has its number; what is known while touching comes behind the name
enum StructureColumn {
  StructureVisible,
  StructureColour,
  StructureName,
  StructureDistance,
  StructureOpacity,
  kStructureColumns
};

QTableWidgetItem& cellOf(QTableWidget& list, int row, int column) {
  QTableWidgetItem* item = list.item(row, column);
  if (item == nullptr) {
    item = new QTableWidgetItem;
    Qt::ItemFlags flags = Qt::ItemIsSelectable | Qt::ItemIsEnabled;
    if (column == StructureVisible) flags |= Qt::ItemIsUserCheckable;
    if (column == StructureName) flags |= Qt::ItemIsEditable;
    if (column == StructureOpacity || column == StructureDistance)
      item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    item->setFlags(flags);
    list.setItem(row, column, item);
  }
  return *item;
}

void showLook(QTableWidget& list, int row, const StructureLook& look) {
  const QString tip = QStringLiteral("<qt>%1</qt>").arg(look.name.toHtmlEscaped());
  QTableWidgetItem& visible = cellOf(list, row, StructureVisible);
  visible.setCheckState(look.visible ? Qt::Checked : Qt::Unchecked);
  visible.setData(Qt::AccessibleTextRole, StructuresPanel::tr("Show %1").arg(look.name));
  visible.setToolTip(StructuresPanel::tr("Shows it, or hides it"));
  QTableWidgetItem& colour = cellOf(list, row, StructureColour);
  colour.setData(Qt::DecorationRole, look.colour);
  colour.setData(Qt::AccessibleTextRole, StructuresPanel::tr("Colour of %1").arg(look.name));
  colour.setToolTip(StructuresPanel::tr("A click chooses another colour"));
  QTableWidgetItem& name = cellOf(list, row, StructureName);
  name.setText(look.name);
  name.setToolTip(tip);
  cellOf(list, row, StructureOpacity)
      .setText(StructuresPanel::tr("%1 %").arg(qRound(100.0 * look.opacity)));
}

}  // namespace

StructuresPanel::StructuresPanel(QWidget* parent)
    : QWidget(parent),
      search_(new QLineEdit),
      list_(new QTableWidget),
      parts_(new QWidget),
      go_(new QPushButton(tr("Go to"))),
      alone_(new QPushButton(tr("Only this"))),
      rename_(new QPushButton(tr("Rename"))),
      colour_(new QPushButton(tr("Colour…"))),
      opacity_(new NumberBox),
      watch_(new QCheckBox(tr("Tell the distance"))),
      near_mm_(new NumberBox),
      close_mm_(new NumberBox),
      through_(new QCheckBox(tr("Through the bone"))),
      filled_(new QCheckBox(tr("Filled in slices"))),
      open_(new QPushButton(tr("Open…"))),
      close_(new QPushButton(tr("Close"))) {
  search_->setObjectName("structureSearch");
  search_->setAccessibleName(tr("Search the structures"));
  search_->setPlaceholderText(tr("Search"));
  search_->setToolTip(tr("Lists the structures whose names have these letters"));
  search_->setClearButtonEnabled(true);
  connect(search_, &QLineEdit::textChanged, this, &StructuresPanel::search);
  buildList();
  auto* within = new QVBoxLayout(parts_);
  within->setContentsMargins(0, 0, 0, 0);
  within->addWidget(search_);
  within->addWidget(list_, 1);
  within->addWidget(buildChosen());
  within->addWidget(buildAll());

  open_->setObjectName("openStructuresButton");
  open_->setToolTip(
      tr("Opens the structures of this scan from a file: a segmentation by another program"));
  close_->setObjectName("closeStructures");
  close_->setToolTip(tr("Takes the structures from the views; the file stays"));
  connect(open_, &QPushButton::clicked, this, &StructuresPanel::openWanted);
  connect(close_, &QPushButton::clicked, this, &StructuresPanel::closeWanted);
  auto* files = new QHBoxLayout;
  files->addWidget(open_);
  files->addWidget(close_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(parts_);
  column->addLayout(files);
  setReady(false);
  show(Structures{});
}

void StructuresPanel::buildList() {
  list_->setObjectName("structures");
  list_->setAccessibleName(tr("Structures"));
  list_->setColumnCount(kStructureColumns);
  list_->setHorizontalHeaderLabels({{}, {}, tr("Name"), tr("Distance"), tr("Opacity")});
  style::makeLines(*list_);
  list_->setMinimumHeight(160);
  list_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  list_->horizontalHeader()->setSectionResizeMode(StructureName, QHeaderView::Stretch);
  list_->installEventFilter(this);
  whenKeysChange(*list_, [this] {
    list_->setToolTip(tr("%1 turns the views to the structure, %2 renames it, %3 shows or hides it")
                          .arg(keyOf(Action::GoToStructure), keyOf(Action::RenameStructure),
                               keyOf(Action::ShowStructure)));
  });
  connect(list_, &QTableWidget::itemSelectionChanged, this, &StructuresPanel::showChosen);
  connect(list_, &QTableWidget::cellClicked, this, [this](int row, int column) {
    if (column == StructureColour) return askColour(row);
    if (column != StructureVisible) emit goToWanted(row);
  });
  connect(list_, &QTableWidget::itemChanged, this, [this](const QTableWidgetItem* item) {
    if (item->column() == StructureVisible)
      emit visibleChosen(item->row(), item->checkState() == Qt::Checked);
    else if (item->column() == StructureName)
      emit renamed(item->row(), item->text());
  });
}

QWidget* StructuresPanel::buildChosen() {
  go_->setObjectName("goToStructure");
  alone_->setObjectName("structureAlone");
  alone_->setToolTip(tr("Shows this structure alone"));
  rename_->setObjectName("renameStructure");
  colour_->setObjectName("structureColour");
  colour_->setToolTip(tr("Chooses another colour"));
  whenKeysChange(*this, [this] {
    go_->setToolTip(
        withKey(tr("Turns the 3-D view to the structure, and brings the slices to its middle"),
                Action::GoToStructure));
    rename_->setToolTip(withKey(tr("Renames the structure, here alone"), Action::RenameStructure));
  });
  opacity_->setObjectName("structureOpacity");
  opacity_->setAccessibleName(tr("Opacity of the structure"));
  opacity_->setToolTip(tr("How much of what lies behind it the structure hides"));
  opacity_->setRange(100.0 * kLeastStructure, 100.0);
  opacity_->setDecimals(0);
  opacity_->setSingleStep(10.0);
  opacity_->setFineStep(1.0);
  opacity_->setSuffix(tr(" %"));
  connect(go_, &QPushButton::clicked, this, [this] { emit goToWanted(chosen()); });
  connect(alone_, &QPushButton::clicked, this, [this] { emit aloneWanted(chosen()); });
  connect(rename_, &QPushButton::clicked, this, [this] {
    list_->setFocus();
    list_->editItem(list_->item(chosen(), StructureName));
  });
  connect(colour_, &QPushButton::clicked, this, [this] { askColour(chosen()); });
  connect(opacity_, &NumberBox::valueChanged, this,
          [this](double percent) { emit opacityChosen(chosen(), percent / 100.0); });
  watch_->setObjectName("watchStructure");
  watch_->setToolTip(
      tr("Tells how far the tool is from the structure, beside the force and in recordings"));
  connect(watch_, &QCheckBox::toggled, this, [this](bool on) { emit watchChosen(chosen(), on); });
  auto* part = new QWidget;
  auto* grid = new QGridLayout(part);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->addWidget(watch_, 3, 0, 1, 2);
  grid->addWidget(go_, 0, 0);
  grid->addWidget(alone_, 0, 1);
  grid->addWidget(rename_, 1, 0);
  grid->addWidget(colour_, 1, 1);
  grid->addWidget(new QLabel(tr("Opacity")), 2, 0);
  grid->addWidget(opacity_, 2, 1);
  return part;
}

QWidget* StructuresPanel::buildAll() {
  auto* part = new QWidget;
  auto* grid = new QGridLayout(part);
  grid->setContentsMargins(0, 0, 0, 0);
  for (const bool on : {true, false}) {
    auto* all = new QPushButton(on ? tr("All on") : tr("All off"));
    all->setObjectName(on ? "structuresOn" : "structuresOff");
    all->setToolTip(on ? tr("Shows all structures") : tr("Hides all structures"));
    connect(all, &QPushButton::clicked, this, [this, on] { emit allWanted(on); });
    grid->addWidget(all, 0, on ? 0 : 1);
  }
  through_->setObjectName("structuresThrough");
  through_->setToolTip(tr("Draws the outlines of structures over the bone that hides them"));
  filled_->setObjectName("structuresFilled");
  filled_->setToolTip(tr("Fills the structures in slices, so that the anatomy is seen through"));
  connect(through_, &QCheckBox::toggled, this, &StructuresPanel::throughChosen);
  connect(filled_, &QCheckBox::toggled, this, &StructuresPanel::filledChosen);
  grid->addWidget(through_, 1, 0, 1, 2);
  grid->addWidget(filled_, 2, 0, 1, 2);
  const NearLimits limits;
  const auto add = [&](NumberBox& box, const char* name, const QString& words, double mm, int row) {
    box.setObjectName(name);
    box.setAccessibleName(words);
    box.setRange(0.1, 20.0);
    box.setDecimals(1);
    box.setSingleStep(0.5);
    box.setSuffix(tr(" mm"));
    box.setValue(mm);
    connect(&box, &NumberBox::valueChanged, this, [this] {
      emit limitsChosen({near_mm_->value(), close_mm_->value()});
    });
    grid->addWidget(new QLabel(words), row, 0);
    grid->addWidget(&box, row, 1);
  };
  add(*near_mm_, "nearFrom", tr("Near from"), limits.near_mm, 3);
  add(*close_mm_, "closeFrom", tr("Close from"), limits.close_mm, 4);
  return part;
}

bool StructuresPanel::eventFilter(QObject* watched, QEvent* event) {
  if (watched != list_ || event->type() != QEvent::KeyPress) return false;
  const Binding* meaning = meaningOf(Where::Structures, *static_cast<QKeyEvent*>(event));
  if (chosen() < 0 || meaning == nullptr) return false;
  // Enter also comes from the field in which a name is typed
  const QWidget* focus = QApplication::focusWidget();
  if (focus != nullptr && focus != list_ && list_->isAncestorOf(focus)) return false;
  if (meaning->action == Action::GoToStructure)
    emit goToWanted(chosen());
  else if (meaning->action == Action::RenameStructure)
    list_->editItem(list_->item(chosen(), StructureName));
  else if (meaning->action == Action::ShowStructure)
    emit visibleChosen(chosen(), !shown_.looks[static_cast<std::size_t>(chosen())].visible);
  else
    return false;
  return true;
}

void StructuresPanel::setReady(bool ready) { open_->setEnabled(ready); }

void StructuresPanel::show(const Structures& structures) {
  const bool others = structures.map != shown_.map;
  const bool any = structures.map != nullptr;
  const QSignalBlocker quiet_list(list_), quiet_through(through_), quiet_filled(filled_);
  if (others) {
    list_->setRowCount(static_cast<int>(structures.looks.size()));
    list_->clearSelection();
  }
  for (int row = 0; row < list_->rowCount(); ++row) {
    const auto number = static_cast<std::size_t>(row);
    if (others || structures.looks[number] != shown_.looks[number])
      showLook(*list_, row, structures.looks[number]);
  }
  shown_ = structures;
  if (others) search_->clear();
  through_->setChecked(structures.through);
  filled_->setChecked(structures.filled);
  parts_->setVisible(any);
  close_->setVisible(any);
  search();
  showChosen();
}

void StructuresPanel::showNear(const std::vector<std::pair<int, StructureNear>>& near) {
  const QSignalBlocker quiet(list_);
  std::vector<QString> words(static_cast<std::size_t>(list_->rowCount()));
  for (const auto& [number, one] : near)
    if (number < list_->rowCount()) words[static_cast<std::size_t>(number)] = distanceWords(one);
  for (int row = 0; row < list_->rowCount(); ++row) {
    QTableWidgetItem& cell = cellOf(*list_, row, StructureDistance);
    if (cell.text() != words[static_cast<std::size_t>(row)])
      cell.setText(words[static_cast<std::size_t>(row)]);
  }
}

void StructuresPanel::search() {
  for (int row = 0; row < list_->rowCount(); ++row)
    list_->setRowHidden(row, !shown_.looks[static_cast<std::size_t>(row)].name.contains(
                                 search_->text(), Qt::CaseInsensitive));
}

int StructuresPanel::chosen() const {
  const QList<QTableWidgetSelectionRange> ranges = list_->selectedRanges();
  return ranges.isEmpty() ? -1 : ranges.first().topRow();
}

void StructuresPanel::showChosen() {
  const int number = chosen();
  for (QWidget* control : {static_cast<QWidget*>(go_), static_cast<QWidget*>(alone_),
                           static_cast<QWidget*>(rename_), static_cast<QWidget*>(colour_),
                           static_cast<QWidget*>(opacity_), static_cast<QWidget*>(watch_)})
    control->setEnabled(number >= 0);
  const QSignalBlocker quiet(opacity_), quiet_watch(watch_);
  watch_->setChecked(number >= 0 && shown_.looks[static_cast<std::size_t>(number)].watched);
  opacity_->setValue(number < 0 ? 100.0
                                : 100.0 * shown_.looks[static_cast<std::size_t>(number)].opacity);
}

void StructuresPanel::askColour(int number) {
  const StructureLook& look = shown_.looks[static_cast<std::size_t>(number)];
  // Qt's own dialog: in a foreign one Escape would not reach the application
  QColorDialog dialog(look.colour, window());
  dialog.setObjectName("structureColours");
  dialog.setWindowTitle(tr("Colour of a structure"));
  dialog.setOption(QColorDialog::DontUseNativeDialog);
  if (dialog.exec() == QDialog::Accepted) emit colourChosen(number, dialog.currentColor());
}

}  // namespace ui
