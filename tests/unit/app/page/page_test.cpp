// SPDX-License-Identifier: BSD-3-Clause
#include "app/page/page.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <regex>
#include <set>

namespace {

using page::escaped;
using page::Page;
using page::Plot;
using page::PlotPoint;
using page::Scale;
using page::Series;
using page::shortly;
using page::svgOf;

/// Every group of a pattern's matches, as numbers.
std::vector<std::vector<double>> numbersOf(const std::string& text, const std::string& pattern) {
  std::vector<std::vector<double>> all;
  const std::regex regex{pattern};
  for (std::sregex_iterator it{text.begin(), text.end(), regex}, end; it != end; ++it) {
    std::vector<double> row;
    for (std::size_t g = 1; g < it->size(); ++g) row.push_back(std::stod((*it)[g]));
    all.push_back(row);
  }
  return all;
}

/// The tags that are opened and not closed in their order; empty if all are.
std::string unbalanced(const std::string& xml) {
  std::vector<std::string> open;
  const std::regex tag{"<(/?)([a-zA-Z0-9]+)[^>]*?(/?)>"};
  for (std::sregex_iterator it{xml.begin(), xml.end(), tag}, end; it != end; ++it) {
    if ((*it)[3].length() > 0) continue;
    if ((*it)[1].length() == 0) {
      open.push_back((*it)[2]);
    } else if (open.empty() || open.back() != (*it)[2]) {
      return "</" + (*it)[2].str() + ">";
    } else {
      open.pop_back();
    }
  }
  return open.empty() ? "" : "<" + open.back() + ">";
}

Plot decades() {
  Plot plot{"Error against time",
            "Falls with the budget.",
            {"time [us]", Scale::Log},
            {"error [mm]", Scale::Log}};
  plot.series.push_back({"ours", {{10, 0.1}, {100, 0.01, 0.001, 0.1}, {1000, 0.001}}});
  return plot;
}

TEST(Plot, PutsEqualRatiosAtEqualDistancesOnALogarithmicAxis) {
  const auto at = numbersOf(svgOf(decades(), "p"), "<circle cx='([0-9.]+)' cy='([0-9.]+)'");
  ASSERT_EQ(at.size(), 4u);  // three points, and the legend's mark
  EXPECT_NEAR(at[1][0] - at[0][0], at[2][0] - at[1][0], 0.02);
  EXPECT_NEAR(at[1][1] - at[0][1], at[2][1] - at[1][1], 0.02);
  EXPECT_LT(at[0][0], at[1][0]);
  EXPECT_LT(at[0][1], at[1][1]);  // less is lower
  // its spread goes from a decade below to a decade above
  const auto spread = numbersOf(svgOf(decades(), "p"), "spread' d='M([0-9.]+) ([0-9.]+)V([0-9.]+)");
  ASSERT_EQ(spread.size(), 1u);
  EXPECT_NEAR(spread[0][0], at[1][0], 0.06);  // to a tenth
  EXPECT_NEAR(spread[0][1], at[2][1], 0.06);
  EXPECT_NEAR(spread[0][2], at[0][1], 0.06);
}

TEST(Plot, MarksItsAxesWithRoundFigures) {
  const std::string svg = svgOf(decades(), "p");
  for (const char* label : {">10<", ">100<", ">10³<", ">10⁻²<", ">0.1<"})
    EXPECT_NE(svg.find(label), std::string::npos) << label;
  Plot linear{"t", "d", {"x"}, {"y"}};
  linear.series.push_back({"s", {{0.0, 3.1}, {7.3, 41.0}}});
  const std::string plain = svgOf(linear, "p");
  for (const char* label : {">0<", ">2<", ">8<", ">10<", ">50<"})
    EXPECT_NE(plain.find(label), std::string::npos) << label;
}

// a penetration of exactly zero is the best there is: it must be seen, and not as 1e-300
TEST(Plot, ShowsZeroOnALogarithmicAxisInALaneOfItsOwn) {
  Plot plot = decades();
  plot.series.push_back({"exact", {{10, 0.0}, {100, 0.0}}});
  const std::string svg = svgOf(plot, "p");
  EXPECT_NE(svg.find(">0<"), std::string::npos);
  const auto lane = numbersOf(svg, "class='lane' d='M[0-9.]+ ([0-9.]+)H");
  ASSERT_EQ(lane.size(), 1u);
  const auto squares = numbersOf(svg, "<rect x='[0-9.]+' y='([0-9.]+)' width='([0-9.]+)'");
  ASSERT_EQ(squares.size(), 3u);
  for (int n = 0; n < 2; ++n) EXPECT_GT(squares[n][0], lane[0][0]);
  // what is above zero stands above the lane, or on its edge (the last circle is the legend's)
  const auto circles = numbersOf(svg, "<circle cx='[0-9.]+' cy='([0-9.]+)'");
  ASSERT_EQ(circles.size(), 4u);
  for (int n = 0; n < 3; ++n) EXPECT_LE(circles[n][0], lane[0][0]);
}

TEST(Plot, LeavesOutWhatIsNotFiniteAndKeepsTheRest) {
  Plot plot = decades();
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = INFINITY;
  plot.series[0].points.push_back({nan, 1.0});
  plot.series[0].points.push_back({100.0, inf});
  const std::string svg = svgOf(plot, "p");
  EXPECT_EQ(numbersOf(svg, "<circle cx='([0-9.]+)'").size(), 4u);
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  EXPECT_EQ(svg.find("inf"), std::string::npos);
  Plot empty{"t", "d", {"x", Scale::Log}, {"y"}};
  empty.series.push_back({"nothing", {}});
  EXPECT_EQ(unbalanced(svgOf(empty, "p")), "");
}

TEST(Plot, EverySeriesHasAMarkOfItsOwn) {
  Plot plot{"t", "d", {"x"}, {"y"}};
  for (int n = 0; n < page::kMostSeries; ++n)
    plot.series.push_back({"series " + std::to_string(n), {{1.0, 1.0}}, false});
  const std::string svg = svgOf(plot, "p");
  std::set<std::string> marks;
  const std::regex group{"<g class='s[0-7]'>\\n([^\\n]*)\\n"};
  for (std::sregex_iterator it{svg.begin(), svg.end(), group}, end; it != end; ++it)
    marks.insert((*it)[1]);
  EXPECT_EQ(marks.size(), std::size_t{page::kMostSeries});
  EXPECT_EQ(svg.find("class='line' d='M1"),
            std::string::npos);  // not joined: no line but the legend's
}

TEST(Plot, DrawsALineAloneWhereASeriesHasNoMarks) {
  Plot plot{.title = "a", .description = "b", .x = {"x"}, .y = {"y"}};
  plot.series = {{.name = "line", .points = {{.x = 0.0, .y = 1.0}, {.x = 1.0, .y = 2.0}}}};
  const std::string marked = svgOf(plot, "p");
  plot.series[0].marked = false;
  const std::string bare = svgOf(plot, "p");
  EXPECT_NE(marked.find("<circle"), std::string::npos);
  EXPECT_EQ(bare.find("<circle"), std::string::npos);
  EXPECT_NE(bare.find("class='line'"), std::string::npos);
}

TEST(Plot, ALineOfManyPointsHasMarksAtSomeOfThem) {
  Plot plot{.title = "a", .description = "b", .x = {"x"}, .y = {"y"}};
  const auto marksOf = [&](std::size_t points) {
    plot.series = {{.name = "line", .points = {}}};
    for (std::size_t n = 0; n < points; ++n)
      plot.series[0].points.push_back({.x = double(n), .y = double(n % 7)});
    const std::string svg = svgOf(plot, "p");
    const std::string line = svg.substr(svg.find("class='line'"));
    EXPECT_EQ(std::ranges::count(line.substr(0, line.find("/>")), 'L'), std::ptrdiff_t(points) - 1);
    std::size_t marks = 0;
    for (auto at = svg.find("<circle"); at != svg.npos; at = svg.find("<circle", at + 1)) ++marks;
    return marks - 1;  // one is the legend's
  };
  EXPECT_EQ(marksOf(page::kMostMarks), page::kMostMarks);
  EXPECT_GE(marksOf(1000), 10U);
  EXPECT_LE(marksOf(1000), 20U);
}

TEST(Plot, SaysWhatItIsToWhoCannotSeeIt) {
  Plot plot = decades();
  plot.title = "Error & <time>";
  const std::string svg = svgOf(plot, "plot-7");
  EXPECT_NE(svg.find("role='img'"), std::string::npos);
  EXPECT_NE(svg.find("aria-labelledby='plot-7-title plot-7-description'"), std::string::npos);
  EXPECT_NE(svg.find("<title id='plot-7-title'>Error &amp; &lt;time&gt;</title>"),
            std::string::npos);
  EXPECT_NE(svg.find("<desc id='plot-7-description'>Falls with the budget.</desc>"),
            std::string::npos);
}

TEST(Plot, UsesItsWholeWidth) {
  Plot plot{"t", "d", {"x", Scale::Log}, {"y", Scale::Log}};
  plot.series.push_back({"s", {{21.0, 0.3}, {48.0, 0.4}}, false});
  const std::string svg = svgOf(plot, "p");
  const auto at = numbersOf(svg, "<circle cx='([0-9.]+)' cy='([0-9.]+)'");
  ASSERT_EQ(at.size(), 3u);
  EXPECT_GT(at[1][0] - at[0][0], 0.8 * (640.0 - 76.0 - 22.0));
  EXPECT_GT(at[0][1] - at[1][1], 0.6 * (300.0 - 12.0 - 46.0));
  for (const char* label : {">20<", ">50<", ">0.3<", ">0.4<"})
    EXPECT_NE(svg.find(label), std::string::npos) << label;
  // a single value has an axis as well
  plot.series[0].points.pop_back();
  EXPECT_NE(svgOf(plot, "p").find(">20<"), std::string::npos);
}

TEST(Plot, NamesSettingsWhereThereIsRoomAndEveryMarkOnce) {
  Plot plot = decades();
  plot.series[0].points[0].setting = "50 us";
  plot.series[0].points[1].setting = "200 us";
  const std::string svg = svgOf(plot, "p");
  EXPECT_NE(svg.find("<title>ours, 50 us</title>"), std::string::npos);
  EXPECT_NE(svg.find(">50 us</text>"), std::string::npos);
  EXPECT_NE(svg.find(">200 us</text>"), std::string::npos);
  // no place on the whole plot: all of it is marks
  for (int x = 0; x < 200; ++x)
    for (int y = 0; y < 100; ++y)
      plot.series[0].points.push_back(
          {std::pow(10.0, 1.0 + 0.01 * x), std::pow(10.0, -3.0 + 0.02 * y), NAN, NAN, false});
  const auto full = svgOf(plot, "p");
  EXPECT_EQ(full.find(">200 us</text>"), std::string::npos);
  EXPECT_NE(full.find("<title>ours, 200 us</title>"), std::string::npos);
  const auto marks = numbersOf(full, "<circle cx='([0-9.]+)'").size();
  for (int again = 0; again < 3; ++again)
    plot.series[0].points.insert(plot.series[0].points.end(), plot.series[0].points.end() - 1000,
                                 plot.series[0].points.end());
  EXPECT_EQ(numbersOf(svgOf(plot, "p"), "<circle cx='([0-9.]+)'").size(), marks);
}

TEST(Page, DrawsNothingOfZerosAndShortensWhatIsLong) {
  Page page{"t"};
  Plot plot{"Penetration", "d", {"x"}, {"depth [mm]"}};
  plot.series.push_back({"s", {{1.0, 0.0}, {2.0, 0.0, 0.0, 0.0}}});
  page.plot(plot);
  EXPECT_EQ(page.html().find("<svg"), std::string::npos);
  EXPECT_NE(page.html().find("Penetration: depth [mm] is 0 at each of 2 points"),
            std::string::npos);
  plot.series[0].points[1].high = 0.1;
  page.plot(plot);
  EXPECT_NE(page.html().find("<svg"), std::string::npos);
  Page other{"t"};
  other.table({"long", {"n"}, std::vector<std::vector<std::string>>(1000, {"row"})});
  EXPECT_NE(other.html().find("first 400 of 1000 rows"), std::string::npos);
  EXPECT_EQ(unbalanced(other.html().substr(other.html().find("<html"))), "");
}

TEST(Shortly, WritesFourDigitsAndMarksThousands) {
  EXPECT_EQ(shortly(0.012345), "0.01235");
  EXPECT_EQ(shortly(0.0), "0");
  EXPECT_EQ(shortly(4.5e-7), "4.5e-07");
  EXPECT_EQ(shortly(2126), "2,126");
  EXPECT_EQ(shortly(-1234567), "-1,234,567");
  EXPECT_EQ(shortly(-123456), "-123,456");
  EXPECT_EQ(shortly(-999.96), "-1000");
  EXPECT_EQ(shortly(std::nan("")), "none");
  EXPECT_EQ(shortly(-INFINITY), "minus infinite");
}

TEST(Page, IsOneWellFormedFileThatAsksForNothingElse) {
  Page page{"Accuracy <of> \"ours\" & others"};
  page.heading("Penetration");
  page.paragraph("Zero & nothing < it.");
  page.command("palpate-cli study accuracy --out 'here'");
  page.table({"Table 1", {"scene", "mean [us]"}, {{"bunny", "11"}, {"<engine>", "24"}}});
  Plot plot = decades();
  plot.bound = 0.05;
  page.plot(plot);
  page.plot(decades());
  const std::string html = page.html();
  EXPECT_EQ(unbalanced(html.substr(html.find("<html"))), "");
  EXPECT_EQ(html.find("<engine>"), std::string::npos);
  EXPECT_EQ(html.find("http"), std::string::npos);
  EXPECT_EQ(html.find("src="), std::string::npos);
  EXPECT_EQ(html.find("@import"), std::string::npos);
  // both plots, each with its own name, and the figures behind them
  EXPECT_NE(html.find("id='plot-1-title'"), std::string::npos);
  EXPECT_NE(html.find("id='plot-2-title'"), std::string::npos);
  EXPECT_NE(html.find("<td>ours</td><td></td><td>100</td><td>0.01</td><td>0.001</td><td>0.1</td>"),
            std::string::npos);
  EXPECT_NE(html.find("<td>bound</td><td></td><td></td><td>0.05</td>"), std::string::npos);
  // dark mode and paper
  EXPECT_NE(html.find("prefers-color-scheme: dark"), std::string::npos);
  EXPECT_NE(html.find("@media print"), std::string::npos);
}

}  // namespace
