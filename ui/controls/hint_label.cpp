// SPDX-License-Identifier: BSD-3-Clause
#include "ui/controls/hint_label.h"

namespace ui {

QLabel* hintLabel(const QString& words) {
  auto* hint = new QLabel(words);
  hint->setWordWrap(true);
  hint->setTextFormat(Qt::PlainText);
  QSizePolicy policy = hint->sizePolicy();
  policy.setHorizontalPolicy(QSizePolicy::Ignored);
  hint->setSizePolicy(policy);
  return hint;
}

}  // namespace ui
