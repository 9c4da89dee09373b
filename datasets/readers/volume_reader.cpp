// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/readers/volume_reader.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <exception>
#include <iterator>
#include <map>
#include <new>
#include <utility>
#include <variant>

#include "datasets/readers/dicom/file.h"
#include "datasets/readers/dicom/folder.h"
#include "datasets/readers/dicom/pixels.h"
#include "datasets/readers/files/archive.h"
#include "datasets/readers/files/folder_tree.h"
#include "datasets/readers/files/parallel.h"
#include "datasets/readers/files/refusal.h"
#include "datasets/readers/found.h"
#include "datasets/readers/nrrd/header.h"
#include "datasets/readers/volume_file.h"

namespace datasets {

namespace fs = std::filesystem;
using haptics::Expected;
using haptics::Message;

namespace {

/// No exception leaves the readers.
template <class T, class F>
Expected<T> guarded(const fs::path& path, F&& read) {
  try {
    return read();
  } catch (const std::bad_alloc&) {
    return unsupported("too-large", {"memory-too-small", {quoted(path)}});
  } catch (const std::exception&) {
    return malformed("unreadable", {"file-unreadable", {quoted(path)}});
  }
}

Message listedAlone(const SeriesVerdict& v) {
  const std::string number = std::to_string(v.index);
  const Message modality =
      v.modality.empty() ? Message{"series-no-modality", {}} : Message{v.modality};
  const std::string dims = std::to_string(v.dims[0]) + " x " + std::to_string(v.dims[1]) + " x " +
                           std::to_string(v.dims[2]);
  const Message spacing_mm =
      Message::numbers(brief(v.spacing_mm.x()).text + " x " + brief(v.spacing_mm.y()).text + " x " +
                       brief(v.spacing_mm.z()).text);
  switch (v.verdict) {
    case Verdict::Sound:
      return {"series-listed", {number, modality, dims, spacing_mm}};
    case Verdict::Correctable:
      return {"series-listed-correctable", {number, modality, dims, spacing_mm, v.reasons.front()}};
    case Verdict::Refused:
      break;
  }
  return {"series-listed-refused", {number, modality, dims, v.reasons.front()}};
}

Message listed(const SeriesVerdict& v) {
  if (v.part.empty()) return listedAlone(v);
  return {"part-and", {listedAlone(v), v.part}};
}

Message listOf(const std::vector<SeriesVerdict>& all) {
  constexpr int kMost = 20;
  Message list;
  for (const SeriesVerdict& v : all) {
    if (v.index == kMost) return {"series-and-more", {list, std::to_string(all.size() - kMost)}};
    list = list.empty() ? listed(v) : Message{"series-and-next", {std::move(list), listed(v)}};
  }
  return list;
}

Expected<SeriesVerdict> chosenOf(const fs::path& path, const std::vector<SeriesVerdict>& all,
                                 const Reading& reading) {
  if (reading.series) {
    if (*reading.series < 0 || *reading.series >= static_cast<int>(all.size()))
      return tl::unexpected(haptics::Error{
          haptics::Error::Kind::NotFound,
          {"series-unknown", {quoted(path), std::to_string(*reading.series), listOf(all)}},
          "no-such-series"});
    return all[static_cast<std::size_t>(*reading.series)];
  }
  const auto any = [](const SeriesVerdict& s) { return s.verdict != Verdict::Refused; };
  const auto sound = [&](const SeriesVerdict& s) {
    return s.verdict == Verdict::Sound ||
           (s.verdict == Verdict::Correctable && reading.geometry == Geometry::Corrected) ||
           (s.unbroken_part && reading.largest_part);
  };
  const auto loadable = std::ranges::count_if(all, sound);
  if (loadable > 1)
    return unsupported("which-series",
                       {"series-several", {quoted(path), std::to_string(loadable), listOf(all)}});
  if (loadable == 1) return *std::ranges::find_if(all, sound);
  // what could be corrected says so itself
  if (const auto one = std::ranges::find_if(all, any); one != all.end()) return *one;
  if (all.size() > 1)
    return unsupported(
        all.front().reasons.front(),
        {"series-none-loadable", {std::to_string(all.size()), quoted(path), all.front().message}});
  return all.front();
}

constexpr double kHeaders = 0.1;  // of the progress

SeriesVerdict verdictWith(DicomSeries series) {
  SeriesVerdict verdict = verdictOf(series);
  verdict.found = std::make_shared<Found>(Found{std::move(series)});
  return verdict;
}

constexpr std::size_t kMostVolumes = 20'000;  // in the files of a folder

/// Adds the volumes of one file, or says that there are too many to list.
void add(std::vector<SeriesVerdict> found, std::vector<SeriesVerdict>& volumes) {
  if (found.size() > 1 && volumes.size() + found.size() > kMostVolumes) {
    found.resize(1);
    found.front().verdict = Verdict::Refused;
    found.front().reasons = {"too-large"};
    found.front().message = {"folder-too-many-volumes", {}};
  }
  std::ranges::move(found, std::back_inserter(volumes));
}

/// Files in a folder that cannot be looked into.
struct Closed {
  int empty = 0;      ///< without a byte
  int forbidden = 0;  ///< that the user may not read
  int damaged = 0;    ///< DICOM whose header does not say to which series it belongs
};

/// A copy that broke off leaves files without a byte, one by another user files that are forbidden,
/// and a stack may lack its last slices.
void sayClosed(SeriesVerdict& series, const Closed& closed) {
  const auto say = [&](int count, const Message& sentence) {
    if (count == 0) return;
    series.message = bothOf(std::move(series.message), sentence);
    series.faults.push_back(sentence);
  };
  say(closed.empty, {"folder-empty-files", {std::to_string(closed.empty)}});
  say(closed.damaged, {"folder-damaged-files", {std::to_string(closed.damaged)}});
  say(closed.forbidden, {"folder-forbidden-files", {std::to_string(closed.forbidden)}});
}

bool isForbidden(const fs::path& path) {
  return access(path.c_str(), R_OK) != 0 && errno == EACCES;
}

/// What lies beside a file of a series.
Closed closedBeside(const fs::path& folder) {
  Closed closed;
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    std::error_code ignored;
    if (!it->is_regular_file(ignored)) continue;
    closed.empty += it->file_size(ignored) == 0 ? 1 : 0;
    closed.forbidden += isForbidden(it->path()) ? 1 : 0;
  }
  return closed;
}

fs::path folderOf(const fs::path& file) {
  return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

/// Of the files of a folder and all in it: volumes after series, each in order.
Expected<Survey> surveyOf(const fs::path& folder, const ReadProgress& progress) {
  const auto paths = filesBelow(folder, progress);
  if (!paths) return tl::unexpected(paths.error());
  Survey survey{.several = true, .series = {}};
  std::vector<DicomFile> frames;
  std::vector<SeriesVerdict> volumes;
  std::map<fs::path, Closed> closed;  // by folder
  enum class Kind : char { Readable, Empty, Forbidden };
  struct File {
    Kind kind = Kind::Readable;
    const VolumeFormat* format = nullptr;  ///< null: not a file of whole volumes
    bool holds_segments = false;           ///< and no scan
    std::vector<DicomFile> frames;
  };
  std::vector<File> files(paths->size());
  const bool done = onAllCores(paths->size(), progress, [&](std::size_t i) {
    std::error_code error;
    File& file = files[i];
    if (fs::file_size((*paths)[i], error) == 0)
      file.kind = Kind::Empty;
    else if (isForbidden((*paths)[i]))
      file.kind = Kind::Forbidden;
    if (file.kind != Kind::Readable) return true;
    const Beginning beginning((*paths)[i]);
    file.format = formatOf(beginning);
    file.holds_segments = holdsSegments(beginning);
    if (file.format == nullptr && looksLikeDicom(beginning))
      file.frames = readDicomHeader(beginning).frames;
    return true;
  });
  if (!done) return cancelled();
  for (std::size_t i = 0; i < paths->size(); ++i) {
    if (progress.isCancelled()) return cancelled();
    const fs::path& path = (*paths)[i];
    if (files[i].kind == Kind::Empty) ++closed[path.parent_path()].empty;
    if (files[i].kind == Kind::Forbidden) ++closed[path.parent_path()].forbidden;
    if (files[i].holds_segments)
      survey.structures.push_back({path, path.lexically_relative(folder).string()});
    else if (files[i].format != nullptr)
      add(verdictsOf(path, *files[i].format), volumes);
    std::ranges::move(files[i].frames, std::back_inserter(frames));
  }
  std::ranges::move(takeStructures(frames, folder), std::back_inserter(survey.structures));
  std::vector<DicomSeries> all = seriesAmong(std::move(frames));
  for (const DicomSeries& series : all)
    for (const DicomFile& file : series.files)
      if (file.fault && file.series.empty()) ++closed[file.path.parent_path()].damaged;
  for (DicomSeries& series : all) {
    const DicomFile& first = series.files.front();
    const auto beside = closed.find(first.path.parent_path());
    const bool lacks =
        !first.series.empty() && beside != closed.end();  // else it is what lies there
    survey.series.push_back(verdictWith(std::move(series)));
    if (lacks) sayClosed(survey.series.back(), beside->second);
  }
  std::ranges::move(volumes, std::back_inserter(survey.series));
  return survey;
}

/// Whether a file is an archive though it is named as a volume.
bool isArchiveOfThatName(const fs::path& path, const VolumeFormat& format) {
  return !format.header(path) && looksLikeArchive(path);
}

/// The refusal of structures without a scan.
tl::unexpected<haptics::Error> holdsNoScan(const fs::path& path) {
  return unsupported("no-pixels", {"dicom-structures", {quoted(path)}});
}

/// The refusal of a folder or an archive without a scan.
tl::unexpected<haptics::Error> noScanIn(const Survey& found, const fs::path& path) {
  if (found.structures.empty())
    return unsupported("unreadable", {"folder-no-scan", {quoted(path)}});
  return holdsNoScan(path);
}

Expected<Survey> surveyAny(const fs::path& path, const ReadProgress& progress,
                           bool layers = false) {
  std::error_code error;
  Survey survey;
  if (isForbidden(path))
    return tl::unexpected(haptics::Error{
        haptics::Error::Kind::NotFound, {"path-forbidden", {quoted(path)}}, "unreadable"});
  const Beginning beginning = fs::is_regular_file(path, error) ? Beginning(path) : Beginning();
  const bool is_dicom = beginning.is_open && looksLikeDicom(beginning);
  DicomHeader header = is_dicom ? readDicomHeader(beginning) : DicomHeader();
  const bool is_index = header.is_folder_index;
  const VolumeFormat* const format = formatOf(beginning);
  if (is_index || fs::is_directory(path, error)) {
    const fs::path folder = is_index ? folderOf(path) : path;
    auto found = surveyOf(folder, progress);
    if (!found) return found;
    if (found->series.empty()) return noScanIn(*found, folder);
    survey = std::move(*found);
  } else if (!fs::is_regular_file(path, error)) {
    return notFound(path);
  } else if (!layers && holdsSegments(beginning)) {
    return holdsNoScan(path);
  } else if (format != nullptr && !isArchiveOfThatName(path, *format)) {
    survey.series = verdictsOf(path, *format);
    survey.several = survey.series.size() > 1;
  } else if (is_dicom && !header.frames.empty() && holdsStructures(header.frames.front())) {
    return tl::unexpected(*header.frames.front().fault);
  } else if (is_dicom) {
    auto all = seriesOf(path, std::move(header), progress, &survey.structures);
    if (!all) return tl::unexpected(std::move(all.error()));
    Closed beside = closedBeside(folderOf(path));
    survey.several = all->size() > 1;
    for (DicomSeries& series : *all) {
      beside.damaged = series.damaged_beside;
      survey.series.push_back(verdictWith(std::move(series)));
      sayClosed(survey.series.back(), beside);
    }
  } else if (looksLikeArchive(path)) {
    const auto folder = unpacked(path, progress.part(0.0, 0.5));
    if (!folder) return tl::unexpected(folder.error());
    auto found = surveyOf((*folder)->path(), progress.part(0.5, 1.0));
    if (!found) return found;
    if (found->series.empty()) return noScanIn(*found, path);
    survey = std::move(*found);
    for (SeriesVerdict& series : survey.series) series.place = *folder;
    for (StructuresFound& structures : survey.structures) structures.place = *folder;
  } else if (auto packed = whyNoArchive(path)) {
    return unsupported("unreadable", std::move(*packed));
  } else {
    return unsupported("unreadable", {"file-no-scan", {quoted(path)}});
  }
  for (std::size_t i = 0; i < survey.series.size(); ++i)
    survey.series[i].index = static_cast<int>(i);
  return survey;
}

Expected<haptics::Volume> readFound(const Found& found, const Reading& reading,
                                    const ReadProgress& progress) {
  if (const auto* series = std::get_if<DicomSeries>(&found.source)) {
    if (!series->unbroken || !reading.largest_part)
      return readSeries(*series, reading.geometry, reading.part, progress);
    const DicomSeries& part = *series->unbroken;
    auto volume = readSeries(part, reading.geometry, reading.part, progress);
    if (volume)
      volume->slices_left_out = static_cast<std::int64_t>(series->files.size() - part.files.size());
    return volume;
  }
  return readVolume(std::get<VolumeInFile>(found.source), reading.part, progress);
}

/// Those of one entry of a survey.
std::vector<fs::path> filesReadFor(const Found& found) {
  if (const auto* file = std::get_if<VolumeInFile>(&found.source)) return filesReadFor(*file);
  std::vector<fs::path> files;
  for (const DicomFile& file : std::get<DicomSeries>(found.source).files)
    files.push_back(file.path);
  return files;
}

Expected<haptics::Volume> readAny(const fs::path& path, const Reading& reading,
                                  const ReadProgress& progress) {
  if (progress.isCancelled()) return cancelled();
  const auto survey = surveyAny(path, progress.part(0.0, kHeaders));
  if (!survey) return tl::unexpected(survey.error());
  const auto chosen = chosenOf(path, survey->series, reading);
  if (!chosen) return tl::unexpected(chosen.error());
  return readFound(*chosen->found, reading, progress.part(kHeaders, 1.0));
}

}  // namespace

Expected<Survey> survey(const fs::path& path, const ReadProgress& progress, bool layers) {
  return guarded<Survey>(path, [&] { return surveyAny(path, progress, layers); });
}

Expected<haptics::Volume> readVolume(const SeriesVerdict& chosen, const Reading& reading,
                                     const ReadProgress& progress) {
  return guarded<haptics::Volume>("the scan",
                                  [&] { return readFound(*chosen.found, reading, progress); });
}

Expected<haptics::Volume> readVolume(const fs::path& path, const Reading& reading,
                                     const ReadProgress& progress) {
  return guarded<haptics::Volume>(path, [&] { return readAny(path, reading, progress); });
}

std::vector<fs::path> filesReadFor(const fs::path& path, const ReadProgress& progress) {
  std::vector<fs::path> files{path};
  std::error_code error;
  if (fs::is_regular_file(path, error)) {
    const Beginning beginning(path);
    if (formatOf(beginning) == nullptr && !looksLikeDicom(beginning)) return files;
  }
  const auto found = survey(path, progress);
  if (!found) return files;
  for (const SeriesVerdict& series : found->series)
    std::ranges::move(filesReadFor(*series.found), std::back_inserter(files));
  return files;
}

std::vector<fs::path> filesReadFor(const SeriesVerdict& chosen) {
  return filesReadFor(*chosen.found);
}

Expected<Thumbnail> thumbnailOf(const SeriesVerdict& chosen, int longest) {
  return guarded<Thumbnail>("the scan", [&]() -> Expected<Thumbnail> {
    if (const auto* series = std::get_if<DicomSeries>(&chosen.found->source))
      return thumbnailOf(*series, longest);
    return thumbnailOf(std::get<VolumeInFile>(chosen.found->source), longest);
  });
}

}  // namespace datasets
