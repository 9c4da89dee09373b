// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QDialog>
#include <QList>
#include <QString>

class QTableWidget;

namespace ui {

/// A moment of a recording.
struct ReportMoment {
  double time = 0.0;  ///< s
  QString what = {};
};

/// Lists the moments of a report. A click or Enter goes to one. It is not modal: the replay and the
/// stop button go on.
class ReportMoments : public QDialog {
  Q_OBJECT
 public:
  ReportMoments(const QString& recording, const QList<ReportMoment>& moments,
                QWidget* parent = nullptr);

 signals:
  void momentWanted(double time);

 private:
  void go(int row);

  QList<ReportMoment> moments_;
  QTableWidget* list_;
};

}  // namespace ui
