// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QKeyCombination>
#include <QPushButton>
#include <QWidget>

class QLineEdit;
class QTableWidget;

namespace ui {

class WarningLabel;

/// A button that takes the next key. Escape, and leaving it, take none.
class KeyButton : public QPushButton {
  Q_OBJECT
 public:
  explicit KeyButton(QWidget* parent = nullptr);
  /// Takes the next key, from now on.
  void listen();
  bool listens() const { return listens_; }

 signals:
  void pressedKey(QKeyCombination key);

 protected:
  bool event(QEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;

 private:
  void setListening(bool listens);

  bool listens_ = false;
};

/// All that keys and mouse do, from the table that Help is printed from, with a search. Keys can be
/// changed here; a key that is taken, or that others need, is refused with the reason.
class ShortcutList : public QWidget {
  Q_OBJECT
 public:
  explicit ShortcutList(QWidget* parent = nullptr);

 signals:
  /// The user changed a key.
  void keysChanged();

 private:
  void fill();
  void search();
  void showChosen();
  void change(QKeyCombination key);
  /// Shows why a key was refused; empty: that it was taken.
  void say(const QString& refusal);

  QLineEdit* search_;
  QTableWidget* list_;
  KeyButton* change_;
  QPushButton* reset_;
  QPushButton* reset_all_;
  WarningLabel* said_;
};

}  // namespace ui
