// SPDX-License-Identifier: BSD-3-Clause
#include "app/build_info/build_info.h"

#include <fstream>
#include <thread>

#include "app/build_info/build_identity.h"
#include "haptics/field/lanes.h"

namespace app {

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
  // the first module is the program itself
  dl_iterate_phdr(
      [](dl_phdr_info* program, std::size_t, void* out) {
        *static_cast<std::string*>(out) = buildIdentityOf(*program);
        return 1;
      },
      &identity);
  return identity.empty() ? "unknown" : identity;
}

}  // namespace app
