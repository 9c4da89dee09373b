// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/readers/quiet_terminal.h"

#include <dlfcn.h>
#include <sys/types.h>
#include <unistd.h>

#include <cstddef>
#include <cstdio>
#include <initializer_list>

namespace datasets {
namespace {

thread_local int quiet = 0;

ssize_t writeUnlessQuiet(void*, const char* text, std::size_t size) {
  return quiet > 0 ? static_cast<ssize_t>(size) : ::write(STDERR_FILENO, text, size);
}

/// The codec library under vtk-dicom warns through C++ streams; it comes without headers, so its
/// switches are looked up by name, and missing ones are no harm.
void silenceCodecs() {
  for (const char* name :
       {"_ZN4gdcm5Trace10WarningOffEv", "_ZN4gdcm5Trace8DebugOffEv", "_ZN4gdcm5Trace8ErrorOffEv"})
    if (void* off = dlsym(RTLD_DEFAULT, name)) reinterpret_cast<void (*)()>(off)();
}

/// The C library lets a program put a stream of its own in place of stderr.
bool replaced() {
  silenceCodecs();
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
