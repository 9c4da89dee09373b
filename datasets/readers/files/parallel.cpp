// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/readers/files/parallel.h"

#include <sys/resource.h>
#include <unistd.h>
#include <vtkObjectFactory.h>

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace datasets {
namespace {

constexpr int kLowPriority = 10;  // a nice value: the touch and the window go first

}  // namespace

std::size_t workersFor(std::size_t count) {
  return std::clamp<std::size_t>(count, 1, std::max(1U, std::thread::hardware_concurrency()));
}

bool onAllCores(std::size_t count, const ReadProgress& progress,
                const std::function<bool(std::size_t)>& work) {
  std::atomic<std::size_t> next = 0;
  std::atomic<bool> stop = false;
  std::exception_ptr thrown;
  std::mutex mutex;
  std::condition_variable news;
  std::size_t running = workersFor(count), done = 0;
  const std::thread::id caller = std::this_thread::get_id();
  const auto worker = [&] {
    if (std::this_thread::get_id() != caller)
      setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), kLowPriority);
    try {
      for (std::size_t i = next++; i < count && !stop; i = next++) {
        if (progress.isCancelled() || !work(i)) stop = true;
        const std::scoped_lock lock(mutex);
        ++done;
        news.notify_one();
      }
    } catch (...) {
      stop = true;
      const std::scoped_lock lock(mutex);
      thrown = std::current_exception();
    }
    const std::scoped_lock lock(mutex);
    --running;
    news.notify_one();
  };
  // VTK sets up its factories with the first object made, which two threads may not do at once
  vtkObjectFactory::GetRegisteredFactories();
  std::vector<std::jthread> workers;
  const std::size_t wanted = running;
  try {
    while (workers.size() < wanted) workers.emplace_back(worker);
  } catch (const std::system_error&) {  // no thread to be had: those that run do it
    const std::scoped_lock lock(mutex);
    running -= wanted - workers.size();
    if (workers.empty()) ++running;
  }
  if (workers.empty()) worker();
  std::unique_lock lock(mutex);
  for (std::size_t told = 0; running > 0;) {
    news.wait(lock, [&] { return running == 0 || done > told; });
    told = done;
    lock.unlock();
    progress.advanced(static_cast<double>(told) /
                      static_cast<double>(std::max<std::size_t>(count, 1)));
    lock.lock();
  }
  lock.unlock();
  workers.clear();
  if (thrown) std::rethrow_exception(thrown);
  return !stop && !progress.isCancelled();
}

}  // namespace datasets
