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

#include "datasets/readers/dicom/grouping.h"
#include "datasets/readers/dicom/parts.h"
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
  const auto changes = [](const DicomFile& f) { return f.slope != 1.0 || f.intercept != 0.0; };
  const auto bare = std::ranges::find(files, false, &DicomFile::rescaled);
  if (bare != files.end() && std::ranges::any_of(files, changes))
    return malformed("bad-header", {"dicom-rescale-of-some", {quoted(bare->path)}});
  std::vector<SlicePlane> planes;
  planes.reserve(files.size());
  for (const DicomFile& file : files) planes.push_back(file.plane);
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

/// What the files of a refused stack seem to be, where many lie at each place.
void sayHowMany(DicomSeries& series) {
  if (series.stack || series.stack.error().reason != "duplicate") return;
  const std::size_t images = imagesAtEachPlace(series.files);
  const std::size_t places = images > 1 ? series.files.size() / images : 0;
  if (places < 2) return;
  series.stack = unsupported(
      "duplicate", {"dicom-several-volumes", {std::to_string(images), std::to_string(places)}});
}

DicomSeries judgedTogether(std::vector<DicomFile> files, const FileGroup& group) {
  DicomSeries series;
  series.files = std::move(files);
  std::ranges::stable_sort(series.files, {},
                           [](const DicomFile& f) { return std::pair(f.path, f.frame); });
  series.stack = judge(series.files);
  series.left_out = group.left_out;
  if (series.stack) {
    series.differences = differencesAmong(series.files);
    if (group.join == FileGroup::Join::NothingInCommon)
      series.question =
          haptics::Error{haptics::Error::Kind::Correctable,
                         {"dicom-nothing-in-common", {std::to_string(series.files.size())}},
                         "identifiers-differ"};
  } else if (series.stack.error().reason == "missing-slices") {
    series.unbroken = unbrokenPartOf(series.files);
  }
  sayHowMany(series);
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

/// Whether acquisitions lie in each other's place. One after the other they are turns of a scanner
/// that counts them.
bool acquisitionsOverlap(const std::vector<DicomFile>& files) {
  constexpr auto kAcquisition = static_cast<std::size_t>(Attribute::Acquisition);
  std::map<std::string, std::vector<DicomFile>> by_acquisition;
  for (const DicomFile& file : files) by_acquisition[file.attributes[kAcquisition]].push_back(file);
  std::vector<std::pair<double, double>> extents;
  for (const auto& [number, some] : by_acquisition) extents.push_back(extentOf(some));
  std::ranges::sort(extents);
  double highest_mm = -std::numeric_limits<double>::infinity();
  for (const auto& [low_mm, high_mm] : extents) {
    if (low_mm <= highest_mm) return true;
    highest_mm = std::max(highest_mm, high_mm);
  }
  return false;
}

/// Passes that lie between each other's and are no even stack together are never one volume.
void keepPassesApart(DicomSeries& series) {
  const bool faulty =
      std::ranges::any_of(series.files, [](const DicomFile& f) { return f.fault.has_value(); });
  const bool uneven = series.stack && series.stack->crooked && series.stack->crooked->uneven;
  if (faulty || (series.stack && !uneven) || !acquisitionsOverlap(series.files)) return;
  series.unbroken.reset();  // it may hold slices of several
  if (uneven)
    series.stack = unsupported("mixed-acquisitions", {"dicom-acquisitions-interleaved", {}});
}

/// Its slices, or else what may be slices.
const std::vector<DicomFile>& filesOf(const FileGroup& group) {
  return group.slices.empty() ? group.faulty : group.slices;
}

/// The volumes that a group of files makes.
std::vector<DicomSeries> judged(FileGroup group) {
  std::ranges::move(group.faulty, std::back_inserter(group.slices));
  const int copies = leaveOutCopies(group.slices);
  const auto unplaced =
      std::stable_partition(group.slices.begin(), group.slices.end(),
                            [](const DicomFile& f) { return f.placed || !f.fault; });
  const std::vector<DicomFile> lacking(unplaced, group.slices.end());
  group.slices.erase(unplaced, group.slices.end());
  std::vector<DicomSeries> all;
  std::vector<VolumePart> parts;
  if (group.slices.empty())
    parts.push_back({});
  else
    parts = partsOf(group.slices);
  for (const VolumePart& part : parts) {
    std::vector<DicomFile> files;
    for (const std::size_t n : part.slices) files.push_back(group.slices[n]);
    std::ranges::copy(lacking, std::back_inserter(files));
    DicomSeries series = judgedTogether(std::move(files), group);
    series.part = group.view.empty()  ? part.name
                  : part.name.empty() ? group.view
                                      : haptics::Message{"part-and", {group.view, part.name}};
    if (parts.size() == 1) keepPassesApart(series);
    series.copies_left_out = copies;
    all.push_back(std::move(series));
  }
  return all;
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

haptics::Message listOf(const std::vector<haptics::Message>& names) {
  haptics::Message list = names.front();
  for (std::size_t n = 1; n < names.size(); ++n) list = {"part-and", {std::move(list), names[n]}};
  return list;
}

void sayPartAndLeftOut(const DicomSeries& series, SeriesVerdict& verdict) {
  verdict.part = series.part;
  if (!series.part.empty())
    verdict.message = bothOf(std::move(verdict.message), {"dicom-part", {series.part}});
  if (series.left_out.empty()) return;
  const std::string first = quoted(series.left_out.front().path);
  verdict.message =
      bothOf(std::move(verdict.message),
             {"dicom-files-left-out", {std::to_string(series.left_out.size()), first}});
  for (const DicomFile& file : series.left_out)
    verdict.faults.push_back({"file-fault", {quoted(file.path), file.fault->message}});
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
  const std::int64_t stored =
      std::ranges::max_element(series.files, {}, &DicomFile::bits_allocated)->bits_allocated / 8;
  const std::int64_t each = std::ranges::any_of(series.files, is_fraction)
                                ? 4
                                : std::max<std::int64_t>(stored, rescaled ? 2 : 1);
  return pixels * slices * each;
}

/// Copies in another encoding may be of another voxel type, and were written at another time.
bool tellsCopiesApart(Attribute attribute) {
  return attribute == Attribute::Acquisition ||
         (traitsOf(attribute).strong && attribute != Attribute::VoxelType);
}

/// Whether two images differ in nothing that tells reconstructions or moments apart.
bool isOneKind(const DicomFile& a, const DicomFile& b) {
  for (std::size_t n = 0; n < kAttributes; ++n)
    if (tellsCopiesApart(static_cast<Attribute>(n)) && a.attributes[n] != b.attributes[n])
      return false;
  return true;
}

/// The files that a named one replaces at its place.
enum class Beside { OfOneKind, OfAnyKind };

/// The volumes with frames of a file, which counts instead of others at its place.
std::vector<DicomSeries> seriesHolding(const DicomFile& named, std::vector<DicomFile> headers,
                                       Beside left_out) {
  const auto isNamed = [&](const DicomFile& file) { return file.path == named.path; };
  const auto copies = std::erase_if(headers, [&](const DicomFile& file) {
    // many are made anonymous by giving all images one identifier
    const bool comparable = file.placed && named.placed;
    const bool same_instance =
        !comparable && !file.instance.empty() && file.instance == named.instance;
    const bool same_place = comparable && isSamePlace(file.plane, named.plane);
    return !isNamed(file) && file.series == named.series && file.identity == named.identity &&
           (left_out == Beside::OfAnyKind || isOneKind(file, named)) &&
           (same_instance || same_place);
  });
  std::vector<DicomSeries> found;
  for (DicomSeries& series : seriesAmong(std::move(headers))) {
    const bool holds = std::ranges::any_of(series.files, isNamed);
    if (!holds && std::ranges::none_of(series.left_out, isNamed)) continue;
    if (!holds) {  // it stands for itself
      series = DicomSeries{};
      series.files = {named};
      series.stack = judge(series.files);
    }
    series.copies_left_out += static_cast<int>(copies);
    found.push_back(std::move(series));
    if (!holds) break;
  }
  return found;
}

tl::unexpected<haptics::Error> noSeries(const fs::path& path) {
  return malformed("unreadable", {"dicom-no-series", {quoted(path)}});
}

}  // namespace

std::vector<DicomSeries> seriesAmong(std::vector<DicomFile> frames) {
  std::vector<FileGroup> groups = groupsOf(std::move(frames));
  std::map<std::string, fs::path> first;  // file of each series
  for (const FileGroup& group : groups)
    for (const DicomFile& file : filesOf(group)) {
      const auto [it, is_new] = first.try_emplace(file.series, file.path);
      if (!is_new) it->second = std::min(it->second, file.path);
    }
  // volumes of one series stay in their order
  std::ranges::stable_sort(groups, {}, [&](const FileGroup& group) {
    const DicomFile& any = filesOf(group).front();
    return std::pair(any.series_number, first.at(any.series));
  });
  std::vector<DicomSeries> all;
  for (FileGroup& group : groups)
    for (DicomSeries& series : judged(std::move(group))) all.push_back(std::move(series));
  return all;
}

Expected<std::vector<DicomSeries>> seriesAmong(const std::vector<fs::path>& paths,
                                               const ReadProgress& progress) {
  auto frames = framesOf(paths, {}, progress);
  if (!frames) return tl::unexpected(std::move(frames.error()));
  return seriesAmong(std::move(*frames));
}

std::vector<StructuresFound> takeStructures(std::vector<DicomFile>& frames,
                                            const fs::path& folder) {
  std::vector<StructuresFound> found;
  std::erase_if(frames, [&](const DicomFile& file) {
    if (!holdsStructures(file)) return false;
    using enum StructuresFound::Kind;
    found.push_back({file.path, file.path.lexically_relative(folder).string(),
                     holdsContours(file) ? Contours : Segments});
    return true;
  });
  return found;
}

Expected<std::vector<DicomSeries>> seriesOf(const fs::path& path, DicomHeader header,
                                            const ReadProgress& progress,
                                            std::vector<StructuresFound>* structures) {
  std::vector<DicomFile>& frames = header.frames;
  if (frames.empty()) return unsupported("no-pixels", {"dicom-index-or-no-image", {quoted(path)}});
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  const auto paths = filesOf(folder);
  if (!paths) return tl::unexpected(paths.error());
  // as the folder names it
  for (DicomFile& frame : frames) frame.path = folder / path.filename();
  auto headers = framesOf(*paths, frames, progress);
  if (!headers) return tl::unexpected(std::move(headers.error()));
  const DicomFile named = frames.front();
  auto beside = takeStructures(*headers, folder);
  if (structures != nullptr) *structures = std::move(beside);
  const auto isNamed = [&](const DicomFile& file) {
    return file.path.filename() == path.filename();
  };
  const auto damaged = std::ranges::count_if(*headers, [&](const DicomFile& file) {
    return file.fault && file.series.empty() && !isNamed(file);
  });
  // files without identifiers stand for themselves
  if (named.series.empty())
    std::erase_if(*headers, [&](const DicomFile& file) { return !isNamed(file); });
  std::vector<DicomSeries> found = seriesHolding(named, *headers, Beside::OfOneKind);
  const bool refused = found.size() == 1 && !found.front().stack && !named.fault;
  if (refused) found = seriesHolding(named, std::move(*headers), Beside::OfAnyKind);
  if (found.empty()) return noSeries(path);
  for (DicomSeries& series : found) series.damaged_beside = static_cast<int>(damaged);
  return found;
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
    sayPartAndLeftOut(series, verdict);
    return verdict;
  }
  const bool asks = series.stack->crooked || series.question;
  verdict.verdict = asks ? Verdict::Correctable : Verdict::Sound;
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
  if (series.question) {
    verdict.reasons.push_back(series.question->reason);
    verdict.message = series.stack->crooked
                          ? bothOf(series.question->message, std::move(verdict.message))
                          : series.question->message;
  }
  if (!series.differences.empty())
    verdict.message = {"dicom-differing", {verdict.message, listOf(series.differences)}};
  if (series.copies_left_out > 0) {
    verdict.reasons.push_back("duplicate");
    verdict.message = {"dicom-copies-left-out",
                       {verdict.message, std::to_string(series.copies_left_out)}};
  }
  sayPartAndLeftOut(series, verdict);
  return verdict;
}

}  // namespace datasets
