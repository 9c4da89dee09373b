// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string>

#include "datasets/readers/volume_reader.h"
#include "haptics/core/volume.h"
#include "tests/support/places.h"

/// Skips the test, loudly, where the real scans do not stand beside the checkout.
#define NEEDS_SCAN(path)              \
  if (!std::filesystem::exists(path)) \
  GTEST_SKIP() << "NOT CHECKED: the scan " << (path).filename() << " is not here"

namespace datasets::testing {

inline std::filesystem::path scan(const std::string& name) { return places::scan(name); }

/// The reason for which this file or folder is refused; empty where it is not.
inline std::string reasonFor(const std::filesystem::path& path) {
  const auto volume = readVolume(path);
  return volume ? "" : volume.error().reason;
}

/// A folder of its own for each test, removed at the end.
class Workshop {
 public:
  Workshop()
      : folder_(std::filesystem::temp_directory_path() /
                ("palpate-" + std::to_string(getpid()) + "-" +
                 ::testing::UnitTest::GetInstance()->current_test_info()->name())) {
    std::filesystem::create_directories(folder_);
  }
  ~Workshop() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  Workshop(const Workshop&) = delete;
  Workshop& operator=(const Workshop&) = delete;

  const std::filesystem::path& folder() const { return folder_; }
  std::filesystem::path write(const std::string& name, const std::string& bytes) const {
    std::filesystem::create_directories((folder_ / name).parent_path());
    std::ofstream(folder_ / name, std::ios::binary) << bytes;
    return folder_ / name;
  }
  std::filesystem::path copy(const std::filesystem::path& from,
                             const std::string& name = {}) const {
    const auto to = folder_ / (name.empty() ? from.filename().string() : name);
    std::filesystem::create_directories(to.parent_path());
    std::filesystem::copy_file(from, to);
    std::filesystem::permissions(to, std::filesystem::perms::owner_write,
                                 std::filesystem::perm_options::add);
    return to;
  }

 private:
  std::filesystem::path folder_;
};

/// The voxel at an index, as a double.
inline double voxelAt(const haptics::Volume& v, std::int64_t i, std::int64_t j, std::int64_t k) {
  const std::int64_t at = i + v.grid.dims[0] * (j + v.grid.dims[1] * k);
  return haptics::visitVoxels(v.type, v.voxels.get(),
                              [&](const auto* p) { return static_cast<double>(p[at]); });
}

/// How many voxels differ between equal grids; -1 where the dims differ.
inline std::int64_t differing(const haptics::Volume& a, const haptics::Volume& b,
                              double tolerance = 0.0) {
  if (a.grid.dims != b.grid.dims) return -1;
  std::int64_t count = 0;
  for (std::int64_t k = 0; k < a.grid.dims[2]; ++k)
    for (std::int64_t j = 0; j < a.grid.dims[1]; ++j)
      for (std::int64_t i = 0; i < a.grid.dims[0]; ++i)
        count += std::abs(voxelAt(a, i, j, k) - voxelAt(b, i, j, k)) > tolerance ? 1 : 0;
  return count;
}

}  // namespace datasets::testing
