// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/readers/dicom/folder.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "datasets/readers/files/parallel.h"
#include "datasets/readers/files/refusal.h"
#include "datasets/readers/files/thumbnail.h"

namespace datasets {

namespace fs = std::filesystem;
using haptics::Expected;

namespace {

/// The first fault among the files, saying how many share its reason; else their stack.
Expected<Stack> judge(const std::vector<DicomFile>& files) {
  const auto faulty =
      std::ranges::find_if(files, [](const DicomFile& f) { return f.fault.has_value(); });
  if (faulty != files.end()) {
    haptics::Error error = *faulty->fault;
    const auto alike = std::ranges::count_if(
        files, [&](const DicomFile& f) { return f.fault && f.fault->reason == error.reason; });
    if (files.size() > 1)
      error.message = {"dicom-fault-shared",
                       {error.message, std::to_string(alike), std::to_string(files.size())}};
    return tl::unexpected(std::move(error));
  }
  std::vector<SlicePlane> planes;
  planes.reserve(files.size());
  for (const DicomFile& file : files) {
    if (file.bits_allocated != files.front().bits_allocated ||
        file.is_signed != files.front().is_signed)
      return unsupported("mixed-size", {"dicom-voxel-types-mixed", {}});
    planes.push_back(file.plane);
  }
  auto stack = stackOf(planes);
  if (!stack) return stack;
  if (const auto grid = gridOf(stack->geometry); !grid) return tl::unexpected(grid.error());
  return stack;
}

bool isSamePlace(const SlicePlane& a, const SlicePlane& b) {
  constexpr double kSame = 1e-6;  // mm, and of a unit vector
  return (a.position_mm - b.position_mm).norm() < kSame &&
         (a.along_row - b.along_row).norm() < kSame &&
         (a.along_column - b.along_column).norm() < kSame;
}

/// Whether the stored pixels of two files are the same bytes. Tools that change the pixels of an
/// image and keep its identifier are not rare.
bool isSameStored(const DicomFile& a, const DicomFile& b) {
  std::ifstream one(a.path, std::ios::binary), other(b.path, std::ios::binary);
  // what was written anew has its pixels elsewhere
  if (!a.rewritten && !b.rewritten) {
    one.seekg(a.pixels_begin);
    other.seekg(b.pixels_begin);
  }
  std::vector<char> block(std::size_t{1} << 16), beside(block.size());
  while (one && other) {
    one.read(block.data(), static_cast<std::streamsize>(block.size()));
    other.read(beside.data(), static_cast<std::streamsize>(beside.size()));
    if (one.gcount() != other.gcount() ||
        !std::equal(block.begin(), block.begin() + one.gcount(), beside.begin()))
      return false;
  }
  return one.eof() && other.eof();
}

/// Keeps one of several copies of an image: of those with the same identifier, place and pixels one
/// that can be read. How many were left out.
int leaveOutCopies(std::vector<DicomFile>& files) {
  std::map<std::pair<std::string, int>, std::size_t> kept;
  std::vector<DicomFile> once;
  std::map<std::pair<fs::path, fs::path>, bool> compared;
  const auto same = [&](const DicomFile& a, const DicomFile& b) {
    if (!isSamePlace(a.plane, b.plane)) return false;
    const auto [it, is_new] = compared.try_emplace({a.path, b.path}, false);
    if (is_new) it->second = isSameStored(a, b);
    return it->second;
  };
  int copies = 0;
  for (DicomFile& file : files) {
    const auto [it, is_new] = kept.try_emplace({file.instance, file.frame}, once.size());
    if (is_new || file.instance.empty()) {
      once.push_back(std::move(file));
      continue;
    }
    DicomFile& before = once[it->second];
    const bool faulty = file.fault.has_value() || before.fault.has_value();
    const bool elsewhere = file.placed && before.placed && !isSamePlace(file.plane, before.plane);
    if (elsewhere || (!faulty && !same(file, before))) {
      once.push_back(std::move(file));
      continue;
    }
    ++copies;
    if (before.fault && !file.fault) before = std::move(file);
  }
  files = std::move(once);
  return copies;
}

Expected<std::vector<fs::path>> filesOf(const fs::path& folder) {
  std::vector<fs::path> paths;
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    std::error_code ignored;
    if (it->is_regular_file(ignored)) paths.push_back(it->path());
  }
  if (error) return notFound(folder);
  std::ranges::sort(paths);
  return paths;
}

/// Frames of the DICOM files among these, in their order, read by all cores; of the one file whose
/// frames are `known`, those.
Expected<std::vector<DicomFile>> framesOf(const std::vector<fs::path>& paths,
                                          const std::vector<DicomFile>& known,
                                          const ReadProgress& progress) {
  std::vector<std::vector<DicomFile>> of_each(paths.size());
  const bool done = onAllCores(paths.size(), progress, [&](std::size_t i) {
    if (!known.empty() && paths[i] == known.front().path) {
      of_each[i] = known;
      return true;
    }
    const Beginning beginning(paths[i]);
    if (looksLikeDicom(beginning)) of_each[i] = readDicomHeader(beginning).frames;
    return true;
  });
  if (!done) return cancelled();
  std::vector<DicomFile> headers;
  for (std::vector<DicomFile>& some : of_each) std::ranges::move(some, std::back_inserter(headers));
  return headers;
}

/// Whether a file whose header could be read in part only may belong to these.
bool mayBelong(const DicomFile& broken, const DicomFile& to) {
  const auto agrees = [](const std::string& known, const std::string& other) {
    return known.empty() || known == "\n" || known == other;
  };
  const SliceIdentity &a = broken.identity, &b = to.identity;
  return !broken.series.empty() && broken.series == to.series && agrees(a.patient, b.patient) &&
         agrees(a.study, b.study) && agrees(a.frame_of_reference, b.frame_of_reference) &&
         agrees(a.modality, b.modality) && agrees(a.kernel, b.kernel) &&
         agrees(a.image_type, b.image_type);
}

/// Files by series, and by all else that slices of one stack have in common, since identifiers of
/// series are blank, or given twice, in files that are made anonymous. What is known of a broken
/// file puts it to every series that may lack it.
std::vector<std::vector<DicomFile>> separated(std::vector<DicomFile> files) {
  std::map<std::pair<std::string, SliceIdentity>, std::vector<DicomFile>> by_identity;
  std::vector<DicomFile> broken;
  for (DicomFile& file : files) {
    if (file.fault) {
      broken.push_back(std::move(file));
      continue;
    }
    // a series without an identifier is one of its folder
    const std::string series =
        file.series.empty() ? "/" + file.path.parent_path().string() : file.series;
    by_identity[{series, file.identity}].push_back(std::move(file));
  }
  std::map<std::string, std::vector<DicomFile>> alone;
  for (const DicomFile& file : broken) {
    bool belongs = false;
    for (auto& [key, sound] : by_identity)
      if (mayBelong(file, sound.front())) {
        sound.push_back(file);
        belongs = true;
      }
    if (!belongs)
      alone[file.series.empty() ? "/" + file.path.parent_path().string() : file.series].push_back(
          file);
  }
  std::vector<std::vector<DicomFile>> all;
  for (auto& [key, some] : by_identity) all.push_back(std::move(some));
  for (auto& [key, some] : alone) all.push_back(std::move(some));
  for (std::vector<DicomFile>& some : all)
    std::ranges::stable_sort(some, {},
                             [](const DicomFile& f) { return std::pair(f.path, f.frame); });
  return all;
}

/// The largest part without a gap of files that lack slices; none where it is no sound stack.
std::shared_ptr<const DicomSeries> unbrokenPartOf(const std::vector<DicomFile>& files) {
  std::vector<SlicePlane> planes;
  for (const DicomFile& file : files) planes.push_back(file.plane);
  DicomSeries part;
  for (const std::size_t i : longestRun(planes)) part.files.push_back(files[i]);
  if (part.files.size() < 2) return {};
  part.stack = judge(part.files);
  if (!part.stack || part.stack->crooked) return {};
  return std::make_shared<const DicomSeries>(std::move(part));
}

DicomSeries judgedTogether(std::vector<DicomFile> files) {
  DicomSeries series;
  series.files = std::move(files);
  series.copies_left_out = leaveOutCopies(series.files);
  series.stack = judge(series.files);
  if (!series.stack && series.stack.error().reason == "missing-slices")
    series.unbroken = unbrokenPartOf(series.files);
  return series;
}

/// From the lowest slice to the highest along their normal, mm.
std::pair<double, double> extentOf(const std::vector<DicomFile>& files) {
  const SlicePlane& any = files.front().plane;
  const haptics::Vec3 normal = any.along_row.cross(any.along_column);
  std::pair<double, double> extent{std::numeric_limits<double>::infinity(),
                                   -std::numeric_limits<double>::infinity()};
  for (const DicomFile& file : files) {
    const double height_mm = normal.dot(file.plane.position_mm);
    extent = {std::min(extent.first, height_mm), std::max(extent.second, height_mm)};
  }
  return extent;
}

/// The series that files of one identity make: one, or one for each acquisition, where acquisitions
/// lie in each other's place and each is an even stack. Acquisitions one after the other are turns
/// of a scanner that counts them.
std::vector<DicomSeries> judged(std::vector<DicomFile> files) {
  std::map<std::string, std::vector<DicomFile>> by_acquisition;
  const bool faulty =
      std::ranges::any_of(files, [](const DicomFile& f) { return f.fault.has_value(); });
  if (!faulty)
    for (const DicomFile& file : files) by_acquisition[file.acquisition].push_back(file);
  bool overlap = false;
  std::vector<std::pair<double, double>> extents;
  for (const auto& [number, some] : by_acquisition) extents.push_back(extentOf(some));
  std::ranges::sort(extents);
  double highest_mm = -std::numeric_limits<double>::infinity();
  for (const auto& [low_mm, high_mm] : extents) {
    overlap = overlap || low_mm <= highest_mm;
    highest_mm = std::max(highest_mm, high_mm);
  }
  if (by_acquisition.size() < 2 || !overlap) return {judgedTogether(std::move(files))};

  std::vector<DicomSeries> apart;
  bool each_even = true;
  for (auto& [number, some] : by_acquisition) {
    apart.push_back(judgedTogether(std::move(some)));
    each_even = each_even && apart.back().files.size() > 1 && apart.back().stack &&
                !apart.back().stack->crooked;
  }
  if (each_even) return apart;
  DicomSeries together = judgedTogether(std::move(files));
  together.unbroken.reset();  // it may hold slices of several
  if (together.stack)
    together.stack = unsupported("mixed-acquisitions", {"dicom-acquisitions-interleaved", {}});
  return {std::move(together)};
}

int fileCount(const DicomSeries& series) {
  std::set<fs::path> paths;
  for (const DicomFile& file : series.files) paths.insert(file.path);
  return static_cast<int>(paths.size());
}

/// A number with one decimal.
haptics::Message tenths(double number) {
  char text[64];
  const auto end = std::to_chars(text, text + sizeof text, number, std::chars_format::fixed, 1);
  return haptics::Message::numbers({text, end.ptr});
}

UnbrokenPart partOf(const DicomSeries& series) {
  const DicomSeries& part = *series.unbroken;
  const haptics::Vec3 normal = part.stack->geometry.steps_mm.col(2).normalized();
  const auto height_mm = [&](std::size_t i) { return normal.dot(part.files[i].plane.position_mm); };
  return {.slices = static_cast<std::int64_t>(part.files.size()),
          .of = static_cast<std::int64_t>(series.files.size()),
          .from_mm = height_mm(part.stack->order.front()),
          .to_mm = height_mm(part.stack->order.back()),
          .spacing_mm = part.stack->geometry.steps_mm.colwise().norm().transpose()};
}

/// Of the voxels once they are read: what is not 8 bits becomes 16, or float where it must.
std::int64_t voxelBytesOf(const DicomSeries& series) {
  const DicomFile& first = series.files.front();
  std::int64_t pixels = first.plane.columns * first.plane.rows;
  auto slices = static_cast<std::int64_t>(series.files.size());
  if (series.stack) {
    pixels = series.stack->geometry.dims[0] * series.stack->geometry.dims[1];
    slices = series.stack->geometry.dims[2];
  }
  const auto is_fraction = [](const DicomFile& f) {
    return f.slope != std::nearbyint(f.slope) || f.intercept != std::nearbyint(f.intercept);
  };
  const bool rescaled = std::ranges::any_of(series.files, &DicomFile::rescaled);
  const std::int64_t stored = first.bits_allocated / 8;
  const std::int64_t each = std::ranges::any_of(series.files, is_fraction)
                                ? 4
                                : std::max<std::int64_t>(stored, rescaled ? 2 : 1);
  return pixels * slices * each;
}

tl::unexpected<haptics::Error> noSeries(const fs::path& path) {
  return malformed("unreadable", {"dicom-no-series", {quoted(path)}});
}

}  // namespace

