// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/readers/files/folder_tree.h"

#include <algorithm>

#include "datasets/readers/files/refusal.h"

namespace datasets {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kMostInFolder = 200'000;
constexpr int kDeepestFolder = 32;

}  // namespace

haptics::Expected<std::vector<fs::path>> filesBelow(const fs::path& folder,
                                                    const ReadProgress& progress) {
  std::vector<fs::path> paths;
  std::error_code error;
  fs::recursive_directory_iterator it(folder, fs::directory_options::skip_permission_denied, error);
  for (const fs::recursive_directory_iterator end; !error && it != end; it.increment(error)) {
    if (progress.isCancelled()) return cancelled();
    std::error_code ignored;
    if (it->is_regular_file(ignored)) paths.push_back(it->path());
    if (it.depth() >= kDeepestFolder) it.disable_recursion_pending();
    if (paths.size() > kMostInFolder)
      return unsupported(
          "too-large", {"folder-too-many-files", {quoted(folder), std::to_string(kMostInFolder)}});
  }
  if (error) return notFound(folder);
  std::ranges::sort(paths);
  return paths;
}

}  // namespace datasets
