// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/process/helper_program.h"

#include <unistd.h>

#include <system_error>

namespace haptics {

std::filesystem::path helperProgram(std::string_view name) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::path folder = fs::read_symlink("/proc/self/exe", error).parent_path();
  if (error) return {};
  for (const fs::path& place : {folder / name, folder / PALPATE_HELPERS / name})
    if (fs::is_regular_file(place, error) && access(place.c_str(), X_OK) == 0)
      return place.lexically_normal();
  return {};
}

}  // namespace haptics
