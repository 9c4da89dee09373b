// SPDX-License-Identifier: BSD-3-Clause
#include "app/fetch/supervisor.h"

#include <fcntl.h>
#include <malloc.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/signalfd.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <new>
#include <utility>

#include "haptics/process/process_limits.h"

namespace app::fetch {
namespace {

using haptics::limitResource;
using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds kGrace{700};  // from SIGTERM to SIGKILL
constexpr int kLook_ms = 50;
constexpr rlim_t kMoreMemory = rlim_t{1} << 30;  // bytes, beyond what the program begins with
constexpr int kKept = 16 << 20;                  // bytes that are free and not given back
constexpr rlim_t kMostTime_s = 1800;             // of the processor
constexpr rlim_t kLargestFile = rlim_t{64} << 30;
constexpr rlim_t kMostFiles = 256;
constexpr std::size_t kLongestAnswer = std::size_t{64} << 20;

bool confine() {
  bool sound =
      prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 && limitResource(RLIMIT_CPU, kMostTime_s) &&
      limitResource(RLIMIT_FSIZE, kLargestFile) && limitResource(RLIMIT_NOFILE, kMostFiles);
  if constexpr (!haptics::kSanitized) {
    // each arena of the C library's takes 64 MiB of addresses, however little is in it; and memory
    // that it gives back and takes again costs more than what is done with it
    sound = sound && mallopt(M_ARENA_MAX, 1) == 1 && mallopt(M_TRIM_THRESHOLD, kKept) == 1 &&
            mallopt(M_MMAP_THRESHOLD, kKept) == 1 && haptics::limitAddresses(kMoreMemory);
  }
  return sound;
}

bool writeWhole(int descriptor, const std::string& bytes) {
  for (std::size_t at = 0; at < bytes.size();) {
    const ssize_t size = write(descriptor, bytes.data() + at, bytes.size() - at);
    if (size < 0 && errno == EINTR) continue;
    if (size <= 0) return false;
    at += static_cast<std::size_t>(size);
  }
  return true;
}

[[noreturn]] void beChild(int answers, pid_t parent, const std::function<Outcome()>& work) {
  // a supervisor that is killed leaves nobody at the network
  prctl(PR_SET_PDEATHSIG, SIGKILL, 0, 0, 0);
  if (getppid() != parent) _exit(1);
  for (const int signal : {SIGINT, SIGHUP, SIGPIPE, SIGXFSZ}) std::signal(signal, SIG_IGN);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  const int nowhere = open("/dev/null", O_RDWR | O_CLOEXEC);
  // libraries say on standard error what a server sent
  if (nowhere < 0 || dup2(nowhere, STDIN_FILENO) < 0 || dup2(nowhere, STDERR_FILENO) < 0 ||
      !haptics::forbidCoreDumps() || !confine())
    _exit(1);
  Outcome outcome;
  try {
    outcome = work();
  } catch (const std::bad_alloc&) {
    outcome = outcomeOf({haptics::Error::Kind::NotFound, {"fetch-memory", {}}, "memory"});
  }
  const nlohmann::ordered_json told{{"code", static_cast<int>(outcome.code)},
                                    {"json", outcome.json},
                                    {"text", outcome.text},
                                    {"error", jsonOf(outcome.error)},
                                    {"reason", outcome.reason}};
  const bool sent =
      writeWhole(answers, told.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
  _exit(sent ? 0 : 1);
}

haptics::Message messageIn(const nlohmann::ordered_json& told, int deepest = 8) {
  if (told.is_string()) return told.get<std::string>();
  haptics::Message message;
  if (!told.is_object() || deepest == 0) return message;
  message.id = told.value("id", "");
  for (const auto& argument : told.value("arguments", nlohmann::ordered_json::array()))
    message.arguments.push_back(messageIn(argument, deepest - 1));
  return message;
}

/// What the child told; nothing if it is not whole.
bool understood(const std::string& text, Outcome& outcome) {
  const auto told = nlohmann::ordered_json::parse(text, nullptr, false);
  if (!told.is_object()) return false;
  outcome = {static_cast<Exit>(told.value("code", 4)), told.value("json", outcome.json),
             told.value("text", ""), messageIn(told.value("error", nlohmann::ordered_json(""))),
             told.value("reason", "")};
  return true;
}

Outcome stopped() {
  return outcomeOf({haptics::Error::Kind::Cancelled, {"fetch-cancelled", {}}, "cancelled"});
}

}  // namespace

Outcome outcomeOf(const haptics::Error& error) {
  Outcome outcome;
  outcome.error = error.message;
  outcome.reason = error.reason;
  outcome.code = error.kind == haptics::Error::Kind::Cancelled  ? Exit::Interrupted
                 : error.kind == haptics::Error::Kind::NotFound ? Exit::Failed
                 : error.reason == "usage"                      ? Exit::Usage
                                                                : Exit::Refused;
  return outcome;
}

nlohmann::ordered_json jsonOf(const haptics::Message& message) {
  if (message.id.empty()) return message.text;
  auto arguments = nlohmann::ordered_json::array();
  for (const haptics::Message& argument : message.arguments) arguments.push_back(jsonOf(argument));
  return {{"id", message.id}, {"arguments", std::move(arguments)}};
}

Supervisor::Supervisor(bool attached) : attached_{attached} {
  haptics::forbidCoreDumps();
  sigset_t set;
  sigemptyset(&set);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaddset(&set, signal);
  sigprocmask(SIG_BLOCK, &set, nullptr);
  std::signal(SIGPIPE, SIG_IGN);
  signals_ = signalfd(-1, &set, SFD_CLOEXEC);
}

void Supervisor::wait(int answers, int milliseconds) {
  std::array<pollfd, 3> waited{pollfd{signals_, POLLIN, 0}, pollfd{answers, POLLIN, 0},
                               pollfd{attached_ ? STDIN_FILENO : -1, POLLIN, 0}};
  if (poll(waited.data(), waited.size(), milliseconds) <= 0) return;
  if (waited[0].revents != 0) {
    signalfd_siginfo which{};
    if (read(signals_, &which, sizeof which) > 0) stopped_ = true;
  }
  if (waited[2].revents != 0) {
    char ignored[512];
    if (read(STDIN_FILENO, ignored, sizeof ignored) <= 0) stopped_ = true, attached_ = false;
  }
}

void Supervisor::waitForStop() {
  while (!stopped_) wait(-1, -1);
}

Outcome Supervisor::run(const std::function<Outcome()>& work, double longest_s) {
  const Outcome not_started =
      outcomeOf({haptics::Error::Kind::NotFound, {"fetch-not-started", {}}, "not-started"});
  std::array<int, 2> ends{-1, -1};
  if (signals_ < 0 || pipe2(ends.data(), O_CLOEXEC) != 0) return not_started;
  const pid_t parent = getpid();
  const pid_t child = fork();
  if (child == 0) {
    close(ends[0]);
    beChild(ends[1], parent, work);
  }
  close(ends[1]);
  if (child < 0) {
    close(ends[0]);
    return not_started;
  }

  const auto until = Clock::now() + std::chrono::duration<double>(longest_s);
  Clock::time_point asked{};
  bool late = false, killed = false;
  std::string text;
  for (bool open = true; open;) {
    wait(ends[0], kLook_ms);
    pollfd readable{ends[0], POLLIN, 0};
    if (poll(&readable, 1, 0) > 0) {
      char bytes[65536];
      const ssize_t size = read(ends[0], bytes, sizeof bytes);
      if (size > 0) text.append(bytes, static_cast<std::size_t>(size));
      open = size > 0 || (size < 0 && errno == EINTR);
    }
    const auto now = Clock::now();
    if (stopped_ && asked == Clock::time_point{}) {
      asked = now;
      kill(child, SIGTERM);
    }
    late = late || now > until || text.size() > kLongestAnswer;
    if (!killed && (late || (stopped_ && now - asked > kGrace))) killed = kill(child, SIGKILL) == 0;
  }
  close(ends[0]);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  Outcome outcome;
  if (stopped_) return stopped();
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0 && understood(text, outcome)) return outcome;
  if (late)
    return outcomeOf({haptics::Error::Kind::NotFound,
                      {"fetch-too-long", {std::to_string(static_cast<int>(longest_s))}},
                      "too-long"});
  return outcomeOf({haptics::Error::Kind::NotFound, {"fetch-died", {}}, "died"});
}

}  // namespace app::fetch
