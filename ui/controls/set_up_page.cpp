// SPDX-License-Identifier: BSD-3-Clause
#include "ui/controls/set_up_page.h"

#include <QDialogButtonBox>
#include <QFile>
#include <QTextBrowser>
#include <QVBoxLayout>

namespace ui {
namespace {

QString resource(const QString& name) {
  QFile file(QStringLiteral(":/help/device-%1.md").arg(name));
  return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString{};
}

}  // namespace

QString setUpPage(const QString& device) { return resource(device.section(':', 0, 0)); }

SetUpDialog::SetUpDialog(const QString& device, const QString& name, bool has_motors,
                         QWidget* parent)
    : QDialog(parent) {
  setWindowTitle(tr("Set up: %1").arg(name));
  setAttribute(Qt::WA_DeleteOnClose);
  auto* page = new QTextBrowser;
  page->setObjectName("setUpPage");
  page->setAccessibleName(windowTitle());
  QString text = setUpPage(device);
  if (has_motors) text += '\n' + resource("every");
  page->setMarkdown(text);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* column = new QVBoxLayout(this);
  column->addWidget(page, 1);
  column->addWidget(buttons);
  resize(560, 620);
}

}  // namespace ui
