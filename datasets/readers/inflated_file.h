// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

#include "haptics/core/error.h"

namespace datasets {

/// A DICOM file whose data set is deflated, inflated in memory: a file of this process alone that
/// never touches a disk and ends with the object. vtk-dicom does not inflate.
class InflatedFile {
 public:
  /// Refuses what is cut off ("truncated"), does not begin as such a file does ("bad-header"), or
  /// is or inflates to more than 1 GiB, or 32 times itself where that is over 64 MiB ("too-large").
  static haptics::Expected<InflatedFile> of(const std::filesystem::path& deflated);
  ~InflatedFile();
  InflatedFile(InflatedFile&& other) noexcept;
  InflatedFile& operator=(InflatedFile&&) = delete;

  /// To open it by, while it lives.
  std::string path() const;

 private:
  explicit InflatedFile(int descriptor) : descriptor_{descriptor} {}
  int descriptor_;
};

}  // namespace datasets
