// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/replay.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "app/window/force_curve.h"
#include "app/window/sentence.h"
#include "haptics/core/output_file.h"

namespace app {
namespace {

constexpr int kFrameMs = 16;
constexpr std::size_t kBins = 2000;  // of the force's curve: more than a screen has pixels

double timeOf(const haptics::RecordedStep& step) {
  return static_cast<double>(step.step.time_ns) * 1e-9;
}

}  // namespace

haptics::Expected<std::unique_ptr<Replay::Beginning>> Replay::read(
    const std::filesystem::path& path, const std::atomic<bool>& cancel) {
  haptics::keepInput(path);
  auto recording = haptics::Recording::open(path, &cancel);
  if (!recording) return tl::unexpected(recording.error());
  auto first = recording->block(0);
  if (!first) return tl::unexpected(first.error());
  return std::make_unique<Beginning>(Beginning{std::move(*recording), std::move(*first)});
}

Replay::Replay(Beginning beginning, std::filesystem::path path)
    : recording_{std::move(beginning.recording)},
      path_{std::move(path)},
      steps_{std::move(beginning.steps)} {
  track_.begin = time_ = recording_.begin();
  track_.end = recording_.end();
  for (const haptics::RecordedEvent& event : recording_.events())
    if (event.kind != "camera")
      track_.marks.append({.time = static_cast<double>(event.time_ns) * 1e-9,
                           .kind = QString::fromStdString(event.kind),
                           .value = event.value,
                           .note = QString::fromStdString(event.text)});
  timer_.setInterval(kFrameMs);
  timer_.setTimerType(Qt::PreciseTimer);
  connect(&timer_, &QTimer::timeout, this, &Replay::advance);
  reader_.start([path = path_](
                    const background::Watch& watch) { return forceCurveOf(path, kBins, 0, watch); },
                [this](haptics::Expected<ForceCurve> curve) {
                  if (!curve) return;  // then there is no curve
                  track_.force_least = std::move(curve->least);
                  track_.force_most = std::move(curve->most);
                  emit trackRead();
                });
}

bool Replay::load(std::size_t block) {
  if (block == block_) return true;
  auto steps = recording_.block(block);
  if (!steps) {
    play(false);
    emit failed(sentenceOf(steps.error()));
    return false;
  }
  block_ = block;
  steps_ = std::move(*steps);
  at_ = 0;
  return true;
}

void Replay::play(bool play) {
  if (play == timer_.isActive()) return;
  if (play && time_ >= track_.end) seek(track_.begin);
  since_.start();
  if (play)
    timer_.start();
  else
    timer_.stop();
  emit playing(play);
}

void Replay::setSpeed(double factor) { speed_ = factor; }

void Replay::advance() {
  const double passed = static_cast<double>(since_.restart()) * 1e-3;
  const double time = time_ + passed * speed_;
  seek(std::min(time, track_.end));
  if (time >= track_.end) play(false);
}

void Replay::seek(double time) {
  time_ = std::clamp(time, track_.begin, track_.end);
  if (!load(recording_.blockAt(time_))) return;
  const auto after = std::upper_bound(
      steps_.begin(), steps_.end(), time_,
      [](double t, const haptics::RecordedStep& step) { return t < timeOf(step); });
  at_ = after == steps_.begin() ? 0 : static_cast<std::size_t>(after - steps_.begin()) - 1;
  emit moved(time_);
}

void Replay::stepBy(int ticks) {
  play(false);
  for (; ticks > 0; --ticks) {
    if (at_ + 1 < steps_.size())
      ++at_;
    else if (block_ + 1 == recording_.blockCount() || !load(block_ + 1))
      break;
  }
  for (; ticks < 0; ++ticks) {
    if (at_ > 0) {
      --at_;
    } else {
      if (block_ == 0 || !load(block_ - 1)) break;
      at_ = steps_.size() - 1;
    }
  }
  time_ = timeOf(step());
  emit moved(time_);
}

std::vector<haptics::ForceSample> Replay::forces(double from, double to) {
  std::vector<haptics::ForceSample> points;
  // a part that cannot be read is told of where one goes to it
  (void)recording_.forEach(
      std::max(from, to - ui::ForcePlot::kSeconds), to, [&](const haptics::RecordedStep& step) {
        if (timeOf(step) > from)
          points.push_back({timeOf(step), static_cast<float>(step.step.sent_W.force.norm()),
                            static_cast<float>(step.step.sent_W.torque.norm())});
        return true;
      });
  return points;
}

}  // namespace app
