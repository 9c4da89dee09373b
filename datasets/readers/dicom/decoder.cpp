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

#include "datasets/readers/dicom/decode_protocol.h"
#include "datasets/readers/files/refusal.h"
#include "haptics/core/helper_program.h"

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
    return notStarted({"decoder-no-memory", {kProgram}});
  void* mapped = mmap(nullptr, all, PROT_READ | PROT_WRITE, MAP_SHARED, memory.get(), 0);
  if (mapped == MAP_FAILED) return notStarted({"decoder-no-memory", {kProgram}});
  decoder.memory_ = static_cast<std::byte*>(mapped);
  std::array<int, 2> ends{-1, -1};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0)
    return notStarted({"decoder-not-connected", {kProgram}});
  decoder.socket_ = ends[0];
  {
    // closed here at once, so that its end is seen
    const Descriptor theirs{ends[1]};
    decoder.process_ = spawn(program, theirs.get(), memory.get());
  }
  if (decoder.process_ < 0) return notStarted({"decoder-not-started", {kProgram}});
  const decode::Room room{decoder.codestream_bytes_, decoder.pixel_bytes_};
  std::byte said{};
  if (!sendWhole(decoder.socket_, &room, sizeof room) ||
      decoder.listen(said, kStartTime, {}) != Outcome::Decoded ||
      said != std::byte{static_cast<std::uint8_t>(decode::Answer::Ready)})
    return notStarted({"decoder-not-confined", {kProgram}});
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

Decoder::Outcome Decoder::listen(std::byte& said, double seconds, const ReadProgress& progress) {
  using Clock = std::chrono::steady_clock;
  const auto until = Clock::now() + std::chrono::duration<double>(seconds);
  for (;;) {
    if (progress.isCancelled()) return Outcome::Cancelled;
    pollfd waited{socket_, POLLIN, 0};
    const int ready = poll(&waited, 1, kListen_ms);
    if (ready < 0 && errno != EINTR) return Outcome::Died;
    if (ready > 0) return recv(socket_, &said, 1, 0) == 1 ? Outcome::Decoded : Outcome::Died;
    if (Clock::now() > until) return Outcome::TooLong;
  }
}

Decoder::Outcome Decoder::decode(const Codestream& codestream, std::span<const std::byte> bytes,
                                 const CodedImage& image, const ReadProgress& progress) {
  if (process_ < 0 || codestream.size > codestream_bytes_ || codestream.size > bytes.size() ||
      image.byteCount() > pixel_bytes_)
    return Outcome::Died;
  std::memcpy(memory_, bytes.data(), codestream.size);
  decode::Request request;
  request.codestream_bytes = codestream.size;
  request.coding = codestream.coding;
  request.columns = static_cast<std::uint32_t>(image.columns);
  request.rows = static_cast<std::uint32_t>(image.rows);
  request.bytes_per_pixel = static_cast<std::uint32_t>(image.bits_allocated / 8);
  request.precision = static_cast<std::uint32_t>(codestream.precision);
  request.is_signed = image.is_signed ? 1 : 0;
  Outcome outcome = Outcome::Died;
  std::byte said{};
  if (sendWhole(socket_, &request, sizeof request))
    outcome = listen(said, kFrameTime + kTimeOfAPixel * double(image.columns) * double(image.rows),
                     progress);
  const auto answer = static_cast<decode::Answer>(said);
  if (outcome == Outcome::Decoded) {
    if (answer == decode::Answer::Decoded) return Outcome::Decoded;
    if (answer == decode::Answer::Refused) return Outcome::Refused;
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
