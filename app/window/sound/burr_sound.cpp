// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/sound/burr_sound.h"

#include <utility>

namespace app {

BurrSound::~BurrSound() {
  thread_.quit();
  thread_.wait();
}

void BurrSound::setOn(bool on) {
  on_ = on;
  turned_ = false;
  if (player_ == nullptr) {
    player_ = new BurrPlayer;
    player_->moveToThread(&thread_);
    QObject::connect(&thread_, &QThread::finished, player_, &QObject::deleteLater);
    thread_.start();
  }
  QMetaObject::invokeMethod(player_, on ? &BurrPlayer::prepare : &BurrPlayer::end);
}

void BurrSound::show(const BurrRun& run) {
  if (!on_ || !(std::exchange(turned_, run.turns) || run.turns)) return;
  QMetaObject::invokeMethod(player_, [player = player_, run] { player->show(run); });
}

}  // namespace app
