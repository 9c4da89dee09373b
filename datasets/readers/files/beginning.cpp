// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/readers/files/beginning.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>

namespace datasets {

namespace {

constexpr std::size_t kBeginning = 512;  // bytes

}  // namespace

Beginning::Beginning(const std::filesystem::path& file) : path(file) {
  // a pipe that nobody writes is not waited for
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (descriptor < 0) return;
  is_open = true;
  struct stat status {};
  const bool known = ::fstat(descriptor, &status) == 0;
  if (known) file_size = status.st_size;
  if (known && S_ISREG(status.st_mode)) bytes.resize(kBeginning);
  std::size_t filled = 0;
  while (filled < bytes.size()) {
    const ssize_t count = ::read(descriptor, bytes.data() + filled, bytes.size() - filled);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) break;
    filled += static_cast<std::size_t>(count);
  }
  bytes.resize(filled);
  ::close(descriptor);
}

}  // namespace datasets
