// SPDX-License-Identifier: BSD-3-Clause
#include "ui/panels/structures_panel.h"

#include <QApplication>
#include <QCheckBox>
#include <QColorDialog>
#include <QComboBox>
#include <QGridLayout>
#include <QHeaderView>
#include <QIcon>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QMenu>
#include <QPixmap>
#include <QPushButton>
#include <QSignalBlocker>
#include <QStyledItemDelegate>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "ui/controls/bindings.h"
#include "ui/controls/elided_label.h"
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
  StructureFelt,     // of those that are felt otherwise than the scan has them
  StructureOpacity,  // once one is not opaque
  kStructureColumns
};

/// A way to feel a structure, as the user chooses it.
struct FeelChoice {
  StructureFeel::Kind kind;
  const char* name;
  const char* tip;
};
constexpr FeelChoice kFeels[] = {
    {StructureFeel::Kind::AsScan, QT_TRANSLATE_NOOP("ui::StructuresPanel", "As the scan has it"),
     QT_TRANSLATE_NOOP("ui::StructuresPanel", "Nothing changes where the structure is touched")},
    {StructureFeel::Kind::Softer, QT_TRANSLATE_NOOP("ui::StructuresPanel", "Softer"),
     QT_TRANSLATE_NOOP("ui::StructuresPanel",
                       "Where the structure is touched, what is felt gives way")},
    {StructureFeel::Kind::Guarded, QT_TRANSLATE_NOOP("ui::StructuresPanel", "Guarded"),
     QT_TRANSLATE_NOOP("ui::StructuresPanel", "A force keeps the tool away from the structure")},
    {StructureFeel::Kind::Solid, QT_TRANSLATE_NOOP("ui::StructuresPanel", "Solid"),
     QT_TRANSLATE_NOOP("ui::StructuresPanel", "The structure's own surface stops the tool, too")},
    {StructureFeel::Kind::NotThere, QT_TRANSLATE_NOOP("ui::StructuresPanel", "Not there"),
     QT_TRANSLATE_NOOP("ui::StructuresPanel",
                       "The tool goes into the structure as into air; what is shown stays")}};

/// A number of a way to feel.
struct FeelField {
  StructureFeel::Kind kind;
  double StructureFeel::*value;
  const char* object;
  const char* name;
  const char* unit;
  double least, most, step;
  int decimals;
  const char* tip;
};
constexpr FeelField kFeelFields[] = {
    {StructureFeel::Kind::Softer, &StructureFeel::stiffness, "structureStiffness",
     QT_TRANSLATE_NOOP("ui::StructuresPanel", "Stiffness"),
     QT_TRANSLATE_NOOP("ui::StructuresPanel", " N/m"), kLeastFeelStiffness, kMostFeelStiffness,
     50.0, 0, QT_TRANSLATE_NOOP("ui::StructuresPanel", "Of the tissue that is felt there")},
    {StructureFeel::Kind::Guarded, &StructureFeel::margin_mm, "structureMargin",
     QT_TRANSLATE_NOOP("ui::StructuresPanel", "Force within"),
     QT_TRANSLATE_NOOP("ui::StructuresPanel", " mm"), kLeastMargin_mm, kMostMargin_mm, 0.5, 1,
     QT_TRANSLATE_NOOP("ui::StructuresPanel",
                       "The distance from the structure at which the force begins")},
    {StructureFeel::Kind::Guarded, &StructureFeel::most, "structureGuard",
     QT_TRANSLATE_NOOP("ui::StructuresPanel", "Force at most"),
     QT_TRANSLATE_NOOP("ui::StructuresPanel", " N"), kLeastGuard, kMostGuard, 0.5, 1,
     QT_TRANSLATE_NOOP("ui::StructuresPanel", "The greatest force, at the structure and within")}};

/// As its row says it; empty: as the scan has it.
QString feltWords(const StructureLook& look) {
  QStringList words;
  for (const FeelChoice& choice : kFeels)
    if (choice.kind == look.feel.kind && choice.kind != StructureFeel::Kind::AsScan)
      words.append(StructuresPanel::tr(choice.name));
  if (look.cutting.kind == StructureCutting::Kind::Never)
    words.append(StructuresPanel::tr("Never cut"));
  return words.join(StructuresPanel::tr(", "));
}

