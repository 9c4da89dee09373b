// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/edits/edit_history.h"

#include <algorithm>
#include <new>
#include <utility>

#include "datasets/edits/operators.h"
#include "datasets/edits/view.h"
#include "haptics/carving/lowering.h"

namespace datasets {
namespace {

constexpr double kFound = 0.6;    // of an edit's time: what it lowers is known
constexpr double kLowered = 0.9;  // it is lowered

tl::unexpected<haptics::Error> editRefused(haptics::Message message, std::string reason) {
  return tl::unexpected(
      haptics::Error{haptics::Error::Kind::Unsupported, std::move(message), std::move(reason)});
}
tl::unexpected<haptics::Error> nothingTaken() {
  return editRefused({"edit-nothing", {}}, "nothing");
}

/// What `call` gives; an Error where memory ends.
template <class F>
auto withinMemory(F&& call) -> decltype(call()) {
  try {
    return call();
  } catch (const std::bad_alloc&) {
    return editRefused({"edit-memory", {}}, "too-large");
  }
}

haptics::Expected<void> checkCrop(const haptics::Volume& volume, const Crop& crop) {
  for (std::size_t a = 0; a < 3; ++a)
    if (crop.kept.first[a] < 0 || crop.kept.first[a] >= crop.kept.end[a] ||
        crop.kept.end[a] > volume.grid.dims[a])
      return editRefused({"edit-crop-outside", {}}, "outside");
  if (crop.kept == volume.bounds()) return nothingTaken();
  return {};
}

/// A volume that is being made.
struct Draft {
  haptics::Volume volume;  ///< with the voxels of `view` once there is one
  std::shared_ptr<void> view;
  TouchedBlocks touched;
  std::uint64_t digest = 0;  ///< of its voxels, without the crop
};

haptics::Expected<void> cropDraft(Draft& draft, const Crop& crop) {
  if (const auto possible = checkCrop(draft.volume, crop); !possible) return possible;
  draft.volume.crop = crop.kept;
  if (crop.kept == haptics::VoxelBox{{}, draft.volume.grid.dims}) draft.volume.crop.reset();
  return {};
}

haptics::Expected<void> setTissues(Draft& draft, const TissueTable& table) {
  if (table.dims() != draft.volume.grid.dims)
    return editRefused({"edit-other-grid", {}}, "other-grid");
  const auto before = std::exchange(draft.volume.tissues, nullptr);
  if (table.parts().empty()) return before ? haptics::Expected<void>{} : nothingTaken();
  std::vector<haptics::Tissues::Part> parts;
  for (const TissueTable::Part& part : table.parts()) parts.push_back({part.runs, part.energy});
  draft.volume.tissues = std::make_shared<const haptics::Tissues>(draft.volume.grid, parts);
  return {};
}

/// Whether an edit writes voxels; if not, `draft` has it now.
haptics::Expected<bool> writesVoxels(Draft& draft, const Edit& edit) {
  haptics::Expected<void> done;
  if (const auto* crop = std::get_if<Crop>(&edit))
    done = cropDraft(draft, *crop);
  else if (const auto* table = std::get_if<TissueTable>(&edit))
    done = setTissues(draft, *table);
  else
    return true;
  if (!done) return tl::unexpected(done.error());
  return false;
}

haptics::Expected<haptics::Lowered> lowered(const haptics::Volume& volume,
                                            const haptics::RowCutter& cutter, void* written,
                                            const EditProgress& progress) {
  auto taken = haptics::lower(volume, cutter, written, [&](std::int64_t count, const auto& work) {
    return progress.each(count, work);
  });
  if (!taken) return tl::unexpected(editCancelled());
  return std::move(*taken);
}

/// Carries out an edit that writes voxels, in a view of the volume. The runs that it lowered, at
/// least one.
haptics::Expected<std::vector<haptics::VoxelRun>> written(const haptics::Volume& volume,
                                                          const Edit& edit, double greatest,
                                                          void* view, const EditWatch& watch) {
  haptics::Expected<std::vector<haptics::VoxelRun>> runs;
  if (const auto* stroke = std::get_if<Stroke>(&edit)) {
    runs = carve(volume, *stroke, view, {watch, 0.0, kLowered});
  } else {
    const auto made = operatorOf(volume, edit, greatest, watch);
    if (!made) return tl::unexpected(made.error());
    auto taken = lowered(volume, **made, view, {watch, kFound, kLowered});
    if (!taken) return tl::unexpected(taken.error());
    runs = std::move(taken->runs);
  }
  if (runs && runs->empty()) return nothingTaken();
  return runs;
}

/// The volume of a draft, with how it came about.
std::shared_ptr<const haptics::Volume> finished(
    Draft draft, std::shared_ptr<const haptics::Volume> scan, std::vector<Edit> edits,
    const std::shared_ptr<const haptics::Volume>& neighbour,
    std::vector<haptics::VoxelBox> changed) {
  auto edited = std::make_shared<Edited>();
  edited->digest = digestOf(draft.digest, draft.volume.bounds());
  edited->scan = std::move(scan);
  edited->edits = std::move(edits);
  edited->neighbour = neighbour;
  edited->changed = std::move(changed);
  draft.volume.derivation = std::move(edited);
  return std::make_shared<const haptics::Volume>(std::move(draft.volume));
}

/// Applies edits to the draft of a scan, one after the other in one view.
haptics::Expected<void> applyAll(const haptics::Volume& scan, std::span<const Edit> edits,
                                 Draft& draft, ChangedBoxes& changed, const EditWatch& watch) {
  for (std::size_t n = 0; n < edits.size(); ++n) {
    if (watch.cancel != nullptr && watch.cancel->load()) return tl::unexpected(editCancelled());
    EditWatch part = watch;
    if (watch.advanced)
      part.advanced = [&watch, n, count = edits.size()](double fraction) {
        watch.advanced((static_cast<double>(n) + fraction) / static_cast<double>(count));
      };
    const auto writes = writesVoxels(draft, edits[n]);
    if (!writes) return tl::unexpected(writes.error());
    if (!*writes) continue;
    if (!draft.view) {
      auto view = viewOf(scan, scan.voxels.get(), draft.touched);
      if (!view) return tl::unexpected(view.error());
      draft.view = std::move(*view);
      draft.volume.voxels = draft.view;
    }
    const auto runs = written(draft.volume, edits[n], scan.greatest, draft.view.get(), part);
    if (!runs) return tl::unexpected(runs.error());
    for (const haptics::VoxelRun& run : *runs) {
      const RunBytes bytes = bytesOfRun(scan, run);
      draft.touched.add(bytes.first, bytes.first + bytes.count);
    }
    changed.add(*runs);
  }
  changed.add(scan.bounds(), draft.volume.bounds());
  draft.digest = digestOfVoxels(scan, draft.volume.voxels.get(), draft.touched);
  return {};
}

Draft draftOf(const haptics::Volume& scan) { return {scan, nullptr, TouchedBlocks{scan}, 0}; }

/// Voxels at or above a value in a box.
std::int64_t solidIn(const haptics::Volume& volume, const haptics::VoxelBox& box, double isovalue) {
  std::int64_t count = 0;
  visitVoxels(volume.type, volume.voxels.get(), [&](const auto* values) {
    const auto& dims = volume.grid.dims;
    for (std::int64_t k = box.first[2]; k < box.end[2]; ++k)
      for (std::int64_t j = box.first[1]; j < box.end[1]; ++j)
        for (std::int64_t i = box.first[0]; i < box.end[0]; ++i)
          count += static_cast<double>(values[(k * dims[1] + j) * dims[0] + i]) >= isovalue;
  });
  return count;
}

/// The part of one box within another; empty: its end is its beginning.
haptics::VoxelBox within(const haptics::VoxelBox& one, const haptics::VoxelBox& other) {
  haptics::VoxelBox both;
  for (std::size_t a = 0; a < 3; ++a) {
    both.first[a] = std::max(one.first[a], other.first[a]);
    both.end[a] = std::max(both.first[a], std::min(one.end[a], other.end[a]));
  }
  return both;
}

Removal removalOfCrop(const haptics::Volume& volume, const Crop& crop, double isovalue) {
  Removal removal;
  const haptics::VoxelBox now = volume.bounds();
  const haptics::VoxelBox stays = within(now, crop.kept);
  const auto add = [&](std::int64_t first, std::int64_t end, std::int64_t j, std::int64_t k) {
    if (first < end)
      removal.runs.push_back({static_cast<std::int32_t>(first), static_cast<std::int32_t>(j),
                              static_cast<std::int32_t>(k),
                              static_cast<std::int32_t>(end - first)});
  };
  for (std::int64_t k = now.first[2]; k < now.end[2]; ++k)
    for (std::int64_t j = now.first[1]; j < now.end[1]; ++j) {
      const bool row = k >= stays.first[2] && k < stays.end[2] && j >= stays.first[1] &&
                       j < stays.end[1] && stays.first[0] < stays.end[0];
      add(now.first[0], row ? stays.first[0] : now.end[0], j, k);
      if (row) add(stays.end[0], now.end[0], j, k);
    }
  removal.volume =
      static_cast<double>(solidIn(volume, now, isovalue) - solidIn(volume, stays, isovalue)) *
      volume.grid.spacing.prod();
  return removal;
}

}  // namespace

namespace {

haptics::Expected<Removal> removalWith(const haptics::Volume& volume, const Edit& edit,
                                       double isovalue, const EditWatch& watch) {
  if (const auto* crop = std::get_if<Crop>(&edit)) {
    if (const auto possible = checkCrop(volume, *crop); !possible)
      return tl::unexpected(possible.error());
    return removalOfCrop(volume, *crop, isovalue);
  }
  if (std::holds_alternative<Stroke>(edit) || !takesAway(edit)) return nothingTaken();
  const auto made = operatorOf(volume, edit, isovalue, watch);
  if (!made) return tl::unexpected(made.error());
  auto taken = lowered(volume, **made, nullptr, {watch, kFound, 1.0});
  if (!taken) return tl::unexpected(taken.error());
  if (taken->runs.empty()) return nothingTaken();
  return Removal{static_cast<double>(taken->solid) * volume.grid.spacing.prod(),
                 std::move(taken->runs)};
}

haptics::Expected<std::shared_ptr<const haptics::Volume>> editedWith(
    std::shared_ptr<const haptics::Volume> scan, std::span<const Edit> edits,
    const EditWatch& watch) {
  Draft draft = draftOf(*scan);
  ChangedBoxes changed{scan->grid};
  if (auto done = applyAll(*scan, edits, draft, changed, watch); !done)
    return tl::unexpected(done.error());
  return finished(std::move(draft), scan, {edits.begin(), edits.end()}, scan, changed.boxes());
}

}  // namespace

haptics::Expected<Removal> removalOf(const haptics::Volume& volume, const Edit& edit,
                                     double isovalue, const EditWatch& watch) {
  return withinMemory([&] { return removalWith(volume, edit, isovalue, watch); });
}

class EditHistory::State {
 public:
  State(std::shared_ptr<const haptics::Volume> of_scan, std::size_t limit)
      : scan{std::move(of_scan)}, present{scan}, touched{*scan}, journal_limit{limit} {}

