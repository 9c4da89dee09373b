// SPDX-License-Identifier: BSD-3-Clause
#include "tests/bus/child.h"

#include <fcntl.h>
#include <grp.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <iostream>
#include <sstream>
#include <thread>

#include "haptics/devices/catalogue.h"
#include "tests/bus/felt_sphere.h"
#include "tests/support/sentence.h"

namespace bus {

Child::Child(As who, const std::vector<std::string>& words) {
  constexpr unsigned kUser = 1000;
  std::string program = "/proc/self/exe";
  std::vector<std::string> copies = words;
  std::vector<char*> arguments{program.data()};
  for (std::string& word : copies) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) return;
  process_ = fork();
  if (process_ == 0) {
    // only what a signal handler might do: other threads were not copied
    dup2(ends[1], STDOUT_FILENO);
    if (who == As::User && (setgroups(0, nullptr) != 0 || setresgid(kUser, kUser, kUser) != 0 ||
                            setresuid(kUser, kUser, kUser) != 0))
      _exit(3);
    execv(program.c_str(), arguments.data());
    _exit(4);
  }
  close(ends[1]);
  words_ = ends[0];
}

Child::~Child() {
  kill();
  close(words_);
}

void Child::kill() {
  if (process_ <= 0) return;
  ::kill(process_, SIGKILL);
  while (waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
  }
  process_ = -1;
}

std::string Child::line() {
  std::string text;
  for (char letter = 0; read(words_, &letter, 1) == 1 && letter != '\n';) text += letter;
  return text;
}

std::string Child::said() {
  std::string text;
  std::array<char, 4096> part{};
  for (ssize_t n = 0; (n = read(words_, part.data(), part.size())) > 0;)
    text.append(part.data(), std::size_t(n));
  return text;
}

int childMain(const std::string& what, const std::string& id) {
  if (what == "survey") {
    for (const haptics::DeviceEntry& entry : haptics::surveyDevices())
      std::cout << entry.id << ' ' << haptics::wordOf(entry.trouble) << ' ' << sentence(entry.why)
                << '\n';
    return 0;
  }
  auto device = haptics::openDevice({id});
  if (!device) {
    std::cout << device.error().reason << ' ' << sentence(device.error()) << '\n';
    return 0;
  }
  if (what == "open") {
    std::cout << "opened\n";
    return 0;
  }
  FeltSphere sphere{std::move(*device)};
  sphere.arm();
  std::cout << "armed" << std::endl;
  for (;;) std::this_thread::sleep_for(std::chrono::seconds{1});
}

std::string lineOf(const std::string& survey, const std::string& id) {
  std::istringstream lines{survey};
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with(id + ' ') || line.starts_with(id + ':')) return line;
  return {};
}

}  // namespace bus
