// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/readers/volume_reader.h"

#include <vtkCommand.h>
#include <vtkExecutive.h>
#include <vtkNew.h>

#include <algorithm>
#include <exception>
#include <new>

#include "datasets/readers/dicom_folder.h"
#include "datasets/readers/dicom_pixels.h"
#include "datasets/readers/nrrd_header.h"
#include "datasets/readers/nrrd_voxels.h"
#include "datasets/readers/refusal.h"
#include "datasets/readers/vtk_errors.h"
#include "datasets/readers/vtk_nrrd_reader.h"

namespace datasets {

namespace fs = std::filesystem;
using haptics::Expected;

namespace {

enum class Format { DicomFolder, DicomFile, Nrrd };

Expected<Format> formatOf(const fs::path& path) {
  std::error_code error;
  if (fs::is_directory(path, error)) return Format::DicomFolder;
  if (!fs::is_regular_file(path, error)) return notFound(path);
  const fs::path extension = path.extension();
  if (looksLikeNrrd(path) || extension == ".nrrd" || extension == ".nhdr") return Format::Nrrd;
  if (looksLikeDicom(path)) return Format::DicomFile;
  return unsupported("unreadable",
                     quoted(path) +
                         " is neither a DICOM nor an NRRD file; open the folder of a "
                         "DICOM series, one of its files, or an .nrrd or .nhdr file.");
}

/// No exception leaves the readers.
template <class T, class F>
Expected<T> guarded(const fs::path& path, F&& read) {
  try {
    return read();
  } catch (const std::bad_alloc&) {
    return unsupported("too-large", "The memory of this machine does not hold " + quoted(path) +
                                        "; close other programs or try a smaller series.");
  } catch (const std::exception&) {
    return malformed("unreadable", quoted(path) +
                                       " cannot be read; copy it to another folder and "
                                       "try again.");
  }
}

SeriesVerdict nrrdVerdict(const fs::path& path) {
  SeriesVerdict verdict;
  const auto header = readNrrdHeader(path);
  const auto description = describeNrrd(path);
  if (header) verdict.dims = header->dims;
  if (!description) {
    verdict.reasons.push_back(description.error().reason);
    verdict.message = description.error().what;
    return verdict;
  }
  verdict.verdict = Verdict::Sound;
  verdict.modality = description->facts.modality;
  verdict.spacing_mm = description->grid.spacing * 1e3;
  verdict.message = "One evenly spaced stack.";
  if (!description->facts.orientation_known) {
    verdict.reasons.push_back("orientation-unknown");
    verdict.message = description->spacing_stated
                          ? "The file does not state its orientation: left and right are unknown, "
                            "and its spacing is taken to be in millimetres."
                          : "The file states neither orientation nor spacing: left and right are "
                            "unknown, and voxels of 1 mm are assumed.";
  }
  return verdict;
}

std::string listOf(const std::vector<DicomSeries>& all) {
  std::string list;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const SeriesVerdict v = verdictOf(all[i], static_cast<int>(i));
    list +=
        (i == 0 ? "" : "; ") + std::to_string(i) + " is " +
        (v.modality.empty() ? "of no modality" : v.modality) + ", " + std::to_string(v.dims[0]) +
        " x " + std::to_string(v.dims[1]) + " x " + std::to_string(v.dims[2]) + ", " +
        (v.verdict != Verdict::Refused ? brief(v.spacing_mm.x()) + " x " + brief(v.spacing_mm.y()) +
                                             " x " + brief(v.spacing_mm.z()) + " mm"
                                       : "refused (" + v.reasons.front() + ")") +
        (v.verdict == Verdict::Correctable ? ", correctable (" + v.reasons.front() + ")" : "");
  }
  return list;
}

Expected<DicomSeries> chosen(const fs::path& folder, std::vector<DicomSeries> all,
                             std::optional<int> index, Geometry geometry) {
  if (index) {
    if (*index < 0 || *index >= static_cast<int>(all.size()))
      return tl::unexpected(haptics::Error{haptics::Error::Kind::NotFound,
                                           "The folder " + quoted(folder) + " has no series " +
                                               std::to_string(*index) + ": " + listOf(all) + ".",
                                           "no-such-series"});
    return std::move(all[static_cast<std::size_t>(*index)]);
  }
  const auto any = [](const DicomSeries& s) { return s.stack.has_value(); };
  const auto sound = [&](const DicomSeries& s) {
    return any(s) && (!s.stack->crooked || geometry == Geometry::Corrected);
  };
  const auto loadable = std::ranges::count_if(all, sound);
  if (loadable > 1)
    return unsupported("which-series",
                       "The folder " + quoted(folder) + " holds " + std::to_string(loadable) +
                           " series that can be loaded; name one: " + listOf(all) + ".");
  if (loadable == 1) return std::move(*std::ranges::find_if(all, sound));
  // what could be corrected says so itself
  if (const auto one = std::ranges::find_if(all, any); one != all.end()) return std::move(*one);
  if (all.size() > 1)
    return unsupported(all.front().stack.error().reason,
                       "None of the " + std::to_string(all.size()) + " series in " +
                           quoted(folder) +
                           " can be loaded; the first: " + all.front().stack.error().what);
  return std::move(all.front());
}

constexpr double kHeaders = 0.1;  // of the progress

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

Expected<haptics::Volume> readNrrd(const fs::path& path, const ReadProgress& progress) {
  vtkNew<VtkNrrdReader> reader;
  vtkNew<Relay> relay;
  vtkNew<VtkErrors> errors;
  relay->progress = &progress;
  reader->AddObserver(vtkCommand::ProgressEvent, relay);
  errors->watch(reader);
  errors->watch(reader->GetExecutive());
  reader->setPath(path);
  reader->Update();
  return reader->volume();
}

Expected<haptics::Volume> readAny(const fs::path& path, std::optional<int> series,
                                  Geometry geometry, const ReadProgress& progress) {
  const auto format = formatOf(path);
  if (!format) return tl::unexpected(format.error());
  if (progress.isCancelled()) return cancelled();
  if (*format == Format::Nrrd) return readNrrd(path, progress);
  if (*format == Format::DicomFile) {
    const auto one = seriesOf(path, progress.part(0.0, kHeaders));
    if (!one) return tl::unexpected(one.error());
    return readSeries(*one, geometry, progress.part(kHeaders, 1.0));
  }
  auto all = scanFolder(path, progress.part(0.0, kHeaders));
  if (!all) return tl::unexpected(std::move(all.error()));
  const auto one = chosen(path, std::move(*all), series, geometry);
  if (!one) return tl::unexpected(one.error());
  return readSeries(*one, geometry, progress.part(kHeaders, 1.0));
}

Expected<Survey> surveyAny(const fs::path& path) {
  const auto format = formatOf(path);
  if (!format) return tl::unexpected(format.error());
  Survey survey;
  if (*format == Format::Nrrd) {
    survey.series.push_back(nrrdVerdict(path));
  } else if (*format == Format::DicomFile) {
    const auto one = seriesOf(path);
    if (!one) return tl::unexpected(one.error());
    survey.series.push_back(verdictOf(*one, 0));
  } else {
    survey.folder = true;
    const auto all = scanFolder(path);
    if (!all) return tl::unexpected(all.error());
    for (std::size_t i = 0; i < all->size(); ++i)
      survey.series.push_back(verdictOf((*all)[i], static_cast<int>(i)));
  }
  return survey;
}

}  // namespace

Expected<Survey> survey(const fs::path& path) {
  return guarded<Survey>(path, [&] { return surveyAny(path); });
}

Expected<haptics::Volume> readVolume(const fs::path& path, std::optional<int> series,
                                     Geometry geometry, const ReadProgress& progress) {
  return guarded<haptics::Volume>(path, [&] { return readAny(path, series, geometry, progress); });
}

}  // namespace datasets
