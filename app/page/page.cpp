// SPDX-License-Identifier: BSD-3-Clause
#include "app/page/page.h"

#include <algorithm>
#include <span>

namespace page {
namespace {

constexpr std::size_t kMostRows = 400;  // of a table: the page stays one that can be opened

// Series are told apart by colour (after Okabe and Ito, for all kinds of colour vision), by mark,
// and by dashes; the colours are lighter on a dark ground.
constexpr const char* kStyle = R"(
:root { color-scheme: light dark; --ground: #fff; --ink: #1a1a1a; --quiet: #6b6b6b; --rule: #ddd;
  --c0: #0072b2; --c1: #d55e00; --c2: #009e73; --c3: #cc79a7; --c4: #a07400; --c5: #2f8fc4;
  --c6: #7a4fa3; --c7: #1a1a1a; --bad: #b00020; }
@media (prefers-color-scheme: dark) { :root { --ground: #16181b; --ink: #e8e8e8; --quiet: #a0a0a0;
  --rule: #3a3d42; --c0: #58b4f0; --c1: #ff8b3d; --c2: #35c79b; --c3: #e6a3c8; --c4: #e0b040;
  --c5: #86cdf5; --c6: #b892dc; --c7: #e8e8e8; --bad: #ff6b7d; } }
@media print { :root { --ground: #fff; --ink: #000; --quiet: #444; --rule: #bbb; --c0: #0072b2;
  --c1: #d55e00; --c2: #009e73; --c3: #cc79a7; --c4: #a07400; --c5: #2f8fc4; --c6: #7a4fa3;
  --c7: #000; --bad: #b00020; } details { display: none; } figure, tr { break-inside: avoid; }
  div.wide { overflow: visible; } table { font-size: 8pt; } }
body { background: var(--ground); color: var(--ink); font: 15px/1.5 system-ui, sans-serif;
  max-width: 62rem; margin: 2rem auto; padding: 0 1rem; }
h1 { font-size: 1.6rem; } h2 { font-size: 1.2rem; margin-top: 2.2rem; }
figure { margin: 1.2rem 0; } div.pictures { display: flex; flex-wrap: wrap; gap: 1rem; }
div.pictures figure { margin: 0; } div.letters { position: relative; width: 256px; height: 256px; }
div.letters span { position: absolute; color: #fff; font-weight: 600; text-shadow: 0 0 3px #000; }
.left { left: 4px; top: 46%; } .right { right: 4px; top: 46%; } .upper { top: 2px; left: 48%; }
.lower { bottom: 2px; left: 48%; } a { color: var(--c0); } figcaption { font-weight: 600; }
div.wide { overflow-x: auto; }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; }
caption { text-align: left; font-weight: 600; padding: .3rem 0; }
th, td { text-align: left; padding: .15rem .8rem .15rem 0; border-bottom: 1px solid var(--rule); }
pre { overflow-x: auto; border: 1px solid var(--rule); padding: .5rem; }
summary { color: var(--quiet); cursor: pointer; }
svg { width: 100%; height: auto; font: 12px system-ui, sans-serif; fill: var(--ink); }
svg path { fill: none; } .axes path { stroke: var(--rule); } .axes .lane { stroke: var(--quiet); }
.bound { stroke: var(--bad); stroke-width: 1.6; stroke-dasharray: 8 3; }
div.overview { display: grid; grid-template-columns: repeat(auto-fit, minmax(24rem, 1fr)); gap: 1rem;
  width: min(94vw, 96rem); margin-left: calc(50% - min(47vw, 48rem)); }
div.overview figure { margin: 0; max-width: 40rem; }
.setting { font-size: 9px; fill: var(--quiet); } .see { color: var(--quiet); margin: .2rem 0; }
.line { stroke-width: 1.6; } .spread { stroke-width: 1; opacity: .6; }
)";

/// Colour and dashes of each series.
std::string seriesStyle() {
  static const char* const kDashes[kMostSeries] = {"none", "6 3",     "2 3", "10 3 2 3",
                                                   "none", "6 2 2 2", "3 6", "12 4"};
  std::string css;
  for (int n = 0; n < kMostSeries; ++n) {
    const std::string s = ".s" + std::to_string(n), colour = "var(--c" + std::to_string(n) + ")";
    css += s + " circle, " + s + " rect, " + s + " path { stroke: " + colour + "; fill: " + colour +
           "; }\n";
    css += s + " .open, " + s + " .line, " + s + " .spread { fill: none; }\n";
    css += s + " .line { stroke-dasharray: " + kDashes[n] + "; }\n";
  }
  return css;
}

}  // namespace

void Page::heading(const std::string& text) { body_ += "<h2>" + escaped(text) + "</h2>\n"; }
void Page::paragraph(const std::string& text) { body_ += "<p>" + escaped(text) + "</p>\n"; }
void Page::command(const std::string& text) {
  body_ += "<pre><code>" + escaped(text) + "</code></pre>\n";
}

void Page::list(const std::vector<std::string>& sentences) {
  body_ += "<ol>\n";
  for (const std::string& sentence : sentences) body_ += "<li>" + escaped(sentence) + "</li>\n";
  body_ += "</ol>\n";
}

void Page::table(const Table& table) {
  body_ += "<div class='wide'><table>";
  if (!table.caption.empty()) body_ += "<caption>" + escaped(table.caption) + "</caption>";
  body_ += "<thead><tr>";
  for (const std::string& cell : table.head) body_ += "<th scope='col'>" + escaped(cell) + "</th>";
  body_ += "</tr></thead>\n<tbody>\n";
  for (const auto& row : std::span{table.rows}.first(std::min(table.rows.size(), kMostRows))) {
    body_ += "<tr>";
    for (const std::string& cell : row) body_ += "<td>" + escaped(cell) + "</td>";
    body_ += "</tr>\n";
  }
  body_ += "</tbody></table></div>\n";
  if (table.rows.size() > kMostRows)
    paragraph("These are the first " + std::to_string(kMostRows) + " of " +
              std::to_string(table.rows.size()) + " rows; results.json has all.");
}

void Page::pictures(const std::vector<Picture>& pictures) {
  body_ += "<div class='pictures'>\n";
  for (const Picture& picture : pictures) {
    body_ += "<figure><div class='letters'><img src='" + escaped(picture.file) + "' alt='" +
             escaped(picture.name) + "'/>";
    static constexpr const char* kEdges[] = {"left", "right", "upper", "lower"};
    for (std::size_t edge = 0; edge < 4; ++edge)
      if (!picture.letters[edge].empty())
        body_ += std::string("<span class='") + kEdges[edge] + "'>" +
                 escaped(picture.letters[edge]) + "</span>";
    body_ += "</div><figcaption>" + escaped(picture.name) + "</figcaption></figure>\n";
  }
  body_ += "</div>\n";
}

void Page::links(const std::vector<Link>& links) {
  body_ += "<ul>\n";
  for (const Link& link : links)
    body_ += "<li><a href='" + escaped(link.to) + "'>" + escaped(link.words) + "</a></li>\n";
  body_ += "</ul>\n";
}

void Page::plot(const Plot& plot) {
  Table figures{{}, {"series", "setting", plot.x.label, plot.y.label, "from", "to"}, {}};
  for (const Series& series : plot.series)
    for (const PlotPoint& p : series.points)
      figures.rows.push_back(
          {series.name, p.setting, shortly(p.x), shortly(p.y), shortly(p.low), shortly(p.high)});
  if (isZero(plot)) {
    paragraph(plot.title + ": " + plot.y.label + " is 0 at each of " +
              std::to_string(figures.rows.size()) + " points, so there is nothing to draw.");
    return;
  }
  if (plot.bound) figures.rows.push_back({plot.bound_name, "", "", shortly(*plot.bound), "", ""});
  figure(plot);
  body_ += "<details><summary>The figures</summary>\n";
  table(figures);
  body_ += "</details>\n</figure>\n";
}

void Page::overview(const std::vector<Plot>& plots) {
  body_ += "<div class='overview'>\n";
  for (const Plot& plot : plots) {
    figure(plot);
    body_ += "</figure>\n";
  }
  body_ += "</div>\n";
}

void Page::figure(const Plot& plot) {
  const std::string id = "plot-" + std::to_string(++plots_);
  body_ += "<figure>\n<figcaption>" + escaped(plot.title) + "</figcaption>\n" + svgOf(plot, id) +
           "<p class='see'>" + escaped(plot.description) + "</p>\n";
}

std::string Page::html() const {
  return "<!DOCTYPE html>\n<html lang='en'>\n<head>\n<meta charset='utf-8'/>\n"
         "<meta name='viewport' content='width=device-width, initial-scale=1'/>\n<title>" +
         escaped(title_) + "</title>\n<style>" + kStyle + seriesStyle() +
         "</style>\n</head>\n<body>\n<h1>" + escaped(title_) + "</h1>\n" + body_ +
         "</body>\n</html>\n";
}

}  // namespace page
