// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "haptics/core/error.h"

namespace app::fetch {

/// Splits a multipart/related body (RFC 2046) as its bytes come, without keeping a part in memory.
/// Only the boundary ends a part: lengths that a server states are not used. Between two calls it
/// holds the last bytes that may begin a boundary, or the header of a part, 8 KiB at most; all else
/// goes on from where it lies.
class Multipart {
 public:
  /// Each may refuse, which ends the reading. `ended` is called only after the boundary behind a
  /// part was seen, so a part that was cut off never ends.
  struct Sink {
    std::function<haptics::Expected<void>()> began;
    std::function<haptics::Expected<void>(std::span<const char>)> bytes;
    std::function<haptics::Expected<void>()> ended;
  };
  Multipart(std::string boundary, Sink sink);

  haptics::Expected<void> feed(std::span<const char> bytes);
  /// After the last byte: an error unless the closing boundary was seen.
  haptics::Expected<void> finish() const;
  std::uint64_t parts() const { return parts_; }

 private:
  enum class State { Preamble, AfterBoundary, Header, Body, Epilogue };

  std::string delimiter_;  ///< CR LF - - boundary
  Sink sink_;
  std::string held_;  ///< not consumed yet
  State state_ = State::Preamble;
  std::uint64_t parts_ = 0;
  std::uint64_t aside_ = 0;  ///< bytes before the first part and behind the last

  haptics::Expected<void> consume(std::string_view& bytes);
  haptics::Expected<bool> step(std::string_view& bytes);
};

/// The boundary that a Content-Type states; empty for a single body of application/dicom; nothing
/// if it is neither. At most 70 characters.
std::optional<std::string> boundaryOf(std::string_view content_type);

}  // namespace app::fetch
