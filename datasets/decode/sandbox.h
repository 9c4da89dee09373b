// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace datasets::decode {

/// Restricts the process from now on. It can compute, read standard input, write standard output,
/// grow its address space by `more_bytes`, and end. It cannot open a file, a socket or a program
/// (seccomp: the kernel kills it for the attempt), writes no core file, and cannot gain rights.
/// Returns false if the system refuses; then decode nothing. Under a sanitizer, which needs more
/// system calls, only the core file is forbidden.
[[nodiscard]] bool confine(std::uint64_t more_bytes);

}  // namespace datasets::decode
