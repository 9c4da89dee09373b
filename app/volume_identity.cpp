// SPDX-License-Identifier: BSD-3-Clause
#include "app/volume_identity.h"

#include <exception>

#include "app/recording/volume_hash.h"

namespace app {

VolumeIdentity::~VolumeIdentity() {
  for (Job& job : jobs_) job.cancel = true;
  for (Job& job : jobs_)
    if (job.thread.joinable()) job.thread.join();
}

void VolumeIdentity::seek(const std::shared_ptr<const haptics::Volume>& volume) {
  // of volumes that are gone nobody asks any more; a thread at work holds its volume
  for (Job& job : jobs_)
    if (job.volume.expired() && job.thread.joinable()) job.thread.join();
  jobs_.remove_if([](const Job& job) { return job.volume.expired(); });
  for (const Job& job : jobs_) {
    if (job.volume.lock() != volume) continue;
    if (job.done)
      QMetaObject::invokeMethod(
          this, [this, volume] { emit sought(volume); }, Qt::QueuedConnection);
    return;
  }
  Job& job = jobs_.emplace_back(volume);
  job.thread = std::thread([this, &job, volume] {
    std::optional<haptics::VolumeHash> hash;
    try {
      if (const auto key = installationKey()) hash = hashOf(*volume, *key, job.cancel);
    } catch (const std::exception&) {  // then nobody can tell
    }
    QMetaObject::invokeMethod(
        this,
        [this, &job, volume, hash] {
          job.hash = hash;
          job.done = true;
          emit sought(volume);
        },
        Qt::QueuedConnection);
  });
}

std::optional<haptics::VolumeHash> VolumeIdentity::of(
    const std::shared_ptr<const haptics::Volume>& volume) const {
  for (const Job& job : jobs_)
    if (job.volume.lock() == volume) return job.hash;
  return {};
}

}  // namespace app
