// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
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
  /// Pictures side by side, files beside the page, each with a name below and the letters at its
  /// left, right, upper and lower edge; empty letters are left out.
  struct Picture {
    std::string file, name;
    std::array<std::string, 4> letters = {};
  };
  void pictures(const std::vector<Picture>& pictures);
  /// A list of links to other pages, each with its words.
  struct Link {
    std::string to, words;
  };
  void links(const std::vector<Link>& links);
  /// The picture, and behind it, folded, the figures it was drawn from.
  void plot(const Plot& plot);

  std::string html() const;

 private:
  std::string title_, body_;
  int plots_ = 0;
};

}  // namespace study
