// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QDialog>

class QDialogButtonBox;
class QPlainTextEdit;

namespace ui {

/// A text to read and to copy, such as the log. Not modal; it deletes itself when it is closed.
class TextWindow : public QDialog {
  Q_OBJECT
 public:
  /// `name`: of the window for programs. `about`: a sentence above the text.
  TextWindow(const char* name, const QString& title, const QString& about, const QString& text,
             QWidget* parent);
  /// A button "Delete" beside the others, which closes the window as well.
  void offerDelete();

 signals:
  void deleteWanted();

 private:
  QPlainTextEdit* text_;
  QDialogButtonBox* buttons_;
};

}  // namespace ui
