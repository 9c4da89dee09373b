// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/scene/pages_ahead.h"

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <optional>

namespace haptics {
namespace {

constexpr double kAhead = 2e-3;                     // m: farther than what is written next
constexpr std::chrono::milliseconds kLookEvery{2};  // a hand at 0.25 m/s goes a quarter of kAhead

}  // namespace

PagesAhead::PagesAhead(std::shared_ptr<const Volume> volume, double reach)
    : volume_{std::move(volume)}, reach_{reach} {
  for (auto& axis : place_) axis.store(std::numeric_limits<float>::quiet_NaN());
  thread_ = std::thread{[this] { run(); }};
}

PagesAhead::~PagesAhead() {
  {
    const std::scoped_lock lock(mutex_);
    ending_ = true;
  }
  ended_.notify_one();
  thread_.join();
}

void PagesAhead::at(const Vec3& p_W) HAPTICS_RT {
  for (std::size_t axis = 0; axis < 3; ++axis)
    place_[axis].store(static_cast<float>(p_W[static_cast<Eigen::Index>(axis)]),
                       std::memory_order_relaxed);
}

void PagesAhead::run() {
  std::optional<Vec3> copied;
  std::unique_lock lock(mutex_);
  while (!ended_.wait_for(lock, kLookEvery, [&] { return ending_; })) {
    const Vec3 p(double(place_[0].load(std::memory_order_relaxed)),
                 double(place_[1].load(std::memory_order_relaxed)),
                 double(place_[2].load(std::memory_order_relaxed)));
    if (!p.allFinite() || (copied && (p - *copied).norm() < 0.25 * kAhead)) continue;
    lock.unlock();
    const bool works = copyAround(p);
    lock.lock();
    if (!works) return;
    copied = p;
  }
}

bool PagesAhead::copyAround(const Vec3& p_W) const {
  const Volume& volume = *volume_;
  const VoxelBox bounds = volume.bounds();
  const Vec3 u = volume.grid.indexOf(p_W);
  VoxelBox box;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto of = static_cast<Eigen::Index>(axis);
    const double half = (reach_ + kAhead) / volume.grid.spacing[of];
    const auto inside = [&](double index) {
      return static_cast<std::int64_t>(
          std::clamp(index, double(bounds.first[axis]), double(bounds.end[axis])));
    };
    box.first[axis] = inside(std::floor(u[of] - half));
    box.end[axis] = inside(std::ceil(u[of] + half) + 1.0);
    if (box.end[axis] <= box.first[axis]) return true;
  }
  const auto page = static_cast<std::uintptr_t>(::sysconf(_SC_PAGESIZE));
  const auto& dims = volume.grid.dims;
  const std::size_t size = sizeOf(volume.type);
  const auto begin = reinterpret_cast<std::uintptr_t>(volume.voxels.get());
  const auto addressOf = [&](std::int64_t i, std::int64_t j, std::int64_t k) {
    return begin + static_cast<std::uintptr_t>((k * dims[1] + j) * dims[0] + i) * size;
  };
  for (std::int64_t k = box.first[2]; k < box.end[2]; ++k) {
    // whole rows in between: they are shorter than a page, or few
    const std::uintptr_t first = addressOf(box.first[0], box.first[1], k) / page * page;
    const std::uintptr_t last = addressOf(box.end[0] - 1, box.end[1] - 1, k);
    if (::madvise(reinterpret_cast<void*>(first), last + size - first, MADV_POPULATE_WRITE) != 0)
      return false;
  }
  return true;
}

}  // namespace haptics
