// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/scan/volume_identity.h"

#include "app/recording/volume_hash.h"
#include "app/window/scan/edited_volume.h"

namespace app {

void VolumeIdentity::seek(const std::shared_ptr<const haptics::Volume>& sought_volume) {
  const std::shared_ptr<const haptics::Volume> volume = scanOf(sought_volume);
  // of volumes that are gone nobody asks any more; a thread at work holds its volume
  jobs_.remove_if([](const Job& job) { return job.volume.expired(); });
  for (const Job& job : jobs_) {
    if (job.volume.lock() != volume) continue;
    if (!job.task.isRunning())
      QMetaObject::invokeMethod(
          this, [this, volume] { emit sought(volume); }, Qt::QueuedConnection);
    return;
  }
  Job& job = jobs_.emplace_back(volume);
  job.task.start(
      [volume](const background::Watch& watch) -> haptics::Expected<VolumeHash> {
        const auto key = installationKey();
        if (!key) return tl::unexpected(key.error());
        if (const auto hash = hashOf(*volume, *key, watch.cancel)) return *hash;
        return tl::unexpected(haptics::Error{haptics::Error::Kind::Cancelled, {}, "cancelled"});
      },
      [this, &job, volume](const haptics::Expected<VolumeHash>& hash) {
        if (hash) job.hash = *hash;  // else nobody can tell
        emit sought(volume);
      });
}

std::optional<VolumeHash> VolumeIdentity::of(
    const std::shared_ptr<const haptics::Volume>& volume) const {
  const std::shared_ptr<const haptics::Volume> scan = scanOf(volume);
  for (const Job& job : jobs_)
    if (job.volume.lock() == scan) return job.hash;
  return {};
}

}  // namespace app
