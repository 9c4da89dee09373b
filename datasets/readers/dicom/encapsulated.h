// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "datasets/readers/dicom/codestream.h"
#include "haptics/core/error.h"

namespace datasets {

/// Where compressed frames lie in their file.
class EncapsulatedFrames {
 public:
  /// Finds the frames. `pixels_begin` is the position of the offset table, in bytes. Without an
  /// offset table, the number of fragments, or of those that begin like a codestream, must equal
  /// the number of frames. Anything else is refused.
  static haptics::Expected<EncapsulatedFrames> of(const std::filesystem::path& file,
                                                  std::int64_t pixels_begin, int frame_count,
                                                  Coding coding);

  /// Size of the largest frame.
  std::size_t mostBytes() const;
  /// The bytes of one frame, its fragments put together.
  haptics::Expected<std::vector<std::byte>> bytesOf(int frame) const;

 private:
  struct Fragment {
    std::int64_t begin = 0;  ///< in the file
    std::int64_t size = 0;
  };

  std::filesystem::path file_;
  std::vector<std::vector<Fragment>> frames_;
};

}  // namespace datasets
