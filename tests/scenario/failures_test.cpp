// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/stability/stability.h"

#include <gtest/gtest.h>

#include <cctype>
#include <string>

// Situations in which the paper's method, or a plausible step beyond it, fails. They are cases of
// the stability study, with their bounds; here each of them is held to it.

namespace {

using study::Case;
using study::Depth;
using study::Job;
using study::Outcome;

constexpr Depth kDepth = Depth::Full;

class Failures : public testing::TestWithParam<int> {};

TEST_P(Failures, AreNot) {
  const Job job = study::stability::failureJobs(kDepth).at(std::size_t(GetParam()));
  const Outcome outcome = job.run(0);
  EXPECT_FALSE(outcome.cases.empty());
  for (const Case& each : outcome.cases)
    EXPECT_TRUE(each.pass()) << each.name << ": " << each.value << " " << each.unit << ", bound "
                             << each.bound << "; " << each.note;
}

INSTANTIATE_TEST_SUITE_P(All, Failures,
                         testing::Range(0, int(study::stability::failureJobs(kDepth).size())),
                         [](const testing::TestParamInfo<int>& which) {
                           const Job job =
                               study::stability::failureJobs(kDepth).at(std::size_t(which.param));
                           std::string name;
                           for (const char c : job.name)
                             if (std::isalnum(static_cast<unsigned char>(c))) name += c;
                           return name;
                         });

}  // namespace
