// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/sessions/replay.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "app/window/scan/sentence.h"
#include "app/window/sessions/force_curve.h"
#include "haptics/process/output_file.h"

namespace app {
namespace {

constexpr int kFrameMs = 16;
constexpr std::size_t kBins = 2000;  // of the force's curve: more than a screen has pixels

constexpr double kAhead = 2.0;            // s: what is read beforehand
constexpr std::size_t kMostBlocks = 256;  // kept; a recording has some ten a second

double timeOf(const RecordedStep& step) { return static_cast<double>(step.step.time_ns) * 1e-9; }

haptics::Expected<Replay::Part> partOf(Recording& recording, std::size_t block, bool with_steps) {
  auto steps = recording.block(block);
  if (!steps) return tl::unexpected(steps.error());
  Replay::Part part;
  for (const RecordedStep& step : *steps)
    part.forces.push_back({timeOf(step), static_cast<float>(step.step.sent_W.force.norm()),
                           static_cast<float>(step.step.sent_W.torque.norm())});
  if (with_steps) part.steps = std::move(*steps);
  return part;
}

}  // namespace

haptics::Expected<std::unique_ptr<Replay::Beginning>> Replay::read(
    const std::filesystem::path& path, const std::atomic<bool>& cancel) {
  haptics::keepInput(path);
  auto recording = Recording::open(path, &cancel);
  if (!recording) return tl::unexpected(recording.error());
  auto first = partOf(*recording, 0, true);
  if (!first) return tl::unexpected(first.error());
  Parts parts;
  parts.emplace(0, std::move(first));
  return std::make_unique<Beginning>(Beginning{std::move(*recording), std::move(parts)});
}

Replay::Replay(Beginning beginning, std::filesystem::path path)
    : recording_{std::move(beginning.recording)},
      path_{std::move(path)},
      parts_{std::move(beginning.parts)} {
  track_.begin = time_ = recording_.begin();
  track_.end = recording_.end();
  for (const RecordedEvent& event : recording_.events())
    if (event.kind != "camera")
      track_.marks.append({.time = static_cast<double>(event.time_ns) * 1e-9,
                           .kind = QString::fromStdString(event.kind),
                           .value = event.value,
                           .note = QString::fromStdString(event.text)});
  timer_.setInterval(kFrameMs);
  timer_.setTimerType(Qt::PreciseTimer);
  connect(&timer_, &QTimer::timeout, this, &Replay::advance);
  curve_reader_.start(
      [path = path_](const background::Watch& watch) {
        return forceCurveOf(path, kBins, 0, watch);
      },
      [this](haptics::Expected<ForceCurve> curve) {
        if (!curve) return;  // then there is no curve
        track_.force_least = std::move(curve->least);
        track_.force_most = std::move(curve->most);
        emit trackRead();
      });
}

const RecordedStep& Replay::step() const { return parts_.at(present_.block)->steps[present_.step]; }

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
  if (wish_) return;  // its steps are being read
  const double time = time_ + passed * speed_;
  seek(time);
  if (time >= track_.end) play(false);
}

void Replay::seek(double time) {
  time = std::clamp(time, track_.begin, track_.end);
  goTo({.block = recording_.blockAt(time), .step = {}, .time = time});
}

void Replay::stepBy(int ticks) {
  play(false);
  Place to = present_;
  if (wish_ && wish_->step) to = {wish_->block, *wish_->step};
  for (; ticks > 0; --ticks) {
    if (to.step + 1 < recording_.stepsIn(to.block))
      ++to.step;
    else if (to.block + 1 < recording_.blockCount())
      to = {to.block + 1, 0};
  }
  for (; ticks < 0; ++ticks) {
    if (to.step > 0)
      --to.step;
    else if (to.block > 0)
      to = {to.block - 1, recording_.stepsIn(to.block - 1) - 1};
  }
  goTo({.block = to.block, .step = to.step});
}

void Replay::goTo(Wish wish) {
  wish_ = wish;
  arrive();
  readAround();
}

void Replay::arrive() {
  if (!wish_) return;
  const auto part = parts_.find(wish_->block);
  if (!isRead(wish_->block, wanted())) return;
  const Wish wish = *std::exchange(wish_, {});
  if (!part->second) {
    play(false);
    const QString why = sentenceOf(part->second.error());
    parts_.erase(part);  // it is tried again where one goes there again
    emit failed(why);
    return;
  }
  const auto& steps = part->second->steps;
  if (wish.step) {
    present_ = {wish.block, *wish.step};
    time_ = timeOf(step());
  } else {
    const auto after =
        std::upper_bound(steps.begin(), steps.end(), wish.time,
                         [](double t, const RecordedStep& step) { return t < timeOf(step); });
    present_ = {wish.block,
                static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, after - steps.begin() - 1))};
    time_ = wish.time;
  }
  emit moved(time_);
}

Replay::Range Replay::wanted() const {
  const std::size_t to = wish_ ? wish_->block : present_.block;
  const double time = wish_ ? recording_.beginOf(to) : time_;
  const std::size_t first = recording_.blockAt(time - ui::ForcePlot::kSeconds);
  const std::size_t last = recording_.blockAt(time + kAhead);
  return {.first = std::max(first, to - std::min(to, kMostBlocks)),
          .steps_from = to - std::min<std::size_t>(to, 1),
          .last = std::clamp(last, to, to + kMostBlocks)};
}

bool Replay::isRead(std::size_t block, const Range& range) const {
  const auto part = parts_.find(block);
  if (part == parts_.end()) return false;
  return !part->second || block < range.steps_from || !part->second->steps.empty();
}

void Replay::readAround() {
  const Range range = wanted();
  if (block_reader_.isRunning()) {
    if (wish_ && (wish_->block < reading_.steps_from || wish_->block > reading_.last))
      block_reader_.cancel();
    return;
  }
  std::vector<std::size_t> missing;
  for (std::size_t block = range.first; block <= range.last; ++block)
    if (!isRead(block, range)) missing.push_back(block);
  if (missing.empty()) return;
  reading_ = range;
  block_reader_.start(
      [this, missing, range](const background::Watch& watch) -> haptics::Expected<Parts> {
        Parts parts;
        for (const std::size_t block : missing) {
          if (watch.cancelled()) break;
          parts.emplace(block, partOf(recording_, block, block >= range.steps_from));
        }
        return parts;
      },
      [this](haptics::Expected<Parts> parts) {
        if (parts) return keep(std::move(*parts));
        play(false);  // no thread or no memory
        wish_.reset();
        emit failed(sentenceOf(parts.error()));
      });
}

void Replay::keep(Parts parts) {
  for (auto& [block, part] : parts) parts_.insert_or_assign(block, std::move(part));
  arrive();
  const Range range = wanted();
  std::erase_if(parts_, [&](const auto& part) {
    return part.first != present_.block && (part.first < range.first || part.first > range.last);
  });
  for (auto& [block, part] : parts_)
    if (part && block != present_.block && block < range.steps_from) part->steps = {};
  readAround();
}

std::vector<haptics::ForceSample> Replay::forces(double from, double to) const {
  std::vector<haptics::ForceSample> points;
  for (const auto& [block, part] : parts_)
    if (part)  // a part that cannot be read is told of where one goes to it
      for (const haptics::ForceSample& point : part->forces)
        if (point.time > std::max(from, to - ui::ForcePlot::kSeconds) && point.time <= to)
          points.push_back(point);
  return points;
}

}  // namespace app