/// As reports number it.
QString numbered(int number, const QString& name) {
  const QString plain = StructuresPanel::tr("Structure %1").arg(number + 1);
  return name == plain ? plain : StructuresPanel::tr("%1: %2").arg(plain, name);
}

/// Edits a name in its cell: Qt's own field grows over the cells beside it.
class NameDelegate : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;
  QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem&,
                        const QModelIndex&) const override {
    auto* field = new QLineEdit(parent);
    field->setFrame(false);
    field->setAutoFillBackground(true);
    return field;
  }
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
  const QString tip = QStringLiteral("<qt>%1</qt>").arg(numbered(row, look.name).toHtmlEscaped());
  QTableWidgetItem& visible = cellOf(list, row, StructureVisible);
  visible.setCheckState(look.visible ? Qt::Checked : Qt::Unchecked);
  visible.setData(Qt::AccessibleTextRole, StructuresPanel::tr("Show %1").arg(look.name));
  visible.setToolTip(StructuresPanel::tr("Shows it, or hides it"));
  QTableWidgetItem& colour = cellOf(list, row, StructureColour);
  // the same where the row is chosen, which tints a plain colour
  QPixmap swatch(list.iconSize().isValid() ? list.iconSize() : QSize(16, 16));
  swatch.fill(look.colour);
  QIcon icon(swatch);
  icon.addPixmap(swatch, QIcon::Selected);
  colour.setIcon(icon);
  colour.setData(Qt::AccessibleTextRole, StructuresPanel::tr("Colour of %1").arg(look.name));
  colour.setToolTip(StructuresPanel::tr("A click chooses another colour"));
  QTableWidgetItem& name = cellOf(list, row, StructureName);
  name.setText(look.name);
  name.setToolTip(tip);
  // a name has the room of a distance that is not told
  if (const int cells = look.watched ? 1 : 2; list.columnSpan(row, StructureName) != cells)
    list.setSpan(row, StructureName, 1, cells);
  cellOf(list, row, StructureFelt).setText(feltWords(look));
  cellOf(list, row, StructureOpacity)
      .setText(StructuresPanel::tr("%1 %").arg(qRound(100.0 * look.opacity)));
}

}  // namespace

StructuresPanel::StructuresPanel(QWidget* parent)
    : QWidget(parent),
      search_(new QLineEdit),
      list_(new QTableWidget),
      parts_(new QWidget),
      title_(new ElidedLabel),
      go_(new QPushButton(tr("Go to"))),
      alone_(new QPushButton(tr("Only this"))),
      rename_(new QPushButton(tr("Rename"))),
      colour_(new QPushButton(tr("Colour…"))),
      opacity_(new NumberBox),
      watch_(new QCheckBox(tr("Tell the distance"))),
      feel_(new QComboBox),
      cutting_(new QComboBox),
      cut_energy_(cutEnergyBox("structureCutEnergy")),
      near_mm_(new NumberBox),
      close_mm_(new NumberBox),
      sound_(new QCheckBox(tr("Beep when near"))),
      through_(new QCheckBox(tr("Through the bone"))),
      filled_(new QCheckBox(tr("Filled in slices"))),
      open_(new QPushButton(tr("Open…"))),
      found_(new QPushButton(tr("Found with the scan"))),
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
  found_->setObjectName("foundStructures");
  found_->setToolTip(tr("Opens DICOM structures that lie with the scan: segmentations, contours"));
  found_->setMenu(new QMenu(found_));
  auto* files = new QHBoxLayout;
  files->addWidget(open_);
  files->addWidget(close_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(parts_);
  column->addLayout(files);
  column->addWidget(found_);
  showFound({});
  setReady(false);
  show(Structures{});
}

