// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/core/core_dump.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>

namespace haptics {
namespace {

constexpr std::uintptr_t kSmall = 128 * 1024;  // malloc gives from here on a mapping to each

// a line of /proc/self/maps: first-end perms offset device inode name
struct Mapping {
  std::uintptr_t first = 0, end = 0;
  bool writable = false, of_file = false, first_stack = false, memory_file = false;
};

/// Reads a number; `at` is then behind it.
std::uintptr_t numberAt(const char*& at, unsigned base) {
  std::uintptr_t number = 0;
  for (;; ++at) {
    const char c = *at;
    unsigned digit = 16;
    if (c >= '0' && c <= '9') digit = static_cast<unsigned>(c - '0');
    if (c >= 'a' && c <= 'f') digit = static_cast<unsigned>(c - 'a') + 10;
    if (digit >= base) return number;
    number = number * base + digit;
  }
}

void skipWord(const char*& at) {
  while (*at != '\0' && *at != ' ') ++at;
  while (*at == ' ') ++at;
}

Mapping mappingOf(const char* line) {
  Mapping mapping;
  mapping.first = numberAt(line, 16);
  if (*line != '-') return {};
  mapping.end = numberAt(++line, 16);
  if (*line != ' ') return {};
  mapping.writable = *++line != '\0' && line[1] == 'w';
  for (int word = 0; word < 3; ++word) skipWord(line);  // perms, offset, device
  mapping.of_file = numberAt(line, 10) != 0;
  while (*line == ' ') ++line;
  mapping.first_stack = std::strncmp(line, "[stack]", 7) == 0;
  // memory that is shared has a name that nobody gave it
  mapping.memory_file =
      std::strncmp(line, "/memfd:", 7) == 0 || std::strncmp(line, "/dev/zero", 9) == 0 ||
      std::strncmp(line, "/dev/shm/", 9) == 0 || std::strncmp(line, "/SYSV", 5) == 0;
  return mapping;
}

void keepOut(const Mapping& mapping, std::uintptr_t stack) noexcept {
  if (!mapping.writable || mapping.first_stack) return;
  if (mapping.first <= stack && stack < mapping.end) return;
  if (mapping.of_file && !mapping.memory_file) return;
  if (mapping.end - mapping.first < kSmall) return;
  madvise(reinterpret_cast<void*>(mapping.first), mapping.end - mapping.first, MADV_DONTDUMP);
}

}  // namespace

void keepOutOfCoreDumps(void* first, std::size_t bytes) noexcept {
  const auto page = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE));
  const auto at = reinterpret_cast<std::uintptr_t>(first);
  const std::uintptr_t begin = at / page * page, end = (at + bytes + page - 1) / page * page;
  madvise(reinterpret_cast<void*>(begin), end - begin, MADV_DONTDUMP);
}

void keepHeapOutOfCoreDump() noexcept {
  const int error = errno;
  const int file = open("/proc/self/maps", O_RDONLY | O_CLOEXEC);
  if (file < 0) prctl(PR_SET_DUMPABLE, 0, 0, 0, 0);
  std::array<char, 512> line;
  std::array<char, 4096> read_ahead;
  const auto stack = reinterpret_cast<std::uintptr_t>(line.data());
  std::size_t length = 0;
  for (;;) {
    const ssize_t count = read(file, read_ahead.data(), read_ahead.size());
    if (count <= 0) break;
    for (ssize_t n = 0; n < count; ++n) {
      const char c = read_ahead[static_cast<std::size_t>(n)];
      if (c == '\n') {
        line[length] = '\0';
        keepOut(mappingOf(line.data()), stack);
        length = 0;
      } else if (length + 1 < line.size()) {
        line[length++] = c;
      }
    }
  }
  close(file);
  errno = error;
}

}  // namespace haptics
