// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/readers/files/byte_stream.h"

#include <zlib.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <utility>

namespace datasets {

namespace {

constexpr std::int64_t kBlock = 1 << 18;  // bytes

class PlainBytes final : public ByteStream {
 public:
  PlainBytes(const std::filesystem::path& file, std::int64_t offset)
      : file_(file, std::ios::binary) {
    file_.seekg(offset);
  }

 private:
  std::int64_t fill(char* block, std::int64_t size) override {
    file_.read(block, size);
    return file_.gcount();
  }
  std::int64_t leap(std::int64_t count) override {
    file_.seekg(count, std::ios::cur);
    return file_ ? count : 0;
  }
  std::ifstream file_;
};

class MemoryBytes final : public ByteStream {
 public:
  MemoryBytes(const void* memory, std::int64_t size)
      : next_(static_cast<const char*>(memory)), left_(size) {}

 private:
  std::int64_t fill(char* block, std::int64_t size) override {
    const std::int64_t count = std::min(size, left_);
    std::memcpy(block, next_, static_cast<std::size_t>(count));
    return leap(count);
  }
  std::int64_t leap(std::int64_t count) override {
    count = std::min(count, left_);
    next_ += count;
    left_ -= count;
    return count;
  }
  const char* next_;
  std::int64_t left_;
};

class InflatedBytes final : public ByteStream {
 public:
  InflatedBytes(const std::filesystem::path& file, std::int64_t offset)
      : file_(file, std::ios::binary), input_(kBlock / 4) {
    file_.seekg(offset);
    // a gzip or a zlib stream: it says which
    whole_ = inflateInit2(&zlib_, MAX_WBITS + 32) == Z_OK;
  }
  ~InflatedBytes() override { inflateEnd(&zlib_); }
  bool endsWell() override {
    length();
    return ended_;
  }

 private:
  std::int64_t fill(char* block, std::int64_t size) override {
    zlib_.next_out = reinterpret_cast<Bytef*>(block);
    zlib_.avail_out = static_cast<uInt>(size);
    while (whole_ && zlib_.avail_out > 0) {
      if (zlib_.avail_in == 0 && !moreInput()) break;
      const int state = inflate(&zlib_, Z_NO_FLUSH);
      ended_ = state == Z_STREAM_END;
      // one gzip file may be several, one after the other
      if (state == Z_STREAM_END)
        whole_ = (zlib_.avail_in > 0 || moreInput()) && *zlib_.next_in == 0x1f &&
                 inflateReset(&zlib_) == Z_OK;
      else if (state != Z_OK)
        whole_ = false;
    }
    return size - zlib_.avail_out;
  }
  bool moreInput() {
    file_.read(input_.data(), static_cast<std::streamsize>(input_.size()));
    zlib_.next_in = reinterpret_cast<Bytef*>(input_.data());
    zlib_.avail_in = static_cast<uInt>(file_.gcount());
    return zlib_.avail_in > 0;
  }
  std::ifstream file_;
  std::vector<char> input_;
  z_stream zlib_ = {};
  bool whole_ = false;  ///< so far, and there may be more
  bool ended_ = false;  ///< with a checksum that is right
};

class JoinedBytes final : public ByteStream {
 public:
  JoinedBytes(std::vector<FileBytes> files, std::int64_t bytes_of_each)
      : files_(std::move(files)), each_(bytes_of_each) {}
  bool endsWell() override { return whole_; }

 private:
  std::int64_t fill(char* block, std::int64_t size) override {
    if (left() == 0 || !whole_) return 0;
    const auto number = static_cast<std::size_t>(at_ / each_);
    const std::int64_t within = at_ % each_;
    if (!open_ || number != number_) open(number);
    const std::int64_t count = std::min(size, each_ - within);
    whole_ = begin_ >= 0 && open_->advanceTo(begin_ + within) && open_->read(block, count);
    if (whole_ && within + count == each_) whole_ = open_->endsWell();
    if (!whole_) return 0;
    at_ += count;
    return count;
  }
  std::int64_t leap(std::int64_t count) override {
    count = std::min(count, left());
    at_ += count;
    return count;
  }
  std::int64_t left() const { return each_ * static_cast<std::int64_t>(files_.size()) - at_; }
  void open(std::size_t number) {
    const FileBytes& file = files_[number];
    number_ = number;
    open_ = openBytes(file.file, file.offset, file.deflated);
    begin_ = file.skip;
    if (begin_ >= 0) return;
    // where the last bytes begin is known once all have been seen
    begin_ = open_->length() - each_;
    open_ = openBytes(file.file, file.offset, file.deflated);
  }

  std::vector<FileBytes> files_;
  std::int64_t each_, at_ = 0;  ///< bytes: of each file, and read or skipped of all
  std::unique_ptr<ByteStream> open_;
  std::size_t number_ = 0;  ///< of the open file
  std::int64_t begin_ = 0;  ///< of its bytes
  bool whole_ = true;       ///< so far
};

}  // namespace

ByteStream::ByteStream() : block_(static_cast<std::size_t>(kBlock)) {}

void ByteStream::watch(const ReadProgress& progress, std::int64_t end) {
  progress_ = &progress;
  last_ = std::max<std::int64_t>(end, 1);
}

bool ByteStream::refill() {
  if (progress_ != nullptr) {
    if (progress_->isCancelled()) return false;
    progress_->advanced(std::min(1.0, static_cast<double>(at_) / static_cast<double>(last_)));
  }
  next_ = 0;
  end_ = fill(block_.data(), kBlock);
  return end_ > 0;
}

bool ByteStream::advanceTo(std::int64_t at) {
  while (at_ < at) {
    if (next_ == end_) at_ += leap(at - at_);
    if (at_ == at) break;
    if (next_ == end_ && !refill()) return false;
    const std::int64_t count = std::min(at - at_, end_ - next_);
    next_ += count;
    at_ += count;
  }
  return true;
}

bool ByteStream::read(void* to, std::int64_t count) {
  for (auto* out = static_cast<char*>(to); count > 0;) {
    if (next_ == end_ && !refill()) return false;
    const std::int64_t some = std::min(count, end_ - next_);
    std::memcpy(out, block_.data() + next_, static_cast<std::size_t>(some));
    next_ += some;
    at_ += some;
    out += some;
    count -= some;
  }
  return true;
}

std::int64_t ByteStream::length() {
  while (next_ < end_ || refill()) {
    at_ += end_ - next_;
    next_ = end_;
  }
  return at_;
}

std::unique_ptr<ByteStream> openBytes(const std::filesystem::path& file, std::int64_t offset,
                                      bool deflated) {
  if (deflated) return std::make_unique<InflatedBytes>(file, offset);
  return std::make_unique<PlainBytes>(file, offset);
}

std::unique_ptr<ByteStream> joinedBytes(std::vector<FileBytes> files, std::int64_t bytes_of_each) {
  return std::make_unique<JoinedBytes>(std::move(files), bytes_of_each);
}

std::unique_ptr<ByteStream> bytesOf(const void* memory, std::int64_t size) {
  return std::make_unique<MemoryBytes>(memory, size);
}

}  // namespace datasets
