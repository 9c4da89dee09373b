// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "app/study/report/outcome.h"

namespace study::stability {

/// A cell of a table, under the head of its column.
struct Cell {
  const char* head;
  std::string text;
};

/// What a job finds, as it comes up. A case is named "subject/what".
struct Findings {
  std::string subject = {};
  Outcome outcome = {};

  void atMost(const std::string& what, double value, double bound, const std::string& unit = "",
              const std::string& note = "") {
    outcome.cases.push_back({subject + "/" + what, value, bound, unit, Case::Sense::AtMost, note});
  }
  void atLeast(const std::string& what, double value, double bound, const std::string& unit = "",
               const std::string& note = "") {
    outcome.cases.push_back({subject + "/" + what, value, bound, unit, Case::Sense::AtLeast, note});
  }
  void none(const std::string& what, int count) { atMost(what, count, 0.0); }
  /// Adds a row to the table with this caption. The first row brings the head.
  void row(const std::string& caption, const std::vector<Cell>& cells) {
    auto table = std::find_if(outcome.tables.begin(), outcome.tables.end(),
                              [&](const Table& each) { return each.caption == caption; });
    if (table == outcome.tables.end()) {
      table = outcome.tables.insert(table, {caption, {}, {}});
      for (const Cell& cell : cells) table->head.push_back(cell.head);
    }
    table->rows.emplace_back();
    for (const Cell& cell : cells) table->rows.back().push_back(cell.text);
  }
};

}  // namespace study::stability
