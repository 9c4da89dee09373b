// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QList>
#include <QPixmap>
#include <QWidget>
#include <optional>
#include <vector>

#include "ui/controls/spoken.h"

namespace ui {

/// An event of a recorded session.
struct ReplayMark {
  double time = 0.0;  ///< s, on the track's time axis
  QString kind;       ///< as in the recording: "mark", "isovalue", "gap", …
  std::optional<double> value = {};
  QString note = {};
};

/// A recorded session, as the timeline shows it. Times are the recording's own, s.
struct ReplayTrack {
  double begin = 0.0, end = 0.0;
  QList<ReplayMark> marks = {};
  /// Norm of the force, N: least and greatest in equal intervals of the time. Values that are not
  /// finite are left out.
  std::vector<float> force_least = {}, force_most = {};
};

/// The whole recording from left to right: the force as a curve over axes of newtons and of time,
/// events as symbols that differ in colour and shape, late ticks as short dim lines at the foot,
/// the present time as a line. A click or drag requests another time; while the mouse button is
/// down the line follows the mouse. Its keys are in ui/controls/bindings.h.
class ReplayTimeline : public QWidget, public Spoken {
  Q_OBJECT
 public:
  explicit ReplayTimeline(QWidget* parent = nullptr);

  void show(ReplayTrack track);
  using QWidget::show;
  void setTime(double time);

  const ReplayTrack& track() const { return track_; }
  /// Position of a time in pixels from the left. A time outside the track has the position of the
  /// nearer end.
  double xOf(double time) const;
  double timeAt(double x) const;
  /// The texts of the events at `x`: a line each, plain text; empty if there is none.
  QString wordsAt(double x) const;

  QSize sizeHint() const override { return {600, 88}; }
  QSize minimumSizeHint() const override { return {240, 80}; }

  QAccessible::Role spokenRole() const override { return QAccessible::Slider; }
  QString spokenName() const override;
  QString spokenValue() const override;
  std::optional<SpokenNumber> spokenNumber() const override;
  void takeSpoken(double time) override { emit timeWanted(time); }

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
  /// Where the curve is drawn, px.
  QRectF curveArea() const;
  void drawForce(QPainter& painter) const;
  void drawTimes(QPainter& painter) const;
  void drawLate(QPainter& painter) const;
  void drawMarks(QPainter& painter) const;

  ReplayTrack track_;
  double time_ = 0.0;
  std::optional<double> held_;  ///< s, time at which the mouse holds the line
  QPixmap ground_;              ///< the picture without the line; null: must be drawn
};

}  // namespace ui
