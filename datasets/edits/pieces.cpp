// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/edits/pieces.h"

#include <algorithm>
#include <cstring>
#include <numeric>
#include <type_traits>

#include "haptics/carving/threshold.h"

namespace datasets {
namespace {

template <class T>
void solidRow(const T* values, std::int64_t first, std::int64_t end, T threshold,
              std::vector<std::uint8_t>& flags, std::uint64_t* bits, std::int64_t words) {
  // one byte a voxel, then eight bytes to eight bits
  std::uint8_t* flag = flags.data();
  for (std::int64_t i = first; i < end; ++i) flag[i] = values[i] >= threshold;
  for (std::int64_t w = 0; w < words; ++w) {
    std::uint64_t word = 0;
    for (int b = 0; b < 8; ++b) {
      std::uint64_t eight;
      std::memcpy(&eight, flag + w * 64 + b * 8, 8);
      word |= (eight * 0x0102040810204080U >> 56) << (8 * b);
    }
    bits[w] = word;
  }
}

}  // namespace

std::optional<VoxelBits> solidOf(const haptics::Volume& volume, const haptics::VoxelBox& box,
                                 double isovalue, const EditProgress& progress) {
  VoxelBits solid{volume.grid.dims};
  const auto& dims = volume.grid.dims;
  const bool done = visitVoxels(volume.type, volume.voxels.get(), [&](const auto* values) {
    using T = std::remove_cvref_t<decltype(*values)>;
    const std::optional<T> threshold = haptics::thresholdOf<T>(isovalue);
    return progress.each(box.end[2] - box.first[2], [&](std::int64_t n) {
      if (!threshold) return;
      const std::int64_t k = box.first[2] + n;
      std::vector<std::uint8_t> flags(static_cast<std::size_t>(solid.wordsInRow() * 64));
      for (std::int64_t j = box.first[1]; j < box.end[1]; ++j)
        solidRow(values + (k * dims[1] + j) * dims[0], box.first[0], box.end[0], *threshold, flags,
                 solid.row(j, k), solid.wordsInRow());
    });
  });
  if (!done) return {};
  return solid;
}

namespace {

/// Pieces that are found to be one.
class RunUnion {
 public:
  explicit RunUnion(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), std::uint32_t{0});
  }
  std::uint32_t root(std::uint32_t n) {
    while (parent_[n] != n) n = parent_[n] = parent_[parent_[n]];
    return n;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    a = root(a);
    b = root(b);
    if (a != b) parent_[std::max(a, b)] = std::min(a, b);  // the root is the first run
  }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace

std::optional<Pieces> Pieces::of(const haptics::Volume& volume, const VoxelBits& solid,
                                 double isovalue, bool saddles, const EditProgress& progress) {
  Pieces pieces;
  pieces.dims_ = solid.dims();
  const std::int64_t rows_j = solid.dims()[1], rows_k = solid.dims()[2];
  pieces.row_begins_.reserve(static_cast<std::size_t>(rows_j * rows_k + 1));
  for (std::int64_t k = 0; k < rows_k; ++k) {
    if (progress.cancelled()) return {};
    for (std::int64_t j = 0; j < rows_j; ++j) {
      pieces.row_begins_.push_back(pieces.runs_.size());
      eachRun(solid.row(j, k), solid.wordsInRow(), [&](std::int64_t first, std::int64_t end) {
        pieces.runs_.push_back({static_cast<std::int32_t>(first), static_cast<std::int32_t>(end)});
      });
    }
  }
  pieces.row_begins_.push_back(pieces.runs_.size());
  RunUnion joined{pieces.runs_.size()};

  const std::vector<Run>& runs = pieces.runs_;
  visitVoxels(volume.type, volume.voxels.get(), [&](const auto* values) {
    const auto over = [&](std::int64_t i, std::int64_t j, std::int64_t k) {
      return static_cast<double>(values[(k * solid.dims()[1] + j) * solid.dims()[0] + i]) -
             isovalue;
    };
    // a and d are in the solid, b and c opposite each other on the same face are not
    const auto crosses = [](double a, double d, double b, double c) { return a * d >= b * c; };
    // rows that are neighbours along j or along k
    const auto beside = [&](std::int64_t j, std::int64_t k, std::int64_t j2, std::int64_t k2) {
      const auto row = static_cast<std::size_t>(k * rows_j + j);
      const auto other = static_cast<std::size_t>(k2 * rows_j + j2);
      std::size_t a = pieces.row_begins_[row], b = pieces.row_begins_[other];
      const std::size_t a_end = pieces.row_begins_[row + 1], b_end = pieces.row_begins_[other + 1];
      while (a < a_end && b < b_end) {
        if (runs[a].first < runs[b].end && runs[b].first < runs[a].end) {
          joined.join(static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b));
        } else if (saddles && runs[a].end == runs[b].first) {
          const std::int64_t i = runs[a].end - 1;
          if (crosses(over(i, j, k), over(i + 1, j2, k2), over(i + 1, j, k), over(i, j2, k2)))
            joined.join(static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b));
        } else if (saddles && runs[b].end == runs[a].first) {
          const std::int64_t i = runs[b].end - 1;
          if (crosses(over(i, j2, k2), over(i + 1, j, k), over(i + 1, j2, k2), over(i, j, k)))
            joined.join(static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b));
        }
        if (runs[a].end < runs[b].end)
          ++a;
        else
          ++b;
      }
    };
    // rows across a face of the planes j, k: at the same i
    const auto across = [&](std::int64_t j, std::int64_t k, std::int64_t j2) {
      const auto row = static_cast<std::size_t>(k * rows_j + j);
      const auto other = static_cast<std::size_t>((k - 1) * rows_j + j2);
      std::size_t a = pieces.row_begins_[row], b = pieces.row_begins_[other];
      const std::size_t a_end = pieces.row_begins_[row + 1], b_end = pieces.row_begins_[other + 1];
      while (a < a_end && b < b_end) {
        const std::int64_t from = std::max(runs[a].first, runs[b].first);
        const std::int64_t until = std::min(runs[a].end, runs[b].end);
        for (std::int64_t i = from; i < until; ++i) {
          const double b_over = over(i, j2, k), c_over = over(i, j, k - 1);
          if (b_over >= 0.0 || c_over >= 0.0) break;  // joined through that voxel
          if (!crosses(over(i, j, k), over(i, j2, k - 1), b_over, c_over)) continue;
          joined.join(static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b));
          break;
        }
        if (runs[a].end < runs[b].end)
          ++a;
        else
          ++b;
      }
    };
    for (std::int64_t k = 0; k < rows_k && !progress.cancelled(); ++k)
      for (std::int64_t j = 0; j < rows_j; ++j) {
        if (j > 0) beside(j, k, j - 1, k);
        if (k > 0) beside(j, k, j, k - 1);
        if (k > 0 && j > 0 && saddles) across(j, k, j - 1);
        if (k > 0 && j + 1 < rows_j && saddles) across(j, k, j + 1);
      }
  });
  if (progress.cancelled()) return {};

  // a piece has the number of its first run among the first runs
  pieces.piece_.resize(runs.size());
  for (std::size_t n = 0; n < runs.size(); ++n) {
    const std::uint32_t root = joined.root(static_cast<std::uint32_t>(n));
    if (root == n) {
      pieces.piece_[n] = static_cast<std::uint32_t>(pieces.voxels_.size());
      pieces.voxels_.push_back(0);
    } else {
      pieces.piece_[n] = pieces.piece_[root];
    }
    pieces.voxels_[pieces.piece_[n]] += runs[n].end - runs[n].first;
  }
  return pieces;
}

