// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace datasets {

/// A file of this process alone, for libraries that read files only: it never touches a disk and
/// ends with the object.
class MemoryFile {
 public:
  MemoryFile();
  ~MemoryFile();
  MemoryFile(MemoryFile&& other) noexcept;
  MemoryFile& operator=(MemoryFile&&) = delete;

  /// False where there is no room for it.
  [[nodiscard]] bool append(std::string_view bytes);
  /// To open it by, while it lives.
  std::string path() const;

 private:
  int descriptor_;
};

}  // namespace datasets
