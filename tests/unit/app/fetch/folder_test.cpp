// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <optional>

#include "app/fetch/folder.h"
#include "tests/support/scratch_folder.h"

namespace {

using namespace app::fetch;
namespace fs = std::filesystem;

mode_t modeOf(const fs::path& path) {
  struct stat status {};
  return stat(path.c_str(), &status) == 0 ? status.st_mode & 0777U : 0;
}

TEST(FetchFolder, ATemporaryOneGoesWithItsObjectAndStaysInASweep) {
  fs::path path;
  {
    auto folder = Folder::temporary();
    ASSERT_TRUE(folder);
    path = folder->path();
    EXPECT_EQ(modeOf(path), 0700U);
    std::ofstream(path / "000001.dcm") << "image";
    sweepFolders();
    EXPECT_TRUE(fs::exists(path / "000001.dcm"));
  }
  EXPECT_FALSE(fs::exists(path));
}

TEST(FetchFolder, ASweepTakesWhatNobodyHolds) {
  const fs::path left = fs::temp_directory_path() / "palpate-fetch-LEFTXX";
  fs::create_directory(left);
  std::ofstream(left / "000001.dcm") << "image";
  sweepFolders();
  EXPECT_FALSE(fs::exists(left));
}

TEST(FetchFolder, TheUsersOwnIsNewOrEmptyAndStays) {
  const support::ScratchFolder scratch;
  const fs::path path = scratch / "scan";
  {
    auto folder = Folder::at(path);
    ASSERT_TRUE(folder);
    std::ofstream(path / "000001.dcm") << "image";
  }
  EXPECT_EQ(modeOf(path), 0700U);
  EXPECT_TRUE(fs::exists(path / "000001.dcm"));
  EXPECT_FALSE(Folder::at(path));  // not empty
  fs::create_directory_symlink(path, scratch / "link");
  EXPECT_FALSE(Folder::at(scratch / "link"));
  auto again = Folder::at(scratch / "other");
  ASSERT_TRUE(again);
  again->discard();
  EXPECT_FALSE(fs::exists(scratch / "other"));
}

}  // namespace
