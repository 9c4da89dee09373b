// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/readers/nrrd/quiet_terminal.h"

#include <sys/types.h>
#include <unistd.h>

#include <cstddef>
#include <cstdio>

namespace datasets {
namespace {

thread_local int quiet = 0;

ssize_t writeUnlessQuiet(void*, const char* text, std::size_t size) {
  return quiet > 0 ? static_cast<ssize_t>(size) : ::write(STDERR_FILENO, text, size);
}

/// The C library lets a program put a stream of its own in place of stderr.
bool replaced() {
  FILE* stream = fopencookie(nullptr, "w", {nullptr, writeUnlessQuiet, nullptr, nullptr});
  if (stream == nullptr) return false;
  std::setvbuf(stream, nullptr, _IONBF, 0);
  stderr = stream;
  return true;
}

}  // namespace

QuietTerminal::QuietTerminal() {
  [[maybe_unused]] static const bool once = replaced();
  ++quiet;
}

QuietTerminal::~QuietTerminal() { --quiet; }

}  // namespace datasets
