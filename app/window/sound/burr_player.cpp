// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/sound/burr_player.h"

#include <QStringList>
#include <algorithm>
#include <chrono>

#include "app/window/sound/sound_program.h"

namespace app {
namespace {

using namespace std::chrono_literals;

constexpr int kEveryMs = 10;
constexpr int kToldMs = 250;
constexpr int kLead = 3'840;    // samples that the program has ahead: 80 ms
constexpr int kTail = 9'600;    // of silence, so that the end does not wait in the program's buffer
constexpr int kAtOnce = 4'800;  // samples; what a late moment has missed is not made up for

/// The programs that play what they read, with a buffer of 50 ms. PipeWire's pw-cat would read in
/// the thread that makes everybody's sound.
const QStringList* streaming() {
  static const QString kRate = QString::number(BurrTone::kRate);
  static const QList<QStringList> known{
      {"paplay", "--raw", "--format=s16ne", "--channels=1", "--rate=" + kRate, "--latency-msec=50",
       "--client-name=Palpate"},
      {"aplay", "-q", "-t", "raw", "-f", "S16", "-c", "1", "-r", kRate, "--buffer-time=50000"}};
  return firstThere(known);
}

}  // namespace

BurrPlayer::BurrPlayer() : program_(this), pumping_(this) {
  program_.setStandardOutputFile(QProcess::nullDevice());
  program_.setStandardErrorFile(QProcess::nullDevice());
  pumping_.setInterval(kEveryMs);
  pumping_.setTimerType(Qt::PreciseTimer);
  connect(&pumping_, &QTimer::timeout, this, &BurrPlayer::pump);
}

BurrPlayer::~BurrPlayer() { end(); }

bool BurrPlayer::isPossible() { return streaming() != nullptr; }

void BurrPlayer::prepare() {
  const QStringList* words = streaming();
  if (words == nullptr || program_.state() != QProcess::NotRunning) return;
  tone_ = {};
  program_.start(words->front(), words->mid(1));
}

void BurrPlayer::end() {
  pumping_.stop();
  program_.kill();
  program_.waitForFinished(500);
}

void BurrPlayer::show(const BurrRun& run) {
  const bool begins = run.turns && !run_.turns;
  run_ = run;
  told_.start();
  if (!run.turns) return;
  after_ = 0;
  if (begins) prepare();  // again, if it was gone
  if (pumping_.isActive()) return;
  due_ = 0;
  clock_.start();
  pumping_.start();
  pump();
}

void BurrPlayer::pump() {
  if (told_.hasExpired(kToldMs)) run_.turns = false;
  const std::int64_t due = clock_.elapsed() * BurrTone::kRate / 1'000 + kLead;
  const int count = static_cast<int>(std::min<std::int64_t>(due - due_, kAtOnce));
  due_ = due;
  feed(count);
  if (run_.turns) return;
  after_ += count;
  if (after_ >= BurrTone::kFade + kTail) pumping_.stop();
}

void BurrPlayer::feed(int count) {
  if (program_.state() == QProcess::NotRunning) return;
  const int room = std::min(count, kMostUnread - unread());
  if (room <= 0) return;
  samples_.resize(static_cast<std::size_t>(room));
  tone_.fill(samples_, run_);
  program_.write(reinterpret_cast<const char*>(samples_.data()), qint64{kBytes} * room);
}

}  // namespace app
