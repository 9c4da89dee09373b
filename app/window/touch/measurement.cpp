// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/touch/measurement.h"

#include <utility>

#include "app/window/scan/sentence.h"

namespace app {

Measurement::Measurement(QObject* parent)
    : QObject(parent), task_([this](double fraction) {
        if (under_way_ && !next_) emit progressed(fraction);
      }) {}

void Measurement::start(measurement::CapacityRequest request) {
  cancel();
  under_way_ = true;
  // beside one that still runs its times would mean nothing
  if (task_.isRunning())
    next_ = std::move(request);
  else
    begin(std::move(request));
}

void Measurement::begin(measurement::CapacityRequest request) {
  task_.start(
      [request = std::move(request)](const background::Watch& watch) {
        return measurement::measureCapacity(request, watch.stop,
                                            [&](double fraction) { watch.advanced(fraction); });
      },
      [this](const haptics::Expected<measurement::Capacity>& result) { end(result); });
}

bool Measurement::cancel() {
  if (!std::exchange(under_way_, false)) return false;
  next_.reset();
  task_.cancel();
  return true;
}

void Measurement::end(const haptics::Expected<measurement::Capacity>& result) {
  if (next_) return begin(*std::exchange(next_, std::nullopt));
  if (!std::exchange(under_way_, false)) return;
  if (result) return emit measured(*result);
  const haptics::Error& error = result.error();
  if (error.reason == background::kNoMemory)
    emit failed(
        tr("There is not enough memory for tools of so many points; close other programs."));
  else if (error.reason == background::kThrew)
    emit failed(tr("It could not be measured: %1").arg(sentenceOf(error)));
  else
    emit failed(sentenceOf(error));
}

}  // namespace app
