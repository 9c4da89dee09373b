// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/process/input_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <utility>

namespace haptics {

namespace fs = std::filesystem;

namespace {

tl::unexpected<Error> unread(Error::Kind kind, Message message, const char* reason) {
  return tl::unexpected(Error{kind, std::move(message), reason});
}

std::string sizeWords(std::uintmax_t bytes) {
  return bytes < 1'000'000 ? std::to_string(bytes / 1000) + " kB"
                           : std::to_string(bytes / 1'000'000) + " MB";
}

}  // namespace

Expected<std::ifstream> openInput(const fs::path& path, std::uintmax_t most_bytes) {
  const auto unreadable = [&] {
    return unread(Error::Kind::NotFound, {"input-unreadable", {path.string()}}, "unreadable");
  };
  const auto no_file = [&] {
    return unread(Error::Kind::Unsupported, {"input-no-file", {path.string()}}, "no-file");
  };
  // before it is opened: to open a device can be to use it
  struct stat what {};
  if (::stat(path.c_str(), &what) != 0) return unreadable();
  if (!S_ISREG(what.st_mode)) return no_file();
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
  if (file < 0) return unreadable();
  // and after, since another may have taken its place
  const bool known = ::fstat(file, &what) == 0;
  std::ifstream in;
  if (known && S_ISREG(what.st_mode))
    in.open("/proc/self/fd/" + std::to_string(file), std::ios::binary);
  ::close(file);
  if (!known) return unreadable();
  if (!S_ISREG(what.st_mode)) return no_file();
  if (static_cast<std::uintmax_t>(what.st_size) > most_bytes)
    return unread(Error::Kind::Unsupported,
                  {"input-too-large", {path.string(), sizeWords(most_bytes)}}, "too-large");
  if (!in) return unreadable();
  return in;
}

Expected<std::string> readInput(const fs::path& path, std::uintmax_t most_bytes) {
  auto in = openInput(path, most_bytes);
  if (!in) return tl::unexpected(std::move(in.error()));
  std::string text;
  // it may have grown since it was measured
  constexpr std::size_t kPiece = 1 << 16;
  while (*in && text.size() <= most_bytes) {
    const std::size_t so_far = text.size();
    text.resize(so_far + kPiece);
    in->read(text.data() + so_far, static_cast<std::streamsize>(kPiece));
    text.resize(so_far + static_cast<std::size_t>(in->gcount()));
  }
  if (text.size() > most_bytes)
    return unread(Error::Kind::Unsupported,
                  {"input-too-large", {path.string(), sizeWords(most_bytes)}}, "too-large");
  if (in->bad())
    return unread(Error::Kind::NotFound, {"input-unreadable", {path.string()}}, "unreadable");
  return text;
}

LineRead takeLine(std::istream& in, std::string& line, std::size_t most_bytes) {
  line.clear();
  std::streambuf* bytes = in.rdbuf();
  using Traits = std::istream::traits_type;
  for (int c = bytes->sbumpc();; c = bytes->sbumpc()) {
    if (c == Traits::eof()) {
      if (line.empty()) return LineRead::End;
      break;
    }
    if (c == '\n') break;
    if (line.size() == most_bytes) return LineRead::TooLong;
    line.push_back(Traits::to_char_type(c));
  }
  if (line.ends_with('\r')) line.pop_back();
  return LineRead::Whole;
}

bool isNestedDeeper(std::string_view json, int levels) {
  int depth = 0;
  bool in_text = false;
  for (std::size_t i = 0; i < json.size(); ++i) {
    const char c = json[i];
    if (in_text) {
      if (c == '\\') ++i;
      if (c == '"') in_text = false;
    } else if (c == '"') {
      in_text = true;
    } else if (c == '[' || c == '{') {
      if (++depth > levels) return true;
    } else if (c == ']' || c == '}') {
      --depth;
    }
  }
  return false;
}

}  // namespace haptics
