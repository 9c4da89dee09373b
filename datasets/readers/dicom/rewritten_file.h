// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "datasets/readers/files/memory_file.h"
#include "haptics/core/error.h"

namespace datasets {

/// A DICOM file that begins with its data set, instead of the group that names its syntax.
struct BareDataSet {
  std::string_view syntax;
  std::size_t begin = 0;  ///< bytes of preamble and mark before it

  /// True for big endian: vtk-dicom reads little endian without a stated syntax, and takes big
  /// endian for little.
  bool needsRewriting() const;
};
/// From the file's first bytes, 140 of them or all.
std::optional<BareDataSet> bareDataSetOf(std::string_view beginning);

/// A DICOM file that vtk-dicom cannot read, rewritten in memory.
class RewrittenFile {
 public:
  /// Rewrites a file whose data set is deflated, or is bare and needs rewriting. Refuses a file
  /// that is cut off ("truncated"), does not begin like such a file ("bad-header"), or is larger
  /// than 1 GiB, or inflates to more than 1 GiB or to more than 32 times its size (if that is over
  /// 64 MiB) ("too-large").
  static haptics::Expected<RewrittenFile> of(const std::filesystem::path& path);
  /// Copies the first `count` bytes of a file, the part without a fault.
  static haptics::Expected<RewrittenFile> beginningOf(const std::filesystem::path& file,
                                                      std::int64_t count);

  /// Path to open it by, valid while the object lives.
  std::string path() const { return file_.path(); }

 private:
  RewrittenFile() = default;
  MemoryFile file_;
};

}  // namespace datasets
