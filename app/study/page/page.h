// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "app/study/page/plot.h"

namespace study {

struct Table {
  std::string caption;
  std::vector<std::string> head;
  std::vector<std::vector<std::string>> rows;  ///< as many cells as the head
};

/// A report: one HTML file that needs nothing else, for the screen, dark or light, and for paper.
/// Everything given is text, not markup.
class Page {
 public:
  explicit Page(std::string title) : title_{std::move(title)} {}

  void heading(const std::string& text);
  void paragraph(const std::string& text);
  /// A line to be typed, kept as it is.
  void command(const std::string& text);
  void table(const Table& table);
  /// The picture, and behind it, folded, the figures it was drawn from.
  void plot(const Plot& plot);

  std::string html() const;

 private:
  std::string title_, body_;
  int plots_ = 0;
};

}  // namespace study