std::optional<std::uint32_t> Pieces::at(std::int64_t i, std::int64_t j, std::int64_t k) const {
  const auto row = static_cast<std::size_t>(k * dims_[1] + j);
  for (std::size_t n = row_begins_[row]; n < row_begins_[row + 1]; ++n)
    if (runs_[n].first <= i && i < runs_[n].end) return piece_[n];
  return {};
}

void Pieces::mark(const std::vector<bool>& chosen, VoxelBits& bits) const {
  for (std::size_t row = 0; row + 1 < row_begins_.size(); ++row) {
    std::uint64_t* words = bits.words().data() + row * static_cast<std::size_t>(bits.wordsInRow());
    for (std::size_t n = row_begins_[row]; n < row_begins_[row + 1]; ++n)
      if (chosen[piece_[n]]) setBits(words, runs_[n].first, runs_[n].end);
  }
}

PieceOperator::PieceOperator(VoxelBits gone, VoxelBits kept, const haptics::VoxelBox& box_of_rim,
                             double isovalue_then)
    : gone_{std::move(gone)}, kept_{std::move(kept)} {
  isovalue = isovalue_then;
  // two voxels around what is gone
  haptics::VoxelBox found{box_of_rim.end, box_of_rim.first};
  for (std::int64_t k = box_of_rim.first[2]; k < box_of_rim.end[2]; ++k)
    for (std::int64_t j = box_of_rim.first[1]; j < box_of_rim.end[1]; ++j) {
      const std::uint64_t* row = gone_.row(j, k);
      bool any = false;
      for (std::int64_t w = 0; w < gone_.wordsInRow(); ++w) any = any || row[w] != 0;
      if (!any) continue;
      found.first[1] = std::min(found.first[1], j);
      found.end[1] = std::max(found.end[1], j + 1);
      found.first[2] = std::min(found.first[2], k);
      found.end[2] = std::max(found.end[2], k + 1);
    }
  box = box_of_rim;
  for (std::size_t a = 1; a < 3; ++a) {
    box.first[a] = std::max(box.first[a], found.first[a] - 2);
    box.end[a] = std::min(box.end[a], found.end[a] + 2);
  }
}

