// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/edits/view.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include "haptics/core/voxel_memory.h"

namespace datasets {

TouchedBlocks::TouchedBlocks(const haptics::Volume& volume)
    : size_{static_cast<std::size_t>(volume.grid.voxelCount()) * haptics::sizeOf(volume.type)},
      blocks_{(size_ + kBytes - 1) / kBytes},
      bits_((blocks_ + 63) / 64) {}

void TouchedBlocks::add(std::size_t first_byte, std::size_t end_byte) {
  for (std::size_t block = first_byte / kBytes; block * kBytes < end_byte; ++block)
    bits_[block / 64] |= std::uint64_t{1} << (block % 64);
}

std::size_t TouchedBlocks::touched() const {
  std::size_t count = 0;
  for (const std::uint64_t word : bits_) count += static_cast<std::size_t>(std::popcount(word));
  return count;
}

haptics::Expected<std::shared_ptr<void>> viewOf(const haptics::Volume& scan, const void* present,
                                                const TouchedBlocks& touched) {
  if (!scan.memory)
    return tl::unexpected(haptics::Error{
        haptics::Error::Kind::Unsupported, {"edit-not-editable", {}}, "not-editable"});
  auto view = scan.memory->privateView();
  if (!view) return view;
  for (std::size_t block = 0; block < touched.blocks(); ++block)
    if (touched.has(block))
      std::memcpy(static_cast<std::byte*>(view->get()) + touched.begin(block),
                  static_cast<const std::byte*>(present) + touched.begin(block),
                  touched.end(block) - touched.begin(block));
  return view;
}

namespace {

std::uint64_t scrambled(std::uint64_t x) {
  // the finisher of splitmix64
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9U;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebU;
  return x ^ (x >> 31);
}

}  // namespace

std::uint64_t digestOfVoxels(const haptics::Volume& scan, const void* voxels,
                             const TouchedBlocks& touched) {
  std::uint64_t digest = 0;
  const auto* then = static_cast<const std::uint8_t*>(scan.voxels.get());
  const auto* now = static_cast<const std::uint8_t*>(voxels);
  for (std::size_t block = 0; block < touched.blocks(); ++block) {
    if (!touched.has(block)) continue;
    const std::size_t begin = touched.begin(block), end = touched.end(block);
    if (std::memcmp(then + begin, now + begin, end - begin) == 0) continue;
    for (std::size_t at = begin; at < end; at += 8) {
      std::uint64_t before = 0, after = 0;
      std::memcpy(&before, then + at, std::min<std::size_t>(8, end - at));
      std::memcpy(&after, now + at, std::min<std::size_t>(8, end - at));
      if (before == after) continue;
      digest = (digest ^ scrambled(after + at * 0x9e3779b97f4a7c15U)) * 0x9fb21c651e98df25U;
      digest ^= digest >> 32;
    }
  }
  return digest;
}

std::uint64_t digestOf(std::uint64_t of_voxels, const haptics::VoxelBox& bounds) {
  std::uint64_t digest = of_voxels;
  for (std::size_t a = 0; a < 3; ++a) {
    digest = scrambled(digest ^ static_cast<std::uint64_t>(bounds.first[a]));
    digest = scrambled(digest ^ static_cast<std::uint64_t>(bounds.end[a]));
  }
  return digest;
}

RunBytes bytesOfRun(const haptics::Volume& volume, const haptics::VoxelRun& run) {
  const auto& dims = volume.grid.dims;
  const std::size_t size = haptics::sizeOf(volume.type);
  const auto at = static_cast<std::size_t>((run.k * dims[1] + run.j) * dims[0] + run.i);
  return {at * size, static_cast<std::size_t>(run.count) * size};
}

Journal::Journal(const haptics::Volume& scan, const void* before, const TouchedBlocks& touched,
                 std::vector<haptics::VoxelRun> runs)
    : runs_{std::move(runs)} {
  runs_.shrink_to_fit();
  const auto* original = static_cast<const std::uint8_t*>(scan.voxels.get());
  const auto* present = static_cast<const std::uint8_t*>(before);
  for (std::size_t n = 0; n < runs_.size(); ++n) {
    const RunBytes bytes = bytesOfRun(scan, runs_[n]);
    const std::size_t last = (bytes.first + bytes.count - 1) / TouchedBlocks::kBytes;
    bool near = false;
    for (std::size_t block = bytes.first / TouchedBlocks::kBytes; block <= last; ++block)
      near = near || touched.has(block);
    if (!near || std::memcmp(original + bytes.first, present + bytes.first, bytes.count) == 0)
      continue;
    stored_.push_back(static_cast<std::uint32_t>(n));
    values_.insert(values_.end(), present + bytes.first, present + bytes.first + bytes.count);
  }
  stored_.shrink_to_fit();
  values_.shrink_to_fit();
}

void Journal::restore(const haptics::Volume& scan, void* view, const TouchedBlocks& touched) const {
  const auto* original = static_cast<const std::uint8_t*>(scan.voxels.get());
  auto* written = static_cast<std::uint8_t*>(view);
  std::size_t next = 0, value = 0;
  for (std::size_t n = 0; n < runs_.size(); ++n) {
    const RunBytes bytes = bytesOfRun(scan, runs_[n]);
    if (next < stored_.size() && stored_[next] == n) {
      std::memcpy(written + bytes.first, values_.data() + value, bytes.count);
      value += bytes.count;
      ++next;
      continue;
    }
    // where the block was the scan's before, it still is in the view
    const std::size_t end = bytes.first + bytes.count;
    for (std::size_t at = bytes.first; at < end;) {
      const std::size_t block = at / TouchedBlocks::kBytes;
      const std::size_t until = std::min(end, touched.end(block));
      if (touched.has(block)) std::memcpy(written + at, original + at, until - at);
      at = until;
    }
  }
}

std::size_t Journal::bytes() const {
  return runs_.size() * sizeof(haptics::VoxelRun) + stored_.size() * sizeof(std::uint32_t) +
         values_.size();
}

ChangedBoxes::ChangedBoxes(const haptics::Grid& grid) : dims_{grid.dims} {
  for (std::size_t a = 0; a < 3; ++a) cubes_[a] = (dims_[a] + kSide - 1) / kSide;
  changed_.resize(static_cast<std::size_t>(cubes_[0] * cubes_[1] * cubes_[2]));
}

void ChangedBoxes::add(const std::vector<haptics::VoxelRun>& runs) {
  for (const haptics::VoxelRun& run : runs) {
    const std::int64_t row = (run.k / kSide * cubes_[1] + run.j / kSide) * cubes_[0];
    for (std::int64_t c = run.i / kSide; c <= (run.i + run.count - 1) / kSide; ++c)
      changed_[static_cast<std::size_t>(row + c)] = true;
  }
}

void ChangedBoxes::add(const haptics::VoxelBox& one, const haptics::VoxelBox& other) {
  // what one has beyond the other, axis by axis
  const auto beyond = [&](haptics::VoxelBox whole, const haptics::VoxelBox& inner) {
    for (std::size_t a = 0; a < 3; ++a) {
      if (whole.first[a] >= inner.end[a] || inner.first[a] >= whole.end[a]) {
        slabs_.push_back(whole);
        return;
      }
      if (whole.first[a] < inner.first[a]) {
        slabs_.push_back(whole);
        slabs_.back().end[a] = inner.first[a];
        whole.first[a] = inner.first[a];
      }
      if (whole.end[a] > inner.end[a]) {
        slabs_.push_back(whole);
        slabs_.back().first[a] = inner.end[a];
        whole.end[a] = inner.end[a];
      }
    }
  };
  beyond(one, other);
  beyond(other, one);
}

std::vector<haptics::VoxelBox> ChangedBoxes::boxes() const {
  std::vector<bool> left = changed_;
  const auto at = [&](std::int64_t i, std::int64_t j, std::int64_t k) {
    return static_cast<std::size_t>((k * cubes_[1] + j) * cubes_[0] + i);
  };
  std::vector<haptics::VoxelBox> found;
  for (std::int64_t k = 0; k < cubes_[2]; ++k)
    for (std::int64_t j = 0; j < cubes_[1]; ++j)
      for (std::int64_t i = 0; i < cubes_[0]; ++i) {
        if (!left[at(i, j, k)]) continue;
        // as far as it goes along i, then j, then k
        std::array<std::int64_t, 3> end{i + 1, j + 1, k + 1};
        const auto all = [&](const std::array<std::int64_t, 3>& from,
                             const std::array<std::int64_t, 3>& until) {
          for (std::int64_t c = from[2]; c < until[2]; ++c)
            for (std::int64_t b = from[1]; b < until[1]; ++b)
              for (std::int64_t a = from[0]; a < until[0]; ++a)
                if (!left[at(a, b, c)]) return false;
          return true;
        };
        while (end[0] < cubes_[0] && all({end[0], j, k}, {end[0] + 1, end[1], end[2]})) ++end[0];
        while (end[1] < cubes_[1] && all({i, end[1], k}, {end[0], end[1] + 1, end[2]})) ++end[1];
        while (end[2] < cubes_[2] && all({i, j, end[2]}, {end[0], end[1], end[2] + 1})) ++end[2];
        for (std::int64_t c = k; c < end[2]; ++c)
          for (std::int64_t b = j; b < end[1]; ++b)
            for (std::int64_t a = i; a < end[0]; ++a) left[at(a, b, c)] = false;
        haptics::VoxelBox box{{i * kSide, j * kSide, k * kSide},
                              {end[0] * kSide, end[1] * kSide, end[2] * kSide}};
        for (std::size_t a = 0; a < 3; ++a) box.end[a] = std::min(box.end[a], dims_[a]);
        found.push_back(box);
      }
  found.insert(found.end(), slabs_.begin(), slabs_.end());
  return found;
}

}  // namespace datasets
