// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/report/results.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <fstream>
#include <new>
#include <set>

#include "app/build_info/build_info.h"
#include "app/study/report/run_study.h"

namespace {

namespace fs = std::filesystem;
using study::Case;
using study::Job;
using study::Outcome;
using study::Results;
using study::Study;

/// A folder of the test's own, removed with it.
struct Folder {
  Folder() {
    static int made = 0;
    path = fs::temp_directory_path() /
           ("palpate-study-" + std::to_string(::getpid()) + "-" + std::to_string(made++));
    fs::create_directories(path);
  }
  ~Folder() { fs::remove_all(path); }
  fs::path path;
};

/// Jobs that count how often they are run; the third's case fails.
Study study3(std::vector<int>& runs) {
  Study study{"plan", "Three jobs", {"Nothing <real>."}};
  for (int n = 0; n < 3; ++n)
    study.jobs.push_back(
        {"job/" + std::to_string(n), n < 2 ? "First" : "Last", 1.0 + n,
         [&runs, n](std::uint64_t seed) {
           ++runs[static_cast<std::size_t>(n)];
           Outcome outcome;
           outcome.cases.push_back({"case, \"" + std::to_string(n) + "\"", double(n), 1.0, "mm",
                                    Case::Sense::AtMost, "seed " + std::to_string(seed)});
           study::Plot plot{"Shared", "Joined over jobs.", {"x"}, {"y"}};
           plot.series.push_back({"s", {{3.0 - n, 1.0, NAN, 2.0, n != 1, "2, 3"}}});
           outcome.plots.push_back(plot);
           outcome.tables.push_back({"Rows", {"n"}, {{std::to_string(n)}}});
           outcome.remarks.push_back("Said once.");
           return outcome;
         }});
  study.front = {{{"At most {worst} in {count}.", "\""}, {"Said of none.", "no case"}}, {"Shared"}};
  return study;
}

study::RunOptions into(const fs::path& out) {
  study::RunOptions options;
  options.out = out;
  return options;
}
std::string textOf(const fs::path& path) {
  std::ifstream file{path};
  return {std::istreambuf_iterator<char>{file}, {}};
}
int countOf(const std::string& text, const std::string& what) {
  int count = 0;
  for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++count;
  return count;
}

TEST(Case, PassesWithinItsBoundAndNeverWithoutANumber) {
  EXPECT_TRUE((Case{"a", 1.0, 1.0, ""}.pass()));
  EXPECT_FALSE((Case{"a", 1.1, 1.0, ""}.pass()));
  EXPECT_TRUE((Case{"a", 1.0, 1.0, "", Case::Sense::AtLeast}.pass()));
  EXPECT_FALSE((Case{"a", 0.9, 1.0, "", Case::Sense::AtLeast}.pass()));
  EXPECT_FALSE((Case{"a", NAN, 1.0, ""}.pass()));
  EXPECT_FALSE((Case{"a", INFINITY, 1.0, "", Case::Sense::AtLeast}.pass()));
}

TEST(RunStudy, WritesWhatItFoundAndRunsNothingTwice) {
  Folder folder;
  std::vector<int> runs(3);
  const auto results = study::runStudy(study3(runs), into(folder.path));
  ASSERT_TRUE(results);
  EXPECT_EQ(runs, (std::vector{1, 1, 1}));
  ASSERT_EQ(results->cases().size(), 3u);
  EXPECT_FALSE(results->cases()[2].pass());
  const std::string json = textOf(folder.path / "results.json");
  const std::string html = textOf(folder.path / "report.html");
  const std::string csv = textOf(folder.path / "results.csv");
  // again: what is there is taken as it is, to the byte
  const auto again = study::runStudy(study3(runs), into(folder.path));
  ASSERT_TRUE(again);
  EXPECT_EQ(runs, (std::vector{1, 1, 1}));
  EXPECT_EQ(textOf(folder.path / "results.json"), json);
  EXPECT_EQ(textOf(folder.path / "report.html"), html);

  // the page: one plot of one title and section, its points in order; what fails stands in front
  EXPECT_EQ(countOf(html, "<figcaption>Shared</figcaption>"), 4);  // the first page has them, too
  EXPECT_NE(html.find("<li>At most 2 mm in 3.</li>"), std::string::npos);
  EXPECT_EQ(html.find("Said of none"), std::string::npos);
  EXPECT_NE(html.find("2 of 3 cases hold"), std::string::npos);
  EXPECT_EQ(countOf(html, ">case, &quot;2&quot;<"), 2);  // among the failing, and in its section
  EXPECT_EQ(countOf(html, ">case, &quot;0&quot;<"), 1);
  EXPECT_EQ(countOf(html, "Said once."), 2);
  EXPECT_EQ(html.find("Nothing <real>"), std::string::npos);
  // commas and quotes of names are no fields of their own
  EXPECT_NE(csv.find("case,First,job/0,\"case, \"\"0\"\"\",,,,0,,,1,mm,yes\n"), std::string::npos);
  EXPECT_EQ(countOf(csv, "\n"), 1 + 3 + 3);
  EXPECT_EQ(countOf(csv, "Shared,s,\"2, 3\","), 3);
}

TEST(RunStudy, AJobThatThrowsFailsAndTheOthersGoOn) {
  Folder folder;
  std::vector<int> runs(3);
  Study study = study3(runs);
  study.jobs[0].run = [](std::uint64_t) -> Outcome { throw std::bad_alloc{}; };
  const auto results = study::runStudy(study, into(folder.path));
  ASSERT_TRUE(results);
  EXPECT_EQ(runs, (std::vector{0, 1, 1}));
  ASSERT_EQ(results->cases().size(), 3u);
  EXPECT_FALSE(results->cases()[0].pass());
  EXPECT_EQ(results->cases()[0].name, "job/0: ran to its end");
}

TEST(RunStudy, AnotherSeedOrDepthIsAnotherStudyAndIsNotMixedIn) {
  Folder folder;
  std::vector<int> runs(3);
  ASSERT_TRUE(study::runStudy(study3(runs), into(folder.path)));
  const std::string json = textOf(folder.path / "results.json");
  for (const bool seed : {true, false}) {
    auto other = into(folder.path);
    if (seed)
      other.seed = 2;
    else
      other.depth = study::Depth::Quick;
    const auto refused = study::runStudy(study3(runs), other);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().reason, "mixed");
  }
  EXPECT_EQ(runs, (std::vector{1, 1, 1}));
  EXPECT_EQ(textOf(folder.path / "results.json"), json);
}

