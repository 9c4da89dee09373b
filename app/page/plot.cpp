// SPDX-License-Identifier: BSD-3-Clause
#include "app/page/plot.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "app/page/text.h"

namespace page {
namespace {

// the drawing, in units of its viewBox
constexpr double kWidth = 640.0, kHeight = 300.0;
constexpr double kLeft = 76.0, kRight = 22.0, kTop = 12.0, kBottom = 46.0;
constexpr double kLane = 30.0;  // of the zeros on a logarithmic axis
constexpr double kLegendRow = 18.0;
constexpr int kLegendColumns = 3;                  // at most
constexpr double kLegendLine = 32.0;               // of a series' look, before its name
constexpr double kLetter = 7.2;                    // wide, a little more than most are in this size
constexpr double kSmall = 5.2, kSmallHigh = 10.0;  // a letter of a setting
constexpr std::size_t kMostSettings = 80;          // that are written into one plot
constexpr std::size_t kMarksOfMany = 16;           // about so many, of a line of many points

/// A power of ten as it is written: 10⁻³, but 0.1, 1, 10 and 100 as they are.
std::string powerOfTen(int exponent) {
  if (exponent >= -1 && exponent <= 2) return text("%g", std::pow(10.0, exponent));
  static const char* const kRaised[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string out = exponent < 0 ? "10⁻" : "10";
  for (const char digit : std::to_string(std::abs(exponent)))
    out += kRaised[static_cast<std::size_t>(digit - '0')];
  return out;
}

struct Tick {
  double at = 0.0;  // viewBox
  std::string label;
};

/// One side: from values to places between `from` and `to` of the viewBox.
class Side {
 public:
  Side(Scale scale, std::vector<double> values, double from, double to)
      : log_{scale == Scale::Log}, from_{from}, to_{to} {
    std::erase_if(values, [](double v) { return !std::isfinite(v); });
    if (log_) {
      const auto zeros = std::erase_if(values, [](double v) { return v <= 0.0; });
      lane_ = zeros > 0;
    }
    if (values.empty()) values = {1.0};
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    if (log_) {
      const double room = std::max(0.04 * std::log10(*most / *least), 0.03);
      low_ = std::log10(*least) - room;
      high_ = std::log10(*most) + room;
      while (marks().size() < 2) {
        low_ -= 0.1;
        high_ += 0.1;
      }
      return;
    }
    // from zero where that wastes less than half
    low_ = *least > 0.0 && *least < 0.5 * *most ? 0.0 : *least;
    high_ = *most;
    if (high_ == low_) {
      const double room = low_ != 0.0 ? 0.1 * std::abs(low_) : 1.0;
      low_ -= room;
      high_ += room;
    }
    // a step of 1, 2, 5 or 10 that gives four to eight marks
    const double rough = (high_ - low_) / 5.0,
                 decade = std::pow(10.0, std::floor(std::log10(rough)));
    const double share = rough / decade;
    step_ = decade * (share < 1.5 ? 1.0 : share < 3.5 ? 2.0 : share < 7.5 ? 5.0 : 10.0);
    low_ = std::floor(low_ / step_) * step_;
    high_ = std::ceil(high_ / step_) * step_;
  }

  double at(double value) const {
    if (!log_) return from_ + (value - low_) / (high_ - low_) * (to_ - from_);
    if (value <= 0.0) return from_ + 0.5 * lane();
    return begin() + (std::log10(value) - low_) / (high_ - low_) * (to_ - begin());
  }
  /// Where the lane of the zeros ends; none: where the side begins.
  double begin() const { return from_ + lane(); }
  bool hasLane() const { return lane_; }

  std::vector<Tick> ticks() const {
    std::vector<Tick> all;
    if (!log_) {
      const auto count = std::lround((high_ - low_) / step_);
      for (long n = 0; n <= count; ++n) {
        // what rounding makes of zero is zero
        const double value = low_ + double(n) * step_;
        all.push_back({at(value), shortly(std::abs(value) < 1e-9 * step_ ? 0.0 : value)});
      }
      return all;
    }
    if (lane_) all.push_back({at(0.0), "0"});
    if (high_ - low_ < 1.8) {
      for (const double value : marks()) all.push_back({at(value), shortly(value)});
      return all;
    }
    const int every = std::max(1, static_cast<int>(std::ceil((high_ - low_) / 8.0)));
    for (int e = static_cast<int>(std::ceil(low_)); e <= static_cast<int>(high_); e += every)
      all.push_back({at(std::pow(10.0, e)), powerOfTen(e)});
    return all;
  }

 private:
  /// Of a logarithmic side of few decades, from low to high: 1, 2 and 5 times each power of ten,
  /// or more where that is less than two.
  std::vector<double> marks() const {
    std::vector<double> marks = marksOf({1, 2, 5});
    return marks.size() < 2 ? marksOf({1, 2, 3, 4, 5, 6, 7, 8, 9}) : marks;
  }
  std::vector<double> marksOf(std::initializer_list<int> of) const {
    std::vector<double> marks;
    for (int e = static_cast<int>(std::floor(low_)); e <= static_cast<int>(std::floor(high_)); ++e)
      for (const int times : of)
        if (const double value = times * std::pow(10.0, e);
            std::log10(value) >= low_ && std::log10(value) <= high_)
          marks.push_back(value);
    return marks;
  }
  double lane() const { return lane_ ? std::copysign(kLane, to_ - from_) : 0.0; }

  bool log_, lane_ = false;
  double from_, to_;
  double low_ = 0.0, high_ = 1.0;  // values, or their powers of ten
  double step_ = 1.0;
};

/// Letters of a text in UTF-8.
std::size_t lettersIn(const std::string& text) {
  return static_cast<std::size_t>(
      std::ranges::count_if(text, [](char c) { return (c & 0xC0) != 0x80; }));
}

/// The mark of a series about a place.
std::string mark(int series, double x, double y) {
  const double r = 3.6;
  switch (series % kMostSeries) {
    case 0:
      return text("<circle cx='%.2f' cy='%.2f' r='%.2f'/>", x, y, r);
    case 1:
      return text("<rect x='%.2f' y='%.2f' width='%.2f' height='%.2f'/>", x - r, y - r, 2 * r,
                  2 * r);
    case 2:
      return text("<path d='M%.2f %.2fl%.2f %.2fh%.2fz'/>", x, y - r - 0.6, r + 0.6, 2 * r,
                  -2 * r - 1.2);
    case 3:
      return text("<path d='M%.2f %.2fl4.6 4.6l-4.6 4.6l-4.6 -4.6z'/>", x, y - 4.6);
    case 4:
      return text("<path class='open' d='M%.2f %.2fl7 7m0 -7l-7 7'/>", x - 3.5, y - 3.5);
    case 5:
      return text("<circle class='open' cx='%.2f' cy='%.2f' r='%.2f'/>", x, y, r);
    case 6:
      return text("<rect class='open' x='%.2f' y='%.2f' width='%.2f' height='%.2f'/>", x - r, y - r,
                  2 * r, 2 * r);
    default:
      return text("<path class='open' d='M%.2f %.2fh8m-4 -4v8'/>", x - 4.0, y);
  }
}

struct Box {
  double left = 0.0, top = 0.0, right = 0.0, bottom = 0.0;
  bool meets(const Box& other) const {
    return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
  }
};

/// Settings beside their marks: each at the first of four places where it meets no mark, no other
/// setting and no edge; without such a place it is left out.
class Settings {
 public:
  explicit Settings(std::vector<Box> marks) : taken_{std::move(marks)} {}
  std::string beside(double x, double y, const std::string& words) {
    const double wide = kSmall * double(lettersIn(words)), half = 0.5 * kSmallHigh;
    const Box places[] = {{x + 7.0, y - half, x + 7.0 + wide, y + half},
                          {x - 7.0 - wide, y - half, x - 7.0, y + half},
                          {x - 0.5 * wide, y - 6.0 - kSmallHigh, x + 0.5 * wide, y - 6.0},
                          {x - 0.5 * wide, y + 6.0, x + 0.5 * wide, y + 6.0 + kSmallHigh}};
    for (const Box& place : places) {
      if (place.left < kLeft || place.right > kWidth - 2.0 || place.top < 0.0 ||
          place.bottom > kHeight - kBottom)
        continue;
      if (std::ranges::any_of(taken_, [&](const Box& box) { return box.meets(place); })) continue;
      taken_.push_back(place);
      return text("<text class='setting' x='%.2f' y='%.2f'>", place.left, place.bottom - 2.0) +
             escaped(words) + "</text>\n";
    }
    return {};
  }

 private:
  std::vector<Box> taken_;
};

}  // namespace

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '\'':
        out += "&#39;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

std::string shortly(double value) {
  if (std::isnan(value)) return "none";
  if (std::isinf(value)) return value > 0.0 ? "infinite" : "minus infinite";
  if (std::abs(value) < 1000.0 || std::abs(value) >= 1e7) return text("%.4g", value);
  // whole, with its thousands marked
  std::string out = text("%.0f", value);
  for (std::size_t n = out.size(); n > 3 + (value < 0.0 ? 1U : 0U);) {
    n -= 3;
    out.insert(n, ",");
  }
  return out;
}

bool isZero(const Plot& plot) {
  bool any = false;
  for (const Series& series : plot.series)
    for (const PlotPoint& p : series.points) {
      any = true;
      const auto zero = [](double value) { return value == 0.0 || std::isnan(value); };
      if (p.y != 0.0 || !zero(p.low) || !zero(p.high)) return false;
    }
  return any;
}

std::string svgOf(const Plot& plot, const std::string& id) {
  std::vector<double> xs, ys;
  for (const Series& series : plot.series)
    for (const PlotPoint& p : series.points) {
      xs.push_back(p.x);
      ys.insert(ys.end(), {p.y, p.low, p.high});
    }
  if (plot.bound) ys.push_back(*plot.bound);
  const double right = kWidth - kRight, bottom = kHeight - kBottom;
  const Side x{plot.x.scale, xs, kLeft, right}, y{plot.y.scale, ys, bottom, kTop};

  const auto count = static_cast<int>(plot.series.size()) + (plot.bound ? 1 : 0);
  // as many columns as the longest name leaves room for
  std::size_t longest = plot.bound ? lettersIn(plot.bound_name) : 0;
  for (const Series& series : plot.series) longest = std::max(longest, lettersIn(series.name));
  const double entry = kLegendLine + kLetter * double(longest) + 8.0;
  const int columns = std::clamp(static_cast<int>((kWidth - kLeft) / entry), 1, kLegendColumns);
  const int rows = (count + columns - 1) / columns;
  const double height = kHeight + kLegendRow * rows + 6.0;
  std::string svg = text("<svg viewBox='0 0 %g %g' role='img' aria-labelledby='", kWidth, height);
  svg += id + "-title " + id + "-description'>\n<title id='" + id + "-title'>" +
         escaped(plot.title) + "</title>\n<desc id='" + id + "-description'>" +
         escaped(plot.description) + "</desc>\n";

  // the frame, its marks and what the axes are
  svg += "<g class='axes'>\n";
  for (const Tick& tick : x.ticks())
    svg += text("<path d='M%.2f %.2fV%.2f'/><text x='%.2f' y='%.2f' text-anchor='middle'>", tick.at,
                kTop, bottom, tick.at, bottom + 19.0) +
           tick.label + "</text>\n";
  for (const Tick& tick : y.ticks())
    svg += text("<path d='M%.2f %.2fH%.2f'/><text x='%.2f' y='%.2f' text-anchor='end'>", kLeft,
                tick.at, right, kLeft - 6.0, tick.at + 4.0) +
           tick.label + "</text>\n";
  if (x.hasLane())
    svg += text("<path class='lane' d='M%.2f %.2fV%.2f'/>\n", x.begin(), kTop, bottom);
  if (y.hasLane())
    svg += text("<path class='lane' d='M%.2f %.2fH%.2f'/>\n", kLeft, y.begin(), right);
  svg +=
      text("<text x='%.2f' y='%.2f' text-anchor='middle'>", 0.5 * (kLeft + right), bottom + 38.0) +
      escaped(plot.x.label) + "</text>\n";
  svg += text("<text transform='translate(14 %.2f) rotate(-90)' text-anchor='middle'>",
              0.5 * (kTop + bottom)) +
         escaped(plot.y.label) + "</text>\n</g>\n";

  if (plot.bound && std::isfinite(*plot.bound))
    svg += text("<path class='bound' d='M%.2f %.2fH%.2f'/>\n", kLeft, y.at(*plot.bound), right);

  const auto drawn = [](const PlotPoint& p) { return std::isfinite(p.x) && std::isfinite(p.y); };
  std::vector<Box> marks;
  std::size_t named = 0;
  for (const Series& series : plot.series)
    for (const PlotPoint& p : series.points) {
      if (!drawn(p)) continue;
      marks.push_back({x.at(p.x) - 4.0, y.at(p.y) - 4.0, x.at(p.x) + 4.0, y.at(p.y) + 4.0});
      named += !p.setting.empty();
    }
  Settings settings{std::move(marks)};
  for (std::size_t n = 0; n < plot.series.size(); ++n) {
    const Series& series = plot.series[n];
    const int look = static_cast<int>(n) % kMostSeries;
    svg += text("<g class='s%d'>\n", look);
    const auto isOfLine = [&](const PlotPoint& p) {
      return series.joined && p.in_line && drawn(p);
    };
    std::string line;
    for (const PlotPoint& p : series.points)
      if (isOfLine(p)) line += text("%s%.1f %.1f", line.empty() ? "M" : "L", x.at(p.x), y.at(p.y));
    if (!line.empty()) svg += "<path class='line' d='" + line + "'/>\n";
    std::set<std::pair<long, long>> places;  // of marks, to a unit of the viewBox
    const auto points = std::size_t(std::ranges::count_if(series.points, isOfLine));
    const std::size_t apart = points > kMostMarks ? points / kMarksOfMany + 1 : 1;
    std::size_t number = 0;
    for (const PlotPoint& p : series.points) {
      if (!drawn(p)) continue;
      const double at_x = x.at(p.x), at_y = y.at(p.y);
      if (std::isfinite(p.low) && std::isfinite(p.high))
        svg += text("<path class='spread' d='M%.1f %.1fV%.1f'/>", at_x, y.at(p.low), y.at(p.high));
      // a line of many points has a mark at some of them
      const bool is_marked = series.marked && (!isOfLine(p) || number++ % apart == 0);
      if (!is_marked || !places.emplace(std::lround(at_x), std::lround(at_y)).second) continue;
      if (p.setting.empty()) {
        svg += mark(look, at_x, at_y) + "\n";
        continue;
      }
      svg += "<g><title>" + escaped(series.name + ", " + p.setting) + "</title>" +
             mark(look, at_x, at_y) + "</g>\n";
      if (named <= kMostSettings) svg += settings.beside(at_x, at_y, p.setting);
    }
    svg += "</g>\n";
  }

  // the legend below
  const double column = (kWidth - kLeft) / columns;
  for (int n = 0; n < count; ++n) {
    const double left = kLeft + column * (n % columns);
    const double middle = kHeight + kLegendRow * (n / columns) + 4.0;
    const bool bound = n == static_cast<int>(plot.series.size());
    const int look = n % kMostSeries;
    svg += bound ? std::string{"<g>"} : text("<g class='s%d'>", look);
    svg += text("<path class='%s' d='M%.2f %.2fh26'/>", bound ? "bound" : "line", left, middle);
    const Series* const series = bound ? nullptr : &plot.series[static_cast<std::size_t>(n)];
    if (series != nullptr && series->marked) svg += mark(look, left + 13.0, middle);
    svg += text("<text x='%.2f' y='%.2f'>", left + kLegendLine, middle + 4.0) +
           escaped(bound ? plot.bound_name : series->name) + "</text></g>\n";
  }
  return svg + "</svg>\n";
}

}  // namespace page
