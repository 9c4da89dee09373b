// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/readers/dicom/encapsulated.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <numeric>
#include <optional>
#include <span>
#include <utility>

#include "datasets/readers/files/refusal.h"

namespace datasets {

using haptics::Expected;

namespace {

constexpr std::int64_t kHead = 8;  // bytes of an item's tag and length
constexpr std::size_t kMostFragments = 1 << 20;

tl::unexpected<haptics::Error> cutOffPixels(const std::filesystem::path& file) {
  return malformed("truncated", {"file-damaged", {quoted(file)}});
}

std::uint32_t littleEndian(const unsigned char* bytes) {
  return bytes[0] | std::uint32_t{bytes[1]} << 8 | std::uint32_t{bytes[2]} << 16 |
         std::uint32_t{bytes[3]} << 24;
}

enum class Item { Fragment, End, Neither };

/// The head of the item that begins here.
std::pair<Item, std::int64_t> itemAt(std::ifstream& in, std::int64_t at) {
  std::array<unsigned char, kHead> head{};
  in.seekg(at);
  if (!in.read(reinterpret_cast<char*>(head.data()), kHead)) return {Item::Neither, 0};
  const std::uint32_t tag = littleEndian(head.data()), length = littleEndian(head.data() + 4);
  if (tag == 0xe000fffeU) return {Item::Fragment, length};
  return {tag == 0xe0ddfffeU && length == 0 ? Item::End : Item::Neither, 0};
}

}  // namespace

Expected<EncapsulatedFrames> EncapsulatedFrames::of(const std::filesystem::path& file,
                                                    std::int64_t pixels_begin, int frame_count,
                                                    Coding coding) {
  std::ifstream in(file, std::ios::binary | std::ios::ate);
  const auto size = static_cast<std::int64_t>(in.tellg());
  std::int64_t at = pixels_begin;
  std::vector<Fragment> all;
  for (;;) {
    const auto [item, length] = itemAt(in, at);
    if (item == Item::End) break;
    if (item == Item::Neither || length > size - at - kHead || all.size() > kMostFragments)
      return cutOffPixels(file);
    all.push_back({at + kHead, length});
    at += kHead + length;
  }
  if (all.size() < 2) return cutOffPixels(file);
  const Fragment table = all.front();
  all.erase(all.begin());

  // which fragments begin a frame
  std::vector<std::size_t> first;
  const auto count = static_cast<std::size_t>(frame_count);
  if (count == 1) {
    first.push_back(0);  // whatever the table says
  } else if (table.size > 0) {
    if (table.size != std::int64_t{4} * frame_count) return cutOffPixels(file);
    std::vector<unsigned char> bytes(static_cast<std::size_t>(table.size));
    in.seekg(table.begin);
    if (!in.read(reinterpret_cast<char*>(bytes.data()), table.size)) return cutOffPixels(file);
    for (std::size_t n = 0; n < count; ++n) {
      const std::int64_t begin = all.front().begin + littleEndian(bytes.data() + 4 * n);
      const auto found = std::ranges::lower_bound(all, begin, {}, &Fragment::begin);
      const auto place = static_cast<std::size_t>(found - all.begin());
      if (found == all.end() || found->begin != begin ||
          (n == 0 ? place != 0 : place <= first.back()))
        return cutOffPixels(file);
      first.push_back(place);
    }
  } else if (count == all.size()) {
    first.resize(count);
    std::iota(first.begin(), first.end(), std::size_t{0});
  } else {
    for (std::size_t n = 0; n < all.size(); ++n) {
      std::array<std::byte, 2> mark{};
      in.seekg(all[n].begin);
      if (all[n].size >= 2 && in.read(reinterpret_cast<char*>(mark.data()), 2) &&
          beginsCodestream(coding, mark))
        first.push_back(n);
      in.clear();
    }
    if (first.size() != count || first.front() != 0 || coding == Coding::Rle)
      return cutOffPixels(file);
  }

  EncapsulatedFrames frames;
  frames.file_ = file;
  for (std::size_t n = 0; n < count; ++n) {
    const std::size_t end = n + 1 < count ? first[n + 1] : all.size();
    frames.frames_.emplace_back(all.begin() + static_cast<std::ptrdiff_t>(first[n]),
                                all.begin() + static_cast<std::ptrdiff_t>(end));
  }
  return frames;
}

std::size_t EncapsulatedFrames::mostBytes() const {
  std::int64_t most = 0;
  for (const std::vector<Fragment>& frame : frames_)
    most = std::max(most,
                    std::accumulate(frame.begin(), frame.end(), std::int64_t{0},
                                    [](std::int64_t n, const Fragment& f) { return n + f.size; }));
  return static_cast<std::size_t>(most);
}

Expected<std::vector<std::byte>> EncapsulatedFrames::bytesOf(int frame) const {
  std::ifstream in(file_, std::ios::binary);
  std::vector<std::byte> bytes;
  for (const Fragment& fragment : frames_[static_cast<std::size_t>(frame)]) {
    const std::size_t before = bytes.size();
    bytes.resize(before + static_cast<std::size_t>(fragment.size));
    in.seekg(fragment.begin);
    if (!in.read(reinterpret_cast<char*>(bytes.data() + before), fragment.size))
      return cutOffPixels(file_);
  }
  return bytes;
}

}  // namespace datasets