TEST(RunStudy, EveryJobHasASeedOfItsOwnThatFollowsFromTheStudys) {
  const auto seeds = [](std::uint64_t seed) {
    Folder folder;
    std::vector<int> runs(3);
    auto options = into(folder.path);
    options.seed = seed;
    std::set<std::string> notes;
    const auto results = study::runStudy(study3(runs), options);
    for (const Case& c : results->cases()) notes.insert(c.note);
    return notes;
  };
  EXPECT_EQ(seeds(1).size(), 3u);
  EXPECT_EQ(seeds(1), seeds(1));
  EXPECT_NE(seeds(1), seeds(2));
}

TEST(RunStudy, StoppedItKeepsWhatIsDoneAndGoesOn) {
  Folder folder;
  std::vector<int> runs(3);
  auto options = into(folder.path);
  options.stop = [&] { return runs[1] > 0; };
  const auto some = study::runStudy(study3(runs), options);
  ASSERT_TRUE(some);
  EXPECT_EQ(some->missing(), std::vector<std::string>{"job/2"});
  EXPECT_NE(textOf(folder.path / "report.html").find("1 of 3 jobs have not been run"),
            std::string::npos);
  const auto whole = study::runStudy(study3(runs), into(folder.path));
  ASSERT_TRUE(whole);
  EXPECT_TRUE(whole->missing().empty());
  EXPECT_EQ(runs, (std::vector{1, 1, 1}));
}

