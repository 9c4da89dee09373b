// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/structures/near_sound.h"

#include <QDataStream>
#include <QFile>
#include <QStringList>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/window/sound/sound_program.h"

namespace app {
namespace {

constexpr int kRate = 22'050;                   // samples/s
constexpr double kLength = 0.06;                // s of a beep
constexpr double kLow = 660, kHigh = 990;       // Hz
constexpr int kLongest = 900, kShortest = 150;  // ms between two beeps

/// The programs that play a file, each with the words before its name.
const QStringList* playing() {
  static const QList<QStringList> known{{"pw-play"}, {"paplay"}, {"aplay", "-q"}};
  return firstThere(known);
}

/// A tone that swells and fades, as a WAV file of 16 bits and one channel.
void writeTone(const QString& path, double frequency) {
  QFile file(path);
  if (!file.open(QIODevice::WriteOnly)) return;
  const int count = static_cast<int>(kLength * kRate);
  QDataStream out(&file);
  out.setByteOrder(QDataStream::LittleEndian);
  out.writeRawData("RIFF", 4);
  out << quint32(36 + 2 * count);
  out.writeRawData("WAVEfmt ", 8);
  out << quint32{16} << quint16{1} << quint16{1} << quint32{kRate} << quint32{2 * kRate}
      << quint16{2} << quint16{16};
  out.writeRawData("data", 4);
  out << quint32(2 * count);
  for (int n = 0; n < count; ++n) {
    const double swell = std::sin(std::numbers::pi * n / count);
    out << qint16(
        std::lround(9'000.0 * swell * std::sin(2.0 * std::numbers::pi * frequency * n / kRate)));
  }
}

}  // namespace

NearSound::NearSound() {
  next_.setSingleShot(true);
  player_.setStandardOutputFile(QProcess::nullDevice());
  player_.setStandardErrorFile(QProcess::nullDevice());
  connect(&next_, &QTimer::timeout, this, &NearSound::beep);
}

NearSound::~NearSound() {
  player_.kill();
  player_.waitForFinished(500);
}

bool NearSound::isPossible() { return playing() != nullptr; }

std::optional<int> NearSound::pauseAt(double distance_mm, const ui::NearLimits& limits) {
  if (distance_mm > limits.near_mm) return {};
  const double part = limits.near_mm > limits.close_mm
                          ? (distance_mm - limits.close_mm) / (limits.near_mm - limits.close_mm)
                          : 0.0;
  return kShortest + int(std::lround((kLongest - kShortest) * std::clamp(part, 0.0, 1.0)));
}

void NearSound::setOn(bool on) {
  on_ = on;
  if (!on) return next_.stop();
  if (!QFile::exists(sounds_.filePath("near.wav"))) {
    writeTone(sounds_.filePath("near.wav"), kLow);
    writeTone(sounds_.filePath("close.wav"), kHigh);
  }
  if (pause_) beep();
}

void NearSound::show(const std::vector<ui::StructureNear>& near, const ui::NearLimits& limits) {
  double nearest_mm = HUGE_VAL;
  for (const ui::StructureNear& one : near)
    if (!one.is_farther) nearest_mm = std::min(nearest_mm, one.distance_mm);
  pause_ = pauseAt(nearest_mm, limits);
  close_ = nearest_mm <= limits.close_mm;
  if (!on_) return;
  if (!pause_)
    next_.stop();
  else if (!next_.isActive())
    beep();
  else if (next_.remainingTime() > *pause_)
    next_.start(*pause_);
}

void NearSound::beep() {
  if (!on_ || !pause_) return;
  next_.start(*pause_);
  const QStringList* words = playing();
  if (words == nullptr || player_.state() != QProcess::NotRunning) return;
  player_.start(words->front(), words->mid(1)
                                    << sounds_.filePath(close_ ? "close.wav" : "near.wav"));
}

}  // namespace app
