// SPDX-License-Identifier: BSD-3-Clause
#include "app/log/log.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "tests/support/scratch_folder.h"

namespace {

namespace fs = std::filesystem;
namespace log = app::log;
using log::Level;

class Log : public testing::Test {
 protected:
  ~Log() override { log::close(); }
  std::string last() const {
    const auto lines = log::lines(folder_, 1);
    return lines.empty() ? "" : lines.front();
  }
  support::ScratchFolder scratch_;
  fs::path folder_ = scratch_ / "state";
};

TEST_F(Log, ALineIsTheEventAndItsFacts) {
  ASSERT_TRUE(log::open(folder_, Level::Info));
  log::write(Level::Warning, "scan-opened",
             {{"columns", 512},
              {"spacing_mm", 0.625},
              {"type", log::nameOfProgram("int16")},
              {"renderer", log::nameOfMachine("Mesa llvmpipe\n(LLVM)")},
              {"hand", "mouse"}});
  const std::string line = last();
  EXPECT_TRUE(
      line.ends_with(" warning scan-opened columns=512 spacing_mm=0.625 type=int16 "
                     "renderer=\"Mesa llvmpipe?(LLVM)\" hand=mouse"))
      << line;
  EXPECT_NE(line.find('[' + log::session() + ']'), std::string::npos) << line;
}

TEST_F(Log, AnErrorIsItsIdentifierWithoutWhatItNames) {
  using haptics::Error;
  const Error planted{
      Error::Kind::Malformed, {"file-shorter-than-header", {"Doe^Jane.nrrd"}}, "truncated"};
  const Error plain{Error::Kind::Malformed, "Doe^Jane.nrrd is cut off.", "truncated"};
  EXPECT_EQ(log::nameOf(planted).text(), "file-shorter-than-header");
  EXPECT_EQ(log::nameOf(plain).text(), "truncated");
  // what is no name is none
  for (const char* text : {"", "Doe Jane", "/home/scan", "a\nb", "Doe^Jane"})
    EXPECT_EQ(log::nameOfProgram(text).text(), "?") << text;
}

TEST_F(Log, HoldsWhatIsAtLeastOfItsLevel) {
  ASSERT_TRUE(log::open(folder_, Level::Warning));
  log::write(Level::Debug, "first");
  log::write(Level::Info, "second");
  log::write(Level::Warning, "third");
  log::write(Level::Error, "fourth");
  const auto lines = log::lines(folder_, 10);
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_TRUE(lines[0].ends_with("third"));
  EXPECT_TRUE(lines[1].ends_with("fourth"));
  EXPECT_EQ(log::levelOf("warning"), Level::Warning);
  EXPECT_EQ(log::levelOf("loud"), Level::Off);
}

TEST_F(Log, OffMakesNoFile) {
  EXPECT_FALSE(log::open(folder_, Level::Off));
  log::write(Level::Error, "nothing");
  EXPECT_FALSE(fs::exists(folder_));
}

TEST_F(Log, IsForTheUsersEyesAlone) {
  umask(0);
  ASSERT_TRUE(log::open(folder_, Level::Info));
  log::write(Level::Info, "first");
  EXPECT_EQ(fs::status(folder_).permissions(), fs::perms::owner_all);
  EXPECT_EQ(fs::status(folder_ / "palpate.log").permissions(),
            fs::perms::owner_read | fs::perms::owner_write);
}

TEST_F(Log, RotatesThroughThreeFilesOfAMegabyte) {
  ASSERT_TRUE(log::open(folder_, Level::Info));
  const std::string filler(120, 'x');
  constexpr int kLines = 20'000;  // of some 190 bytes
  for (int n = 0; n < kLines; ++n)
    log::write(Level::Info, "line", {{"filler", log::nameOfMachine(filler)}, {"number", n}});
  int files = 0;
  for (const auto& entry : fs::directory_iterator{folder_}) {
    ++files;
    EXPECT_LE(entry.file_size(), 1'000'000U) << entry.path();
    EXPECT_EQ(entry.status().permissions(), fs::perms::owner_read | fs::perms::owner_write);
  }
  EXPECT_EQ(files, 3);
  const auto lines = log::lines(folder_, 10'000);
  ASSERT_EQ(lines.size(), 10'000U);  // more than one file holds, oldest first
  EXPECT_TRUE(lines.front().ends_with("number=10000")) << lines.front();
  EXPECT_TRUE(lines.back().ends_with("number=19999")) << lines.back();
}

TEST_F(Log, GoesOnWhereItEndedAndTellsSessionsApart) {
  for (int n = 0; n < 2; ++n) {
    ASSERT_TRUE(log::open(folder_, Level::Info));
    log::write(Level::Info, "start");
  }
  EXPECT_EQ(log::lines(folder_, 10).size(), 2U);
  EXPECT_EQ(log::lines(folder_, 10, log::session()).size(), 2U);
  EXPECT_TRUE(log::lines(folder_, 10, "1-1").empty());
}

TEST_F(Log, WhereItCannotBeWrittenNothingFails) {
  std::ofstream{folder_} << "a file stands in the way";
  EXPECT_FALSE(log::open(folder_, Level::Info));
  log::write(Level::Error, "nothing");
  EXPECT_FALSE(log::open({}, Level::Info));
  EXPECT_TRUE(log::lines(folder_, 10).empty());
}

TEST_F(Log, AFullDiskCostsTheLineAlone) {
  ASSERT_TRUE(log::open(folder_, Level::Info));
  log::write(Level::Error, "first");
  const auto size = fs::file_size(folder_ / "palpate.log");
  rlimit most{};
  getrlimit(RLIMIT_FSIZE, &most);
  const rlimit full{.rlim_cur = size, .rlim_max = most.rlim_max};
  const auto before = std::signal(SIGXFSZ, SIG_IGN);
  setrlimit(RLIMIT_FSIZE, &full);
  log::write(Level::Error, "second");
  setrlimit(RLIMIT_FSIZE, &most);
  std::signal(SIGXFSZ, before);
  EXPECT_EQ(fs::file_size(folder_ / "palpate.log"), size);
  log::write(Level::Error, "third");
  EXPECT_TRUE(last().ends_with("third")) << last();
}

TEST_F(Log, TheFolderFollowsTheDesktopsRules) {
  ASSERT_EQ(setenv("HOME", "/home/of", 1), 0);
  ASSERT_EQ(setenv("XDG_STATE_HOME", "/var/state", 1), 0);
  EXPECT_EQ(log::stateFolder(), "/var/state/palpate");
  ASSERT_EQ(setenv("XDG_STATE_HOME", "relative", 1), 0);
  EXPECT_EQ(log::stateFolder(), "/home/of/.local/state/palpate");
  ASSERT_EQ(unsetenv("XDG_STATE_HOME"), 0);
  EXPECT_EQ(log::stateFolder(), "/home/of/.local/state/palpate");
  ASSERT_EQ(unsetenv("HOME"), 0);
  EXPECT_TRUE(log::stateFolder().empty());
}

}  // namespace