std::vector<DicomSeries> seriesAmong(std::vector<DicomFile> frames) {
  std::vector<DicomSeries> all;
  for (std::vector<DicomFile>& files : separated(std::move(frames)))
    for (DicomSeries& series : judged(std::move(files))) all.push_back(std::move(series));
  std::ranges::sort(all, {}, [](const DicomSeries& s) {
    return std::pair(s.files.front().series_number, s.files.front().path);
  });
  return all;
}

Expected<std::vector<DicomSeries>> seriesAmong(const std::vector<fs::path>& paths,
                                               const ReadProgress& progress) {
  auto frames = framesOf(paths, {}, progress);
  if (!frames) return tl::unexpected(std::move(frames.error()));
  return seriesAmong(std::move(*frames));
}

Expected<DicomSeries> seriesOf(const fs::path& path, const ReadProgress& progress) {
  const Beginning beginning(path);
  if (!looksLikeDicom(beginning)) return noSeries(path);
  return seriesOf(path, readDicomHeader(beginning), progress);
}

Expected<DicomSeries> seriesOf(const fs::path& path, DicomHeader header,
                               const ReadProgress& progress) {
  std::vector<DicomFile>& frames = header.frames;
  if (frames.empty()) return unsupported("no-pixels", {"dicom-index-or-no-image", {quoted(path)}});
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  const auto paths = filesOf(folder);
  if (!paths) return tl::unexpected(paths.error());
  // as the folder names it
  for (DicomFile& frame : frames) frame.path = folder / path.filename();
  auto headers = framesOf(*paths, frames, progress);
  if (!headers) return tl::unexpected(std::move(headers.error()));
  const DicomFile& named = frames.front();
  const auto isNamed = [&](const DicomFile& file) {
    return file.path.filename() == path.filename();
  };
  const auto damaged = std::ranges::count_if(*headers, [&](const DicomFile& file) {
    return file.fault && file.series.empty() && !isNamed(file);
  });
  for (std::vector<DicomFile>& files : separated(std::move(*headers))) {
    if (std::ranges::none_of(files, isNamed)) continue;
    // files without identifiers stand for themselves
    if (named.series.empty())
      std::erase_if(files, [&](const DicomFile& file) { return !isNamed(file); });
    const auto copies = std::erase_if(files, [&](const DicomFile& file) {
      // many are made anonymous by giving all images one identifier
      const bool comparable = file.placed && named.placed;
      const bool same_instance =
          !comparable && !file.instance.empty() && file.instance == named.instance;
      const bool same_place = comparable && isSamePlace(file.plane, named.plane);
      return !isNamed(file) && file.acquisition == named.acquisition &&
             (same_instance || same_place);
    });
    for (DicomSeries& series : judged(std::move(files))) {
      if (std::ranges::none_of(series.files, isNamed)) continue;
      series.copies_left_out += static_cast<int>(copies);
      series.damaged_beside = static_cast<int>(damaged);
      return std::move(series);
    }
  }
  return noSeries(path);
}

