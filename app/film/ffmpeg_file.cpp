// SPDX-License-Identifier: BSD-3-Clause
#include "app/film/ffmpeg_file.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fstream>
#include <utility>
#include <vector>

namespace app {
namespace {

using haptics::Error;
using haptics::Expected;

constexpr int kPatience_ms = 100;  // between two questions whether it is still wanted
constexpr std::size_t kMostWords = 4096;
constexpr std::size_t kMostQuoted = 160;

void shut(int& descriptor) {
  if (descriptor >= 0) close(descriptor);
  descriptor = -1;
}

tl::unexpected<Error> cancelled() {
  return tl::unexpected(Error{Error::Kind::Cancelled, {"work-cancelled", {}}, "cancelled"});
}

constexpr int kFilm = 3;  // its descriptor of the file

std::vector<std::string> argumentsFor(const std::string& program, const FilmFormat& format) {
  const std::string size = std::to_string(format.width) + "x" + std::to_string(format.height);
  const std::string rate = std::to_string(format.frames_per_second);
  return {program, "-hide_banner", "-nostdin", "-loglevel", "error", "-xerror", "-y",
          // what comes through the pipe: rows from the lowest
          "-f", "rawvideo", "-pixel_format", "rgb24", "-video_size", size, "-framerate", rate, "-i",
          "pipe:0",
          // what every player knows, and says which colours it has
          "-vf", "vflip,scale=out_color_matrix=bt709:out_range=tv", "-an", "-c:v", "libx264",
          "-preset", "medium", "-crf", "16", "-pix_fmt", "yuv420p", "-colorspace", "bt709",
          "-color_primaries", "bt709", "-color_trc", "bt709", "-color_range", "tv",
          // no dates, no program's name
          "-map_metadata", "-1", "-fflags", "+bitexact", "-flags:v", "+bitexact", "-movflags",
          "+faststart", "-f", "mp4", "file:/proc/self/fd/" + std::to_string(kFilm)};
}

/// Whether a file is boxes without a gap to its end, its table of frames among them. ffmpeg may say
/// that all is well where the disk was full.
bool isWhole(const std::filesystem::path& file) {
  std::error_code error;
  const std::uintmax_t end = std::filesystem::file_size(file, error);
  if (error) return false;
  std::ifstream in(file, std::ios::binary);
  bool table = false;
  std::uint64_t at = 0;
  while (at < end) {
    std::array<unsigned char, 16> head{};
    if (!in.seekg(std::streamoff(at)) || !in.read(reinterpret_cast<char*>(head.data()), 8))
      return false;
    const auto number = [&](std::size_t from, std::size_t to) {
      std::uint64_t value = 0;
      for (std::size_t i = from; i < to; ++i) value = value << 8 | head[i];
      return value;
    };
    std::uint64_t size = number(0, 4);
    if (size == 1) {  // in 64 bits
      if (!in.read(reinterpret_cast<char*>(head.data()) + 8, 8)) return false;
      size = number(8, 16);
    }
    if (size < 8 || size > end - at) return false;
    table = table || std::memcmp(head.data() + 4, "moov", 4) == 0;
    at += size;
  }
  return table;
}

}  // namespace

std::optional<FfmpegFile> FfmpegFile::start(const std::string& program,
                                            const std::filesystem::path& file,
                                            const FilmFormat& format) {
  if (program.empty()) return {};
  // by its descriptor: where the name was removed, an encoder that begins late makes no file anew
  int film = open(file.c_str(), O_RDWR | O_CLOEXEC);
  if (film < 0) return {};
  // a socket and no pipe: that nobody reads any more is told by send, not by a signal
  int frames[2] = {-1, -1}, words[2] = {-1, -1};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, frames) != 0 ||
      pipe2(words, O_CLOEXEC) != 0) {
    shut(film);
    shut(frames[0]);
    shut(frames[1]);
    return {};
  }
  fcntl(frames[0], F_SETFL, O_NONBLOCK);
  fcntl(words[0], F_SETFL, O_NONBLOCK);
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_adddup2(&files, frames[1], STDIN_FILENO);
  posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_adddup2(&files, words[1], STDERR_FILENO);
  // the last: another may have had the number
  posix_spawn_file_actions_adddup2(&files, film, kFilm);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  // in a group of its own: Ctrl+C on the terminal is for us, and we end it; what we have blocked it
  // need not have
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK);
  auto arguments = argumentsFor(program, format);
  std::vector<char*> pointers;
  for (std::string& argument : arguments) pointers.push_back(argument.data());
  pointers.push_back(nullptr);
  pid_t process = -1;
  const int failed =
      posix_spawnp(&process, program.c_str(), &files, &attributes, pointers.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&files);
  shut(frames[1]);
  shut(words[1]);
  shut(film);
  if (failed != 0) {
    shut(frames[0]);
    shut(words[0]);
    return {};
  }
  return FfmpegFile{file, process, frames[0], words[0]};
}