void StructuresPanel::buildList() {
  list_->setObjectName("structures");
  list_->setAccessibleName(tr("Structures"));
  list_->setColumnCount(kStructureColumns);
  list_->setHorizontalHeaderLabels({{}, {}, tr("Name"), tr("Distance"), tr("Felt"), tr("Opacity")});
  style::makeLines(*list_);
  list_->setMinimumHeight(160);
  list_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  list_->horizontalHeader()->setSectionResizeMode(StructureName, QHeaderView::Stretch);
  list_->setItemDelegateForColumn(StructureName, new NameDelegate(list_));
  list_->installEventFilter(this);
  whenKeysChange(*list_, [this] {
    list_->setToolTip(tr("%1 turns the views to the structure, %2 renames it, %3 shows or hides it")
                          .arg(keyOf(Action::GoToStructure), keyOf(Action::RenameStructure),
                               keyOf(Action::ShowStructure)));
  });
  connect(list_, &QTableWidget::itemSelectionChanged, this, &StructuresPanel::showChosen);
  connect(list_, &QTableWidget::cellClicked, this, [this](int row, int column) {
    if (column == StructureColour) return askColour(row);
    // a click elsewhere chooses it, and the camera stays
    if (column == StructureName) emit goToWanted(row);
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
  alone_->setCheckable(true);
  alone_->setToolTip(tr("Shows this structure alone; once more shows what was shown before"));
  title_->setObjectName("structureTitle");
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
  connect(watch_, &QCheckBox::toggled, this, [this](bool on) { emit watchChosen(chosen(), on); });
  auto* part = new QWidget;
  auto* grid = new QGridLayout(part);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->addWidget(title_, 0, 0, 1, 2);
  grid->addWidget(watch_, 4, 0, 1, 2);
  grid->addWidget(buildFeel(), 5, 0, 1, 2);
  buildCutting(*grid, 6);
  grid->addWidget(go_, 1, 0);
  grid->addWidget(alone_, 1, 1);
  grid->addWidget(rename_, 2, 0);
  grid->addWidget(colour_, 2, 1);
  grid->addWidget(new QLabel(tr("Opacity")), 3, 0);
  grid->addWidget(opacity_, 3, 1);
  return part;
}

QWidget* StructuresPanel::buildFeel() {
  feel_->setObjectName("structureFeel");
  feel_->setAccessibleName(tr("How the structure is felt"));
  feel_->setToolTip(tr("What is felt beside the surface of the scan; the distance is told then"));
  auto* part = new QWidget;
  auto* grid = new QGridLayout(part);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->addWidget(new QLabel(tr("Felt")), 0, 0);
  grid->addWidget(feel_, 0, 1);
  for (const FeelChoice& choice : kFeels) {
    feel_->addItem(tr(choice.name), static_cast<int>(choice.kind));
    feel_->setItemData(feel_->count() - 1, tr(choice.tip), Qt::ToolTipRole);
  }
  const auto choose = [this] {
    const StructureFeel feel = feelNow();
    showFeel(feel);
    if (chosen() >= 0) emit feelChosen(chosen(), feel);
  };
  connect(feel_, &QComboBox::currentIndexChanged, this, choose);
  for (const FeelField& field : kFeelFields) {
    auto* box = new NumberBox;
    auto* label = new QLabel(tr(field.name));
    box->setObjectName(field.object);
    box->setAccessibleName(tr(field.name));
    box->setRange(field.least, field.most);
    box->setDecimals(field.decimals);
    box->setSingleStep(field.step);
    box->setSuffix(tr(field.unit));
    box->setKeyboardTracking(false);  // what is typed is felt once it is whole
    box->setValue(StructureFeel{}.*field.value);
    connect(box, &NumberBox::valueChanged, this, choose);
    box->setToolTip(tr(field.tip));
    // all ways have the same rows, so that what stands below stays where it is
    int row = 1;
    for (const FeelNumber& other : feel_numbers_) row += other.kind == field.kind ? 1 : 0;
    QSizePolicy kept = box->sizePolicy();
    kept.setRetainSizeWhenHidden(true);
    box->setSizePolicy(kept);
    grid->addWidget(label, row, 0);
    grid->addWidget(box, row, 1);
    feel_numbers_.push_back({field.kind, field.value, label, box});
  }
  showFeel({});
  return part;
}

StructureFeel StructuresPanel::feelNow() const {
  StructureFeel feel{.kind = static_cast<StructureFeel::Kind>(feel_->currentData().toInt())};
  for (const FeelNumber& number : feel_numbers_) feel.*number.value = number.box->value();
  return feel;
}

void StructuresPanel::showFeel(const StructureFeel& feel) {
  const QSignalBlocker quiet(feel_);
  feel_->setCurrentIndex(feel_->findData(static_cast<int>(feel.kind)));
  for (const FeelNumber& number : feel_numbers_) {
    const QSignalBlocker quiet_box(number.box);
    number.box->setValue(feel.*number.value);
    number.label->setVisible(number.kind == feel.kind);
    number.box->setVisible(number.kind == feel.kind);
  }
}

void StructuresPanel::buildCutting(QGridLayout& grid, int row) {
  using Kind = StructureCutting::Kind;
  cutting_->setObjectName("structureCutting");
  cutting_->setAccessibleName(tr("How the structure is cut"));
  cutting_->setToolTip(tr("What a burr removes of it; Undo takes the choice back, as an edit"));
  cutting_->addItem(tr("As its values say"), static_cast<int>(Kind::ByValue));
  cutting_->addItem(tr("Never"), static_cast<int>(Kind::Never));
  cutting_->addItem(tr("With this energy"), static_cast<int>(Kind::Energy));
  cut_energy_->setKeyboardTracking(false);
  cut_energy_->setToolTip(tr("What it takes to remove a cubic millimetre of the structure"));
  QSizePolicy kept = cut_energy_->sizePolicy();
  kept.setRetainSizeWhenHidden(true);
  cut_energy_->setSizePolicy(kept);
  grid.addWidget(new QLabel(tr("Cut")), row, 0);
  grid.addWidget(cutting_, row, 1);
  grid.addWidget(cut_energy_, row + 1, 1);
  const auto choose = [this] {
    const StructureCutting cutting{static_cast<Kind>(cutting_->currentData().toInt()),
                                   cut_energy_->value()};
    showCutting(cutting);
    if (chosen() >= 0) emit cuttingChosen(chosen(), cutting);
  };
  connect(cutting_, &QComboBox::currentIndexChanged, this, choose);
  connect(cut_energy_, &NumberBox::valueChanged, this, choose);
  showCutting({});
}

void StructuresPanel::showCutting(const StructureCutting& cutting) {
  const QSignalBlocker quiet(cutting_), quiet_energy(cut_energy_);
  cutting_->setCurrentIndex(cutting_->findData(static_cast<int>(cutting.kind)));
  cut_energy_->setValue(cutting.energy_J_mm3);
  cut_energy_->setVisible(cutting.kind == StructureCutting::Kind::Energy);
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
    box.setRange(kLeastNear_mm, kMostNear_mm);
    box.setDecimals(1);
    box.setSingleStep(0.5);
    box.setSuffix(tr(" mm"));
    box.setValue(mm);
    connect(&box, &NumberBox::valueChanged, this, [this](double chosen_mm) {
      // what is close is near, too: one takes the other with it
      NearLimits now{near_mm_->value(), close_mm_->value()};
      if (now.close_mm > now.near_mm) now = {chosen_mm, chosen_mm};
      setLimits(now);
      emit limitsChosen(now);
    });
    grid->addWidget(new QLabel(words), row, 0);
    grid->addWidget(&box, row, 1);
  };
  add(*near_mm_, "nearFrom", tr("Near from"), limits.near_mm, 3);
  add(*close_mm_, "closeFrom", tr("Close from"), limits.close_mm, 4);
  sound_->setObjectName("nearSound");
  connect(sound_, &QCheckBox::toggled, this, &StructuresPanel::soundChosen);
  grid->addWidget(sound_, 5, 0, 1, 2);
  setSoundPossible(true);
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

void StructuresPanel::setSoundPossible(bool possible) {
  sound_->setEnabled(possible);
  sound_->setToolTip(possible ? tr("The nearer a structure whose distance is told, the sooner the "
                                   "next beep; close ones beep higher")
                              : tr("There is no program that plays sounds: install PipeWire, "
                                   "PulseAudio or ALSA's utilities"));
}

void StructuresPanel::setLimits(const NearLimits& limits) {
  const QSignalBlocker quiet_near(near_mm_), quiet_close(close_mm_);
  near_mm_->setValue(limits.near_mm);
  close_mm_->setValue(limits.close_mm);
}

void StructuresPanel::showFound(const QStringList& names) {
  QMenu* menu = found_->menu();
  menu->clear();
  for (int n = 0; n < names.size(); ++n)
    menu->addAction(QString(names[n]).replace('&', "&&"), this, [this, n] { emit foundWanted(n); });
  found_->setVisible(!names.isEmpty());
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
    // a name that was refused gives way to the one before
    if (others || structures.looks[number] != shown_.looks[number] ||
        cellOf(*list_, row, StructureName).text() != structures.looks[number].name)
      showLook(*list_, row, structures.looks[number]);
  }
  shown_ = structures;
  const auto hideUnless = [&](int column, auto&& is) {
    list_->setColumnHidden(column, std::ranges::none_of(shown_.looks, is));
  };
  hideUnless(StructureDistance, &StructureLook::watched);
  hideUnless(StructureFelt, [](const StructureLook& look) {
    return look.feel.kind != StructureFeel::Kind::AsScan ||
           look.cutting.kind == StructureCutting::Kind::Never;
  });
  hideUnless(StructureOpacity, [](const StructureLook& look) { return look.opacity < 1.0; });
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
  // what is chosen is seen
  if (chosen() < 0 || !list_->isRowHidden(chosen())) return;
  int first = 0;
  while (first < list_->rowCount() && list_->isRowHidden(first)) ++first;
  if (first < list_->rowCount())
    list_->selectRow(first);
  else
    list_->clearSelection();
}

int StructuresPanel::chosen() const {
  const QList<QTableWidgetSelectionRange> ranges = list_->selectedRanges();
  return ranges.isEmpty() ? -1 : ranges.first().topRow();
}

void StructuresPanel::showChosen() {
  const int number = chosen();
  for (QWidget* control : {static_cast<QWidget*>(go_), static_cast<QWidget*>(alone_),
                           static_cast<QWidget*>(rename_), static_cast<QWidget*>(colour_),
                           static_cast<QWidget*>(opacity_), static_cast<QWidget*>(watch_),
                           static_cast<QWidget*>(feel_), static_cast<QWidget*>(cutting_)})
    control->setEnabled(number >= 0);
  title_->setText(number < 0
                      ? QString{}
                      : numbered(number, shown_.looks[static_cast<std::size_t>(number)].name));
  // shown alone, it comes up with the others at the next click
  alone_->setChecked(number >= 0 && shown_.looks[static_cast<std::size_t>(number)].visible &&
                     std::ranges::count_if(shown_.looks, &StructureLook::visible) == 1);
  const QSignalBlocker quiet(opacity_), quiet_watch(watch_);
  showCutting(number < 0 ? StructureCutting{}
                         : shown_.looks[static_cast<std::size_t>(number)].cutting);
  showFeel(number < 0 ? StructureFeel{} : shown_.looks[static_cast<std::size_t>(number)].feel);
  const std::int64_t bytes =
      number < 0 ? 0 : shown_.looks[static_cast<std::size_t>(number)].distance_bytes;
  const QString size = QLocale().formattedDataSize(bytes, 1, QLocale::DataSizeSIFormat);
  watch_->setText(bytes == 0 ? tr("Tell the distance")
                             : tr("Tell the distance (%1 of memory)").arg(size));
  watch_->setToolTip(
      tr("Tells how far the tool is from the structure, beside the force and in recordings. Its "
         "distances need %1 of memory.")
          .arg(size));
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
