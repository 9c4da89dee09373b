// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/readers/nrrd/stream.h"

#include <algorithm>
#include <cstring>

namespace datasets {

namespace {

constexpr std::size_t kBuffer = 1 << 18;  // bytes

}  // namespace

NrrdStream::NrrdStream(std::string text, const std::filesystem::path& file,
                       const ReadProgress& progress)
    : text_(std::move(text)), file_(file, std::ios::binary | std::ios::ate), progress_(progress) {
  if (!file_) return;
  size_ = static_cast<std::int64_t>(text_.size()) + static_cast<std::int64_t>(file_.tellg());
  stream_ =
      fopencookie(this, "rb", {.read = read, .write = nullptr, .seek = seek, .close = nullptr});
  if (stream_ != nullptr) std::setvbuf(stream_, nullptr, _IOFBF, kBuffer);
}

NrrdStream::~NrrdStream() {
  if (stream_ != nullptr) std::fclose(stream_);
}

ssize_t NrrdStream::read(void* self, char* buffer, std::size_t size) {
  auto& s = *static_cast<NrrdStream*>(self);
  if (s.progress_.isCancelled()) return -1;
  s.progress_.advanced(static_cast<double>(s.at_) / static_cast<double>(s.size_));
  const auto text_size = static_cast<std::int64_t>(s.text_.size());
  std::int64_t count = std::min(static_cast<std::int64_t>(size), s.size_ - s.at_);
  if (count <= 0) return 0;
  if (s.at_ < text_size) {
    count = std::min(count, text_size - s.at_);
    std::memcpy(buffer, s.text_.data() + s.at_, static_cast<std::size_t>(count));
  } else {
    s.file_.clear();
    s.file_.seekg(s.at_ - text_size);
    s.file_.read(buffer, count);
    count = s.file_.gcount();
  }
  s.at_ += count;
  return count;
}

int NrrdStream::seek(void* self, off64_t* offset, int whence) {
  auto& s = *static_cast<NrrdStream*>(self);
  const std::int64_t base = whence == SEEK_SET ? 0 : whence == SEEK_CUR ? s.at_ : s.size_;
  if (base + *offset < 0 || base + *offset > s.size_) return -1;
  s.at_ = base + *offset;
  *offset = s.at_;
  return 0;
}

}  // namespace datasets
