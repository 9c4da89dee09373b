// SPDX-License-Identifier: BSD-3-Clause
#include "ui/dialogs/save_dialog.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QGridLayout>
#include <QLabel>
#include <QStandardPaths>

namespace ui {

namespace {

QString& lastFolder() {
  static QString folder;
  if (folder.isEmpty())
    folder = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
  // an account without one; the dialog would begin in the folder that the program was started from
  if (!QFileInfo(folder).isDir()) folder = QDir::homePath();
  return folder;
}

}  // namespace

QString folderOfOutput() { return lastFolder(); }

void askForOutput(QFileDialog& dialog, const QString& filter, const QString& ending) {
  // Qt's own dialog: in a foreign one Escape would not reach the application
  dialog.setOption(QFileDialog::DontUseNativeDialog);
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setNameFilter(filter);
  dialog.setDefaultSuffix(ending);
  dialog.setDirectory(lastFolder());
  QObject::connect(&dialog, &QFileDialog::fileSelected,
                   [](const QString& file) { lastFolder() = QFileInfo(file).absolutePath(); });
}

void addNotesWarning(QFileDialog& dialog) {
  auto* words = new QLabel(QCoreApplication::translate(
      "ui::SaveDialog", "Notes are saved as you wrote them: do not name the patient."));
  words->setObjectName("notesWarning");
  words->setWordWrap(true);
  if (auto* grid = qobject_cast<QGridLayout*>(dialog.layout()))
    grid->addWidget(words, grid->rowCount(), 0, 1, -1);
}

}  // namespace ui
