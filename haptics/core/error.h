// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <tl/expected.hpp>
#include <utility>
#include <vector>

namespace haptics {

/// A sentence for the user before it is put into words: a row of the catalogue (resources/messages)
/// and what stands in its places. Without a row it is plain text that is put in as it is: a name, a
/// number, words of the operating system.
struct Message {
  std::string id;                  ///< of the row: "header-unreadable"; empty: plain text
  std::vector<Message> arguments;  ///< for %1, %2, …
  std::string text;                ///< the plain text, without a row
  bool of_numbers = false;         ///< the text's points are decimal marks

  Message() = default;
  Message(const char* plain) : text(plain) {}
  Message(std::string plain) : text(std::move(plain)) {}
  Message(const char* row, std::vector<Message> with) : id(row), arguments(std::move(with)) {}

  /// Plain text of numbers, as C writes them: "0.5", "0.5 x 0.5".
  static Message numbers(std::string plain) {
    Message message{std::move(plain)};
    message.of_numbers = true;
    return message;
  }

  bool empty() const { return id.empty() && text.empty(); }
};

/// Why something could not be set up. Never crosses the servo thread.
struct Error {
  enum class Kind {
    NotFound,
    Unsupported,
    Malformed,
    Cancelled,
    Correctable  ///< can be used after a correction to which the user agrees
  };
  Kind kind = Kind::Malformed;
  Message message;          ///< One sentence for the user: names the thing, and what to try.
  std::string reason = {};  ///< A word for programs: "truncated", "sheared", …
};

template <class T>
using Expected = tl::expected<T, Error>;  // C++20: std::expected arrives with C++23

}  // namespace haptics
