// SPDX-License-Identifier: BSD-3-Clause
#include <strings.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/cli/commands.h"
#include "app/cli/interrupts.h"
#include "app/cli/sources.h"
#include "app/cli/terminal.h"
#include "datasets/labels/label_writer.h"
#include "datasets/labels/phantom_labels.h"
#include "datasets/phantoms/structures.h"
#include "datasets/readers/nrrd/writer.h"
#include "datasets/readers/volume_reader.h"

namespace app::cli {
namespace {

struct ConvertOptions {
  VolumeChoice volume;
  std::vector<std::string> paths;
  std::string labels_out;
};

bool ends(const std::string& name, const std::string& ending) {
  return name.size() >= ending.size() &&
         strcasecmp(name.c_str() + name.size() - ending.size(), ending.c_str()) == 0;
}

Outcome convert(ConvertOptions options) {
  const bool phantom = !options.volume.phantom.empty();
  if (options.paths.size() != (phantom ? 1U : 2U))
    return usage("convert needs a volume (a path, or --phantom NAME) and OUT.nrrd.");
  if (!phantom) options.volume.path = options.paths.front();
  const std::string& out = options.paths.back();
  // what is no file, such as a pipe, needs no ending
  std::error_code nothing;
  const bool file =
      !std::filesystem::exists(out, nothing) || std::filesystem::is_regular_file(out, nothing);
  if (file && !ends(out, ".nrrd") && !isStandardOutput(out))
    return usage("\"" + out + "\" must end in .nrrd.");
  const std::string& labels_out = options.labels_out;
  std::vector<Target> targets{{"OUT.nrrd", out}};
  if (!labels_out.empty()) {
    if (datasets::phantomStructures(options.volume.phantom).empty())
      return usage("--labels-out writes the structures of a phantom; demo and mastoid have some.");
    if (!ends(labels_out, ".seg.nrrd"))
      return usage("\"" + labels_out + "\" must end in .seg.nrrd.");
    targets.push_back({"--labels-out", labels_out});
  }
  if (const auto wrong = overwritten(targets, options.volume, {})) return usage(*wrong);
  if (std::filesystem::is_directory(out, nothing))
    return failed("\"" + out + "\" is a folder, and is not written over; name a file.");
  auto volume = loadVolume(options.volume);
  if (!volume) return refused(volume.error());
  if (auto written = datasets::writeNrrd(**volume, out, {.cancel = &interruption()}); !written)
    return refused(written.error());
  if (!labels_out.empty()) {
    const auto labels =
        datasets::phantomLabels(options.volume.phantom, (*volume)->grid, &interruption());
    if (!labels) return refused(labels.error());
    if (auto written = datasets::writeLabels(*labels, labels_out, {.cancel = &interruption()});
        !written)
      return refused(written.error());
  }
  Outcome outcome;
  outcome.json["dims"] = (*volume)->grid.dims;
  outcome.json["scalar"] = haptics::nameOf((*volume)->type);
  outcome.json["unit"] = (*volume)->unit;
  outcome.json["modality"] = (*volume)->modality;
  outcome.aside = isStandardOutput(out);
  return outcome;
}

}  // namespace

void addConvert(CLI::App& program, Chosen& chosen) {
  auto options = std::make_shared<ConvertOptions>();
  CLI::App* command = program.add_subcommand("convert", "Write a scan or a phantom as NRRD");
  command->add_option("paths", options->paths, "PATH OUT.nrrd, or with --phantom OUT.nrrd")
      ->required()
      ->expected(1, 2)
      ->check(notEmpty());
  command->add_option("--phantom", options->volume.phantom, "A named phantom instead of PATH")
      ->check(notEmpty());
  command
      ->add_option("--labels-out", options->labels_out,
                   "Write the structures of the phantom too, NAME.seg.nrrd")
      ->check(notEmpty());
  addReading(*command, options->volume);
  command->callback([options, &chosen] { chosen = [options] { return convert(*options); }; });
}

}  // namespace app::cli