void PieceOperator::cutRow(std::int64_t j, std::int64_t k, haptics::RowCut& cut) const {
  constexpr int kMostWords = 64;  // of the row that are looked at together
  const std::int64_t words = gone_.wordsInRow();
  std::array<std::uint64_t, kMostWords> lowered{};
  const auto word = [](const std::uint64_t* row, std::int64_t w, std::int64_t count) {
    return row == nullptr || w < 0 || w >= count ? std::uint64_t{0} : row[w];
  };
  std::int64_t open_first = -1, open_end = -1;
  const auto add = [&](std::int64_t first, std::int64_t end) {
    first = std::max(first, box.first[0]);
    end = std::min(end, box.end[0]);
    if (first >= end) return;
    if (open_end == first) {
      open_end = end;
      return;
    }
    if (open_first >= 0)
      cut.spans.push_back(
          {static_cast<std::int32_t>(open_first), static_cast<std::int32_t>(open_end), true});
    open_first = first;
    open_end = end;
  };
  for (std::int64_t w0 = 0; w0 < words; w0 += kMostWords) {
    const std::int64_t n = std::min<std::int64_t>(kMostWords, words - w0);
    bool any = false;
    for (std::int64_t w = w0; w < w0 + n; ++w) {
      // the neighbours in the 26 directions, and those two steps along an axis
      std::uint64_t near_gone = 0, near_kept = 0, far_gone = 0, far_kept = 0;
      for (std::int64_t dk = -1; dk <= 1; ++dk)
        for (std::int64_t dj = -1; dj <= 1; ++dj) {
          const std::uint64_t* g = gone_.rowOrNull(j + dj, k + dk);
          const std::uint64_t* h = kept_.rowOrNull(j + dj, k + dk);
          const std::uint64_t g0 = word(g, w, words), h0 = word(h, w, words);
          near_gone |=
              g0 | g0 << 1 | g0 >> 1 | word(g, w - 1, words) >> 63 | word(g, w + 1, words) << 63;
          near_kept |=
              h0 | h0 << 1 | h0 >> 1 | word(h, w - 1, words) >> 63 | word(h, w + 1, words) << 63;
        }
      const auto twoAway = [&](const VoxelBits& bits) {
        const std::uint64_t* row = bits.row(j, k);
        const std::uint64_t here = row[w];
        return here << 2 | here >> 2 | word(row, w - 1, words) >> 62 |
               word(row, w + 1, words) << 62 | word(bits.rowOrNull(j - 2, k), w, words) |
               word(bits.rowOrNull(j + 2, k), w, words) | word(bits.rowOrNull(j, k - 2), w, words) |
               word(bits.rowOrNull(j, k + 2), w, words);
      };
      far_gone = twoAway(gone_);
      if ((near_gone | far_gone) == 0) {
        lowered[static_cast<std::size_t>(w - w0)] = 0;
        continue;
      }
      far_kept = twoAway(kept_);
      const std::uint64_t here = word(gone_.row(j, k), w, words);
      lowered[static_cast<std::size_t>(w - w0)] =
          here | ((near_gone | (far_gone & ~far_kept)) & ~near_kept);
      any = true;
    }
    if (any)
      eachRun(lowered.data(), n,
              [&](std::int64_t first, std::int64_t end) { add(w0 * 64 + first, w0 * 64 + end); });
  }
  if (open_first >= 0)
    cut.spans.push_back(
        {static_cast<std::int32_t>(open_first), static_cast<std::int32_t>(open_end), true});
}

