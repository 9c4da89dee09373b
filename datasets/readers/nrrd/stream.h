// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

#include "datasets/readers/scan.h"

namespace datasets {

/// A header's text followed by a data file, as one C stream: teem reads it like an attached NRRD,
/// opens no file by itself, and every block it asks for is a chance to report and to stop.
class NrrdStream {
 public:
  /// The text may be empty: then the file is the whole stream.
  NrrdStream(std::string text, const std::filesystem::path& file, const ReadProgress& progress);
  ~NrrdStream();
  NrrdStream(const NrrdStream&) = delete;
  NrrdStream& operator=(const NrrdStream&) = delete;

  std::FILE* stream() const { return stream_; }  ///< null if the file cannot be opened

 private:
  static ssize_t read(void* self, char* buffer, std::size_t size);
  static int seek(void* self, off64_t* offset, int whence);

  std::string text_;
  std::ifstream file_;
  std::int64_t size_ = 0;  ///< bytes, text and file
  std::int64_t at_ = 0;
  const ReadProgress& progress_;
  std::FILE* stream_ = nullptr;
};

}  // namespace datasets
