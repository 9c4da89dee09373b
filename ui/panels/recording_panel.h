// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QDateTime>
#include <QElapsedTimer>
#include <QList>
#include <QTimer>
#include <QWidget>
#include <optional>

class QAction;
class QCheckBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QTableWidget;

namespace ui {

class WarningLabel;

/// The progress of the recording of the present session.
struct RecordingStatus {
  enum class State {
    Off,
    Recording,
    Finishing,  ///< the last steps are being written
    Stopped     ///< ended without the user: `failure` gives the reason
  };
  State state = State::Off;
  double elapsed = 0.0;  ///< s since the recording began
  qint64 samples = 0;    ///< samples in the file
  qint64 gaps = 0;       ///< lost samples; above 0 the recording is not complete
  qint64 bytes = 0;
  std::optional<double> room = {};  ///< s of recording for which the disk has room
  QString failure = {};             ///< a sentence
};

/// An earlier recording.
struct PastRecording {
  QString id;
  QString name;
  double duration = 0.0;  ///< s; unknown for an unfinished one
  QString tool = {};
  qint64 bytes = 0;
  bool finished = true;
  QString label = {};       ///< the user's own words, kept on this computer only
  QDateTime changed = {};   ///< last change of the file; a recording itself holds no date
  QList<float> curve = {};  ///< greatest force [N] in equal intervals; empty: not known yet
  QString scan = {};        ///< of which scan; empty: not known. A recording itself holds no name
};

/// What a recording states only where its user wants it to.
struct RecordingStates {
  bool when = false;  ///< date and time of its begin
  bool scan = false;  ///< an open hash of the scan's voxels
};

/// Records the session and sets marks in it, and lists earlier recordings, each with a label that
/// the user may give it, its date, duration, tool and a small curve of the force. A mark is set
/// with the button, with Enter in its note, or with markAction(); all are disabled while nothing is
/// recorded.
class RecordingPanel : public QWidget {
  Q_OBJECT
 public:
  explicit RecordingPanel(QWidget* parent = nullptr);

  /// Whether there is a session to record.
  void setReady(bool ready);
  void show(const RecordingStatus& status);
  /// Shows the list in this order. The selection is kept.
  void show(const QList<PastRecording>& recordings);
  using QWidget::show;
  /// Shows the curve of a recording of the list.
  void showCurve(const QString& id, const QList<float>& curve);

  /// Sets a mark. Its key is M, in the window to which the action is added. Enabled during a
  /// recording.
  QAction* markAction() { return mark_action_; }
  /// Chooses a recording of the list.
  void choose(const QString& id);
  /// What the next recording states; nothing until the user switches it on.
  RecordingStates states() const;
  /// Asks for an export of the chosen recording; false: none is chosen that can be exported.
  bool exportChosen();

 signals:
  void recordWanted(bool record);
  /// Asks for a mark at the present time; the note may be empty.
  void markWanted(const QString& note);
  void openWanted(const QString& id);
  void exportWanted(const QString& id);
  void reportWanted(const QString& id);
  /// Emitted after the user agreed to delete.
  void deleteWanted(const QString& id);
  void recoverWanted(const QString& id);
  /// The user gave the recording another label; empty: none.
  void labelChanged(const QString& id, const QString& label);
  /// The panel came into view.
  void seen();

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  QWidget* buildFigures();
  QWidget* buildList();
  void mark();
  void showState();
  void showSelected();
  const PastRecording* selected() const;
  void openSelected();
  void askToDelete();
  void fillRow(int row);
  void takeLabel();

  QPushButton* record_;
  QCheckBox* when_;
  QCheckBox* scan_;
  QLabel* elapsed_;
  WarningLabel* state_;
  QLabel* samples_;
  WarningLabel* gaps_;
  QLabel* bytes_;
  WarningLabel* room_;
  WarningLabel* lost_;
  QLineEdit* note_;
  QPushButton* mark_;
  QLabel* marked_;
  QAction* mark_action_;
  QTableWidget* list_;
  QLineEdit* label_;
  QPushButton* open_;
  QPushButton* export_;
  QPushButton* report_;
  QPushButton* delete_;
  QTimer confirmation_{this};  ///< the last mark is shown while this timer runs
  RecordingStatus status_;
  QElapsedTimer since_status_;  ///< since it came
  QList<PastRecording> recordings_;
  QString labelled_;  ///< id of the recording whose label is in the field
  bool ready_ = false;
};

}  // namespace ui