TEST(RunStudy, ShardsTogetherAreTheWhole) {
  Folder folder;
  std::vector<int> runs(3);
  std::vector<fs::path> parts;
  for (int n = 1; n <= 2; ++n) {
    auto options = into(folder.path / std::to_string(n));
    options.shard = {n, 2};
    ASSERT_TRUE(study::runStudy(study3(runs), options));
    parts.push_back(options.out);
  }
  EXPECT_EQ(runs, (std::vector{1, 1, 1}));  // each job in one shard
  std::vector<int> none(3);
  const auto studyOf = [&](const study::Identity&) { return std::optional{study3(none)}; };
  const auto merged = study::mergeStudies(parts, folder.path / "all", studyOf);
  ASSERT_TRUE(merged);
  EXPECT_TRUE(merged->missing().empty());
  EXPECT_EQ(none, (std::vector{0, 0, 0}));
  // but for the times it is what one run gives
  const auto whole = study::runStudy(study3(runs), into(folder.path / "whole"));
  const auto timeless = [](const Results& results) {
    study::Json json = study::jsonOf(results);
    for (study::Json& job : json["jobs"]) job.erase("seconds");
    return json;
  };
  EXPECT_EQ(timeless(*merged), timeless(*whole));
  // a job that stands in two folders is taken from the first, in all that is written
  study::Json changed =
      study::Json::parse(textOf(folder.path / "2" / "jobs" / "job_2.json"), nullptr, false);
  const bool second = !changed.is_discarded();
  const fs::path owner = folder.path / (second ? "2" : "1"),
                 other = folder.path / (second ? "1" : "2");
  changed = study::Json::parse(textOf(owner / "jobs" / "job_2.json"));
  changed["seconds"] = 1e6;
  std::ofstream{other / "jobs" / "job_2.json"} << changed.dump();
  const auto twice = study::mergeStudies({owner, other}, folder.path / "twice", studyOf);
  ASSERT_TRUE(twice);
  EXPECT_LT(twice->finished[2].seconds, 1e6);
  EXPECT_LT(study::Json::parse(textOf(folder.path / "twice" / "jobs" / "job_2.json"))["seconds"],
            1e6);
  // merged again: the same
  const auto again = study::mergeStudies({folder.path / "all"}, folder.path / "all", studyOf);
  ASSERT_TRUE(again);
  EXPECT_EQ(study::jsonOf(*again), study::jsonOf(*merged));
}

TEST(MergeStudies, RefusesAMixAndWhatIsNoStudy) {
  Folder folder;
  std::vector<int> runs(3);
  const auto studyOf = [&](const study::Identity&) { return std::optional{study3(runs)}; };
  auto one = into(folder.path / "one"), other = into(folder.path / "other");
  other.seed = 2;
  ASSERT_TRUE(study::runStudy(study3(runs), one));
  ASSERT_TRUE(study::runStudy(study3(runs), other));
  const auto mixed = study::mergeStudies({one.out, other.out}, folder.path / "all", studyOf);
  ASSERT_FALSE(mixed);
  EXPECT_EQ(mixed.error().reason, "mixed");
  const auto empty = study::mergeStudies({folder.path}, folder.path / "all", studyOf);
  ASSERT_FALSE(empty);
  EXPECT_EQ(empty.error().reason, "no-jobs");
  // another build's: its version would be the same
  fs::path job;
  for (const auto& entry : fs::directory_iterator{one.out / "jobs"}) {
    study::Json json = study::Json::parse(textOf(entry.path()));
    json["build"] = "0123";
    std::ofstream{entry.path()} << json.dump();
    job = entry.path();
  }
  const auto older = study::mergeStudies({one.out}, folder.path / "all", studyOf);
  ASSERT_FALSE(older);
  EXPECT_EQ(older.error().reason, "other-build");
  for (const char* text : {"", "{", "[]", "{\"schema\":1}", "{\"schema\":\"x\"}"}) {
    std::ofstream{job} << text;
    const auto broken = study::mergeStudies({one.out}, folder.path / "all", studyOf);
    ASSERT_FALSE(broken) << text;
    EXPECT_EQ(broken.error().reason, "malformed") << text;
  }
  EXPECT_FALSE(fs::exists(folder.path / "all" / "results.json"));
}

TEST(BuildHere, IsKnown) { EXPECT_EQ(app::buildHere().size(), 40u); }

}  // namespace
