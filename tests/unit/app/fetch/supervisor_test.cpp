// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <vector>

#include "app/fetch/supervisor.h"

namespace {

using namespace app::fetch;

constexpr double kLong_s = 600.0;

TEST(FetchSupervisor, HandsOnWhatTheWorkAnswers) {
  Supervisor supervisor{false};
  const Outcome outcome = supervisor.run(
      [] {
        Outcome made{Exit::Refused};
        made.json["series"] = {1, 2};
        made.error = {"output-unwritable", {"a.dcm", {"disk-full", {}}}};
        made.reason = "word";
        return made;
      },
      kLong_s);
  EXPECT_EQ(outcome.code, Exit::Refused);
  EXPECT_EQ(outcome.json.dump(), R"({"series":[1,2]})");
  EXPECT_EQ(
      jsonOf(outcome.error).dump(),
      R"({"id":"output-unwritable","arguments":["a.dcm",{"id":"disk-full","arguments":[]}]})");
  EXPECT_EQ(outcome.reason, "word");
}

TEST(FetchSupervisor, LimitsTheWork) {
  Supervisor supervisor{false};
  const Outcome outcome = supervisor.run(
      [] {
        rlimit core{}, files{};
        getrlimit(RLIMIT_CORE, &core);
        getrlimit(RLIMIT_NOFILE, &files);
        Outcome made;
        made.json = {{"core", core.rlim_max},
                     {"files", files.rlim_max},
                     {"dumpable", prctl(PR_GET_DUMPABLE, 0, 0, 0, 0)}};
        return made;
      },
      kLong_s);
  EXPECT_EQ(outcome.json.dump(), R"({"core":0,"files":256,"dumpable":0})");
}

TEST(FetchSupervisor, SaysSoWhereTheWorkDiesOrTakesTooMuch) {
  Supervisor supervisor{false};
  EXPECT_EQ(supervisor.run([]() -> Outcome { std::abort(); }, kLong_s).reason, "died");
  EXPECT_EQ(supervisor.run([]() -> Outcome { ::_exit(0); }, kLong_s).reason, "died");
  const auto sleeps = []() -> Outcome {
    for (;;) ::pause();
  };
  EXPECT_EQ(supervisor.run(sleeps, 0.2).reason, "too-long");
  const auto grows = []() -> Outcome {
    std::vector<std::vector<char>> all;
    for (;;) all.emplace_back(std::size_t{1} << 26, 'x');
  };
  EXPECT_EQ(supervisor.run(grows, kLong_s).reason, "memory");
}

TEST(FetchSupervisor, StopsWhatDoesNotListen) {
  Supervisor supervisor{false};
  const auto deaf = []() -> Outcome {
    std::signal(SIGTERM, SIG_IGN);
    kill(getppid(), SIGTERM);
    for (;;) ::pause();
  };
  const Outcome outcome = supervisor.run(deaf, kLong_s);
  EXPECT_EQ(outcome.code, Exit::Interrupted);
  EXPECT_EQ(outcome.reason, "cancelled");
}

}  // namespace
