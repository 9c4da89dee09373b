// SPDX-License-Identifier: BSD-3-Clause
#include <dlfcn.h>

#include <cstdio>
#include <exception>
#include <filesystem>
#include <memory>
#include <string>

#include "app/program.h"
#include "app/read_ahead.h"
#include "datasets/readers/volume_header.h"
#include "haptics/process/process_limits.h"

namespace {

namespace fs = std::filesystem;

constexpr int kFailed = 4;
constexpr const char* kLibrary = "palpate-window.so";

/// The library beside the program, as in a build folder, or that of the same installation.
fs::path library() {
  std::error_code error;
  const fs::path folder = fs::read_symlink("/proc/self/exe", error).parent_path();
  const fs::path beside = folder / kLibrary;
  return fs::exists(beside, error) ? beside
                                   : (folder / PALPATE_LIBRARIES / kLibrary).lexically_normal();
}

/// The only argument that is a file of volumes. The program itself reads the command line, and
/// takes what was read only for the path that is given there.
std::shared_ptr<app::ReadAhead> readAhead(int argc, char** argv) {
  try {
    fs::path file;
    for (int i = 1; i < argc; ++i) {
      std::error_code error;
      if (argv[i][0] == '-' || !fs::is_regular_file(argv[i], error) ||
          !datasets::isVolumeFile(argv[i]))
        continue;
      if (!file.empty()) return {};
      file = argv[i];
    }
    return file.empty() ? nullptr : std::make_shared<app::ReadAhead>(file);
  } catch (const std::exception&) {  // no memory: the loader reads, and says so
    return {};
  }
}

}  // namespace

int main(int argc, char** argv) {
  haptics::forbidCoreDumps();  // names and scans lie in memory
  auto ahead = readAhead(argc, argv);
  // functions of other libraries are sought when they are first called, as in any program
  void* const loaded = dlopen(library().c_str(), RTLD_LAZY);
  auto* const program =
      loaded == nullptr
          ? nullptr
          : reinterpret_cast<decltype(&palpateProgram)>(dlsym(loaded, "palpateProgram"));
  if (program == nullptr) {
    std::fprintf(stderr, "Palpate is not installed as a whole; install it anew. (%s)\n", dlerror());
    return kFailed;
  }
  try {
    return program(argc, argv, std::move(ahead));
  } catch (const std::exception&) {
    std::fprintf(
        stderr,
        "The system has no thread or no memory left for this; close other programs and try "
        "again.\n");
    return kFailed;
  }
}
