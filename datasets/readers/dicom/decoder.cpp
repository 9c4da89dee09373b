// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/readers/dicom/decoder.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

#include "datasets/readers/files/refusal.h"
#include "haptics/process/helper_program.h"

namespace datasets {

using haptics::Expected;

namespace {

constexpr const char* kProgram = "palpate-decode";
constexpr double kStartTime = 10.0;     // s
constexpr double kFrameTime = 10.0;     // s, and
constexpr double kTimeOfAPixel = 5e-8;  // s
constexpr int kListen_ms = 50;          // between looks at Cancel

/// Closed when it goes.
class Descriptor {
 public:
  explicit Descriptor(int descriptor) : descriptor_{descriptor} {}
  ~Descriptor() {
    if (descriptor_ >= 0) close(descriptor_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int get() const { return descriptor_; }
  int release() { return std::exchange(descriptor_, -1); }

 private:
  int descriptor_;
};

tl::unexpected<haptics::Error> notStarted(haptics::Message why) {
  return unsupported("no-decoder", std::move(why));
}

bool sendWhole(int socket, const void* bytes, std::size_t size) {
  const char* from = static_cast<const char*>(bytes);
  while (size > 0) {
    const ssize_t sent = send(socket, from, size, MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) return false;
    from += sent;
    size -= static_cast<std::size_t>(sent);
  }
  return true;
}

/// What a program is started with.
struct Spawning {
  posix_spawn_file_actions_t actions;
  posix_spawnattr_t attributes;

  Spawning() {
    posix_spawn_file_actions_init(&actions);
    posix_spawnattr_init(&attributes);
  }
  ~Spawning() {
    posix_spawn_file_actions_destroy(&actions);
    posix_spawnattr_destroy(&attributes);
  }
  Spawning(const Spawning&) = delete;
  Spawning& operator=(const Spawning&) = delete;
};

/// What of the environment the program needs: where libraries lie, and what tests tell the C
/// library and the sanitizers. Codecs look for switches of their own there.
std::vector<char*> environmentOfDecoder() {
  std::vector<char*> kept;
  for (char** variable = environ; *variable != nullptr; ++variable)
    for (const std::string_view name : {"LD_LIBRARY_PATH=", "MALLOC_PERTURB_=", "ASAN_OPTIONS=",
                                        "LSAN_OPTIONS=", "UBSAN_OPTIONS=", "TSAN_OPTIONS="})
      if (std::string_view{*variable}.starts_with(name)) kept.push_back(*variable);
  kept.push_back(nullptr);
  return kept;
}

/// The program with a socket as its input and output and the memory as its third descriptor, and
/// nothing else of this process: no other descriptor, signals as usual, deaf to the terminal.
pid_t spawn(const std::filesystem::path& program, int socket, int memory) {
  // the third descriptor may be taken, by one of these two even: both go up first
  const Descriptor socket_above{fcntl(socket, F_DUPFD_CLOEXEC, 10)};
  const Descriptor memory_above{fcntl(memory, F_DUPFD_CLOEXEC, 10)};
  if (socket_above.get() < 0 || memory_above.get() < 0) return -1;
  Spawning with;
  posix_spawn_file_actions_adddup2(&with.actions, socket_above.get(), STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&with.actions, socket_above.get(), STDOUT_FILENO);
  posix_spawn_file_actions_addopen(&with.actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_adddup2(&with.actions, memory_above.get(), decode::kMemoryDescriptor);
  posix_spawn_file_actions_addclosefrom_np(&with.actions, decode::kMemoryDescriptor + 1);
  sigset_t none, all;
  sigemptyset(&none);
  sigfillset(&all);
  posix_spawnattr_setsigmask(&with.attributes, &none);
  posix_spawnattr_setsigdefault(&with.attributes, &all);
  posix_spawnattr_setpgroup(&with.attributes, 0);
  posix_spawnattr_setflags(&with.attributes,
                           POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP);
  std::array<char*, 2> arguments{const_cast<char*>(kProgram), nullptr};
  std::vector<char*> environment = environmentOfDecoder();
  pid_t process = -1;
  const int failed = posix_spawn(&process, program.c_str(), &with.actions, &with.attributes,
                                 arguments.data(), environment.data());
  return failed == 0 ? process : -1;
}

std::string sizeText(std::uint32_t columns, std::uint32_t rows) {
  return std::to_string(columns) + " x " + std::to_string(rows);
}

haptics::Message differenceOf(const decode::Request& frame, const decode::Answer& answer) {
  const char* what = frame.coding <= Coding::JpegLossless ? "JPEG frame"
                     : frame.coding <= Coding::JpegLs     ? "JPEG-LS frame"
                                                          : "JPEG 2000 image";
  const decode::FrameHeader& own = answer.frame;
  const std::string bits_allocated = std::to_string(8 * frame.bytes_per_pixel);
  switch (answer.verdict) {
    case decode::Verdict::Components:
      return {"codestream-components", {what, std::to_string(own.components)}};
    case decode::Verdict::Size:
      return {"codestream-size-differs",
              {what, sizeText(own.columns, own.rows), sizeText(frame.columns, frame.rows)}};
    case decode::Verdict::Depth:
      return {
          "codestream-depth-differs",
          {what, std::to_string(own.precision), std::to_string(frame.bits_stored), bits_allocated}};
    case decode::Verdict::Sign:
      return {"codestream-sign-differs", {}};
    case decode::Verdict::Loss:
      return {"codestream-loss-undeclared", {}};
    case decode::Verdict::Segments:
      return {
          "codestream-rle-segments",
          {std::to_string(own.components), bits_allocated, std::to_string(frame.bytes_per_pixel)}};
    default:
      return {"codestream-other-process", {}};
  }
}

}  // namespace

Expected<Decoder> Decoder::start(std::size_t codestream_bytes, std::size_t pixel_bytes) {
  const std::filesystem::path program = haptics::helperProgram(kProgram);
  if (program.empty()) return notStarted({"decoder-missing", {kProgram}});
  Decoder decoder;
  // the pixels begin where a number of any width may
  decoder.codestream_bytes_ = (codestream_bytes + 63) / 64 * 64;
  decoder.pixel_bytes_ = pixel_bytes;
  const std::size_t all = decoder.codestream_bytes_ + pixel_bytes;
  const Descriptor memory{memfd_create("frame", MFD_CLOEXEC | MFD_ALLOW_SEALING)};
  if (memory.get() < 0 || ftruncate(memory.get(), static_cast<off_t>(all)) != 0 ||
      fcntl(memory.get(), F_ADD_SEALS, F_SEAL_SHRINK | F_SEAL_GROW) != 0)
    return notStarted({"decoder-unusable", {kProgram}});
  void* mapped = mmap(nullptr, all, PROT_READ | PROT_WRITE, MAP_SHARED, memory.get(), 0);
  if (mapped == MAP_FAILED) return notStarted({"decoder-unusable", {kProgram}});
  decoder.memory_ = static_cast<std::byte*>(mapped);
  std::array<int, 2> ends{-1, -1};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0)
    return notStarted({"decoder-unusable", {kProgram}});
  decoder.socket_ = ends[0];
  {
    // closed here at once, so that its end is seen
    const Descriptor theirs{ends[1]};
    decoder.process_ = spawn(program, theirs.get(), memory.get());
  }
  if (decoder.process_ < 0) return notStarted({"decoder-unusable", {kProgram}});
  const decode::Room room{decoder.codestream_bytes_, decoder.pixel_bytes_};
  decode::Answer answer;
  if (!sendWhole(decoder.socket_, &room, sizeof room) ||
      decoder.listen(answer, kStartTime, {}) != Outcome::Decoded ||
      answer.verdict != decode::Verdict::Ready)
    return notStarted({"decoder-unusable", {kProgram}});
  return decoder;
}

Decoder::Decoder(Decoder&& other) noexcept
    : process_{std::exchange(other.process_, -1)},
      socket_{std::exchange(other.socket_, -1)},
      memory_{std::exchange(other.memory_, nullptr)},
      codestream_bytes_{other.codestream_bytes_},
      pixel_bytes_{other.pixel_bytes_} {}

Decoder::~Decoder() {
  end();
  if (memory_ != nullptr) munmap(memory_, codestream_bytes_ + pixel_bytes_);
}

void Decoder::end() {
  if (socket_ >= 0) close(std::exchange(socket_, -1));
  if (process_ < 0) return;
  kill(process_, SIGKILL);
  while (waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
  }
  process_ = -1;
}

Decoder::Outcome Decoder::listen(decode::Answer& answer, double seconds,
                                 const ReadProgress& progress) {
  using Clock = std::chrono::steady_clock;
  const auto until = Clock::now() + std::chrono::duration<double>(seconds);
  for (;;) {
    if (progress.isCancelled()) return Outcome::Cancelled;
    pollfd waited{socket_, POLLIN, 0};
    const int ready = poll(&waited, 1, kListen_ms);
    if (ready < 0 && errno != EINTR) return Outcome::Died;
    if (ready > 0)
      return recv(socket_, &answer, sizeof answer, 0) == sizeof answer ? Outcome::Decoded
                                                                       : Outcome::Died;
    if (Clock::now() > until) return Outcome::TooLong;
  }
}

Decoder::Outcome Decoder::decode(decode::Request frame, std::span<const std::byte> bytes,
                                 const ReadProgress& progress) {
  using enum decode::Verdict;
  const double pixels = double(frame.columns) * double(frame.rows);
  if (process_ < 0 || bytes.size() > codestream_bytes_ ||
      pixels * frame.bytes_per_pixel > double(pixel_bytes_))
    return Outcome::Died;
  std::memcpy(memory_, bytes.data(), bytes.size());
  frame.codestream_bytes = bytes.size();
  Outcome outcome = Outcome::Died;
  decode::Answer answer;
  if (sendWhole(socket_, &frame, sizeof frame))
    outcome = listen(answer, kFrameTime + kTimeOfAPixel * pixels, progress);
  if (outcome == Outcome::Decoded) {
    if (answer.verdict == Decoded) return Outcome::Decoded;
    if (answer.verdict == Damaged) return Outcome::Damaged;
    if (answer.verdict >= Components && answer.verdict <= Segments) {
      difference_ = differenceOf(frame, answer);
      return Outcome::Differs;
    }
    outcome = Outcome::Died;
  }
  end();
  return outcome;
}

Expected<std::unique_ptr<Decoder>> Decoders::take() {
  {
    const std::scoped_lock lock(mutex_);
    if (!free_.empty()) {
      auto decoder = std::move(free_.back());
      free_.pop_back();
      return decoder;
    }
  }
  auto started = Decoder::start(codestream_bytes_, pixel_bytes_);
  if (!started) return tl::unexpected(std::move(started.error()));
  return std::make_unique<Decoder>(std::move(*started));
}

void Decoders::give(std::unique_ptr<Decoder> decoder) {
  const std::scoped_lock lock(mutex_);
  free_.push_back(std::move(decoder));
}

}  // namespace datasets
