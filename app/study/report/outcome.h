// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "app/page/page.h"
#include "app/page/plot.h"

namespace study {

using page::Axis;
using page::isZero;
using page::Page;
using page::Plot;
using page::PlotPoint;
using page::Scale;
using page::Series;
using page::shortly;
using page::Table;

/// A claim with its limit: the value must not exceed the bound, or not fall below it.
struct Case {
  enum class Sense { AtMost, AtLeast };

  std::string name;  ///< unique in the study
  double value = 0.0;
  double bound = 0.0;
  std::string unit;  ///< empty for counts and ratios
  Sense sense = Sense::AtMost;
  std::string note = {};  ///< how it was done; of one that fails, what is known about it

  /// A value that is not finite fails.
  bool pass() const;
};

/// The larger of two; what is no number is larger than all, so that it shows.
inline double worse(double a, double b) {
  return std::isnan(a) || std::isnan(b) ? INFINITY : std::max(a, b);
}

/// What a job found. All of it survives the way through a results file.
struct Outcome {
  std::vector<Case> cases = {};
  /// Plots of the same title in one section are drawn as one, series of the same name joined.
  std::vector<Plot> plots = {};
  std::vector<Table> tables = {};  ///< of the same caption: joined as well
  std::vector<std::string> remarks = {};
  bool whole = true;  ///< false: it was stopped on the way, and is not kept
};

/// The shortest piece of a study that can be run by itself, on any machine, in any order.
struct Job {
  std::string name;     ///< unique in the study, the same in every shard
  std::string section;  ///< the heading under which it is reported
  double cost = 1.0;    ///< s, about: to share out jobs, and to say how much time is left
  std::function<Outcome(std::uint64_t seed)> run;
};

/// How thorough a study is: minutes, or all of it.
enum class Depth { Quick, Full };

/// A sentence of the first page about the cases whose names end alike: {worst} is the worst of
/// their values with its unit, {count} how many there are. Left out where there is none.
struct Claim {
  std::string words;
  std::string cases;  ///< the end of the names
};

/// The first screen of a report: the sentences and the plots that matter most. Of the plots, by
/// title, the first three that there are.
struct Front {
  std::vector<Claim> claims;
  std::vector<std::string> plots;
};

struct Study {
  std::string name;  ///< as the command line calls it
  std::string title;
  std::vector<std::string> introduction = {};  ///< paragraphs
  std::vector<Job> jobs = {};
  Front front = {};
};

}  // namespace study
