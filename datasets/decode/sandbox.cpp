// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/decode/sandbox.h"

#include <seccomp.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <fstream>
#include <memory>

namespace datasets::decode {
namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kSanitized = true;
#elif defined(__has_feature)
constexpr bool kSanitized = __has_feature(address_sanitizer) || __has_feature(thread_sanitizer);
#else
constexpr bool kSanitized = false;
#endif

bool limit(__rlimit_resource which, rlim_t most) {
  const rlimit both{most, most};
  return setrlimit(which, &both) == 0;
}

/// Address space in use, bytes; 0 if it cannot be told.
std::uint64_t addressSpace() {
  std::ifstream file("/proc/self/statm");
  std::uint64_t pages = 0;
  if (!(file >> pages)) return 0;
  return pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

struct Releases {
  void operator()(void* filter) const { seccomp_release(filter); }
};

bool forbidSystemCalls() {
  const std::unique_ptr<void, Releases> filter{seccomp_init(SCMP_ACT_KILL_PROCESS)};
  if (!filter) return false;
  bool sound = true;
  const auto allow = [&](int call) {
    sound = sound && seccomp_rule_add(filter.get(), SCMP_ACT_ALLOW, call, 0) == 0;
  };
  // memory, time, and the end, also by abort()
  for (const int call :
       {SCMP_SYS(brk), SCMP_SYS(munmap), SCMP_SYS(mremap), SCMP_SYS(madvise), SCMP_SYS(futex),
        SCMP_SYS(clock_gettime), SCMP_SYS(gettimeofday), SCMP_SYS(alarm), SCMP_SYS(setitimer),
        SCMP_SYS(getrandom), SCMP_SYS(getpid), SCMP_SYS(gettid), SCMP_SYS(tgkill),
        SCMP_SYS(rt_sigprocmask), SCMP_SYS(rt_sigaction), SCMP_SYS(rt_sigreturn),
        SCMP_SYS(restart_syscall), SCMP_SYS(exit), SCMP_SYS(exit_group)})
    allow(call);
  // the C library gives memory back by making it inaccessible; nothing becomes executable
  sound = sound &&
          seccomp_rule_add(filter.get(), SCMP_ACT_ALLOW, SCMP_SYS(mprotect), 1,
                           SCMP_A2(SCMP_CMP_MASKED_EQ, PROT_EXEC, 0)) == 0 &&
          seccomp_rule_add(filter.get(), SCMP_ACT_ALLOW, SCMP_SYS(mmap), 2,
                           SCMP_A2(SCMP_CMP_MASKED_EQ, PROT_EXEC, 0),
                           SCMP_A3(SCMP_CMP_MASKED_EQ, MAP_ANONYMOUS, MAP_ANONYMOUS)) == 0 &&
          seccomp_rule_add(filter.get(), SCMP_ACT_ALLOW, SCMP_SYS(read), 1,
                           SCMP_A0(SCMP_CMP_EQ, STDIN_FILENO)) == 0 &&
          seccomp_rule_add(filter.get(), SCMP_ACT_ALLOW, SCMP_SYS(write), 1,
                           SCMP_A0(SCMP_CMP_EQ, STDOUT_FILENO)) == 0;
  return sound && seccomp_load(filter.get()) == 0;
}

}  // namespace

bool confine(std::uint64_t more_bytes) {
  // a dump that is piped to a program heeds no limit
  if (!limit(RLIMIT_CORE, 0) || prctl(PR_SET_DUMPABLE, 0, 0, 0, 0) != 0) return false;
  if constexpr (kSanitized) return true;
  const std::uint64_t now = addressSpace();
  return now > 0 && limit(RLIMIT_AS, now + more_bytes) && limit(RLIMIT_FSIZE, 0) &&
         limit(RLIMIT_NOFILE, 0) && prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
         forbidSystemCalls();
}

}  // namespace datasets::decode
