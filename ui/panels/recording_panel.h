// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QList>
#include <QTimer>
#include <QWidget>
#include <optional>

class QAction;
class QLabel;
class QLineEdit;
class QPushButton;
class QTableWidget;

namespace ui {

/// How the recording of the present session comes along.
struct RecordingStatus {
  enum class State {
    Off,
    Recording,
    Finishing,  ///< the last of it is being written
    Stopped     ///< by itself: `failure` says why
  };
  State state = State::Off;
  double elapsed = 0.0;  ///< s since it began
  qint64 samples = 0;    ///< in the file
  qint64 gaps = 0;       ///< samples that were lost: 0, or the recording is not whole
  qint64 bytes = 0;
  std::optional<double> room = {};  ///< s of recording that the disk has room for
  QString failure = {};             ///< a sentence
};

/// A recording made before.
struct PastRecording {
  QString id;
  QString name;
  double duration = 0.0;  ///< s; of an unfinished one nobody knows
  QString tool = {};
  qint64 bytes = 0;
  bool finished = true;
};

/// Records the session and sets marks in it; lists what was recorded before. A mark is set with
/// the button, with Enter in its note, or with markAction(); all but while it records are refused.
class RecordingPanel : public QWidget {
  Q_OBJECT
 public:
  explicit RecordingPanel(QWidget* parent = nullptr);

  /// Whether there is a session to record.
  void setReady(bool ready);
  void show(const RecordingStatus& status);
  /// The list, in this order; what was selected stays so.
  void show(const QList<PastRecording>& recordings);
  using QWidget::show;

  /// Sets a mark, by the key M in whatever window it is added to; enabled while it records.
  QAction* markAction() { return mark_action_; }

 signals:
  void recordWanted(bool record);
  /// A mark now; the note may be empty.
  void markWanted(const QString& note);
  void openWanted(const QString& id);
  void exportWanted(const QString& id);
  /// The user was asked, and agreed.
  void deleteWanted(const QString& id);
  void recoverWanted(const QString& id);

 private:
  QWidget* buildFigures();
  QWidget* buildList();
  void mark();
  void showState();
  void showSelected();
  const PastRecording* selected() const;
  void openSelected();
  void askToDelete();

  QPushButton* record_;
  QLabel* elapsed_;
  QLabel* state_;
  QLabel* samples_;
  QLabel* gaps_;
  QLabel* bytes_;
  QLabel* room_;
  QLabel* lost_;
  QLineEdit* note_;
  QPushButton* mark_;
  QLabel* marked_;
  QAction* mark_action_;
  QTableWidget* list_;
  QPushButton* open_;
  QPushButton* export_;
  QPushButton* delete_;
  QTimer confirmation_;  ///< while it runs the last mark is shown
  RecordingStatus status_;
  QList<PastRecording> recordings_;
  bool ready_ = false;
};

}  // namespace ui
