// SPDX-License-Identifier: BSD-3-Clause
// By the first byte how the rest comes in pieces: a Content-Type, and bytes as the body of an
// answer of DICOMweb.
#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>

#include "app/fetch/multipart.h"
#include "tests/fuzz/require.h"

namespace {

/// What a body comes to: its parts, or how far it went.
struct Read {
  std::string bytes;  ///< of all parts, each with a letter behind that says that it ended
  bool whole = false;
  std::string reason;
  bool operator==(const Read&) const = default;
};

Read readIn(std::string_view body, const std::string& boundary, std::size_t piece) {
  Read read;
  bool open = false;
  app::fetch::Multipart parts{boundary,
                              {.began =
                                   [&] {
                                     fuzz::require(!open, "a part ends before the next begins");
                                     open = true;
                                     return haptics::Expected<void>{};
                                   },
                               .bytes =
                                   [&](std::span<const char> bytes) {
                                     fuzz::require(open && !bytes.empty(), "bytes are of a part");
                                     read.bytes.append(bytes.data(), bytes.size());
                                     return haptics::Expected<void>{};
                                   },
                               .ended =
                                   [&] {
                                     fuzz::require(open, "what ends has begun");
                                     open = false;
                                     read.bytes += "|";
                                     return haptics::Expected<void>{};
                                   }}};
  for (std::size_t at = 0; at < body.size(); at += piece) {
    const auto fed = parts.feed(body.substr(at, piece));
    if (!fed) {
      fuzz::require(!fed.error().message.empty() && !fed.error().reason.empty(),
                    "a refusal has a sentence and a reason");
      read.reason = fed.error().reason;
      // how much of a part was handed out before depends on the pieces
      read.bytes.clear();
      return read;
    }
  }
  read.whole = parts.finish().has_value();
  if (!read.whole) {
    const auto end = read.bytes.rfind('|');
    read.bytes.resize(end == std::string::npos ? 0 : end + 1);
  }
  fuzz::require(!read.whole || !open, "a whole body has whole parts");
  return read;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  if (size < 2) return 0;
  const std::string_view all(reinterpret_cast<const char*>(bytes) + 1, size - 1);
  const auto line = all.find('\n');
  if (line == std::string_view::npos) return 0;
  const auto boundary = app::fetch::boundaryOf(all.substr(0, line));
  if (!boundary || boundary->empty()) return 0;
  fuzz::require(boundary->size() <= 70, "a boundary is short");
  const std::string_view body = all.substr(line + 1);
  const Read at_once = readIn(body, *boundary, std::max<std::size_t>(body.size(), 1));
  const Read in_pieces = readIn(body, *boundary, 1 + bytes[0] % 17);
  fuzz::require(at_once.whole == in_pieces.whole && at_once.reason == in_pieces.reason,
                "how a body comes changes nothing");
  if (at_once.reason.empty())
    fuzz::require(at_once.bytes == in_pieces.bytes, "a part has the same bytes however it comes");
  return 0;
}
