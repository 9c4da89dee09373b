// SPDX-License-Identifier: BSD-3-Clause
#include <charconv>
#include <cmath>
#include <cstdio>
#include <memory>

#include "app/cli/commands.h"
#include "app/cli/interrupts.h"
#include "app/cli/sources.h"
#include "app/cli/terminal.h"
#include "haptics/process/output_file.h"
#include "resources/messages/messages.h"
#include "resources/named_tools.h"

namespace app::cli {
namespace {

struct ToolOptions {
  ToolChoice tool;
  std::string out;
};

std::string shownMm(double length) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", length * 1e3);
  return text;
}

/// The named tools, those of one use under its name.
Outcome listTools() {
  Outcome outcome;
  auto& tools = outcome.json["tools"] = nlohmann::ordered_json::array();
  std::string use;
  for (const resources::NamedTool& tool : resources::namedTools()) {
    tools.push_back({{"name", tool.name},
                     {"use", tool.use},
                     {"title", tool.title},
                     {"length_mm", std::round(tool.length * 1e6) / 1e3},
                     {"tip_mm", std::round(tool.tip * 1e6) / 1e3}});
    if (tool.use != use) outcome.text += (use = tool.use) + '\n';
    char line[128];
    std::snprintf(line, sizeof line, "  %-14s%-18slength %5s mm, tip %4s mm\n", tool.name.c_str(),
                  tool.title.c_str(), shownMm(tool.length).c_str(), shownMm(tool.tip).c_str());
    outcome.text += line;
  }
  return outcome;
}

Outcome writeShell(const ToolOptions& options) {
  if (options.out.empty()) return usage("tool writes a tool's points: add --out FILE.csv.");
  if (const auto wrong = contradictionIn(options.tool)) return usage(*wrong);
  if (const auto wrong = overwritten({{"--out", options.out}}, {}, {options.tool.name}))
    return usage(*wrong);
  auto loaded = loadTool(options.tool);
  if (!loaded) return refused(loaded.error());
  const haptics::PointShell& shell = loaded->tool.shell;
  std::string text = "x_m,y_m,z_m\n";
  for (const haptics::Vec3& p : shell.points)
    for (int axis = 0; axis < 3; ++axis) {
      char number[32];
      const auto [end, error] = std::to_chars(number, number + sizeof number, p[axis]);
      text.append(number, end);
      text += axis < 2 ? ',' : '\n';
    }
  if (interrupted()) return stopped();
  if (auto written = haptics::writeFile(options.out, text); !written)
    return refused(written.error());

  Outcome outcome;
  outcome.json["points"] = shell.points.size();
  outcome.json["triangles"] = loaded->tool.mesh.triangles.size();
  outcome.json["radius_mm"] = shell.radius * 1e3;
  outcome.json["spacing_mm"] = shell.spacing * 1e3;
  const haptics::Vec3 origin_mm = shell.origin * 1e3;
  outcome.json["origin_mm"] = {origin_mm.x(), origin_mm.y(), origin_mm.z()};
  auto& warnings = outcome.json["warnings"] = nlohmann::ordered_json::array();
  for (const haptics::Message& warning : loaded->warnings)
    warnings.push_back(resources::sentence(warning));
  outcome.aside = isStandardOutput(options.out);
  return outcome;
}

}  // namespace

void addTool(CLI::App& program, Chosen& chosen) {
  auto options = std::make_shared<ToolOptions>();
  CLI::App* command = program.add_subcommand(
      "tool", "Write a tool's point shell; without a tool, list the named ones");
  CLI::Option* tool = command
                          ->add_option("tool", options->tool.name,
                                       resources::namesOfTools() + ", or a mesh or CSV file")
                          ->check(notEmpty());
  command->add_option("--points", options->tool.points, "Number of points, spread evenly by area")
      ->needs(tool)
      ->check(wholeNumber(1, 10'000'000));
  command->add_option("--tool-unit", options->tool.unit, "Unit of a mesh file")
      ->needs(tool)
      ->check(CLI::IsMember({"m", "mm", "cm", "in"}));
  command->add_option("--out", options->out, "CSV to write")->needs(tool)->check(notEmpty());
  command->callback([options, &chosen] {
    chosen = [options] { return options->tool.name.empty() ? listTools() : writeShell(*options); };
  });
}

}  // namespace app::cli
