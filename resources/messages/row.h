// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

namespace resources {

/// A sentence of the catalogue. %1 to %9 are the places of its arguments; %(1) is the argument
/// without its full stop, where the sentence goes on behind another one.
struct Row {
  std::string_view id;
  std::string_view english;
  std::string_view reason = {};  ///< whose entry in the help explains it; empty: it needs none
};

}  // namespace resources
