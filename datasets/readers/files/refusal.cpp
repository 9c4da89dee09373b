// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/readers/files/refusal.h"

#include <unistd.h>

#include <charconv>
#include <fstream>

namespace datasets {

using haptics::Error;
using haptics::Message;

tl::unexpected<Error> malformed(std::string reason, Message message) {
  return tl::unexpected(Error{Error::Kind::Malformed, std::move(message), std::move(reason)});
}

tl::unexpected<Error> unsupported(std::string reason, Message message) {
  return tl::unexpected(Error{Error::Kind::Unsupported, std::move(message), std::move(reason)});
}

tl::unexpected<Error> notFound(const std::filesystem::path& path) {
  return tl::unexpected(
      Error{Error::Kind::NotFound, {"path-unreadable", {quoted(path)}}, "unreadable"});
}

tl::unexpected<Error> cancelled() {
  return tl::unexpected(Error{Error::Kind::Cancelled, {"work-cancelled", {}}, "cancelled"});
}

Message bothOf(Message first, Message second) {
  return {"both-sentences", {std::move(first), std::move(second)}};
}

std::string quoted(const std::filesystem::path& path) {
  const auto name = path.has_filename() ? path.filename() : path.parent_path().filename();
  return "\"" + name.string() + "\"";
}

Message brief(double number) {
  char text[64];
  const auto end = std::to_chars(text, text + sizeof text, number, std::chars_format::general, 4);
  return Message::numbers({text, end.ptr});
}

std::string exact(double number) {
  char text[64];
  const auto end = std::to_chars(text, text + sizeof text, number);
  return {text, end.ptr};
}

double freeMemory() {
  std::ifstream file("/proc/meminfo");
  std::string word;
  double kilobytes = 0.0;
  while (file >> word)
    if (word == "MemAvailable:" && file >> kilobytes) return kilobytes * 1024.0;
  return static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
}

haptics::Expected<void> checkRoom(std::int64_t voxels, std::int64_t bytes_per_voxel,
                                  Message advice) {
  const double needed = static_cast<double>(voxels) * static_cast<double>(bytes_per_voxel);
  const double there = freeMemory();
  if (needed <= there) return {};
  return unsupported("too-large", {"memory-too-small-for-volume",
                                   {brief(needed / 1e9), brief(there / 1e9), std::move(advice)}});
}

}  // namespace datasets
