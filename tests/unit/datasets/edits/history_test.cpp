// SPDX-License-Identifier: BSD-3-Clause
// Undo and redo restore every byte, whatever was done in between, and memory grows by what is
// touched alone.
#include <gtest/gtest.h>

#include <atomic>
#include <cstring>
#include <fstream>
#include <iostream>
#include <new>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "datasets/edits/edit_history.h"
#include "datasets/edits/edited.h"
#include "datasets/edits/operators.h"
#include "datasets/phantoms/making.h"
#include "datasets/phantoms/sampling.h"
#include "tests/support/made.h"
#include "tests/support/millimetre.h"
#include "tests/support/sentence.h"

namespace {

using namespace datasets;
using namespace haptics;
using datasets::Random;
using millimetre::h;

std::size_t bytesOf(const Volume& volume) {
  return std::size_t(volume.grid.voxelCount()) * sizeOf(volume.type);
}
std::vector<char> copyOf(const Volume& volume) {
  const auto* first = static_cast<const char*>(volume.voxels.get());
  return {first, first + bytesOf(volume)};
}
bool holds(const Volume& volume, const std::vector<char>& bytes) {
  return std::memcmp(volume.voxels.get(), bytes.data(), bytes.size()) == 0;
}

/// Blobs of many sizes in noise.
std::shared_ptr<const Volume> blobs(std::int64_t side, unsigned seed) {
  Random random{seed};
  struct Blob {
    Vec3 at;
    double radius;
  };
  std::vector<Blob> all;
  const double half = 0.5 * double(side) * h;
  for (int n = 0; n < 40; ++n) all.push_back({random.box(half), random.in(2.0, 9.0) * h});
  const Grid grid = datasets::centredGrid(side, h);
  return made::shared(datasets::filled(
      grid, ScalarType::Int16, [&](std::int64_t i, std::int64_t j, std::int64_t k) {
        const Vec3 p = grid.worldOf(Vec3{double(i), double(j), double(k)});
        double least = 1.0;
        for (const Blob& blob : all) least = std::min(least, (p - blob.at).norm() - blob.radius);
        return -1000.0 + 2000.0 * std::clamp(0.65 - least / (2 * h), 0.0, 1.0) +
               random.in(-50.0, 50.0);
      }));
}

Edit randomEdit(const Grid& grid, Random& random) {
  const double half = 0.5 * double(grid.dims[0]) * h;
  switch (random.below(7)) {
    case 0: {
      Crop crop;
      for (std::size_t a = 0; a < 3; ++a) {
        crop.kept.first[a] = random.below(6);
        crop.kept.end[a] = grid.dims[a] - random.below(6);
      }
      return crop;
    }
    case 1: {
      const Vec3 out = random.direction();
      return PlaneCut{out * half * random.in(0.6, 1.2), out, random.in(-200.0, 400.0)};
    }
    case 2: {
      LassoCut cut;
      const Quat turn = random.rotation();
      cut.X_WC = poseOf(turn * Vec3{0.0, 0.0, 0.2}, turn);
      cut.parallel = random.below(2) == 0;
      const double x = random.in(-0.02, 0.02), y = random.in(-0.02, 0.02);
      const double scale = cut.parallel ? 1.0 : 5.0;
      for (int n = 0; n < 9; ++n)
        cut.outline.push_back(
            {scale * (x + 0.004 * std::cos(n * 0.7)), scale * (y + 0.004 * std::sin(n * 0.7))});
      cut.until = random.in(0.19, 0.3);
      cut.isovalue = random.in(-200.0, 400.0);
      return cut;
    }
    case 3:
      return RemovePiece{random.box(half), random.in(-200.0, 400.0)};
    case 4:
      return RemovePiece{random.box(half), random.in(600.0, 900.0)};
    case 5: {
      std::vector<BurrCut> cuts;
      const double radius = random.in(1.0, 6.0) * h, isovalue = random.in(-200.0, 400.0);
      Vec3 at = random.box(half);
      for (int n = random.below(30); n >= 0; --n) {
        const Vec3 to = at + 0.5 * radius * random.direction();
        cuts.push_back({at, to, radius, isovalue});
        at = to;
      }
      return Stroke{std::move(cuts)};
    }
    default:
      return RemoveSmallPieces{random.in(-200.0, 900.0), random.in(1.0, 200.0) * h * h * h};
  }
}

/// Every voxel that differs between the two, and every part of the crops, lies in a box.
void expectInBoxes(const Volume& one, const Volume& other, const std::vector<VoxelBox>& boxes) {
  const auto& dims = one.grid.dims;
  const auto in = [](const VoxelBox& box, const std::array<std::int64_t, 3>& at) {
    for (std::size_t a = 0; a < 3; ++a)
      if (at[a] < box.first[a] || at[a] >= box.end[a]) return false;
    return true;
  };
  const auto* a = static_cast<const std::int16_t*>(one.voxels.get());
  const auto* b = static_cast<const std::int16_t*>(other.voxels.get());
  std::int64_t outside = 0;
  for (std::int64_t k = 0, n = 0; k < dims[2]; ++k)
    for (std::int64_t j = 0; j < dims[1]; ++j)
      for (std::int64_t i = 0; i < dims[0]; ++i, ++n) {
        const std::array<std::int64_t, 3> at{i, j, k};
        if (a[n] == b[n] && in(one.bounds(), at) == in(other.bounds(), at)) continue;
        bool found = false;
        for (const VoxelBox& box : boxes) found = found || in(box, at);
        outside += !found;
      }
  EXPECT_EQ(outside, 0);
}

/// Goes back and forth in a history, and holds each volume to what its edits make of the scan.
void wander(std::size_t journal_limit, unsigned seed, int steps) {
  Random random{seed};
  const auto scan = blobs(70, seed);
  const std::vector<char> original = copyOf(*scan);
  EditHistory history{scan, journal_limit};
  std::vector<std::vector<char>> bytes{original};  // after each edit in force
  std::vector<std::optional<VoxelBox>> crops{{}};
  std::vector<std::uint64_t> digests{0};
  std::size_t at = 0, deepest = 0;
  int undone = 0, redone = 0;
  for (int n = 0; n < steps; ++n) {
    const auto before = history.present();
    const std::vector<char> held = copyOf(*before);
    const int what = n < steps / 2 ? 0 : random.below(5);
    if (what <= 1) {
      const Edit edit = randomEdit(scan->grid, random);
      const auto volume = history.apply(edit);
      if (!volume) {
        ASSERT_TRUE(volume.error().reason == "nothing" || volume.error().reason == "no-piece")
            << sentence(volume.error());
        ASSERT_EQ(history.present(), before);
        continue;
      }
      ++at;
      bytes.resize(at);
      crops.resize(at);
      digests.resize(at);
      bytes.push_back(copyOf(**volume));
      crops.push_back((*volume)->crop);
      digests.push_back(editedOf(**volume)->digest);
      const auto fresh = edited(scan, history.edits());
      ASSERT_TRUE(fresh) << sentence(fresh.error());
      ASSERT_TRUE(holds(**fresh, bytes.back()));
      ASSERT_EQ(editedOf(**fresh)->digest, digests.back());
      ASSERT_EQ((*fresh)->crop, crops.back());
      expectInBoxes(*scan, **fresh, (*fresh)->derivation->changed);
      ASSERT_FALSE(history.canRedo());
    } else if (what <= 3) {
      ASSERT_EQ(history.canUndo(), at > 0);
      if (at == 0) continue;
      ASSERT_TRUE(history.undo());
      --at;
      ++undone;
    } else {
      ASSERT_EQ(history.canRedo(), at + 1 < bytes.size());
      if (!history.canRedo()) {
        ASSERT_FALSE(history.redo());
        continue;
      }
      ASSERT_TRUE(history.redo());
      ++at;
      ++redone;
    }
    deepest = std::max(deepest, at);
    const Volume& now = *history.present();
    ASSERT_EQ(history.edits().size(), at);
    ASSERT_TRUE(holds(now, bytes[at])) << "step " << n << ", " << at << " edits";
    ASSERT_EQ(now.crop, crops[at]);
    ASSERT_EQ(now.derivation == nullptr, at == 0);
    if (at > 0) {
      ASSERT_EQ(editedOf(now)->digest, digests[at]);
      ASSERT_EQ(now.derivation->scan, scan);
      ASSERT_EQ(editedOf(now)->edits.size(), at);
      ASSERT_EQ(now.derivation->neighbour.lock(), before);
      expectInBoxes(*before, now, now.derivation->changed);
    } else {
      ASSERT_EQ(history.present(), scan);
    }
    // what somebody still holds is as it was
    ASSERT_TRUE(holds(*before, held));
  }
  while (history.canUndo()) ASSERT_TRUE(history.undo());
  EXPECT_TRUE(holds(*history.present(), original));
  EXPECT_EQ(history.present(), scan);
  EXPECT_GE(deepest, std::size_t(steps) / 5);
  EXPECT_GT(undone, steps / 10);
  EXPECT_GT(redone, 0);
}

TEST(EditHistory, RestoresEveryByte) { wander(EditHistory::kJournalLimit, 201, 160); }
TEST(EditHistory, RestoresEveryByteBeyondItsJournal) {
  wander(std::size_t{200} << 10, 202, 60);
  wander(0, 203, 40);
}

TEST(EditHistory, HasRoomForFiftyStepsAndKeepsItsLimit) {
  const auto scan = blobs(60, 204);
  Random random{204};
  for (const std::size_t limit : {EditHistory::kJournalLimit, std::size_t{64} << 10}) {
    EditHistory history{scan, limit};
    while (history.edits().size() < 50) {
      (void)history.apply(randomEdit(scan->grid, random));
      ASSERT_LE(history.journalBytes(), limit);
    }
    EXPECT_GT(history.journalBytes(), 0U);
    int undone = 0;
    for (; history.canUndo(); ++undone) ASSERT_TRUE(history.undo());
    EXPECT_EQ(undone, 50);
    int redone = 0;
    for (; history.canRedo(); ++redone) ASSERT_TRUE(history.redo());
    EXPECT_EQ(redone, 50);
    ASSERT_TRUE(history.reset());
    EXPECT_EQ(history.present(), scan);
    for (redone = 0; history.canRedo(); ++redone) ASSERT_TRUE(history.redo());
    EXPECT_EQ(redone, 50);
  }
}

TEST(EditHistory, TakesFiftyStrokesBackToTheByte) {
  const auto scan = blobs(70, 8);
  EditHistory history{scan};
  Random random{8};
  std::vector<std::vector<char>> bytes{copyOf(*scan)};
  while (bytes.size() <= 50) {
    // each a way of its own through the blobs
    std::vector<BurrCut> cuts;
    Vec3 at = random.box(0.3 * 70 * h);
    for (int n = 0; n < 40; ++n) {
      const Vec3 to = at + 0.3 * h * random.direction();
      cuts.push_back({at, to, 2.0 * h, 100.0});
      at = to;
    }
    const auto volume = history.apply(Stroke{std::move(cuts)});
    if (volume) bytes.push_back(copyOf(**volume));  // else it met nothing
  }
  for (std::size_t n = 50; n-- > 0;) {
    const auto volume = history.undo();
    ASSERT_TRUE(volume);
    ASSERT_TRUE(holds(**volume, bytes[n])) << n;
  }
  EXPECT_EQ(history.present(), scan);
  for (std::size_t n = 1; n <= 50; ++n) ASSERT_TRUE(holds(*history.redo().value(), bytes[n])) << n;
}

TEST(EditHistory, IsAsItWasAfterACancelledEdit) {
  const auto scan = blobs(60, 205);
  Random random{205};
  EditHistory history{scan};
  int cancelled = 0, in_the_middle = 0;
  for (int n = 0; n < 60; ++n) {
    const auto before = history.present();
    const std::size_t edits = history.edits().size();
    std::atomic<bool> cancel{false};
    const double at = random.in(0.0, 1.0);
    double furthest = 0.0;
    EditWatch watch{&cancel, [&](double fraction) {
                      EXPECT_GE(fraction, 0.0);
                      EXPECT_LE(fraction, 1.0);
                      furthest = fraction;
                      if (fraction >= at) cancel = true;
                    }};
    const auto volume = history.apply(randomEdit(scan->grid, random), watch);
    if (volume) continue;
    if (volume.error().kind != Error::Kind::Cancelled) continue;
    ++cancelled;
    in_the_middle += furthest > 0.1;
    ASSERT_EQ(history.present(), before);
    ASSERT_EQ(history.edits().size(), edits);
    const auto fresh = edited(scan, history.edits());
    ASSERT_TRUE(fresh);
    ASSERT_TRUE(holds(*before, copyOf(**fresh)));
  }
  EXPECT_GT(cancelled, 10);
  EXPECT_GT(in_the_middle, 5);
  std::atomic<bool> cancel{true};
  while (history.edits().size() < 3) (void)history.apply(randomEdit(scan->grid, random));
  const auto before = history.present();
  EXPECT_FALSE(history.undo({&cancel, {}}));
  EXPECT_FALSE(history.reset({&cancel, {}}));
  EXPECT_EQ(history.present(), before);
  EXPECT_TRUE(history.undo());
}

TEST(EditHistory, IsAsItWasWhereMemoryEnds) {
  const auto scan = blobs(60, 211);
  const EditWatch watch{nullptr, [](double) { throw std::bad_alloc{}; }};
  const Edit edit = PlaneCut{Vec3::Zero(), Vec3::UnitY(), 300.0};
  int ended = 0;
  for (int n = 0; n < 12; ++n) {
    // without a journal an undo applies the first edit again
    EditHistory history{scan, 0};
    ASSERT_TRUE(history.apply(PlaneCut{{0.0, 0.0, 10 * h}, Vec3::UnitZ(), 300.0}));
    ASSERT_TRUE(history.apply(RemoveSmallPieces{300.0, 50 * h * h * h}));
    const auto before = history.present();
    const auto expectAsItWas = [&](const auto& result) {
      if (result) return false;  // the other thread did it all, and told nobody
      EXPECT_EQ(result.error().reason, "too-large");
      EXPECT_FALSE(sentence(result.error()).empty());
      EXPECT_EQ(history.present(), before);
      EXPECT_EQ(history.edits().size(), 2U);
      ++ended;
      return true;
    };
    expectAsItWas(removalOf(*before, edit, 300.0, watch));
    expectAsItWas(edited(scan, history.edits(), watch));
    if (expectAsItWas(history.apply(edit, watch)) && expectAsItWas(history.undo(watch))) {
      ASSERT_TRUE(history.undo());
      EXPECT_EQ(history.edits().size(), 1U);
    }
  }
  EXPECT_GT(ended, 12);
}

TEST(EditProgress, CarriesOverWhatEitherThreadThrows) {
  const EditWatch watch;
  const EditProgress progress{watch, 0.0, 1.0};
  const auto here = std::this_thread::get_id();
  for (const bool second : {false, true}) {
    if (second && std::thread::hardware_concurrency() < 2) continue;
    std::atomic<bool> thrown{false};
    EXPECT_THROW(progress.each(1000,
                               [&](std::int64_t) {
                                 if ((std::this_thread::get_id() != here) == second) {
                                   thrown = true;
                                   throw std::bad_alloc{};
                                 }
                                 while (!thrown) std::this_thread::yield();
                               }),
                 std::bad_alloc);
  }
}

TEST(EditHistory, TellsWhatItDoesNotDo) {
  const auto scan = blobs(40, 206);
  EditHistory history{scan};
  EXPECT_EQ(history.undo().error().reason, "nothing");
  EXPECT_EQ(history.redo().error().reason, "nothing");
  EXPECT_EQ(history.reset().error().reason, "nothing");
  EXPECT_EQ(history.apply(Crop{{{0, 0, 0}, {40, 40, 40}}}).error().reason, "nothing");
  EXPECT_EQ(history.apply(Crop{{{0, 0, 0}, {41, 40, 40}}}).error().reason, "outside");
  EXPECT_EQ(history.apply(PlaneCut{{0.0, 0.0, 1.0}, Vec3::UnitZ(), 300.0}).error().reason,
            "nothing");
  Volume loose = *scan;
  loose.memory.reset();
  EditHistory other{made::shared(loose)};
  const auto volume = other.apply(PlaneCut{Vec3::Zero(), Vec3::UnitZ(), 300.0});
  ASSERT_FALSE(volume);
  EXPECT_EQ(volume.error().reason, "not-editable");
  EXPECT_FALSE(sentence(volume.error()).empty());
}

TEST(EditHistory, WidensACropAgainAndWritesNoVoxelForIt) {
  const auto scan = blobs(40, 207);
  EditHistory history{scan};
  ASSERT_TRUE(history.apply(Crop{{{5, 5, 5}, {20, 30, 30}}}));
  EXPECT_EQ(history.present()->voxels, scan->voxels);
  ASSERT_TRUE(history.apply(Crop{{{0, 5, 5}, {25, 30, 30}}}));
  EXPECT_EQ(history.present()->bounds(), (VoxelBox{{0, 5, 5}, {25, 30, 30}}));
  ASSERT_TRUE(history.apply(Crop{{{0, 0, 0}, {40, 40, 40}}}));
  EXPECT_FALSE(history.present()->crop);
  ASSERT_TRUE(history.undo());
  ASSERT_TRUE(history.undo());
  EXPECT_EQ(history.present()->bounds(), (VoxelBox{{5, 5, 5}, {20, 30, 30}}));
}

TEST(EditHistory, KeepsWhatMayNotBeCutAndTakesThatBackToo) {
  const auto scan = blobs(40, 209);
  EditHistory history{scan};
  std::vector<VoxelRun> runs;
  for (std::int32_t k = 10; k < 30; ++k)
    for (std::int32_t j = 10; j < 30; ++j) runs.push_back({20, j, k, 12});
  const TissueTable kept{scan->grid.dims, {{.structure = 0, .runs = runs}}};
  std::vector<BurrCut> cuts;
  for (int n = 0; n < 60; ++n) {
    const Vec3 at = scan->grid.worldOf(Vec3(10.0 + 0.4 * n, 20.0, 20.0));
    cuts.push_back({at, at, 3.0 * h, 100.0});
  }
  const auto apart = history.apply(Stroke{cuts}).value();
  ASSERT_TRUE(history.undo());
  ASSERT_TRUE(history.apply(kept));
  EXPECT_EQ(history.present()->voxels, scan->voxels);
  EXPECT_FALSE(history.apply(TissueTable{{1, 2, 3}, {{.structure = 0}}}));  // of another scan
  ASSERT_TRUE(history.apply(Stroke{cuts}));
  std::int64_t spared = 0;
  const auto expectKept = [&](const Volume& volume) {
    visitVoxels(scan->type, scan->voxels.get(), [&](const auto* before) {
      using T = std::remove_cvref_t<decltype(*before)>;
      const T* after = static_cast<const T*>(volume.voxels.get());
      const T* uncut = static_cast<const T*>(apart->voxels.get());
      const auto& dims = scan->grid.dims;
      for (std::int64_t n = 0; n < scan->grid.voxelCount(); ++n) {
        const std::int64_t i = n % dims[0], j = n / dims[0] % dims[1], k = n / (dims[0] * dims[1]);
        const bool never = i >= 20 && i < 32 && j >= 10 && j < 30 && k >= 10 && k < 30;
        ASSERT_EQ(after[n], never ? before[n] : uncut[n]);
        spared += never && uncut[n] != before[n];
      }
    });
  };
  expectKept(*history.present());
  EXPECT_GT(spared, 100);
  // read again from their text, as a recording and a view have them
  std::vector<Edit> again;
  for (const Edit& edit : history.edits()) again.push_back(editFrom(textOf(edit)).value());
  expectKept(*edited(scan, again).value());
  ASSERT_TRUE(history.undo());
  ASSERT_TRUE(history.undo());
  EXPECT_EQ(history.present()->tissues, nullptr);
  ASSERT_TRUE(history.apply(Stroke{cuts}));
  EXPECT_TRUE(holds(*history.present(), copyOf(*apart)));
}

TEST(EditHistory, GivesOtherVoxelsAnotherDigest) {
  const auto scan = blobs(40, 208);
  std::set<std::uint64_t> digests;
  int volumes = 0;
  const auto add = [&](const Edit& edit) {
    const std::vector<Edit> edits{edit};
    const auto volume = edited(scan, edits);
    ASSERT_TRUE(volume) << sentence(volume.error());
    digests.insert(editedOf(**volume)->digest);
    ++volumes;
  };
  for (int n = 0; n < 10; ++n) {
    add(PlaneCut{{0.0, 0.0, n * 1e-4}, Vec3::UnitZ(), 300.0});
    add(PlaneCut{{0.0, 0.0, 0.0}, Vec3::UnitZ(), 300.0 + n + 1});
    add(Crop{{{0, 0, n + 1}, {40, 40, 40}}});
    add(Crop{{{0, 0, 0}, {40, 40 - n - 1, 40}}});
  }
  EXPECT_EQ(digests.size(), std::size_t(volumes));
}

TEST(EditHistory, GivesEqualVoxelsInAnotherPlaceAnotherDigest) {
  const Grid grid = datasets::centredGrid(32, h);
  const auto scan = made::shared(
      datasets::filled(grid, ScalarType::Int16, [](std::int64_t i, std::int64_t j, std::int64_t k) {
        return i % 16 >= 4 && i % 16 < 8 && j > 4 && j < 9 && k > 4 && k < 9 ? 900.0 : -1000.0;
      }));
  std::set<std::uint64_t> digests;
  for (const double i : {5.0, 21.0}) {
    const std::vector<Edit> edits{RemovePiece{grid.worldOf(Vec3{i, 6.0, 6.0}), 300.0}};
    digests.insert(editedOf(**edited(scan, edits))->digest);
  }
  EXPECT_EQ(digests.size(), 2U);
}

/// Bytes of private memory of the mapping that holds these voxels.
std::size_t privateBytes(const Volume& volume) {
  std::ifstream maps{"/proc/self/smaps"};
  const auto at = reinterpret_cast<std::uintptr_t>(volume.voxels.get());
  bool here = false;
  for (std::string line; std::getline(maps, line);) {
    std::uintptr_t first = 0, end = 0;
    unsigned long kilobytes = 0;
    if (std::sscanf(line.c_str(), "%lx-%lx ", &first, &end) == 2 && line.find('-') < line.find(' '))
      here = first <= at && at < end;
    else if (here && std::sscanf(line.c_str(), "Anonymous: %lu kB", &kilobytes) == 1)
      return kilobytes * 1024;
  }
  ADD_FAILURE() << "no mapping of the voxels";
  return 0;
}

TEST(EditHistory, TakesMemoryForTouchedPagesAlone) {
  if (made::kSanitized) GTEST_SKIP() << "the sanitizer's shadow changes what pages hold";
  constexpr std::size_t kPage = 4096;
  const auto scan = blobs(128, 209);
  EditHistory history{scan};
  const auto pagesThatDiffer = [&] {
    const auto* then = static_cast<const char*>(scan->voxels.get());
    const auto* now = static_cast<const char*>(history.present()->voxels.get());
    std::size_t count = 0;
    for (std::size_t at = 0; at < bytesOf(*scan); at += kPage)
      count += std::memcmp(then + at, now + at, std::min(kPage, bytesOf(*scan) - at)) != 0;
    return count;
  };
  // the last eighth of the slices
  ASSERT_TRUE(history.apply(PlaneCut{{0.0, 0.0, 48 * h}, Vec3::UnitZ(), 300.0}));
  const std::size_t slices = pagesThatDiffer() * kPage;
  std::cout << "an eighth of the slices: " << slices << " bytes differ by pages, "
            << privateBytes(*history.present()) << " are private, of " << bytesOf(*scan) << "\n";
  EXPECT_GT(slices, bytesOf(*scan) / 10);
  EXPECT_LE(privateBytes(*history.present()), slices + 2 * kPage);
  EXPECT_LT(slices, bytesOf(*scan) / 5);
  ASSERT_TRUE(history.apply(RemoveSmallPieces{300.0, 100 * h * h * h}));
  EXPECT_LE(privateBytes(*history.present()), (pagesThatDiffer() + 2) * kPage);
  // what is undone is given back
  ASSERT_TRUE(history.apply(PlaneCut{Vec3::Zero(), Vec3::UnitZ(), 300.0}));
  const std::size_t most = privateBytes(*history.present());
  ASSERT_TRUE(history.undo());
  EXPECT_LT(privateBytes(*history.present()), most / 2);
  EXPECT_LE(privateBytes(*history.present()), (pagesThatDiffer() + 2) * kPage);
}

}  // namespace