namespace {

/// The voxel of the solid that is nearest to a place, within two voxels.
std::optional<std::array<std::int64_t, 3>> seedVoxel(const haptics::Volume& volume,
                                                     const VoxelBits& solid,
                                                     const haptics::Vec3& seed_W) {
  const haptics::Vec3 u = volume.grid.indexOf(seed_W);
  std::optional<std::array<std::int64_t, 3>> best;
  if (!u.allFinite() || u.cwiseAbs().maxCoeff() > 1e9) return best;
  constexpr double kWithin = 2.0;  // voxels
  double best_distance = kWithin;
  const auto first = [&](double v) { return static_cast<std::int64_t>(std::ceil(v - kWithin)); };
  const auto& dims = volume.grid.dims;
  for (std::int64_t k = first(u.z()); static_cast<double>(k) <= u.z() + kWithin; ++k)
    for (std::int64_t j = first(u.y()); static_cast<double>(j) <= u.y() + kWithin; ++j)
      for (std::int64_t i = first(u.x()); static_cast<double>(i) <= u.x() + kWithin; ++i) {
        if (i < 0 || j < 0 || k < 0 || i >= dims[0] || j >= dims[1] || k >= dims[2]) continue;
        if (!solid.at(i, j, k)) continue;
        const double distance =
            (haptics::Vec3{static_cast<double>(i), static_cast<double>(j), static_cast<double>(k)} -
             u)
                .norm();
        if (distance > best_distance || (best && distance == best_distance)) continue;
        best_distance = distance;
        best = {i, j, k};
      }
  return best;
}

}  // namespace

MadeOperator pieceOperator(const haptics::Volume& volume, const Edit& edit,
                           const EditWatch& watch) {
  const auto* remove = std::get_if<RemovePiece>(&edit);
  const auto* keep = std::get_if<KeepPiece>(&edit);
  const auto* small = std::get_if<RemoveSmallPieces>(&edit);
  const double isovalue = remove != nullptr ? remove->isovalue
                          : keep != nullptr ? keep->isovalue
                                            : small->isovalue;
  const haptics::VoxelBox box = volume.bounds();
  const auto solid = solidOf(volume, box, isovalue, {watch, 0.0, 0.2});
  if (!solid) return tl::unexpected(editCancelled());
  std::optional<std::array<std::int64_t, 3>> seed;
  if (small == nullptr) {
    seed = seedVoxel(volume, *solid, remove != nullptr ? remove->seed_W : keep->seed_W);
    if (!seed)
      return tl::unexpected(
          haptics::Error{haptics::Error::Kind::Unsupported, {"edit-no-piece", {}}, "no-piece"});
  }
  const auto pieces = Pieces::of(volume, *solid, isovalue, true, {watch, 0.2, 0.5});
  if (!pieces) return tl::unexpected(editCancelled());
  const double voxel_volume = volume.grid.spacing.prod();
  std::vector<bool> goes(pieces->count(), keep != nullptr);
  if (seed)
    goes[*pieces->at((*seed)[0], (*seed)[1], (*seed)[2])] = remove != nullptr;
  else
    for (std::uint32_t n = 0; n < pieces->count(); ++n)
      goes[n] = static_cast<double>(pieces->voxelsOf(n)) * voxel_volume < small->least_volume;
  VoxelBits gone{volume.grid.dims};
  pieces->mark(goes, gone);
  VoxelBits kept = *solid;
  for (std::size_t w = 0; w < kept.words().size(); ++w) kept.words()[w] &= ~gone.words()[w];
  return std::make_unique<PieceOperator>(std::move(gone), std::move(kept), box, isovalue);
}

}  // namespace datasets
