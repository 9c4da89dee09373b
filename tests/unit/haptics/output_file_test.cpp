// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/process/output_file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "tests/support/scratch_folder.h"
#include "tests/support/sentence.h"

namespace {

namespace fs = std::filesystem;
using haptics::Output;
using haptics::OutputFile;

std::string contentOf(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// A folder to write in.
struct Place {
  const support::ScratchFolder scratch;
  const fs::path path = scratch.write("marker", "").parent_path();
};

/// What was written there.
std::vector<std::string> namesIn(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().filename() != "marker") names.push_back(entry.path().filename().string());
  return names;
}

TEST(OutputFile, HasItsNameOnceItIsWhole) {
  const Place folder;
  const fs::path path = folder.path / "f";
  ASSERT_TRUE(haptics::writeFile(path, "old"));
  auto file = OutputFile::open(path);
  ASSERT_TRUE(file);
  EXPECT_TRUE(file->write("new"));
  ASSERT_TRUE(file->close());
  EXPECT_EQ(contentOf(path), "old");
  EXPECT_EQ(file->finish(), 3);
  EXPECT_EQ(contentOf(path), "new");
  EXPECT_EQ(namesIn(folder.path), std::vector<std::string>{"f"});
}

TEST(OutputFile, TwoAtOnceAreNotMixed) {
  const Place folder;
  const fs::path path = folder.path / "f";
  auto a = OutputFile::open(path), b = OutputFile::open(path);
  ASSERT_TRUE(a && b);
  a->write("aaaa");
  b->write("bb");
  ASSERT_TRUE(a->close() && b->close() && b->finish() && a->finish());
  EXPECT_EQ(contentOf(path), "aaaa");
  EXPECT_EQ(namesIn(folder.path), std::vector<std::string>{"f"});
}

TEST(OutputFile, ReplacesNoFileThatIsKept) {
  const support::ScratchFolder scratch;
  const fs::path scan = scratch.write("scan", "mine");
  haptics::keepInput(scan);
  fs::create_symlink("scan", scratch / "link");
  fs::create_hard_link(scan, scratch / "second");
  for (const char* name : {"scan", "link", "second"}) {
    const auto written = haptics::writeFile(scratch / name, "other");
    ASSERT_FALSE(written) << name;
    EXPECT_NE(sentence(written.error()).find("would be lost"), std::string::npos) << name;
  }
  EXPECT_EQ(contentOf(scan), "mine");
  EXPECT_EQ(scratch.names(), (std::vector<std::string>{"link", "scan", "second"}));
  // its number may be given to a file that is made when it is gone
  for (const char* name : {"scan", "link", "second"}) fs::remove(scratch / name);
  for (int n = 0; n < 20; ++n) {
    const std::string name = "new-" + std::to_string(n);
    ASSERT_TRUE(haptics::writeFile(scratch / name, "1"));
    ASSERT_TRUE(haptics::writeFile(scratch / name, "2")) << n;
  }
}

TEST(OutputFile, MayHaveAsLongANameAsThereIs) {
  const support::ScratchFolder scratch;
  for (const std::size_t length : {240U, 250U, 255U}) {
    const std::string name(length, 'x');
    ASSERT_TRUE(haptics::writeFile(scratch / name, "1")) << length;
    EXPECT_EQ(contentOf(scratch / name), "1");
  }
  EXPECT_FALSE(haptics::writeFile(scratch / std::string(256, 'x'), "1"));
}

TEST(OutputFile, UnfinishedLeavesWhatWasThere) {
  const Place folder;
  ASSERT_TRUE(haptics::writeFile(folder.path / "f", "old"));
  {
    auto file = OutputFile::open(folder.path / "f");
    ASSERT_TRUE(file);
    file->write("new");
    auto output = Output::at(folder.path / "g");
    ASSERT_TRUE(output);
    EXPECT_TRUE(fs::exists(output->part()));
  }
  EXPECT_EQ(contentOf(folder.path / "f"), "old");
  EXPECT_EQ(namesIn(folder.path), std::vector<std::string>{"f"});
}

TEST(OutputFile, ADescriptorIsWrittenAsItIs) {
  const Place folder;
  const int file = ::open((folder.path / "f").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
  ASSERT_GE(file, 0);
  ASSERT_EQ(::write(file, "before ", 7), 7);
  ASSERT_TRUE(haptics::writeFile("/proc/self/fd/" + std::to_string(file), "and "));
  ASSERT_TRUE(haptics::writeFile("/dev/fd/" + std::to_string(file), "after"));
  ::close(file);
  EXPECT_EQ(contentOf(folder.path / "f"), "before and after");
  EXPECT_EQ(namesIn(folder.path), std::vector<std::string>{"f"});
}

TEST(OutputFile, WhatCannotBeWrittenIsRefusedByName) {
  const Place folder;
  for (const fs::path& path : {fs::path("/dev/full"), folder.path, folder.path / "no/f"}) {
    const auto written = haptics::writeFile(path, "text");
    ASSERT_FALSE(written) << path;
    EXPECT_EQ(written.error().reason, "unwritable");
    EXPECT_NE(sentence(written.error()).find(path.string()), std::string::npos)
        << sentence(written.error());
  }
  EXPECT_FALSE(Output::at("/dev/null"));  // has no name to give
}

TEST(OutputFile, AnEndHereAndNowLeavesNothing) {
  const Place folder;
  const pid_t child = fork();
  if (child == 0) {
    auto file = OutputFile::open(folder.path / "f");
    if (!file || !file->write("half")) ::_exit(1);
    haptics::discardOutputs();
    ::_exit(0);
  }
  int status = -1;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_EQ(status, 0);
  EXPECT_TRUE(namesIn(folder.path).empty());
}

}  // namespace
