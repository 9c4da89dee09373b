// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QList>
#include <QWidget>

#include "ui/panels/performance_words.h"

class QLabel;
class QProgressBar;
class QPushButton;

namespace ui {

/// An omission in the plan of the present scene, and its reason.
struct LeftOut {
  QString what;
  QString why;
};

/// Shows how many points this machine carries, as text and as a diagram, after a measurement that a
/// button starts. Also shows what the present scene leaves out.
class PerformancePanel : public QWidget {
  Q_OBJECT
 public:
  explicit PerformancePanel(QWidget* parent = nullptr);

  /// Whether there is a scene to measure.
  void setReady(bool ready);
  /// A measurement has begun; the button now cancels it.
  void showMeasuring();
  void showProgress(double fraction);
  /// The measurement has ended with a result.
  void show(const Performance& performance);
  using QWidget::show;
  /// The measurement has ended without a result; `why` is the reason, a sentence.
  void showNothing(const QString& why);
  /// Shows the omissions of the present scene. An empty list is not mentioned.
  void showLeftOut(const QList<LeftOut>& left_out);

  bool isMeasuring() const { return measuring_; }

 signals:
  void measureWanted();
  void cancelWanted();

 private:
  void end();

  QPushButton* measure_;
  QProgressBar* progress_;
  QLabel* headline_;
  QLabel* details_;
  LoadPlot* plot_;
  QLabel* suggestion_;
  QLabel* left_out_title_;
  QLabel* left_out_;
  bool ready_ = false;
  bool measuring_ = false;
};

}  // namespace ui
