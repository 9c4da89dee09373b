// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QFrame>

class QHBoxLayout;
class QLabel;
class QPushButton;

namespace ui {

/// A bar over the whole width, with a symbol, a sentence and what can be done.
class Banner : public QFrame {
  Q_OBJECT
 public:
  enum class Kind { Attention, Fault, Stopped, Done };

  /// `name` is that of the sentence.
  Banner(Kind kind, const char* name, QWidget* parent = nullptr);

  void setSentence(const QString& sentence);
  /// A button behind the sentence.
  QPushButton* addButton(const char* name);
  /// A cross at the end, which hides the bar.
  void addClose();

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  Kind kind_;
  QLabel* sentence_;
  QHBoxLayout* row_;
};

}  // namespace ui
