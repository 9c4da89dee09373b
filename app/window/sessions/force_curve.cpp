// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/sessions/force_curve.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <system_error>
#include <utility>

#include "app/recording/recording.h"

namespace app {

namespace fs = std::filesystem;

haptics::Expected<ForceCurve> forceCurveOf(const fs::path& path, std::size_t intervals,
                                           std::size_t most_blocks,
                                           const background::Watch& watch) {
  auto recording = Recording::open(path);
  if (!recording) return tl::unexpected(recording.error());
  constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
  ForceCurve curve{std::vector<float>(intervals, kNone), std::vector<float>(intervals, kNone)};
  const double begin = recording->begin();
  const double span = std::max(1e-9, recording->end() - begin);
  const std::size_t count = recording->blockCount();
  const std::size_t taken = most_blocks == 0 ? count : std::min(count, most_blocks);
  for (std::size_t n = 0; n < taken && !watch.cancelled(); ++n) {
    const auto steps = recording->block(n * count / taken);
    if (!steps) return tl::unexpected(steps.error());
    for (const RecordedStep& step : *steps) {
      const double place =
          (static_cast<double>(step.step.time_ns) * 1e-9 - begin) / span * double(intervals);
      const auto at = std::min(intervals - 1, static_cast<std::size_t>(std::max(0.0, place)));
      const auto force = static_cast<float>(step.step.sent_W.force.norm());
      curve.least[at] = std::fmin(curve.least[at], force);
      curve.most[at] = std::fmax(curve.most[at], force);
    }
  }
  return curve;
}

void ForceCurves::want(const fs::path& folder, const QList<QString>& ids) {
  folder_ = folder;
  wanted_ = ids;
  for (auto at = known_.begin(); at != known_.end();)
    at = ids.contains(at->first) ? std::next(at) : known_.erase(at);
  if (!reader_.isRunning()) readNext();
}

QList<float> ForceCurves::of(const QString& id) const {
  const auto found = known_.find(id);
  return found == known_.end() ? QList<float>{} : found->second.most;
}

void ForceCurves::readNext() {
  while (!wanted_.isEmpty()) {
    const QString id = wanted_.takeFirst();
    const fs::path path = folder_ / id.toStdString();
    std::error_code error;
    const auto changed = fs::last_write_time(path, error);
    const auto found = known_.find(id);
    if (error || (found != known_.end() && found->second.changed == changed)) continue;
    reader_.start(
        [path](const background::Watch& watch) {
          background::goLast();
          return forceCurveOf(path, kIntervals, kMostBlocks, watch);
        },
        [this, id, changed](haptics::Expected<ForceCurve> curve) {
          Known& known = known_[id];
          known = {changed,
                   curve ? QList<float>(curve->most.begin(), curve->most.end()) : QList<float>{}};
          emit read(id, known.most);
          readNext();
        });
    return;
  }
}

}  // namespace app
