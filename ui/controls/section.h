// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QAbstractButton>
#include <QWidget>

#include "ui/controls/spoken.h"

namespace ui {

/// The heading of a section: its name, and whether it is folded.
class SectionHead : public QAbstractButton, public Spoken {
  Q_OBJECT
 public:
  explicit SectionHead(const QString& title, QWidget* parent = nullptr);
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

  QAccessible::Role spokenRole() const override { return QAccessible::Button; }
  void spokenState(QAccessible::State& state) const override;

 protected:
  void paintEvent(QPaintEvent* event) override;
};

/// A panel under a heading that folds it away.
class Section : public QWidget {
  Q_OBJECT
 public:
  Section(const QString& title, QWidget* panel, bool folded_at_first, QWidget* parent = nullptr);

  QWidget& panel() { return *panel_; }
  bool folded() const;
  void setFolded(bool folded);
  /// As at the first start.
  void reset() { setFolded(folded_at_first_); }

 signals:
  void foldedChanged();

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  SectionHead* head_;
  QWidget* body_;
  QWidget* panel_;
  bool folded_at_first_;
};

}  // namespace ui
