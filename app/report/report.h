// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/report/session.h"

namespace app::report {

/// A structure of a report.
struct Structure {
  int number = 0;                    ///< by which the user knows it, from 1
  std::string name = {};             ///< the user's own; empty: none. Never one of a file
  double error = 0.0, told = 0.0;    ///< m, as of haptics::DistanceMap
  std::vector<double> margins = {};  ///< m
};

/// One session, or two beside each other, over the same structures.
struct Report {
  std::vector<Structure> structures;
  std::vector<Session> sessions;
};

/// A figure in words. The sources are places in kSources, from 1.
struct Definition {
  const char* key;  ///< in JSON and CSV, with its unit
  const char* title;
  const char* unit;
  const char* means;
  const char* sources;
};
/// A figure of a session, in the unit of its definition.
struct FigureOfSession {
  Definition definition;
  Moment (*of)(const Figures&);
};
/// A figure of a structure.
struct FigureOfStructure {
  Definition definition;
  Moment (*of)(const FiguresOf&);
};
std::vector<FigureOfSession> figuresOfSessions();
std::vector<FigureOfStructure> figuresOfStructures();
/// Of the times within margins, which are as many as there are margins.
Definition withinMargin();
/// Where the figures come from.
std::vector<std::string> sources();
/// Cautions about the numbers, and that they are no grade.
std::vector<std::string> remarks();

/// By how much a distance is wrong at most [mm]: inside twice as much, as of haptics::DistanceMap.
double errorOf_mm(const Structure& structure, double distance_mm);

nlohmann::ordered_json jsonOf(const Report& report);
/// A row for each figure of each session.
std::string csvOf(const Report& report);
/// A page that needs nothing else.
std::string htmlOf(const Report& report);

}  // namespace app::report
