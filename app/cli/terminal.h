// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace app::cli {

/// Makes a text safe for a terminal, since a file's name may contain any bytes. Control characters
/// and characters that change the direction of text are written like \u001b, bytes that are not
/// UTF-8 like \xff. With `lines`, line ends stay.
std::string printable(std::string_view text, bool lines = false);

/// A sentence on standard error, printable.
void tell(std::string_view sentence);

/// Opens descriptors 0 to 2 on /dev/null if the caller closed them, so that no other file gets
/// their number. Writing to such a standard output fails. Call it before any file is opened.
void openStandardStreams();

/// Whether a path is the same file as standard output, such as /dev/stdout.
bool isStandardOutput(const std::string& path);

}  // namespace app::cli
