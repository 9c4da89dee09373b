// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QLabel>

#include "ui/controls/spoken.h"

namespace ui {

/// What stands before a state in words: a shape of its own for each, and a colour.
enum class Mark {
  None,
  On,         ///< disc
  Rising,     ///< half a disc
  Held,       ///< two bars
  Ready,      ///< ring
  Off,        ///< dash
  Fault,      ///< triangle
  Shown,      ///< diamond
  Replay,     ///< arrowhead
  Recording,  ///< disc in a ring
};

/// A state in a word or a few, with its mark.
/// Screen readers are told each change once: its accessible name, and the words.
class StateChip : public QLabel, public Spoken {
  Q_OBJECT
 public:
  explicit StateChip(QWidget* parent = nullptr);

  void show(Mark mark, const QString& words);
  using QLabel::show;
  /// What stands behind the words and steps back, such as the hand.
  void setDetail(const QString& detail);
  const QString& detail() const { return detail_; }
  Mark mark() const { return mark_; }

  QAccessible::Role spokenRole() const override { return QAccessible::Notification; }
  QString spokenName() const override;
  QSize sizeHint() const override;
  /// The words without their detail.
  QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  Mark mark_ = Mark::None;
  QString detail_;
};

}  // namespace ui
