// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QAbstractButton>
#include <QApplication>
#include <QFileDialog>
#include <QLineEdit>
#include <QMessageBox>
#include <QString>
#include <QTest>
#include <QTimer>

namespace window {

/// Answers each question by its button that begins so, as long as it lives.
struct Answer {
  explicit Answer(const char* button) {
    QObject::connect(&timer, &QTimer::timeout, [this, button] {
      auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
      if (box == nullptr) return;
      said = box->text() + " " + box->informativeText();
      for (QAbstractButton* choice : box->buttons())
        if (choice->text().remove('&').startsWith(button)) return choice->click();
    });
    timer.start(20);
  }
  QTimer timer;
  QString said;  ///< the last question; empty: none was asked
};

/// Types a name into the next file dialog.
struct FileName {
  explicit FileName(const QString& path) {
    QObject::connect(&timer, &QTimer::timeout, [this, path] {
      auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
      if (dialog == nullptr) return;
      timer.stop();
      auto* name = dialog->findChild<QLineEdit*>("fileNameEdit");
      name->setText(path);
      QTest::keyClick(name, Qt::Key_Return);
    });
    timer.start(20);
  }
  QTimer timer;
};

}  // namespace window
