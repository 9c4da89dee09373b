// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/core/voxel_memory.h"
#include "haptics/process/process_limits.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <memory>
#include <numeric>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "datasets/phantoms/sampling.h"
#include "haptics/core/volume.h"
#include "tests/support/scratch_folder.h"

namespace {

using haptics::allocateVoxels;
using haptics::ScalarType;
using haptics::Volume;
using haptics::VoxelMemory;

constexpr std::size_t kPage = 4096;  // bytes

/// kB of the mapping that holds this place which are its own: copied pages.
long ownMemoryOf(const void* place) {
  std::ifstream in("/proc/self/smaps");
  const auto address = reinterpret_cast<std::uintptr_t>(place);
  bool here = false;
  for (std::string line; std::getline(in, line);) {
    unsigned long long from = 0, to = 0;
    if (std::sscanf(line.c_str(), "%llx-%llx ", &from, &to) == 2)
      here = address >= from && address < to;
    else if (here && line.starts_with("Anonymous:"))
      return std::stol(line.substr(10));
  }
  ADD_FAILURE() << "no such mapping";
  return -1;
}

Volume numbered(std::int64_t side) {
  auto voxels = allocateVoxels(side * side * side, ScalarType::Int16).value();
  auto* v = static_cast<std::int16_t*>(voxels.get());
  for (std::int64_t n = 0; n < side * side * side; ++n) v[n] = static_cast<std::int16_t>(n % 9973);
  return haptics::makeVolume(datasets::centredGrid(side, 1e-3), ScalarType::Int16, voxels).value();
}

TEST(VoxelMemory, AViewsWritesAreSeenByNobodyElse) {
  const Volume scan = numbered(40);
  ASSERT_TRUE(scan.memory);
  const auto* original = static_cast<const std::int16_t*>(scan.voxels.get());
  const auto one = scan.memory->privateView().value(), other = scan.memory->privateView().value();
  auto* a = static_cast<std::int16_t*>(one.get());
  auto* b = static_cast<std::int16_t*>(other.get());
  for (int n = 0; n < 64'000; ++n) ASSERT_EQ(a[n], n % 9973);
  for (int n = 0; n < 64'000; ++n) a[n] = -1;
  for (int n = 0; n < 64'000; ++n) {
    ASSERT_EQ(original[n], n % 9973);
    ASSERT_EQ(b[n], n % 9973);
  }
  b[7] = -2;
  EXPECT_EQ(a[7], -1);
  const auto later = scan.memory->privateView().value();
  EXPECT_EQ(static_cast<const std::int16_t*>(later.get())[7], 7);
}

TEST(VoxelMemory, AViewOutlivesTheScan) {
  auto scan = std::make_unique<Volume>(numbered(20));
  const auto view = scan->memory->privateView().value();
  scan.reset();
  const auto* v = static_cast<const std::int16_t*>(view.get());
  for (int n = 0; n < 8000; ++n) ASSERT_EQ(v[n], n);
  EXPECT_TRUE(VoxelMemory::of(view));
}

TEST(VoxelMemory, IsFoundFromItsFirstVoxelOnly) {
  const Volume scan = numbered(20);
  EXPECT_EQ(VoxelMemory::of(scan.voxels), scan.memory);
  const std::shared_ptr<const void> within(scan.voxels,
                                           static_cast<const std::int16_t*>(scan.voxels.get()) + 1);
  EXPECT_FALSE(VoxelMemory::of(within));
  EXPECT_FALSE(VoxelMemory::of(std::make_shared<int>(1)));
  EXPECT_FALSE(VoxelMemory::of(nullptr));
}

TEST(VoxelMemory, PaddingBehindAViewCanBeRead) {
  // up to the end of a page, and across it
  for (const std::size_t bytes : {std::size_t{10}, kPage - 1, kPage, 3 * kPage}) {
    const auto memory = VoxelMemory::allocate(bytes).value();
    for (const auto& view : {memory->sharedView().value(), memory->privateView().value()}) {
      const auto* v = static_cast<const char*>(view.get());
      EXPECT_EQ(std::accumulate(v, v + bytes + haptics::kVoxelPadding, 0), 0) << bytes;
    }
  }
}

TEST(VoxelMemory, OnlyTouchedPagesAreCopied) {
  const Volume scan = numbered(128);  // 4 MiB
  const auto view = scan.memory->privateView().value();
  auto* v = static_cast<char*>(view.get());
  const long page = sysconf(_SC_PAGESIZE) / 1024;  // kB
  EXPECT_EQ(ownMemoryOf(v), 0);
  long sum = 0;
  for (std::size_t n = 0; n < scan.memory->bytes(); n += kPage) sum += v[n];  // reading copies none
  EXPECT_NE(sum, 0);
  EXPECT_EQ(ownMemoryOf(v), 0);
  for (const std::size_t at : {std::size_t{0}, 100 * kPage, 100 * kPage + 17, 900 * kPage + 4095})
    v[at] = 1;
  EXPECT_EQ(ownMemoryOf(v), 3 * page);
  EXPECT_EQ(ownMemoryOf(scan.voxels.get()), 0);
}

TEST(VoxelMemory, IsPlainMemoryWhereFilesMayNotBecomeSoLarge) {
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  rlimit small = before;
  small.rlim_cur = 5000;
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
  const auto voxels = haptics::allocateVoxels(10'000, ScalarType::Int16);
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &before), 0);
  ASSERT_TRUE(voxels);
  EXPECT_FALSE(VoxelMemory::of(*voxels));
  EXPECT_EQ(static_cast<const char*>(voxels->get())[20'000 + haptics::kVoxelPadding - 1], 0);
}

class VoxelsOfAFile : public testing::Test {
 protected:
  ~VoxelsOfAFile() override { std::fclose(file_); }
  int made(const std::vector<float>& voxels, std::size_t before) {
    const std::string head(before, 'x');
    EXPECT_EQ(std::fwrite(head.data(), 1, before, file_), before);
    EXPECT_EQ(std::fwrite(voxels.data(), sizeof(float), voxels.size(), file_), voxels.size());
    std::fflush(file_);
    return fileno(file_);
  }
  std::string bytes() {
    std::string all(static_cast<std::size_t>(lseek(fileno(file_), 0, SEEK_END)), '\0');
    EXPECT_EQ(pread(fileno(file_), all.data(), all.size(), 0), static_cast<ssize_t>(all.size()));
    return all;
  }

 private:
  std::FILE* file_ = std::tmpfile();
};

TEST_F(VoxelsOfAFile, NeedNotBeginAtAPageAndStayAsTheyAre) {
  std::vector<float> voxels(27'000);
  std::iota(voxels.begin(), voxels.end(), 0.0F);
  const int file = made(voxels, kPage + 20);
  const std::string before = bytes();
  const auto memory = VoxelMemory::ofFile(file, kPage + 20, 4 * voxels.size()).value();
  const auto view = memory->privateView().value();
  auto* v = static_cast<float*>(view.get());
  EXPECT_EQ(std::memcmp(v, voxels.data(), 4 * voxels.size()), 0);
  for (std::size_t n = 0; n < voxels.size(); n += 500) v[n] = -1.0F;
  EXPECT_EQ(bytes(), before);
}

TEST_F(VoxelsOfAFile, ThatAreNoNumbersAreReplacedInEveryView) {
  std::vector<float> voxels(1000);
  std::iota(voxels.begin(), voxels.end(), 3.0F);
  for (const std::size_t n : {0, 1, 2, 500, 999}) voxels[n] = NAN;
  voxels[700] = INFINITY;
  const auto memory = VoxelMemory::ofFile(made(voxels, 0), 0, 4 * voxels.size()).value();
  const Volume scan = haptics::makeVolume(datasets::centredGrid(10, 1e-3), ScalarType::Float32,
                                          memory->privateView().value())
                          .value();
  EXPECT_EQ(scan.replaced, 6);
  ASSERT_TRUE(scan.memory);
  const auto view = scan.memory->privateView().value();
  EXPECT_EQ(std::memcmp(view.get(), scan.voxels.get(), 4 * voxels.size()), 0);
  EXPECT_EQ(static_cast<const float*>(view.get())[500], 6.0F);
}

/// What a process of its own returns, since what is done there lasts.
template <class Work>
int returnedBy(Work work) {
  const pid_t process = fork();
  if (process == 0) _exit(work());
  int status = 0;
  waitpid(process, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(ProcessLimits, AProcessThatForbidsThemLeavesNoCoreDump) {
  EXPECT_EQ(returnedBy([] {
              if (prctl(PR_GET_DUMPABLE, 0, 0, 0, 0) != 1) return 1;
              if (!haptics::forbidCoreDumps()) return 2;
              rlimit most{1, 1};
              getrlimit(RLIMIT_CORE, &most);
              return prctl(PR_GET_DUMPABLE, 0, 0, 0, 0) == 0 && most.rlim_max == 0 ? 0 : 3;
            }),
            0);
}

}  // namespace
