// SPDX-License-Identifier: BSD-3-Clause
#include "app/fetch/multipart.h"

#include <algorithm>

#include "app/fetch/archive.h"

namespace app::fetch {

using haptics::Expected;

namespace {

constexpr std::size_t kMostHeader = 8192;     // bytes of the header of a part
constexpr std::size_t kMostAside = 65536;     // bytes before the first part and behind the last
constexpr std::size_t kLongestBoundary = 70;  // RFC 2046

tl::unexpected<haptics::Error> noMultipart() {
  return refused("answer", {"fetch-web-answer-senseless", {}});
}

std::string lowered(std::string_view text) {
  std::string small(text);
  std::ranges::transform(small, small.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return small;
}

}  // namespace

Multipart::Multipart(std::string boundary, Sink sink)
    // the first boundary may stand at the very beginning, where nothing ends a line before it
    : delimiter_{"\r\n--" + std::move(boundary)}, sink_{std::move(sink)}, held_{"\r\n"} {}

Expected<void> Multipart::feed(std::span<const char> bytes) {
  std::string_view fresh{bytes.data(), bytes.size()};
  // what is held goes on with a few of the fresh bytes, until none of it is left
  while (!held_.empty() && !fresh.empty()) {
    const std::string_view next = fresh.substr(0, delimiter_.size());
    held_ += next;
    std::string_view rest = held_;
    if (auto consumed = consume(rest); !consumed) return consumed;
    if (rest.size() <= next.size()) {
      fresh.remove_prefix(next.size() - rest.size());
      held_.clear();
    } else {
      fresh.remove_prefix(next.size());
      held_.erase(0, held_.size() - rest.size());
    }
  }
  if (!held_.empty()) return {};
  if (auto consumed = consume(fresh); !consumed) return consumed;
  held_ = fresh;
  return {};
}

/// Consumes from the front of `bytes` until more are needed.
Expected<void> Multipart::consume(std::string_view& bytes) {
  for (;;) {
    const auto more = step(bytes);
    if (!more) return tl::unexpected(more.error());
    if (!*more) return {};
  }
}

/// Consumes one thing; false if it needs more bytes.
Expected<bool> Multipart::step(std::string_view& bytes) {
  switch (state_) {
    case State::Preamble:
    case State::Body: {
      const auto at = bytes.find(delimiter_);
      const bool found = at != bytes.npos;
      // what is left may be the beginning of a delimiter, which has one CR
      const std::size_t sure =
          found ? at
                : std::min(bytes.size(),
                           bytes.find(
                               '\r', bytes.size() - std::min(bytes.size(), delimiter_.size() - 1)));
      if (state_ == State::Body) {
        if (sure > 0)
          if (auto taken = sink_.bytes({bytes.data(), sure}); !taken)
            return tl::unexpected(taken.error());
        if (found) {
          if (auto ended = sink_.ended(); !ended) return tl::unexpected(ended.error());
          ++parts_;
        }
      } else if ((aside_ += sure) > kMostAside) {
        return noMultipart();
      }
      bytes.remove_prefix(sure + (found ? delimiter_.size() : 0));
      if (found) state_ = State::AfterBoundary;
      return found;
    }
    case State::AfterBoundary: {
      // "--" closes; else white space, and the end of the line
      if (bytes.size() >= 2 && bytes.starts_with("--")) {
        state_ = State::Epilogue;
        return true;
      }
      const auto end = bytes.find("\r\n");
      if (bytes.find_first_not_of(" \t\r\n-") < end || std::min(end, bytes.size()) > kMostHeader)
        return noMultipart();
      if (end == bytes.npos) return false;
      // the line's end stays: a part without header fields goes on with an empty line
      bytes.remove_prefix(end);
      state_ = State::Header;
      return true;
    }
    case State::Header: {
      const auto end = bytes.find("\r\n\r\n");
      if (std::min(end, bytes.size()) > kMostHeader) return noMultipart();
      if (end == bytes.npos) return false;
      bytes.remove_prefix(end + 4);
      state_ = State::Body;
      if (auto began = sink_.began(); !began) return tl::unexpected(began.error());
      return true;
    }
    case State::Epilogue:
      aside_ += bytes.size();
      bytes = {};
      if (aside_ > kMostAside) return noMultipart();
      return false;
  }
  return false;
}

Expected<void> Multipart::finish() const {
  if (state_ == State::Epilogue) return {};
  return failed("lost", {"fetch-cut-off", {}});
}

std::optional<std::string> boundaryOf(std::string_view content_type) {
  const std::string type = lowered(content_type);
  if (type.starts_with("application/dicom") &&
      (type.size() == 17 || type[17] == ';' || type[17] == ' '))
    return std::string{};
  if (!type.starts_with("multipart/related")) return {};
  auto at = type.find("boundary=");
  if (at == std::string::npos) return {};
  at += 9;
  std::string_view rest = content_type.substr(at);
  if (rest.starts_with('"')) {
    rest.remove_prefix(1);
    const auto end = rest.find('"');
    if (end == std::string_view::npos) return {};
    rest = rest.substr(0, end);
  } else {
    rest = rest.substr(0, rest.find_first_of("; \t"));
  }
  if (rest.empty() || rest.size() > kLongestBoundary ||
      std::ranges::any_of(rest, [](char c) { return c < ' ' || c > '~'; }))
    return {};
  return std::string(rest);
}

}  // namespace app::fetch
