// SPDX-License-Identifier: BSD-3-Clause
#include <memory>

#include "app/cli/commands.h"
#include "app/cli/interrupts.h"
#include "app/cli/sources.h"
#include "app/cli/terminal.h"
#include "datasets/edits/edit_history.h"
#include "datasets/surface/surface_file.h"
#include "haptics/process/output_file.h"

namespace app::cli {
namespace {

struct SurfaceOptions {
  VolumeChoice volume;
  double isovalue = 0.0;
  std::string out, frame = "lps", view;
  bool largest = false;
};

Outcome writeSurface(const SurfaceOptions& options) {
  if (options.volume.path.empty() == options.volume.phantom.empty())
    return usage("surface needs a volume: a path, or --phantom NAME.");
  const auto format = datasets::surfaceFormatOf(options.out);
  if (!format) return usage("\"" + options.out + "\" must end in .stl, .obj or .ply.");
  std::vector<std::string> inputs;
  if (!options.view.empty()) inputs.push_back(options.view);
  if (const auto wrong = overwritten({{"--out", options.out}}, options.volume, inputs))
    return usage(*wrong);
  auto volume = loadVolume(options.volume);
  if (!volume) return refused(volume.error());
  const datasets::EditWatch watch{.cancel = &interruption()};
  if (!options.view.empty()) {
    const auto view = viewOver(options.view, **volume);
    if (!view) return refused(view.error());
    volume = datasets::edited(*volume, view->edits, watch);
    if (!volume) return refused(volume.error());
  }
  const auto surface = datasets::Surface::of(*volume, options.isovalue, options.largest, watch);
  if (!surface) return refused(surface.error());
  const std::int64_t bytes = bytesOf(*surface, *format);
  tell(std::to_string(surface->triangles()) + " triangles, " +
       (*format == datasets::SurfaceFormat::Obj ? "about " : "") +
       std::to_string((bytes + 999'999) / 1'000'000) + " MB.");
  const auto frame =
      options.frame == "ras" ? datasets::SurfaceFrame::Ras : datasets::SurfaceFrame::Lps;
  const auto written = datasets::writeSurface(*surface, options.out, *format, frame, watch);
  if (!written) return refused(written.error());
  Outcome outcome;
  outcome.json["triangles"] = surface->triangles();
  outcome.json["corners"] = surface->corners();
  outcome.json["bytes"] = *written;
  outcome.json["frame"] = options.frame;
  outcome.json["orientation_known"] = (*volume)->orientation_known;
  return outcome;
}

}  // namespace

void addSurface(CLI::App& program, Chosen& chosen) {
  auto options = std::make_shared<SurfaceOptions>();
  CLI::App* command =
      program.add_subcommand("surface", "Write the surface at an isovalue as STL, OBJ or PLY");
  command->add_option("path", options->volume.path, "A scan")->check(notEmpty());
  command->add_option("--phantom", options->volume.phantom, "A named phantom instead of PATH")
      ->check(notEmpty());
  addReading(*command, options->volume);
  command->add_option("--isovalue", options->isovalue, "Where the surface lies")
      ->required()
      ->check(finiteNumber());
  command
      ->add_option("--out", options->out,
                   "File to write, in mm; its ending names the format: .stl, .obj or .ply")
      ->required()
      ->check(notEmpty());
  command->add_option("--frame", options->frame, "Axes of the file; lps by default")
      ->check(CLI::IsMember({"lps", "ras"}));
  command->add_flag("--largest", options->largest, "Only the largest connected piece");
  command
      ->add_option("--view", options->view,
                   "Without the parts that were removed in this saved view, NAME.palpate-view")
      ->check(notEmpty());
  command->callback([options, &chosen] { chosen = [options] { return writeSurface(*options); }; });
}

}  // namespace app::cli
