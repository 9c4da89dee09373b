// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace page {

enum class Scale { Linear, Log };

/// What is measured along one side of a plot.
struct Axis {
  std::string label;  ///< with its unit
  Scale scale = Scale::Linear;
};

/// A measured value, and between what it varied: the quantiles of its runs, say. Not a number:
/// not known.
struct PlotPoint {
  double x = 0.0, y = 0.0;
  double low = std::numeric_limits<double>::quiet_NaN();
  double high = std::numeric_limits<double>::quiet_NaN();
  bool in_line = true;       ///< false: a mark beside the line, of what another point outdoes
  std::string setting = {};  ///< with which it was measured; empty: the same as its series
};

struct Series {
  std::string name;
  std::vector<PlotPoint> points;
  bool joined = true;  ///< by a line, in the order of the points
  bool marked = true;  ///< false: the line alone
};

/// A diagram, and in words what there is to see.
struct Plot {
  std::string title;
  std::string description;  ///< stands below it: what the axes are and what shows
  Axis x, y;
  std::vector<Series> series = {};
  std::optional<double> bound = {};  ///< a level of y that must not be exceeded
  std::string bound_name = "bound";
};

/// Whether every value, with what it varied between, is exactly zero; false without values.
bool isZero(const Plot& plot);

/// How many series of one plot can be told apart: by colour, mark and dashes, each alone enough.
inline constexpr int kMostSeries = 8;
/// A line of more points than this has a mark at every so many of them.
inline constexpr std::size_t kMostMarks = 40;

/// The plot as an <svg> element for a page whose style sheet is that of `Page`; `id` is unique in
/// the page. On a logarithmic axis what is zero or less stands in a lane of its own at the lower
/// end, marked 0. Values that are not finite are not drawn, nor a second mark on one place; a line
/// of more than kMostMarks points has marks at some of them. Settings stand beside their marks
/// where there is room, and are the marks' titles. Series beyond kMostSeries repeat the first
/// marks.
std::string svgOf(const Plot& plot, const std::string& id);

/// Text that may stand in HTML or an attribute.
std::string escaped(const std::string& text);

/// A figure with four significant digits, short: "0.0123", "4.5e-07", "2,126", "none" for what is
/// not a number.
std::string shortly(double value);

}  // namespace page