  /// One edit in force, and what takes it back.
  struct Step {
    TouchedBlocks touched;                            ///< before it
    std::uint64_t digest = 0;                         ///< of the voxels before it
    std::optional<haptics::VoxelBox> crop;            ///< before it
    std::shared_ptr<const haptics::Tissues> tissues;  ///< before it
    bool writes = false;                              ///< it writes voxels
    std::shared_ptr<const Journal> journal;           ///< null: it was dropped
    std::vector<haptics::VoxelBox> changed;
    std::size_t bytes() const { return journal ? journal->bytes() + touched.bytes() : 0; }
  };

  haptics::Expected<std::shared_ptr<const haptics::Volume>> apply(const Edit& edit,
                                                                  const EditWatch& watch);
  haptics::Expected<std::shared_ptr<const haptics::Volume>> takeBack(std::size_t steps,
                                                                     const EditWatch& watch);
  std::size_t journalBytes() const {
    std::size_t sum = 0;
    for (const Step& step : steps) sum += step.bytes();
    return sum;
  }

  std::shared_ptr<const haptics::Volume> scan, present;
  TouchedBlocks touched;
  std::uint64_t digest = 0;  // of its voxels
  std::vector<Step> steps;
  std::vector<Edit> edits;   // in force
  std::vector<Edit> undone;  // the last to redo first
  std::size_t journal_limit;

