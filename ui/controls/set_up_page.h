// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QDialog>
#include <QString>

namespace ui {

/// What a device needs before it can be used: cables and power, permission, first use, and what can
/// go wrong. Markdown. `device`: an id of the list, or the name of its driver; empty if there is no
/// page.
QString setUpPage(const QString& device);

/// Shows the page. Not modal, so that the user can follow it while the device is connected.
class SetUpDialog : public QDialog {
  Q_OBJECT
 public:
  SetUpDialog(const QString& device, const QString& name, bool has_motors,
              QWidget* parent = nullptr);
};

}  // namespace ui
