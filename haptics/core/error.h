// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <tl/expected.hpp>

namespace haptics {

/// Why something could not be set up. Never crosses the servo thread.
struct Error {
  enum class Kind {
    NotFound,
    Unsupported,
    Malformed,
    Cancelled,
    Correctable  ///< can be used after a correction to which the user agrees
  };
  Kind kind = Kind::Malformed;
  std::string what;         ///< One sentence for the user: names the thing, and what to try.
  std::string reason = {};  ///< A word for programs: "truncated", "sheared", …
};

template <class T>
using Expected = tl::expected<T, Error>;  // C++20: std::expected arrives with C++23

}  // namespace haptics
