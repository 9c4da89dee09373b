// SPDX-License-Identifier: BSD-3-Clause
// What of a recording is exported, and what is left behind where that cannot be done.
// tests/scenario/exports_test.py reads the formats.
#include "app/export/export.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <bit>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <random>
#include <set>
#include <sstream>

#include "app/recording/recorder.h"
#include "tests/support/places.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/sentence.h"

namespace app::exporting {
namespace {

namespace fs = std::filesystem;
using app::Recording;
using haptics::Expected;
using haptics::Step;
using support::ScratchFolder;

Step at(std::int64_t time_ns) {
  Step step;
  step.time_ns = time_ns;
  return step;
}

Recording recorded(const fs::path& path, std::vector<Step> steps) {
  auto recorder = app::Recorder::create(path, {"test", "build", "machine"});
  EXPECT_TRUE(recorder) << sentence(recorder.error());
  haptics::StepRing& ring = (*recorder)->ring();
  ring.start({});
  for (Step& step : steps) {
    while (ring.full()) (*recorder)->hurry();
    EXPECT_TRUE(ring.push(step));
  }
  const auto finished = (*recorder)->finish();
  EXPECT_TRUE(finished) << sentence(finished.error());
  auto recording = Recording::open(path);
  EXPECT_TRUE(recording) << sentence(recording.error());
  return std::move(*recording);
}

/// Rows of a table, cell by cell.
std::vector<std::vector<std::string>> table(const fs::path& path) {
  std::vector<std::vector<std::string>> rows;
  std::ifstream file{path};
  for (std::string line; std::getline(file, line);) {
    std::istringstream cells{line};
    for (rows.emplace_back(); std::getline(cells, line, '\t');) rows.back().push_back(line);
  }
  return rows;
}
/// The cells of one channel of prefix_motion.tsv.
std::vector<std::string> channel(const fs::path& prefix, const std::string& name) {
  const auto channels = table(prefix.string() + "_channels.tsv");
  std::size_t column = 0;
  while (column + 1 < channels.size() && channels[column + 1][0] != name) ++column;
  EXPECT_LT(column + 1, channels.size()) << name;
  std::vector<std::string> cells;
  for (const auto& row : table(prefix.string() + "_motion.tsv")) cells.push_back(row[column]);
  return cells;
}

/// The numbers of the steps that are chosen of ones at these times.
std::vector<int> chosen(const std::vector<std::int64_t>& times_ms, const ExportOptions& options) {
  const ScratchFolder scratch;
  std::vector<Step> steps;
  for (const std::int64_t time : times_ms) steps.push_back(at(time * 1'000'000));
  Recording recording = recorded(scratch / "r.palpate", steps);
  const auto exported = exportMotionBids(recording, scratch / "x", options);
  if (!exported) {
    EXPECT_EQ(exported.error().reason, "empty") << sentence(exported.error());
    EXPECT_EQ(scratch.names().size(), 1U);
    return {};
  }
  std::vector<int> numbers;
  for (const std::string& cell : channel(scratch / "x", "step")) numbers.push_back(stoi(cell));
  EXPECT_EQ(exported->steps, std::int64_t(numbers.size()));
  return numbers;
}
ExportOptions within(double from, double to, double rate = 0.0) {
  ExportOptions options;
  options.from = from;
  options.to = to;
  options.rate = rate;
  return options;
}
constexpr double kEver = std::numeric_limits<double>::infinity();
using Numbers = std::vector<int>;

TEST(Selection, TakesTheLastStepAtOrBeforeEachMultipleAndNoneTwice) {
  // at 10 Hz: 0, 100, 200, … ms
  EXPECT_EQ(chosen({0, 40, 90, 140, 200, 210, 260}, within(-kEver, kEver, 10)), (Numbers{0, 2, 4}));
  // the last is taken only if it is due itself
  EXPECT_EQ(chosen({30, 60, 95, 130, 290, 300}, within(-kEver, kEver, 10)), (Numbers{2, 3, 5}));
  // two multiples in a gap; and of steps at one time the last
  EXPECT_EQ(chosen({10, 80, 450, 500, 500, 510}, within(-kEver, kEver, 10)), (Numbers{1, 4}));
  // more often than there are steps
  EXPECT_EQ(chosen({0, 1, 2, 3, 7}, within(-kEver, kEver, 5000)), (Numbers{0, 1, 2, 3, 4}));
  // multiples that are no whole ns: 333,333,333 and 666,666,667
  EXPECT_EQ(chosen({300, 333, 334, 600, 666, 667, 1000}, within(-kEver, kEver, 3)),
            (Numbers{1, 4, 6}));
  // none is due
  EXPECT_EQ(chosen({10, 20, 30}, within(-kEver, kEver, 10)), Numbers{});
}

TEST(Selection, HoldsBothEndsOfTheWindowToTheNanosecond) {
  const std::vector<std::int64_t> times{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10};
  EXPECT_EQ(chosen(times, within(0.003, 0.007)), (Numbers{3, 4, 5, 6, 7}));
  EXPECT_EQ(chosen(times, within(0.003000001, 0.006999999)), (Numbers{4, 5, 6}));
  EXPECT_EQ(chosen(times, within(-1.0, 0.001)), (Numbers{0, 1}));
  EXPECT_EQ(chosen(times, within(0.0091, 0.0099)), Numbers{});
  EXPECT_EQ(chosen(times, within(1.0, kEver)), Numbers{});
  // what is due at the end of the window comes from within it
  EXPECT_EQ(chosen({0, 40, 90, 140, 190, 260}, within(0.05, 0.25, 10)), (Numbers{2, 4}));
  EXPECT_EQ(chosen({0, 40, 90, 140, 190, 260}, within(0.05, 0.19, 10)), Numbers{2});
}

TEST(Selection, RefusesATimeThatGoesBackwards) {
  const ScratchFolder scratch;
  Recording recording = recorded(scratch / "r.palpate", {at(5), at(9), at(7), at(11)});
  for (const auto& write : {exportHdf5, exportMcap, exportMotionBids, exportCsv}) {
    const auto exported = write(recording, scratch / "x.out", {});
    ASSERT_FALSE(exported);
    EXPECT_EQ(exported.error().reason, "damaged");
  }
  EXPECT_EQ(scratch.names().size(), 1U);
}

TEST(ExportCsv, PrintsEveryDoubleSoThatItReadsAsTheSame) {
  const ScratchFolder scratch;
  std::mt19937_64 random{11};
  std::vector<Step> steps;
  std::vector<double> numbers{0.0, -0.0, 5e-324, -1.7976931348623157e308, 0.1, 1e22, 123456789.0};
  while (numbers.size() < 3000) numbers.push_back(std::bit_cast<double>(random()));
  for (const double number : numbers) {
    steps.push_back(at(std::int64_t(steps.size())));
    steps.back().sent_W.force.x() = number;
  }
  Recording recording = recorded(scratch / "r.palpate", steps);
  ASSERT_TRUE(exportMotionBids(recording, scratch / "x", {}));
  const auto cells = channel(scratch / "x", "force_x");
  ASSERT_EQ(cells.size(), numbers.size());
  int missing = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (!std::isfinite(numbers[i])) {
      EXPECT_EQ(cells[i], "n/a");
      ++missing;
      continue;
    }
    EXPECT_EQ(std::bit_cast<std::uint64_t>(std::strtod(cells[i].c_str(), nullptr)),
              std::bit_cast<std::uint64_t>(numbers[i]))
        << cells[i];
  }
  EXPECT_GT(missing, 0);
}

TEST(ExportMcap, KeepsTheSignOfZeroAndSaysNullForWhatIsNoNumber) {
  const ScratchFolder scratch;
  Step step = at(0);
  step.sent_W.force = {-0.0, std::nan(""), 4.0};
  Recording recording = recorded(scratch / "r.palpate", {step});
  ASSERT_TRUE(exportMcap(recording, scratch / "x.mcap", {}));
  std::ostringstream content;
  content << std::ifstream{scratch / "x.mcap"}.rdbuf();
  // "-0" would be read as the whole number 0
  EXPECT_NE(content.str().find(R"({"force":{"x":-0.0,"y":null,"z":4.0})"), std::string::npos);
}

TEST(Export, TellsHowFarItIsAndLeavesNothingWhenItIsStopped) {
  const ScratchFolder scratch;
  std::vector<Step> steps;
  for (int i = 0; i < 20'000; ++i) steps.push_back(at(std::int64_t{i} * 1'000'000));
  Recording recording = recorded(scratch / "r.palpate", steps);
  for (const auto& write : {exportHdf5, exportMcap, exportMotionBids, exportCsv}) {
    std::vector<double> parts;
    ExportOptions options = within(5.0, kEver);
    options.goes_on = [&](double part) {
      parts.push_back(part);
      return part < 0.5;
    };
    const auto exported = write(recording, scratch / "x.out", options);
    ASSERT_FALSE(exported);
    EXPECT_EQ(exported.error().reason, "cancelled");
    EXPECT_EQ(exported.error().kind, haptics::Error::Kind::Cancelled);
    EXPECT_GT(parts.size(), 10U);
    EXPECT_TRUE(std::is_sorted(parts.begin(), parts.end()));
    EXPECT_LT(parts.front(), 0.01);
    EXPECT_NEAR(parts.back(), 0.5, 0.05);
    EXPECT_EQ(scratch.names().size(), 1U);
  }
}

/// Lets no file grow beyond so many bytes while it lives.
class NoRoom {
 public:
  explicit NoRoom(rlim_t bytes) {
    handler_ = std::signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &before_);
    rlimit limit = before_;
    limit.rlim_cur = bytes;
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~NoRoom() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }

 private:
  rlimit before_{};
  void (*handler_)(int);
};

TEST(Export, LeavesNothingWhereThereIsNoRoomAndWorksAgainOnceThereIs) {
  const ScratchFolder scratch;
  std::mt19937_64 random{3};
  std::vector<Step> steps;
  for (int i = 0; i < 12'000; ++i) {
    steps.push_back(at(std::int64_t{i} * 1'000'000));
    steps.back().sent_W.force = haptics::Vec3::Constant(double(random()));
  }
  Recording recording = recorded(scratch / "r.palpate", steps);
  for (const auto& write : {exportHdf5, exportMcap, exportMotionBids, exportCsv}) {
    const auto whole = write(recording, scratch / "x.out", {});
    ASSERT_TRUE(whole) << sentence(whole.error());
    for (const std::string& file : whole->files) fs::remove(file);
    for (const rlim_t bytes : {0, 3000, 50'000, 200'000}) {
      const NoRoom no_room{bytes};
      const auto exported = write(recording, scratch / "x.out", {});
      ASSERT_FALSE(exported) << bytes;
      EXPECT_EQ(exported.error().reason, "unwritable");
      EXPECT_NE(sentence(exported.error()).find("File too large"), std::string::npos)
          << sentence(exported.error());
      EXPECT_EQ(scratch.names().size(), 1U) << bytes;
    }
    const auto again = write(recording, scratch / "x.out", {});
    ASSERT_TRUE(again) << sentence(again.error());
    EXPECT_EQ(again->bytes, whole->bytes);
    for (const std::string& file : again->files) EXPECT_TRUE(fs::remove(file));
  }
}

/// The kinds of events are those that recordings have, by app/recording/README.md.
TEST(ExportCsv, TheTableOfEventsExplainsEachKind) {
  const ScratchFolder scratch;
  Recording recording = recorded(scratch / "r.palpate", {at(0), at(1'000'000)});
  ASSERT_TRUE(exportMotionBids(recording, scratch / "x", {}));
  std::ifstream explained{scratch / "x_events.json"};
  const auto levels =
      nlohmann::json::parse(explained).at("trial_type").at("Levels").get<nlohmann::json>();
  std::ifstream readme{places::source("app/recording/README.md")};
  std::string line, bullet;
  while (std::getline(readme, line) && !line.starts_with("- **Events**")) continue;
  for (bullet = line; std::getline(readme, line) && line.starts_with("  ");) bullet += line;
  std::set<std::string> kinds;
  for (std::size_t from = 0; (from = bullet.find('`', from)) != std::string::npos;) {
    const std::size_t to = bullet.find('`', from + 1);
    kinds.insert(bullet.substr(from + 1, to - from - 1));
    from = to + 1;
  }
  EXPECT_TRUE(kinds.erase("start"));  // how the program began to record
  EXPECT_GT(kinds.size(), 10U);
  for (const std::string& kind : kinds) EXPECT_TRUE(levels.contains(kind)) << kind;
  EXPECT_EQ(levels.size(), kinds.size());
}

}  // namespace
}  // namespace app::exporting
