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

  /// vtk-dicom reads little endian without a word about it, and takes big endian for little.
  bool needsRewriting() const;
};
/// From the file's first bytes, 140 of them or all.
std::optional<BareDataSet> bareDataSetOf(std::string_view beginning);

/// A DICOM file that vtk-dicom cannot read as it stands, written anew in memory.
class RewrittenFile {
 public:
  /// Of one whose data set is deflated, or bare and in need of it. Refuses what is cut off
  /// ("truncated"), does not begin as such a file does ("bad-header"), or is or inflates to more
  /// than 1 GiB, or 32 times itself where that is over 64 MiB ("too-large").
  static haptics::Expected<RewrittenFile> of(const std::filesystem::path& path);
  /// The first bytes of a file, as one of this kind: what of it is sound.
  static haptics::Expected<RewrittenFile> beginningOf(const std::filesystem::path& file,
                                                      std::int64_t count);

  /// To open it by, while it lives.
  std::string path() const { return file_.path(); }

 private:
  RewrittenFile() = default;
  MemoryFile file_;
};

}  // namespace datasets
