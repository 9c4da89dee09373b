// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <QString>
#include <cstdint>
#include <optional>
#include <thread>

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
  void ended();
  void work(std::uint64_t number, const study::HereRequest& request, std::stop_token stop);
  template <class Action>
  void onThisThread(std::uint64_t number, Action&& action);

  std::uint64_t number_ = 0;  ///< of the newest
  bool under_way_ = false;    ///< and not cancelled
  bool running_ = false;      ///< the thread is, for the newest or for one that was cancelled
  std::optional<study::HereRequest> next_;  ///< begins when the thread has ended
  std::jthread thread_;                     ///< last: it ends first
};

}  // namespace app
