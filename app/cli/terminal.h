// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace app::cli {

/// A text as a terminal may have it: a file's name may hold anything. What would steer the terminal
/// or turn the direction of reading is written as \u001b, a byte that is no UTF-8 as \xff; with
/// `lines` the ends of lines stay.
std::string printable(std::string_view text, bool lines = false);

/// A sentence on standard error, printable.
void tell(std::string_view sentence);

/// Descriptors 0 to 2 that the caller closed are opened on nothing, so that no file of ours gets
/// their number; what is written to such a standard output fails. Before any file is opened.
void openStandardStreams();

/// Whether a path names what standard output is, such as /dev/stdout.
bool isStandardOutput(const std::string& path);

}  // namespace app::cli
