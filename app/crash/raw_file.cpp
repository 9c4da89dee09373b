// SPDX-License-Identifier: BSD-3-Clause
#include "app/crash/raw_file.h"

#include <dlfcn.h>
#include <elf.h>
#include <fcntl.h>
#include <link.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <ucontext.h>
#include <unistd.h>
#include <unwind.h>

#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <system_error>

#include "app/build_info/build_identity.h"
#include "app/build_info/build_info.h"
#include "app/log/log.h"
#include "haptics/servo/emergency.h"

namespace app::crash {
namespace {

namespace fs = std::filesystem;

int crash_file = -1;  // as the signal handler has it

// --- in the signal handler: no allocation, no lock -------------------------------------------

/// A line on its way to the file.
class Line {
 public:
  void add(const char* text) {
    while (*text != '\0') add(*text++);
  }
  void addHex(std::uint64_t number) {
    int digits = 1;
    while (digits < 16 && number >> (4 * digits) != 0) ++digits;
    while (digits > 0) add("0123456789abcdef"[number >> (4 * --digits) & 15]);
  }
  void addByte(unsigned char byte) {
    add("0123456789abcdef"[byte / 16]);
    add("0123456789abcdef"[byte % 16]);
  }
  void end() {
    add('\n');
    for (std::size_t done = 0; done < length_;) {
      const ssize_t count = write(crash_file, text_ + done, length_ - done);
      if (count < 0 && errno == EINTR) continue;
      if (count <= 0) break;
      done += static_cast<std::size_t>(count);
    }
    length_ = 0;
  }

 private:
  void add(char c) {
    if (length_ < sizeof text_) text_[length_++] = c;
  }
  char text_[160];
  std::size_t length_ = 0;
};

/// Adds the build identity of the module whose first page is here. False if it has none.
bool addIdentity(Line& line, const char* first, std::uintptr_t bias) {
  if (std::memcmp(first, ELFMAG, SELFMAG) != 0) return false;
  ElfW(Ehdr) head;
  std::memcpy(&head, first, sizeof head);
  for (unsigned n = 0; n < head.e_phnum; ++n) {
    ElfW(Phdr) segment;
    std::memcpy(&segment, first + head.e_phoff + n * sizeof segment, sizeof segment);
    if (segment.p_type != PT_NOTE) continue;
    const auto* at = reinterpret_cast<const char*>(bias + segment.p_vaddr);
    const auto identity = buildIdentityIn(at, at + segment.p_memsz);
    if (identity.empty() || identity.size() > raw::kLongestIdentity) continue;
    for (const unsigned char byte : identity) line.addByte(byte);
    return true;
  }
  return false;
}

/// False if the address belongs to no module.
bool writeFrame(std::uintptr_t address, bool is_instruction) {
  Line line;
  line.add(raw::kAt);
  // glibc's own way for unwinders: it takes no lock
  dl_find_object module{};
  const bool known = _dl_find_object(reinterpret_cast<void*>(address), &module) == 0;
  const std::uintptr_t bias = known ? module.dlfo_link_map->l_addr : 0;
  if (!known || !addIdentity(line, static_cast<const char*>(module.dlfo_map_start), bias))
    line.add("-");
  line.add(" ");
  line.addHex(address - bias);
  line.add(is_instruction ? " 1" : " 0");
  line.end();
  return known;
}

struct Machine {
  std::uintptr_t instruction = 0, caller = 0;  // of the function that has no frame yet
};

Machine machineOf(const void* context, bool with_caller) {
  Machine machine;
#if defined(__x86_64__)
  const auto& registers = static_cast<const ucontext_t*>(context)->uc_mcontext.gregs;
  machine.instruction = static_cast<std::uintptr_t>(registers[REG_RIP]);
  if (with_caller)
    std::memcpy(&machine.caller, reinterpret_cast<const void*>(registers[REG_RSP]),
                sizeof machine.caller);
#elif defined(__aarch64__)
  const auto& registers = static_cast<const ucontext_t*>(context)->uc_mcontext;
  machine.instruction = registers.pc;
  if (with_caller) machine.caller = registers.regs[30];
#else
  (void)context;
  (void)with_caller;
#endif
  return machine;
}

struct Walk {
  std::uintptr_t from;  // the instruction that crashed
  bool reached = false;
  int frames = 1;
};

_Unwind_Reason_Code step(_Unwind_Context* context, void* state) {
  auto& walk = *static_cast<Walk*>(state);
  int is_instruction = 0;
  const auto address = static_cast<std::uintptr_t>(_Unwind_GetIPInfo(context, &is_instruction));
  if (!walk.reached) {
    // the frames before it are those of the handler
    walk.reached = address == walk.from;
    return _URC_NO_REASON;
  }
  if (address == 0 || walk.frames++ == raw::kMostFrames) return _URC_END_OF_STACK;
  writeFrame(address, is_instruction != 0);
  return _URC_NO_REASON;
}

void onCrash(int signal, void* context) {
  Line line;
  line.add(raw::kSignal);
  line.addHex(static_cast<unsigned>(signal));
  line.end();
  Walk walk{machineOf(context, false).instruction};
  if (!writeFrame(walk.from, true)) {
    // a call to nowhere: who called is where its return address lies
    writeFrame(machineOf(context, true).caller, false);
    walk.frames = raw::kMostFrames;
  }
  if (walk.frames < raw::kMostFrames) _Unwind_Backtrace(step, &walk);
}

// ----------------------------------------------------------------------------------------------

/// Without it the first use of the unwinder could load or allocate something.
_Unwind_Reason_Code lookOnly(_Unwind_Context*, void*) { return _URC_NO_REASON; }

}  // namespace

RawFile::RawFile(const fs::path& folder) {
  if (folder.empty()) return;
  std::error_code failed;
  fs::create_directories(folder, failed);
  fs::permissions(folder, fs::perms::owner_all, failed);
  std::string made = (folder / "crash-").string() + std::string(6, 'X');  // a name of mkostemp's
  file_ = mkostemp(made.data(), O_CLOEXEC | O_APPEND);                    // for its owner's eyes
  if (file_ < 0) return;
  const std::string head = std::string{raw::kHead} + '\n' + raw::kVersion + versionHere() + '\n' +
                           raw::kBuild + buildHere() + '\n' + raw::kSession + log::session() + '\n';
  path_ = made + raw::kEnding;
  // the next start takes only those that nobody holds
  if (flock(file_, LOCK_EX | LOCK_NB) != 0 ||
      write(file_, head.data(), head.size()) != static_cast<ssize_t>(head.size()) ||
      std::rename(made.c_str(), path_.c_str()) != 0) {
    unlink(made.c_str());
    close(file_);
    file_ = -1;
    path_.clear();
    return;
  }
  crash_file = file_;
  _Unwind_Backtrace(lookOnly, nullptr);
  haptics::setAfterCrashStop(onCrash);
}

RawFile::~RawFile() {
  if (file_ < 0) return;
  haptics::setAfterCrashStop(nullptr);
  unlink(path_.c_str());
  close(file_);
}

}  // namespace app::crash
