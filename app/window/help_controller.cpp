// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/help_controller.h"

#include <QApplication>
#include <QFile>

#include "app/window/sentence.h"

namespace app {

QString helpPlaceOf(const QString& sentence) {
  const std::string id{resources::idOf(sentence.toStdString(), windowsLanguage())};
  if (id.empty()) return {};
  const QString entry = QStringLiteral("- `%1`:").arg(QString::fromStdString(id));
  for (const QString& page : ui::helpPages()) {
    if (!page.startsWith(QLatin1String("messages-"))) continue;
    QFile file(QStringLiteral(":/help/%1.md").arg(page));
    if (file.open(QIODevice::ReadOnly) && QString::fromUtf8(file.readAll()).contains(entry))
      return page + '#' + QString::fromStdString(id);
  }
  return {};
}

HelpController::HelpController(ui::MainWindow& window) : window_(window) {
  window.setExplainer(helpPlaceOf);
  connect(&window, &ui::MainWindow::helpWanted, this, [this](const QString& place) {
    open(place.isEmpty() ? ui::helpPageOf(QApplication::focusWidget()) : place);
  });
}

void HelpController::open(const QString& place) {
  if (shown_ == nullptr) shown_ = new ui::HelpWindow(&window_);
  shown_->open(place);
}

}  // namespace app