 private:
  void dropJournals();
};

void EditHistory::State::dropJournals() {
  // the oldest first: what was done last is taken back first
  std::size_t bytes = journalBytes();
  for (Step& step : steps) {
    if (bytes <= journal_limit) return;
    bytes -= step.bytes();
    step.journal.reset();
    step.touched = {};
  }
}

haptics::Expected<std::shared_ptr<const haptics::Volume>> EditHistory::State::apply(
    const Edit& edit, const EditWatch& watch) {
  if (steps.size() >= kMostSteps)
    return editRefused({"edit-too-many", {std::to_string(kMostSteps)}}, "too-many");
  // a view or recording with it could not be read again
  if (const auto* table = std::get_if<TissueTable>(&edit)) {
    std::size_t runs = 0;
    for (const TissueTable::Part& part : table->parts()) runs += part.runs.size();
    if (table->parts().size() > kMostParts || runs > kMostRuns)
      return editRefused({"edit-too-long", {}}, "too-large");
  }
  Draft draft{*present, nullptr, touched, digest};
  ChangedBoxes changed{scan->grid};
  Journal journal;
  const auto writes = writesVoxels(draft, edit);
  if (!writes) return tl::unexpected(writes.error());
  if (!*writes) {
    changed.add(present->bounds(), draft.volume.bounds());
  } else {
    auto view = viewOf(*scan, present->voxels.get(), touched);
    if (!view) return tl::unexpected(view.error());
    draft.view = std::move(*view);
    draft.volume.voxels = draft.view;
    auto runs = written(*present, edit, scan->greatest, draft.view.get(), watch);
    if (!runs) return tl::unexpected(runs.error());
    for (const haptics::VoxelRun& run : *runs) {
      const RunBytes bytes = bytesOfRun(*scan, run);
      draft.touched.add(bytes.first, bytes.first + bytes.count);
    }
    // the digest goes through all that was lowered: the other thread takes the rest
    const EditProgress beside{watch, kLowered, 1.0};
    if (!beside.each(2, [&](std::int64_t n) {
          if (n == 0) {
            draft.digest = digestOfVoxels(*scan, draft.view.get(), draft.touched);
          } else {
            changed.add(*runs);
            journal = {*scan, present->voxels.get(), touched, std::move(*runs)};
          }
        }))
      return tl::unexpected(editCancelled());
  }
  if (watch.cancel != nullptr && watch.cancel->load()) return tl::unexpected(editCancelled());
  std::vector<Edit> all = edits;
  all.push_back(edit);
  TouchedBlocks after = draft.touched;
  const std::uint64_t digest_after = draft.digest;
  std::vector<haptics::VoxelBox> boxes = changed.boxes();
  auto volume = finished(std::move(draft), scan, all, present, boxes);
  auto kept = std::make_shared<const Journal>(std::move(journal));
  steps.reserve(steps.size() + 1);
  // nothing from here on needs memory
  steps.push_back({std::move(touched), digest, present->crop, present->tissues, *writes,
                   std::move(kept), std::move(boxes)});
  touched = std::move(after);
  digest = digest_after;
  edits = std::move(all);
  present = std::move(volume);
  dropJournals();
  return present;
}

haptics::Expected<std::shared_ptr<const haptics::Volume>> EditHistory::State::takeBack(
    std::size_t count, const EditWatch& watch) {
  const std::size_t left = steps.size() - count;
  const std::vector<Edit> kept(edits.begin(), edits.begin() + static_cast<std::ptrdiff_t>(left));
  TouchedBlocks before{*scan};
  std::uint64_t digest_before = 0;
  std::shared_ptr<const haptics::Volume> volume = scan;
  if (left > 0 && count == 1 && steps.back().journal) {
    const Step& step = steps.back();
    Draft draft{*present, nullptr, step.touched, step.digest};
    draft.volume.crop = step.crop;
    draft.volume.tissues = step.tissues;
    if (step.writes) {
      auto view = viewOf(*scan, present->voxels.get(), step.touched);
      if (!view) return tl::unexpected(view.error());
      step.journal->restore(*scan, view->get(), step.touched);
      draft.view = std::move(*view);
      draft.volume.voxels = draft.view;
    }
    before = step.touched;
    digest_before = step.digest;
    volume = finished(std::move(draft), scan, kept, present, step.changed);
  } else if (left > 0) {
    Draft draft = draftOf(*scan);
    ChangedBoxes unused{scan->grid};
    if (auto done = applyAll(*scan, kept, draft, unused, watch); !done)
      return tl::unexpected(done.error());
    before = draft.touched;
    digest_before = draft.digest;
    volume = finished(std::move(draft), scan, kept, present, steps.back().changed);
  }
  if (watch.cancel != nullptr && watch.cancel->load()) return tl::unexpected(editCancelled());
  undone.reserve(undone.size() + count);
  for (std::size_t n = 0; n < count; ++n) {
    undone.push_back(std::move(edits.back()));
    edits.pop_back();
    steps.pop_back();
  }
  touched = std::move(before);
  digest = digest_before;
  present = std::move(volume);
  return present;
}

EditHistory::EditHistory(std::shared_ptr<const haptics::Volume> scan, std::size_t journal_limit)
    : state_{std::make_unique<State>(std::move(scan), journal_limit)} {}
EditHistory::~EditHistory() = default;

const std::shared_ptr<const haptics::Volume>& EditHistory::scan() const { return state_->scan; }
const std::shared_ptr<const haptics::Volume>& EditHistory::present() const {
  return state_->present;
}
std::span<const Edit> EditHistory::edits() const { return state_->edits; }
bool EditHistory::canUndo() const { return !state_->steps.empty(); }
bool EditHistory::canRedo() const { return !state_->undone.empty(); }
std::size_t EditHistory::journalBytes() const { return state_->journalBytes(); }

haptics::Expected<std::shared_ptr<const haptics::Volume>> EditHistory::apply(
    const Edit& edit, const EditWatch& watch) {
  auto volume = withinMemory([&] { return state_->apply(edit, watch); });
  if (volume) state_->undone.clear();
  return volume;
}

haptics::Expected<std::shared_ptr<const haptics::Volume>> EditHistory::undo(
    const EditWatch& watch) {
  if (!canUndo()) return editRefused({"edit-no-such", {}}, "nothing");
  return withinMemory([&] { return state_->takeBack(1, watch); });
}

haptics::Expected<std::shared_ptr<const haptics::Volume>> EditHistory::redo(
    const EditWatch& watch) {
  if (!canRedo()) return editRefused({"edit-no-such", {}}, "nothing");
  auto volume = withinMemory([&] { return state_->apply(state_->undone.back(), watch); });
  if (volume) state_->undone.pop_back();
  return volume;
}

haptics::Expected<std::shared_ptr<const haptics::Volume>> EditHistory::reset(
    const EditWatch& watch) {
  if (!canUndo()) return editRefused({"edit-no-such", {}}, "nothing");
  return withinMemory([&] { return state_->takeBack(state_->steps.size(), watch); });
}

haptics::Expected<std::shared_ptr<const haptics::Volume>> edited(
    std::shared_ptr<const haptics::Volume> scan, std::span<const Edit> edits,
    const EditWatch& watch) {
  if (edits.empty()) return scan;
  return withinMemory([&] { return editedWith(std::move(scan), edits, watch); });
}

}  // namespace datasets
