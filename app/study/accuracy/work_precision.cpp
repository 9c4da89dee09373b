// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/accuracy/work_precision.h"

#include <algorithm>
#include <cmath>

#include "app/study/comparison/measures.h"

namespace study::accuracy {
namespace {

/// "12.3, 15, 20, 31": median, 90 %, 99 % and greatest.
std::string quantilesOf(const std::vector<double>& sorted) {
  std::string text;
  for (const double q : {0.5, 0.9, 0.99, 1.0})
    text += (text.empty() ? "" : ", ") + shortly(comparison::quantile(sorted, q));
  return text;
}

/// "12, 12.5, 14": least, median and most of the runs.
std::string spreadOf(std::vector<double> runs) {
  if (runs.size() < 2) return "one run";
  std::ranges::sort(runs);
  return shortly(runs.front()) + ", " + shortly(comparison::quantile(runs, 0.5)) + ", " +
         shortly(runs.back());
}

/// samples, gradients, pivots, sub-steps, work.
std::vector<std::string> countsOf(const std::optional<comparison::MeanCounts>& counts) {
  if (!counts) return {"", "", "", "", ""};
  const auto cell = [](double count) { return std::isnan(count) ? "" : shortly(count); };
  return {cell(counts->samples), cell(counts->gradients), cell(counts->pivots),
          cell(counts->sub_steps), counts->work > 0.0 ? shortly(counts->work) : ""};
}

}  // namespace

double rms(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double v : values) sum += v * v;
  return std::sqrt(sum / double(values.size()));
}

std::vector<bool> paretoFront(const std::vector<std::pair<double, double>>& points) {
  std::vector<bool> front;
  for (const auto& p : points)
    front.push_back(std::ranges::none_of(points, [&](const auto& other) {
      return other.first <= p.first && other.second <= p.second && other != p;
    }));
  return front;
}

void addTo(Outcome& outcome, const WorkPrecision& work) {
  const bool of_hands =
      std::ranges::any_of(work.points, [](const WorkPoint& point) { return !point.hands.empty(); });
  Plot plot{work.title,
            work.description +
                (of_hands ? " Marks are the median of the hands' means, and bars go from the least "
                            "of them to the greatest."
                          : " Bars go from the median error to that of 99 %.") +
                " A line joins what no other setting of the same method outdoes.",
            {work.cost_label, Scale::Log},
            {work.error_label, Scale::Log}};
  Table table{work.title + ": quantiles (50, 90, 99, 100 %)",
              {"method", "setting", work.cost_label, "runs: least, median, most of the mean",
               work.error_label, "on the front", "samples", "gradients", "pivots", "sub-steps",
               "units of work"},
              {}};
  if (of_hands) table.head.push_back("hands: least, median, most of the mean");
  std::vector<std::string> methods;
  for (const WorkPoint& point : work.points)
    if (std::ranges::find(methods, point.method) == methods.end()) methods.push_back(point.method);
  for (const std::string& method : methods) {
    Series series{method, {}};
    std::vector<std::pair<double, double>> places;
    std::vector<std::vector<std::string>> rows;
    for (const WorkPoint& point : work.points) {
      if (point.method != method) continue;
      std::vector<double> cost = point.cost, error = point.error;
      // what is no number is worse than any
      for (double& e : error)
        if (std::isnan(e)) e = INFINITY;
      std::ranges::sort(cost);
      std::ranges::sort(error);
      std::vector<double> hands = point.hands;
      std::ranges::sort(hands);
      const auto& shown = hands.empty() ? error : hands;
      const double middle = comparison::quantile(shown, 0.5);
      const double mean =
          point.runs.empty() ? comparison::mean(cost) : comparison::median(point.runs);
      places.emplace_back(mean, middle);
      series.points.push_back({mean, middle, hands.empty() ? middle : hands.front(),
                               hands.empty() ? comparison::quantile(error, 0.99) : hands.back(),
                               true, point.setting});
      rows.push_back(
          {method, point.setting, quantilesOf(cost), spreadOf(point.runs), quantilesOf(error), ""});
      for (std::string& count : countsOf(point.counts)) rows.back().push_back(std::move(count));
      if (of_hands) rows.back().push_back(spreadOf(point.hands));
    }
    const std::vector<bool> front = paretoFront(places);
    for (std::size_t n = 0; n < front.size(); ++n) {
      series.points[n].in_line = front[n];
      rows[n][5] = front[n] ? "yes" : "no";
    }
    std::ranges::sort(series.points, {}, &PlotPoint::x);
    plot.series.push_back(std::move(series));
    table.rows.insert(table.rows.end(), rows.begin(), rows.end());
  }
  outcome.plots.push_back(std::move(plot));
  outcome.tables.push_back(std::move(table));
}

}  // namespace study::accuracy
