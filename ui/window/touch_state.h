// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <QString>
#include <QTimer>
#include <optional>
#include <vector>

#include "haptics/snapshot.h"
#include "ui/panels/force_words.h"
#include "ui/panels/nearness_lines.h"

class QPushButton;

namespace ui {

class Banner;
class StatusLine;
class TopBar;

/// The state of the touch in words: the force on the bar, what the user can do about it above the
/// views, figures in the status bar. GUI thread.
class TouchState : public QObject {
  Q_OBJECT
 public:
  /// `stopped`: the bar above the views, hidden until there is something to do.
  TouchState(TopBar& bar, Banner& stopped, StatusLine& status);

  /// At display rate; texts are updated ten times a second (worded()).
  void display(const haptics::Snapshot& snapshot);
  /// The hand that holds the tool, and what comes of the force.
  void setHand(const QString& label, Feel feel);
  /// The tool is near these structures; none: none is watched.
  void showNear(const std::vector<StructureNear>& near, const NearLimits& limits);
  /// Whether there are motors that may push the hand.
  bool hasMotors() const { return feel_ == Feel::Felt; }
  /// Takes the force away. `by`: a sentence on who did.
  void stop(const QString& by);

 signals:
  /// The state is due in words, at most ten times a second.
  void worded(const haptics::Snapshot& snapshot);
  /// Device, and the rate of its loop once it is known.
  void handNamed(const QString& words);
  void forceOffWanted();
  void forceOnWanted();

 private:
  void displayWords();
  void sayForce(const haptics::Snapshot& snapshot);
  void showDetail(const haptics::Snapshot& snapshot);
  void detail(const QString& words);

  TopBar& bar_;
  Banner& stopped_;
  StatusLine& status_;
  QPushButton* resume_;
  Feel feel_ = Feel::Shown;
  QString hand_;
  bool is_force_ = false;  ///< of the last snapshot
  QString stopped_by_;     ///< sentence on who stopped the force; empty: nobody since it was armed
  std::optional<haptics::Snapshot> unsaid_;  ///< snapshot that arrived while words_ ran
  QTimer words_;                             ///< runs after the texts changed
};

}  // namespace ui
