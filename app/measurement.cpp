// SPDX-License-Identifier: BSD-3-Clause
#include "app/measurement.h"

#include <exception>
#include <new>
#include <utility>

namespace app {
namespace {

constexpr double kMeasuringStep = 0.005;  // of the whole, between two signals of progress

}  // namespace

Measurement::Measurement(QObject* parent) : QObject(parent) {}

void Measurement::start(study::HereRequest request) {
  cancel();
  ++number_;
  under_way_ = true;
  if (running_)
    next_ = std::move(request);
  else
    begin(std::move(request));
}

void Measurement::begin(study::HereRequest request) {
  running_ = true;
  // the one before has told its end as its last act: assigning does not wait for it
  thread_ = std::jthread(
      [this, number = number_, request = std::move(request)](const std::stop_token& stop) {
        work(number, request, stop);
        QMetaObject::invokeMethod(this, &Measurement::ended, Qt::QueuedConnection);
      });
}

void Measurement::ended() {
  running_ = false;
  if (next_) begin(*std::exchange(next_, std::nullopt));
}

bool Measurement::cancel() {
  if (!std::exchange(under_way_, false)) return false;
  ++number_;
  next_.reset();
  thread_.request_stop();
  return true;
}

template <class Action>
void Measurement::onThisThread(std::uint64_t number, Action&& action) {
  QMetaObject::invokeMethod(
      this,
      [this, number, action = std::forward<Action>(action)] {
        if (number == number_) action();
      },
      Qt::QueuedConnection);
}

void Measurement::work(std::uint64_t number, const study::HereRequest& request,
                       std::stop_token stop) {
  double told = 0.0;
  const auto advanced = [&](double fraction) {
    if (fraction < told + kMeasuringStep) return;
    told = fraction;
    onThisThread(number, [this, fraction] { emit progressed(fraction); });
  };
  QString why;
  try {
    const auto here = study::measureHere(request, std::move(stop), advanced);
    if (here)
      return onThisThread(number, [this, result = *here] {
        under_way_ = false;
        emit measured(result);
      });
    why = QString::fromStdString(here.error().what);
  } catch (const std::bad_alloc&) {
    why = tr("There is not enough memory for tools of so many points; close other programs.");
  } catch (const std::exception& thrown) {
    why = tr("It could not be measured: %1").arg(QString(thrown.what()));
  }
  onThisThread(number, [this, why] {
    under_way_ = false;
    emit failed(why);
  });
}

}  // namespace app
