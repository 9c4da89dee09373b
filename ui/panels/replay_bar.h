// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QFrame>

#include "ui/panels/replay_timeline.h"

class QComboBox;
class QLabel;
class QToolButton;

namespace ui {

class WarningLabel;

/// The controls of a replay: timeline, play and pause, single ticks, speed, the list of marks.
/// Space, Left and Right work only while the bar has the focus.
class ReplayBar : public QFrame {
  Q_OBJECT
 public:
  explicit ReplayBar(QWidget* parent = nullptr);

  /// Shows another recording, at its beginning, paused and without a warning.
  void show(ReplayTrack track);
  using QWidget::show;
  /// Sets the time that the views show, in s of the recording.
  void setTime(double time);
  void setPlaying(bool playing);
  /// A sentence on what differs from the recorded session, or empty.
  void showWarning(const QString& sentence);

  ReplayTimeline& timeline() { return *timeline_; }
  double speed() const;  ///< chosen speed; 1 at first

 signals:
  void playWanted(bool play);
  void timeWanted(double time);
  void stepWanted(int ticks);
  void speedChosen(double factor);
  void closeWanted();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void listMarks();
  QToolButton* button(const char* name, const QString& text, const QString& tip);

  WarningLabel* warning_;
  ReplayTimeline* timeline_;
  QToolButton* play_;
  QComboBox* speeds_;
  QComboBox* marks_;  ///< its data are the times, s
  QLabel* time_;
  bool playing_ = false;
};

}  // namespace ui
