// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cassert>
#include <cstddef>

#include "haptics/core/realtime.h"

namespace haptics {

/// A vector that never allocates: at most N elements, in place. push() on a full one
/// returns false, and the caller handles it.
template <class T, std::size_t N>
class FixedVector {
 public:
  /// Appends and returns true, or returns false if there is no room.
  bool push(const T& value) HAPTICS_RT {
    if (size_ == N) return false;
    items_[size_++] = value;
    return true;
  }
  void clear() HAPTICS_RT { size_ = 0; }
  /// Removes element i; the last element takes its place.
  void dropUnordered(std::size_t i) HAPTICS_RT {
    assert(i < size_);
    items_[i] = items_[--size_];
  }

  std::size_t size() const HAPTICS_RT { return size_; }
  bool empty() const HAPTICS_RT { return size_ == 0; }
  bool full() const HAPTICS_RT { return size_ == N; }
  static constexpr std::size_t capacity() { return N; }

  T& operator[](std::size_t i) HAPTICS_RT { return items_[i]; }
  const T& operator[](std::size_t i) const HAPTICS_RT { return items_[i]; }
  T* begin() HAPTICS_RT { return items_.data(); }
  T* end() HAPTICS_RT { return items_.data() + size_; }
  const T* begin() const HAPTICS_RT { return items_.data(); }
  const T* end() const HAPTICS_RT { return items_.data() + size_; }

 private:
  std::array<T, N> items_{};
  std::size_t size_ = 0;
};

}  // namespace haptics
