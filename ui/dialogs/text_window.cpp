// SPDX-License-Identifier: BSD-3-Clause
#include "ui/dialogs/text_window.h"

#include <QClipboard>
#include <QDialogButtonBox>
#include <QFontDatabase>
#include <QGuiApplication>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QVBoxLayout>

namespace ui {

TextWindow::TextWindow(const char* name, const QString& title, const QString& about,
                       const QString& text, QWidget* parent)
    : QDialog(parent),
      text_(new QPlainTextEdit(text)),
      buttons_(new QDialogButtonBox(QDialogButtonBox::Close)) {
  setObjectName(name);
  setWindowTitle(title);
  setAttribute(Qt::WA_DeleteOnClose);
  auto* sentence = new QLabel(about);
  sentence->setTextFormat(Qt::PlainText);
  sentence->setWordWrap(true);
  sentence->setBuddy(text_);
  text_->setObjectName("text");
  text_->setAccessibleName(title);
  text_->setReadOnly(true);
  text_->setTabChangesFocus(true);
  text_->setLineWrapMode(QPlainTextEdit::NoWrap);
  text_->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  QPushButton* copy = buttons_->addButton(tr("Copy"), QDialogButtonBox::ActionRole);
  copy->setObjectName("copyText");
  connect(copy, &QPushButton::clicked, this,
          [this] { QGuiApplication::clipboard()->setText(text_->toPlainText()); });
  connect(buttons_, &QDialogButtonBox::rejected, this, &QWidget::close);
  auto* column = new QVBoxLayout(this);
  column->addWidget(sentence);
  column->addWidget(text_);
  column->addWidget(buttons_);
  resize(860, 560);
}

void TextWindow::offerDelete() {
  QPushButton* button = buttons_->addButton(tr("Delete"), QDialogButtonBox::DestructiveRole);
  button->setObjectName("deleteText");
  connect(button, &QPushButton::clicked, this, [this] {
    emit deleteWanted();
    close();
  });
}

}  // namespace ui
