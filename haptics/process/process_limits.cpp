// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/process/process_limits.h"

#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <fstream>

namespace haptics {

bool limitResource(int resource, std::uint64_t most) {
  const rlimit both{most, most};
  return setrlimit(static_cast<__rlimit_resource>(resource), &both) == 0;
}

bool forbidCoreDumps() {
  // a dump that is piped to a program heeds no limit
  return limitResource(RLIMIT_CORE, 0) && prctl(PR_SET_DUMPABLE, 0, 0, 0, 0) == 0;
}

bool limitAddresses(std::uint64_t more_bytes) {
  std::ifstream file("/proc/self/statm");
  std::uint64_t pages = 0;
  if (!(file >> pages)) return false;
  const std::uint64_t now = pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
  return limitResource(RLIMIT_AS, now + more_bytes);
}

}  // namespace haptics
