// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QString>

class QFileDialog;

namespace ui {

/// Makes the dialog ask for a file to write, with this filter and this ending ("png"). It begins in
/// the folder where a file was last written since the program's start, or else in the user's
/// documents. GUI thread.
void askForOutput(QFileDialog& dialog, const QString& filter, const QString& ending);
/// That folder.
QString folderOfOutput();

/// Says in the dialog that notes are written as the user wrote them.
void addNotesWarning(QFileDialog& dialog);

}  // namespace ui
