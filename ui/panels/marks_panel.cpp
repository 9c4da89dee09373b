// SPDX-License-Identifier: BSD-3-Clause
#include "ui/panels/marks_panel.h"

#include <QAbstractItemDelegate>
#include <QAction>
#include <QApplication>
#include <QGridLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/controls/bindings.h"
#include "ui/overlays/measure_words.h"
#include "ui/style/style.h"

namespace ui {
namespace {

enum MarkColumn { MarkText, MarkValue, kMarkColumns };

constexpr Action kPlaceActions[] = {Action::PlaceDistance, Action::PlaceAngle, Action::PlacePoint,
                                    Action::PlaceNote};
constexpr const char* kPlaceNames[] = {"placeDistance", "placeAngle", "placePoint", "placeNote"};

/// Sets a cell's words if they are others, as plain text.
void setCell(QTableWidget& list, int row, int column, const QString& text, bool editable) {
  QTableWidgetItem* item = list.item(row, column);
  if (item == nullptr) {
    item = new QTableWidgetItem;
    item->setFlags(Qt::ItemIsSelectable | Qt::ItemIsEnabled |
                   (editable ? Qt::ItemIsEditable : Qt::NoItemFlags));
    list.setItem(row, column, item);
  }
  if (item->text() == text) return;
  item->setText(text);
  item->setToolTip(QStringLiteral("<qt>%1</qt>").arg(text.toHtmlEscaped()));
}

}  // namespace

MarksPanel::MarksPanel(QWidget* parent)
    : QWidget(parent),
      list_(new QTableWidget),
      go_(new QPushButton(tr("&Go to"))),
      rename_(new QPushButton(tr("&Rename"))),
      remove_(new QPushButton(tr("De&lete"))),
      restore_(new QPushButton(tr("&Undo delete"))),
      travel_start_(new QPushButton),
      travel_end_(new QPushButton(tr("End"))),
      travel_(new QLabel) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(buildTools());
  buildList();
  column->addWidget(list_, 1);
  // two by two: the panel is narrow
  auto* buttons = new QGridLayout;
  buttons->addWidget(go_, 0, 0);
  buttons->addWidget(rename_, 0, 1);
  buttons->addWidget(remove_, 1, 0);
  buttons->addWidget(restore_, 1, 1);
  column->addLayout(buttons);
  column->addWidget(buildTravel());
  auto* accuracy = new QLabel(tr("± is the accuracy that the voxels allow."));
  accuracy->setObjectName("marksAccuracy");
  accuracy->setToolTip(
      tr("Half a voxel diagonal for each place. Errors of the scanner and of the choice of the "
         "places are not in it."));
  accuracy->setWordWrap(true);
  column->addWidget(accuracy);
  setFocusProxy(list_);
  setReady(false);
  setCanRestore(false);
  showTravel({});
  showChosen();
}

QWidget* MarksPanel::buildTools() {
  const QString tips[] = {
      tr("Press at the two ends, or drag from one to the other"),
      tr("Press at the end of one leg, at the corner, and at the end of the other leg"),
      tr("Press at the place to read"), tr("Press where the note belongs, then type it")};
  auto* tools = new QWidget;
  auto* grid = new QGridLayout(tools);
  grid->setContentsMargins(0, 0, 0, 0);
  for (const MeasureKind kind : kMeasureKinds) {
    const auto i = static_cast<std::size_t>(kind);
    auto* action = new QAction(nameOf(kind), this);
    actions_[i] = action;
    action->setObjectName(kPlaceNames[i]);
    action->setCheckable(true);
    // only while a view has the focus: in a field a letter is a letter
    action->setShortcutContext(Qt::WidgetShortcut);
    action->setAutoRepeat(false);
    whenKeysChange(*action, [action, tip = tips[i], of = kPlaceActions[i]] {
      action->setShortcuts(shortcutsOf(of));
      action->setToolTip(tr("%1 (key %2 in a view)").arg(tip, keyOf(of)));
    });
    connect(action, &QAction::triggered, this,
            [this, i](bool on) { emit placingWanted(on ? static_cast<int>(i) : -1); });
    auto* button = new QToolButton;
    button->setDefaultAction(action);
    button->setToolButtonStyle(Qt::ToolButtonTextOnly);
    button->setObjectName(QString(kPlaceNames[i]) + "Button");
    button->setFocusPolicy(Qt::TabFocus);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    grid->addWidget(button, static_cast<int>(i) / 2, static_cast<int>(i) % 2);
  }
  return tools;
}

