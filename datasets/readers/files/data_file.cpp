// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/readers/files/data_file.h"

#include <algorithm>

#include "datasets/readers/files/refusal.h"

namespace datasets {

namespace fs = std::filesystem;
using haptics::Expected;

namespace {

tl::unexpected<haptics::Error> outside(const fs::path& path) {
  return unsupported("outside-folder", {"data-file-outside-folder", {quoted(path)}});
}

/// A name as this system writes it, where Windows wrote it: "slices\\s1.raw".
fs::path namedBelow(const fs::path& folder, std::string name) {
  std::error_code error;
  if (!fs::exists(folder / name, error)) std::ranges::replace(name, '\\', '/');
  return name;
}

}  // namespace

Expected<fs::path> dataFileOf(const fs::path& header, const std::string& name) {
  const fs::path folder = header.has_parent_path() ? header.parent_path() : fs::path(".");
  const fs::path relative = namedBelow(folder, name);
  if (relative.is_absolute() || name == "-") return outside(header);
  for (const fs::path& part : relative)
    if (part == "..") return outside(header);
  std::error_code error;
  const fs::path real_folder = fs::canonical(folder, error);
  const fs::path real = error ? fs::path() : fs::canonical(folder / relative, error);
  if (error)
    return malformed("truncated", {"data-file-missing", {quoted(header), quoted(relative)}});
  const auto [end, unused] =
      std::mismatch(real_folder.begin(), real_folder.end(), real.begin(), real.end());
  if (end != real_folder.end() || !fs::is_regular_file(real, error)) return outside(header);
  return real;
}

}  // namespace datasets
