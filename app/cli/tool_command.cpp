// SPDX-License-Identifier: BSD-3-Clause
#include <charconv>
#include <cstdio>
#include <memory>

#include "app/cli/commands.h"
#include "app/cli/interrupts.h"
#include "app/cli/sources.h"
#include "app/cli/terminal.h"
#include "haptics/core/output_file.h"
#include "resources/messages/messages.h"

namespace app::cli {
namespace {

struct ToolOptions {
  ToolChoice tool;
  std::string out;
};

Outcome writeShell(const ToolOptions& options) {
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
  auto& warnings = outcome.json["warnings"] = nlohmann::ordered_json::array();
  for (const haptics::Message& warning : loaded->warnings)
    warnings.push_back(resources::sentence(warning));
  outcome.aside = isStandardOutput(options.out);
  return outcome;
}

}  // namespace

void addTool(CLI::App& program, Chosen& chosen) {
  auto options = std::make_shared<ToolOptions>();
  CLI::App* command = program.add_subcommand("tool", "Write a tool's point shell");
  command->add_option("tool", options->tool.name, "A named tool, or a mesh or CSV file")
      ->required()
      ->check(notEmpty());
  command->add_option("--points", options->tool.points, "Number of points, spread evenly by area")
      ->check(wholeNumber(1, 10'000'000));
  command->add_option("--tool-unit", options->tool.unit, "Unit of a mesh file")
      ->check(CLI::IsMember({"m", "mm", "cm", "in"}));
  command->add_option("--out", options->out, "CSV to write")->required()->check(notEmpty());
  command->callback([options, &chosen] { chosen = [options] { return writeShell(*options); }; });
}

}  // namespace app::cli
