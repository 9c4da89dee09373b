// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>
#include <vector>

#include "app/page/plot.h"

namespace page {

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
  /// Sentences, numbered.
  void list(const std::vector<std::string>& sentences);
  /// A line to be typed, kept as it is.
  void command(const std::string& text);
  /// Of a long one the first rows, and how many are left out.
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
  /// The picture and its description, and behind it, folded, the figures it was drawn from.
  /// Where all values are zero, a sentence that says so instead of the picture.
  void plot(const Plot& plot);
  /// Plots side by side over the whole width, without their figures.
  void overview(const std::vector<Plot>& plots);

  std::string html() const;

 private:
  /// The picture with its title and description, which the caller ends.
  void figure(const Plot& plot);

  std::string title_, body_;
  int plots_ = 0;
};

}  // namespace page
