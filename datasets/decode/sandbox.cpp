// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/decode/sandbox.h"

#include <seccomp.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <initializer_list>
#include <memory>

#include "haptics/process/process_limits.h"

namespace datasets::decode {
namespace {

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
  // (the header's own macros for an argument are C)
  const auto allowIf = [&](int call, std::initializer_list<scmp_arg_cmp> arguments) {
    sound = sound &&
            seccomp_rule_add_array(filter.get(), SCMP_ACT_ALLOW, call,
                                   static_cast<unsigned>(arguments.size()), arguments.begin()) == 0;
  };
  const scmp_arg_cmp not_executable{2, SCMP_CMP_MASKED_EQ, PROT_EXEC, 0};
  // the C library gives memory back by making it inaccessible; nothing becomes executable
  allowIf(SCMP_SYS(mprotect), {not_executable});
  allowIf(SCMP_SYS(mmap), {not_executable, {3, SCMP_CMP_MASKED_EQ, MAP_ANONYMOUS, MAP_ANONYMOUS}});
  allowIf(SCMP_SYS(read), {{0, SCMP_CMP_EQ, STDIN_FILENO, 0}});
  allowIf(SCMP_SYS(write), {{0, SCMP_CMP_EQ, STDOUT_FILENO, 0}});
  return sound && seccomp_load(filter.get()) == 0;
}

}  // namespace

bool confine(std::uint64_t more_bytes) {
  using haptics::limitResource;
  if (!haptics::forbidCoreDumps()) return false;
  if constexpr (haptics::kSanitized) return true;
  return haptics::limitAddresses(more_bytes) && limitResource(RLIMIT_FSIZE, 0) &&
         limitResource(RLIMIT_NOFILE, 0) && prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
         forbidSystemCalls();
}

}  // namespace datasets::decode