FfmpegFile::FfmpegFile(FfmpegFile&& other) noexcept
    : file_{std::move(other.file_)},
      process_{std::exchange(other.process_, -1)},
      frames_{std::exchange(other.frames_, -1)},
      words_{std::exchange(other.words_, -1)},
      said_{std::move(other.said_)} {}

FfmpegFile::~FfmpegFile() {
  shut(frames_);
  shut(words_);
  if (process_ < 0) return;
  kill(process_, SIGKILL);
  int status = 0;
  while (waitpid(process_, &status, 0) < 0 && errno == EINTR) {
  }
}

/// Takes what it said; false once it says no more.
bool FfmpegFile::listen() {
  if (words_ < 0) return false;
  std::array<char, 1024> heard{};
  for (;;) {
    const ssize_t count = read(words_, heard.data(), heard.size());
    if (count > 0) {
      said_.append(heard.data(), std::min(std::size_t(count), kMostWords - said_.size()));
      continue;
    }
    if (count < 0 && errno == EINTR) continue;
    if (count < 0 && errno == EAGAIN) return true;
    shut(words_);
    return false;
  }
}

bool FfmpegFile::ended(int& status) {
  if (waitpid(process_, &status, WNOHANG) == 0) return false;
  process_ = -1;
  return true;
}

Error FfmpegFile::failure() {
  // its last words may still be under way
  for (int n = 0; n < 10 && listen(); ++n) {
    pollfd news{words_, POLLIN, 0};
    poll(&news, 1, kPatience_ms);
  }
  std::string quoted = said_.substr(0, said_.find('\n'));
  if (quoted.size() > kMostQuoted) {
    quoted.resize(kMostQuoted);
    quoted += "…";
  }
  return {Error::Kind::Unsupported,
          quoted.empty() ? haptics::Message{"film-not-written", {}}
                         : haptics::Message{"ffmpeg-ended", {quoted}},
          "encoder"};
}

Expected<void> FfmpegFile::write(const FilmFrame& frame, const StillWanted& wanted) {
  const std::uint8_t* next = frame.rgb.data();
  std::size_t left = frame.rgb.size();
  while (left > 0) {
    listen();
    const ssize_t sent = send(frames_, next, left, MSG_NOSIGNAL);
    if (sent >= 0) {
      next += sent;
      left -= std::size_t(sent);
      continue;
    }
    if (errno != EAGAIN && errno != EINTR) return tl::unexpected(failure());
    if (!wanted()) return cancelled();
    // no descriptor, once it has closed its standard error: poll passes over it
    pollfd news[2] = {{frames_, POLLOUT, 0}, {words_, POLLIN, 0}};
    poll(news, 2, kPatience_ms);
  }
  return {};
}

Expected<void> FfmpegFile::finish(const StillWanted& wanted) {
  shut(frames_);
  int status = 0;
  while (!ended(status)) {
    if (!wanted()) return cancelled();
    pollfd news{words_, POLLIN, 0};
    const int said = poll(&news, 1, listen() ? kPatience_ms : 5);
    if (said < 0 && errno != EINTR) break;
  }
  if (process_ >= 0 || !WIFEXITED(status) || WEXITSTATUS(status) != 0 || !isWhole(file_))
    return tl::unexpected(failure());
  return {};
}

}  // namespace app
