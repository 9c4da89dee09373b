// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/readers/files/file_stamp.h"

#include <sys/stat.h>

namespace datasets {

namespace {

std::int64_t nanoseconds(const timespec& time) {
  return std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
}

}  // namespace

FileStamp stampOf(const std::filesystem::path& path) {
  FileStamp stamp{.path = path};
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) return stamp;
  stamp.device = status.st_dev;
  stamp.number = status.st_ino;
  stamp.size = status.st_size;
  stamp.modified_ns = nanoseconds(status.st_mtim);
  stamp.changed_ns = nanoseconds(status.st_ctim);
  return stamp;
}

}  // namespace datasets
