// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace haptics {

/// Whether this is a sanitizer's build: it needs terabytes of addresses, and system calls of its
/// own.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool kSanitized = true;
#elif defined(__has_feature)
inline constexpr bool kSanitized =
    __has_feature(address_sanitizer) || __has_feature(thread_sanitizer);
#else
inline constexpr bool kSanitized = false;
#endif

/// Limits a resource (RLIMIT_CORE and so on) of this process for good. False if that failed.
bool limitResource(int resource, std::uint64_t most);

/// This process leaves no core dump, and who runs it cannot read its memory. False if that failed.
bool forbidCoreDumps();

/// Limits the address space to what is in use and this much more, bytes. False if that failed.
bool limitAddresses(std::uint64_t more_bytes);

}  // namespace haptics
