// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <QString>
#include <optional>

#include "app/background/task.h"
#include "app/study/here/here.h"

namespace app {

/// Measures what this machine carries, on a thread of its own. Signals arrive on the thread that
/// owns it, and only for the measurement that was started last and not cancelled. No call waits
/// for the thread, which looks up every few milliseconds, save while a tool of very many points is
/// made: one that is started meanwhile begins when the cancelled one has ended. The destructor
/// waits.
class Measurement : public QObject {
  Q_OBJECT
 public:
  explicit Measurement(QObject* parent = nullptr);

  /// In place of what is under way.
  void start(study::HereRequest request);
  /// Nothing more is heard of it. False if there was none under way.
  bool cancel();

 signals:
  void progressed(double fraction);
  void measured(const study::Here& here);
  /// A sentence for the user.
  void failed(const QString& why);

 private:
  void begin(study::HereRequest request);
  void end(const haptics::Expected<study::Here>& result);

  bool under_way_ = false;                  ///< and not cancelled
  std::optional<study::HereRequest> next_;  ///< begins when the one that was cancelled has ended
  background::Task<study::Here> task_;
};

}  // namespace app
