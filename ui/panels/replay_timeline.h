// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QList>
#include <QPixmap>
#include <QWidget>
#include <optional>
#include <vector>

namespace ui {

/// Something that happened in a recorded session.
struct ReplayMark {
  double time = 0.0;  ///< s, as the track's
  QString kind;       ///< as the recording has it: "mark", "isovalue", "gap", …
  std::optional<double> value = {};
  QString note = {};
};

/// A recorded session, as the timeline shows it. Times are the recording's own, s.
struct ReplayTrack {
  double begin = 0.0, end = 0.0;
  QList<ReplayMark> marks = {};
  /// Norm of the force, N: least and greatest in each of so many equal parts of the time; what is
  /// not finite is left out.
  std::vector<float> force_least = {}, force_most = {};
};

/// The whole recording from left to right: the force as a curve, events as symbols that differ in
/// colour and shape, the present time as a line. A click or drag asks for another time; while the
/// mouse is down the line follows it. Left and Right ask for one tick less or more, Home and End
/// for the ends, Space for play or pause.
class ReplayTimeline : public QWidget {
  Q_OBJECT
 public:
  explicit ReplayTimeline(QWidget* parent = nullptr);

  void show(ReplayTrack track);
  using QWidget::show;
  void setTime(double time);

  const ReplayTrack& track() const { return track_; }
  /// Where a time is drawn, in pixels from the left; what is outside the track, at its end.
  double xOf(double time) const;
  double timeAt(double x) const;
  /// The texts of the events at `x`: a line each, plain text; empty if there is none.
  QString wordsAt(double x) const;

  QSize sizeHint() const override { return {600, 68}; }
  QSize minimumSizeHint() const override { return {200, 60}; }

 signals:
  void timeWanted(double time);
  void stepWanted(int ticks);
  void playToggled();

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void wish(double x);
  void drawGround();
  void drawForce(QPainter& painter) const;
  void drawMarks(QPainter& painter) const;

  ReplayTrack track_;
  double time_ = 0.0;
  std::optional<double> held_;  ///< where the mouse holds the line, s
  QPixmap ground_;              ///< everything but the line; null: to be drawn
};

}  // namespace ui
