// SPDX-License-Identifier: BSD-3-Clause
#include "app/fetch/multipart.h"

#include <algorithm>

#include "app/fetch/archive.h"

namespace app::fetch {

using haptics::Expected;

namespace {

constexpr std::size_t kMostHeader = 8192;     // bytes of the header of a part
constexpr std::size_t kMostPreamble = 65536;  // bytes before the first part
constexpr std::size_t kLongestBoundary = 70;  // RFC 2046

tl::unexpected<haptics::Error> noMultipart() {
  return refused("answer", {"fetch-multipart-senseless", {}});
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
  held_.append(bytes.data(), bytes.size());
  for (;;) {
    const auto more = step();
    if (!more) return tl::unexpected(more.error());
    if (!*more) return {};
  }
}

/// Consumes from held_; false if it needs more bytes.
Expected<bool> Multipart::step() {
  switch (state_) {
    case State::Preamble:
    case State::Body: {
      const auto at = held_.find(delimiter_);
      const bool found = at != std::string::npos;
      // what is left may be the beginning of a delimiter
      const std::size_t sure =
          found ? at : held_.size() - std::min(held_.size(), delimiter_.size() - 1);
      if (state_ == State::Body) {
        if (sure > 0)
          if (auto taken = sink_.bytes({held_.data(), sure}); !taken)
            return tl::unexpected(taken.error());
        if (found) {
          if (auto ended = sink_.ended(); !ended) return tl::unexpected(ended.error());
          ++parts_;
        }
      } else if ((preamble_ += sure) > kMostPreamble) {
        return noMultipart();
      }
      held_.erase(0, sure + (found ? delimiter_.size() : 0));
      if (found) state_ = State::AfterBoundary;
      return found;
    }
    case State::AfterBoundary: {
      // "--" closes; else white space, and the end of the line
      if (held_.size() >= 2 && held_.starts_with("--")) {
        state_ = State::Epilogue;
        held_.clear();
        return true;
      }
      const auto end = held_.find("\r\n");
      if (held_.find_first_not_of(" \t\r\n-") < end || std::min(end, held_.size()) > kMostHeader)
        return noMultipart();
      if (end == std::string::npos) return false;
      // the line's end stays: a part without header fields goes on with an empty line
      held_.erase(0, end);
      state_ = State::Header;
      return true;
    }
    case State::Header: {
      const auto end = held_.find("\r\n\r\n");
      if (std::min(end, held_.size()) > kMostHeader) return noMultipart();
      if (end == std::string::npos) return false;
      held_.erase(0, end + 4);
      state_ = State::Body;
      if (auto began = sink_.began(); !began) return tl::unexpected(began.error());
      return true;
    }
    case State::Epilogue:
      held_.clear();
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
