// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Holds code to what HAPTICS_RT promises: no allocation, no lock, no wait, no file. A program
/// that links no_allocation.cpp has the C library's functions for these interposed by counting
/// ones; a guard tells how many of them its thread called since it was made.
namespace support {

struct Calls {
  long allocations = 0;    ///< malloc and its kin, free and operator new and delete among them
  long waits = 0;          ///< mutexes, condition variables, semaphores, sleeps, polls
  long files = 0;          ///< open, read, write
  const char* first = "";  ///< the first of them by name
  long all() const { return allocations + waits + files; }
};

/// Counts on the thread that makes it, from then on; one at a time.
class NoAllocation {
 public:
  NoAllocation();
  ~NoAllocation();
  NoAllocation(const NoAllocation&) = delete;
  NoAllocation& operator=(const NoAllocation&) = delete;
  Calls calls() const;
};

}  // namespace support
