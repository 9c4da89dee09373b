// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <span>

#include "datasets/readers/dicom/decoder.h"
#include "datasets/readers/dicom/file.h"
#include "datasets/readers/dicom/values.h"
#include "datasets/readers/scan.h"
#include "haptics/core/error.h"

namespace datasets {

/// The pixels of one file, frame by frame, in its own row order.
class FileFrames {
 public:
  FileFrames() = default;
  FileFrames(const FileFrames&) = delete;
  FileFrames& operator=(const FileFrames&) = delete;
  virtual ~FileFrames() = default;
  /// Of one of the file's frames, until the next is asked for; a byte for each pixel of one bit.
  virtual haptics::Expected<Pixels> pixelsOf(const DicomFile& frame,
                                             const ReadProgress& progress) = 0;
};

/// Those of a file; the decoders must outlive them.
std::unique_ptr<FileFrames> framesOf(const DicomFile& file, Decoders& decoders);

/// For frames as large as the largest among files: they cannot be larger than the file.
Decoders decodersFor(std::span<const DicomFile> files);

}  // namespace datasets
