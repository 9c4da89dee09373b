// SPDX-License-Identifier: BSD-3-Clause
#include "ui/dialogs/shortcut_list.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLineEdit>
#include <QTableWidget>
#include <QVBoxLayout>

#include "ui/controls/bindings.h"
#include "ui/controls/warning_label.h"
#include "ui/style/style.h"

namespace ui {
namespace {

constexpr int kPlaceWidth = 148;  // px

enum ShortcutColumn { ShortcutKey, ShortcutPlace, ShortcutWords, kShortcutColumns };

/// What it does, and where an arrow key goes: the four have the same words.
QString wordsWithWay(const Binding& binding) {
  const QPoint way = wayOf(binding);
  const QString words = wordsOf(binding);
  if (way.isNull() || binding.gesture != Gesture::Key) return words;
  const QString where = way.x() < 0   ? ShortcutList::tr("left")
                        : way.x() > 0 ? ShortcutList::tr("right")
                        : way.y() < 0 ? ShortcutList::tr("up")
                                      : ShortcutList::tr("down");
  return ShortcutList::tr("%1: %2").arg(words, where);
}

bool canChange(const Binding& binding) { return *binding.name != '\0'; }

bool isChanged(const Binding& binding) {
  return canChange(binding) &&
         binding.at_first != QKeyCombination(binding.modifiers, static_cast<Qt::Key>(binding.key));
}

const Binding& bindingAt(int row) { return bindings()[static_cast<std::size_t>(row)]; }

}  // namespace

KeyButton::KeyButton(QWidget* parent) : QPushButton(parent) {
  setCheckable(true);
  setListening(false);
  connect(this, &QPushButton::clicked, this, &KeyButton::setListening);
}

void KeyButton::listen() {
  setFocus();
  setListening(true);
}

void KeyButton::setListening(bool listens) {
  listens_ = listens;
  setChecked(listens);
  setText(listens ? tr("Press the key…") : tr("&Change…"));
  setToolTip(listens ? tr("Press the new key, or Escape to cancel")
                     : tr("Takes another key for the chosen line: the next that is pressed"));
}

bool KeyButton::event(QEvent* event) {
  const bool press = event->type() == QEvent::KeyPress;
  if (!listens_ || (!press && event->type() != QEvent::ShortcutOverride))
    return QPushButton::event(event);
  auto& key = static_cast<QKeyEvent&>(*event);
  event->accept();
  if (!press) return true;  // no shortcut takes it; it comes again as a key
  switch (key.key()) {
    case Qt::Key_Shift:
    case Qt::Key_Control:
    case Qt::Key_Alt:
    case Qt::Key_Meta:
    case Qt::Key_AltGr:
    case Qt::Key_unknown:
      return true;  // the beginning of a key
    default:
      break;
  }
  setListening(false);
  if (key.key() != Qt::Key_Escape) emit pressedKey(plainKey(key));
  return true;
}

void KeyButton::focusOutEvent(QFocusEvent* event) {
  setListening(false);
  QPushButton::focusOutEvent(event);
}

ShortcutList::ShortcutList(QWidget* parent)
    : QWidget(parent),
      search_(new QLineEdit),
      list_(new QTableWidget),
      change_(new KeyButton),
      reset_(new QPushButton(tr("&Reset"))),
      reset_all_(new QPushButton(tr("Reset &all"))),
      said_(new WarningLabel) {
  search_->setObjectName("shortcutSearch");
  search_->setAccessibleName(tr("Search shortcuts"));
  search_->setPlaceholderText(tr("Search: a key, a place or a function"));
  search_->setToolTip(tr("Shows the lines that have all these words"));
  search_->setClearButtonEnabled(true);
  list_->setObjectName("shortcuts");
  list_->setAccessibleName(tr("Shortcuts"));
  list_->setToolTip(tr("Enter or a double-click changes the key of a line"));
  list_->setColumnCount(kShortcutColumns);
  list_->setHorizontalHeaderLabels({tr("Key"), tr("Where"), tr("Function")});
  style::makeLines(*list_);
  list_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  list_->horizontalHeader()->setSectionResizeMode(ShortcutWords, QHeaderView::Stretch);
  // the few long places are said in full by their tool tips
  list_->horizontalHeader()->setSectionResizeMode(ShortcutPlace, QHeaderView::Interactive);
  list_->setColumnWidth(ShortcutPlace, kPlaceWidth);
  change_->setObjectName("changeShortcut");
  reset_->setObjectName("resetShortcut");
  reset_->setToolTip(tr("Gives the chosen line the key that it has at first"));
  reset_all_->setObjectName("resetShortcuts");
  reset_all_->setToolTip(tr("Gives every line the key that it has at first"));
  for (QPushButton* button : {static_cast<QPushButton*>(change_), reset_, reset_all_})
    button->setAutoDefault(false);
  said_->setObjectName("shortcutSaid");
  said_->setWordWrap(true);
  said_->setTextFormat(Qt::PlainText);
  auto* row = new QHBoxLayout;
  row->addWidget(change_);
  row->addWidget(reset_);
  row->addStretch();
  row->addWidget(reset_all_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(search_);
  column->addWidget(list_, 1);
  column->addWidget(said_);
  column->addLayout(row);

  list_->setRowCount(static_cast<int>(bindings().size()));
  whenKeysChange(*this, [this] { fill(); });
  connect(search_, &QLineEdit::textChanged, this, &ShortcutList::search);
  connect(list_, &QTableWidget::itemSelectionChanged, this, &ShortcutList::showChosen);
  connect(list_, &QTableWidget::cellActivated, this, [this] {
    if (change_->isEnabled()) change_->listen();
  });
  connect(change_, &KeyButton::pressedKey, this, &ShortcutList::change);
  connect(reset_, &QPushButton::clicked, this,
          [this] { change(bindingAt(list_->currentRow()).at_first); });
  connect(reset_all_, &QPushButton::clicked, this, [this] {
    setOwnKeys({});
    say({});
    emit keysChanged();
  });
  list_->selectRow(0);
  showChosen();
}

void ShortcutList::fill() {
  for (int row = 0; row < list_->rowCount(); ++row) {
    const Binding& binding = bindingAt(row);
    const QString cells[] = {triggerOf(binding), placeOf(binding), wordsWithWay(binding)};
    for (int column = 0; column < kShortcutColumns; ++column) {
      QTableWidgetItem* item = list_->item(row, column);
      if (item == nullptr) {
        item = new QTableWidgetItem;
        item->setFlags(Qt::ItemIsSelectable | Qt::ItemIsEnabled);
        list_->setItem(row, column, item);
      }
      item->setText(cells[column]);
      item->setToolTip(cells[column]);
      QFont font = list_->font();
      font.setBold(column == ShortcutKey && isChanged(binding));
      item->setFont(font);
    }
  }
  search();
  showChosen();
}

void ShortcutList::search() {
  const QStringList words = search_->text().split(' ', Qt::SkipEmptyParts);
  for (int row = 0; row < list_->rowCount(); ++row) {
    QString line;
    for (int column = 0; column < kShortcutColumns; ++column)
      line += list_->item(row, column)->text() + '\n';
    bool found = true;
    for (const QString& word : words) found = found && line.contains(word, Qt::CaseInsensitive);
    list_->setRowHidden(row, !found);
  }
}

void ShortcutList::showChosen() {
  const int row = list_->currentRow();
  const bool can = row >= 0 && !list_->selectedItems().isEmpty() && canChange(bindingAt(row));
  change_->setEnabled(can);
  reset_->setEnabled(can && isChanged(bindingAt(row)));
  reset_all_->setEnabled(!ownKeys().isEmpty());
  said_->setWarning(false);
  const bool key = row >= 0 && (bindingAt(row).gesture == Gesture::Key ||
                                bindingAt(row).gesture == Gesture::HeldKey);
  said_->setText(
      can   ? isChanged(bindingAt(row))
                  ? tr("At first: %1")
                      .arg(QKeySequence(bindingAt(row).at_first).toString(QKeySequence::NativeText))
                  : tr("Press Change, then the key.")
        : key ? tr("Escape and Space stop the force and cannot be changed.")
            : tr("The mouse's functions cannot be changed."));
}

void ShortcutList::change(QKeyCombination key) {
  const int row = list_->currentRow();
  if (row < 0) return;
  const QString refusal = changeKey(QString::fromLatin1(bindingAt(row).name), key);
  say(refusal);
  if (refusal.isEmpty()) emit keysChanged();
}

void ShortcutList::say(const QString& refusal) {
  if (refusal.isEmpty()) return showChosen();
  said_->setWarning(true);
  said_->setText(refusal);
}

}  // namespace ui
