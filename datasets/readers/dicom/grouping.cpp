// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/readers/dicom/grouping.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <numbers>
#include <set>
#include <utility>

#include "datasets/readers/dicom/parts.h"
#include "datasets/readers/dicom/stack.h"
#include "datasets/readers/files/refusal.h"

namespace datasets {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kOtherView = 20.0 * kDegree;  // rad: scouts are turned by more
constexpr double kOtherTilt = 5.0 * kDegree;   // rad: a slice that is turned by less is a fault
constexpr std::size_t kStack = 3;              // slices, at least, beside which others are odd
constexpr std::size_t kMostViews = 64;         // of one series

/// A series without an identifier is one of its folder.
std::string seriesOf(const DicomFile& file) {
  return file.series.empty() ? "/" + file.path.parent_path().string() : file.series;
}

/// Whether a fault says that the file is no image of a stack at all, and not that a slice is lost.
bool isNoSlice(const DicomFile& file) {
  if (!file.fault) return false;
  const std::string& reason = file.fault->reason;
  const bool describes_slice = file.placed && file.plane.rows > 0 && file.plane.columns > 0;
  return reason == "localizer" || reason == "not-scalar" ||
         file.fault->message.id == "dicom-dose" || (reason == "no-pixels" && !describes_slice);
}

/// Whether a file without a place says itself that it is a picture of the screen.
bool isScreen(const DicomFile& file) {
  return file.attributes[static_cast<std::size_t>(Attribute::ImageType)].find("SCREEN") !=
         std::string::npos;
}

/// Whether a file that has no place is an object of another kind than the slices, such as a picture
/// of the screen or a dose.
bool isOtherObject(const DicomFile& file, const DicomFile& slice) {
  return file.fault->message.id == "dicom-place-missing" &&
         (isScreen(file) || file.sop_class != slice.sop_class ||
          file.plane.rows != slice.plane.rows || file.plane.columns != slice.plane.columns);
}

/// Whether a file whose header could be read in part only may belong to the slices of this one.
bool mayBelong(const DicomFile& broken, const DicomFile& to) {
  const auto agrees = [](const std::string& known, const std::string& other) {
    return known.empty() || known == other;
  };
  return !broken.series.empty() && broken.series == to.series &&
         agrees(broken.identity.patient, to.identity.patient) &&
         agrees(broken.identity.study, to.identity.study) &&
         (isNoSlice(broken) || agrees(broken.identity.modality, to.identity.modality));
}

/// Takes from another slice the attributes that a header of which only a part could be read lacks.
void supply(DicomFile& broken, const DicomFile& slice) {
  for (std::size_t a = 0; a < kAttributes; ++a)
    if (broken.attributes[a].empty()) broken.attributes[a] = slice.attributes[a];
  constexpr auto kType = static_cast<std::size_t>(Attribute::VoxelType);
  broken.attributes[kType] = slice.attributes[kType];
  if (broken.name.empty()) broken.name = slice.name;
}

using Slices = std::vector<DicomFile>;

/// Indices of planes that are alike, by the first with which they are; the most first.
std::vector<std::vector<std::size_t>> alikeAmong(const std::vector<SlicePlane>& planes) {
  std::vector<std::vector<std::size_t>> views;
  for (std::size_t n = 0; n < planes.size(); ++n) {
    const auto alike = std::ranges::find_if(views, [&](const std::vector<std::size_t>& view) {
      return isAlike(planes[view.front()], planes[n]);
    });
    if (alike != views.end())
      alike->push_back(n);
    else if (views.size() < kMostViews)
      views.push_back({n});
    else
      views.front().push_back(n);
  }
  std::ranges::stable_sort(views, std::greater(), &std::vector<std::size_t>::size);
  return views;
}

std::vector<Slices> viewsOf(const Slices& slices) {
  std::vector<SlicePlane> planes;
  for (const DicomFile& slice : slices) planes.push_back(slice.plane);
  std::vector<Slices> views;
  for (const auto& view : alikeAmong(planes)) {
    views.emplace_back();
    for (const std::size_t n : view) views.back().push_back(slices[n]);
  }
  return views;
}

/// Whether slices lie in each other's place, along the normal of the first.
bool overlap(const Slices& a, const Slices& b) {
  const SlicePlane& any = a.front().plane;
  const haptics::Vec3 normal = any.along_row.cross(any.along_column);
  const auto extentOf = [&](const Slices& slices) {
    std::vector<double> heights_mm;
    for (const DicomFile& slice : slices) heights_mm.push_back(normal.dot(slice.plane.position_mm));
    return std::ranges::minmax(heights_mm);
  };
  const auto one = extentOf(a), other = extentOf(b);
  return one.min <= other.max && other.min <= one.max;
}

/// Whether a view is of slices that a stack lacks, and that are turned, or sized, by a fault.
bool isFaultOf(const Slices& view, const Slices& stack, bool whole) {
  const SlicePlane &a = view.front().plane, &b = stack.front().plane;
  if (a.rows != b.rows || a.columns != b.columns) return false;
  if (view.size() < kStack) return !whole || turnBetween(a, b) <= kOtherView;
  return turnBetween(a, b) <= kOtherTilt && overlap(stack, view);
}

haptics::Message viewName(const SlicePlane& view, const SlicePlane& first, std::size_t number,
                          std::size_t count) {
  const std::string n = std::to_string(number), all = std::to_string(count);
  const double turned = turnBetween(view, first);
  if (view.rows != first.rows || view.columns != first.columns)
    return {"part-of", {haptics::Message{"attribute-size", {}}, n, all}};
  if (turned > 0.1 * kDegree)
    return {"part-of-with",
            {haptics::Message{"attribute-orientation", {}}, n, all,
             haptics::Message{"part-turned", {brief(turned / kDegree)}}}};
  return {"part-of", {haptics::Message{"attribute-view", {}}, n, all}};
}

/// The slices of one series by their geometry. A stack that is whole without its odd images leaves
/// them out; slices that it lacks stay with it, so that it is refused by name.
std::vector<FileGroup> byGeometry(Slices slices) {
  std::vector<Slices> views = viewsOf(slices);
  Slices& stack = views.front();
  // nothing tells which is odd
  if (stack.size() < kStack) return {FileGroup{.slices = std::move(slices)}};
  const bool whole = isEven(stack) || partsOf(stack).size() > 1;
  Slices odd, lacking;
  std::vector<Slices> stacks;
  for (auto view = views.begin() + 1; view != views.end(); ++view) {
    const bool fault = isFaultOf(*view, stack, whole);
    if (view->size() >= kStack && !fault)
      stacks.push_back(std::move(*view));
    else
      std::ranges::move(*view, std::back_inserter(fault ? lacking : odd));
  }
  const std::size_t count = stacks.size() + 1;
  const SlicePlane first = stack.front().plane;
  std::ranges::move(lacking, std::back_inserter(stack));
  stacks.insert(stacks.begin(), std::move(stack));
  std::vector<FileGroup> groups;
  for (std::size_t n = 0; n < count; ++n) {
    FileGroup group{.slices = std::move(stacks[n])};
    if (count > 1) group.view = viewName(group.slices.front().plane, first, n + 1, count);
    groups.push_back(std::move(group));
  }
  for (DicomFile& file : odd) {
    if (!file.fault)
      file.fault =
          haptics::Error{haptics::Error::Kind::Unsupported, {"dicom-other-view", {}}, "other-view"};
    groups.front().left_out.push_back(std::move(file));
  }
  return groups;
}

/// The groups of one slice, which may be slices of one stack.
bool isSingle(const FileGroup& group) {
  return group.slices.size() == 1 && group.faulty.empty() && !group.slices.front().fault;
}

bool haveNothingInCommon(const Slices& slices) {
  std::set<std::string> studies, patients;
  for (const DicomFile& file : slices) {
    studies.insert(file.identity.study);
    patients.insert(file.identity.patient);
  }
  return studies.size() == slices.size() &&
         (patients.size() == slices.size() || patients.size() == 1);
}

/// Joins groups of one slice that are equal by `keyOf` and alike, where they make even stacks.
template <class KeyOf>
void joinSingles(std::vector<FileGroup>& groups, FileGroup::Join join, const KeyOf& keyOf) {
  std::map<decltype(keyOf(groups.front().slices.front())), std::vector<std::size_t>> singles;
  for (std::size_t n = 0; n < groups.size(); ++n)
    if (isSingle(groups[n])) singles[keyOf(groups[n].slices.front())].push_back(n);
  std::set<std::size_t> gone;
  for (const auto& [key, members] : singles) {
    std::vector<SlicePlane> planes;
    for (const std::size_t n : members) planes.push_back(groups[n].slices.front().plane);
    for (const std::vector<std::size_t>& view : alikeAmong(planes)) {
      Slices together;
      for (const std::size_t m : view) together.push_back(groups[members[m]].slices.front());
      if (together.size() < kStack ||
          (join == FileGroup::Join::NothingInCommon && !haveNothingInCommon(together)) ||
          (!isEven(together) && partsOf(together).size() < 2))
        continue;
      FileGroup& into = groups[members[view.front()]];
      into.slices = std::move(together);
      into.join = join;
      for (const std::size_t m : view) {
        FileGroup& from = groups[members[m]];
        if (&from == &into) continue;
        std::ranges::move(from.left_out, std::back_inserter(into.left_out));
        gone.insert(members[m]);
      }
    }
  }
  std::vector<FileGroup> rest;
  for (std::size_t n = 0; n < groups.size(); ++n)
    if (!gone.contains(n)) rest.push_back(std::move(groups[n]));
  groups = std::move(rest);
}

void joinSingles(std::vector<FileGroup>& groups) {
  if (groups.empty()) return;
  joinSingles(groups, FileGroup::Join::SeriesOfOneSlice,
              [](const DicomFile& f) { return f.identity; });
  joinSingles(groups, FileGroup::Join::NothingInCommon, [](const DicomFile& f) {
    return std::pair(f.identity.modality, f.identity.patient);
  });
  joinSingles(groups, FileGroup::Join::NothingInCommon,
              [](const DicomFile& f) { return f.identity.modality; });
}

bool lacksIdentifiers(const DicomFile& file) {
  return file.series.empty() || file.identity.study.empty() || file.identity.modality.empty() ||
         file.identity.patient.empty() || file.identity.patient.starts_with('\n');
}

/// Whether what one series states of itself is what the other does, or blank: a patient without an
/// identifier by the name.
bool isBlankOf(const Slices& blank, const Slices& full) {
  const DicomFile &a = blank.front(), &b = full.front();
  const auto agrees = [](const std::string& known, const std::string& other) {
    return known.empty() || known == other;
  };
  const bool same_person = a.identity.patient.starts_with('\n')
                               ? a.name == b.name
                               : agrees(a.identity.patient, b.identity.patient);
  const bool same_series =
      a.series.empty() ? a.path.parent_path() == b.path.parent_path() : a.series == b.series;
  return same_series && same_person && agrees(a.identity.study, b.identity.study) &&
         agrees(a.identity.modality, b.identity.modality);
}

/// Series by their identifiers, and the files of those that lack some with the only one to which
/// they can belong, where all are one even stack together.
std::vector<Slices> seriesBy(std::map<std::pair<std::string, SliceIdentity>, Slices> by_series) {
  std::vector<Slices> all;
  for (auto& [key, slices] : by_series) all.push_back(std::move(slices));
  for (Slices& blank : all) {
    if (!blank.empty() && !lacksIdentifiers(blank.front())) continue;
    Slices* only = nullptr;
    int count = 0;
    for (Slices& full : all)
      if (&full != &blank && !full.empty() && !blank.empty() && isBlankOf(blank, full)) {
        only = &full;
        ++count;
      }
    if (count != 1) continue;
    Slices together = *only;
    std::ranges::copy(blank, std::back_inserter(together));
    if (!isEven(together)) continue;
    *only = std::move(together);
    blank.clear();
  }
  std::erase_if(all, [](const Slices& slices) { return slices.empty(); });
  return all;
}

/// Puts a file that is no slice, or nobody knows where one, to the groups that may lack it.
bool attached(const DicomFile& file, std::vector<FileGroup>& groups) {
  bool belongs = false;
  for (FileGroup& group : groups) {
    if (!mayBelong(file, group.slices.front())) continue;
    const bool no_slice = isNoSlice(file) || isOtherObject(file, group.slices.front());
    (no_slice ? group.left_out : group.faulty).push_back(file);
    belongs = true;
  }
  return belongs;
}

}  // namespace

std::vector<FileGroup> groupsOf(std::vector<DicomFile> frames) {
  std::map<std::pair<std::string, SliceIdentity>, Slices> by_series;
  Slices aside;
  for (DicomFile& file : frames)
    if (file.fault)
      aside.push_back(std::move(file));
    else
      by_series[{seriesOf(file), file.identity}].push_back(std::move(file));
  // a faulty slice that says where it lies is one that its series lacks
  std::erase_if(aside, [&](DicomFile& file) {
    const auto series = by_series.find({seriesOf(file), file.identity});
    if (!file.placed || isNoSlice(file) || series == by_series.end()) return false;
    supply(file, series->second.front());
    series->second.push_back(std::move(file));
    return true;
  });
  std::vector<FileGroup> groups;
  for (Slices& slices : seriesBy(std::move(by_series)))
    std::ranges::move(byGeometry(std::move(slices)), std::back_inserter(groups));
  std::map<std::string, FileGroup> alone;
  for (DicomFile& file : aside)
    if (!attached(file, groups)) alone[seriesOf(file)].faulty.push_back(std::move(file));
  joinSingles(groups);
  for (auto& [series, group] : alone) groups.push_back(std::move(group));
  return groups;
}

}  // namespace datasets
