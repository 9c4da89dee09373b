// SPDX-License-Identifier: BSD-3-Clause
#include "app/build_info/build_info.h"

#include <cstdint>
#include <fstream>
#include <string>
#include <thread>

#include "app/build_info/build_identity.h"
#include "haptics/field/lanes.h"

namespace app {

extern const char* const kCommit;  // commit.cpp, which the build writes

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

nlohmann::ordered_json madeBy(const std::string& program) {
  return {{"program", program},
          {"version", versionHere()},
          {"commit", commitHere()},
          {"build", buildHere()},
          {"vectors", haptics::lanes::targetName()}};
}

std::string versionHere() { return PALPATE_VERSION; }

std::string commitHere() { return kCommit; }

std::string buildHere() {
  // of the module with this code: the program, or the library of the window
  struct Sought {
    std::uintptr_t place;
    std::string identity;
  } sought{reinterpret_cast<std::uintptr_t>(&buildHere), {}};
  dl_iterate_phdr(
      [](dl_phdr_info* module, std::size_t, void* out) {
        auto& wanted = *static_cast<Sought*>(out);
        for (int n = 0; n < module->dlpi_phnum; ++n) {
          const ElfW(Phdr)& segment = module->dlpi_phdr[n];
          if (segment.p_type != PT_LOAD ||
              wanted.place - module->dlpi_addr - segment.p_vaddr >= segment.p_memsz)
            continue;
          wanted.identity = buildIdentityOf(*module);
          return 1;
        }
        return 0;
      },
      &sought);
  return sought.identity.empty() ? "unknown" : sought.identity;
}

}  // namespace app
