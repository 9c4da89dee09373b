// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/readers/volume_file.h"

#include <vtkCommand.h>
#include <vtkExecutive.h>
#include <vtkNew.h>

#include <algorithm>
#include <iterator>
#include <memory>

#include "datasets/readers/files/refusal.h"
#include "datasets/readers/files/thumbnail.h"
#include "datasets/readers/files/vtk_errors.h"
#include "datasets/readers/found.h"
#include "datasets/readers/meta_image/header.h"
#include "datasets/readers/nifti/header.h"
#include "datasets/readers/nrrd/header.h"
#include "datasets/readers/nrrd/voxels.h"
#include "datasets/readers/nrrd/vtk_reader.h"

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
  verdict.message = "One evenly spaced stack.";
  if (!stored.facts.orientation_known) {
    verdict.reasons.push_back("orientation-unknown");
    verdict.message = stored.spacing_stated
                          ? "The file does not state its orientation: left and right are unknown, "
                            "and its spacing is taken to be in millimetres."
                          : "The file states neither orientation nor spacing: left and right are "
                            "unknown, and voxels of 1 mm are assumed.";
  }
  if (stored.facts.orientation_known && !stored.spacing_stated) {
    verdict.reasons.push_back("spacing-unknown");
    verdict.message += " The file states no spacing: voxels of 1 mm are assumed.";
  }
  return verdict;
}

SeriesVerdict refusalOf(const haptics::Error& error) {
  SeriesVerdict verdict;
  verdict.file_count = 1;
  verdict.reasons.push_back(error.reason);
  verdict.message = error.what;
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

Expected<haptics::Volume> readNrrd(const VolumeInFile& chosen, const Part& part,
                                   const ReadProgress& progress) {
  vtkNew<VtkNrrdReader> reader;
  vtkNew<Relay> relay;
  vtkNew<VtkErrors> errors;
  relay->progress = &progress;
  reader->AddObserver(vtkCommand::ProgressEvent, relay);
  errors->watch(reader);
  errors->watch(reader->GetExecutive());
  reader->setPath(chosen.path);
  reader->setChoice(chosen.number, part);
  reader->Update();
  return reader->volume();
}

enum class Format { None, Nrrd, MetaImage, Nifti };

Format formatOf(const fs::path& path) {
  const fs::path extension = path.extension();
  if (looksLikeNrrd(path) || extension == ".nrrd" || extension == ".nhdr") return Format::Nrrd;
  if (looksLikeMetaImage(path)) return Format::MetaImage;
  return looksLikeNifti(path) ? Format::Nifti : Format::None;
}

Expected<StoredVolumes> describe(const fs::path& path) {
  switch (formatOf(path)) {
    case Format::MetaImage:
      return describeMetaImage(path);
    case Format::Nifti:
      return describeNifti(path);
    case Format::Nrrd:
    case Format::None:
      break;
  }
  return describeNrrd(path);
}

}  // namespace

bool isVolumeFile(const fs::path& path) { return formatOf(path) != Format::None; }

std::vector<SeriesVerdict> verdictsOf(const fs::path& path) {
  const auto stored = describe(path);
  const std::int64_t count = stored ? stored->count() : 1;
  std::vector<SeriesVerdict> verdicts;
  for (std::int64_t number = 0; number < count; ++number) {
    SeriesVerdict verdict = stored ? verdictOf(*stored) : refusalOf(stored.error());
    if (count > 1)
      verdict.message = "Volume " + std::to_string(number) + " of " + std::to_string(count) +
                        ", counted from 0. " + verdict.message;
    verdict.found = std::make_shared<Found>(Found{VolumeInFile{path, static_cast<int>(number)}});
    verdicts.push_back(std::move(verdict));
  }
  return verdicts;
}

std::vector<fs::path> filesReadFor(const VolumeInFile& chosen) {
  std::vector<fs::path> files{chosen.path};
  if (formatOf(chosen.path) == Format::Nrrd) {
    if (const auto header = readNrrdHeader(chosen.path))
      std::ranges::copy(header->data_files, std::back_inserter(files));
  } else if (const auto stored = describe(chosen.path)) {
    files.push_back(stored->voxels.file);
  }
  return files;
}

Expected<haptics::Volume> readVolume(const VolumeInFile& chosen, const Part& part,
                                     const ReadProgress& progress) {
  if (formatOf(chosen.path) == Format::Nrrd) return readNrrd(chosen, part, progress);
  const auto stored = describe(chosen.path);
  if (!stored) return tl::unexpected(stored.error());
  return readVolume(*stored, chosen.number, part, progress);
}

Expected<Thumbnail> thumbnailOf(const VolumeInFile& chosen, int longest) {
  const auto stored = describe(chosen.path);
  if (!stored) return tl::unexpected(stored.error());
  const auto& dims = stored->grid.dims;
  const Part middle{.box = Part::Box{{0, 0, dims[2] / 2}, {dims[0], dims[1], dims[2] / 2 + 1}}};
  const auto slice = readVolume(chosen, middle, {});
  if (!slice) return tl::unexpected(slice.error());
  return thumbnailOf({.type = slice->type,
                      .pixels = slice->voxels.get(),
                      .columns = dims[0],
                      .rows = dims[1],
                      .column_step = slice->grid.spacing.x(),
                      .row_step = slice->grid.spacing.y()},
                     longest);
}

}  // namespace datasets
