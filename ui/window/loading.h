// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QFrame>
#include <QString>

class QLabel;
class QProgressBar;

namespace ui {

class StartPage;

/// What is being loaded or computed, how far it is, and the button to cancel it: in the status bar,
/// or on the start page while that is in view. GUI thread.
class Loading : public QFrame {
  Q_OBJECT
 public:
  explicit Loading(StartPage& start);

  void begin(const QString& what);
  /// 0 to 1.
  void advance(double fraction);
  void end();
  /// Work that goes on behind other work, and is shown whenever nothing else is; empty: it ended.
  void setBehind(const QString& what);
  /// How far that is, 0 to 1.
  void advanceBehind(double fraction);

 signals:
  void cancelWanted();

 private:
  StartPage& start_;
  QString behind_;
  QLabel* what_;
  QProgressBar* progress_;
};

}  // namespace ui
