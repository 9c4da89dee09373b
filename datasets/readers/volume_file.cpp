// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/readers/volume_file.h"

#include <vtkCommand.h>
#include <vtkExecutive.h>
#include <vtkNew.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <utility>

#include "datasets/readers/files/refusal.h"
#include "datasets/readers/files/thumbnail.h"
#include "datasets/readers/files/vtk_errors.h"
#include "datasets/readers/found.h"
#include "datasets/readers/nrrd/header.h"
#include "datasets/readers/nrrd/vtk_reader.h"
#include "datasets/readers/volume_header.h"

namespace datasets {

namespace fs = std::filesystem;
using haptics::Expected;

namespace {

/// What holds of every volume of the file.
SeriesVerdict verdictOf(const StoredVolumes& stored) {
  SeriesVerdict verdict;
  verdict.verdict = Verdict::Sound;
  verdict.file_count = 1;
  verdict.dims = stored.grid.dims;
  verdict.bytes = stored.grid.voxelCount() *
                  static_cast<std::int64_t>(haptics::sizeOf(stored.voxels.layout.type));
  verdict.modality = stored.facts.modality;
  verdict.spacing_mm = stored.grid.spacing * 1e3;
  verdict.message = {"volume-evenly-spaced", {}};
  if (!stored.facts.orientation_known) {
    verdict.reasons.push_back("orientation-unknown");
    verdict.message = stored.spacing_stated
                          ? haptics::Message{"volume-orientation-unknown", {}}
                          : haptics::Message{"volume-orientation-and-spacing-unknown", {}};
  }
  if (stored.facts.orientation_known && !stored.spacing_stated) {
    verdict.reasons.push_back("spacing-unknown");
    verdict.message = bothOf(std::move(verdict.message), {"volume-spacing-unknown", {}});
  }
  if (stored.voxels.layout.doubles)
    verdict.message = bothOf(std::move(verdict.message), {"volume-doubles-rounded", {}});
  for (const haptics::Message& note : stored.notes)
    verdict.message = bothOf(std::move(verdict.message), note);
  return verdict;
}

SeriesVerdict refusalOf(const haptics::Error& error) {
  SeriesVerdict verdict;
  verdict.file_count = 1;
  verdict.reasons.push_back(error.reason);
  verdict.message = error.message;
  return verdict;
}

/// Passes VTK's progress on, and the wish to stop back.
class Relay : public vtkCommand {
 public:
  static Relay* New() { return new Relay; }
  void Execute(vtkObject* caller, unsigned long, void* fraction) override {
    auto* reader = static_cast<vtkAlgorithm*>(caller);
    progress->advanced(*static_cast<double*>(fraction));
    if (progress->isCancelled()) reader->SetAbortExecute(1);
  }
  const ReadProgress* progress = nullptr;
};

Expected<haptics::Volume> readNrrd(std::shared_ptr<const ParsedNrrd> nrrd, int number,
                                   const Part& part, const ReadProgress& progress) {
  vtkNew<VtkNrrdReader> reader;
  vtkNew<Relay> relay;
  vtkNew<VtkErrors> errors;
  relay->progress = &progress;
  reader->AddObserver(vtkCommand::ProgressEvent, relay);
  errors->watch(reader);
  errors->watch(reader->GetExecutive());
  reader->setParsed(std::move(nrrd));
  reader->setChoice(number, part);
  reader->Update();
  return reader->volume();
}

/// As the survey parsed it, or anew.
Expected<HeaderPtr> headerOf(const VolumeInFile& chosen) {
  if (chosen.header && chosen.header->isUpToDate()) return chosen.header;
  return datasets::headerOf(chosen.path);
}

Expected<haptics::Volume> readVolume(const VolumeHeader& header, int number, const Part& part,
                                     const ReadProgress& progress) {
  if (const auto* nrrd = std::get_if<std::shared_ptr<const ParsedNrrd>>(&header.parsed))
    return readNrrd(*nrrd, number, part, progress);
  return readVolume(header.stored(), number, part, progress);
}

}  // namespace

std::vector<SeriesVerdict> verdictsOf(const fs::path& path, const VolumeFormat& format) {
  const auto header = format.header(path);
  const std::int64_t count = header ? (*header)->stored().count() : 1;
  std::vector<SeriesVerdict> verdicts;
  for (std::int64_t number = 0; number < count; ++number) {
    SeriesVerdict verdict = header ? verdictOf((*header)->stored()) : refusalOf(header.error());
    if (count > 1)
      verdict.message = {"volume-numbered",
                         {std::to_string(number + 1), std::to_string(count), verdict.message}};
    verdict.found = std::make_shared<Found>(
        Found{VolumeInFile{path, static_cast<int>(number), header ? *header : nullptr}});
    verdicts.push_back(std::move(verdict));
  }
  return verdicts;
}

std::vector<fs::path> filesReadFor(const VolumeInFile& chosen) {
  std::vector<fs::path> files{chosen.path};
  if (chosen.header) {
    for (const FileStamp& file : chosen.header->files) files.push_back(file.path);
  } else if (const auto header = readNrrdHeader(chosen.path)) {
    // teem refused what follows the names of the data files
    std::ranges::copy(header->data_files, std::back_inserter(files));
  }
  return files;
}

Expected<haptics::Volume> readVolume(const VolumeInFile& chosen, const Part& part,
                                     const ReadProgress& progress) {
  const auto header = headerOf(chosen);
  if (!header) return tl::unexpected(header.error());
  return readVolume(**header, chosen.number, part, progress);
}

Expected<Thumbnail> thumbnailOf(const VolumeInFile& chosen, int longest) {
  const auto header = headerOf(chosen);
  if (!header) return tl::unexpected(header.error());
  const StoredVolumes& stored = (*header)->stored();
  const auto& dims = stored.grid.dims;
  std::optional<haptics::Mat3> direction;
  if (stored.facts.orientation_known) direction = stored.grid.direction;
  const std::int64_t k = middleOf(dims[2], direction);
  const Part middle{.box = Part::Box{{0, 0, k}, {dims[0], dims[1], k + 1}}};
  const auto slice = readVolume(**header, chosen.number, middle, {});
  if (!slice) return tl::unexpected(slice.error());
  return thumbnailOf({.type = slice->type,
                      .pixels = slice->voxels.get(),
                      .columns = dims[0],
                      .rows = dims[1],
                      .column_step = slice->grid.spacing.x(),
                      .row_step = slice->grid.spacing.y(),
                      .direction = direction},
                     longest);
}

}  // namespace datasets
