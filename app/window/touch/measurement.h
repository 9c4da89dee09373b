// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <QString>
#include <optional>

#include "app/background/task.h"
#include "app/measurement/capacity.h"

namespace app {

/// Measures how many points this machine carries, on its own thread. Signals arrive on the thread
/// that owns it, and only for the newest measurement, unless it was cancelled. Only the destructor
/// waits for the thread. The thread checks for cancellation every few milliseconds, except while it
/// makes a tool with very many points. A measurement that is started meanwhile begins when the
/// cancelled one has ended.
class Measurement : public QObject {
  Q_OBJECT
 public:
  explicit Measurement(QObject* parent = nullptr);

  /// Starts a measurement and cancels the present one.
  void start(measurement::CapacityRequest request);
  /// Cancels the measurement; no signal follows. Returns false if none was running.
  bool cancel();

 signals:
  void progressed(double fraction);
  void measured(const measurement::Capacity& capacity);
  /// A sentence for the user.
  void failed(const QString& why);

 private:
  void begin(measurement::CapacityRequest request);
  void end(const haptics::Expected<measurement::Capacity>& result);

  bool under_way_ = false;  ///< a measurement runs and is not cancelled
  std::optional<measurement::CapacityRequest>
      next_;  ///< begins when the cancelled measurement has ended
  background::Task<measurement::Capacity> task_;
};

}  // namespace app
