// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <list>
#include <memory>
#include <optional>

#include "app/background/task.h"
#include "haptics/recording/scene_words.h"

namespace app {

/// Hashes volumes on a thread of its own, each once while it is in use. No call waits, except the
/// destructor.
class VolumeIdentity : public QObject {
  Q_OBJECT
 public:
  explicit VolumeIdentity(QObject* parent = nullptr) : QObject(parent) {}

  /// sought() follows, soon if it is known already.
  void seek(const std::shared_ptr<const haptics::Volume>& volume);
  /// None: it was not sought yet, or cannot be had.
  std::optional<haptics::VolumeHash> of(const std::shared_ptr<const haptics::Volume>& volume) const;

 signals:
  void sought(const std::shared_ptr<const haptics::Volume>& volume);

 private:
  struct Job {
    explicit Job(std::weak_ptr<const haptics::Volume> hashed) : volume{std::move(hashed)} {}
    std::weak_ptr<const haptics::Volume> volume;
    std::optional<haptics::VolumeHash> hash = {};
    background::Task<haptics::VolumeHash> task;
  };
  std::list<Job> jobs_;
};

}  // namespace app
