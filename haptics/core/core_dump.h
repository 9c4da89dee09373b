// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace haptics {

/// Keeps the pages of this memory, and what else lies in them, out of core dumps as long as they
/// are mapped.
void keepOutOfCoreDumps(void* first, std::size_t bytes) noexcept;

/// Keeps out of this process's core dump what may hold a voxel and was not kept out before: all
/// memory that belongs to no file, such as the heap, in pieces from 128 KiB on. What stays are the
/// stacks of the first and of the calling thread, variables of program and libraries, and small
/// pieces. Where that cannot be told, there is no core dump at all. For a signal handler: allocates
/// nothing, takes no lock and changes no errno.
void keepHeapOutOfCoreDump() noexcept;

}  // namespace haptics
