// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <link.h>

#include <span>
#include <string>

namespace app {

/// The linker's build identity among the ELF notes from `at` to `end`; empty if there is none. For
/// signal handlers too: allocates nothing.
std::span<const unsigned char> buildIdentityIn(const char* at, const char* end) noexcept;

/// The same of a module of this process, in hexadecimal.
std::string buildIdentityOf(const dl_phdr_info& module);

}  // namespace app
