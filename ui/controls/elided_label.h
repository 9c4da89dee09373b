// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QLabel>
#include <QPainter>

namespace ui {

/// Plain text in one line that gives way to what stands beside it: it is cut with dots, and then
/// its tooltip has it whole.
class ElidedLabel : public QLabel {
 public:
  explicit ElidedLabel(QWidget* parent = nullptr) : QLabel(parent) {
    setTextFormat(Qt::PlainText);
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  }

  /// As it is drawn.
  QString shownText() const {
    return fontMetrics().elidedText(text(), Qt::ElideRight, contentsRect().width());
  }

 protected:
  void paintEvent(QPaintEvent*) override {
    const QString shown = shownText();
    setToolTip(shown == text() ? QString{}
                               : QStringLiteral("<qt>%1</qt>").arg(text().toHtmlEscaped()));
    QPainter(this).drawText(contentsRect(), int(alignment()), shown);
  }
};

}  // namespace ui
