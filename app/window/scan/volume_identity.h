// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <list>
#include <memory>
#include <optional>

#include "app/background/task.h"
#include "app/recording/scene_words.h"

namespace app {

/// Hashes volumes on its own thread, each volume once while it is in use; of an edited volume the
/// scan. Only the destructor waits.
class VolumeIdentity : public QObject {
  Q_OBJECT
 public:
  explicit VolumeIdentity(QObject* parent = nullptr) : QObject(parent) {}

  /// Starts hashing. sought() follows later, without new work if the hash is known.
  void seek(const std::shared_ptr<const haptics::Volume>& sought_volume);
  /// The hash; none if it is not known yet or cannot be made.
  std::optional<VolumeHash> of(const std::shared_ptr<const haptics::Volume>& volume) const;

 signals:
  /// `volume`: the scan.
  void sought(const std::shared_ptr<const haptics::Volume>& volume);

 private:
  struct Job {
    explicit Job(std::weak_ptr<const haptics::Volume> hashed) : volume{std::move(hashed)} {}
    std::weak_ptr<const haptics::Volume> volume;
    std::optional<VolumeHash> hash = {};
    background::Task<VolumeHash> task;
  };
  std::list<Job> jobs_;
};

}  // namespace app
