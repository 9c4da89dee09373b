// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/readers/files/memory_file.h"

#include <sys/mman.h>
#include <unistd.h>

#include <utility>

namespace datasets {

MemoryFile::MemoryFile() : descriptor_{memfd_create("copy", MFD_CLOEXEC)} {}

MemoryFile::~MemoryFile() {
  if (descriptor_ >= 0) close(descriptor_);
}

MemoryFile::MemoryFile(MemoryFile&& other) noexcept
    : descriptor_{std::exchange(other.descriptor_, -1)} {}

bool MemoryFile::append(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = write(descriptor_, bytes.data(), bytes.size());
    if (written <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return descriptor_ >= 0;
}

std::string MemoryFile::path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

}  // namespace datasets