void MarksPanel::buildList() {
  list_->setObjectName("marks");
  list_->setAccessibleName(tr("Measures, marks and notes"));
  list_->setColumnCount(kMarkColumns);
  list_->setHorizontalHeaderLabels({tr("Name or note"), tr("Value")});
  style::makeLines(*list_, tr("No measures or marks yet: choose one above, then click in a view"));
  list_->setMinimumHeight(160);
  list_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  list_->horizontalHeader()->setSectionResizeMode(MarkText, QHeaderView::Stretch);
  list_->installEventFilter(this);
  connect(list_->itemDelegate(), &QAbstractItemDelegate::closeEditor, this, &MarksPanel::typed);
  whenKeysChange(*list_, [this] {
    list_->setToolTip(tr("%1 shows the place, %2 renames, %3 deletes")
                          .arg(keyOf(Action::GoToMark), keyOf(Action::RenameMark),
                               keyOf(Action::DeleteMark, Where::Marks)));
  });
  go_->setObjectName("goToMark");
  whenKeysChange(*this, [this] {
    go_->setToolTip(withKey(tr("Moves the crosshair to the place; again, to its next place"),
                            Action::GoToMark));
    rename_->setToolTip(withKey(tr("Renames the mark, or edits the note"), Action::RenameMark));
    remove_->setToolTip(withKey(tr("Deletes the mark"), Action::DeleteMark));
  });
  rename_->setObjectName("renameMark");
  remove_->setObjectName("removeMark");
  restore_->setObjectName("restoreMark");
  restore_->setToolTip(tr("Brings back the mark that was deleted last"));
  connect(list_, &QTableWidget::itemSelectionChanged, this, [this] {
    showChosen();
    emit selected(chosen());
  });
  connect(list_, &QTableWidget::itemChanged, this, [this](QTableWidgetItem* item) {
    if (item->column() == MarkText) emit renamed(item->row(), item->text());
  });
  connect(list_, &QTableWidget::cellDoubleClicked, this, [this](int row) { emit goToWanted(row); });
  connect(go_, &QPushButton::clicked, this, [this] { emit goToWanted(chosen()); });
  connect(rename_, &QPushButton::clicked, this, [this] { edit(chosen()); });
  connect(remove_, &QPushButton::clicked, this, [this] { emit removeWanted(chosen()); });
  connect(restore_, &QPushButton::clicked, this, &MarksPanel::restoreWanted);
}

QWidget* MarksPanel::buildTravel() {
  travel_start_->setObjectName("travelStart");
  travel_start_->setToolTip(tr("Measures the way of the tool from where it is now"));
  travel_end_->setObjectName("travelEnd");
  travel_end_->setToolTip(tr("Ends the measurement of the way"));
  travel_->setObjectName("travelled");
  travel_->setTextFormat(Qt::PlainText);
  travel_->setWordWrap(true);
  connect(travel_start_, &QPushButton::clicked, this, [this] { emit travelWanted(true); });
  connect(travel_end_, &QPushButton::clicked, this, [this] { emit travelWanted(false); });
  auto* part = new QWidget;
  auto* grid = new QGridLayout(part);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->addWidget(travel_, 0, 0, 1, 2);
  grid->addWidget(travel_start_, 1, 0);
  grid->addWidget(travel_end_, 1, 1);
  return part;
}

bool MarksPanel::eventFilter(QObject* watched, QEvent* event) {
  if (watched != list_ || event->type() != QEvent::KeyPress) return false;
  const Binding* meaning = meaningOf(Where::Marks, *static_cast<QKeyEvent*>(event));
  if (chosen() < 0 || meaning == nullptr) return false;
  // Enter also comes from the field in which a text is typed
  const QWidget* focus = QApplication::focusWidget();
  if (focus != nullptr && focus != list_ && list_->isAncestorOf(focus)) return false;
  if (meaning->action == Action::DeleteMark)
    emit removeWanted(chosen());
  else if (meaning->action == Action::GoToMark)
    emit goToWanted(chosen());
  else if (meaning->action == Action::RenameMark)
    edit(chosen());  // whatever cell is the current one
  else
    return false;
  return true;
}

void MarksPanel::setReady(bool ready) {
  for (QAction* action : actions_) action->setEnabled(ready);
  travel_start_->setEnabled(ready);
}

void MarksPanel::show(const QList<MarkRow>& rows) {
  const QSignalBlocker quiet(list_);
  if (list_->rowCount() != rows.size()) list_->setRowCount(static_cast<int>(rows.size()));
  for (int row = 0; row < list_->rowCount(); ++row) {
    setCell(*list_, row, MarkText, rows[row].text, true);
    setCell(*list_, row, MarkValue, rows[row].value, false);
  }
  showChosen();
}

void MarksPanel::setCanRestore(bool can) { restore_->setEnabled(can); }

void MarksPanel::select(int index) {
  if (index == chosen()) return;
  const QSignalBlocker quiet(list_);
  list_->clearSelection();
  if (index >= 0) {
    list_->setCurrentCell(index, MarkText);
    list_->selectRow(index);
  }
  showChosen();
}

void MarksPanel::edit(int index) {
  QTableWidgetItem* item = list_->item(index, MarkText);
  if (item == nullptr) return;
  list_->setFocus();
  list_->setCurrentItem(item);
  list_->editItem(item);
}

void MarksPanel::showPlacing(int kind) {
  for (std::size_t i = 0; i < actions_.size(); ++i)
    actions_[i]->setChecked(static_cast<int>(i) == kind);
}

void MarksPanel::showTravel(const std::optional<QString>& words) {
  const QString text = words.value_or(tr("The tool's way is not measured."));
  if (travel_->text() != text) travel_->setText(text);
  const QString start = words ? tr("Start again") : tr("Start at the tool");
  if (travel_start_->text() != start) travel_start_->setText(start);
  travel_end_->setEnabled(words.has_value());
}

int MarksPanel::chosen() const {
  const QList<QTableWidgetSelectionRange> ranges = list_->selectedRanges();
  return ranges.isEmpty() ? -1 : ranges.first().topRow();
}

void MarksPanel::showChosen() {
  const bool any = chosen() >= 0;
  for (QPushButton* button : {go_, rename_, remove_}) button->setEnabled(any);
}

}  // namespace ui
