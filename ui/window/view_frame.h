// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QColor>
#include <QList>
#include <QRect>
#include <QWidget>
#include <cstddef>
#include <functional>
#include <vector>

class QLabel;
class QToolButton;

namespace ui {

class ForcePanel;

/// A view under a line in its colour, with its buttons in the upper right corner: a menu, if the
/// view has one, and one that makes the view as large as all of them, or gives the others back. At
/// its foot a line says what the mouse does in the view.
class ViewFrame : public QWidget {
  Q_OBJECT
 public:
  ViewFrame(QWidget* view, const QColor& colour, bool has_menu, QWidget* parent = nullptr);

  QWidget& view() { return *view_; }
  /// Gives half of the room to another view, at the left or above; null: all of it is the view's.
  void setBefore(QWidget* before);
  /// Whether the button gives the others back.
  void setMaximised(bool maximised);
  void setHint(const QString& hint);
  void setHintShown(bool shown);
  /// Words on a plate at a side of the view; empty: no plate. It leaves the pointer free, and what
  /// is written in the view.
  void setPointed(const QString& words, std::vector<QRectF> written);
  /// Whether the slices go with the tool, as its button shows.
  void setFollowing(bool on);
  /// How much of the view's upper edge its buttons cover, from the right.
  int buttonRoom() const;
  /// Shows the force in a corner of the view, at first the lower right one: the figure alone where
  /// the view is small, and not at all where it would cover the most of it. `taken`: whether there
  /// is something in this part of the view that must not be covered; `disliked`: something that is
  /// covered only where the card has no other corner.
  using IsIn = std::function<bool(const QRect& part)>;
  void setCard(ForcePanel& card, IsIn taken, IsIn disliked);
  /// Moves the card to a corner that is free, folded to one line where nothing else is.
  void keepCardClear();
  /// Where sentences lie over the view, in its coordinates.
  void setSentences(const QList<QRect>& parts);
  /// Whether the user folded the card.
  bool cardFolded() const { return card_folded_; }
  void setCardFolded(bool folded);
  QSize minimumSizeHint() const override;

 signals:
  /// The user wants no hints, in any view.
  void hintsUnwanted();
  void maximiseWanted();
  /// The user folded the card, or unfolded it.
  void cardFoldedChanged();
  /// The card or sentences cover other parts of the view.
  void coveredChanged(const std::vector<QRectF>& parts);
  void menuWanted(QPoint at);
  void fitWanted();
  void followWanted(bool on);

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  QList<QToolButton*> buttons() const;
  void place();
  void placePointed();
  QRect cardIn(std::size_t corner, bool folded) const;
  bool meetsSentence(const QRect& part) const;
  void tellCovered();

  QWidget* view_;
  QWidget* before_ = nullptr;
  QColor colour_;
  QToolButton* menu_ = nullptr;
  QToolButton* fit_ = nullptr;
  QToolButton* follow_ = nullptr;
  QLabel* pointed_;
  QToolButton* maximise_;
  QLabel* hint_;
  QToolButton* hide_hint_;
  QString hint_words_;
  bool hint_shown_ = true;
  bool maximised_ = false;
  ForcePanel* card_ = nullptr;
  IsIn taken_, disliked_;
  bool card_folded_ = false;
  std::size_t corner_ = 0;  ///< of the card
  QList<QRect> sentences_;
  std::vector<QRectF> covered_, written_;
};

}  // namespace ui
