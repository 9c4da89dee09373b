// SPDX-License-Identifier: BSD-3-Clause
#include "app/build_info/build_info.h"

#include <elf.h>
#include <link.h>

#include <cstring>
#include <fstream>
#include <thread>

#include "haptics/field/lanes.h"

namespace app {
namespace {

/// The build identity among the notes of the first object, which is the program itself.
int readIdentity(dl_phdr_info* program, std::size_t, void* out) {
  constexpr const char* kDigits = "0123456789abcdef";
  for (int n = 0; n < program->dlpi_phnum; ++n) {
    const ElfW(Phdr)& segment = program->dlpi_phdr[n];
    if (segment.p_type != PT_NOTE) continue;
    const auto* at = reinterpret_cast<const char*>(program->dlpi_addr + segment.p_vaddr);
    const char* end = at + segment.p_memsz;
    const auto padded = [](std::size_t size) { return (size + 3) / 4 * 4; };
    while (at + sizeof(ElfW(Nhdr)) <= end) {
      ElfW(Nhdr) note;
      std::memcpy(&note, at, sizeof note);
      const char* name = at + sizeof note;
      const char* content = name + padded(note.n_namesz);
      if (note.n_type == NT_GNU_BUILD_ID && note.n_namesz == 4 &&
          std::memcmp(name, "GNU", 4) == 0) {
        auto& identity = *static_cast<std::string*>(out);
        for (std::size_t b = 0; b < note.n_descsz; ++b) {
          const auto byte = static_cast<unsigned char>(content[b]);
          identity += kDigits[byte / 16];
          identity += kDigits[byte % 16];
        }
        return 1;
      }
      at = content + padded(note.n_descsz);
    }
  }
  return 1;
}

}  // namespace

nlohmann::ordered_json machineHere() {
  std::string cpu = "unknown", line;
  std::ifstream info{"/proc/cpuinfo"};
  while (std::getline(info, line))
    if (line.starts_with("model name")) {
      cpu = line.substr(line.find(':') + 2);
      break;
    }
  return {{"cpu", cpu},
          {"cores", std::thread::hardware_concurrency()},
          {"vectors", haptics::lanes::targetName()},
          {"compiler", __VERSION__},
          {"flags", PALPATE_BUILD_FLAGS}};
}

std::string versionHere() { return PALPATE_VERSION; }

std::string buildHere() {
  std::string identity;
  dl_iterate_phdr(readIdentity, &identity);
  return identity.empty() ? "unknown" : identity;
}

}  // namespace app
