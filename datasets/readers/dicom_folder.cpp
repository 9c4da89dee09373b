// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/readers/dicom_folder.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <utility>

#include "datasets/readers/parallel.h"
#include "datasets/readers/refusal.h"

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
    if (files.size() > 1 && error.what.ends_with('.')) {
      error.what.pop_back();
      error.what +=
          " (" + std::to_string(alike) + " of " + std::to_string(files.size()) + " files).";
    }
    return tl::unexpected(std::move(error));
  }
  std::vector<SlicePlane> planes;
  planes.reserve(files.size());
  for (const DicomFile& file : files) {
    if (file.bits_allocated != files.front().bits_allocated ||
        file.is_signed != files.front().is_signed)
      return unsupported("mixed-size",
                         "The series mixes voxel types; put them into folders of their own.");
    planes.push_back(file.plane);
  }
  return stackOf(planes);
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
    if (!faulty && !same(file, before)) {
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

/// Headers of the DICOM files among these, in their order, read by all cores.
Expected<std::vector<DicomFile>> headersOf(const std::vector<fs::path>& paths,
                                           const ReadProgress& progress) {
  std::vector<std::vector<DicomFile>> of_each(paths.size());
  const bool done = onAllCores(paths.size(), progress, [&](std::size_t i) {
    if (looksLikeDicom(paths[i])) of_each[i] = readDicomHeader(paths[i]);
    return true;
  });
  if (!done) return cancelled();
  std::vector<DicomFile> headers;
  for (std::vector<DicomFile>& some : of_each) std::ranges::move(some, std::back_inserter(headers));
  return headers;
}

int fileCount(const DicomSeries& series) {
  return static_cast<int>(std::ranges::count(series.files, 0, &DicomFile::frame));
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

}  // namespace

Expected<std::vector<DicomSeries>> seriesAmong(const std::vector<fs::path>& paths,
                                               const ReadProgress& progress) {
  auto headers = headersOf(paths, progress);
  if (!headers) return tl::unexpected(std::move(headers.error()));
  std::map<std::string, DicomSeries> by_series;
  for (DicomFile& file : *headers) {
    // a series without an identifier is one of its folder
    const std::string key =
        file.series.empty() ? "/" + file.path.parent_path().string() : file.series;
    by_series[key].files.push_back(std::move(file));
  }

  std::vector<DicomSeries> all;
  for (auto& [uid, series] : by_series) {
    series.copies_left_out = leaveOutCopies(series.files);
    series.stack = judge(series.files);
    all.push_back(std::move(series));
  }
  std::ranges::sort(all, {}, [](const DicomSeries& s) {
    return std::pair(s.files.front().series_number, s.files.front().path);
  });
  return all;
}

Expected<DicomSeries> seriesOf(const fs::path& path, const ReadProgress& progress) {
  const std::vector<DicomFile> frames = readDicomHeader(path);
  if (frames.empty())
    return unsupported("no-pixels", quoted(path) +
                                        " holds no image: it is the index of a folder, or no "
                                        "DICOM after all; open the folder of one series.");
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  const auto paths = filesOf(folder);
  if (!paths) return tl::unexpected(paths.error());
  auto headers = headersOf(*paths, progress);
  if (!headers) return tl::unexpected(std::move(headers.error()));
  const DicomFile& named = frames.front();
  DicomSeries series;
  for (DicomFile& file : *headers) {
    if (file.series != named.series) continue;
    const bool is_named = file.path.filename() == path.filename();
    // files without identifiers stand for themselves
    if (!is_named && file.series.empty()) continue;
    const bool same_instance = !file.instance.empty() && file.instance == named.instance;
    const bool same_place = !named.fault && isSamePlace(file.plane, named.plane);
    if (!is_named && (same_instance || same_place)) {
      ++series.copies_left_out;
      continue;
    }
    series.files.push_back(std::move(file));
  }
  if (series.files.empty())
    return malformed("unreadable", quoted(path) +
                                       " is no DICOM file, or not any more; open the folder of one "
                                       "series.");
  series.copies_left_out += leaveOutCopies(series.files);
  series.stack = judge(series.files);
  return series;
}

SeriesVerdict verdictOf(const DicomSeries& series) {
  const DicomFile& first = series.files.front();
  SeriesVerdict verdict;
  verdict.labels = first.labels;
  verdict.file_count = fileCount(series);
  verdict.bytes = voxelBytesOf(series);
  for (const DicomFile& file : series.files)
    if (file.fault) verdict.faults.push_back(quoted(file.path) + ": " + file.fault->what);
  verdict.modality = first.modality;
  verdict.dims = {first.plane.columns, first.plane.rows,
                  static_cast<std::int64_t>(series.files.size())};
  verdict.spacing_mm = {first.plane.column_step_mm, first.plane.row_step_mm,
                        first.plane.thickness_mm};
  if (!series.stack) {
    verdict.reasons.push_back(series.stack.error().reason);
    verdict.message = series.stack.error().what;
    return verdict;
  }
  verdict.verdict = series.stack->crooked ? Verdict::Correctable : Verdict::Sound;
  verdict.dims = series.stack->geometry.dims;
  verdict.spacing_mm = series.stack->geometry.steps_mm.colwise().norm().transpose();
  verdict.message = "One evenly spaced stack of " + std::to_string(series.files.size()) +
                    (series.files.size() == 1 ? " slice." : " slices.");
  if (series.files.size() == 1)
    verdict.message = first.plane.thickness_mm > 0.0
                          ? "A single slice, taken to be as thick as it states."
                          : "A single slice of unstated thickness, taken to be 1 mm thick.";
  if (series.stack->crooked) {
    verdict.reasons.push_back(series.stack->crooked->why.reason);
    verdict.message = series.stack->crooked->why.what;
  }
  if (series.copies_left_out > 0) {
    verdict.reasons.push_back("duplicate");
    verdict.message.pop_back();
    verdict.message += "; " + std::to_string(series.copies_left_out) +
                       (series.copies_left_out == 1 ? " other copy of a slice in the folder is"
                                                    : " other copies of slices in the folder are") +
                       " left out.";
  }
  return verdict;
}

}  // namespace datasets
