// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/core/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace haptics {

int coreCount() { return static_cast<int>(std::max(1U, std::thread::hardware_concurrency())); }

void inParallel(std::int64_t count, const std::function<void(std::int64_t)>& work, int threads) {
  std::atomic<std::int64_t> next{0};
  std::mutex mutex;
  std::exception_ptr thrown;
  const auto take = [&] {
    try {
      for (std::int64_t n; (n = next++) < count;) work(n);
    } catch (...) {
      next = count;
      const std::scoped_lock lock(mutex);
      thrown = std::current_exception();
    }
  };
  std::vector<std::jthread> others;
  try {
    while (static_cast<std::int64_t>(others.size()) + 1 < std::min<std::int64_t>(threads, count))
      others.emplace_back(take);
  } catch (const std::system_error&) {  // no thread to be had: those that run do it
  }
  take();
  others.clear();
  if (thrown) std::rethrow_exception(thrown);
}

}  // namespace haptics
