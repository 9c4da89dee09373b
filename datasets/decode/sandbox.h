// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace datasets::decode {

/// From here on the process can compute, read and write its standard input and output, ask for
/// memory up to what it has now plus `more_bytes`, and end. It can open no file, no socket and no
/// program (seccomp; the kernel kills it for trying), writes no core file, and cannot gain rights.
/// False if the system does not grant that, in which case nothing foreign may be decoded.
/// Under a sanitizer, which needs more of the system, only the core file is forbidden.
[[nodiscard]] bool confine(std::uint64_t more_bytes);

}  // namespace datasets::decode