const DicomFile& middleSliceOf(const DicomSeries& series) {
  const std::size_t count = series.files.size();
  if (!series.stack) return series.files[count / 2];
  const auto direction = directionOf(series.files.front().plane);
  const std::int64_t middle = middleOf(static_cast<std::int64_t>(count), direction);
  return series.files[series.stack->order[static_cast<std::size_t>(middle)]];
}

SeriesVerdict verdictOf(const DicomSeries& series) {
  const DicomFile& first = series.files.front();
  SeriesVerdict verdict;
  verdict.labels = first.labels;
  verdict.windows = middleSliceOf(series.unbroken ? *series.unbroken : series).windows;
  verdict.file_count = fileCount(series);
  verdict.bytes = voxelBytesOf(series);
  for (const DicomFile& file : series.files)
    if (file.fault)
      verdict.faults.push_back({"file-fault", {quoted(file.path), file.fault->message}});
  verdict.modality = first.modality;
  verdict.dims = {first.plane.columns, first.plane.rows,
                  static_cast<std::int64_t>(series.files.size())};
  verdict.spacing_mm = {first.plane.column_step_mm, first.plane.row_step_mm,
                        first.plane.thickness_mm};
  if (!series.stack) {
    verdict.reasons.push_back(series.stack.error().reason);
    verdict.message = series.stack.error().message;
    if (series.unbroken) {
      const UnbrokenPart part = partOf(series);
      verdict.message =
          bothOf(std::move(verdict.message), {"dicom-largest-part",
                                              {std::to_string(part.slices), std::to_string(part.of),
                                               tenths(part.from_mm), tenths(part.to_mm)}});
      verdict.unbroken_part = part;
    }
    return verdict;
  }
  verdict.verdict = series.stack->crooked ? Verdict::Correctable : Verdict::Sound;
  verdict.dims = series.stack->geometry.dims;
  verdict.spacing_mm = series.stack->geometry.steps_mm.colwise().norm().transpose();
  verdict.message = {"dicom-one-stack", {std::to_string(series.files.size())}};
  if (series.files.size() == 1)
    verdict.message = first.plane.thickness_mm > 0.0
                          ? haptics::Message{"dicom-single-slice", {}}
                          : haptics::Message{"dicom-single-slice-unstated", {}};
  if (series.stack->crooked) {
    verdict.reasons.push_back(series.stack->crooked->why.reason);
    verdict.message = series.stack->crooked->why.message;
  }
  if (series.copies_left_out > 0) {
    verdict.reasons.push_back("duplicate");
    verdict.message =
        series.copies_left_out == 1
            ? haptics::Message{"dicom-copy-left-out", {verdict.message}}
            : haptics::Message{"dicom-copies-left-out",
                               {verdict.message, std::to_string(series.copies_left_out)}};
  }
  return verdict;
}

}  // namespace datasets
