// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/readers/files/refusal.h"

#include <unistd.h>

#include <charconv>
#include <fstream>

namespace datasets {

using haptics::Error;

tl::unexpected<Error> malformed(std::string reason, std::string what) {
  return tl::unexpected(Error{Error::Kind::Malformed, std::move(what), std::move(reason)});
}

tl::unexpected<Error> unsupported(std::string reason, std::string what) {
  return tl::unexpected(Error{Error::Kind::Unsupported, std::move(what), std::move(reason)});
}

tl::unexpected<Error> notFound(const std::filesystem::path& path) {
  return tl::unexpected(Error{Error::Kind::NotFound,
                              "There is no file or folder " + quoted(path) +
                                  " that can be read; check its name and its permissions.",
                              "unreadable"});
}

tl::unexpected<Error> cancelled() {
  return tl::unexpected(Error{Error::Kind::Cancelled, "Loading was cancelled.", "cancelled"});
}

std::string quoted(const std::filesystem::path& path) {
  const auto name = path.has_filename() ? path.filename() : path.parent_path().filename();
  return "\"" + name.string() + "\"";
}

std::string brief(double number) {
  char text[64];
  const auto end = std::to_chars(text, text + sizeof text, number, std::chars_format::general, 4);
  return {text, end.ptr};
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
                                  const char* advice) {
  const double needed = static_cast<double>(voxels) * static_cast<double>(bytes_per_voxel);
  const double there = freeMemory();
  if (needed <= there) return {};
  return unsupported("too-large", "The volume needs " + brief(needed / 1e9) + " GB of memory and " +
                                      brief(there / 1e9) +
                                      " GB are free; read every second voxel or a box of it, or " +
                                      advice + ".");
}

}  // namespace datasets
