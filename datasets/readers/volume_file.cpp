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

using HeaderPtr = std::shared_ptr<const VolumeHeader>;

HeaderPtr withStamps(FileStamp of_header, const std::vector<fs::path>& data_files,
                     VolumeHeader header) {
  header.files.push_back(std::move(of_header));
  for (const fs::path& file : data_files) header.files.push_back(stampOf(file));
  return std::make_shared<const VolumeHeader>(std::move(header));
}

Expected<HeaderPtr> nrrdHeader(const fs::path& path) {
  FileStamp stamp = stampOf(path);  // before the parse, so that a change during it is seen
  auto nrrd = parseNrrd(path);
  if (!nrrd) return tl::unexpected(std::move(nrrd.error()));
  auto parsed = std::make_shared<const ParsedNrrd>(std::move(*nrrd));
  return withStamps(std::move(stamp), parsed->header.data_files, {parsed, {}});
}

/// The header of a format whose parser gives StoredVolumes.
template <Expected<StoredVolumes> (*describe)(const fs::path&)>
Expected<HeaderPtr> storedHeader(const fs::path& path) {
  FileStamp stamp = stampOf(path);  // before the parse, as above
  auto stored = describe(path);
  if (!stored) return tl::unexpected(std::move(stored.error()));
  const std::vector<fs::path> data_files{stored->voxels.file};
  return withStamps(std::move(stamp), data_files, {std::move(*stored), {}});
}

bool isNrrd(const Beginning& file) {
  const fs::path extension = file.path.extension();
  return looksLikeNrrd(file) || extension == ".nrrd" || extension == ".nhdr";
}

}  // namespace

struct VolumeFormat {
  bool (*recognises)(const Beginning& file);
  Expected<HeaderPtr> (*header)(const fs::path& path);
};

namespace {

/// All formats of whole volumes; the first that recognises a file reads it. To add a format, add
/// its row.
constexpr VolumeFormat kVolumeFormats[] = {
    {isNrrd, nrrdHeader},
    {looksLikeMetaImage, storedHeader<describeMetaImage>},
    {looksLikeNifti, storedHeader<describeNifti>},
};

/// As the survey parsed it, or anew.
Expected<HeaderPtr> headerOf(const VolumeInFile& chosen) {
  if (chosen.header && chosen.header->isUpToDate()) return chosen.header;
  const VolumeFormat* const format = formatOf(Beginning(chosen.path));
  // a file that is none of them any more: the NRRD's parser says why
  return (format != nullptr ? *format : kVolumeFormats[0]).header(chosen.path);
}

Expected<haptics::Volume> readVolume(const VolumeHeader& header, int number, const Part& part,
                                     const ReadProgress& progress) {
  if (const auto* nrrd = std::get_if<std::shared_ptr<const ParsedNrrd>>(&header.parsed))
    return readNrrd(*nrrd, number, part, progress);
  return readVolume(header.stored(), number, part, progress);
}

}  // namespace

const VolumeFormat* formatOf(const Beginning& file) {
  const auto* const found = std::ranges::find_if(
      kVolumeFormats, [&](const VolumeFormat& format) { return format.recognises(file); });
  return found != std::end(kVolumeFormats) ? found : nullptr;
}

bool isVolumeFile(const fs::path& path) { return formatOf(Beginning(path)) != nullptr; }

const StoredVolumes& VolumeHeader::stored() const {
  if (const auto* nrrd = std::get_if<std::shared_ptr<const ParsedNrrd>>(&parsed))
    return (*nrrd)->stored;
  return std::get<StoredVolumes>(parsed);
}

bool VolumeHeader::isUpToDate() const {
  return std::ranges::all_of(files, [](const FileStamp& f) { return stampOf(f.path) == f; });
}

std::vector<SeriesVerdict> verdictsOf(const fs::path& path, const VolumeFormat& format) {
  const auto header = format.header(path);
  const std::int64_t count = header ? (*header)->stored().count() : 1;
  std::vector<SeriesVerdict> verdicts;
  for (std::int64_t number = 0; number < count; ++number) {
    SeriesVerdict verdict = header ? verdictOf((*header)->stored()) : refusalOf(header.error());
    if (count > 1)
      verdict.message = {"volume-numbered",
                         {std::to_string(number), std::to_string(count), verdict.message}};
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
  const auto& dims = (*header)->stored().grid.dims;
  const Part middle{.box = Part::Box{{0, 0, dims[2] / 2}, {dims[0], dims[1], dims[2] / 2 + 1}}};
  const auto slice = readVolume(**header, chosen.number, middle, {});
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
