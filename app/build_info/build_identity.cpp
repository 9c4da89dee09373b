// SPDX-License-Identifier: BSD-3-Clause
#include "app/build_info/build_identity.h"

#include <elf.h>

#include <cstddef>
#include <cstring>

namespace app {

std::span<const unsigned char> buildIdentityIn(const char* at, const char* end) noexcept {
  const auto padded = [](std::size_t size) { return (size + 3) / 4 * 4; };
  ElfW(Nhdr) note;
  for (std::size_t left; (left = static_cast<std::size_t>(end - at)) >= sizeof note;) {
    std::memcpy(&note, at, sizeof note);
    const std::size_t before = sizeof note + padded(note.n_namesz);
    const std::size_t whole = before + padded(note.n_descsz);
    if (whole > left) break;
    if (note.n_type == NT_GNU_BUILD_ID && note.n_namesz == 4 &&
        std::memcmp(at + sizeof note, "GNU", 4) == 0)
      return {reinterpret_cast<const unsigned char*>(at + before), note.n_descsz};
    at += whole;
  }
  return {};
}

std::string buildIdentityOf(const dl_phdr_info& module) {
  constexpr const char* kDigits = "0123456789abcdef";
  std::string identity;
  for (int n = 0; n < module.dlpi_phnum && identity.empty(); ++n) {
    const ElfW(Phdr)& segment = module.dlpi_phdr[n];
    if (segment.p_type != PT_NOTE) continue;
    const auto* at = reinterpret_cast<const char*>(module.dlpi_addr + segment.p_vaddr);
    for (const unsigned char byte : buildIdentityIn(at, at + segment.p_memsz)) {
      identity += kDigits[byte / 16];
      identity += kDigits[byte % 16];
    }
  }
  return identity;
}

}  // namespace app
