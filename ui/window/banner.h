// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QFrame>

#include "ui/controls/spoken.h"

class QBoxLayout;
class QHBoxLayout;
class QLabel;
class QPushButton;

namespace ui {

/// A bar over the whole width, with a symbol, a sentence and what can be done.
/// Screen readers are told its sentence when it comes, and when it is another.
class Banner : public QFrame, public Spoken {
  Q_OBJECT
 public:
  enum class Kind { Attention, Fault, Stopped, Done, Question };

  /// `name` is that of the sentence.
  Banner(Kind kind, const char* name, QWidget* parent = nullptr);

  void setSentence(const QString& sentence);
  /// A button behind the sentence.
  QPushButton* addButton(const char* name);
  /// The buttons stand below the sentence.
  void setStacked(bool stacked);
  /// px, that it needs with its buttons below the sentence or beside it.
  int leastWidth(bool stacked) const;
  int heightIf(bool stacked, int width) const;
  /// A cross at the end, which hides the bar.
  void addClose();

  QAccessible::Role spokenRole() const override { return QAccessible::AlertMessage; }
  QString spokenName() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  Kind kind_;
  QLabel* sentence_;
  QBoxLayout* parts_;
  QHBoxLayout* buttons_;
};

}  // namespace ui
